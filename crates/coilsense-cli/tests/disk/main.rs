//! What becomes of files and words where a disk is full, a folder read-only, a name odd, or the command is ended in the middle.
//!
//! Next door: files by themselves, step by step (`coilsense-lab/src/output`).
#![cfg(unix)]

#[path = "../answering/mod.rs"]
mod answering;
mod full;
mod kept;
mod killed;
mod signals;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A coil of few windings, hit, and watched for a few samples: quick in a test build, too.
const SPEC: &str = include_str!("../short-coil.toml");
const POINTS: &str = "l [mm],L [uH]\n196,3.9\n210,3.6\n230,3.35\n250,3.1\n264,2.95\n";

/// A folder, and the command in it.
struct Place(tempfile::TempDir);

impl Place {
    /// With `spec.toml`, and `points.csv` for a calibration.
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("spec.toml"), SPEC).expect("written");
        fs::write(folder.path().join("points.csv"), POINTS).expect("written");
        Self(folder)
    }

    /// What every command needs: an experiment, and a sweep of which all may be asked.
    fn whole() -> Self {
        let place = Self::new();
        let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
        for name in ["virtual-rig.toml", "sea-ankle.toml", "valve-train.toml"] {
            fs::copy(examples.join(name), place.path(name)).expect("an example");
        }
        place.done("rig virtual-rig.toml --out bench");
        place.done("sweep spec.toml --over spring.stiffness=600..900N/m --rows 64 --sampling saltelli --out designs");
        place
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
        command.args(arguments.split(' ')).current_dir(self.0.path());
        command
    }

    fn run(&self, arguments: &str) -> Output {
        self.command(arguments).output().expect("the command starts")
    }

    /// Runs what must do as it is told; what it prints.
    fn done(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        assert!(output.status.success(), "{arguments}: {}", text(&output.stderr));
        text(&output.stdout)
    }

    /// The only line of a run that is refused.
    fn refusal(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        refusal(arguments, &output)
    }

    /// All files and what is in them, but the lists of what was written.
    fn files(&self) -> BTreeMap<PathBuf, Vec<u8>> {
        files(self.0.path())
    }
}

fn refusal(what: &str, output: &Output) -> String {
    let message = text(&output.stderr);
    assert_eq!((output.status.code(), message.lines().count()), (Some(2), 1), "{what}: {message}");
    message
}

fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).into_iter().flatten().map(|entry| entry.expect("an entry").path()) {
        if entry.is_dir() {
            found.extend(files(&entry));
        } else if entry.is_file() && entry.file_name().is_some_and(|name| name != ".coilsense") {
            found.insert(entry.clone(), fs::read(&entry).unwrap_or_default());
        }
    }
    found
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Every command that writes, each to `new`: whole folders where that may be one, else a file in it.
const WRITING: [&str; 17] = [
    "init --from S_T --out new/spec.toml",
    "simulate spec.toml --out new/run.csv",
    "simulate spec.toml --out new/run.parquet",
    "analyze spec.toml --out new",
    "calibrate points.csv --column u2=l --length-at-zero 1mm --out new",
    "identify bench/hit-1-fast.csv --out new",
    "import bench/hit-1-fast.csv --out new/run.csv",
    "rig virtual-rig.toml --out new",
    "mitigate spec.toml --seeds 1 --out new",
    "export spec.toml --as c --out new/plant.h",
    "export spec.toml --as state-space --out new/plant.json",
    "placement sea-ankle.toml --out new",
    "speed valve-train.toml --from 1000rpm --to 1500rpm --step 500rpm --out new",
    "sensitivity designs --out new",
    "pareto designs --minimize F_o.rmsd --maximize stiffness --out new",
    "experiment bench --out new",
    "reproduce --protocol text --out new",
];
