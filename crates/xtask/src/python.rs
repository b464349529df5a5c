//! A Python environment inside the project, set up on first use.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, bail};

use crate::root;

/// A virtual environment with its packages.
pub struct Environment {
    folder: PathBuf,
}

/// The environment `folder` with the packages of `requirements`, both relative to the project; made, or brought up to date, where needed.
pub fn environment(folder: &str, requirements: &str) -> anyhow::Result<Environment> {
    let environment = Environment { folder: root().join(folder) };
    let wanted = std::fs::read(root().join(requirements)).with_context(|| format!("{requirements} cannot be read"))?;
    let stamp = environment.folder.join("requirements.stamp");
    if std::fs::read(&stamp).is_ok_and(|installed| installed == wanted) {
        return Ok(environment);
    }
    eprintln!("== Python packages of {requirements} into {folder}");
    let made = Command::new("python3").args(["-m", "venv"]).arg(&environment.folder).status();
    if !made.context("python3 cannot be started; install Python 3.11 or later with its venv module")?.success() {
        bail!("python3 -m venv failed; on Debian: apt-get install python3-venv");
    }
    let mut install = environment.python();
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r", requirements]);
    if !install.status()?.success() {
        bail!("pip install -r {requirements} failed");
    }
    std::fs::write(&stamp, wanted)?;
    Ok(environment)
}

impl Environment {
    /// Its interpreter, started in the project's root.
    pub fn python(&self) -> Command {
        let mut command = Command::new(self.folder.join("bin/python"));
        command.current_dir(root());
        command
    }
}
