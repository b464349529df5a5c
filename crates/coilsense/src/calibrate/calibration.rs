//! The relation of eq. (13) alone: what a sensor needs.
//!
//! Next door: fits to measured points with their diagnostics (`inverse_length`, `inductance`), the theory that can stand in for measured
//! points (`crate::inductance`), the sensor that uses the relation (`crate::sensors`).

use super::line::slope_about;
use super::misfit::Misfit;
use super::points::CalibrationPoints;
use crate::error::{Error, all_finite, called, check, count, finite};
use crate::inductance::OverLength;
use crate::spring::Spring;

/// α and β of `1/l = αL + β`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Calibration {
    alpha: f64,
    beta: f64,
}

/// Lengths at which [`Calibration::theoretical`] samples the operating range; both ends are among them.
pub const CALIBRATION_LENGTHS: usize = 101;

/// α is 1/(μ₀ N² π r²) and thus large for small coils: 1e9 for 8 windings of 4 mm. This is that of 1 winding of 18 µm.
const LARGEST_ALPHA: f64 = 1e15;

impl Calibration {
    /// Least squares over pairs of length and inductance, constrained to pass through one of them, the preload.
    ///
    /// α = Σ (L − L_p)(1/l − 1/l_p) / Σ (L − L_p)², β = 1/l_p − αL_p
    ///
    /// - `preload`: (l_p \[m\], L_p \[H\]); `lengths`: l \[m\], shape `points`; `inductances`: L \[H\], shape `points`
    ///
    /// Source:   `[Weijde2017]` eq. 13 and section III-C ("a constraint to have the model match the static preload").
    /// Valid:    lengths above zero.
    /// Accuracy: 1e-12 relative in α against 40 digits.
    /// Differs:  the paper does not say in which quantity it takes squares; here it is 1/l, in which eq. 13 is linear.
    ///
    /// # Errors
    /// [`Error::Count`] where the series differ in length; [`Error::Value`] for a value that is not finite, a length not above zero,
    /// or inductances that all equal the preload's.
    pub fn through(preload: (f64, f64), lengths: &[f64], inductances: &[f64]) -> Result<Self, Error> {
        count("inductances", inductances.len(), lengths.len())?;
        all_finite("inductances", inductances, "H")?;
        let (length, inductance) = preload;
        for &value in lengths.iter().chain([&length]) {
            let holds = value.is_finite() && value > 0.0;
            check(holds, called("lengths", "calibration length"), value, "m", "above zero and finite")?;
        }
        finite("preload inductance", inductance, "H")?;
        let inverse: Vec<f64> = lengths.iter().map(|l| 1.0 / l).collect();
        let (alpha, square) = slope_about(inductances, &inverse, [inductance, 1.0 / length]);
        check(square > 0.0, "spread of the inductances", square.sqrt(), "H", "above zero")?;
        let holds = alpha.abs() <= LARGEST_ALPHA;
        check(holds, "alpha of the fit", alpha, "1/(H m)", format!("at most {LARGEST_ALPHA:e} either way"))?;
        Ok(Self { alpha, beta: 1.0 / length - alpha * inductance })
    }

    /// The fit to a coil's own theory: [`CALIBRATION_LENGTHS`] uniform windings over the operating range, through `preload_length` \[m\].
    ///
    /// # Errors
    /// As [`Self::through`].
    pub fn theoretical(spring: &Spring, coil: &dyn OverLength, preload_length: f64) -> Result<Self, Error> {
        Theory::new(spring, coil).calibration(coil, preload_length)
    }

    /// A relation whose constants are known.
    ///
    /// - `alpha`: α \[1/(H m)\], `beta`: β \[1/m\]
    ///
    /// # Errors
    /// [`Error::Value`] for an α that is zero or not finite, or a β that is not finite.
    pub fn new(alpha: f64, beta: f64) -> Result<Self, Error> {
        check(alpha.is_finite() && alpha != 0.0, "alpha", alpha, "1/(H m)", "finite and not zero")?;
        Ok(Self { alpha, beta: finite("beta", beta, "1/m")? })
    }

    pub(super) fn of(alpha: f64, beta: f64) -> Self {
        Self { alpha, beta }
    }

    /// α \[1/(H m)\].
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// β \[1/m\].
    pub fn beta(&self) -> f64 {
        self.beta
    }

    /// Length \[m\] that the fit reads from an inductance L \[H\]: 1 / (αL + β).
    pub fn length(&self, inductance: f64) -> f64 {
        1.0 / (self.alpha * inductance + self.beta)
    }

    /// How it does on points, those of its fit or others.
    ///
    /// # Errors
    /// As [`Misfit::of`].
    pub fn misfit(&self, points: &CalibrationPoints) -> Result<Misfit, Error> {
        let predicted: Vec<f64> = points.lengths().iter().map(|&length| self.inductance(length)).collect();
        let read: Vec<f64> = points.inductances().iter().map(|&henry| self.length(henry)).collect();
        Misfit::of(points, &predicted, &read)
    }

    /// Inductance \[H\] at which the relation reads a length l \[m\]: (1/l − β) / α.
    pub fn inductance(&self, length: f64) -> f64 {
        (1.0 / length - self.beta) / self.alpha
    }
}

/// A coil's own theory over the operating range, at hand for calibrations through several preloads: see [`Calibration::theoretical`].
#[derive(Debug, Clone, PartialEq)]
pub struct Theory {
    lengths: Vec<f64>,
    inductances: Vec<f64>,
}

impl Theory {
    /// L of [`CALIBRATION_LENGTHS`] uniform windings over the operating range.
    pub fn new(spring: &Spring, coil: &dyn OverLength) -> Self {
        let (shortest, longest) = spring.operating_range();
        let step = (longest - shortest) / (CALIBRATION_LENGTHS - 1) as f64;
        let lengths: Vec<f64> = (0..CALIBRATION_LENGTHS).map(|index| shortest + index as f64 * step).collect();
        let inductances = coil.at_lengths(&lengths);
        Self { lengths, inductances }
    }

    /// The fit through `preload_length` \[m\] on the same coil.
    ///
    /// # Errors
    /// As [`Calibration::through`].
    pub fn calibration(&self, coil: &dyn OverLength, preload_length: f64) -> Result<Calibration, Error> {
        Calibration::through((preload_length, coil.at_length(preload_length)), &self.lengths, &self.inductances)
    }
}
