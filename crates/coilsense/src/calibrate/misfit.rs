//! How far a relation between length and inductance is from measured points.
//!
//! Next door: the fits (`inverse_length`, `inductance`), a theory turned round to give a length (`inversion`).

use super::points::CalibrationPoints;
use crate::error::{Error, called, check};

/// How a relation does on measured points: in inductance by R², in length by the rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Misfit {
    /// R² of L \[1\], below zero where the mean of L would do better.
    pub r2: f64,
    /// Root mean square of the residuals \[m\].
    pub rmse: f64,
    /// The same over the range of the lengths \[1\].
    pub rmse_share_of_range: f64,
    /// Length read from L less the length given \[m\], shape `points`.
    pub residuals: Vec<f64>,
}

impl Misfit {
    /// What a relation makes of points: `read` lengths from the points' inductances, `predicted` inductances from their lengths.
    ///
    /// R² = 1 − Σ (L − L̂)²/Σ (L − mean L)², RMSE = √(Σ (l̂ − l)²/n), share = RMSE/(max l − min l)
    ///
    /// - `predicted`: L̂ \[H\], `read`: l̂ \[m\], both shape `points`
    ///
    /// Source:   the processing of `[Vlasblom2015]`: R² of L, RMSE of the displacement over its range, n and not n − 2 below the root.
    /// Valid:    any relation, fitted or not; a residual of displacement is one of length, as both start from the same zero.
    /// Accuracy: rounding.
    ///
    /// # Errors
    /// [`Error::Count`] for series of another length; [`Error::Value`] where a predicted inductance or a length read is not finite.
    ///
    /// ```
    /// use coilsense::calibrate::{CalibrationPoints, Misfit};
    /// let points = CalibrationPoints::new(&[0.1, 0.2], &[4e-6, 2e-6])?;
    /// let misfit = Misfit::of(&points, &[4e-6, 2e-6], &[0.11, 0.21])?;
    /// assert_eq!(misfit.r2, 1.0);
    /// assert!((misfit.rmse - 0.01).abs() < 1e-15 && (misfit.rmse_share_of_range - 0.1).abs() < 1e-14);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn of(points: &CalibrationPoints, predicted: &[f64], read: &[f64]) -> Result<Self, Error> {
        let (lengths, inductances) = (points.lengths(), points.inductances());
        let count = lengths.len() as f64;
        crate::error::count(called("predicted", "predicted inductances"), predicted.len(), lengths.len())?;
        crate::error::count(called("read", "lengths read"), read.len(), lengths.len())?;
        crate::error::all_finite(called("predicted", "predicted inductances"), predicted, "H")?;
        crate::error::all_finite(called("read", "lengths read"), read, "m")?;
        let mean = inductances.iter().sum::<f64>() / count;
        let left: f64 = inductances.iter().zip(predicted).map(|(l, hat)| (l - hat) * (l - hat)).sum();
        let all: f64 = inductances.iter().map(|l| (l - mean) * (l - mean)).sum();
        let residuals: Vec<f64> = read.iter().zip(lengths).map(|(hat, l)| hat - l).collect();
        let rmse = (residuals.iter().map(|r| r * r).sum::<f64>() / count).sqrt();
        check(rmse.is_finite(), "root mean square of the residuals", rmse, "m", "finite")?;
        Ok(Self { r2: 1.0 - left / all, rmse, rmse_share_of_range: rmse / points.range(), residuals })
    }
}
