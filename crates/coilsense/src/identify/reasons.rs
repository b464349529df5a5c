//! Why a verdict is what it is, in words.
//!
//! Next door: the verdict (`verdict`), what was weighed (`explain`).

use super::explain::Coil;
use super::{Identification, ModeSeries};
use crate::signals::Channel;

/// So many modes of a spring are loud enough after a hit to be seen folded.
const FOLDED: f64 = 4.0;

/// What speaks for a coil.
pub(super) fn series(found: &Identification, coil: &Coil) -> Vec<String> {
    let hits = found.hits.len();
    let after =
        if hits == 0 { String::new() } else { format!(" after {hits} hit{}", if hits == 1 { "" } else { "s" }) };
    let name = coil.mode_series.name();
    let mut evidence = vec![match coil.modes.len() {
        1 => format!("1 decaying line{after} matches a mode of a coil with {name}"),
        modes => format!("{modes} decaying lines{after} match the modes of a coil with {name}"),
    }];
    if found.has_both_forces
        && matches!(coil.mode_series, ModeSeries::HeldHeld | ModeSeries::Gives { .. })
        && !coil.turned
    {
        evidence.push(
            "odd modes pull the two ends in opposite phase and even ones in phase, as a coil between held ends does"
                .to_owned(),
        );
    }
    // A coil of so many windings is continuous: that its lines are no chain's says nothing against it.
    if let (Some(other), Some(said)) = (coil.other_windings.filter(|other| other.is_finite()), found.settings.windings)
    {
        evidence.push(format!(
            "the lines contradict a chain of the {said} windings that were said (about {other:.1} fit them): left out"
        ));
    }
    if let Some(second) = coil.second {
        evidence.push(format!("other lines are those of a second coil with f1 = {second:.2} Hz"));
    }
    if coil.delay.abs() > 0.0 {
        let (late, early) = if coil.delay > 0.0 { ("F_o", "F_i") } else { ("F_i", "F_o") };
        evidence.push(format!("{late} is {:.2} ms later than {early}", 1e3 * coil.delay.abs()));
    }
    evidence
}

/// A channel whose sign is turned.
pub(super) fn turned(found: &Identification) -> Option<String> {
    if found.opposed {
        return Some("F_i and F_o have opposite signs: one of them is turned".to_owned());
    }
    let channel = found.turned?;
    let name = channel.name();
    Some(match channel {
        Channel::U1 | Channel::U2 => {
            format!("the sign of {name} is turned, or those of the forces: they fall where the spring gets longer")
        }
        _ => format!("the sign of {name} is turned: it goes against the other force and against the length"),
    })
}

/// A coil that explains no more than something else does.
pub(super) fn no_lead(decaying: usize, coil: &Coil, rival: &str) -> String {
    let name = coil.mode_series.name();
    if coil.lead > 0.0 {
        format!("{decaying} lines ring: a coil with {name} explains them little better than {rival}")
    } else {
        format!("{decaying} lines ring: {rival} explain them as well as a coil with {name} does")
    }
}

/// A line where the spring was predicted, which the coil that explains most passes by.
pub(super) fn passed_by(line: f64, predicted: f64, rate: f64, coil: &Coil) -> String {
    let off = 100.0 * (line / predicted - 1.0);
    let off = if off.abs() < 0.05 { "at".to_owned() } else { format!("{off:+.1} % from") };
    let why = if FOLDED * predicted > 0.5 * rate {
        format!("sampled at {rate:.0} Hz, higher modes are folded among the lines")
    } else {
        "a coil of few windings rings in torsional and lateral modes, too; `coilsense spring` has their frequencies"
            .to_owned()
    };
    format!(
        "a line at {line:.2} Hz, {off} the {predicted:.2} Hz predicted, decays as the spring's first mode would, but the mode series that fits most \
         lines has f1 = {:.2} Hz and leaves it out ({why})",
        coil.first,
    )
}

/// A coil whose first mode is not there, by modes that hold little of the ringing.
pub(super) fn without_first(predicted: f64, coil: &Coil) -> String {
    format!("{}, and none of them is its first mode, predicted at {predicted:.2} Hz", unexplained(coil))
}

/// A coil that leaves most of the ringing open.
pub(super) fn unexplained(coil: &Coil) -> String {
    format!(
        "{} lines match the modes of a coil with {}, but they hold {:.0} % of the ringing only: something else rings too",
        coil.modes.len(),
        coil.mode_series.name(),
        100.0 * coil.share
    )
}

/// A coil between whose modes steady lines lie like those of a coil with a lower f1.
pub(super) fn steady_between(coil: &Coil, divisor: usize, steady: usize) -> String {
    format!(
        "{} decaying lines match the modes of a coil with f1 = {:.2} Hz, but {steady} steady lines lie between them where a coil with f1 = \
         {:.2} Hz has modes, too",
        coil.modes.len(),
        coil.first,
        coil.first / divisor as f64
    )
}

/// A coil whose mount may move f1.
pub(super) fn moved(coil: &Coil) -> String {
    format!(
        "{} lines match the modes of a coil, but f1 between held ends may lie from {:.2} to {:.2} Hz: a mount that gives cannot be told from \
         one that does not",
        coil.modes.len(),
        coil.range.0,
        coil.range.1
    )
}
