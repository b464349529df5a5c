//! Whether the project can leave: its crates packed, unpacked into an empty folder, built there with the features of a plain build, and asked the main question.
//!
//! Next door: the same of the Python package (`package`).

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

use crate::{cargo, for_once, root, target_folder};

/// The spec that the built command is asked about: with sensors, a goal and tolerances.
const QUESTION: &str = "examples/sea-ankle.toml";

/// Packs, builds and asks; whether all succeed.
pub fn steps() -> anyhow::Result<bool> {
    let crates = published()?;
    let mut pack = cargo(&["package", "--no-verify", "--allow-dirty", "--quiet"]);
    pack.args(crates.iter().flat_map(|(name, _)| ["--package", name.as_str()]));
    if !pack.status()?.success() {
        return Ok(false);
    }
    let place = tempfile::tempdir()?;
    unpack(&crates, place.path())?;
    let built = target_folder().join("packed");
    let mut build = lean(&["build", "--quiet", "--package", "coilsense-cli"]);
    build.current_dir(place.path()).env("CARGO_TARGET_DIR", &built);
    if !build.status()?.success() {
        return Ok(false);
    }
    // The golden tables travel with the crate. A test knows its folder from when it was compiled, so nothing of an earlier run's is taken.
    let mut clean = lean(&["clean", "--quiet", "--package", "coilsense"]);
    clean.current_dir(place.path()).env("CARGO_TARGET_DIR", &built);
    let mut test = lean(&["test", "--quiet", "--package", "coilsense", "--test", "golden", "--test", "trend"]);
    test.current_dir(place.path()).env("CARGO_TARGET_DIR", &built);
    Ok(ask(&built.join("debug/coilsense"), place.path())? && clean.status()?.success() && test.status()?.success())
}

/// Cargo for a build that is run once.
fn lean(arguments: &[&str]) -> Command {
    let mut command = cargo(arguments);
    for_once(&mut command);
    command
}

/// Names and versions of the crates that are published: all but the chores and the doors that other tools pack.
fn published() -> anyhow::Result<Vec<(String, String)>> {
    let output = cargo(&["metadata", "--no-deps", "--format-version", "1"]).output()?;
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).context("cargo metadata")?;
    let packages = metadata["packages"].as_array().context("cargo metadata names no packages")?;
    let is_published = |package: &&serde_json::Value| package["publish"].is_null();
    let text = |package: &serde_json::Value, key: &str| package[key].as_str().unwrap_or_default().to_owned();
    Ok(packages.iter().filter(is_published).map(|package| (text(package, "name"), text(package, "version"))).collect())
}

/// Unpacks the crates beside each other; those that are not on a registry yet are taken from there.
fn unpack(crates: &[(String, String)], place: &Path) -> anyhow::Result<()> {
    let mut workspace = "[workspace]\nresolver = \"3\"\nmembers = [\"*-[0-9]*\"]\n\n[patch.crates-io]\n".to_owned();
    for (name, version) in crates {
        let file = target_folder().join(format!("package/{name}-{version}.crate"));
        let size = file.metadata().with_context(|| format!("{} is not there", file.display()))?.len();
        println!("{name} {version}: {:.0} kB", 1e-3 * size as f64);
        // With the date of today: packed files all have one old date, by which an earlier run's build of other files would be taken for theirs.
        let unpacked = Command::new("tar").arg("xzmf").arg(&file).arg("-C").arg(place).status();
        if !unpacked.context("tar cannot be started")?.success() {
            bail!("{} cannot be unpacked", file.display());
        }
        let _ = writeln!(workspace, "{name} = {{ path = \"{name}-{version}\" }}");
        // Each carries a lock of its own; that of the project counts, so that what was tested is what is built.
        let _ = std::fs::remove_file(place.join(format!("{name}-{version}/Cargo.lock")));
    }
    std::fs::write(place.join("Cargo.toml"), workspace)?;
    std::fs::copy(root().join("Cargo.lock"), place.join("Cargo.lock"))?;
    Ok(())
}

/// The main job, in the folder of the unpacked crates: a spec from the template, its analysis, the paper's tables.
fn ask(command: &Path, place: &Path) -> anyhow::Result<bool> {
    std::fs::copy(root().join(QUESTION), place.join("spec.toml"))?;
    for arguments in [
        ["init", "--from", "S_A", "--out", "template.toml"].as_slice(),
        &["analyze", "spec.toml", "--out", "out"],
        &["spring", "template.toml"],
    ] {
        let output = Command::new(command).args(arguments).current_dir(place).output()?;
        if !output.status.success() {
            eprintln!("coilsense {}: {}", arguments.join(" "), String::from_utf8_lossy(&output.stderr));
            return Ok(false);
        }
    }
    // A plain build says of a format that it leaves out how to have it.
    std::fs::write(place.join("run.mf4"), b"MDF     4.10    test    ")?;
    let refused = Command::new(command).args(["identify", "run.mf4"]).current_dir(place).output()?;
    let said = String::from_utf8_lossy(&refused.stderr);
    if refused.status.success() || !said.contains("--features formats") {
        eprintln!("coilsense identify run.mf4: {said}");
        return Ok(false);
    }
    let report = place.join("out/report.html");
    println!("coilsense analyze: {:.0} kB of report", 1e-3 * report.metadata()?.len() as f64);
    Ok(true)
}
