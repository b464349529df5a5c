//! The answer in a few lines: verdict with evidence, numbers with intervals, what can be trusted, what to record next.
//!
//! Next door: all lines of the record (`crate::report`).

use coilsense::identify::{Answer, Estimate, Identification, Part};

use super::Identified;
use crate::calibration::with_error;
use crate::quantity::digits;

/// The answer, the verdict first.
pub fn answer(identified: &Identified) -> Vec<String> {
    let found = &identified.found;
    let verdict = &found.verdict;
    let mut lines = vec![format!("{}: {}.", verdict.answer.name(), verdict.evidence.join("; "))];
    lines.extend(numbers(identified));
    if let (Some(trust), Some(first)) = (found.trust, first_frequency(found)) {
        let percent = digits(100.0 * trust.tolerance);
        let if_spring = if verdict.answer == Answer::Spring { "" } else { " if it is the spring" };
        lines.push(format!(
            "Within {percent} % of its amplitude{if_spring}, a sinusoid of the force at the driven end is told by F_o, the force at the other end, up to {} Hz and by \
             F_x = k (l - l0) up to {} Hz; the force at the held end by F_x up to {} Hz (f1 = {} Hz, no damping).",
            digits(trust.output_for_input),
            digits(trust.deflection_for_input),
            digits(trust.deflection_for_output),
            digits(first.value),
        ));
    }
    lines.extend(verdict.next.iter().map(|next| format!("Record next: {next}.")));
    lines
}

/// f1 where it is worth telling: where it is open whether it is the spring's, its line has to be there, since what lies above may be modes that are
/// folded, or other ones.
fn first_frequency(found: &Identification) -> Option<Estimate> {
    found.first_frequency.filter(|_| found.verdict.answer == Answer::Spring || found.has_first_mode())
}

/// f1, ζ, k, l0, m and τ, as far as they are known.
fn numbers(identified: &Identified) -> Option<String> {
    let found = &identified.found;
    let first = first_frequency(found);
    let of_series = |estimate: &Option<Estimate>| estimate.filter(|_| first.is_some());
    let mut parts = Vec::new();
    let mut add = |name: &str, estimate: Option<Estimate>, scale: f64, unit: &str| {
        parts.extend(estimate.map(|estimate| format!("{name} = {}{unit}", interval(&estimate, scale))));
    };
    add("f1", first, 1.0, " Hz");
    let mode = found.ratio_mode.filter(|mode| *mode != 1);
    add(&mode.map_or("ζ".to_owned(), |mode| format!("ζ of mode {mode}")), of_series(&found.ratio), 1.0, "");
    if let Ok(line) = &found.stiffness {
        add("k", Some(line.stiffness), 1.0, " N/m");
        let name = match (line.both_positions, line.length_at_zero.value > 0.0) {
            (true, true) => "l0",
            (true, false) => "u2 − u1 at zero force (no length: their zeros differ, or a sign is turned)",
            (false, _) => "position without force",
        };
        add(name, Some(line.length_at_zero), 1e3, " mm");
    }
    add("effective mass kτ²", of_series(&found.mass), 1e3, " g");
    add("wave transit time τ", of_series(&found.transit_time), 1e3, " ms");
    if let Some(mass) = found.end_mass {
        parts.push(format!("mass at end 2 {} kg", digits(mass)));
    }
    let sure = found.verdict.answer == Answer::Spring || first.is_none();
    let head = if sure { "" } else { "If it is the spring: " };
    if let Some((low, high)) = wide(first, found.first_range) {
        parts[0] += &format!(" by noise alone, {low:.2} to {high:.2} Hz whatever the mount");
    }
    (!parts.is_empty()).then(|| format!("{head}{} (95 % intervals).", parts.join(", ")))
}

/// A range, where it says more than an estimate's interval.
fn wide(estimate: Option<Estimate>, range: Option<(f64, f64)>) -> Option<(f64, f64)> {
    let (estimate, (low, high)) = (estimate?, range?);
    (high - low > 4.0 * estimate.expanded && high - low > 3e-4 * estimate.value).then_some((low, high))
}

/// A value with its 95 % interval, in another unit.
pub(crate) fn interval(estimate: &Estimate, scale: f64) -> String {
    with_error(scale * estimate.value, Some(scale * estimate.expanded))
}

/// A component of the two ends' forces, as tables call it; mixed where one end pulls more than the other.
pub fn component_name(part: Option<Part>) -> &'static str {
    match part {
        Some(Part::Difference) => "antisymmetric",
        Some(Part::Sum) => "symmetric",
        Some(Part::Single(channel)) => channel.name(),
        None => "mixed",
    }
}
