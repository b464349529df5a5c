//! The types of the Python module: written from what PyO3 tells of it (`cargo xtask stubs`), and compared with the committed file.
//!
//! Next door: the checks of the package (`package`), what PyO3 cannot know (`python/stubs/write.py`).

use std::path::{Path, PathBuf};

use anyhow::{Context, bail};

use crate::package::{Built, REQUIREMENTS};
use crate::python::{self, Environment};
use crate::{as_cargo, root};

/// The file that is committed.
const STUB: &str = "python/coilsense/_coilsense.pyi";
/// Where the module is built with PyO3's account of it.
const PROJECT: &str = "python/stubs";

/// Writes the committed file.
pub fn write() -> anyhow::Result<()> {
    let environment = python::environment("target/python", REQUIREMENTS)?;
    generated(&environment, &root(), Built::AsReleased, &root().join(STUB))?;
    println!("{STUB}");
    Ok(())
}

/// Whether the committed file is what would be written of a source that the wheel was just built of: what it is built of need not be built again.
pub fn agree(environment: &Environment, source: &Path, built: Built) -> anyhow::Result<bool> {
    // A packed source has no need of what asks for the account.
    std::fs::create_dir_all(source.join(PROJECT))?;
    let project = Path::new(PROJECT).join("pyproject.toml");
    std::fs::copy(root().join(&project), source.join(&project))?;
    let folder = tempfile::tempdir()?;
    let anew = folder.path().join("_coilsense.pyi");
    generated(environment, source, built, &anew)?;
    let same =
        std::fs::read(root().join(STUB)).with_context(|| format!("{STUB} cannot be read"))? == std::fs::read(anew)?;
    if !same {
        eprintln!("{STUB} is not what the module tells; write it with: cargo xtask stubs");
    }
    Ok(same)
}

/// Writes the types of a source's module into a file.
fn generated(environment: &Environment, source: &Path, built: Built, file: &Path) -> anyhow::Result<()> {
    let folder = root().join("target/stubs");
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    let mut account = environment.python();
    account.args([
        "-m",
        "maturin",
        "generate-stubs",
        "--profile",
        built.profile(),
        "--quiet",
        "--interpreter",
        "python3",
    ]);
    as_cargo(&mut account);
    account.arg("--out").arg(&folder).current_dir(source.join(PROJECT)).env("CARGO_TARGET_DIR", built.folder());
    if !account.status().context("maturin cannot be started")?.success() {
        bail!("PyO3's account of the module cannot be had");
    }
    let mut types = environment.python();
    types.arg(root().join(PROJECT).join("write.py")).arg(account_in(&folder)?).arg(file);
    if !types.status().context("Python cannot be started")?.success() {
        bail!("the types are not all known");
    }
    Ok(())
}

/// The account's file: maturin calls it after the module or `__init__`, in a folder of the one or the other.
fn account_in(folder: &Path) -> anyhow::Result<PathBuf> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            return account_in(&path);
        }
        if path.extension().is_some_and(|ending| ending == "pyi") {
            return Ok(path);
        }
    }
    bail!("{}: maturin has written no stub", folder.display())
}
