//! Eq. (13) fitted to points: 1/l = αL + β.
//!
//! Next door: the same curve fitted in L (`inductance`), the bare relation that a sensor uses (`calibration`).

use super::calibration::Calibration;
use super::line::{FitMethod, Line, preload};
use super::misfit::Misfit;
use super::points::CalibrationPoints;
use crate::error::Error;

/// A fit of eq. (13) with what is known of it.
#[derive(Debug, Clone, PartialEq)]
pub struct InverseLengthFit {
    /// α \[1/(H m)\].
    pub alpha: f64,
    /// Standard error of α \[1/(H m)\]; none without a degree of freedom.
    pub alpha_se: Option<f64>,
    /// β \[1/m\].
    pub beta: f64,
    /// Standard error of β \[1/m\]; none without a degree of freedom.
    pub beta_se: Option<f64>,
    /// Points beyond those that fix the fit.
    pub degrees_of_freedom: usize,
    /// How it does on all points, those left out by [`FitMethod::TwoPoints`] too.
    pub misfit: Misfit,
}

impl InverseLengthFit {
    /// Fits 1/l = αL + β, squares of 1/l, all points with the same weight.
    ///
    /// - two points: α = (1/l₂ − 1/l₁)/(L₂ − L₁), β = 1/l₁ − αL₁
    /// - all: α = Σ (L − L̄)(1/l − mean 1/l)/Σ (L − L̄)², β = mean 1/l − αL̄, s² = Σ (1/l − αL − β)²/(n − 2),
    ///   u(α)² = s²/Σ (L − L̄)², u(β)² = s²/n + L̄² u(α)²
    /// - through (l_p, L_p): α = Σ (L − L_p)(1/l − 1/l_p)/Σ (L − L_p)², β = 1/l_p − αL_p, s² over n − 1, u(α)² = s²/Σ (L − L_p)²,
    ///   u(β) = L_p u(α); a point that equals the preload counts in neither
    ///
    /// Source:   `[Weijde2017]` eq. 13 and section III-C; standard errors of a straight line as `[JCGM100]` H.3.
    /// Valid:    errors that sit in 1/l, alike and independent. Noise of L instead, of variance σ², makes |α| too small by about
    ///           the share σ²/var L; [`super::InductanceFit`] takes squares of L.
    /// Accuracy: α and β to 1e-12 relative from exact points; standard errors within 2 % of a Monte Carlo run of 20 000.
    /// Differs:  the paper does not say in which quantity it takes squares.
    ///
    /// # Errors
    /// [`Error::Value`] for an index that is no point's, two points that are one, a preload that is not finite or above zero in length, or
    /// where some point's L lies beyond the pole of the fit.
    ///
    /// ```
    /// use coilsense::calibrate::{CalibrationPoints, FitMethod, InverseLengthFit};
    /// let points = CalibrationPoints::new(&[0.1, 0.125, 0.2], &[4e-6, 3.1e-6, 1.5e-6])?; // 1/l = 2e6 L + 2, but for 1e-7 H
    /// let fit = InverseLengthFit::new(&points, FitMethod::first_and_last(&points))?;
    /// assert!((fit.alpha - 2e6).abs() < 1e-6 && (fit.beta - 2.0).abs() < 1e-12 && fit.alpha_se.is_none());
    /// let fit = InverseLengthFit::new(&points, FitMethod::AllPoints)?;
    /// assert!(fit.degrees_of_freedom == 1 && fit.alpha_se.is_some());
    /// assert!((fit.calibration().length(4e-6) - 0.1).abs() < 1e-3);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn new(points: &CalibrationPoints, method: FitMethod) -> Result<Self, Error> {
        let (x, y) = (points.inductances(), points.inverse_lengths());
        let line = match method {
            FitMethod::TwoPoints { first, last } => Line::two_points(x, &y, [first, last])?,
            FitMethod::AllPoints => Line::least_squares(x, &y),
            FitMethod::Through { length, inductance } => {
                let (length, inductance) = preload(length, inductance)?;
                Line::through(x, &y, [inductance, 1.0 / length])
            }
        };
        let line = line.usable("alpha of the fit", "1/(H m)")?;
        let calibration = Calibration::of(line.slope, line.intercept);
        Ok(Self {
            alpha: line.slope,
            alpha_se: line.slope_se,
            beta: line.intercept,
            beta_se: line.intercept_se,
            degrees_of_freedom: line.degrees_of_freedom,
            misfit: calibration.misfit(points)?,
        })
    }

    /// The relation alone, for a sensor.
    pub fn calibration(&self) -> Calibration {
        Calibration::of(self.alpha, self.beta)
    }
}
