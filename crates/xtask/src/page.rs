//! The page (`web/`): its engine built from source for the browser, its JavaScript, and its tests in the system's Chromium and Firefox.
//!
//! Next door: the other checks (`test`), what compiles the engine (`toolchain`), the browsers (`browser`), the command that the page
//! is held against (`commands`).

use std::process::{Command, Stdio};

use anyhow::{Context, bail};

use crate::browser::{Browser, CHROMIUM, FIREFOX};
use crate::toolchain::{Build, Target};
use crate::{built, cargo, commands, notices, root, target_folder, typed};

/// A browser; every one of the last years works on two numbers at a time.
const TARGET: Target = Target {
    name: "wasm32-unknown-unknown",
    libraries: "std,panic_abort",
    linker: ["wasm-ld-22", "wasm-ld"],
    flags: &["-Ctarget-feature=+simd128"],
};
/// The browsers that the page is tested in.
const BROWSERS: [Browser; 2] = [CHROMIUM, FIREFOX];
/// What installs Node on Debian.
const INSTALL_NODE: &str = "apt-get install --yes --no-install-recommends nodejs npm";
/// The oldest Node that the page's tools run on.
const OLDEST_NODE: u32 = 20;

/// What is missing to build the page and how to get it, after installing what may be installed.
pub fn missing(may_install: bool) -> Option<String> {
    TARGET.missing(may_install).or_else(|| missing_node(may_install))
}

/// What is missing of that to run the page's tools.
pub fn missing_node(may_install: bool) -> Option<String> {
    if !(has_node() || may_install && typed("apt-get update") && typed(INSTALL_NODE) && has_node()) {
        return Some(format!(
            "no Node of version {OLDEST_NODE} or later with npm; install it from https://nodejs.org or with: {INSTALL_NODE}"
        ));
    }
    None
}

/// The same to test it.
pub fn missing_for_tests(may_install: bool) -> Option<String> {
    missing(may_install).or_else(|| BROWSERS.iter().find_map(|browser| browser.missing(may_install)))
}

/// Builds `web/dist` from source; whether that succeeds.
pub fn build() -> anyhow::Result<bool> {
    Ok(engine("engine", &[])?
        && engine("workshop", &["--features", "workshop"])?
        && tools()?
        && notices::of_page().map(|()| true)?
        && npm(&["run", "types"])?
        && npm(&["run", "build"])?)
}

/// Installs the packages that the page is built with, where they are not there as they are wanted.
pub fn tools() -> anyhow::Result<bool> {
    let wanted = !root().join("web/node_modules/.package-lock.json").is_file() || is_older();
    Ok(!wanted || npm(&["ci"])?)
}

/// Builds the page and tries it out, every preset, size and scheme where it may take long; whether all of it is as it should be.
pub fn check(long: bool) -> anyhow::Result<bool> {
    if !build()? || !npm(&["run", "formatted"])? {
        return Ok(false);
    }
    // The command is built once more, for it carries the page that is there only now; all that it is built of stays.
    if !cargo(&built::EVERY_TEST).args(["--test", "app"]).status()?.success() {
        return Ok(false);
    }
    let command = commands::as_tested()?;
    let mut tests = in_web("npm", &["test"]);
    tests.env("COILSENSE_COMMAND", command);
    if long {
        tests.env("COILSENSE_LONG", "1");
    }
    for browser in BROWSERS {
        let Some(found) = browser.find() else { bail!("no {}", browser.name) };
        tests.env(browser.variable, found);
    }
    Ok(tests.status().context("cannot start npm")?.success())
}

/// An engine as wasm, and the JavaScript beside it, in `web/src/<name>`.
fn engine(name: &str, features: &[&str]) -> anyhow::Result<bool> {
    let Build { command: mut compile, made } = TARGET.build("web")?;
    compile.args(["--package", "coilsense-web", "--profile", "web"]).args(features);
    if !compile.status()?.success() {
        return Ok(false);
    }
    let wasm = made.join("web/coilsense_web.wasm");
    let mut bind = cargo(&["run", "--quiet", "--locked", "--target-dir"]);
    bind.arg(target_folder().join("bindgen")).arg("--").arg(wasm).arg(root().join("web/src").join(name));
    Ok(bind.current_dir(root().join("crates/coilsense-web/bindgen")).status()?.success())
}

/// Whether the installed packages are older than the list of those wanted.
fn is_older() -> bool {
    let changed = |name: &str| std::fs::metadata(root().join("web").join(name)).and_then(|file| file.modified()).ok();
    changed("node_modules/.package-lock.json") < changed("package-lock.json")
}

pub fn npm(arguments: &[&str]) -> anyhow::Result<bool> {
    Ok(in_web("npm", arguments).status().context("cannot start npm")?.success())
}

/// A program in the page's folder. No browser is downloaded: the system's own is used.
fn in_web(program: &str, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root().join("web")).stdin(Stdio::null());
    command.env("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1");
    command
}

fn has_node() -> bool {
    let version = Command::new("node").arg("--version").output().map(|output| output.stdout).unwrap_or_default();
    let text = String::from_utf8_lossy(&version);
    let major = text.trim().trim_start_matches('v').split('.').next().and_then(|major| major.parse::<u32>().ok());
    let npm = Command::new("npm").arg("--version").output().is_ok_and(|output| output.status.success());
    npm && major.is_some_and(|major| major >= OLDEST_NODE)
}
