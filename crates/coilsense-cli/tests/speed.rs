//! `coilsense speed` as a person meets it: killed at any time, in parts on several machines.
//!
//! Next door: the map as a library (`coilsense-lab/tests/speed`).

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const SPEC: &str = include_str!("../../../examples/valve-train.toml");
const FILES: [&str; 4] = ["report.html", "results.json", "speed.csv", "speed.parquet"];

/// A folder with the spec, and the command on it.
struct Place(tempfile::TempDir);

impl Place {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("valve.toml"), SPEC).expect("written");
        Self(folder)
    }

    fn command(&self, out: &str, more: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
        command.current_dir(&self.0).args(["speed", "valve.toml", "--from", "1000rpm", "--to", "2000rpm"]);
        command.args(["--step", "500rpm", "--date", "2026-01-01", "--out", out]).args(more);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    fn run(&self, out: &str, more: &[&str]) -> Output {
        self.command(out, more).output().expect("runs")
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn files(&self, out: &str) -> Vec<Vec<u8>> {
        FILES.iter().map(|file| fs::read(self.path(out).join(file)).expect("a file of the map")).collect()
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// Bytes of all files of a folder, which may not be there yet.
fn bytes_in(folder: &Path) -> u64 {
    let files = fs::read_dir(folder).into_iter().flatten().flatten();
    files.filter_map(|file| Some(file.metadata().ok()?.len())).sum()
}

#[test]
fn a_killed_map_goes_on_and_leaves_the_files_of_an_unbroken_one() {
    let place = Place::new();
    assert!(place.run("whole", &[]).status.success());
    assert!(!place.path("whole.points").exists(), "the points are of no use once the map is there");
    let mut killed = place.command("map/", &[]).spawn().expect("runs");
    let begun = Instant::now();
    while bytes_in(&place.path("map.points")) == 0 && begun.elapsed() < Duration::from_secs(60) {
        sleep(Duration::from_millis(2));
    }
    killed.kill().expect("it runs");
    killed.wait().expect("it ends");
    assert!(!place.path("map/results.json").exists() && place.path("map.points").is_dir());
    let output = place.run("map/", &[]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(!place.path("map.points").exists());
    assert!(place.files("map") == place.files("whole"), "files differ");
}

#[test]
fn parts_say_what_is_missing_and_make_the_same_map() {
    let place = Place::new();
    let part = |number: &str| text(&place.run("parts", &["--part", number]).stdout);
    assert!(part("2/2").contains("are still missing"));
    assert!(!place.path("parts").exists());
    // Somebody's own file there is none of ours.
    fs::write(place.path("parts.points/notes.txt"), "mine").expect("written");
    assert!(part("1/2").contains("all are there: the same command without --part writes the map"));
    assert!(place.run("parts", &[]).status.success() && place.run("whole", &[]).status.success());
    assert!(place.files("parts") == place.files("whole"), "files differ");
    let left: Vec<_> = fs::read_dir(place.path("parts.points")).expect("there").flatten().collect();
    assert!(left.len() == 1 && left[0].file_name() == "notes.txt", "{left:?}");
    for (more, message) in [
        (["--part", "3/2"].as_slice(), "error: part must be K/N with K from 1 to N, such as 2/5, got \"3/2\""),
        (&["--part", "1/2", "--json"], "error: json: a share prints no map"),
    ] {
        let output = place.run("refused", more);
        let error = text(&output.stderr);
        assert!(error.starts_with(message) && error.lines().count() == 1, "{error}");
        assert_eq!(output.status.code(), Some(2));
        assert!(!place.path("refused").exists() && !place.path("refused.points").exists());
    }
}
