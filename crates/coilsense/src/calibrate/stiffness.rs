//! Stiffness and offset of a spring from forces at measured displacements.
//!
//! Next door: length from inductance (`inverse_length`).

use super::line::Line;
use crate::error::{Error, all_finite, check, count, number_of};

/// F = F_0 + k x fitted to points at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StiffnessFit {
    /// k \[N/m\].
    pub stiffness: f64,
    /// Standard error of k \[N/m\]; none without a degree of freedom.
    pub stiffness_se: Option<f64>,
    /// F_0, the force at zero displacement \[N\].
    pub force_at_zero: f64,
    /// Standard error of F_0 \[N\]; none without a degree of freedom.
    pub force_at_zero_se: Option<f64>,
    /// Root mean square of the residuals \[N\].
    pub rmse: f64,
}

impl StiffnessFit {
    /// Fits F = F_0 + k x, squares of F, all points with the same weight.
    ///
    /// k = Σ (x − x̄)(F − F̄)/Σ (x − x̄)², F_0 = F̄ − k x̄
    ///
    /// - `displacements`: x \[m\], shape `points`, by how much the spring is longer than where x is zero; `forces`: F \[N\], shape `points`
    ///
    /// Source:   `[Weijde2017]` section IV-B (from the two ends of the range); standard errors of a straight line as `[JCGM100]` H.3.
    /// Valid:    a spring at rest at each point, above its initial tension; errors that sit in F, alike and independent.
    /// Accuracy: 1e-12 relative from exact points.
    ///
    /// # Errors
    /// [`Error::Count`] for series of different lengths or of fewer than two points; [`Error::Value`] for a value that is not finite, points at
    /// one displacement, or a stiffness that is not above zero.
    ///
    /// ```
    /// let fit = coilsense::calibrate::StiffnessFit::new(&[-1e-3, 0.0, 1e-3], &[25.24, 26.0, 26.76])?;
    /// assert!((fit.stiffness - 760.0).abs() < 1e-9 && (fit.force_at_zero - 26.0).abs() < 1e-12 && fit.rmse < 1e-12);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn new(displacements: &[f64], forces: &[f64]) -> Result<Self, Error> {
        count("forces", forces.len(), displacements.len())?;
        if forces.len() < 2 {
            return Err(number_of("points of the stiffness", forces.len(), "at least 2"));
        }
        all_finite("displacements", displacements, "m")?;
        all_finite("forces", forces, "N")?;
        let line = Line::least_squares(displacements, forces);
        let holds = line.slope.is_finite() && line.slope > 0.0;
        check(
            holds,
            "stiffness",
            line.slope,
            "N/m",
            "above zero and finite (is the sign of force or position turned?)",
        )?;
        let left = displacements.iter().zip(forces).map(|(x, force)| force - line.intercept - line.slope * x);
        let squares: f64 = left.map(|rest| rest * rest).sum();
        Ok(Self {
            stiffness: line.slope,
            stiffness_se: line.slope_se,
            force_at_zero: line.intercept,
            force_at_zero_se: line.intercept_se,
            rmse: (squares / forces.len() as f64).sqrt(),
        })
    }
}
