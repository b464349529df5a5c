//! A calibration in the terminal: the answer, both curves, the theories.
//!
//! Next door: the same as a page (`html`) and for machines (`json`).

use std::fmt::Write;

use anstyle::{AnsiColor, Style};
use coilsense::calibrate::Misfit;

use crate::calibration::{Curve, Outcome, Rival, THEORY_POINTS, answer, with_error};
use crate::quantity::digits;

const BOLD: Style = Style::new().bold();
const MARK: Style = AnsiColor::Yellow.on_default();

/// The answer in the first lines, then a table of curves and theories.
pub fn calibration_text(outcome: &Outcome) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    for (index, line) in answer(outcome).into_iter().enumerate() {
        let _ = if index == 0 { writeln!(text, "{BOLD}{line}{BOLD:#}") } else { writeln!(text, "{line}") };
    }
    let (inverse, direct) = (&outcome.inverse_length, &outcome.inductance);
    let _ = writeln!(text, "\n{BOLD}{:46}{:>9}{:>12}{:>14}{BOLD:#}", "curve", "R²", "RMSE [mm]", "[% of range]");
    row(&mut text, "1/l = αL + β (squares of 1/l)", &inverse.misfit);
    row(&mut text, "L = α/l + β (squares of L)", &direct.misfit);
    match &outcome.taken.curve {
        Curve::InverseLength(..) => (),
        curve => {
            let words = format!("{} ({})", curve.relation().words(), curve.relation().option());
            let share = outcome.taken.rms_share;
            let rmse = digits(1e3 * share * outcome.measured.points.range());
            let _ = writeln!(text, "{words:46}{:>9}{rmse:>12}{:>14}", "", format!("{:.3}", 100.0 * share));
        }
    }
    for judged in &outcome.theories {
        match &judged.misfit {
            Ok(misfit) => row(&mut text, judged.theory.name(), misfit),
            Err(reason) => {
                let _ = writeln!(text, "{:46}{MARK}refused: {reason}{MARK:#}", judged.theory.name());
            }
        }
    }
    let _ = writeln!(
        text,
        "1/l = αL + β: α = {} 1/(H m), β = {} 1/m\nL = α/l + β: α = {} µH m, β = {} µH",
        with_error(inverse.alpha, inverse.alpha_se),
        with_error(inverse.beta, inverse.beta_se),
        with_error(1e6 * direct.alpha, direct.alpha_se.map(|error| 1e6 * error)),
        with_error(1e6 * direct.beta, direct.beta_se.map(|error| 1e6 * error)),
    );
    for line in rivals(outcome) {
        let _ = writeln!(text, "{line}");
    }
    if let Some(coil) = outcome.plan.coil.filter(|_| !outcome.theories.is_empty()) {
        let _ = writeln!(text, "{}", windings(coil.windings()));
    }
    for line in thinned(outcome).iter().chain(&outcome.measured.account) {
        let _ = writeln!(text, "{line}");
    }
    text
}

fn row(text: &mut String, name: &str, misfit: &Misfit) {
    let _ = writeln!(
        text,
        "{name:46}{:>9}{:>12}{:>14}",
        format!("{:.5}", misfit.r2),
        digits(1e3 * misfit.rmse),
        format!("{:.3}", 100.0 * misfit.rmse_share_of_range)
    );
}

/// Each calibration on points that it was not fitted to.
pub(super) fn rivals(outcome: &Outcome) -> Vec<String> {
    let on = if outcome.taken.has_others() { "On points not fitted" } else { "On points left out one at a time" };
    let one = |rival: &Rival| {
        let what = format!("{} ({})", rival.relation.words(), rival.relation.option());
        match &rival.share {
            Ok(share) => format!("{on}, {what}: {:.3} % of the range RMS.", 100.0 * share),
            Err(reason) => format!("{what}: {reason}."),
        }
    };
    outcome.contest.rivals.iter().map(one).collect()
}

/// What is not of all points, where there are many.
pub(super) fn thinned(outcome: &Outcome) -> Option<String> {
    let count = outcome.measured.points.lengths().len();
    let some = "points, spread evenly over their lengths";
    (count > THEORY_POINTS).then(|| {
        format!(
            "Theories, figures and tables of points take {THEORY_POINTS} of the {count} {some}; the curve takes all."
        )
    })
}

/// What the theories make of a number of windings.
pub(super) fn windings(windings: f64) -> String {
    if windings.fract() == 0.0 {
        return format!("{windings} windings.");
    }
    format!(
        "{windings:.4} windings: the Maxwell sum takes {} turns at a pitch of l/N and the self term N times, the helix ends within a turn, the \
         other theories take N as it is (Rosa's k_m between whole numbers).",
        windings.round()
    )
}
