//! Inductance over inverse length fitted to points: L = α/l + β.
//!
//! Next door: the same curve fitted in 1/l (`inverse_length`).

use super::calibration::Calibration;
use super::line::{FitMethod, Line, preload};
use super::misfit::Misfit;
use super::points::CalibrationPoints;
use crate::error::Error;

/// A fit of L = α/l + β with what is known of it. It is eq. (13)'s curve: its α is one over that one's, its β is −β/α of that one's.
#[derive(Debug, Clone, PartialEq)]
pub struct InductanceFit {
    /// α \[H m\].
    pub alpha: f64,
    /// Standard error of α \[H m\]; none without a degree of freedom.
    pub alpha_se: Option<f64>,
    /// β \[H\].
    pub beta: f64,
    /// Standard error of β \[H\]; none without a degree of freedom.
    pub beta_se: Option<f64>,
    /// Points beyond those that fix the fit.
    pub degrees_of_freedom: usize,
    /// How it does on all points, those left out by [`FitMethod::TwoPoints`] too.
    pub misfit: Misfit,
}

impl InductanceFit {
    /// Fits L = α/l + β, squares of L, all points with the same weight.
    ///
    /// As [`super::InverseLengthFit::new`] with 1/l and L exchanged; from two points both give one curve.
    ///
    /// Source:   `[Vlasblom2015]`, which takes the first and the last point; standard errors of a straight line as `[JCGM100]` H.3.
    /// Valid:    errors that sit in L, alike and independent: a meter's noise at well-known lengths.
    /// Accuracy: α and β to 1e-12 relative from exact points; standard errors within 2 % of a Monte Carlo run of 20 000.
    ///
    /// # Errors
    /// As [`super::InverseLengthFit::new`].
    ///
    /// ```
    /// use coilsense::calibrate::{CalibrationPoints, FitMethod, InductanceFit};
    /// let points = CalibrationPoints::new(&[0.1, 0.125, 0.2], &[4.1e-6, 3.3e-6, 2.1e-6])?; // 0.4 µH m / l + 0.1 µH
    /// let fit = InductanceFit::new(&points, FitMethod::AllPoints)?;
    /// assert!((fit.alpha / 4e-7 - 1.0).abs() < 1e-12 && (fit.beta / 1e-7 - 1.0).abs() < 1e-12);
    /// assert!((fit.calibration().length(4.1e-6) - 0.1).abs() < 1e-12);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn new(points: &CalibrationPoints, method: FitMethod) -> Result<Self, Error> {
        let (x, y) = (points.inverse_lengths(), points.inductances());
        let line = match method {
            FitMethod::TwoPoints { first, last } => Line::two_points(&x, y, [first, last])?,
            FitMethod::AllPoints => Line::least_squares(&x, y),
            FitMethod::Through { length, inductance } => {
                let (length, inductance) = preload(length, inductance)?;
                Line::through(&x, y, [1.0 / length, inductance])
            }
        };
        let line = line.usable("alpha of the fit", "H m")?;
        let predicted: Vec<f64> = x.iter().map(|inverse| line.slope * inverse + line.intercept).collect();
        let read: Vec<f64> = y.iter().map(|henry| line.slope / (henry - line.intercept)).collect();
        Ok(Self {
            alpha: line.slope,
            alpha_se: line.slope_se,
            beta: line.intercept,
            beta_se: line.intercept_se,
            degrees_of_freedom: line.degrees_of_freedom,
            misfit: Misfit::of(points, &predicted, &read)?,
        })
    }

    /// The same curve as 1/l = αL + β, for a sensor.
    pub fn calibration(&self) -> Calibration {
        Calibration::of(1.0 / self.alpha, -self.beta / self.alpha)
    }
}
