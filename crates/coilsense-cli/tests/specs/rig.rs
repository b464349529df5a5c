//! `coilsense rig`.

use std::fs;

use super::{coilsense, done, names, path, place, refused, text};

/// A rig that is quick to run.
const QUICK: &str = "\n[mount]\ndamping_ratio = 0.005\n\n[rig]\nduration = \"2 s\"\nreadings = 3\nfrequencies = 1\nhits = 1\nhits_per_run = 1\ncalibration_positions = 3\n";

#[test]
fn it_says_what_it_wrote_and_the_same_seed_writes_the_same() {
    let (place, spec) = place(QUICK);
    let [first, second] = ["first", "second"].map(|name| place.path().join(name));
    let told = done(&["rig", path(&spec), "--out", path(&first), "--seed", "5"]);
    assert!(told.starts_with("wrote 11 files to ") && told.contains(": 5 runs, "), "{told}");
    assert!(told.contains(", simulated with seed 5, in "), "{told}");
    done(&["rig", path(&spec), "--out", path(&second), "--seed", "5"]);
    assert_eq!(names(&first), names(&second));
    assert_eq!(names(&first).len(), 11);
    for name in names(&first) {
        assert_eq!(fs::read(first.join(&name)).unwrap(), fs::read(second.join(&name)).unwrap(), "{name}");
    }
    // Without a seed, that of the spec, which is 1 where it has none.
    assert!(done(&["rig", path(&spec), "--out", path(&second)]).contains(", simulated with seed 1, in "));
    assert_ne!(fs::read(first.join("hit-1-fast.csv")).unwrap(), fs::read(second.join("hit-1-fast.csv")).unwrap());
}

#[test]
fn what_cannot_be_is_refused_and_nothing_is_written() {
    for (tables, expected) in [
        ("", "[mount] damping_ratio must be one value for a rig, such as 0.005, got none\n"),
        ("[mount]\ndamping_ratio = 0.005\n[rig]\namplitude = \"20 mm\"\n", "u1 reaches 20.0"),
        ("[mount]\ndamping_ratio = 0.005\n[rig]\namplitud = \"1 mm\"\n", "did you mean \"amplitude\"?"),
    ] {
        let (place, spec) = place(tables);
        let message = refused(&["rig", path(&spec), "--out", path(&place.path().join("out"))]);
        assert!(message.starts_with(&format!("error: {}:", path(&spec))) && message.contains(expected), "{message}");
        assert_eq!(names(place.path()), ["spec.toml"]);
    }
}

#[test]
fn a_spring_without_damping_is_warned_of() {
    let (place, spec) = place(&QUICK.replace("0.005", "0"));
    let output = coilsense(&["rig", path(&spec), "--out", path(&place.path().join("out"))]);
    assert!(output.status.success());
    assert!(text(&output.stderr).starts_with("warning: without damping a resonance never settles"));
}
