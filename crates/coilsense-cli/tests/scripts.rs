//! The command in a script: exit codes, what goes to which stream, what a shell completes, the manual's pages.

mod running;

use std::fs;
use std::process::{Command, Output};

use running::coilsense;

const ANKLE: &str = include_str!("../../../examples/sea-ankle.toml");

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// The ankle with other words in place of some, analyzed.
fn analyzed(changes: &[(&str, &str)], options: &[&str]) -> Output {
    let place = tempfile::tempdir().unwrap();
    let spec = changes.iter().fold(ANKLE.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    fs::write(place.path().join("my.toml"), spec).unwrap();
    let output = coilsense(place.path(), &[&["analyze", "my.toml", "--out", "out"], options].concat());
    assert!(place.path().join("out/report.html").is_file(), "{}", text(&output.stderr));
    output
}

/// The goal of the ankle.
const GOAL: &str = "[goal]\nerror = \"1 %\"";

#[test]
fn check_ends_with_3_where_the_goal_is_missed_or_nothing_is_decided() {
    let check = |changes: &[(&str, &str)]| {
        let output = analyzed(changes, &["--check"]);
        (output.status.code(), text(&output.stderr).lines().last().unwrap_or_default().to_owned())
    };
    assert_eq!(check(&[]).0, Some(0));
    let strict = check(&[(GOAL, "[goal]\nerror = \"0.01 %\"")]);
    assert_eq!(strict, (Some(3), "check: no sensor meets the goal of 0.0122 N (0.01 % of F_nom)".to_owned()));
    let none = check(&[(GOAL, "")]);
    assert_eq!(none, (Some(3), "check: the spec sets no [goal], so nothing is judged".to_owned()));
    // Without --check the work is done, and that is all that the code says.
    assert_eq!(analyzed(&[(GOAL, "[goal]\nerror = \"0.01 %\"")], &[]).status.code(), Some(0));
}

#[test]
fn a_goal_that_is_met_only_where_windings_pass_through_one_another_is_undecided() {
    // Hit so hard that the coil would clash.
    let hard = analyzed(
        &[("velocity = \"0.25 m/s\"", "velocity = \"30 m/s\""), (GOAL, "[goal]\nerror = \"90000 %\"")],
        &["--check"],
    );
    let said = text(&hard.stderr);
    assert_eq!(hard.status.code(), Some(3), "{said}");
    assert!(said.lines().last().unwrap().contains("windings would touch"), "{said}");
}

#[test]
fn warnings_go_to_the_other_stream_and_those_of_two_sensors_are_one() {
    let output = analyzed(&[], &[]);
    let (answer, warnings) = (text(&output.stdout), text(&output.stderr));
    assert!(answer.starts_with("Choose two encoders."), "{answer}");
    assert!(!answer.contains("Warning:") && !answer.contains("warning:"), "{answer}");
    let folded = "warning: “load cell, motor side” and “load cell, load side”: 17 surge lines";
    assert_eq!(warnings.lines().filter(|line| line.starts_with(folded)).count(), 1, "{warnings}");
    // A program reads them in its JSON, and nothing but JSON on that stream.
    let json = analyzed(&[], &["--json"]);
    let value: serde_json::Value = serde_json::from_str(&text(&json.stdout)).unwrap();
    assert!(value["warnings"].as_array().unwrap().len() > 2);
}

#[test]
fn quiet_says_nothing_but_errors_and_json() {
    let output = analyzed(&[], &["--quiet"]);
    assert!(
        output.status.success() && output.stdout.is_empty() && output.stderr.is_empty(),
        "{}",
        text(&output.stderr)
    );
    let json = analyzed(&[], &["-q", "--json"]);
    assert!(serde_json::from_str::<serde_json::Value>(&text(&json.stdout)).is_ok() && json.stderr.is_empty());
    let place = tempfile::tempdir().unwrap();
    // A spec that goes into a file by the shell is the product, and no talk.
    let init = coilsense(place.path(), &["init", "-q"]);
    assert!(text(&init.stdout).contains("\n[spring]\n"));
    let wrong = coilsense(place.path(), &["--quiet", "analyze", "none.toml"]);
    assert_eq!((wrong.status.code(), text(&wrong.stderr).lines().count()), (Some(2), 1));
}

#[test]
fn every_verb_says_its_version_and_a_shell_learns_all_of_them() {
    let place = tempfile::tempdir().unwrap();
    for verb in ["analyze", "identify", "man", "completions"] {
        let said = coilsense(place.path(), &[verb, "-V"]);
        assert!(said.status.success() && text(&said.stdout).contains(env!("CARGO_PKG_VERSION")), "{verb}");
    }
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = coilsense(place.path(), &["completions", shell]);
        let script = text(&script.stdout);
        for word in ["identify", "--length-at-zero", "--quiet"] {
            let bare = word.trim_start_matches('-');
            assert!(script.contains(bare), "{shell}: {word}");
        }
    }
    assert_eq!(coilsense(place.path(), &["completions", "tcsh"]).status.code(), Some(2));
    // bash itself reads its script, where it is there.
    let script = place.path().join("coilsense.bash");
    fs::write(&script, coilsense(place.path(), &["completions", "bash"]).stdout).unwrap();
    if let Ok(read) = Command::new("bash").arg("-n").arg(&script).output() {
        assert!(read.status.success(), "{}", text(&read.stderr));
    }
}

#[test]
fn man_writes_a_page_for_each_verb_and_leaves_others_alone() {
    let place = tempfile::tempdir().unwrap();
    fs::create_dir(place.path().join("man1")).unwrap();
    fs::write(place.path().join("man1/other.1"), "another's").unwrap();
    let said = coilsense(place.path(), &["man", "--out", "man1"]);
    assert!(said.status.success(), "{}", text(&said.stderr));
    let page = fs::read_to_string(place.path().join("man1/coilsense-analyze.1")).unwrap();
    assert!(page.contains(".TH coilsense-analyze") && page.contains("\\-\\-check"), "{page}");
    let whole = fs::read_to_string(place.path().join("man1/coilsense.1")).unwrap();
    assert!(whole.contains("identify") && whole.contains("sweep"));
    assert_eq!(fs::read_to_string(place.path().join("man1/other.1")).unwrap(), "another's");
    // Again: those are ours.
    assert!(coilsense(place.path(), &["man", "--out", "man1"]).status.success());
}
