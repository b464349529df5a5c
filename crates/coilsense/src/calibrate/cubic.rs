//! Eq. (13)'s curve with one term more, fitted to points: L = α/l + β + γ/l².
//!
//! Next door: the curve without it (`inductance`), the magnetised wire that asks for it (`steel`).

use nalgebra::{Matrix3, Vector3};

use super::misfit::Misfit;
use super::points::CalibrationPoints;
use crate::error::{Error, check, number_of};

/// A fit of L = α/l + β + γ/l².
#[derive(Debug, Clone, PartialEq)]
pub struct CubicFit {
    /// α \[H m\].
    pub alpha: f64,
    /// β \[H\].
    pub beta: f64,
    /// γ \[H m²\].
    pub gamma: f64,
    /// Standard errors of α, β and γ; none without a degree of freedom.
    pub standard_errors: Option<[f64; 3]>,
    /// Points beyond the three that fix the fit.
    pub degrees_of_freedom: usize,
    /// Least and largest length of the points \[m\].
    range: [f64; 2],
    /// s \[H\], and the inverse of JᵀJ of 1/l, 1, 1/l² over the middle of the range.
    scatter: Option<f64>,
    inverse: Matrix3<f64>,
    middle: f64,
    /// The coefficients of the scaled 1/l, 1 and its square \[H\].
    scaled: Vector3<f64>,
}

impl CubicFit {
    /// Fits L = α/l + β + γ/l², squares of L, all points with the same weight.
    ///
    /// Source:   a polynomial in 1/l; magnetised wire adds about 1/l² to the 1/l of a long coil. Standard errors as `[JCGM100]` H.3.
    /// Valid:    between the points: beyond them it is off by several percent of the range.
    /// Accuracy: 1e-10 of L from exact points.
    ///
    /// # Errors
    /// [`Error::Count`] for fewer than three points; [`Error::Value`] where they stand at fewer than three lengths, or where the curve does not fall with
    /// length over the points.
    ///
    /// ```
    /// use coilsense::calibrate::{CalibrationPoints, CubicFit};
    /// let lengths = [0.1, 0.12, 0.16, 0.2];
    /// let points = CalibrationPoints::new(&lengths, &lengths.map(|l| 4e-7 / l + 1e-7 + 2e-9 / (l * l)))?;
    /// let fit = CubicFit::new(&points)?;
    /// assert!((fit.gamma / 2e-9 - 1.0).abs() < 1e-9 && (fit.length(fit.inductance(0.13)) - 0.13).abs() < 1e-12);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn new(points: &CalibrationPoints) -> Result<Self, Error> {
        let lengths = points.lengths();
        if lengths.len() < 3 {
            return Err(number_of("calibration points of the form cubic", lengths.len(), "at least 3"));
        }
        let [shortest, longest] = points.ends();
        // From −1 to 1, so that three columns stay apart.
        let (middle, half) = (0.5 * (1.0 / shortest + 1.0 / longest), 0.5 * (1.0 / shortest - 1.0 / longest));
        let row = |length: f64| {
            let z = (1.0 / length - middle) / half;
            Vector3::new(z, 1.0, z * z)
        };
        let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for (&length, &henry) in lengths.iter().zip(points.inductances()) {
            let row = row(length);
            normal += row * row.transpose();
            right += henry * row;
        }
        let apart = normal.determinant();
        check(apart > 1e-9, "spread of the points", apart, "", "that of at least three lengths apart from each other")?;
        let inverse = normal.try_inverse().unwrap_or_else(Matrix3::zeros);
        let scaled = inverse * right;
        let squares: f64 =
            lengths.iter().zip(points.inductances()).map(|(&l, henry)| (henry - row(l).dot(&scaled)).powi(2)).sum();
        let degrees_of_freedom = lengths.len() - 3;
        let scatter = (degrees_of_freedom > 0).then(|| (squares / degrees_of_freedom as f64).sqrt());
        let (a, c) = (scaled[0], scaled[2]);
        check(
            a > 2.0 * c.abs(),
            "slope of the fit",
            a,
            "H",
            format!("above {} H, so that L falls with length", 2.0 * c.abs()),
        )?;
        // z = (x − m)/h: a z + b + c z² = (a/h − 2cm/h²) x + b − am/h + cm²/h² + (c/h²) x²
        let back = Matrix3::new(
            1.0 / half,
            0.0,
            -2.0 * middle / (half * half),
            -middle / half,
            1.0,
            middle * middle / (half * half),
            0.0,
            0.0,
            1.0 / (half * half),
        );
        let coefficients = back * scaled;
        let covariance = back * inverse * back.transpose();
        Ok(Self {
            alpha: coefficients[0],
            beta: coefficients[1],
            gamma: coefficients[2],
            standard_errors: scatter.map(|s| [0, 1, 2].map(|index| s * covariance[(index, index)].sqrt())),
            degrees_of_freedom,
            range: [shortest, longest],
            scatter,
            inverse,
            middle,
            scaled,
        })
    }

    /// L \[H\] at a length \[m\].
    pub fn inductance(&self, length: f64) -> f64 {
        let z = self.scaled_place(1.0 / length);
        self.scaled[1] + z * (self.scaled[0] + z * self.scaled[2])
    }

    /// The length \[m\] at which it has an inductance \[H\]; NaN where it has it nowhere.
    pub fn length(&self, inductance: f64) -> f64 {
        let [a, b, c] = [self.scaled[0], self.scaled[1] - inductance, self.scaled[2]];
        // The root that stays when c goes to zero.
        let z = -2.0 * b / (a + (a * a - 4.0 * c * b).sqrt());
        1.0 / (self.middle + self.half() * z)
    }

    /// Standard uncertainty \[m\] of the length that is read from an inductance, as noisy as the points; none without a degree of freedom.
    pub fn length_u(&self, inductance: f64) -> Option<f64> {
        let length = self.length(inductance);
        let z = self.scaled_place(1.0 / length);
        let row = Vector3::new(z, 1.0, z * z);
        let slope = (self.scaled[0] + 2.0 * self.scaled[2] * z) / self.half() / (length * length);
        let leverage = row.dot(&(self.inverse * row));
        self.scatter.map(|s| s * (1.0 + leverage).sqrt() / slope.abs())
    }

    /// The same with another β, so that it passes a point.
    pub fn re_zeroed(&self, length: f64, inductance: f64) -> Self {
        let more = inductance - self.inductance(length);
        Self { beta: self.beta + more, scaled: self.scaled + Vector3::new(0.0, more, 0.0), ..self.clone() }
    }

    /// How it does on points.
    ///
    /// # Errors
    /// As [`Misfit::of`].
    pub fn misfit(&self, points: &CalibrationPoints) -> Result<Misfit, Error> {
        let predicted: Vec<f64> = points.lengths().iter().map(|&length| self.inductance(length)).collect();
        let read: Vec<f64> = points.inductances().iter().map(|&henry| self.length(henry)).collect();
        Misfit::of(points, &predicted, &read)
    }

    fn half(&self) -> f64 {
        0.5 * (1.0 / self.range[0] - 1.0 / self.range[1])
    }

    fn scaled_place(&self, inverse_length: f64) -> f64 {
        (inverse_length - self.middle) / self.half()
    }
}
