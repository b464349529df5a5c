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
    environment.make()?;
    if !environment.pip().args(["-r", requirements]).status()?.success() {
        bail!("pip install -r {requirements} failed");
    }
    std::fs::write(&stamp, wanted)?;
    Ok(environment)
}

/// The environment `folder`, relative to the project, made anew and with nothing in it.
pub fn fresh(folder: &str) -> anyhow::Result<Environment> {
    let environment = Environment { folder: root().join(folder) };
    if environment.folder.exists() {
        std::fs::remove_dir_all(&environment.folder)?;
    }
    environment.make()?;
    Ok(environment)
}

impl Environment {
    fn make(&self) -> anyhow::Result<()> {
        let made = Command::new("python3").args(["-m", "venv"]).arg(&self.folder).status();
        if !made.context("python3 cannot be started; install Python 3.11 or later with its venv module")?.success() {
            bail!("python3 -m venv failed; on Debian: apt-get install python3-venv");
        }
        Ok(())
    }

    /// Its `pip install`, started in the project's root.
    pub fn pip(&self) -> Command {
        let mut command = self.python();
        command.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
        command
    }

    /// Its interpreter, started in the project's root.
    pub fn python(&self) -> Command {
        let programs = self.folder.join("bin");
        let mut command = Command::new(programs.join("python"));
        command.current_dir(root());
        // As an activated environment has it: who looks for "python" there finds this one.
        let before = std::env::var_os("PATH").unwrap_or_default();
        if let Ok(path) = std::env::join_paths(std::iter::once(programs).chain(std::env::split_paths(&before))) {
            command.env("PATH", path);
        }
        command
    }
}
