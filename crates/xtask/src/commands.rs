//! Checks of the whole command: what README and book say to type, and every example.
//!
//! Next door: the other checks (`test`), how long commands take (`bench`).

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use anyhow::{Context, bail};

use crate::{built, cargo, root, side_by_side, target_folder};

/// What an example with a cam is asked.
pub const SPEED: [&str; 7] = ["speed", "--from", "1000rpm", "--to", "8000rpm", "--step", "1000rpm"];
/// How README and book call the command from a checkout.
const PREFIXES: [&str; 2] = ["cargo quick ", "cargo run --release -- "];

/// The release build of the command with all that a release has but the page: for what measures.
pub fn with_every_format() -> anyhow::Result<PathBuf> {
    if !cargo(&["build", "--release", "--package", "coilsense-cli", "--features", "formats"]).status()?.success() {
        bail!("the release build failed");
    }
    Ok(target_folder().join("release/coilsense"))
}

/// The command with all that a release has, as its own tests have built it: for what asks only what it says.
pub fn as_tested() -> anyhow::Result<PathBuf> {
    // With any test of the command cargo builds the command, too.
    if !cargo(&built::EVERY_TEST).args(["--test", "app", "--no-run"]).status()?.success() {
        bail!("the command with every format cannot be built");
    }
    Ok(target_folder().join("debug/coilsense"))
}

/// Every example's spec.
pub fn examples() -> anyhow::Result<Vec<PathBuf>> {
    let files = std::fs::read_dir(root().join("examples")).context("examples cannot be read")?;
    let paths = files.map(|file| Ok(file?.path())).collect::<anyhow::Result<Vec<_>>>()?;
    let mut specs: Vec<PathBuf> =
        paths.into_iter().filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    specs.sort();
    if specs.is_empty() {
        bail!("no example is there");
    }
    Ok(specs)
}

/// Whether a spec is that of a rig, which has no conditions of use.
pub fn is_rig(spec: &Path) -> anyhow::Result<bool> {
    Ok(std::fs::read_to_string(spec)?.lines().any(|line| line == "[rig]"))
}

/// Whether a spec is that of a cam alone, which turns at the speeds of a map and has no conditions of use.
pub fn is_cam(spec: &Path) -> anyhow::Result<bool> {
    let text = std::fs::read_to_string(spec)?;
    let has = |table: &str| text.lines().any(|line| line == table);
    Ok(has("[cam]") && !has("[[condition]]"))
}

/// Whether a spec has several springs, which `simulate` takes and `analyze` does not.
pub fn has_several_springs(spec: &Path) -> anyhow::Result<bool> {
    Ok(std::fs::read_to_string(spec)?.lines().any(|line| line == "[[spring]]"))
}

/// README and every page of the book, README first.
pub fn documents() -> anyhow::Result<Vec<PathBuf>> {
    let mut folders = vec![root().join("book/src")];
    let mut pages = Vec::new();
    while let Some(folder) = folders.pop() {
        for file in std::fs::read_dir(&folder).with_context(|| format!("{} cannot be read", folder.display()))? {
            let path = file?.path();
            match path.is_dir() {
                true => folders.push(path),
                false if path.extension().is_some_and(|e| e == "md") => pages.push(path),
                false => {}
            }
        }
    }
    pages.sort();
    if pages.is_empty() {
        bail!("the book has no page");
    }
    pages.insert(0, root().join("README.md"));
    Ok(pages)
}

/// Types the commands of README and book, two pages at a time, each page's in a folder of its own that has the examples; whether all of them succeed,
/// no report holds numbers as a program writes them, and no page Rust that nothing compiles.
pub fn readme() -> anyhow::Result<bool> {
    let executable = as_tested()?;
    let doctests = std::fs::read_to_string(root().join("crates/coilsense/src/lib.rs"))?;
    let (pages, next, typed) = (documents()?, AtomicUsize::new(0), AtomicUsize::new(0));
    let some_pages = || -> anyhow::Result<bool> {
        while let Some(page) = pages.get(next.fetch_add(1, Ordering::Relaxed)) {
            if !type_page(&executable, page, &doctests, &typed)? {
                return Ok(false);
            }
        }
        Ok(true)
    };
    let all = side_by_side(some_pages, some_pages)?;
    println!("{} commands of README and book", typed.load(Ordering::Relaxed));
    Ok(all && typed.into_inner() > 0)
}

/// What a line of a page asks of the command.
fn after_prefix(line: &str) -> Option<&str> {
    PREFIXES.iter().find_map(|prefix| line.strip_prefix(prefix))
}

/// Types the commands of a page and counts them; whether they succeed.
fn type_page(executable: &Path, page: &Path, doctests: &str, typed: &AtomicUsize) -> anyhow::Result<bool> {
    let name = page.strip_prefix(root()).unwrap_or(page).display().to_string();
    let text = std::fs::read_to_string(page).with_context(|| format!("{name} cannot be read"))?;
    if text.contains("```rust") && !doctests.contains(&name) {
        bail!("{name} holds Rust that no doctest compiles: include it in crates/coilsense/src/lib.rs");
    }
    let place = tempfile::tempdir()?;
    copy_examples(&place.path().join("examples"))?;
    for line in text.lines().filter_map(after_prefix) {
        // As a shell has it: quotes keep brackets from it.
        let words = line.split('#').next().unwrap_or_default().split_whitespace().map(|word| word.trim_matches('\''));
        let output = Command::new(executable).args(words).current_dir(place.path()).output()?;
        let said = [&output.stdout, &output.stderr].map(|said| String::from_utf8_lossy(said));
        // In one piece, beside what another page's commands say.
        println!("{name}: coilsense {}\n{}{}", line.trim_end(), said[0], said[1]);
        if !output.status.success() {
            return Ok(false);
        }
        typed.fetch_add(1, Ordering::Relaxed);
    }
    if !crate::reports::are_set(place.path())? {
        bail!("{name}: a report has numbers as a program writes them");
    }
    Ok(true)
}

/// Runs `spring`, `simulate` and `analyze` on every example, `rig` on those of a rig, `speed` on those of a cam, `placement` where there is a loop; whether all succeed and
/// leave what they should.
pub fn every_example() -> anyhow::Result<bool> {
    let executable = as_tested()?;
    let place = tempfile::tempdir()?;
    for spec in examples()? {
        let name = spec.file_stem().and_then(std::ffi::OsStr::to_str).unwrap_or_default().to_owned();
        println!("== {name}");
        let run = |arguments: &[&str]| -> anyhow::Result<bool> {
            let begun = Instant::now();
            let mut command = Command::new(&executable);
            command.arg(arguments[0]).arg(&spec).args(&arguments[1..]).current_dir(place.path());
            let success = command.status()?.success();
            println!("({} took {:.2} s)", arguments[0], begun.elapsed().as_secs_f64());
            Ok(success)
        };
        if is_rig(&spec)? {
            if !(run(&["spring"])? && run(&["rig", "--out", &name])?) {
                return Ok(false);
            }
            if !place.path().join(&name).join("experiment.toml").is_file() {
                bail!("{name}/experiment.toml is missing");
            }
            continue;
        }
        if is_cam(&spec)? {
            if !(run(&["spring"])? && run(&[&SPEED[..], &["--out", &name]].concat())?) {
                return Ok(false);
            }
            let made = ["report.html", "results.json", "speed.csv", "speed.parquet"]
                .map(|file| place.path().join(&name).join(file));
            if let Some(missing) = made.iter().find(|path| !path.is_file()) {
                bail!("{} is missing", missing.display());
            }
            continue;
        }
        let series = format!("{name}.parquet");
        if !(run(&["spring"])? && run(&["simulate", "--out", &series])?) {
            return Ok(false);
        }
        if has_several_springs(&spec)? {
            continue;
        }
        if !run(&["analyze", "--out", &name])? {
            return Ok(false);
        }
        let has_loop = std::fs::read_to_string(&spec)?.lines().any(|line| line == "[control]");
        if has_loop && !run(&["placement", "--out", &format!("{name}-loop")])? {
            return Ok(false);
        }
        let made = ["report.html", "results.json", "signals.parquet"].map(|file| place.path().join(&name).join(file));
        if let Some(missing) = made.iter().find(|path| !path.is_file()) {
            bail!("{} is missing", missing.display());
        }
    }
    crate::reports::are_set(place.path())
}

/// The examples' specs, copied.
pub fn copy_examples(to: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(to)?;
    for file in std::fs::read_dir(root().join("examples")).context("examples cannot be read")? {
        let path = file?.path();
        if let (true, Some(name)) = (path.is_file(), path.file_name()) {
            std::fs::copy(&path, to.join(name))?;
        }
    }
    Ok(())
}
