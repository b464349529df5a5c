//! The command as a person meets it.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn coilsense(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_coilsense")).args(arguments).output().expect("the command starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// Runs the command, which must refuse: exit code 2, one line on standard error, nothing on standard output.
fn refused(arguments: &[&str]) -> String {
    let output = coilsense(arguments);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(output.stdout.is_empty());
    message
}

fn path(path: &Path) -> &str {
    path.to_str().expect("UTF-8 path")
}

/// The built-in springs in a folder, S_T's file changed.
fn springs(change: impl Fn(String) -> String) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let s_t = change(include_str!("../../coilsense-lab/data/springs/S_T.toml").to_owned());
    fs::write(folder.path().join("S_T.toml"), s_t).expect("written");
    fs::write(folder.path().join("S_A.toml"), include_str!("../../coilsense-lab/data/springs/S_A.toml"))
        .expect("written");
    folder
}

#[test]
fn reproduce_prints_the_answer_first_and_writes_the_folder() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().join("deep/paper");
    let output = coilsense(&["reproduce", "--out", path(&out)]);
    let printed = text(&output.stdout);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(printed.lines().next().unwrap().contains("30 of 30 cells"), "{printed}");
    assert!(printed.contains("S_A, resonance (tables): windings touch from t = 0.529 s on"));
    assert!(printed.contains("24 files in"));
    assert!(!printed.contains('\u{1b}'), "colour although it is no terminal");
    assert!(out.join("report.html").is_file());
    assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1, "something was left beside the folder");
}

/// The names that the lab's sources give to hints of options.
fn hinted() -> BTreeSet<String> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("../coilsense-lab/src")];
    let mut names = BTreeSet::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else if entry.extension().is_some_and(|kind| kind == "rs") {
                let source = fs::read_to_string(entry).unwrap();
                for hint in source.split("Hint::").skip(1).filter(|hint| !hint.starts_with("Column")) {
                    names.extend(
                        hint.split_once("(\"")
                            .filter(|(kind, _)| kind.len() < 7)
                            .map(|(_, rest)| rest.split('"').next().unwrap().to_owned()),
                    );
                }
            }
        }
    }
    names
}

/// An option that a message advises is one that the command and Python have.
#[test]
fn every_option_that_is_advised_is_there() {
    let stub = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../python/coilsense/_coilsense.pyi"));
    let stub = stub.unwrap();
    let helps: String =
        ["import", "identify", "calibrate", "sweep"].map(|verb| text(&coilsense(&[verb, "--help"]).stdout)).concat();
    let names = hinted();
    assert!(names.contains("drop_incomplete") && names.contains("over") && names.len() > 12, "{names:?}");
    for name in names {
        assert!(
            helps.contains(&format!("--{} ", name.replace('_', "-")))
                || helps.contains(&format!("--{}\n", name.replace('_', "-"))),
            "--{name}"
        );
        let argument = match name.as_str() {
            "from" => "from_",
            "column" => "columns",
            name => name,
        };
        assert!(stub.contains(&format!(" {argument}: ")), "{argument} in Python");
    }
}

#[test]
fn one_protocol_alone_prints_only_its_tables() {
    let place = tempfile::tempdir().unwrap();
    let output = coilsense(&["reproduce", "--protocol", "text", "--out", path(place.path())]);
    let printed = text(&output.stdout);
    assert!(printed.contains("Table III, text protocol") && !printed.contains("tables protocol"), "{printed}");
    let json = fs::read_to_string(place.path().join("tables.json")).unwrap();
    assert_eq!(json.matches("\"tables_percent\":null").count(), 60);
}

#[test]
fn the_springs_of_a_folder_are_used_and_said_to_be_others() {
    let folder = springs(|text| text.replace("65 g", "130 g"));
    let place = tempfile::tempdir().unwrap();
    let output = coilsense(&["reproduce", "--springs", path(folder.path()), "--out", path(place.path())]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("The springs are not those of Table I"));
    assert!(!text(&output.stdout).contains("not used here"));
    let page = fs::read_to_string(place.path().join("report.html")).unwrap();
    assert!(page.contains("not those of the paper"));
}

#[test]
fn what_the_tables_do_not_take_of_a_springs_file_is_said() {
    let folder = springs(|text| text);
    let file = folder.path().join("S_A.toml");
    let more = "\n[mount]\nend2 = \"mass\"\nend_mass = \"2 kg\"\n";
    fs::write(&file, fs::read_to_string(&file).unwrap().replace("\"chain\"", "\"helix\"") + more).unwrap();
    let place = tempfile::tempdir().unwrap();
    let output = coilsense(&["reproduce", "--springs", path(folder.path()), "--out", path(place.path())]);
    let said = text(&output.stdout);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(said.contains("S_A.toml: not used here: [mount], model = \"helix\"."), "{said}");
    assert!(!said.contains("S_T.toml: not used here"), "{said}");
    // Both are the paper's all the same.
    assert!(!said.contains("The springs are not those of Table I"), "{said}");
}

#[test]
fn a_spring_that_cannot_be_is_refused_and_nothing_is_written() {
    let cases: [(&str, &str, &[&str]); 5] = [
        ("\"65 g\"", "\"-65 g\"", &["S_T.toml:10", "mass", "-65 g", "above zero", "kg"]),
        ("\"65 g\"", "\"nan g\"", &["S_T.toml:10", "mass", "NaN", "kg"]),
        ("\"264 mm\"", "\"100 mm\"", &["S_T.toml:13", "max_length", "100 mm", "above the min length of 0.196 m"]),
        ("mass = \"65 g\"", "", &["S_T.toml:4", "lacks the key \"mass\"", "unit"]),
        ("mass =", "mas =", &["S_T.toml:10", "unknown key \"mas\"", "mass"]),
    ];
    for (old, new, words) in cases {
        let folder = springs(|text| text.replace(old, new));
        let place = tempfile::tempdir().unwrap();
        let out = place.path().join("out");
        let message = refused(&["reproduce", "--springs", path(folder.path()), "--out", path(&out)]);
        for word in words {
            assert!(message.contains(word), "{word} in {message}");
        }
        assert!(message.contains(path(folder.path())), "the file's folder in {message}");
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 0, "something was written");
    }
}

#[test]
fn a_folder_without_the_springs_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let message = refused(&["reproduce", "--springs", path(folder.path())]);
    assert!(message.contains("S_T.toml") && message.contains("cannot be read"), "{message}");
}

#[test]
fn a_folder_that_cannot_be_written_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("file");
    fs::write(&file, "mine").unwrap();
    for out in [file.clone(), file.join("below"), "/proc/coilsense".into()] {
        let message = refused(&["reproduce", "--out", path(&out)]);
        assert!(message.contains(path(&out)), "{message}");
    }
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let place = tempfile::tempdir().unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_coilsense"))
        .args(["reproduce", "--out", path(place.path())])
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    assert!(child.wait().unwrap().success());
    assert!(place.path().join("report.html").is_file());
}

#[test]
fn a_science_error_is_one_line_and_says_things_once() {
    // Uniform windings that would have to overlap over all of the range still have an inductance; a range of one point has none.
    let folder = springs(|text| text.replace("windings = 52 ", "windings = 1.2 "));
    let message = refused(&["reproduce", "--springs", path(folder.path())]);
    assert!(message.contains("S_T.toml: windings = 1.2: must be from 1.5 to 1000"), "{message}");
    let thin = |text: String| text.replace("windings = 52 ", "windings = 20000 ").replace("\"1 mm\"", "\"1 um\"");
    let folder = springs(thin);
    let message = refused(&["reproduce", "--springs", path(folder.path())]);
    assert!(message.contains("S_T.toml: windings = 20000: must be from 1.5 to 1000"), "{message}");
}

#[test]
fn swapped_spring_files_are_refused() {
    let folder = springs(|text| text.replace("name = \"S_T\"", "name = \"S_A\""));
    let message = refused(&["reproduce", "--springs", path(folder.path())]);
    assert!(message.contains("name = \"S_A\": must be another name"), "{message}");
}

#[test]
fn unknown_vector_instructions_are_refused() {
    let output = Command::new(env!("CARGO_BIN_EXE_coilsense"))
        .args(["reproduce", "--out", "/nowhere/at/all"])
        .env("COILSENSE_SIMD", "mmx")
        .output()
        .expect("the command starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(
        text(&output.stderr).starts_with("error: COILSENSE_SIMD must be one of scalar"),
        "{}",
        text(&output.stderr)
    );
}

#[test]
fn what_an_earlier_run_left_does_not_stand_beside_the_new_report() {
    let place = tempfile::tempdir().unwrap();
    for protocol in ["both", "text"] {
        let output = coilsense(&["reproduce", "--protocol", protocol, "--out", path(place.path())]);
        assert!(output.status.success());
    }
    let signals = fs::read_dir(place.path().join("signals")).unwrap();
    let names: Vec<String> = signals.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(names.len(), 10, "{names:?}");
    assert!(names.iter().all(|name| !name.contains("tables")), "{names:?}");
}

#[test]
fn a_damaged_log_is_refused_in_one_line_whatever_its_decoder_does() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let log = place.path().join("run.parquet");
    let good = include_bytes!("../../coilsense-lab/tests/golden/logs/motion.parquet");
    let out = place.path().join("run.csv");
    let decoder_panics = [3653, 3654, 3754, 3759, 3760];
    for index in decoder_panics {
        let mut bytes = good.to_vec();
        bytes[index] ^= if index % 2 == 0 { 0x01 } else { 0x80 };
        std::fs::write(&log, bytes).expect("written");
        let message = refused(&["import", log.to_str().expect("a path"), "--out", out.to_str().expect("a path")]);
        assert!(message.ends_with("run.parquet: is damaged and cannot be read\n"), "byte {index}: {message}");
        assert!(!out.exists());
    }
}

#[test]
fn a_wrong_option_is_refused_with_a_hint() {
    let output = coilsense(&["reproduce", "--protocl", "text"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("--protocol"));
}

#[test]
fn a_log_is_shown_before_anything_is_made_of_it() {
    let place = tempfile::tempdir().unwrap();
    let log = place.path().join("run.csv");
    let rows: String = (0..2000).map(|k| format!("{};{};7\n", f64::from(k) * 0.4, f64::from(k / 25))).collect();
    fs::write(&log, format!("by hand\nZeit (ms);LC (V);LCR\n{rows}")).unwrap();
    let shown = coilsense(&["import", path(&log)]);
    assert_eq!(shown.status.code(), Some(0), "{}", text(&shown.stderr));
    let shown = text(&shown.stdout);
    for words in [
        "2000 rows; 2.5 kHz, from 0 s to 0.7996 s",
        "#2  LC",
        "changes 98.8 times a second",
        "constant",
        "header: by hand",
        "in place of 1: --column F_o=\"LC\" --gain F_o=\"1 N/V\"",
    ] {
        assert!(shown.contains(words), "{words}: {shown}");
    }
    let told = ["--column", "F_o=LC", "--gain", "F_o=12.5 N/V", "--constant", "u2=104 mm"];
    let page = place.path().join("page");
    let all = [&["import", path(&log)], &told[..], &["--report", path(&page)]].concat();
    assert_eq!(coilsense(&all).status.code(), Some(0));
    let page = fs::read_to_string(page.join("report.html")).unwrap();
    assert!(page.contains("F_o over time and its spectrogram.") && page.contains("12.5 N"));
    // What stands still has a course only.
    assert!(page.contains("u2 over time."));
    let json = coilsense(&[&["import", path(&log), "--json"], &told[..]].concat());
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(
        (&json["schema"], &json["lacks"], &json["columns"][1]["channel"]),
        (&"coilsense/log/1".into(), &serde_json::Value::Null, &"F_o".into())
    );
    assert!(refused(&["import", path(&log), "--with", path(&log)]).contains("--with needs --out FILE"));
}
