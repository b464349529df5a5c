//! Shaped commands as terminal text: a sentence, a table.
//!
//! Next door: filters and estimators as text (`text`), how it is computed (`crate::mitigation`, `shaping`).

use std::fmt::Write as _;

use crate::mitigation::{Shaped, Shaping};

/// What shaping the command does best, in a sentence; empty where no shaper can be.
pub(super) fn shaping_advice(shaping: &Shaping) -> String {
    let Some(best) = shaping.best() else { return String::new() };
    format!(
        "Where u1 moves by a command ({}), shape it by the {}: it leaves {} of the first mode's ringing, {} at worst ({}), {} of any of modes 2 to 5, and comes \
         {:.1} ms late.",
        shaping.conditions.join(", "),
        best.name,
        percent(best.first),
        percent(best.first_worst),
        best.worst_case,
        percent(best.higher_worst),
        1e3 * best.delay,
    )
}

/// A share in %, with one decimal.
pub(super) fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

/// The section: a heading, the sentence, the table.
pub(super) fn shaping_text(shaping: &Shaping) -> String {
    let mut text = format!("\nShape the command instead\n{}\n\n", shaping_advice(shaping));
    let _ = writeln!(
        text,
        "{:62} {:>8} {:>8} {:>10} {:>9} {:>9}",
        "what is left of ringing, over the box", "mode 1", "worst", "modes 2–5", "late", "length"
    );
    for shaped in &shaping.shapers {
        let _ = writeln!(text, "{}", line(shaped));
    }
    for left_out in &shaping.left_out {
        let _ = writeln!(text, "left out: {}: {}", left_out.name, left_out.reason);
    }
    text
}

fn line(shaped: &Shaped) -> String {
    let [delay, length] = [shaped.delay, shaped.length].map(|time| format!("{:.1} ms", 1e3 * time));
    let [first, worst, higher] = [shaped.first, shaped.first_worst, shaped.higher_worst].map(percent);
    format!("  {:60} {first:>8} {worst:>8} {higher:>10} {delay:>9} {length:>9}", shaped.name)
}
