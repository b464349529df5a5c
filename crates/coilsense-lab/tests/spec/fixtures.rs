//! Good specs, and what becomes of them after an edit.

use coilsense_lab::spec::Spec;

/// A spring by values, held, hit and shaken, watched by a laser.
pub const BY_VALUES: &str = r#"[spring]
name = "S_T"
rest_length = "104 mm"
windings = 52
coil_radius = "8 mm"
wire_radius = "1 mm"
mass = "65 g"
stiffness = "760 N/m"
min_length = "196 mm"
max_length = "264 mm"

[mount]
end2 = "held"
damping_ratio = 0.005

[[condition]]
name = "heel strike"
kind = "impact"
velocity = "0.25 m/s"
duration = "1 s"
window = ["0.75 s", "1 s"]
sample_rate = "10 kHz"

[[condition]]
name = "shake"
kind = "harmonic"
frequency = "0.5 f1"
amplitude = "1 %"

[[sensor]]
name = "laser"
kind = "deflection"
resolution = "10 um"

[goal]
error = "1 %"

[uncertainty]
coverage = "95 %"
"#;

/// A spring by geometry, with a mass at its end, that a recorded file moves.
pub const BY_GEOMETRY: &str = r#"[spring]
name = "wound"
rest_length = "104 mm"
min_length = "196 mm"
max_length = "264 mm"
windings = 52
wire_diameter = "2 mm"
coil_diameter = "16 mm"
end_type = "hooks"
material = "CuBe2"

[mount]
end2 = "mass"
end_mass = "2 kg"

[[condition]]
kind = "recorded"
file = "road.csv"
duration = "0.3 s"

[[sensor]]
kind = "load-cell"
"#;

/// A file that a recorded condition can take on every mount.
const ROAD: &str = "# a remark\ntime [s],u1 [mm]\n0,0\n0.1,2\n0.2,-1\n0.3,0\n";

/// Reads a spec in whose folder some recordings lie.
pub fn read(text: &str) -> Result<Spec, String> {
    let files = |name: &str| match name {
        "road.csv" => Ok(ROAD.to_owned()),
        "cam.csv" => Ok((0..=36).map(|row| format!("{},{}\n", 10 * row, if row == 18 { 1.0 } else { 0.0 })).collect()),
        // What a file holds may stand in its name, lines parted by semicolons.
        _ => match name.strip_prefix("holds ") {
            Some(lines) => Ok(lines.replace(';', "\n")),
            None => Err(format!("{name} cannot be read: No such file or directory (os error 2)")),
        },
    };
    let read = Spec::parse("S.toml", text, &files).map_err(|error| error.to_string());
    if let Err(message) = &read {
        assert!(!message.contains(['\n', '\r']) && message.chars().count() < 900, "not one line: {message}\nof {text}");
    }
    read
}

/// Checks a table of faults: what is wrong, what of a good spec is replaced by what, and the message.
pub fn check(good: &str, faults: &[[&str; 4]]) {
    read(good).expect("the good spec");
    for [what, old, new, expected] in faults {
        assert!(good.contains(old), "{what}: nothing to replace by {new}");
        let message = read(&good.replacen(old, new, 1)).expect_err(what);
        assert_eq!(message, *expected, "{what}");
    }
}

/// A spring of two sections, the second of which is the last table.
pub const BY_SECTIONS: &str = r#"[spring]
name = "two steps"
min_length = "40 mm"
max_length = "45 mm"
end_type = "open-ground"

[[spring.section]]
windings = 2
pitch = "5 mm"
coil_diameter = "25 mm"
wire_diameter = "4 mm"

[[spring.section]]
windings = 4.5
pitch = "8 mm"
coil_diameter = "25 mm"
wire_diameter = "4 mm"
"#;
