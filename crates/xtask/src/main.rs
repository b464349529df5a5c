//! coilsense's own chores. `cargo xtask test` is the one door to all checks; `cargo xtask bench` measures.

mod bench;
mod book;
mod browser;
mod built;
mod commands;
mod first;
#[cfg(test)]
mod floors;
mod from_python;
mod fuzz;
mod goals;
#[cfg(test)]
mod links;
mod logs;
mod notices;
mod package;
mod packed;
mod page;
mod python;
mod reports;
mod robot;
mod stubs;
mod sweep;
mod tables;
mod test;
mod toolchain;
mod viewer;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(name = "cargo xtask", about = "coilsense's own chores", arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    chore: Chore,
}

#[derive(Subcommand)]
enum Chore {
    /// Run every check; with CI=true a part that cannot run is a failure
    Test(test::Arguments),
    /// Measure coilsense and its peers on the same jobs, print a table, write target/bench.json
    Bench(bench::Arguments),
    /// Send random bytes to what reads specs and logs, guided by what they reach; needs a nightly compiler
    Fuzz(fuzz::Arguments),
    /// Build the page into web/dist, for any static host
    Page,
    /// Write web/public/notices.txt: the licences of all that the page is made of
    Notices,
    /// Write the interactive part of reports, from the page's modules
    Viewer,
    /// Write the types of the Python module, from what PyO3 tells of it
    Stubs,
    /// Write the tables of README and book that are made of measurements
    Tables,
}

fn main() -> ExitCode {
    let result = match Arguments::parse().chore {
        Chore::Test(arguments) => test::run(&arguments),
        Chore::Bench(arguments) => bench::run(&arguments),
        Chore::Fuzz(arguments) => fuzz::run(&arguments),
        Chore::Page => page_chore(),
        Chore::Notices => page::tools().and_then(|_| notices::of_page()),
        Chore::Viewer => viewer::write(),
        Chore::Stubs => stubs::write(),
        Chore::Tables => tables::write(),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Builds the page, or says what that needs.
fn page_chore() -> anyhow::Result<()> {
    if let Some(missing) = page::missing(false) {
        anyhow::bail!(missing);
    }
    anyhow::ensure!(page::build()?, "the page was not built");
    println!("web/dist: put it on any static host, or look at it with: npm --prefix web run preview");
    Ok(())
}

/// The project's root folder.
fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// A cargo command in the project's root.
fn cargo(arguments: &[&str]) -> std::process::Command {
    let mut command = std::process::Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    as_cargo(&mut command);
    command
}

/// Has a program that calls cargo build what cargo itself would build here.
fn as_cargo(command: &mut std::process::Command) {
    if strict() {
        for_once(command);
    }
}

/// Has cargo build what nobody builds a second time nor looks at with a debugger: what is kept for that is gigabytes and minutes.
fn for_once(command: &mut std::process::Command) {
    command.env("CARGO_INCREMENTAL", "0").env("CARGO_PROFILE_DEV_DEBUG", "0").env("CARGO_PROFILE_TEST_DEBUG", "0");
}

/// With CI=true a part that cannot run is a failure.
fn strict() -> bool {
    std::env::var("CI").is_ok_and(|value| value == "true")
}

/// The folder that cargo builds into.
fn target_folder() -> PathBuf {
    root().join(std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}

/// Whether both succeed, run at the same time.
fn side_by_side(
    one: impl FnOnce() -> anyhow::Result<bool> + Send,
    other: impl FnOnce() -> anyhow::Result<bool>,
) -> anyhow::Result<bool> {
    std::thread::scope(|scope| {
        let one = scope.spawn(one);
        let other = other();
        let one = one.join().unwrap_or_else(|_| anyhow::bail!("a check was not run to its end"));
        Ok(one? && other?)
    })
}

/// Prints a line and types it, without a question being answered; whether it succeeds.
fn typed(line: &str) -> bool {
    println!("{line}");
    let mut words = line.split(' ');
    let mut command = std::process::Command::new(words.next().unwrap_or_default());
    command.args(words).current_dir(root()).stdin(std::process::Stdio::null());
    command.status().is_ok_and(|status| status.success())
}
