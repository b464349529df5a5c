//! An analysis in the terminal: the answer and the sensors on one stream, the warnings on the other.
//!
//! Next door: the same as a page (`html`) and for machines (`json`).

use std::fmt::Write;

use anstyle::{AnsiColor, Style};

use super::frequency::unmoved;
use crate::analysis::{Analysis, Fix, Verdict, answer, changes_that_meet, several};
use crate::quantity::digits;
use crate::spec::SensorSpec;

const BOLD: Style = Style::new().bold();
const GOOD: Style = AnsiColor::Green.on_default();
const BAD: Style = AnsiColor::Red.on_default();

/// The answer in the first lines, then a table of sensors; warnings are for the other stream, see [`analysis_warnings`].
pub fn analysis_text(analysis: &Analysis) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    for (index, line) in answered(analysis).into_iter().enumerate() {
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
         worst: the error of the nominal and of the worst spring; inside: share of the springs that meet the goal in the least favourable case; F_nom = {} N",
        digits(nominal)
    );
    text += &changes(analysis, widest);
    text
}

/// The answer, which denies no warning that only the report gives.
pub(super) fn answered(analysis: &Analysis) -> Vec<String> {
    let mut lines = answer(analysis);
    if unmoved(&analysis.spec).is_some() {
        lines.iter_mut().filter(|line| *line == "No warnings.").for_each(|line| "See the warning.".clone_into(line));
    }
    lines
}

/// What a reader must know before using the numbers, a line each; what holds for several sensors alike is said once.
pub fn analysis_warnings(analysis: &Analysis) -> Vec<String> {
    let mut lines: Vec<(Vec<&str>, &str)> = Vec::new();
    for warning in &analysis.warnings {
        let of = |sensor: &&SensorSpec| warning.text.starts_with(&format!("{}: ", sensor.name));
        let sensor = analysis.sensors.iter().find(of).map(|sensor| sensor.name.as_str());
        let said = sensor.map_or(warning.text.as_str(), |name| &warning.text[name.len() + 2..]);
        match lines.iter_mut().find(|(names, text)| *text == said && !names.is_empty() && sensor.is_some()) {
            Some((names, _)) => names.extend(sensor),
            None => lines.push((sensor.into_iter().collect(), said)),
        }
    }
    let line = |(names, said): (Vec<&str>, &str)| match names.is_empty() {
        true => said.to_owned(),
        false => format!("{}: {said}", several(&names)),
    };
    unmoved(&analysis.spec).into_iter().chain(lines.into_iter().map(line)).collect()
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
