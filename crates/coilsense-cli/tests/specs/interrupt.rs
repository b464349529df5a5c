//! Ctrl-C in the middle of the work.
#![cfg(unix)]

use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::answering::answering;
use super::{names, path, place, text};

/// So many cases that they take several seconds, none of them long.
fn slow() -> String {
    let ratios: Vec<String> = (0..64).map(|index| format!("{}", f64::from(index) / 100.0)).collect();
    let conditions = ["min", "mid", "max"].map(|length| {
        format!("[[condition]]\nname = \"{length}\"\nkind = \"impact\"\nvelocity = \"1 m/s\"\nlength = \"{length}\"\nduration = \"2 s\"\n")
    });
    format!("[mount]\ndamping_ratio = [{}]\n{}", ratios.join(", "), conditions.concat())
}

/// A rig with so many runs that they take several seconds, none of them long.
const SLOW_RIG: &str = "[mount]\ndamping_ratio = 0.01\n[rig]\nhits = 300\n";

#[test]
fn ctrl_c_leaves_the_folder_as_it_was() {
    let (place, spec) = place(&slow());
    let rig = place.path().join("rig.toml");
    fs::write(&rig, format!("{}{SLOW_RIG}", include_str!("../../../coilsense-lab/data/springs/S_T.toml"))).unwrap();
    let out = place.path().join("out");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("results.json"), "mine").unwrap();
    let file = out.join("runs.csv");
    for arguments in [
        ["analyze", path(&spec), "--out", path(&out)],
        ["simulate", path(&spec), "--out", path(&file)],
        ["rig", path(&rig), "--out", path(&out)],
    ] {
        let child = answering().args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // From its begin on there is a folder that it fills.
        let begun = Instant::now();
        while names(&out).len() < 2 {
            assert!(begun.elapsed() < Duration::from_secs(60), "it never began");
            std::thread::sleep(Duration::from_millis(2));
        }
        let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(killed.success());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
        assert_eq!(text(&output.stderr), "error: interrupted; nothing was written\n");
        assert!(output.stdout.is_empty());
        assert_eq!(names(&out), ["results.json"]);
        assert_eq!(fs::read_to_string(out.join("results.json")).unwrap(), "mine");
    }
    assert_eq!(names(place.path()), ["out", "rig.toml", "spec.toml"]);
}
