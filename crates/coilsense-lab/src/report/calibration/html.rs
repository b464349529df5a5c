//! `report.html` of a calibration: one page that needs no other file and no network; the answer first.
//!
//! Next door: its layout (`page.html`), its figures (`figures`).

use coilsense::calibrate::{Inversion, Misfit};
use minijinja::{Value, context};

use super::text::{thinned, windings};
use crate::calibration::{Outcome, Relation, THEORY_POINTS, answer, with_error};
use crate::quantity::{digits, plainly};
use crate::report::page::{self, shown};
use crate::report::prose::{file_name, unbroken};
use crate::report::{Drawn, ReportError};

/// The page of a calibration.
pub(super) fn page(outcome: &Outcome, date: &str, drawn: &[Drawn]) -> Result<String, ReportError> {
    let measured = &outcome.measured;
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            file => file_name(&measured.file),
            simulated => measured.simulated,
            answer => answer(outcome).iter().map(|line| unbroken(line)).collect::<Vec<_>>(),
            figures => drawn.iter().map(shown).collect::<Vec<_>>(),
            curves => curves(outcome),
            relation => outcome.plan.relation.words(),
            rivals => rivals(outcome),
            others => outcome.taken.has_others().then_some(outcome.taken.judged.len()),
            theories => theories(outcome),
            windings => outcome.plan.coil.map(|coil| windings(coil.windings())),
            coil => outcome.plan.coil.map(|coil| context! {
                radius => plainly(1e3 * coil.coil_radius()), wire => plainly(2e3 * coil.wire_radius()),
            }),
            authors_inversion => matches!(outcome.plan.inversion, Inversion::TwentyFiveLengths { .. }),
            place => measured.place_name(),
            zero_length => measured.zero_length.map(|length| plainly_long(1e3 * length)),
            force => force(outcome),
            line => outcome.plan.relation == Relation::InverseLength,
            steel => outcome.plan.relation == Relation::Steel,
            degrees => outcome.reading.map(|reading| reading.degrees_of_freedom()),
            points => points(outcome),
            account => thinned(outcome).into_iter().chain(measured.account.clone()).collect::<Vec<_>>(),
        },
    )?)
}

/// All digits that a person has set.
fn plainly_long(value: f64) -> String {
    format!("{value:.6}").trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn misfit_value(misfit: &Misfit) -> Value {
    context! {
        r2 => format!("{:.5}", misfit.r2),
        rmse => digits(1e3 * misfit.rmse),
        percent => format!("{:.3}", 100.0 * misfit.rmse_share_of_range),
    }
}

fn curves(outcome: &Outcome) -> [Value; 2] {
    let (inverse, direct) = (&outcome.inverse_length, &outcome.inductance);
    let micro = |value: f64, error: Option<f64>| with_error(1e6 * value, error.map(|error| 1e6 * error));
    [
        context! {
            name => "1/l = αL + β, eq. (13)", squares => "1/l",
            alpha => with_error(inverse.alpha, inverse.alpha_se), alpha_unit => "1/(H m)",
            beta => with_error(inverse.beta, inverse.beta_se), beta_unit => "1/m",
            misfit => misfit_value(&inverse.misfit),
        },
        context! {
            name => "L = α/l + β", squares => "L",
            alpha => micro(direct.alpha, direct.alpha_se), alpha_unit => "µH m",
            beta => micro(direct.beta, direct.beta_se), beta_unit => "µH",
            misfit => misfit_value(&direct.misfit),
        },
    ]
}

fn rivals(outcome: &Outcome) -> Vec<Value> {
    let one = |rival: &crate::calibration::Rival| {
        context! {
            name => rival.relation.words(), option => rival.relation.option(),
            percent => rival.share.as_ref().ok().map(|share| format!("{:.3}", 100.0 * share)),
            refused => rival.share.as_ref().err(),
        }
    };
    outcome.contest.rivals.iter().map(one).collect()
}

fn theories(outcome: &Outcome) -> Vec<Value> {
    let one = |judged: &crate::calibration::Assessment| {
        context! {
            name => judged.theory.name(),
            fractions => judged.theory.fractions(),
            misfit => judged.misfit.as_ref().ok().map(misfit_value),
            refused => judged.misfit.as_ref().err(),
        }
    };
    outcome.theories.iter().map(one).collect()
}

fn force(outcome: &Outcome) -> Option<Value> {
    let law = outcome.plan.force?;
    Some(context! {
        stiffness => digits(law.stiffness), stiffness_u => digits(law.stiffness_u),
        rest_length => plainly_long(1e3 * law.rest_length), rest_length_u => digits(1e3 * law.rest_length_u),
    })
}

fn points(outcome: &Outcome) -> Vec<Value> {
    let measured = &outcome.measured;
    let zero = measured.zero_length.unwrap_or(0.0);
    let forces = outcome.forces();
    let places = measured.places();
    let one = |index: usize| {
        let place = places[index];
        let henry = measured.points.inductances()[index];
        let force = forces.as_ref().map(|forces| forces[index]);
        context! {
            row => measured.rows[index],
            place => format!("{:.3}", 1e3 * place),
            henry => format!("{:.4}", 1e6 * henry),
            henry_se => measured.standard_errors.get(index).map(|error| format!("{:.4}", 1e6 * error)),
            read => format!("{:.3}", 1e3 * (outcome.taken.read[index] - zero)),
            read_u => outcome.taken.curve.length_u(henry).map(|length_u| format!("{:.3}", 1e3 * length_u)),
            residual => format!("{:+.3}", 1e3 * (outcome.taken.read[index] - measured.points.lengths()[index])),
            force => force.map(|(force, _)| format!("{force:.3}")),
            force_u => force.and_then(|(_, uncertainty)| uncertainty).map(digits),
        }
    };
    measured.some(THEORY_POINTS).into_iter().map(one).collect()
}
