//! The answer in words: which curve, and how far to trust it.
//!
//! Next door: the numbers (`outcome`).

use coilsense::calibrate::{Permeability, SteelFit};
use coilsense::inductance::{Leads, direct_up_to};

use super::median::median;
use super::{Curve, Outcome, Relation};
use crate::quantity::{digits, plainly};
use crate::spec::STAINLESS;

/// Sentences, the first of which says which curve it is and how far to trust it.
pub fn answer(outcome: &Outcome) -> Vec<String> {
    let first = [advice(outcome), Some(curve(outcome))].into_iter().flatten().collect::<Vec<_>>().join(" ");
    let mut lines = vec![first];
    match &outcome.taken.curve {
        Curve::InverseLength(..) => {
            lines.push(trust(outcome));
            lines.extend(comparison(outcome));
        }
        Curve::Cubic(_) => lines.push(
            "Use it between its points only: beyond them it is soon off by several percent of the range.".to_owned(),
        ),
        Curve::Steel(fit) => lines.extend(steel(outcome, fit)),
    }
    lines.extend(moved(outcome));
    lines.extend(theories(outcome));
    lines.extend(force(outcome));
    if outcome.measured.simulated {
        lines.push("The file says that its data are simulated.".to_owned());
    }
    lines
}

/// Which calibration to take, by points that it was not fitted to.
fn advice(outcome: &Outcome) -> Option<String> {
    let own = outcome.plan.relation;
    let percent = |share: f64| digits(100.0 * share);
    let on = match outcome.taken.has_others() {
        true => format!("on the {} points left over", outcome.taken.judged.len()),
        false => "on points left out one at a time".to_owned(),
    };
    let Some((best, least)) = outcome.best() else {
        // Two points and no other: what measured springs have said.
        let known = outcome.contest.rivals.iter().any(|rival| rival.relation == Relation::Steel && rival.share.is_ok())
            || (outcome.plan.coil.is_some() && outcome.contest.rivals.is_empty());
        return (known && own == Relation::InverseLength && is_exact(outcome)).then(|| {
            "Take --theory steel with two points: on four measured springs it was off by 0.1 to 0.4 % of the range, 1/l = αL + β by 0.3 to 2.2 %."
                .to_owned()
        });
    };
    let share =
        |relation| outcome.contest.rivals.iter().find(|rival| rival.relation == relation)?.share.as_ref().ok().copied();
    let mine = share(own)?;
    // Less than a tenth is not worth another calibration, nor is what rounding leaves.
    if best.relation != own && least < 0.9 * mine && mine > 1e-6 {
        return Some(format!(
            "Take {} ({}): {on} it is off by {} % of the range RMS, this one by {} %.",
            best.relation.words(),
            best.relation.option(),
            percent(least),
            percent(mine)
        ));
    }
    let next = outcome.contest.rivals.iter().filter(|rival| rival.relation != own);
    let next = next.filter_map(|rival| Some((rival.relation, *rival.share.as_ref().ok()?)));
    let (next, further) = next.min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(format!(
        "Take this one, {}: {on} it is off by {} % of the range RMS, {} by {} %.",
        own.words(),
        percent(mine),
        next.words(),
        percent(further)
    ))
}

fn curve(outcome: &Outcome) -> String {
    match &outcome.taken.curve {
        Curve::InverseLength(..) => inverse_length(outcome),
        Curve::Cubic(fit) => {
            let of = |which: usize| fit.standard_errors.map(|errors| errors[which]);
            format!(
                "L = α/l + β + γ/l² {}: α = {} µH m, β = {} µH, γ = {} µH m²{}",
                spread(outcome),
                with_error(1e6 * fit.alpha, of(0).map(|error| 1e6 * error)),
                with_error(1e6 * fit.beta, of(1).map(|error| 1e6 * error)),
                with_error(1e6 * fit.gamma, of(2).map(|error| 1e6 * error)),
                judged(outcome)
            )
        }
        Curve::Steel(fit) => format!(
            "Relative permeability {}{} and a constant of {} nH {}, {}{}",
            with_error(fit.permeability, fit.permeability_u),
            if fit.permeability_u.is_none() { " (told)" } else { "" },
            with_error(1e9 * fit.offset, Some(1e9 * fit.offset_u)),
            spread(outcome),
            match outcome.plan.steel.leads {
                Leads::Open => "leads open".to_owned(),
                Leads::Beside(distance) => format!("return lead {} mm off", plainly(1e3 * distance)),
                Leads::LeftOut => "leads left out".to_owned(),
            },
            judged(outcome)
        ),
    }
}

/// To which points it was fitted.
fn spread(outcome: &Outcome) -> String {
    let (fitted, all) = (outcome.taken.fitted.len(), outcome.taken.read.len());
    if fitted == all { format!("by least squares over {all} points") } else { format!("from {fitted} of {all} points") }
}

/// How far it is from those on which it is judged.
fn judged(outcome: &Outcome) -> String {
    let taken = &outcome.taken;
    if !taken.has_others() && taken.fitted.len() <= outcome.plan.relation.fewest() {
        return ", through all of them.".to_owned();
    }
    if !taken.rms_share.is_finite() {
        return ": some of the points have no length on this curve at all.".to_owned();
    }
    let range = outcome.measured.points.range();
    let place = outcome.measured.place_name();
    let on = if taken.has_others() { format!(" on the other {}", taken.judged.len()) } else { String::new() };
    let half = median(
        taken.judged.iter().filter_map(|&index| taken.curve.length_u(outcome.measured.points.inductances()[index])),
    );
    let half = half.map(|half| format!("; 95 % interval of a single reading ±{} mm", digits(1.96e3 * half)));
    format!(
        ": {} mm RMS of {place}{on} ({} % of the range of {} mm){}.",
        digits(1e3 * taken.rms_share * range),
        digits(100.0 * taken.rms_share),
        digits(1e3 * range),
        half.unwrap_or_default()
    )
}

/// What the permeability says, and what is taken as known.
fn steel(outcome: &Outcome, fit: &SteelFit) -> Vec<String> {
    let mut lines = Vec::new();
    if let Some(uncertainty) = fit.permeability_u {
        let times = (fit.permeability - 1.0) / uncertainty;
        lines.push(match times {
            _ if fit.is_magnetic() => format!("The wire is magnetic: its permeability is {} standard uncertainties above 1.", digits(times)),
            _ if times < -3.0 => format!(
                "The permeability is {} standard uncertainties below 1, which no wire has: check windings, radius, wire and leads.",
                digits(-times)
            ),
            _ => "The wire need not be magnetic: a permeability of 1 is within three standard uncertainties.".to_owned(),
        });
    }
    if fit.permeability > LARGE {
        lines.push(format!(
            "A permeability of {} is that of carbon steel, whose inductance depends on the meter's frequency and test current: calibrate and measure with the same settings.",
            digits(fit.permeability)
        ));
    }
    lines.extend(frequency(outcome, fit));
    if let Some(doubts) = outcome.taken.doubts {
        let told = match outcome.plan.steel.permeability {
            Permeability::Known(_) => format!(", permeability {} %", plainly(100.0 * doubts.permeability)),
            Permeability::Fitted => String::new(),
        };
        let lead = match doubts.leads {
            Leads::Beside(distance) => format!("{} mm off", plainly(1e3 * distance)),
            Leads::Open | Leads::LeftOut => "far away".to_owned(),
        };
        lines.push(format!(
            "Standard uncertainties assumed: meter {} nH, windings {} %, coil radius {} %, wire diameter {} mm{told}, a return lead {lead}, theory {} % of L. Not in them: \
             errors of the points' lengths, and remounting (about 0.25 % of L, which --re-zero removes).",
            digits(1e9 * doubts.meter),
            plainly(100.0 * doubts.windings),
            plainly(100.0 * doubts.coil_radius),
            plainly(1e3 * doubts.wire_diameter),
            plainly(100.0 * doubts.theory),
        ));
    }
    if let (Permeability::Known(known), true) = (outcome.plan.steel.permeability, outcome.taken.fitted.len() > 1) {
        let share = outcome.taken.rms_share;
        if share > FAR {
            lines.push(format!(
                "With a permeability of {} the points are off by {} % of the range: fit it (without --known-permeability), or check windings, radius and wire.",
                digits(known),
                digits(100.0 * share)
            ));
        }
    }
    lines
}

/// From here on wire is taken for carbon steel: stainless spring wire was found between 1 and 3.
const LARGE: f64 = 6.0;
/// What a known permeability may leave before that is said, as a share of the range.
const FAR: f64 = 0.02;

/// Whether the meter's frequency is too high for a theory of direct current.
fn frequency(outcome: &Outcome, fit: &SteelFit) -> Option<String> {
    let frequency = outcome.plan.steel.frequency?;
    let wire = outcome.plan.coil?.wire_radius();
    let limit = direct_up_to(wire, STAINLESS, fit.permeability.max(1.0)).ok()?;
    (frequency > limit).then(|| {
        format!(
            "At {} kHz the skin effect matters, which this theory leaves out: for stainless wire of this thickness it holds up to {} kHz.",
            digits(1e-3 * frequency),
            digits(1e-3 * limit)
        )
    })
}

/// What was zeroed anew.
fn moved(outcome: &Outcome) -> Option<String> {
    let (length, inductance) = outcome.plan.re_zero?;
    Some(format!(
        "Re-zeroed at {} mm, {} µH: the curve is moved by {} nH.",
        digits(1e3 * length),
        digits(1e6 * inductance),
        digits(1e9 * outcome.taken.shift)
    ))
}

fn inverse_length(outcome: &Outcome) -> String {
    let (fit, points) = (&outcome.inverse_length, &outcome.measured.points);
    let found = format!(
        "1/l = αL + β {}: α = {} 1/(H m), β = {} 1/m",
        match outcome.plan.points {
            Some(_) => spread(outcome),
            None => outcome.plan.method.words(points.lengths().len()),
        },
        with_error(fit.alpha, fit.alpha_se),
        with_error(fit.beta, fit.beta_se),
    );
    if is_exact(outcome) {
        return format!("{found}, through all points.");
    }
    format!(
        "{found}, residual {} mm RMS of {} ({} % of the range of {} mm).",
        digits(1e3 * fit.misfit.rmse),
        outcome.measured.place_name(),
        digits(100.0 * fit.misfit.rmse_share_of_range),
        digits(1e3 * points.range()),
    )
}

/// Whether the curve passes through all points because there are no more of them than it has numbers.
fn is_exact(outcome: &Outcome) -> bool {
    outcome.measured.points.lengths().len() <= 2
}

fn trust(outcome: &Outcome) -> String {
    if is_exact(outcome) {
        return "How good it is cannot be told: two points fix α and β, and no residual is left. Record lengths between and beyond them.".to_owned();
    }
    let (worst, index) = outcome.worst();
    let place = 1e3 * outcome.measured.places()[index];
    let name = outcome.measured.place_name();
    let mut text = format!("Largest residual {} mm, at {} mm of {name}", digits(1e3 * worst.abs()), digits(place));
    let rmse = outcome.inverse_length.misfit.rmse;
    match outcome.noise() {
        Some(noise) if rmse > 2.0 * noise => text.push_str(&format!(
            "; the scatter of the readings explains {} mm RMS; the rest is a departure from the form of the curve or an \
             error of the lengths, which more readings will not remove.",
            digits(1e3 * noise)
        )),
        Some(noise) => text.push_str(&format!(
            "; the scatter of the readings alone makes {} mm RMS, so more readings would help.",
            digits(1e3 * noise)
        )),
        None => text.push('.'),
    }
    text
}

/// What the other methods would leave.
fn comparison(outcome: &Outcome) -> Option<String> {
    let rmse = outcome.inverse_length.misfit.rmse;
    let (method, misfit) = outcome.others.iter().min_by(|a, b| a.1.rmse.total_cmp(&b.1.rmse))?;
    // Less than a tenth is not worth another method.
    (misfit.rmse < 0.9 * rmse).then(|| {
        let words = method.words(outcome.measured.points.lengths().len());
        format!("Fitted {words} it would be {} mm RMS.", digits(1e3 * misfit.rmse))
    })
}

fn theories(outcome: &Outcome) -> Option<String> {
    let (name, misfit) = outcome.best_theory()?;
    let worst = outcome.theories.iter().filter_map(|judged| Some((judged.theory, judged.misfit.as_ref().ok()?)));
    let (theory, most) = worst.max_by(|a, b| a.1.rmse.total_cmp(&b.1.rmse))?;
    let percent = |share: f64| digits(100.0 * share);
    Some(format!(
        "Of the theories, which need no measured point, the nearest is {name} ({} % of the range), the farthest {} ({} %).",
        percent(misfit.rmse_share_of_range),
        theory.name(),
        percent(most.rmse_share_of_range)
    ))
}

fn force(outcome: &Outcome) -> Option<String> {
    let forces = outcome.forces()?;
    let lowest = forces.iter().map(|(force, _)| *force).fold(f64::INFINITY, f64::min);
    let highest = forces.iter().map(|(force, _)| *force).fold(f64::NEG_INFINITY, f64::max);
    let range = format!("Force by inductance runs from {} to {} N", digits(lowest), digits(highest));
    let most = forces.iter().filter_map(|(_, uncertainty)| *uncertainty).reduce(f64::max);
    Some(match most {
        Some(most) => format!("{range}, with a standard uncertainty of at most {} N.", digits(most)),
        None => format!("{range}; no point is left to tell its uncertainty."),
    })
}

/// The least share of a value that is shown as its error: what simulations without noise leave is less, and is rounded up.
const FINEST: f64 = 1e-6;

/// A value to the digits that its standard error leaves, such as `2.1573e6 ± 0.012e6`.
pub(crate) fn with_error(value: f64, standard_error: Option<f64>) -> String {
    let exponent = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
    let (scale, power) =
        if (-2..5).contains(&exponent) { (1.0, String::new()) } else { (10f64.powi(exponent), format!("e{exponent}")) };
    let (value, error) =
        (value / scale, standard_error.map(|error| (error / scale).max(FINEST * (value / scale).abs())));
    // Two digits of the error; without one, five of the value.
    let size = error.filter(|error| *error > 0.0).map_or(1e-3 * value.abs(), |error| error);
    let decimals = if size > 0.0 { (1 - size.log10().floor() as i32).clamp(0, 9) as usize } else { 0 };
    match error {
        Some(error) => format!("({value:.decimals$} ± {error:.decimals$}){power}"),
        None => format!("{value:.decimals$}{power}"),
    }
}
