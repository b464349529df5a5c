//! The commands that ask a sweep's folder: `pareto`, `sensitivity`; their answers beside those found from the rows themselves.
//!
//! Next door: the sweep itself (`sweep.rs`), the same as a library (`coilsense-lab/tests/sweep`).

mod pareto;
mod sensitivity;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use parquet::file::reader::SerializedFileReader;
use parquet::record::Field;

/// A coil of few windings, watched for a few samples: thousands of rows a second, also in a test build.
const SPEC: &str = include_str!("../short-coil.toml");

/// A folder with the spec, and the command in it.
struct Place {
    folder: tempfile::TempDir,
}

impl Place {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("spec.toml"), SPEC).expect("written");
        Self { folder }
    }

    fn run(&self, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
        command.current_dir(self.folder.path()).args(arguments).output().expect("it starts")
    }

    /// What a run prints that succeeds.
    fn printed(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    }

    /// The only line of a run that is refused.
    fn refusal(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let message = text(&output.stderr);
        assert_eq!((output.status.code(), message.lines().count()), (Some(2), 1), "{arguments:?}: {message}");
        assert!(output.stdout.is_empty(), "{}", text(&output.stdout));
        message
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn json(&self, name: &str) -> serde_json::Value {
        serde_json::from_slice(&fs::read(self.path(name)).expect("read")).expect("JSON")
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// Names of what a folder holds, but the list of what was written there.
fn names(folder: &Path) -> Vec<String> {
    let name =
        |entry: std::io::Result<fs::DirEntry>| entry.expect("an entry").file_name().into_string().expect("UTF-8");
    let mut names: Vec<String> = fs::read_dir(folder).expect("a folder").map(name).collect();
    names.retain(|name| name != ".coilsense");
    names.sort();
    names
}

/// Every row of a sweep's folder, as any reader of Parquet has it.
fn rows(folder: &Path) -> Vec<BTreeMap<String, Field>> {
    let files = names(folder).into_iter().filter(|name| name.ends_with(".parquet"));
    let of = |name: String| {
        let file = fs::File::open(folder.join(name)).expect("opened");
        SerializedFileReader::new(file).expect("Parquet").into_iter().map(|row| row.expect("a row"))
    };
    files.flat_map(of).map(|row| row.into_columns().into_iter().collect()).collect()
}

fn number(row: &BTreeMap<String, Field>, title: &str) -> f64 {
    match &row[title] {
        Field::Double(value) => *value,
        Field::Long(value) => *value as f64,
        other => panic!("{title} is no number: {other:?}"),
    }
}
