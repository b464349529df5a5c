//! A reproduction in a terminal: the answer first, then Tables II and III, marked where they differ, then why.
//!
//! Next door: the page (`html`).

use std::fmt::Write;

use anstyle::{AnsiColor, Style};
use coilsense::Channel;

use crate::published::{COLUMNS, Table};
use crate::reproduce::{Cell, Condition, Protocol, Reason, Reproduction, TOLERANCE_POINTS};

const BOLD: Style = Style::new().bold();
const MARK: Style = AnsiColor::Yellow.on_default();

/// The whole text, with ANSI colours: whoever prints it takes them out where they are not wanted.
pub fn reproduction_text(reproduction: &Reproduction) -> String {
    let mut text = String::new();
    for line in summary(reproduction) {
        let _ = writeln!(text, "{BOLD}{line}{BOLD:#}");
    }
    let _ = writeln!(text, "{}", finding(reproduction));
    for &protocol in &reproduction.protocols {
        for table in [Table::Two, Table::Three] {
            text.push('\n');
            table_text(&mut text, reproduction, table, protocol);
        }
    }
    reasons_text(&mut text, reproduction);
    for warning in reproduction.warnings() {
        let _ = writeln!(text, "\n{MARK}warning:{MARK:#} {warning}");
    }
    text
}

/// How many cells agree, one line per protocol.
pub(super) fn summary(reproduction: &Reproduction) -> Vec<String> {
    let line = |&protocol: &Protocol| {
        let cells = reproduction.cells.iter().filter(|cell| cell.table() == Table::Two);
        let off = |cell: &Cell| Some((cell.by(protocol)?.percent - cell.published.percent).abs());
        let differences: Vec<f64> = cells.filter_map(off).collect();
        let agree = differences.iter().filter(|&&difference| difference <= TOLERANCE_POINTS).count();
        let largest = differences.iter().fold(0.0, |a: f64, &b| a.max(b));
        let reading = match protocol {
            Protocol::Tables => "tables protocol (what makes the printed numbers come out)",
            Protocol::Text => "text protocol (the paper's literal words)",
        };
        format!(
            "Table II, {reading}: {agree} of {} cells within {TOLERANCE_POINTS} points of the print, largest difference {largest:.3}.",
            differences.len()
        )
    };
    reproduction.protocols.iter().map(line).collect()
}

/// What the tables say, in a sentence of their own numbers.
pub(super) fn finding(reproduction: &Reproduction) -> String {
    let percent = |spring: &str, condition: Condition, force: Channel| {
        let cell = reproduction
            .cells
            .iter()
            .find(|cell| cell.table() == Table::Two && cell.place() == (spring, condition, force));
        let computed = cell.and_then(|cell| cell.computed.first());
        computed.map_or_else(|| "–".to_owned(), |computed| format!("{:.2} %", computed.percent))
    };
    let sentence = |name: &'static str| {
        let clash = reproduction.case(name, Condition::Resonance).is_some_and(|case| case.clash.happens());
        format!(
            "{name}: an end force is off by {} of F_nom (RMS) after a heel strike and {} at the first resonance{}; the force by \
             inductance by {} and {}.",
            percent(name, Condition::HeelStrike, Channel::OutputForce),
            percent(name, Condition::Resonance, Channel::OutputForce),
            if clash { " (where its windings would clash)" } else { "" },
            percent(name, Condition::HeelStrike, Channel::InductanceForce),
            percent(name, Condition::Resonance, Channel::InductanceForce),
        )
    };
    let sentences: Vec<String> = reproduction.springs.each().map(|(name, _)| sentence(name)).collect();
    sentences.join(" ")
}

/// What a table holds, in words.
pub(super) fn table_title(table: Table, protocol: Protocol) -> &'static str {
    match (table, protocol) {
        (Table::Two, _) => "RMSD with respect to F_x, % of F_nom",
        (Table::Three, Protocol::Text) => "maximum deviation max |F − F_x|, % of F_nom",
        (Table::Three, Protocol::Tables) => "maximum deviation max (F − F_x), signed, % of F_nom",
    }
}

fn table_text(text: &mut String, reproduction: &Reproduction, table: Table, protocol: Protocol) {
    let _ = writeln!(
        text,
        "{BOLD}Table {}, {} protocol{BOLD:#}: {}",
        table.numeral(),
        protocol.name(),
        table_title(table, protocol)
    );
    let _ = write!(text, "{:20}", "");
    for force in COLUMNS {
        let _ = write!(text, "{:>12}{:8}", force.name(), "");
    }
    text.truncate(text.trim_end().len());
    let _ = writeln!(text, "\n{:20}{}", "", " printed   ours     ".repeat(COLUMNS.len()).trim_end());
    for (spring, _) in reproduction.springs.each() {
        for condition in Condition::ALL {
            let _ = write!(text, "{spring} {:16}", condition.name());
            let row = reproduction.cells.iter().filter(|cell| {
                let (name, of, _) = cell.place();
                cell.table() == table && name == spring && of == condition
            });
            let mut line = String::new();
            for cell in row {
                cell_text(&mut line, cell, protocol);
            }
            let _ = writeln!(text, "{}", line.trim_end());
        }
    }
}

fn cell_text(line: &mut String, cell: &Cell, protocol: Protocol) {
    let Some(computed) = cell.by(protocol) else {
        return;
    };
    let letters: String = computed.reasons.iter().map(|reason| reason.letter()).collect();
    let (printed, ours) = (format!("{:.2}", cell.published.percent), format!("{:.3}", computed.percent));
    if computed.differs_from(cell.published.percent) {
        let _ = write!(line, "{printed:>8}{MARK}{ours:>8}{MARK:#} {letters:<3}");
    } else {
        let _ = write!(line, "{printed:>8}{ours:>8}    ");
    }
}

/// The reasons that some cell has, in the order of their letters.
pub(super) fn reasons_in_use(reproduction: &Reproduction) -> Vec<Reason> {
    let used = |reason: &Reason| {
        let cells = reproduction.cells.iter().flat_map(|cell| &cell.computed);
        cells.into_iter().any(|computed| computed.reasons.contains(reason))
    };
    Reason::ALL.into_iter().filter(used).collect()
}

fn reasons_text(text: &mut String, reproduction: &Reproduction) {
    let reasons = reasons_in_use(reproduction);
    if reasons.is_empty() {
        return;
    }
    let _ = writeln!(text, "\nWhy cells differ by more than {TOLERANCE_POINTS} points:");
    for reason in reasons {
        let _ = writeln!(text, "  {MARK}{}{MARK:#}  {}", reason.letter(), reason.sentence());
    }
}
