//! A placement in the terminal: the answer, then a table of forces and dampings.
//!
//! Next door: the same as a page (`html`) and for machines (`json`).

use std::fmt::Write;

use anstyle::Style;

use super::{bounded, robust};
use crate::placement::{Assessment, MOST_PEAK, Placement, answered};
use crate::quantity::digits;

const BOLD: Style = Style::new().bold();

/// The answer in the first lines, then each force at each damping.
pub fn placement_text(placement: &Placement) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let [first, rest] = answered(placement);
    for (index, line) in first.into_iter().enumerate() {
        let _ = if index == 0 { writeln!(text, "{BOLD}{line}{BOLD:#}") } else { writeln!(text, "{line}") };
    }
    let _ = writeln!(text, "\n{}", rest.join("\n"));
    let _ = writeln!(
        text,
        "\n{BOLD}{:5}  {:12}  {:>14}  {:>14}  {:>12}  {:>8}  {:>9}  {:>15}  {:>15}  {:>15}{BOLD:#}",
        "fed",
        "damping",
        "stable to [Hz]",
        "sens. 2 [Hz]",
        "rings at [Hz]",
        "as set",
        "phase [°]",
        "ends quiet [Hz]",
        "peak of F_i [1]",
        "peak of F_o [1]"
    );
    for candidate in &placement.candidates {
        for (judged, damping) in candidate.judged.iter().zip(&placement.dampings) {
            let margins = &judged.margins;
            let _ = writeln!(
                text,
                "{:5}  {:12}  {:>14}  {:>14}  {:>13}  {:>8}  {:>9}  {:>15}  {:>15}  {:>15}",
                candidate.channel.name(),
                damping.label,
                bounded(judged.stable_crossover, digits),
                robust([judged.robust_from, judged.robust_crossover], digits),
                if judged.oscillates_at > 0.0 { digits(judged.oscillates_at) } else { "–".to_owned() },
                if margins.stable { "stable" } else { "unstable" },
                if margins.stable && margins.phase.is_finite() {
                    format!("{:.0}", margins.phase.to_degrees())
                } else {
                    "–".to_owned()
                },
                if candidate.calm_crossover > 0.0 { digits(candidate.calm_crossover) } else { "–".to_owned() },
                peak(judged, 0),
                peak(judged, 1),
            );
        }
    }
    let unit = placement.control.drive.command_unit();
    let _ = writeln!(
        text,
        "Each figure is the worst case over all springs of the answer. stable to, sens. 2, ends quiet: the largest crossover, that of the loop with a spring without mass, up to which the loop is stable, \
         its sensitivity |1/(1 + L)| at most 2, and both ends' forces at every damping within {:.0} times their static response; of two numbers, from \
         the one to the other. rings at: where \
         the loop oscillates at the limit of stability, in samples as it is seen there, folded to below half their rate. phase: the phase margin; peak: largest force over the reference, both at the \
         crossover as set, {} Hz (a proportional gain of {} {unit} per N).",
        MOST_PEAK,
        digits(placement.crossover),
        significant(placement.gain),
    );
    text
}

/// How large the force of an end becomes; a dash where the loop is unstable.
fn peak(judged: &Assessment, end: usize) -> String {
    judged.peaks.map_or_else(|| "–".to_owned(), |peaks| digits(peaks[end].size))
}

/// Four significant digits, also of a small number.
pub(super) fn significant(value: f64) -> String {
    format!("{value:.3e}")
}
