//! Indices in the terminal: what matters in a sentence each, then a table per column.
//!
//! Next door: the same as a page (`html`) and for machines (`json`).

use std::fmt::Write;

use anstyle::Style;

use crate::quantity::{Shown, without_unit};
use crate::sensitivity::{Estimate, Study, answer, ranked};

const BOLD: Style = Style::new().bold();

/// The answer in the first lines, then the indices, sorted.
pub fn sensitivity_text(study: &Study) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    for (index, line) in answer(study).into_iter().enumerate() {
        let _ = if index == 0 { writeln!(text, "{BOLD}{line}{BOLD:#}") } else { writeln!(text, "{line}") };
    }
    let widest = study.variables.iter().map(|key| key.chars().count()).max().unwrap_or(0);
    for column in &study.columns {
        let Ok(found) = &column.found else { continue };
        let shown = Shown::of(&column.title, [found.mean.abs() + found.variance.sqrt()]);
        let _ = writeln!(
            text,
            "\n{BOLD}{}{BOLD:#}: {} ± {} (σ), of {} base rows",
            without_unit(&column.title),
            shown.digits(found.mean),
            shown.with_unit(found.variance.sqrt()),
            found.base_rows,
        );
        let _ = writeln!(text, "  {:widest$}  {:>24}  {:>24}", "", "S_1 alone", "S_T with others");
        for (key, index) in ranked(study, found) {
            let _ = writeln!(text, "  {key:widest$}  {:>24}  {:>24}", cell(&index.first), cell(&index.total));
        }
    }
    let _ = writeln!(
        text,
        "\nIn brackets: {:.0} % intervals, from {} resamples of the base rows",
        100.0 * study.resampling.level,
        study.resampling.resamples
    );
    text
}

/// `0.71 [0.66, 0.77]`.
pub(super) fn cell(estimate: &Estimate) -> String {
    let digits = |value: f64| {
        let text = format!("{value:.3}");
        if text == "-0.000" { "0.000".to_owned() } else { text }
    };
    format!("{} [{}, {}]", digits(estimate.value), digits(estimate.lower), digits(estimate.upper))
}
