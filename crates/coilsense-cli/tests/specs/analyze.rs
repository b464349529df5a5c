//! `coilsense analyze`.

use std::fs;
use std::process::Stdio;

use serde_json::Value;

use super::{QUICK, command, done, names, only_warns, path, place, refused};

#[test]
fn two_runs_of_one_date_give_the_same_bytes() {
    let (place, spec) = place(QUICK);
    let folders = ["one", "two"].map(|name| place.path().join(name));
    for folder in &folders {
        done(&["analyze", path(&spec), "--out", path(folder), "--date", "2026-11-21"]);
    }
    let files = names(&folders[0]);
    for name in ["results.json", "signals.parquet"] {
        assert!(files.contains(&name.to_owned()), "{files:?}");
    }
    for name in &files {
        assert_eq!(fs::read(folders[0].join(name)).unwrap(), fs::read(folders[1].join(name)).unwrap(), "{name}");
    }
    assert_eq!(files, names(&folders[1]));
    assert_eq!(names(place.path()), ["one", "spec.toml", "two"]);
}

#[test]
fn results_are_for_machines_and_the_answer_comes_first() {
    let (place, spec) = place(QUICK);
    let out = place.path().join("out");
    let printed = done(&["analyze", path(&spec), "--out", path(&out), "--date", "2026-11-21"]);
    let results: Value = serde_json::from_str(&fs::read_to_string(out.join("results.json")).unwrap()).unwrap();
    assert_eq!((&results["schema"], &results["date"]), (&"coilsense/analysis/1".into(), &"2026-11-21".into()));
    assert_eq!(results["ranking"].as_array().unwrap().len(), 3);
    assert_eq!(results["cases"].as_array().unwrap().len(), 4);
    let answer = results["answer"][0].as_str().unwrap();
    assert_eq!(printed.lines().next(), Some(answer));
}

#[test]
fn what_was_there_stays_where_a_spec_is_refused() {
    let (place, spec) = place("");
    let out = place.path().join("out");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("results.json"), "mine").unwrap();
    refused(&["analyze", path(&spec), "--out", path(&out)]);
    refused(&["analyze", "none.toml", "--out", path(&out)]);
    assert_eq!(names(&out), ["results.json"]);
    assert_eq!(fs::read_to_string(out.join("results.json")).unwrap(), "mine");
    let file = out.join("results.json");
    assert!(refused(&["analyze", path(&spec), "--out", path(&file)]).starts_with("error: "));
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let (place, spec) = place(QUICK);
    let out = place.path().join("out");
    for arguments in [
        vec!["analyze", path(&spec), "--out", path(&out)],
        vec!["init"],
        vec!["init", "--sensors"],
        vec!["spring", "--materials"],
        vec!["spring", path(&spec)],
    ] {
        let mut child = command(&arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success() && only_warns(&output), "{arguments:?}");
    }
    assert!(out.join("results.json").is_file());
}
