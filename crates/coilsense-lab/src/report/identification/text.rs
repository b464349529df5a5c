//! An identification in the terminal: the answer, then every line of the record.
//!
//! Next door: the same as a page (`html`) and for machines (`json`).

use std::fmt::Write;

use anstyle::{AnsiColor, Style};
use coilsense::identify::Answer;

use crate::identification::{Identified, answer, component_name, interval};
use crate::quantity::digits;

const BOLD: Style = Style::new().bold();

/// The answer in the first lines, then a table of lines and what was read.
pub fn identification_text(identified: &Identified) -> String {
    let found = &identified.found;
    let style = match found.verdict.answer {
        Answer::Spring => AnsiColor::Green.on_default().bold(),
        Answer::NotTheSpring => AnsiColor::Red.on_default().bold(),
        Answer::Undecided => AnsiColor::Yellow.on_default().bold(),
    };
    let mut text = String::new();
    // Writing to a String cannot fail.
    for (index, line) in answer(identified).into_iter().enumerate() {
        let _ = if index == 0 { writeln!(text, "{style}{line}{style:#}") } else { writeln!(text, "{line}") };
    }
    if let Err(reason) = &found.stiffness {
        let _ = writeln!(text, "No stiffness: {reason}.");
    }
    if !found.lines.is_empty() {
        let _ = writeln!(
            text,
            "\n{BOLD}{:>24}  {:>24}  {:>11}  {:13}  identified as{BOLD:#}",
            "line [Hz]", "ζ", "peak [N]", "component"
        );
    }
    for line in &found.lines {
        let ratio = line.ratio.filter(|_| line.decays).map_or("–".to_owned(), |ratio| interval(&ratio, 1.0));
        let _ = writeln!(
            text,
            "{:>24}  {ratio:>24}  {:>11}  {:13}  {}",
            interval(&line.frequency, 1.0),
            digits(line.amplitude),
            component_name(line.part),
            line.reason
        );
    }
    let _ = writeln!(
        text,
        "{} samples at {} Hz, {} found; ± is half of a 95 % interval",
        found.sampling.samples,
        digits(found.sampling.rate),
        match found.hits.len() {
            1 => "1 hit".to_owned(),
            hits => format!("{hits} hits"),
        }
    );
    for line in &identified.account {
        let _ = writeln!(text, "{line}");
    }
    text
}
