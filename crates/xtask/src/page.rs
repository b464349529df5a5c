//! The page (`web/`): its engine built from source for the browser, its JavaScript, and its tests in the system's Chromium.
//!
//! Next door: the other checks (`test`), the browser (`browser`), the command that the page is held against (`commands`).

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, bail};

use crate::{browser, cargo, commands, root};

const TARGET: &str = "wasm32-unknown-unknown";
/// What gets the standard library for it.
const ADD_TARGET: &str = "rustup target add wasm32-unknown-unknown";
/// What installs Node on Debian.
const INSTALL_NODE: &str = "apt-get install --yes --no-install-recommends nodejs npm";
/// The oldest Node that the page's tools run on.
const OLDEST_NODE: u32 = 20;
/// Two numbers at a time, which every browser of the last years has.
const FLAGS: &str = "-C target-feature=+simd128";

/// What is missing to build the page and how to get it, after installing what may be installed.
pub fn missing(may_install: bool) -> Option<String> {
    if !(has_target() || may_install && typed(ADD_TARGET) && has_target()) {
        return Some(format!(
            "no standard library for {TARGET}; install it with: {ADD_TARGET} (a compiler without rustup must bring its own)"
        ));
    }
    if !(has_node() || may_install && typed("apt-get update") && typed(INSTALL_NODE) && has_node()) {
        return Some(format!(
            "no Node of version {OLDEST_NODE} or later with npm; install it from https://nodejs.org or with: {INSTALL_NODE}"
        ));
    }
    None
}

/// The same to test it.
pub fn missing_for_tests(may_install: bool) -> Option<String> {
    missing(may_install).or_else(|| {
        let there = browser::find().is_some() || may_install && browser::install();
        (!there).then(|| format!("no browser; install one with: {}", browser::INSTALL))
    })
}

/// Builds `web/dist` from source; whether that succeeds.
pub fn build() -> anyhow::Result<bool> {
    let tools = !root().join("web/node_modules/.package-lock.json").is_file() || is_older();
    Ok(engine("engine", &[])?
        && engine("workshop", &["--features", "workshop"])?
        && (!tools || npm(&["ci"])?)
        && npm(&["run", "types"])?
        && npm(&["run", "build"])?)
}

/// Builds the page and tries it out; whether all of it is as it should be.
pub fn check() -> anyhow::Result<bool> {
    if !build()? || !npm(&["run", "formatted"])? {
        return Ok(false);
    }
    let served = ["test", "--package", "coilsense-cli", "--features", "app", "--test", "app"];
    if !cargo(&served).status()?.success() {
        return Ok(false);
    }
    let command = commands::executable()?;
    let Some(browser) = browser::find() else { bail!("no browser") };
    let mut tests = in_web("npm", &["test"]);
    tests.env("COILSENSE_COMMAND", command).env("COILSENSE_CHROMIUM", browser);
    Ok(tests.status().context("cannot start npm")?.success())
}

/// An engine as wasm, and the JavaScript beside it, in `web/src/<name>`.
fn engine(name: &str, features: &[&str]) -> anyhow::Result<bool> {
    let folder = target();
    let mut compile = cargo(&["build", "--package", "coilsense-web", "--profile", "web", "--target", TARGET]);
    compile.args(features).arg("--target-dir").arg(folder.join("web")).env("RUSTFLAGS", FLAGS);
    if !compile.status()?.success() {
        return Ok(false);
    }
    let wasm = folder.join("web").join(TARGET).join("web/coilsense_web.wasm");
    let mut bind = cargo(&["run", "--quiet", "--locked"]);
    bind.arg("--target-dir").arg(folder.join("bindgen")).arg("--").arg(wasm).arg(root().join("web/src").join(name));
    Ok(bind.current_dir(root().join("crates/coilsense-web/bindgen")).status()?.success())
}

fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Whether the installed packages are older than the list of those wanted.
fn is_older() -> bool {
    let changed = |name: &str| std::fs::metadata(root().join("web").join(name)).and_then(|file| file.modified()).ok();
    changed("node_modules/.package-lock.json") < changed("package-lock.json")
}

fn npm(arguments: &[&str]) -> anyhow::Result<bool> {
    Ok(in_web("npm", arguments).status().context("cannot start npm")?.success())
}

/// A program in the page's folder. No browser is downloaded: the system's own is used.
fn in_web(program: &str, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root().join("web")).stdin(Stdio::null());
    command.env("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1");
    command
}

fn typed(line: &str) -> bool {
    println!("{line}");
    let mut words = line.split(' ');
    let program = words.next().unwrap_or_default();
    let mut command = Command::new(program);
    command.args(words).current_dir(root()).stdin(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

fn has_target() -> bool {
    let asked =
        Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).current_dir(root()).output();
    asked.is_ok_and(|output| {
        let path = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        output.status.success() && Path::new(&path).read_dir().is_ok_and(|mut files| files.next().is_some())
    })
}

fn has_node() -> bool {
    let version = Command::new("node").arg("--version").output().map(|output| output.stdout).unwrap_or_default();
    let text = String::from_utf8_lossy(&version);
    let major = text.trim().trim_start_matches('v').split('.').next().and_then(|major| major.parse::<u32>().ok());
    let npm = Command::new("npm").arg("--version").output().is_ok_and(|output| output.status.success());
    npm && major.is_some_and(|major| major >= OLDEST_NODE)
}
