//! Force from the spring's own inductance.
//!
//! Next door: the inductance itself (`crate::inductance`), the fit that turns it into a length (`crate::calibrate`).

use std::borrow::Cow;
use std::sync::Arc;

use super::cause;
use super::cause::{Cause, Place};
use super::deflection::travel;
use super::sensor::{Native, Row, Sensor, Site};
use crate::calibrate::{Calibration, CalibrationPoints, FitMethod, InverseLengthFit};
use crate::error::Error;
use crate::geometry::Material;
use crate::inductance::theories::Coil;
use crate::inductance::{CLOSE, Leads, OverLength, SteelCoil};
use crate::signals::{Channel, Signals};
use crate::spring::Spring;

pub(super) const ROW: Row = Row {
    word: "inductance",
    native: Native::Inductance,
    watches: &[Channel::Inductance],
    natural_range: |spring, coil| {
        let (shortest, longest) = spring.operating_range();
        (coil.at_length(shortest) - coil.at_length(longest)).abs()
    },
};

/// A meter of L with a calibration: L in, F_L out.
#[derive(Debug, Clone, PartialEq)]
pub struct InductanceSensor {
    spring: Spring,
    calibration: Calibration,
}

impl InductanceSensor {
    /// A sensor on `spring`, calibrated.
    pub fn new(spring: &Spring, calibration: Calibration) -> Self {
        Self { spring: spring.clone(), calibration }
    }

    /// The calibration in use.
    pub fn calibration(&self) -> &Calibration {
        &self.calibration
    }

    /// F_L \[N\], shape `samples`.
    ///
    /// F_L = k (1 / (αL + β) − l0)
    ///
    /// - `inductance`: L \[H\], shape `samples`
    ///
    /// Source:   `[Weijde2017]` eq. 13 and section III-C.
    /// Valid:    an ideal meter; inductances of the range for which the calibration was made. αL + β must stay well above zero: near
    ///           its zero the length, and so the force, runs off to infinity.
    /// Accuracy: that of eq. 13's form, 0.3–0.4 % of F_nom over the paper's operating ranges.
    pub fn force(&self, inductance: &[f64]) -> Vec<f64> {
        inductance.iter().map(|&value| self.force_at(value)).collect()
    }

    fn force_at(&self, inductance: f64) -> f64 {
        self.spring.static_force(self.calibration.length(inductance))
    }
}

/// Departure of measured springs from eq. (13)'s form, share of the travel: 0.3–2 % in measured runs (book: theory, section 5).
const FITTED_FORM: f64 = 0.013;
/// The same of a Maxwell sum without calibration: measured extension springs, uncalibrated Maxwell sum: 27, 33, 28 and 8 % of travel
/// (book: theory, section 5). Most spring wire is magnetic, stainless wire too once it is drawn.
const THEORY_FORM: f64 = 0.30;
/// The same of a wire that is known not to be magnetic, which the sum's air coil is: the upper end of 1–14 %.
const THEORY_FORM_IN_AIR: f64 = 0.14;
/// A relative permeability so near to 1 changes no inductance of a coil by as much.
const NOT_MAGNETIC: f64 = 0.01;

/// How far a measured spring departs from the form of eq. (13), where nobody has measured it: standard deviation, a share of the travel \[1\].
///
/// 0.013 fitted; by theory alone 0.30, and 0.14 of a wire whose relative permeability is 1 within 0.01
///
/// - `uncalibrated`: whether eq. (13) is fitted to Maxwell's sum only, not to measured lengths; `wire`: of the spring
///
/// Source:   measured springs, listed in the book (theory, section 5).
/// Valid:    extension springs of the sizes measured there.
/// Accuracy: a rule of thumb, good to a factor of two.
pub fn usual_form(uncalibrated: bool, wire: &Material) -> f64 {
    let in_air = wire.relative_permeability().is_some_and(|relative| (relative - 1.0).abs() <= NOT_MAGNETIC);
    match (uncalibrated, in_air) {
        (false, _) => FITTED_FORM,
        (true, false) => THEORY_FORM,
        (true, true) => THEORY_FORM_IN_AIR,
    }
}

/// How far eq. (13) is off over a spring's operating range where its wire is magnetic: rms, a share of the travel \[1\].
///
/// Eq. (13) is fitted to 41 lengths of the range (`through_ends`: passes both its ends) of a coil of that permeability.
///
/// - `permeability`: of the wire, 1 to 20; `leads`: where the current goes back, [`Leads::LeftOut`] leaves out what flows along the coil
///
/// Source:   [`SteelCoil`]; radius as it is at the rest length.
/// Valid:    a range in which windings stay 1.02 wire diameters apart; direct current.
/// Accuracy: S_A at 2.5, without the current along the coil: 1.06 % of F_nom, 2.4 % through both ends (1.28 and 2.8 % with open leads). With a radius that does not shrink 1.095 and 2.456 %, and 1.092 and 2.443 % by the finite
///           elements of `reference/permeable_rings.py`.
///
/// # Errors
/// [`Error::Value`] as of [`SteelCoil::new`] and [`SteelCoil::of`].
///
/// ```
/// let s_a = coilsense::paper::s_a();
/// let travel = s_a.operating_range().1 - s_a.operating_range().0;
/// let leads = coilsense::inductance::Leads::LeftOut;
/// let force = coilsense::sensors::magnetic_form(&s_a, 2.5, false, leads)? * travel * s_a.stiffness();
/// assert!((force / s_a.nominal_force() - 0.0106).abs() < 2e-4);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn magnetic_form(spring: &Spring, permeability: f64, through_ends: bool, leads: Leads) -> Result<f64, Error> {
    let (shortest, longest) = spring.operating_range();
    let coil = SteelCoil::from_pitch(&Coil::of(spring)?, spring.rest_length(), leads, [shortest, longest], CLOSE)?;
    let curve = coil.of(permeability)?;
    let step = (longest - shortest) / (MISFIT_LENGTHS - 1) as f64;
    // The last one by itself: rounding must not step over the end.
    let length = |index: usize| if index + 1 == MISFIT_LENGTHS { longest } else { shortest + step * index as f64 };
    let lengths: Vec<f64> = (0..MISFIT_LENGTHS).map(length).collect();
    let inductances: Vec<f64> = lengths.iter().map(|&length| curve.inductance(length)).collect();
    let points = CalibrationPoints::new(&lengths, &inductances)?;
    let method = if through_ends { FitMethod::first_and_last(&points) } else { FitMethod::AllPoints };
    Ok(InverseLengthFit::new(&points, method)?.misfit.rmse_share_of_range)
}

/// How it is known how far a calibration departs from a spring.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FormBy {
    /// By measured springs: [`usual_form`].
    #[default]
    Measured,
    /// Computed, of eq. (13) on magnetic wire: [`magnetic_form`].
    Magnetic,
    /// By what the theory of magnetic wire left of measured springs, which is not eq. (13).
    Steel,
    /// By the calibration of this very spring, whatever its form.
    Stored,
}

/// A calibrated meter, and how far a measured spring departs from its calibration's form.
#[derive(Debug, Clone)]
struct OnCoil {
    meter: InductanceSensor,
    /// Share of the travel \[1\].
    form: f64,
    form_by: FormBy,
    /// What mounting the spring anew adds, likewise.
    remounting: f64,
}

pub(super) fn on(site: &Site<'_>, [form, remounting]: [f64; 2], form_by: FormBy) -> Result<Arc<dyn Sensor>, Error> {
    let calibration = Calibration::theoretical(site.spring, site.coil, site.mean_length)?;
    Ok(Arc::new(OnCoil { meter: InductanceSensor::new(site.spring, calibration), form, form_by, remounting }))
}

impl Sensor for OnCoil {
    fn quantity<'a>(&self, signals: &'a Signals) -> Result<Cow<'a, [f64]>, Error> {
        Ok(signals.channel(Channel::Inductance)?.into())
    }

    fn force_of(&self, reading: f64) -> f64 {
        self.meter.force_at(reading)
    }

    fn zero(&self) -> f64 {
        0.0
    }

    fn slope(&self) -> Option<f64> {
        Some(self.meter.spring.stiffness())
    }

    /// A coil larger in all has as much more inductance; of one that is held at its length the rest is the radii's:
    ///
    /// (∂ln L/∂ln r + ∂ln L/∂ln ρ) = 1 − ∂ln L/∂ln l, 1.7 for S_T, 2 for a long coil of thin wire.
    fn expands(&self, reading: f64) -> f64 {
        let calibration = self.meter.calibration();
        2.0 + calibration.beta() / (calibration.alpha() * reading)
    }

    /// How far eq. (13) is off in length, and which of two reasons says so.
    ///
    /// Of usual figures the larger of the departure of measured springs and that of the coil's own theory, uniform over the operating range: what was
    /// measured holds the theory's part, so adding both would count it twice. What was computed, or measured of this spring, is that alone. It stands for all lengths in use, though a condition of
    /// use visits those near its mean length only, where eq. (13) is forced to be right.
    fn own_causes(&self, site: &Site<'_>) -> Vec<Cause> {
        let measured = self.form * travel(site.spring);
        let theory = misfit(site.spring, site.coil, self.meter.calibration());
        let (name, form) = match (self.form_by, measured >= theory) {
            (FormBy::Steel, _) => (cause::STEEL_FORM, measured),
            (FormBy::Stored, _) => (cause::STORED_FORM, measured),
            (FormBy::Magnetic, _) => (cause::MAGNETIC_FORM, measured),
            (FormBy::Measured, true) => (cause::MEASURED_FORM, measured),
            (FormBy::Measured, false) => (cause::THEORY_FORM, theory),
        };
        let mounted = Cause::normal(Place::Length, cause::REMOUNTING, self.remounting * travel(site.spring));
        Cause::normal(Place::Length, name, form).into_iter().chain(mounted).collect()
    }
}

/// Lengths at which the misfit of eq. (13) is taken.
const MISFIT_LENGTHS: usize = 41;

/// Rms departure \[m\] of eq. (13) from the theory of the coil, over lengths from end to end of the operating range.
fn misfit(spring: &Spring, coil: &dyn OverLength, calibration: &Calibration) -> f64 {
    let (shortest, longest) = spring.operating_range();
    let step = (longest - shortest) / (MISFIT_LENGTHS - 1) as f64;
    let departures = (0..MISFIT_LENGTHS).map(|index| {
        let length = shortest + index as f64 * step;
        calibration.length(coil.at_length(length)) - length
    });
    (departures.map(|d| d * d).sum::<f64>() / MISFIT_LENGTHS as f64).sqrt()
}
