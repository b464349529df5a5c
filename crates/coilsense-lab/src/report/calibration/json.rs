//! A calibration for machines, all in SI units but for shares in percent, as the names of its keys say.
//!
//! Next door: the same for people (`text`, `html`).

use coilsense::calibrate::{InductanceFit, InverseLengthFit, Inversion, Misfit};
use serde::Serialize;

use coilsense::inductance::Leads;

use crate::calibration::{
    Assessment, ByNumber, Curve, ForceLaw, Measured, Outcome as Calibrated, Relation, Rival, answer, median,
};
use crate::report::outcome::{Outcome, to_json};

/// A curve through measured inductances, and the theories beside it; null for what was not computed.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct CalibrationOutcome<'a> {
    date: Option<&'a str>,
    file: &'a str,
    simulated: bool,
    /// Root mean square of lengths read less lengths given, over the points on which the calibration is judged.
    length_rms_percent_of_range: Option<f64>,
    /// "others": points that it was not fitted to; "all": there are none.
    judged_on: &'static str,
    /// The calibration that was asked for: "inverse-length" (1/l = α L + β), "cubic" or "steel".
    relation: &'static str,
    /// The answer, a sentence each.
    answer: Vec<String>,
    /// Rows of the file to which it was fitted.
    fitted_rows: Vec<usize>,
    /// By how much a spring that was mounted anew moved L.
    re_zero_h: f64,
    /// The magnetic wire, where it was asked for.
    steel: Option<SteelPart>,
    /// L = α/l + β + γ/l², where it was asked for.
    cubic: Option<CubicPart>,
    /// Each calibration on points that it was not fitted to: those left over, or each left out in turn.
    rivals: Vec<RivalRow<'a>>,
    /// The same over the number of points, spread from the shortest to the longest, on the others.
    by_number_of_points: Vec<NumberRow>,
    /// What the curve goes through.
    method: &'static str,
    /// How theories are turned round: "exact" or "25-lengths".
    inversion: &'static str,
    /// Length of the coil where the file says zero displacement; null where it holds lengths.
    length_at_zero_m: Option<f64>,
    range_m: f64,
    /// 1/l = α L + β, eq. (13).
    inverse_length: InverseLengthPart,
    /// L = α/l + β.
    inductance: InductancePart,
    theories: Vec<TheoryRow<'a>>,
    coil: Option<CoilPart>,
    force: Option<ForcePart>,
    points: Vec<PointRow>,
    /// What became of the file's rows, line by line.
    account: &'a [String],
}

/// A coil of magnetic wire; `_u` are standard uncertainties.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct SteelPart {
    relative_permeability: f64,
    /// Null where it was told.
    relative_permeability_u: Option<f64>,
    /// By the meter's noise alone.
    relative_permeability_noise: Option<f64>,
    magnetic: bool,
    offset_h: f64,
    offset_h_u: f64,
    /// Of measured less fitted L over the fitted points.
    rms_h: f64,
    /// Distance of the lead from the coil's axis; null where it is far away.
    lead_distance_m: Option<f64>,
    meter_noise_h: Option<f64>,
    /// Median half-width of the 95 % interval of a length read, over the points on which it is judged.
    length_interval_percent_of_range: Option<f64>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct CubicPart {
    alpha_h_m: f64,
    alpha_h_m_se: Option<f64>,
    beta_h: f64,
    beta_h_se: Option<f64>,
    gamma_h_m2: f64,
    gamma_h_m2_se: Option<f64>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct RivalRow<'a> {
    relation: &'static str,
    /// How the command is asked for it.
    option: &'static str,
    length_rms_percent_of_range: Option<f64>,
    /// Why that cannot be said.
    refused: Option<&'a str>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct NumberRow {
    points: usize,
    relation: &'static str,
    length_rms_percent_of_range: f64,
}

impl Outcome for CalibrationOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/calibration/1";
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct InverseLengthPart {
    alpha_per_h_m: f64,
    /// Standard error; null where no point is left to tell.
    alpha_per_h_m_se: Option<f64>,
    beta_per_m: f64,
    beta_per_m_se: Option<f64>,
    degrees_of_freedom: usize,
    #[serde(flatten)]
    misfit: MisfitPart,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct InductancePart {
    alpha_h_m: f64,
    alpha_h_m_se: Option<f64>,
    beta_h: f64,
    beta_h_se: Option<f64>,
    degrees_of_freedom: usize,
    #[serde(flatten)]
    misfit: MisfitPart,
}

/// How far a curve is from the points.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct MisfitPart {
    r2: f64,
    rmse_m: f64,
    rmse_percent_of_range: f64,
    largest_residual_m: f64,
}

/// A theory on the points.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct TheoryRow<'a> {
    name: &'static str,
    fractional_windings: &'static str,
    /// Why it cannot be judged; else the misfit follows.
    refused: Option<&'a str>,
    #[serde(flatten)]
    misfit: Option<MisfitPart>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct CoilPart {
    windings: f64,
    coil_radius_m: f64,
    wire_radius_m: f64,
}

/// What takes a length to a force; `_u` are standard uncertainties.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ForcePart {
    stiffness_n_per_m: f64,
    stiffness_n_per_m_u: f64,
    length_at_zero_force_m: f64,
    length_at_zero_force_m_u: f64,
}

/// A measured point; `_se` is a standard error, `_u` a standard uncertainty.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct PointRow {
    /// Of the file, counted from 1.
    row: usize,
    /// Where the file holds displacements; else the length follows.
    #[serde(skip_serializing_if = "Option::is_none")]
    displacement_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    length_m: Option<f64>,
    inductance_h: f64,
    inductance_h_se: Option<f64>,
    /// By the calibration that was asked for; null where it reads none.
    length_read_m: Option<f64>,
    length_read_m_u: Option<f64>,
    residual_m: Option<f64>,
    force_n: Option<f64>,
    force_n_u: Option<f64>,
}

impl<'a> CalibrationOutcome<'a> {
    /// Of a calibration that was made.
    pub fn of(outcome: &'a Calibrated, date: Option<&'a str>) -> Self {
        let (measured, plan) = (&outcome.measured, &outcome.plan);
        Self {
            date,
            file: &measured.file,
            simulated: measured.simulated,
            length_rms_percent_of_range: Some(100.0 * outcome.taken.rms_share).filter(|percent| percent.is_finite()),
            judged_on: if outcome.taken.has_others() { "others" } else { "all" },
            relation: plan.relation.name(),
            answer: answer(outcome),
            fitted_rows: outcome.taken.fitted.iter().map(|&index| measured.rows[index]).collect(),
            re_zero_h: outcome.taken.shift,
            steel: SteelPart::of(outcome),
            cubic: CubicPart::of(outcome),
            rivals: outcome.contest.rivals.iter().map(RivalRow::of).collect(),
            by_number_of_points: by_number(outcome),
            method: plan.method.name(),
            inversion: match plan.inversion {
                Inversion::Exact => "exact",
                Inversion::TwentyFiveLengths { .. } => "25-lengths",
            },
            length_at_zero_m: measured.zero_length,
            range_m: measured.points.range(),
            inverse_length: InverseLengthPart::of(&outcome.inverse_length),
            inductance: InductancePart::of(&outcome.inductance),
            theories: outcome.theories.iter().map(TheoryRow::of).collect(),
            coil: plan.coil.map(|coil| CoilPart {
                windings: coil.windings(),
                coil_radius_m: coil.coil_radius(),
                wire_radius_m: coil.wire_radius(),
            }),
            force: plan.force.as_ref().map(ForcePart::of),
            points: points(outcome),
            account: &measured.account,
        }
    }
}

impl SteelPart {
    fn of(outcome: &Calibrated) -> Option<Self> {
        let Curve::Steel(fit) = &outcome.taken.curve else { return None };
        let (taken, points) = (&outcome.taken, &outcome.measured.points);
        let half = median(taken.judged.iter().filter_map(|&index| taken.curve.length_u(points.inductances()[index])));
        Some(Self {
            relative_permeability: fit.permeability,
            relative_permeability_u: fit.permeability_u,
            relative_permeability_noise: fit.permeability_noise,
            magnetic: fit.is_magnetic(),
            offset_h: fit.offset + taken.shift,
            offset_h_u: fit.offset_u,
            rms_h: fit.rms,
            lead_distance_m: match outcome.plan.steel.leads {
                Leads::Beside(distance) => Some(distance),
                Leads::Open | Leads::LeftOut => None,
            },
            meter_noise_h: taken.doubts.map(|doubts| doubts.meter),
            length_interval_percent_of_range: half.map(|half| 196.0 * half / points.range()),
        })
    }
}

impl CubicPart {
    fn of(outcome: &Calibrated) -> Option<Self> {
        let Curve::Cubic(fit) = &outcome.taken.curve else { return None };
        let of = |which: usize| fit.standard_errors.map(|errors| errors[which]);
        Some(Self {
            alpha_h_m: fit.alpha,
            alpha_h_m_se: of(0),
            beta_h: fit.beta + outcome.taken.shift,
            beta_h_se: of(1),
            gamma_h_m2: fit.gamma,
            gamma_h_m2_se: of(2),
        })
    }
}

impl<'a> RivalRow<'a> {
    fn of(rival: &'a Rival) -> Self {
        Self {
            relation: rival.relation.name(),
            option: rival.relation.option(),
            length_rms_percent_of_range: rival.share.as_ref().ok().map(|share| 100.0 * share),
            refused: rival.share.as_ref().err().map(String::as_str),
        }
    }
}

impl InverseLengthPart {
    fn of(fit: &InverseLengthFit) -> Self {
        Self {
            alpha_per_h_m: fit.alpha,
            alpha_per_h_m_se: fit.alpha_se,
            beta_per_m: fit.beta,
            beta_per_m_se: fit.beta_se,
            degrees_of_freedom: fit.degrees_of_freedom,
            misfit: MisfitPart::of(&fit.misfit),
        }
    }
}

impl InductancePart {
    fn of(fit: &InductanceFit) -> Self {
        Self {
            alpha_h_m: fit.alpha,
            alpha_h_m_se: fit.alpha_se,
            beta_h: fit.beta,
            beta_h_se: fit.beta_se,
            degrees_of_freedom: fit.degrees_of_freedom,
            misfit: MisfitPart::of(&fit.misfit),
        }
    }
}

impl MisfitPart {
    fn of(misfit: &Misfit) -> Self {
        Self {
            r2: misfit.r2,
            rmse_m: misfit.rmse,
            rmse_percent_of_range: 100.0 * misfit.rmse_share_of_range,
            largest_residual_m: misfit.residuals.iter().fold(0.0, |worst: f64, residual| worst.max(residual.abs())),
        }
    }
}

impl<'a> TheoryRow<'a> {
    fn of(judged: &'a Assessment) -> Self {
        Self {
            name: judged.theory.name(),
            fractional_windings: judged.theory.fractions(),
            refused: judged.misfit.as_ref().err().map(String::as_str),
            misfit: judged.misfit.as_ref().ok().map(MisfitPart::of),
        }
    }
}

impl ForcePart {
    fn of(law: &ForceLaw) -> Self {
        Self {
            stiffness_n_per_m: law.stiffness,
            stiffness_n_per_m_u: law.stiffness_u,
            length_at_zero_force_m: law.rest_length,
            length_at_zero_force_m_u: law.rest_length_u,
        }
    }
}

fn by_number(outcome: &Calibrated) -> Vec<NumberRow> {
    let of = |number: &ByNumber| {
        let points = number.fitted;
        let row = move |&(relation, share): &(Relation, f64)| NumberRow {
            points,
            relation: relation.name(),
            length_rms_percent_of_range: 100.0 * share,
        };
        number.shares.iter().map(row).collect::<Vec<_>>()
    };
    outcome.contest.by_number.iter().flat_map(of).collect()
}

fn points(outcome: &Calibrated) -> Vec<PointRow> {
    let measured: &Measured = &outcome.measured;
    let forces = outcome.forces();
    let one = |(index, place): (usize, f64)| {
        let henry = measured.points.inductances()[index];
        let force = forces.as_ref().map(|forces| forces[index]);
        let displaced = measured.zero_length.is_some();
        PointRow {
            row: measured.rows[index],
            displacement_m: Some(place).filter(|_| displaced),
            length_m: Some(place).filter(|_| !displaced),
            inductance_h: henry,
            inductance_h_se: measured.standard_errors.get(index).copied(),
            length_read_m: Some(outcome.taken.read[index]).filter(|length| length.is_finite()),
            length_read_m_u: outcome.taken.curve.length_u(henry),
            residual_m: Some(outcome.taken.read[index] - measured.points.lengths()[index])
                .filter(|rest| rest.is_finite()),
            force_n: force.map(|(force, _)| force).filter(|force| force.is_finite()),
            force_n_u: force.and_then(|(_, uncertainty)| uncertainty),
        }
    };
    measured.places().into_iter().enumerate().map(one).collect()
}

/// The whole calibration as JSON.
///
/// # Errors
/// [`serde_json::Error`] where it cannot be written.
pub fn calibration_json(outcome: &Calibrated, date: Option<&str>) -> Result<String, serde_json::Error> {
    to_json(CalibrationOutcome::of(outcome, date))
}
