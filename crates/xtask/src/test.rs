//! `cargo xtask test`: every check, one after the other, and a table of how each went.

use std::time::Instant;

use anyhow::{Context, bail};

use crate::cargo;

/// How a part went.
enum Outcome {
    Passed,
    Failed,
    /// It could not run, and why.
    Missing(String),
}

/// A part of the checks.
struct Part {
    name: &'static str,
    run: fn() -> anyhow::Result<Outcome>,
}

const PARTS: [Part; 6] = [
    Part { name: "fmt", run: format },
    Part { name: "clippy", run: clippy },
    Part { name: "tests", run: tests },
    Part { name: "vector paths", run: vector_paths },
    Part { name: "docs", run: docs },
    Part { name: "reproduce", run: reproduce },
];

/// Runs every part, also after one has failed.
pub fn run() -> anyhow::Result<()> {
    let strict = std::env::var("CI").is_ok_and(|value| value == "true");
    let mut lines = Vec::new();
    let mut broken = Vec::new();
    for part in PARTS {
        println!("== {}", part.name);
        let begun = Instant::now();
        let outcome = (part.run)().with_context(|| format!("part {}", part.name))?;
        let seconds = begun.elapsed().as_secs_f64();
        let verdict = match outcome {
            Outcome::Passed => "passed".to_owned(),
            Outcome::Failed => {
                broken.push(part.name);
                "FAILED".to_owned()
            }
            Outcome::Missing(reason) => {
                if strict {
                    broken.push(part.name);
                }
                format!("SKIPPED: {reason}")
            }
        };
        lines.push(format!("{:12} {seconds:7.1} s  {verdict}", part.name));
    }
    println!("\n{}", lines.join("\n"));
    if !broken.is_empty() {
        bail!("failed: {}", broken.join(", "));
    }
    Ok(())
}

/// Runs a command; its own output tells what is wrong.
fn outcome(mut command: std::process::Command) -> anyhow::Result<Outcome> {
    let status = command.status().with_context(|| format!("cannot start {command:?}"))?;
    Ok(if status.success() { Outcome::Passed } else { Outcome::Failed })
}

/// Whether a cargo component answers.
fn has_component(name: &str) -> bool {
    cargo(&[name, "--version"]).output().is_ok_and(|output| output.status.success())
}

fn format() -> anyhow::Result<Outcome> {
    if !has_component("fmt") {
        return Ok(Outcome::Missing("no rustfmt; install it with: rustup component add rustfmt".to_owned()));
    }
    outcome(cargo(&["fmt", "--all", "--", "--check"]))
}

fn clippy() -> anyhow::Result<Outcome> {
    if !has_component("clippy") {
        return Ok(Outcome::Missing("no clippy; install it with: rustup component add clippy".to_owned()));
    }
    outcome(cargo(&["clippy", "--workspace", "--all-targets", "--all-features", "--", "-D", "warnings"]))
}

/// Unit, integration and property tests, the examples' build, and every code block of documentation and README.
fn tests() -> anyhow::Result<Outcome> {
    outcome(cargo(&["test", "--workspace", "--all-features"]))
}

/// The science once more for each path of vector instructions; `tests` has run it on the widest. A path that this processor lacks is
/// refused by name, and so skipped.
fn vector_paths() -> anyhow::Result<Outcome> {
    for path in ["scalar", "avx2"] {
        let mut command = cargo(&["test", "--quiet", "--package", "coilsense", "--lib", "--tests"]);
        command.env("COILSENSE_SIMD", path);
        if path != "scalar" && !supports(path) {
            println!("{path}: not on this processor");
            continue;
        }
        println!("{path}");
        if !command.status()?.success() {
            return Ok(Outcome::Failed);
        }
    }
    Ok(Outcome::Passed)
}

#[cfg(target_arch = "x86_64")]
fn supports(path: &str) -> bool {
    path == "avx2" && is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

#[cfg(not(target_arch = "x86_64"))]
fn supports(_: &str) -> bool {
    false
}

fn docs() -> anyhow::Result<Outcome> {
    let mut command = cargo(&["doc", "--workspace", "--all-features", "--no-deps", "--document-private-items"]);
    command.env("RUSTDOCFLAGS", "-D warnings");
    outcome(command)
}

/// The README's first command, as a new user types it but for the folder.
fn reproduce() -> anyhow::Result<Outcome> {
    let place = tempfile::tempdir()?;
    let out = place.path().join("paper");
    let mut command = cargo(&["run", "--release", "--", "reproduce", "--out"]);
    command.arg(&out);
    match outcome(command)? {
        Outcome::Passed if out.join("report.html").is_file() => Ok(Outcome::Passed),
        _ => Ok(Outcome::Failed),
    }
}
