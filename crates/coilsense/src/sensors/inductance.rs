//! Force from the spring's own inductance.
//!
//! Next door: the inductance itself (`crate::inductance`), the fit that turns it into a length (`crate::calibrate`).

use crate::calibrate::Calibration;
use crate::spring::Spring;

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
        inductance.iter().map(|&value| self.spring.static_force(self.calibration.length(value))).collect()
    }
}
