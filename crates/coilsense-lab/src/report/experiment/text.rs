//! An experiment in the terminal: the answer, then a row per run.
//!
//! Next door: the same as a page (`html`) and for machines (`json`).

use std::fmt::Write;

use anstyle::Style;
use coilsense::Channel;

use super::html::{cell, exact};
use crate::experiment::{Experiment, FORCES, Findings, answer};

const BOLD: Style = Style::new().bold();

/// The answer in the first lines, then a table of runs.
pub fn experiment_text(experiment: &Experiment, findings: &Findings) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    for (index, line) in answer(experiment, findings).into_iter().enumerate() {
        let _ = if index == 0 { writeln!(text, "{BOLD}{line}{BOLD:#}") } else { writeln!(text, "{line}") };
    }
    let widest = experiment.runs.iter().map(|run| run.spec.name.chars().count()).max().unwrap_or(0).max(3);
    let _ = writeln!(
        text,
        "\n{BOLD}{:widest$}  {:>8}  {:>8}  {:>8}  {:>18}  {:>18}  {:>18}{BOLD:#}",
        "run", "f [Hz]", "RMSD", "max", "mean F_o", "mean F_x", "mean F_L"
    );
    for run in &experiment.runs {
        let mean = |force: Channel| cell(experiment, run, force).unwrap_or_else(|| "–".to_owned());
        let [output, deflection, inductance] = FORCES.map(mean);
        let deviation = &run.fast.deviation;
        let _ = writeln!(
            text,
            "{:widest$}  {:>8}  {:>8}  {:>8}  {output:>18}  {deflection:>18}  {inductance:>18}",
            run.spec.name,
            exact(run.spec.frequency, 3),
            exact(experiment.percent(deviation.rmsd), 3),
            exact(experiment.percent(deviation.maximum_absolute), 3),
        );
    }
    let _ = writeln!(
        text,
        "All in % of F_nom = {} N; RMSD and max of F_o − F_x; means less the first preload's F_x, ± σ/√n",
        experiment.spec.nominal_force
    );
    for line in experiment.account() {
        let _ = writeln!(text, "{line}");
    }
    text
}
