//! `coilsense export`.

use std::fs;

use super::{done, names, path, place, refused};

const ONE: &str = "[mount]\ndamping_ratio = 0.005\n";

#[test]
fn each_form_is_one_file_and_two_lines_about_it() {
    let (folder, spec) = place(ONE);
    for (word, file, holds) in [
        ("c", "spring-1.h", "static inline spring_1_output spring_1_step("),
        ("rust", "spring-1.rs", "pub const SPRING_1: PlantSettings<SPRING_1_MODES> = PlantSettings {"),
        ("state-space", "spring-1.json", "\"schema\": \"coilsense/state-space/1\""),
    ] {
        let out = folder.path().join(file);
        let told = done(&["export", path(&spec), "--as", word, "--out", path(&out)]);
        let expected = "S_T, ζ = 0.005, about 230.000 mm (95.7600 N)\nall 52 modes: exact for inputs that move straight between samples\n";
        assert_eq!(told, format!("{expected}{}\n", out.display()));
        let text = fs::read_to_string(&out).unwrap();
        assert!(text.contains(holds), "{word}: {text}");
    }
    assert_eq!(names(folder.path()), ["spec.toml", "spring-1.h", "spring-1.json", "spring-1.rs"]);
}

#[test]
fn an_error_finds_how_few_modes_are_enough() {
    let (folder, spec) = place(ONE);
    let out = folder.path().join("few.h");
    let words = ["export", path(&spec), "--as", "c", "--out", path(&out), "--error", "1 %", "--bandwidth", "100 Hz"];
    let told = done(&words);
    assert!(told.contains("5 of 52 modes, and one for each input with the inertia of all others"), "{told}");
    assert!(told.contains("error up to 100 Hz 0.892 %"), "{told}");
    assert!(fs::read_to_string(&out).unwrap().contains("#define FEW_MODES 7"));
}

#[test]
fn what_cannot_be_is_one_line_and_leaves_nothing() {
    let (folder, spec) = place(ONE);
    let out = folder.path().join("a.h");
    let told = |more: &[&str]| {
        let refused = refused(&[&["export", path(&spec), "--out", path(&out)], more].concat());
        assert_eq!(names(folder.path()), ["spec.toml"], "{refused}");
        refused
    };
    for (more, says) in [
        (&["--as", "modelica"][..], "'--as <WORD>': must be one of c, rust, state-space, fmu"),
        (&["--as", "state-space", "--step", "0 s"], "'--step <TIME>': must be above zero"),
        (&["--as", "state-space", "--step", "-1 ms"], "'--step <TIME>': must be above zero"),
        (&["--as", "c", "--step", "1 ms"], "step goes with state-space, fmu or readings, got c,"),
        (
            &["--as", "c", "--also", "F_l"],
            "'--also <WORDS>': must be of F_L, closest_pitch, readings, with commas between",
        ),
        (&["--as", "c", "--also", "readings", "--step", "1 ms"], "readings: no [[sensor]] looks at"),
        (&["--as", "state-space", "--also", "closest_pitch"], "closest_pitch is no straight line of the inputs"),
        (&["--as", "c", "--error", "1 %"], "--error: needs --bandwidth"),
        (
            &["--as", "c", "--error", "0 %", "--bandwidth", "1 Hz"],
            "'--error <SHARE>': must be above 0 % and below 100 %",
        ),
        (
            &["--as", "c", "--modes", "2", "--error", "1 %", "--bandwidth", "100 Hz"],
            "modes = 2 leaves an error of 27.776 % up to 100 Hz: 1.000 % takes 5 modes",
        ),
        (&["--as", "c", "--modes", "53"], "modes must be from 1 to 52, got 53"),
        (&["--as", "c", "--damping-ratio", "0.1"], "--damping-ratio must be one of ζ = 0.005, got 0.1"),
        (&["--as", "c", "--mean-length", "9 m"], "mm, the lengths in use, got 9000.000 mm"),
        (&["--as", "c", "--mean-length", "-1 mm"], "'--mean-length <LENGTH>': must be above zero"),
    ] {
        let refused = told(more);
        assert!(refused.contains(says), "{more:?}: {refused}");
    }
    let (folder, spec) = place("");
    let file = path(&folder.path().join("2x.h")).to_owned();
    let several = refused(&["export", path(&spec), "--as", "c", "--out", &file]);
    assert!(several.contains("one damping makes a plant, got ζ = 0, ζ = 0.001, ζ = 0.005, ζ = 0.02"), "{several}");
    let name = refused(&["export", path(&spec), "--as", "c", "--out", &file, "--damping-ratio", "0.01"]);
    assert!(name.contains("must be a lower-case letter and then letters, digits or underscores, got \"2x\""), "{name}");
    assert_eq!(names(folder.path()), ["spec.toml"]);
}
