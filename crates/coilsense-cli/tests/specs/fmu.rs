//! `coilsense export --as fmu`: the file, and what is said where there is no compiler.
//!
//! Next door: the same in a simulator (`python/tests/test_fmu.py`), what has no plant (`export`).

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

use super::{command, done, names, path, place, refused};

const ONE: &str = "[mount]\ndamping_ratio = 0.005\n";
const SOURCES: [&str; 6] = [
    "modelDescription.xml",
    "sources/fmi2.c",
    "sources/fmi2_exchange.h",
    "sources/exchange.h",
    "sources/unit.h",
    "sources/ankle_2.h",
];
const SOURCES_OF_3: [&str; 6] = [
    "modelDescription.xml",
    "sources/buildDescription.xml",
    "sources/fmi3.c",
    "sources/fmi3_others.h",
    "sources/unit.h",
    "sources/ankle_2.h",
];
/// Where the standards have a binary for this machine.
const BINARIES: [&str; 2] = ["binaries/linux64/ankle_2.so", "binaries/x86_64-linux/ankle_2.so"];

/// Whether the file, which is packed without compression, names this.
fn holds(file: &Path, name: &str) -> bool {
    let bytes = fs::read(file).unwrap();
    bytes.windows(name.len()).any(|part| part == name.as_bytes())
}

#[test]
fn an_fmu_has_sources_a_binary_and_the_same_bytes_each_time() {
    let (folder, spec) = place(ONE);
    let out = folder.path().join("Ankle-2.fmu");
    let words = ["export", path(&spec), "--as", "fmu", "--out", path(&out), "--step", "0.5 ms"];
    let told = done(&words);
    assert!(
        told.ends_with(&format!(
            "all 52 modes: exact for inputs that move straight between samples\n{}\n",
            out.display()
        ))
    );
    let first = fs::read(&out).unwrap();
    for name in SOURCES.into_iter().chain(["stepSize=\"0.0005\"", "modelIdentifier=\"ankle_2\""]) {
        assert!(holds(&out, name), "{name}");
    }
    assert_eq!(holds(&out, BINARIES[0]), cfg!(all(target_os = "linux", target_arch = "x86_64")));
    // A file that is there is replaced.
    done(&words);
    assert!(fs::read(&out).unwrap() == first);
    assert_eq!(names(folder.path()), ["Ankle-2.fmu", "spec.toml"]);
}

#[test]
fn an_fmu_of_3_is_another_file_and_2_is_what_comes_without_a_word() {
    let (folder, spec) = place(ONE);
    let out = folder.path().join("ankle_2.fmu");
    let made = |more: &[&str]| {
        done(&[&["export", path(&spec), "--as", "fmu", "--out", path(&out)], more].concat());
        fs::read(&out).unwrap()
    };
    let three = made(&["--fmi", "3.0"]);
    for name in SOURCES_OF_3.into_iter().chain(["fmiVersion=\"3.0\"", "instantiationToken=\"{"]) {
        assert!(holds(&out, name), "{name}");
    }
    let is_here = cfg!(all(target_os = "linux", target_arch = "x86_64"));
    assert_eq!(BINARIES.map(|name| holds(&out, name)), [false, is_here]);
    assert!(!holds(&out, "sources/fmi2.c"));
    let two = made(&["--fmi", "2.0"]);
    assert!(holds(&out, "fmiVersion=\"2.0\"") && two != three);
    assert_eq!(BINARIES.map(|name| holds(&out, name)), [is_here, false]);
    assert!(made(&[]) == two);
}

#[test]
fn without_a_compiler_the_sources_are_written_and_that_is_said() {
    let (folder, spec) = place(ONE);
    let out = folder.path().join("ankle_2.fmu");
    let bin = folder.path().join("bin");
    fs::create_dir(&bin).unwrap();
    let told_of = |fmi: &str, sources: &[&str], says: &str| {
        let words = ["export", path(&spec), "--as", "fmu", "--fmi", fmi, "--out", path(&out), "--json"];
        let ran = command(&words).env("PATH", &bin).output().unwrap();
        assert!(ran.status.success());
        let line = format!("warning: {}: {says}: sources only, no binary for this machine\n", out.display());
        assert_eq!(String::from_utf8(ran.stderr).unwrap(), line);
        let json: serde_json::Value = serde_json::from_slice(&ran.stdout).unwrap();
        assert_eq!(json["left_out"], format!("{says}: sources only, no binary for this machine"));
        assert!(sources.iter().all(|name| holds(&out, name)) && !holds(&out, "binaries/"));
    };
    let told = |says: &str| {
        told_of("2.0", &SOURCES, says);
        told_of("3.0", &SOURCES_OF_3, says);
    };
    if cfg!(not(all(target_os = "linux", target_arch = "x86_64"))) {
        return;
    }
    told("no C compiler: cc is not found");
    let compiler = |script: &str| {
        let file = bin.join("cc");
        fs::write(&file, format!("#!/bin/sh\n{script}\n")).unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).unwrap();
    };
    compiler("echo 'In file included from a.h:'  >&2; echo 'a.h:1: error: no such thing' >&2; exit 1");
    told("the C compiler cc failed: a.h:1: error: no such thing");
    compiler("exit 1");
    told("the C compiler cc failed");
    compiler("exit 0");
    told("the C compiler cc left no library");
}

#[test]
fn what_cannot_be_an_fmu_is_one_line_and_leaves_nothing() {
    let (folder, spec) = place(ONE);
    let told = |spec: &Path, file: &str, more: &[&str]| {
        let out = folder.path().join(file);
        let refused = refused(&[&["export", path(spec), "--as", "fmu", "--out", path(&out)], more].concat());
        assert_eq!(names(folder.path()), ["spec.toml"], "{refused}");
        refused
    };
    let name = "must be a lower-case letter and then letters, digits or underscores";
    assert!(told(&spec, "2x.fmu", &[]).contains(name));
    assert!(told(&spec, "Ä.fmu", &[]).contains(name));
    assert!(
        told(&spec, "a.fmu", &["--precision", "single"]).contains("--precision: must be double of an fmu, got single")
    );
    assert!(told(&spec, "a.fmu", &["--step", "0 s"]).contains("'--step <TIME>': must be above zero"));
    assert!(told(&spec, "a.fmu", &["--fmi", "1.0"]).contains("'--fmi <WORD>': must be one of 2.0, 3.0"));
    assert!(told(&spec, "a.fmu", &["--fmi", "3"]).contains("'--fmi <WORD>': must be one of 2.0, 3.0"));
    for form in ["c", "rust", "state-space"] {
        let out = folder.path().join("a");
        let refused = refused(&["export", path(&spec), "--as", form, "--fmi", "3.0", "--out", path(&out)]);
        assert!(refused.contains(&format!("--fmi: goes with fmu, got 3.0 with {form}")), "{refused}");
        assert_eq!(names(folder.path()), ["spec.toml"]);
    }
    let (_other, several) = place("");
    assert!(told(&several, "a.fmu", &[]).contains("one damping makes a plant"));
}
