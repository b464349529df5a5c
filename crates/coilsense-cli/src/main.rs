//! The `coilsense` command: parses, calls `coilsense-lab`, shows. No formula lives here.

// What a user can send must not end in a panic.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod analyze;
mod app;
mod calibrate;
mod date;
mod experiment;
mod identify;
mod import;
mod init;
mod log;
mod mitigate;
mod options;
mod pareto;
mod placement;
mod progress;
mod repairs;
mod reproduce;
mod rig;
mod sensitivity;
mod simulate;
mod spring;
mod sweep;

use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{Parser, Subcommand};
use coilsense_lab::analysis::AnalysisError;

/// How far can one trust a force measured through a coil spring?
#[derive(Parser)]
#[command(name = "coilsense", version, about, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write a commented spec to start from
    Init(init::Arguments),
    /// The data sheet of a spec's spring: rate, mass, stress, lengths, surge frequencies and their neighbours
    Spring(spring::Arguments),
    /// Simulate a spec's conditions and write all signals and readings
    Simulate(simulate::Arguments),
    /// How far off is each force signal, why, and what to choose: simulate, judge, report
    Analyze(analyze::Arguments),
    /// From inductance to length and force: fit a measured log, say how far to trust it, and set the theories beside it
    Calibrate(calibrate::Arguments),
    /// Is it the spring that rings, how stiff, heavy and damped is it, and up to where can its forces be trusted: ask a measured log
    Identify(identify::Arguments),
    /// Read a log, clean it up as allowed, write it in SI units on one rising clock, and account for every row
    Import(import::Arguments),
    /// The paper's experiment on a virtual rig: write the files that a real one would, with every instrument's errors
    Rig(rig::Arguments),
    /// What to do about ringing: every filter and observer on the spec's conditions, ranked, and settings to paste
    Mitigate(mitigate::Arguments),
    /// Which force to feed back, and how fast the loop may then be: limits, margins, rendered impedance
    Placement(placement::Arguments),
    /// Which of a million springs and sensors: vary a spec's values, judge every design, write rows as Parquet; a killed run is continued
    Sweep(sweep::Arguments),
    /// What the columns of a sweep hang on: first-order and total sensitivity indices of its variables
    Sensitivity(sensitivity::Arguments),
    /// Which designs of a sweep are worth a look: those that no other beats
    Pareto(pareto::Arguments),
    /// Work off an experiment: how load cell, position and inductance part, what is biased, what drifts
    Experiment(experiment::Arguments),
    /// The page: hit a spring in the browser and see its two ends disagree; needs a command built with the feature app
    App(app::Arguments),
    /// Reproduce the tables and figures of "Influence of Internal Oscillations on Force Sensing in Coil Springs"
    Reproduce(reproduce::Arguments),
}

/// Exit code of bad input and of output that cannot be written, as clap's own for bad arguments.
const BAD_INPUT: u8 = 2;
/// Exit code after Ctrl-C, as shells have it.
const INTERRUPTED: u8 = 130;

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if error.kind() == ErrorKind::ValueValidation => {
            // What is wrong with a value is said in a line, as of a value in a file; the rest of clap's text points to the help.
            anstream::eprintln!("{}", error.render().ansi().to_string().lines().next().unwrap_or_default());
            return ExitCode::from(BAD_INPUT);
        }
        Err(error) => error.exit(),
    };
    // A wrong COILSENSE_SIMD is bad input like any other.
    let simd = coilsense::simd::SimdPath::selected().map_err(anyhow::Error::from);
    let result = simd.and_then(|_| match arguments.command {
        Command::Init(arguments) => init::run(&arguments),
        Command::Spring(arguments) => spring::run(&arguments),
        Command::Simulate(arguments) => simulate::run(&arguments),
        Command::Analyze(arguments) => analyze::run(&arguments),
        Command::Calibrate(arguments) => calibrate::run(&arguments),
        Command::Identify(arguments) => identify::run(&arguments),
        Command::Import(arguments) => import::run(&arguments),
        Command::Rig(arguments) => rig::run(&arguments),
        Command::Mitigate(arguments) => mitigate::run(&arguments),
        Command::Placement(arguments) => placement::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Sensitivity(arguments) => sensitivity::run(&arguments),
        Command::Pareto(arguments) => pareto::run(&arguments),
        Command::Experiment(arguments) => experiment::run(&arguments),
        Command::App(arguments) => app::run(&arguments),
        Command::Reproduce(arguments) => reproduce::run(&arguments),
    });
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            anstream::eprintln!("error: {error:#}");
            let interrupted =
                matches!(error.downcast_ref(), Some(AnalysisError::Interrupted)) || error.is::<sweep::Interrupted>();
            ExitCode::from(if interrupted { INTERRUPTED } else { BAD_INPUT })
        }
    }
}
