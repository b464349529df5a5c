//! What is known beforehand, and what is asked for.
//!
//! Next door: the answer (the parent).

use crate::error::{Error, above_zero, called, check};
use crate::mount::FarEnd;
use crate::signals::Channel;

/// What a user knows of spring and sensors; [`Settings::default`] knows nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// N: active windings \[1\], for the chain's frequencies instead of the continuous coil's.
    pub windings: Option<f64>,
    /// m: mass of the active coil \[kg\]: with the stiffness it predicts f1.
    pub mass: Option<f64>,
    /// f1 \[Hz\] of the spring with both ends held, where a spec predicts it.
    pub predicted: Option<f64>,
    /// How far a predicted f1 may be off \[1\], relative.
    pub prediction_tolerance: f64,
    /// What end 2 is tied to, where it is known; else the record decides.
    pub far_end: Option<FarEnd>,
    /// A force or position that was recorded with the wrong sign, to be turned.
    pub turned: Option<Channel>,
    /// Dynamic error of a force that is still trusted \[1\], relative.
    pub tolerance: f64,
    /// Limit of error of the force sensors \[1\], relative.
    pub accuracy_force: f64,
    /// Limit of error of the position sensors \[1\], relative.
    pub accuracy_position: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            windings: None,
            mass: None,
            predicted: None,
            prediction_tolerance: 0.05,
            far_end: None,
            turned: None,
            tolerance: 0.01,
            accuracy_force: 0.0,
            accuracy_position: 0.0,
        }
    }
}

impl Settings {
    /// Lets through settings that make sense.
    pub(super) fn checked(&self) -> Result<&Self, Error> {
        for (quantity, value, unit) in [
            ("windings".into(), self.windings, ""),
            (called("mass", "mass of the coil"), self.mass, "kg"),
            (called("predicted", "predicted first surge frequency"), self.predicted, "Hz"),
        ] {
            if let Some(value) = value {
                above_zero(quantity, value, unit)?;
            }
        }
        if let Some(FarEnd::Mass(mass)) = self.far_end {
            above_zero("end_mass", mass, "kg")?;
        }
        if let Some(windings) = self.windings {
            check((1.0..=1e6).contains(&windings), "windings", windings, "", "from 1 to 1000000")?;
        }
        let open = |value: f64| value > 0.0 && value < 1.0;
        check(open(self.tolerance), "tolerance", self.tolerance, "", "above 0 and below 1")?;
        let tolerance = self.prediction_tolerance;
        let prediction = called("prediction_tolerance", "tolerance of the prediction");
        check(open(tolerance), prediction, tolerance, "", "above 0 and below 1")?;
        for (quantity, value) in [
            (called("accuracy_force", "accuracy of the force"), self.accuracy_force),
            (called("accuracy_position", "accuracy of the position"), self.accuracy_position),
        ] {
            check((0.0..1.0).contains(&value), quantity, value, "", "from 0 to below 1")?;
        }
        Ok(self)
    }
}
