//! A straight line through points: from two, from all, or from all and exactly through one.
//!
//! Next door: the two relations that are straight lines in some quantity (`inverse_length`, `inductance`).

use super::points::CalibrationPoints;
use crate::error::{Error, check, finite};

/// What a fit goes by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FitMethod {
    /// Exactly through two of the points, by their indices from zero; no standard errors.
    TwoPoints {
        /// One.
        first: usize,
        /// The other.
        last: usize,
    },
    /// Least squares over all points, each with the same weight in the quantity in which the relation is linear.
    AllPoints,
    /// The same, constrained to pass exactly through one pair, such as the preload's, which may or may not be one of the points.
    Through {
        /// l \[m\].
        length: f64,
        /// L \[H\].
        inductance: f64,
    },
}

impl FitMethod {
    /// Through the first and the last of the points, as the measured runs' authors do.
    pub fn first_and_last(points: &CalibrationPoints) -> Self {
        Self::TwoPoints { first: 0, last: points.lengths().len() - 1 }
    }
}

/// y = slope x + intercept, with what is known of both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    pub(super) slope: f64,
    pub(super) intercept: f64,
    /// None where no point is left to tell.
    pub(super) slope_se: Option<f64>,
    pub(super) intercept_se: Option<f64>,
    /// Points beyond those that fix the line.
    pub(super) degrees_of_freedom: usize,
}

impl Line {
    /// Exactly through two points.
    pub(super) fn two_points(x: &[f64], y: &[f64], [first, last]: [usize; 2]) -> Result<Self, Error> {
        for index in [first, last] {
            let allowed = format!("an index below {}", x.len());
            check(index < x.len(), "point of the fit", index as f64, "", allowed)?;
        }
        let (run, rise) = (x[last] - x[first], y[last] - y[first]);
        check(run != 0.0 && rise != 0.0, "point of the fit", last as f64, "", "another pair than the first point's")?;
        let slope = rise / run;
        let intercept = y[first] - slope * x[first];
        Ok(Self { slope, intercept, slope_se: None, intercept_se: None, degrees_of_freedom: 0 })
    }

    /// Least squares of y.
    ///
    /// a = Σ (x − x̄)(y − ȳ)/Σ (x − x̄)², b = ȳ − a x̄, s² = Σ (y − ax − b)²/(n − 2), u(a)² = s²/Σ (x − x̄)², u(b)² = s²/n + x̄² u(a)²
    pub(super) fn least_squares(x: &[f64], y: &[f64]) -> Self {
        let count = x.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let (x_mean, y_mean) = (mean(x), mean(y));
        let (slope, square) = slope_about(x, y, [x_mean, y_mean]);
        let intercept = y_mean - slope * x_mean;
        let degrees_of_freedom = x.len().saturating_sub(2);
        let variance = variance(x, y, [x_mean, y_mean], slope, degrees_of_freedom);
        let slope_se = variance.map(|s2| (s2 / square).sqrt());
        let intercept_se = variance.map(|s2| (s2 / count + x_mean * x_mean * s2 / square).sqrt());
        Self { slope, intercept, slope_se, intercept_se, degrees_of_freedom }
    }

    /// Least squares of y, exactly through one point.
    ///
    /// a = Σ (x − x_p)(y − y_p)/Σ (x − x_p)², b = y_p − a x_p, s² = Σ (y − ax − b)²/(n − 1), u(a)² = s²/Σ (x − x_p)², u(b) = |x_p| u(a);
    /// n counts the points that are not that one.
    pub(super) fn through(x: &[f64], y: &[f64], at: [f64; 2]) -> Self {
        let (slope, square) = slope_about(x, y, at);
        let intercept = at[1] - slope * at[0];
        let others = x.iter().zip(y).filter(|&(x, y)| [*x, *y] != at).count();
        let degrees_of_freedom = others.saturating_sub(1);
        let slope_se = variance(x, y, at, slope, degrees_of_freedom).map(|s2| (s2 / square).sqrt());
        let intercept_se = slope_se.map(|se| at[0].abs() * se);
        Self { slope, intercept, slope_se, intercept_se, degrees_of_freedom }
    }

    /// Lets through a line that goes up or down at a finite rate; `quantity` names the slope in the error.
    pub(super) fn usable(self, quantity: &'static str, unit: &'static str) -> Result<Self, Error> {
        check(self.slope.is_finite() && self.slope != 0.0, quantity, self.slope, unit, "finite and not zero")?;
        check(self.intercept.is_finite(), "beta of the fit", self.intercept, "", "finite")?;
        Ok(self)
    }
}

/// Slope of least squares about a point, and Σ (x − x_p)².
pub(super) fn slope_about(x: &[f64], y: &[f64], at: [f64; 2]) -> (f64, f64) {
    let (mut product, mut square) = (0.0, 0.0);
    for (x, y) in x.iter().zip(y) {
        let step = x - at[0];
        product += step * (y - at[1]);
        square += step * step;
    }
    (product / square, square)
}

/// s², where there is a degree of freedom.
fn variance(x: &[f64], y: &[f64], at: [f64; 2], slope: f64, degrees_of_freedom: usize) -> Option<f64> {
    let left = |(x, y): (&f64, &f64)| (y - at[1]) - slope * (x - at[0]);
    let squares: f64 = x.iter().zip(y).map(left).map(|rest| rest * rest).sum();
    (degrees_of_freedom > 0).then(|| squares / degrees_of_freedom as f64)
}

/// The pair that a fit must pass, checked.
pub(super) fn preload(length: f64, inductance: f64) -> Result<(f64, f64), Error> {
    check(length.is_finite() && length > 0.0, "preload length", length, "m", "above zero and finite")?;
    Ok((length, finite("preload inductance", inductance, "H")?))
}
