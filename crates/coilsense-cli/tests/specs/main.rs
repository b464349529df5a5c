//! The commands that read a spec, as a person meets them: `init`, `spring`, `simulate`, `analyze`, `export`.

mod analyze;
#[cfg(unix)]
#[path = "../answering/mod.rs"]
mod answering;
mod export;
mod fmu;
mod import;
mod init_and_spring;
mod interrupt;
mod placement;
mod placement_tolerances;
mod rig;
mod simulate;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

/// S_T, hit and shaken for 20 ms, watched by three sensors; quick to process.
const QUICK: &str = r#"
[mount]
damping_ratio = [0, 0.01]

[[condition]]
name = "heel strike"
kind = "impact"
velocity = "0.25 m/s"
duration = "20 ms"

[[condition]]
name = "shake"
kind = "harmonic"
frequency = "0.5 f1"
amplitude = "1 %"
duration = "20 ms"

[[sensor]]
name = "load cell"
kind = "load-cell"
noise = "0.1 %"

[[sensor]]
name = "laser"
kind = "deflection"

[[sensor]]
kind = "inductance"

[goal]
error = "1 %"

[uncertainty]
trials = 1000
"#;

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
    command.args(arguments);
    command
}

fn coilsense(arguments: &[&str]) -> Output {
    command(arguments).output().expect("the command starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// Runs the command, which must do as it is told; what it prints.
fn done(arguments: &[&str]) -> String {
    let output = coilsense(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    assert!(only_warns(&output), "{}", text(&output.stderr));
    text(&output.stdout)
}

/// Nothing but warnings on standard error.
fn only_warns(output: &Output) -> bool {
    text(&output.stderr).lines().all(|line| line.starts_with("warning: "))
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

/// A folder with a spec in it.
fn place(tables: &str) -> (TempDir, PathBuf) {
    let place = tempfile::tempdir().expect("a temporary folder");
    let spec = place.path().join("spec.toml");
    fs::write(&spec, format!("{}{tables}", include_str!("../../../coilsense-lab/data/springs/S_T.toml")))
        .expect("written");
    (place, spec)
}

/// Names of all that is in a folder, hidden or not, but the list of what was written there.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8")).collect();
    names.retain(|name| name != ".coilsense");
    names.sort();
    names
}
