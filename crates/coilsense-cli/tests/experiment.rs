//! `coilsense experiment` as a person meets it: a folder of logs that a person describes by hand.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

const DESCRIPTION: &str = r#"
name = "a spring on the bench"
nominal_force = "100 N"
length_at_zero_force = "104 mm"
averaging = "500 ms"
fast_mapping = "daq.toml"

[[run]]
kind = "calibration"
slow = "rest.csv"

[[run]]
kind = "preload"
fast = "before.csv"
slow = "before-lcr.csv"

[[run]]
kind = "harmonic"
frequency = "8 Hz"
fast = "shaken.csv"
slow = "shaken-lcr.csv"

[[run]]
kind = "preload"
fast = "after.csv"

[[run]]
kind = "hit"
"#;

/// A load cell and a laser that know nothing of coilsense: semicolons, decimal commas, names of their own.
fn fast(amplitude: f64) -> String {
    let row = |index: u32| {
        let time = f64::from(index) / 1000.0;
        let sine = (std::f64::consts::TAU * 8.0 * time).sin();
        format!("{time};{};{}\n", 26.0 + 1.1 * amplitude * sine, -amplitude / 0.76 * sine).replace('.', ",")
    };
    "t [s];LC [N];LDM [mm]\n".to_owned() + &(0..1000).map(row).collect::<String>()
}

fn slow(force: f64) -> String {
    let length = 0.104 + force / 760.0;
    let henry = (1.0 / length - 0.3) / 1.6e6;
    "L [H]\n".to_owned() + &format!("{henry:e}\n").repeat(4)
}

fn folder() -> tempfile::TempDir {
    let place = tempfile::tempdir().unwrap();
    let rest = |index: i32| {
        let u1 = 1e-3 * f64::from(index - 3);
        let force = 26.0 - 760.0 * u1;
        format!("{},{force},{}\n", 1e3 * u1, slow(force).lines().nth(1).unwrap())
    };
    let rest = "u1 [mm],F_o [N],L [H]\n".to_owned() + &(0..7).map(rest).collect::<String>();
    for (name, text) in [
        ("experiment.toml", DESCRIPTION.to_owned()),
        ("daq.toml", "[columns]\ntime = \"t [s]\"\nF_o = \"LC [N]\"\nu1 = \"LDM [mm]\"\n".to_owned()),
        ("rest.csv", rest),
        ("before.csv", fast(0.0)),
        ("before-lcr.csv", slow(26.0)),
        ("shaken.csv", fast(1.0)),
        ("shaken-lcr.csv", slow(25.9)),
        ("after.csv", fast(0.0)),
    ] {
        fs::write(place.path().join(name), text).unwrap();
    }
    place
}

fn experiment(folder: &Path, options: &[&str]) -> std::process::Output {
    Command::new(env!("CARGO_BIN_EXE_coilsense")).arg("experiment").arg(folder).args(options).output().unwrap()
}

#[test]
fn an_experiment_that_a_person_describes_is_worked_off() {
    let place = folder();
    let out = place.path().join("out");
    let output = experiment(place.path(), &["--out", out.to_str().unwrap(), "--json", "--date", "2026-11-21"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let number = |pointer: &str| found.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer}"));
    assert!((number("/spring/stiffness_n_per_m") - 760.0).abs() < 1e-6);
    assert!((number("/inverse_length/alpha_per_h_m") / 1.6e6 - 1.0).abs() < 1e-6);
    // F_o swings by a tenth more than F_x: 0.1/√2 N of 100.
    assert!((number("/runs/1/rmsd_percent") - 0.1 / 2.0_f64.sqrt()).abs() < 1e-9);
    assert!((number("/runs/1/means/F_L/difference_percent") + 0.1).abs() < 1e-6);
    assert!(found["simulated"] == false && found["runs"].as_array().unwrap().len() == 3);
    // The last preload has no readings of L.
    assert!(found["runs"][2]["means"]["F_L"].is_null() && found["runs"][2]["readings"] == 0);
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("a spring on the bench") && !page.contains("imulated data") && !page.contains("src=\""));
    for figure in ["figure-5", "figure-6", "means-in-order"] {
        assert!(out.join(format!("figures/{figure}.png")).is_file(), "{figure}");
    }
    let text = experiment(place.path(), &["--out", out.to_str().unwrap()]);
    let text = String::from_utf8(text.stdout).unwrap();
    assert!(text.lines().next().unwrap().starts_with("F_o and F_x differ most at 8.00 Hz (shaken)"), "{text}");
    assert!(text.contains("One run of hits is not evaluated here") && !text.contains("next release"));
    // The word of the release before is read, and said.
    let description = place.path().join("experiment.toml");
    fs::write(&description, DESCRIPTION.replace("\"hit\"", "\"tap\"")).unwrap();
    let text = String::from_utf8(experiment(place.path(), &["--out", out.to_str().unwrap()]).stdout).unwrap();
    assert!(text.contains("One run of hits") && text.contains("kind = \"tap\" is called \"hit\" now"), "{text}");
}

/// The same rows, two of which changed places, one of which came twice, and one of which a reading was lost.
fn spoiled(text: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines.swap(101, 102);
    lines[500] = lines[500].split(';').next().unwrap().to_owned() + ";;0";
    lines.insert(301, lines[300].clone());
    lines.join("\n") + "\n"
}

#[test]
fn what_is_wrong_with_a_log_is_mended_where_that_is_allowed_and_told() {
    let place = folder();
    let out = place.path().join("out");
    let numbers = |options: &[&str]| {
        let output = experiment(place.path(), &[&["--out", out.to_str().unwrap(), "--json"], options].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    let whole = numbers(&[]);
    fs::write(place.path().join("shaken.csv"), spoiled(&fast(1.0))).unwrap();
    let mut lcr = slow(25.9);
    lcr.push_str("none\n");
    fs::write(place.path().join("shaken-lcr.csv"), lcr).unwrap();

    // Each trouble is named with its file and the option that mends it, and only that option goes past it.
    let trouble = |options: &[&str]| {
        let output = experiment(place.path(), &[&["--out", "nowhere"], options].concat());
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), message.lines().count()), (Some(2), 1), "{message}");
        assert!(output.stdout.is_empty() && !Path::new("nowhere").exists());
        message
    };
    let missing = trouble(&[]);
    assert!(missing.contains("shaken-lcr.csv:6") && missing.contains("--drop-incomplete"), "{missing}");
    let order = trouble(&["--drop-incomplete"]);
    assert!(order.contains("shaken.csv:103") && order.contains("--sort"), "{order}");
    let twice = trouble(&["--drop-incomplete", "--sort"]);
    assert!(twice.contains("shaken.csv") && twice.contains("--merge-repeated"), "{twice}");

    let cleaned = numbers(&["--drop-incomplete", "--sort", "--merge-repeated", "--fill-gaps", "5 ms"]);
    let rmsd = |found: &Value| found.pointer("/runs/1/rmsd_percent").and_then(Value::as_f64).unwrap();
    // One sample of a thousand on a straight line: its share of the mean square, at most.
    assert!((rmsd(&cleaned) - rmsd(&whole)).abs() < 1e-3 * rmsd(&whole), "{} and {}", rmsd(&cleaned), rmsd(&whole));
    assert_eq!(cleaned["runs"][1]["readings"], 4);
    let account: Vec<&str> = cleaned["account"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    let of_fast = account.iter().find(|line| line.contains("shaken.csv: ")).expect("what was cleaned");
    assert!(of_fast.contains("1 row merged into another row of the same time left out"), "{of_fast}");
    assert!(of_fast.contains("sorted: 1 rows stood out of order"), "{of_fast}");
    assert!(of_fast.contains("F_o: 1 missing values filled along straight lines"), "{of_fast}");
    let of_slow = account.iter().find(|line| line.contains("shaken-lcr.csv: ")).expect("what was left out");
    assert!(of_slow.contains("1 row with a missing value left out (the first in line 6)"), "{of_slow}");
    assert!(!account.iter().any(|line| line.contains("before.csv: ")), "{account:?}");
}

#[test]
fn nothing_is_written_where_a_log_is_wrong() {
    let place = folder();
    let out = place.path().join("out");
    fs::write(place.path().join("shaken.csv"), "t [s];LC [N];LDM [mm]\n0;1;2\n0,001;x;2\n").unwrap();
    let output = experiment(place.path(), &["--out", out.to_str().unwrap()]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && output.stdout.is_empty(), "{message}");
    assert!(message.lines().count() == 1 && message.contains("shaken.csv:3"), "{message}");
    assert!(!out.exists());
}

#[test]
fn a_frequency_that_the_log_does_not_have_is_refused_with_file_and_both_numbers() {
    let place = folder();
    let out = place.path().join("out");
    fs::write(place.path().join("experiment.toml"), DESCRIPTION.replace("8 Hz", "8.4 Hz")).unwrap();
    let output = experiment(place.path(), &["--out", out.to_str().unwrap()]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && message.lines().count() == 1 && !out.exists(), "{message}");
    assert!(
        message.contains("shaken.csv: moves at 8.00") && message.contains("not at the 8.4 Hz that shaken"),
        "{message}"
    );
}
