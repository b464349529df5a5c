//! The workspace's test executables, as the part `tests` builds them. Parts that run some of them in another way take them from here: with another
//! choice of packages cargo would build them anew, since that changes the features of what they share.
//!
//! Next door: the parts that do so (`test`).

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::Context;
use serde_json::Value;

use crate::cargo;

/// What every test of the workspace is built with; the same words build the same files.
pub const EVERY_TEST: [&str; 3] = ["test", "--workspace", "--all-features"];

/// A test executable.
pub struct Executable {
    /// Its package's name.
    pub package: String,
    /// Its own: that of the file or folder in `tests`, or the library's.
    pub name: String,
    path: PathBuf,
    /// The package's folder, in which cargo runs it.
    folder: PathBuf,
}

impl Executable {
    /// Its run, as cargo would start it.
    pub fn command(&self) -> Command {
        let mut command = Command::new(&self.path);
        command.current_dir(&self.folder).env("CARGO_MANIFEST_DIR", &self.folder);
        command
    }
}

/// Builds the tests where they are not built, and names them; `None` where that fails, of which cargo has told.
pub fn executables() -> anyhow::Result<Option<Vec<Executable>>> {
    let mut build = cargo(&EVERY_TEST);
    build.args(["--no-run", "--message-format=json-render-diagnostics"]).stderr(Stdio::inherit());
    let output = build.output().with_context(|| format!("cannot start {build:?}"))?;
    if !output.status.success() {
        return Ok(None);
    }
    let text = String::from_utf8(output.stdout).context("cargo's messages are not UTF-8")?;
    let mut found = Vec::new();
    for line in text.lines().filter(|line| line.starts_with('{')) {
        let message: Value = serde_json::from_str(line).with_context(|| format!("not a message of cargo: {line}"))?;
        let named = [&message["executable"], &message["manifest_path"], &message["target"]["name"]].map(Value::as_str);
        let (Some(true), [Some(path), Some(manifest), Some(name)]) = (message["profile"]["test"].as_bool(), named)
        else {
            continue;
        };
        let folder = Path::new(manifest).parent().context("a manifest without a folder")?.to_owned();
        let package = folder.file_name().and_then(std::ffi::OsStr::to_str).unwrap_or_default().to_owned();
        found.push(Executable { package, name: name.to_owned(), path: path.into(), folder });
    }
    Ok(Some(found))
}
