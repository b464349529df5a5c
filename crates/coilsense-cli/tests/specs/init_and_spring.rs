//! `coilsense init` and `coilsense spring`.

use std::fs;

use serde_json::Value;

use super::{QUICK, done, names, path, place, refused};

#[test]
fn init_writes_a_spec_that_the_other_commands_take() {
    let place = tempfile::tempdir().unwrap();
    for (name, from) in
        [("own.toml", None), ("pressed.toml", Some("pressed")), ("s_t.toml", Some("S_T")), ("s_a.toml", Some("S_A"))]
    {
        let arguments = from.map_or(vec!["init"], |from| vec!["init", "--from", from]);
        let printed = done(&arguments);
        let file = place.path().join(name);
        let said = done(&[arguments, vec!["--out", path(&file)]].concat());
        assert!(said.contains("next: coilsense analyze"), "{said}");
        assert_eq!(fs::read_to_string(&file).unwrap(), printed, "the file is what the terminal gets");
        assert!(done(&["spring", path(&file)]).contains("F_nom"));
        // What is commented out there does as it says.
        assert!(refused(&["placement", path(&file)]).contains("the table [control] is missing; it says"));
        let with_loop = printed.replace("# [control]", "[control]").replace("\n# drive", "\ndrive");
        let with_loop = with_loop.replace("\n# sample_time", "\nsample_time").replace("\n# delay", "\ndelay");
        fs::write(&file, with_loop).unwrap();
        assert!(done(&["placement", path(&file)]).starts_with("Feed back F_"));
    }
    assert_eq!(names(place.path()), ["own.toml", "pressed.toml", "s_a.toml", "s_t.toml"]);
}

#[test]
fn init_keeps_what_is_there_and_knows_its_springs() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("spec.toml");
    fs::write(&file, "mine").unwrap();
    let message = refused(&["init", "--out", path(&file)]);
    assert_eq!(
        message,
        format!(
            "error: {}: is there already; name a file that is not, or replace it with --overwrite\n",
            file.display()
        )
    );
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
    let message = refused(&["init", "--from", "S_X"]);
    assert_eq!(message, "error: --from S_X: no spring of that name; there are S_T, S_A, pressed\n");
    let inside = file.join("spec.toml");
    assert!(refused(&["init", "--out", path(&inside)]).contains(path(&file)));
    assert!(refused(&["init", "--out", "/proc/spec.toml"]).contains("/proc"));
    assert!(refused(&["init", "--out", ".."]).contains(".."));
    assert_eq!(names(place.path()), ["spec.toml"]);
}

#[test]
fn init_lists_the_sensor_catalogue_and_spring_the_materials() {
    assert!(done(&["init", "--sensors"]).contains("class = \"magnetic linear encoder\""));
    let materials = done(&["spring", "--materials"]);
    assert!(materials.contains("steel EN 10270-1") && materials.contains("source: "), "{materials}");
}

#[test]
fn spring_tells_the_key_figures() {
    let (_place, spec) = place("");
    let sheet = done(&["spring", path(&spec)]);
    for words in
        ["S_T, steel EN 10270-1 (assumed)", "760 N/m", "121.6 N", "54.065 Hz", "9.248 ms", "7.0285 N s/m", "104 mm"]
    {
        assert!(sheet.contains(words), "{words} in {sheet}");
    }
    assert!(!sheet.contains('\u{1b}'), "colour although it is no terminal");
}

/// Every key of a JSON value.
fn keys(value: &Value) -> Vec<String> {
    match value {
        Value::Object(map) => map.iter().flat_map(|(key, value)| [vec![key.clone()], keys(value)].concat()).collect(),
        Value::Array(each) => each.iter().flat_map(keys).collect(),
        _ => Vec::new(),
    }
}

#[test]
fn spring_as_json_is_for_machines() {
    let (_place, spec) = place("");
    let sheet: Value = serde_json::from_str(&done(&["spring", path(&spec), "--json"])).unwrap();
    assert_eq!(sheet["schema"], "coilsense/data-sheet/2");
    assert_eq!(sheet["nominal_force_n"], 760.0 * (0.264 - 0.104));
    let lengths = sheet["modes_at"].as_array().unwrap();
    assert_eq!(lengths.iter().map(|at| at["length_m"].as_f64().unwrap()).collect::<Vec<_>>(), [0.196, 0.230, 0.264]);
    for at in lengths {
        let modes = at["modes"].as_array().unwrap();
        let first = |kind: &str| modes.iter().find(|mode| mode["kind"] == kind).unwrap();
        assert!(modes.len() >= 10 && first("axial")["axial_strength"].as_f64().unwrap() > 0.9);
        assert!((first("torsional")["frequency_hz"].as_f64().unwrap() - 60.8).abs() < 0.3);
        for key in ["side_force_n_per_n", "couple_m"] {
            assert!(first("lateral")[key].as_f64().unwrap() > first("axial")[key].as_f64().unwrap(), "{key}");
        }
    }
    let snake = |key: &String| key.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
    let others: Vec<String> = keys(&sheet).into_iter().filter(|key| !snake(key)).collect();
    assert!(others.is_empty(), "{others:?}");
}

#[test]
fn a_spring_that_is_not_there_is_refused() {
    assert!(refused(&["spring", "none.toml"]).starts_with("error: none.toml: cannot be read: "));
    let (_place, spec) = place("[mount]\nend2 = \"loose\"\n");
    let message = refused(&["spring", path(&spec)]);
    assert!(message.contains("spec.toml:17: end2 = \"loose\": must be one of"), "{message}");
}

#[test]
fn a_day_that_is_none_is_refused_before_anything_is_done() {
    let (place, spec) = place(QUICK);
    let out = place.path().join("report");
    for date in ["foo", "21.11.2026", "2026-02-30", "2026-1-1", "2026-11-21T00:00"] {
        for command in ["analyze", "placement", "mitigate"] {
            let message = refused(&[command, path(&spec), "--out", path(&out), "--date", date]);
            assert!(message.ends_with("must be a day as YYYY-MM-DD, such as 2026-11-21\n"), "{message}");
        }
    }
    assert!(!out.exists());
}

#[test]
fn a_spring_of_a_single_winding_has_a_data_sheet() {
    let (_place, spec) = place("");
    let single = std::fs::read_to_string(&spec).unwrap().replace("windings = 52", "windings = 1");
    std::fs::write(&spec, single).unwrap();
    assert!(done(&["spring", path(&spec)]).contains("N, active windings"));
}
