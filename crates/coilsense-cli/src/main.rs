//! The `coilsense` command: parses, calls `coilsense-lab`, shows. No formula lives here.

// What a user can send must not end in a panic.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod reproduce;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// How far can one trust a force measured through a coil spring?
#[derive(Parser)]
#[command(name = "coilsense", version, about, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Reproduce the tables and figures of "Influence of Internal Oscillations on Force Sensing in Coil Springs"
    Reproduce(reproduce::Arguments),
}

/// Exit code of bad input and of output that cannot be written, as clap's own for bad arguments.
const BAD_INPUT: u8 = 2;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    // A wrong COILSENSE_SIMD is bad input like any other.
    let simd = coilsense::simd::SimdPath::selected().map_err(anyhow::Error::from);
    let result = simd.and_then(|_| match arguments.command {
        Command::Reproduce(arguments) => reproduce::run(&arguments),
    });
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            anstream::eprintln!("error: {error:#}");
            ExitCode::from(BAD_INPUT)
        }
    }
}
