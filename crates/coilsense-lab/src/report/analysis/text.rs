//! An analysis in the terminal: the answer, the sensors, the warnings.
//!
//! Next door: the same as a page (`html`) and for machines (`json`).

use std::fmt::Write;

use anstyle::{AnsiColor, Style};

use crate::analysis::{Analysis, Fix, Verdict, answer, changes_that_meet};
use crate::quantity::digits;

const BOLD: Style = Style::new().bold();
const GOOD: Style = AnsiColor::Green.on_default();
const BAD: Style = AnsiColor::Red.on_default();
const MARK: Style = AnsiColor::Yellow.on_default();

/// The answer in the first lines, then a table of sensors and the warnings.
pub fn analysis_text(analysis: &Analysis) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    for (index, line) in answer(analysis).into_iter().enumerate() {
        let _ = if index == 0 { writeln!(text, "{BOLD}{line}{BOLD:#}") } else { writeln!(text, "{line}") };
    }
    let nominal = analysis.spec.spring.spring.nominal_force();
    let widest = analysis.sensors.iter().map(|sensor| sensor.name.chars().count()).max().unwrap_or(0).max(15);
    let _ = writeln!(
        text,
        "\n{BOLD}{:widest$}  {:>12}  {:>12}  {:>12}  {:>12}  {:>8}  {:>10}  {:>8}  worst in{BOLD:#}",
        "sensor", "u [N]", "u [% F_nom]", "nominal [N]", "worst [N]", "inside", "−3 dB [Hz]", "lag [ms]"
    );
    for verdict in &analysis.verdicts {
        let sensor = &analysis.sensors[verdict.sensor].name;
        let case = &analysis.cases[verdict.worst];
        let style = style(verdict);
        let _ = writeln!(
            text,
            "{sensor:widest$}  {style}{:>12}  {:>12}{style:#}  {:>12}  {:>12}  {:>8}  {:>10}  {:>8}  {}, {}",
            digits(verdict.combined()),
            digits(100.0 * verdict.combined() / nominal),
            digits(verdict.at_worst().nominal),
            digits(verdict.at_worst().worst),
            verdict.least_inside().map_or_else(|| "–".to_owned(), |share| format!("{:.0} %", 100.0 * share)),
            if verdict.bandwidth.is_finite() { digits(verdict.bandwidth) } else { "–".to_owned() },
            format!("{:.2}", 1e3 * verdict.lag),
            analysis.spec.conditions[case.condition].name,
            analysis.spec.mount.cases[case.damping].label,
        );
    }
    let _ = writeln!(
        text,
        "u: combined standard uncertainty in the worst case, rms over the springs within tolerance, which is compared with the goal; nominal, \
         worst: the error of the nominal and of the worst spring; inside: share of the springs that meet the goal in every case; F_nom = {} N",
        digits(nominal)
    );
    text += &changes(analysis, widest);
    for warning in &analysis.warnings {
        let _ = writeln!(text, "{MARK}Warning:{MARK:#} {}", warning.text);
    }
    text
}

/// What would make the sensors meet the goal that miss it, as a table; nothing where none misses it.
fn changes(analysis: &Analysis, widest: usize) -> String {
    let rows = changes_that_meet(analysis);
    if rows.is_empty() {
        return String::new();
    }
    let change = |fix: Option<&Fix>| fix.map_or("no single change that was tried", |fix| &fix.change).to_owned();
    let wide = rows.iter().map(|(_, fix)| change(*fix).chars().count()).max().unwrap_or(0).max(25);
    let mut text = format!(
        "\n{BOLD}{:widest$}  {:wide$}  {:>8}  {:>12}{BOLD:#}\n",
        "misses the goal", "remedy", "u [N]", "lag [ms]"
    );
    for (sensor, fix) in rows {
        let number = |of: fn(&Fix) -> String| fix.map_or_else(|| "–".to_owned(), of);
        let (newton, later) = (number(|fix| digits(fix.combined)), number(|fix| format!("{:.1}", 1e3 * fix.lag)));
        let _ = writeln!(text, "{sensor:widest$}  {:wide$}  {newton:>8}  {later:>12}", change(fix));
    }
    text + "\n"
}

/// Green where the goal is met, red where it is not.
fn style(verdict: &Verdict) -> Style {
    match verdict.meets_always() {
        Some(true) => GOOD,
        Some(false) => BAD,
        None => Style::new(),
    }
}
