//! What is documented is what is read: every key, every template, every named material and sensor class.

use coilsense_lab::spec::{CONDITION_KINDS, Key, SENSOR_KINDS, TABLES, Table, classes, markdown, materials, template};

use super::fixtures::{BY_GEOMETRY, BY_SECTIONS, BY_VALUES, read};

/// A condition of a kind with the keys that it needs.
fn condition(kind: &str) -> String {
    let needs = match kind {
        "impact" => "velocity = \"0.25 m/s\"",
        "end-stop" => "at = \"max\"",
        "harmonic" => "frequency = \"5 Hz\"\namplitude = \"1 mm\"",
        "sweep" => "frequency = [\"5 Hz\", \"6 Hz\"]\namplitude = \"1 mm\"",
        "step" => "amplitude = \"1 mm\"",
        "ramp" => "amplitude = \"1 mm\"\nrise_time = \"10 ms\"",
        "pulse" => "amplitude = \"1 mm\"\nwidth = \"10 ms\"",
        _ => "file = \"road.csv\"",
    };
    format!("\n[[condition]]\nkind = \"{kind}\"\n{needs}\n")
}

/// The table `[spring]` of a good spec.
fn spring(good: &str) -> String {
    good.split("\n\n").next().unwrap_or_default().to_owned()
}

/// Specs in which a table comes in all its kinds, each with its kind; the table is the last one, so that keys can be added.
fn fixtures(table: &Table) -> Vec<(&'static str, String)> {
    let by_values = spring(BY_VALUES);
    match table.name {
        "spring" => {
            // Pulled, with room for some windings more; and pushed.
            let both = [("by values", by_values.clone()), ("by geometry", spring(BY_GEOMETRY))];
            let used = |(kind, text): &(&'static str, String)| {
                let strengths = "endurance_shear_strength = \"300 MPa\"\nultimate_shear_strength = \"900 MPa\"";
                ["110 mm", "270 mm"].map(|rest| (*kind, format!("{}\n{strengths}\n", text.replace("104 mm", rest))))
            };
            let first = by_values.replace("[spring]", "[[spring]]");
            let second = first.replace("\"S_T\"", "\"second\"");
            let strengths = "endurance_shear_strength = \"300 MPa\"\nultimate_shear_strength = \"900 MPa\"";
            let beside = ("beside the first", format!("{first}\n{second}\n{strengths}\n"));
            both.iter().flat_map(used).chain([beside]).collect()
        }
        "spring.section" => {
            let by_pitch = BY_SECTIONS.to_owned();
            vec![("pitch", by_pitch.clone()), ("gap", by_pitch.replace("pitch = \"8 mm\"", "gap = \"4 mm\""))]
        }
        "mount" => {
            // With windings that may meet, which a follower asks for.
            let meets = format!("{}\n[contact]\n", by_values.replace("104 mm", "150 mm"));
            vec![
                ("held", format!("{meets}\n[mount]\nend2 = \"held\"\n")),
                ("force", format!("{meets}\n[mount]\nend2 = \"force\"\n")),
                ("mass", format!("{meets}\n[mount]\nend2 = \"mass\"\nend_mass = \"1 kg\"\n")),
            ]
        }
        "contact" => {
            // With room for its windings to be apart.
            let apart = by_values.replace("104 mm", "150 mm");
            let of = |word: &'static str| (word, format!("{apart}\n[contact]\nwindings = \"{word}\"\n"));
            vec![of("hard"), of("elastic")]
        }
        "cam" => {
            let held = by_values.replace("104 mm", "150 mm");
            let law = format!("{held}\n[cam]\nlift = \"1 mm\"\nangle = \"130 deg\"\n");
            let harmonics = format!("{held}\n[cam]\nharmonics = [[1, \"0.5 mm\"]]\n");
            vec![("law", law), ("file", format!("{held}\n[cam]\nfile = \"cam.csv\"\n")), ("harmonics", harmonics)]
        }
        "condition" => {
            CONDITION_KINDS.iter().map(|kind| (*kind, format!("{by_values}\n{}", condition(kind)))).collect()
        }
        "sensor" => {
            SENSOR_KINDS.iter().map(|kind| (*kind, format!("{by_values}\n[[sensor]]\nkind = \"{kind}\"\n"))).collect()
        }
        "goal" => vec![("goal", format!("{by_values}\n[goal]\nerror = \"1 %\"\n"))],
        "rig" => vec![("rig", format!("{by_values}\n[rig]\n"))],
        "control" => vec![
            ("velocity", format!("{by_values}\n[control]\ncontroller = \"PID\"\ndrive = \"velocity\"\n")),
            ("force", format!("{by_values}\n[control]\ndrive = \"force\"\nmotor_mass = \"2 kg\"\n")),
        ],
        _ => vec![("budget", format!("{by_values}\n[uncertainty]\n"))],
    }
}

/// The spec with a key of its last table set to a value.
fn with(spec: &str, table: &Table, key: &str, value: &str) -> String {
    let start = spec.rfind(&table.heading()).expect("the table");
    let kept = |line: &&str| !line.starts_with(&format!("{key} = "));
    let last: Vec<&str> = spec[start..].lines().filter(kept).collect();
    format!("{}{}\n{key} = {value}\n", &spec[..start], last.join("\n"))
}

fn each_key(visit: impl Fn(&Table, &Key, Vec<(&'static str, String)>)) {
    for table in TABLES {
        for key in table.keys {
            let fitting: Vec<_> = fixtures(table).into_iter().filter(|(kind, _)| key.applies_to(Some(kind))).collect();
            assert!(!fitting.is_empty(), "{} {} is of no kind that there is", table.heading(), key.name);
            visit(table, key, fitting);
        }
    }
}

#[test]
fn every_example_of_the_documentation_is_taken() {
    each_key(|table, key, fixtures| {
        let tried = fixtures.iter().map(|(_, spec)| read(&with(spec, table, key.name, key.example)));
        // Which unit a sensor has depends on its kind, and which frequencies a sweep has: one kind that takes the example is enough.
        let refusals: Vec<String> = tried.filter_map(Result::err).collect();
        assert!(refusals.len() < fixtures.len(), "{} {} = {}: {refusals:?}", table.heading(), key.name, key.example);
    });
}

#[test]
fn every_key_is_read_in_every_kind_that_has_it() {
    each_key(|table, key, fixtures| {
        for (kind, spec) in fixtures {
            let wrong = if key.example == "true" { "1" } else { "true" };
            let message = read(&with(&spec, table, key.name, wrong)).expect_err(key.name);
            let expected = format!("{} = {wrong}: must be ", key.name);
            assert!(message.contains(&expected), "{} {} of {kind}: {message}", table.heading(), key.name);
        }
    });
}

#[test]
fn a_key_that_must_be_there_is_missed() {
    each_key(|table, key, fixtures| {
        for (kind, spec) in fixtures.into_iter().filter(|_| key.default.is_none()) {
            let line = format!("\n{} = ", key.name);
            let Some(start) = spec.rfind(&line) else { panic!("{kind} lacks {}", key.name) };
            let end = start + 1 + spec[start + 1..].find('\n').unwrap_or(spec.len());
            let message = read(&format!("{}{}", &spec[..start], &spec[end..])).expect_err(key.name);
            assert!(
                message.contains(&format!("lacks the key \"{}\": ", key.name)),
                "{} of {kind}: {message}",
                table.name
            );
        }
    });
}

#[test]
fn the_reference_of_all_keys_is_up_to_date() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/guide/spec.md");
    if std::env::var_os("COILSENSE_WRITE_DOCS").is_some() {
        std::fs::write(path, markdown()).expect("book/src/guide/spec.md can be written");
    }
    let written = std::fs::read_to_string(path).unwrap_or_default();
    let refresh = "COILSENSE_WRITE_DOCS=1 cargo test -p coilsense-lab --test spec";
    assert!(
        written == markdown(),
        "book/src/guide/spec.md is not what the reader's own table says; refresh it: {refresh}"
    );
}

#[test]
fn every_template_can_be_used() {
    for from in [None, Some("pressed"), Some("S_T"), Some("S_A")] {
        let spec = read(&template(from).unwrap()).unwrap();
        assert_eq!((spec.conditions.len(), spec.sensors.len(), spec.mount.cases.len()), (5, 4, 4), "{from:?}");
        assert_eq!(spec.spring.by_geometry, from.is_none_or(|from| from == "pressed"));
        assert!(spec.goal.error.is_some());
    }
    assert_eq!(
        template(Some("S_X")).unwrap_err().to_string(),
        "S_X: no spring of that name; there are S_T, S_A, pressed"
    );
}

/// Values of a key in a catalogue, in order.
fn values<'a>(catalogue: &'a str, key: &str) -> Vec<&'a str> {
    let start = format!("{key} = \"");
    catalogue.lines().filter_map(|line| line.strip_prefix(&start)?.split('"').next()).collect()
}

#[test]
fn every_class_of_sensors_can_be_used() {
    let catalogue = classes().unwrap();
    let named: Vec<_> = values(&catalogue, "class").into_iter().zip(values(&catalogue, "kind")).collect();
    assert!(named.len() >= 15, "{named:?}");
    for (class, kind) in named {
        for good in [BY_VALUES, BY_GEOMETRY] {
            let text = format!("{}\n[[sensor]]\nkind = \"{kind}\"\nclass = \"{class}\"\n", spring(good));
            let spec = read(&text).unwrap();
            assert_eq!((spec.sensors[0].name.as_str(), spec.sensors[0].quantity.kind()), (class, kind));
        }
    }
}

#[test]
fn a_class_gives_its_values_and_a_spec_its_own_in_their_place() {
    let sensor = |keys: &str| {
        let text = format!("{}\n[[sensor]]\nkind = \"deflection\"\n{keys}\n", spring(BY_VALUES));
        read(&text).unwrap().sensors.remove(0)
    };
    let encoder = sensor("class = \"magnetic linear encoder\"");
    // Limits of error of 10 µm over a range of 68 mm.
    assert_eq!((encoder.readout.resolution, encoder.accuracy_full_scale), (Some(0.5e-6), 10e-6 / (0.264 - 0.196)));
    let own = sensor("class = \"magnetic linear encoder\"\nrange = \"100 mm\"\nresolution = \"1 um\"");
    assert_eq!((own.readout.resolution, own.accuracy_full_scale), (Some(1e-6), 10e-6 / 0.1));
}

#[test]
fn every_material_can_be_used() {
    let all = materials().unwrap();
    let names: Vec<&str> = all.lines().filter(|line| !line.is_empty() && !line.starts_with(' ')).collect();
    assert!(names.len() >= 10, "{names:?}");
    for name in names {
        for good in [BY_VALUES, BY_GEOMETRY] {
            let kept: Vec<String> =
                spring(good).lines().filter(|l| !l.starts_with("material")).map(String::from).collect();
            let spec = read(&format!("{}\nmaterial = \"{name}\"\n", kept.join("\n"))).unwrap();
            assert_eq!(spec.spring.material, name);
        }
    }
}
