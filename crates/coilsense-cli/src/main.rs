//! The `coilsense` command: parses, calls `coilsense-lab`, shows. No formula lives here.

// What a user can send must not end in a panic.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod analyze;
mod app;
mod calibrate;
mod date;
mod examples;
mod experiment;
mod export;
mod files;
mod identify;
mod import;
mod init;
#[cfg(not(feature = "files"))]
mod left_out;
mod log;
mod mitigate;
mod options;
#[cfg(feature = "files")]
mod pareto;
mod placement;
mod progress;
mod record;
mod reproduce;
mod rig;
#[cfg(feature = "files")]
mod sensitivity;
mod shell;
mod signals;
mod simulate;
mod speed;
mod spring;
#[cfg(feature = "files")]
mod sweep;
mod terminal;
mod unmet;

use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{ArgMatches, Command};
use coilsense_lab::report::verbs::VERBS;
use coilsense_lab::request::{Given, Verb};
#[cfg(not(feature = "files"))]
use left_out::{self as pareto, self as sensitivity, self as sweep};
use unmet::Unmet;

/// What runs a verb.
type Run = fn(&Given) -> anyhow::Result<()>;

/// Who runs which verb.
const RUNS: [(&str, Run); VERBS.len()] = [
    ("init", init::run),
    ("spring", spring::run),
    ("simulate", simulate::run),
    ("analyze", analyze::run),
    ("calibrate", calibrate::run),
    ("identify", identify::run),
    ("import", import::run),
    ("rig", rig::run),
    ("mitigate", mitigate::run),
    ("export", export::run),
    ("placement", placement::run),
    ("speed", speed::run),
    ("sweep", sweep::run),
    ("sensitivity", sensitivity::run),
    ("pareto", pareto::run),
    ("experiment", experiment::run),
    ("record", record::run),
    ("app", app::run),
    ("reproduce", reproduce::run),
];

/// The command with a subcommand for each verb.
fn command() -> Command {
    let command = Command::new("coilsense")
        .version(env!("CARGO_PKG_VERSION"))
        .about(env!("CARGO_PKG_DESCRIPTION"))
        .subcommand_required(true)
        .arg_required_else_help(true)
        .propagate_version(true)
        .arg(options::quiet());
    let command = VERBS.iter().fold(command, |command, verb| command.subcommand(options::command(verb)));
    command.subcommands(shell::commands())
}

/// The verb of a name, and who runs it.
fn verb(name: &str) -> Option<(&'static Verb, Run)> {
    let run = RUNS.into_iter().find(|(known, _)| *known == name)?.1;
    VERBS.iter().find(|verb| verb.name == name).map(|verb| (verb, run))
}

/// Exit code of bad input and of output that cannot be written, as clap's own for bad arguments.
const BAD_INPUT: u8 = 2;

/// Exit code of `--check` where the answer is no, or open.
const UNMET: u8 = 3;

/// Help and version, and arguments that cannot be.
fn said_by_clap(error: &clap::Error) -> ExitCode {
    match terminal::of_clap(error) {
        Ok(()) => ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(BAD_INPUT)),
        Err(unsaid) => {
            terminal::refuse(unsaid);
            ExitCode::from(BAD_INPUT)
        }
    }
}

/// Runs a subcommand with what was said of it.
fn run(name: &str, said: &ArgMatches) -> anyhow::Result<()> {
    let Some((verb, run)) = verb(name) else { return shell::run(name, said) };
    let given = options::given(verb, said);
    files::remember(verb, &given);
    run(&given)
}

fn main() -> ExitCode {
    if let Err(error) = signals::watch() {
        terminal::refuse(format_args!("cannot watch for Ctrl-C: {error}"));
        return ExitCode::from(BAD_INPUT);
    }
    let matches = match command().try_get_matches() {
        Ok(matches) => matches,
        Err(error) if error.kind() == ErrorKind::ValueValidation => {
            // What is wrong with a value is said in a line, as of a value in a file; the rest of clap's text points to the help.
            let text = error.render().ansi().to_string();
            terminal::tell(text.lines().next().unwrap_or_default());
            return ExitCode::from(BAD_INPUT);
        }
        Err(error) => return said_by_clap(&error),
    };
    terminal::set_quiet(matches.get_flag(options::QUIET));
    // A wrong COILSENSE_SIMD is bad input like any other.
    let simd = coilsense::simd::SimdPath::selected().map_err(anyhow::Error::from);
    let result = simd.and_then(|_| matches.subcommand().map_or(Ok(()), |(name, said)| run(name, said)));
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if error.is::<Unmet>() => {
            terminal::tell(&format!("check: {error:#}"));
            ExitCode::from(UNMET)
        }
        Err(error) => {
            signals::last_word();
            terminal::refuse(format_args!("{error:#}"));
            ExitCode::from(signals::code().unwrap_or(BAD_INPUT))
        }
    }
}
