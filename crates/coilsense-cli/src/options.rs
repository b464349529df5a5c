//! Options that come from a verb's table: as arguments of the command, and back as values.
//!
//! Next door: the table of a verb (`coilsense_lab::request`), the command itself (`mitigate`).

use clap::builder::{StyledStr, ValueParser};
use clap::{Arg, ArgMatches, Command};
use coilsense_lab::request::{IfAbsent, Row};

/// The command with an argument for each row.
pub fn added(command: Command, rows: &'static [Row]) -> Command {
    rows.iter().fold(command, |command, row| command.arg(argument(row)))
}

fn argument(row: &'static Row) -> Arg {
    let read = move |text: &str| row.read(text);
    let argument = Arg::new(row.name)
        .long(row.flag())
        .value_name(row.value_name())
        .value_parser(ValueParser::new(read))
        .allow_hyphen_values(true)
        .help(StyledStr::from(row.help()));
    match row.if_absent {
        IfAbsent::Value(text) => argument.default_value(text),
        IfAbsent::Found(_) => argument,
    }
}

/// What was given for each row, in SI units.
pub fn values<const N: usize>(rows: &'static [Row; N], matches: &ArgMatches) -> [Option<f64>; N] {
    rows.each_ref().map(|row| matches.get_one::<f64>(row.name).copied())
}
