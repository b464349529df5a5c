//! The answer in words: which curve, and how far to trust it.
//!
//! Next door: the numbers (`outcome`).

use super::Outcome;
use crate::quantity::digits;

/// Sentences, the first of which says which curve it is and how far to trust it.
pub fn answer(outcome: &Outcome) -> Vec<String> {
    let mut lines = vec![curve(outcome), trust(outcome)];
    lines.extend(comparison(outcome));
    lines.extend(theories(outcome));
    lines.extend(force(outcome));
    if outcome.measured.simulated {
        lines.push("The file says that its data are simulated.".to_owned());
    }
    lines
}

fn curve(outcome: &Outcome) -> String {
    let (fit, points) = (&outcome.inverse_length, &outcome.measured.points);
    let found = format!(
        "1/l = αL + β {}: α = {} 1/(H m), β = {} 1/m",
        outcome.plan.method.words(points.lengths().len()),
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
