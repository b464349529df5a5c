//! The workspace's test executables, as the part `tests` builds them: what runs some of them in another way takes them from here, for cargo builds
//! anew for each choice of packages, since that changes the features of what they share.
//!
//! Next door: the parts that do so (`test`).

use std::path::PathBuf;
use std::process::{Command, Stdio};

use anyhow::{Context, bail};
use serde::Deserialize;

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
    /// A run of it, as cargo would run it.
    pub fn command(&self) -> Command {
        let mut command = Command::new(&self.path);
        command.current_dir(&self.folder).env("CARGO_MANIFEST_DIR", &self.folder);
        command
    }
}

/// A line of cargo's messages, as far as it matters here.
#[derive(Deserialize)]
struct Message {
    reason: String,
    manifest_path: Option<PathBuf>,
    executable: Option<PathBuf>,
    target: Option<Target>,
    profile: Option<Profile>,
}

#[derive(Deserialize)]
struct Target {
    name: String,
}

#[derive(Deserialize)]
struct Profile {
    test: bool,
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
        let message: Message = serde_json::from_str(line).with_context(|| format!("not a message of cargo: {line}"))?;
        let is_test = message.reason == "compiler-artifact" && message.profile.is_some_and(|profile| profile.test);
        let (true, Some(path), Some(manifest), Some(target)) =
            (is_test, message.executable, message.manifest_path, message.target)
        else {
            continue;
        };
        let folder = manifest.parent().context("a manifest without a folder")?.to_owned();
        let package = folder.file_name().and_then(std::ffi::OsStr::to_str).unwrap_or_default().to_owned();
        found.push(Executable { package, name: target.name, path, folder });
    }
    if found.is_empty() {
        bail!("cargo named no test");
    }
    Ok(Some(found))
}
