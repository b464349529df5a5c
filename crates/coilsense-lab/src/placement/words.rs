//! Words that every part of a placement's answer takes.
//!
//! Next door: the answer (`answer`), what comes first in it (`head`).

use coilsense::Channel;

use super::Placement;
use crate::quantity::digits;

/// What stands behind a force's name.
pub(super) fn place(channel: Channel) -> &'static str {
    match channel {
        Channel::InputForce => "load cell at the drive's end",
        Channel::OutputForce => "load cell at the far end",
        Channel::DeflectionForce => "deflection",
        Channel::InductanceForce | Channel::Inductance => "inductance",
        other => other.name(),
    }
}

/// What holds between two crossovers \[Hz\]: from the slowest loop on where the first is zero.
pub(super) fn upto(what: &str, from: f64, hertz: f64) -> String {
    match (from, hertz) {
        (_, 0.0) => format!("at no gain {what}"),
        (0.0, hertz) if hertz.is_infinite() => format!("{what} at any gain"),
        (0.0, hertz) => format!("{what} up to a crossover of {} Hz", digits(hertz)),
        (from, hertz) if hertz.is_infinite() => format!("{what} from a crossover of {} Hz on", digits(from)),
        (from, hertz) => format!("{what} from a crossover of {} Hz to {} Hz", digits(from), digits(hertz)),
    }
}

/// Which forces cannot be fed back as the loop is set.
pub(super) fn unstable(placement: &Placement) -> String {
    let names: Vec<&str> =
        placement.candidates.iter().filter(|other| !other.is_stable()).map(|other| other.channel.name()).collect();
    if names.is_empty() { "none of the four".to_owned() } else { names.join(", ") }
}
