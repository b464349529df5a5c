//! `cargo xtask test`: every check, one after the other, and a table of how each went.

use std::time::Instant;

use anyhow::{Context, bail};

use crate::{book, browser, built, cargo, commands, first, fuzz, package, packed, page, robot, strict, viewer};

/// What the checks may do.
#[derive(clap::Args)]
pub struct Arguments {
    /// Install system packages that a part needs; CI=true does, too
    #[arg(long)]
    install: bool,
    /// Run only this part, by its name in the table; may be given several times
    #[arg(long, value_name = "PART")]
    only: Vec<String>,
    /// Run the parts long and fuzz, too: the tests that take minutes, and ten minutes of each fuzzer; and all that the parts fewer formats, vector paths, Python and page leave to it
    #[arg(long)]
    long: bool,
}

impl Arguments {
    /// Whether the part of this name is to run.
    fn want(&self, name: &str) -> bool {
        let is_named = self.only.iter().any(|only| only == name);
        is_named || if ASKED_FOR.contains(&name) { self.long } else { self.only.is_empty() }
    }
}

/// How a part went.
enum Outcome {
    Passed,
    Failed,
    /// It could not run, and why.
    Missing(String),
    /// It needs data that no stranger may have; that is no failure.
    Unlicensed(String),
}

/// A part of the checks.
struct Part {
    name: &'static str,
    run: fn(&Arguments) -> anyhow::Result<Outcome>,
}

const PARTS: [Part; 18] = [
    Part { name: "fmt", run: format },
    Part { name: "clippy", run: clippy },
    Part { name: "tests", run: tests },
    Part { name: "measured runs", run: measured_runs },
    Part { name: "vector paths", run: vector_paths },
    Part { name: "docs", run: docs },
    Part { name: "fewer formats", run: fewer_formats },
    Part { name: "no_std", run: no_std },
    Part { name: "first answer", run: first_answer },
    Part { name: "README", run: readme },
    Part { name: "examples", run: examples },
    Part { name: "book", run: book },
    Part { name: "packed crates", run: packed_crates },
    Part { name: "report page", run: report_page },
    Part { name: "Python", run: python },
    Part { name: "page", run: page },
    Part { name: "long", run: long },
    Part { name: "fuzz", run: fuzzers },
];

/// The parts that only run where they are asked for.
const ASKED_FOR: [&str; 2] = ["long", "fuzz"];
/// What is marked to be ignored and is not run by `long`: a benchmark, and what has a part of its own.
const NOT_LONG: [&str; 2] = ["a_million_points", "measured_runs"];

/// Runs every part, also after one has failed.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let (strict, start) = (strict(), Instant::now());
    let mut lines = Vec::new();
    let mut broken = Vec::new();
    let unknown = arguments.only.iter().find(|name| PARTS.iter().all(|part| part.name != name.as_str()));
    if let Some(name) = unknown {
        bail!("--only {name}: must be one of {}", PARTS.map(|part| part.name).join(", "));
    }
    for part in PARTS.into_iter().filter(|part| arguments.want(part.name)) {
        // A run that is cut off has told how far it was.
        println!("== {}, {:.0} s after the start", part.name, start.elapsed().as_secs_f64());
        let begun = Instant::now();
        let outcome = (part.run)(arguments).with_context(|| format!("part {}", part.name))?;
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
            Outcome::Unlicensed(reason) => format!("SKIPPED: {reason}"),
        };
        lines.push(format!("{:13} {seconds:7.1} s  {verdict}", part.name));
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

fn format(_: &Arguments) -> anyhow::Result<Outcome> {
    if !has_component("fmt") {
        return Ok(Outcome::Missing("no rustfmt; install it with: rustup component add rustfmt".to_owned()));
    }
    outcome(cargo(&["fmt", "--all", "--", "--check"]))
}

fn clippy(_: &Arguments) -> anyhow::Result<Outcome> {
    if !has_component("clippy") {
        return Ok(Outcome::Missing("no clippy; install it with: rustup component add clippy".to_owned()));
    }
    outcome(cargo(&["clippy", "--workspace", "--all-targets", "--all-features", "--", "-D", "warnings"]))
}

/// Unit, integration and property tests, the examples' build, and every Rust block of documentation, README and book. What is drawn at random is
/// the same in every run, so that a change is judged by what it changes; `long` draws anew.
fn tests(_: &Arguments) -> anyhow::Result<Outcome> {
    let mut command = cargo(&built::EVERY_TEST);
    command.arg("--no-fail-fast").env("PROPTEST_RNG_SEED", "1");
    outcome(command)
}

/// Calibrations of measured runs, which carry no licence: where they are, in `COILSENSE_LAB_DATA` or beside the project.
fn measured_runs(_: &Arguments) -> anyhow::Result<Outcome> {
    let named = std::env::var_os("COILSENSE_LAB_DATA").map(std::path::PathBuf::from);
    let folder = named.unwrap_or_else(|| crate::root().join("../shared/lab-data"));
    if !folder.join("S1_01.csv").is_file() {
        return Ok(Outcome::Unlicensed("no measured runs; COILSENSE_LAB_DATA names their folder".to_owned()));
    }
    let folder = std::path::absolute(folder)?;
    let Some(tests) = built::executables()? else { return Ok(Outcome::Failed) };
    for (package, name) in MEASURED {
        let test = tests.iter().find(|test| test.package == package && test.name == name);
        let mut command = test.with_context(|| format!("{package} has no test {name}"))?.command();
        command.args(["--ignored", "measured_runs"]).env("COILSENSE_LAB_DATA", &folder);
        if !command.status()?.success() {
            return Ok(Outcome::Failed);
        }
    }
    Ok(Outcome::Passed)
}

/// The tests that read measured runs, by package.
const MEASURED: [(&str, &str); 2] = [("coilsense", "lab_data"), ("coilsense-cli", "calibrate")];

/// The science once more for each path of vector instructions; `tests` has run it on the widest, and held each path to the others. A path that
/// this processor lacks is refused by name, and so skipped.
fn vector_paths(arguments: &Arguments) -> anyhow::Result<Outcome> {
    let Some(tests) = built::executables()? else { return Ok(Outcome::Failed) };
    let is_asked = |test: &&built::Executable| arguments.long || KERNELS.contains(&test.name.as_str());
    let science: Vec<_> = tests.iter().filter(|test| test.package == "coilsense").filter(is_asked).collect();
    if let Some(lost) = KERNELS.iter().find(|name| science.iter().all(|test| test.name != **name)) {
        bail!("coilsense has no test {lost}");
    }
    for path in ["scalar", "avx2"] {
        if path != "scalar" && !supports(path) {
            println!("{path}: not on this processor");
            continue;
        }
        println!("{path}");
        for test in &science {
            let mut command = test.command();
            command.arg("--quiet").env("COILSENSE_SIMD", path).env("PROPTEST_RNG_SEED", "1");
            println!("{}", test.name);
            if !command.status()?.success() {
                return Ok(Outcome::Failed);
            }
        }
    }
    Ok(Outcome::Passed)
}

/// The tests of what the kernels themselves compute, for every run; the long proof repeats all of the science.
const KERNELS: [&str; 7] = ["golden", "inductance", "inductance_series", "live", "modal_model", "permeable", "sensors"];

#[cfg(target_arch = "x86_64")]
fn supports(path: &str) -> bool {
    path == "avx2" && is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

#[cfg(not(target_arch = "x86_64"))]
fn supports(_: &str) -> bool {
    false
}

fn docs(_: &Arguments) -> anyhow::Result<Outcome> {
    let mut command = cargo(&["doc", "--workspace", "--all-features", "--no-deps", "--document-private-items"]);
    command.env("RUSTDOCFLAGS", "-D warnings");
    outcome(command)
}

/// Files for people without what cannot be built everywhere: no format of recordings but text; in the long proof each of the others alone, too.
fn fewer_formats(arguments: &Arguments) -> anyhow::Result<Outcome> {
    let manifest = std::fs::read_to_string(crate::root().join("crates/coilsense-lab/Cargo.toml"))?;
    let default = manifest.lines().find_map(|line| line.strip_prefix("default = ["));
    let default = default.ok_or_else(|| anyhow::anyhow!("coilsense-lab has no default features"))?;
    let formats = default.split('"').skip(1).step_by(2).filter(|feature| *feature != "reference");
    let alone = formats.filter(|_| arguments.long);
    for features in std::iter::once("").chain(alone) {
        println!("features: {}", if features.is_empty() { "none" } else { features });
        let mut command = cargo(&["check", "--quiet", "--package", "coilsense-lab", "--no-default-features"]);
        command.args(["--features", features]);
        if !command.status()?.success() {
            return Ok(Outcome::Failed);
        }
    }
    Ok(Outcome::Passed)
}

/// What runs on a robot, on a robot's processor; what that needs is installed where that is asked for.
fn no_std(arguments: &Arguments) -> anyhow::Result<Outcome> {
    match robot::missing(strict() || arguments.install) {
        Some(missing) => Ok(Outcome::Missing(missing)),
        None => passed(robot::steps()?),
    }
}

/// What a newcomer builds first.
fn first_answer(_: &Arguments) -> anyhow::Result<Outcome> {
    passed(first::steps()?)
}

fn readme(_: &Arguments) -> anyhow::Result<Outcome> {
    passed(commands::readme()?)
}

fn examples(_: &Arguments) -> anyhow::Result<Outcome> {
    passed(commands::every_example()?)
}

/// The book, built and its links followed.
fn book(_: &Arguments) -> anyhow::Result<Outcome> {
    passed(book::steps()?)
}

/// The crates as they would be published, built in an empty folder.
fn packed_crates(_: &Arguments) -> anyhow::Result<Outcome> {
    passed(packed::steps()?)
}

/// A report in a real browser, which is installed where that is asked for.
fn report_page(arguments: &Arguments) -> anyhow::Result<Outcome> {
    let may_install = strict() || arguments.install;
    if let Some(missing) = browser::CHROMIUM.missing(may_install) {
        return Ok(Outcome::Missing(missing));
    }
    let Some(found) = browser::CHROMIUM.find() else { return Ok(Outcome::Failed) };
    passed(browser::report(&found)?)
}

/// The Python package in an environment of its own; in the long proof compiled as it is released.
fn python(arguments: &Arguments) -> anyhow::Result<Outcome> {
    let built = if arguments.long { package::Built::AsReleased } else { package::Built::AsTested };
    match package::missing() {
        Some(missing) => Ok(Outcome::Missing(missing)),
        None => passed(package::steps(built)?),
    }
}

/// The page for the browser, from its source to its tests, and what of it is in reports; what that needs is installed where that is asked for.
fn page(arguments: &Arguments) -> anyhow::Result<Outcome> {
    match page::missing_for_tests(strict() || arguments.install) {
        Some(missing) => Ok(Outcome::Missing(missing)),
        None => passed(viewer::agrees()? && page::check(arguments.long)?),
    }
}

/// The tests that are ignored because they take minutes, and those of random inputs on inputs that nobody has seen. They are built as
/// a release is, and none needs data that is not here.
fn long(_: &Arguments) -> anyhow::Result<Outcome> {
    let mut random =
        cargo(&["test", "--release", "--package", "coilsense-lab", "--all-features", "--tests", "hostile::"]);
    random.env("PROPTEST_CASES", "20000");
    if !random.status()?.success() {
        return Ok(Outcome::Failed);
    }
    let mut command = cargo(&["test", "--release", "--workspace", "--tests", "--", "--ignored"]);
    command.args(NOT_LONG.iter().flat_map(|name| ["--skip", name]));
    outcome(command)
}

/// Random bytes at whatever reads what strangers may send.
fn fuzzers(_: &Arguments) -> anyhow::Result<Outcome> {
    if let Some(missing) = fuzz::missing() {
        return Ok(Outcome::Missing(missing));
    }
    let all = fuzz::Arguments::all(fuzz::SECONDS);
    passed(fuzz::run(&all).inspect_err(|error| eprintln!("{error:#}")).is_ok())
}

fn passed(success: bool) -> anyhow::Result<Outcome> {
    Ok(if success { Outcome::Passed } else { Outcome::Failed })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_is_in_one_job_of_the_workflow() {
        let file = crate::root().join(".github/workflows/test.yml");
        let workflow = std::fs::read_to_string(&file).expect("the workflow");
        let (each_time, weekly) = workflow.split_once("\n  long:\n").expect("the job long");
        for part in PARTS {
            let asked = [format!("--only {}", part.name), format!("--only \"{}\"", part.name)];
            let job = if ASKED_FOR.contains(&part.name) { weekly } else { each_time };
            let words = job.replace(['\'', '\n', '}'], " ");
            let times = asked.iter().map(|asked| words.matches(&format!("{asked} ")).count()).sum::<usize>();
            assert_eq!(times, 1, "{}", part.name);
        }
        assert!(
            weekly
                .replace('\n', " ")
                .contains("--long --only \"fewer formats\" --only \"vector paths\" --only Python --only page "),
            "what each run leaves to the long proof"
        );
    }
}
