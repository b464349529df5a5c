//! What may be off about the spring: a box around its stiffness and its mass.
//!
//! Next door: observers over the box (`bank`), the nominal spring (`sampled_spring`).

use crate::error::{Error, called, check};
use crate::spring::Spring;

/// Relative tolerances of stiffness and mass, to either side.
///
/// ```
/// let tolerances = coilsense::mitigation::ToleranceBox::new(0.1, 0.1)?;
/// assert_eq!(tolerances.corners().len(), 9);
/// assert!(coilsense::mitigation::ToleranceBox::new(0.0, 0.0).is_err());
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToleranceBox {
    stiffness: f64,
    mass: f64,
}

impl ToleranceBox {
    /// ±`stiffness` and ±`mass` \[1\], each from 0 to below 1, not both zero.
    ///
    /// # Errors
    /// [`Error::Value`] for a tolerance outside of that, and for an empty box.
    pub fn new(stiffness: f64, mass: f64) -> Result<Self, Error> {
        for (quantity, value) in
            [(called("stiffness", "stiffness tolerance"), stiffness), (called("mass", "mass tolerance"), mass)]
        {
            check((0.0..1.0).contains(&value), quantity, value, "", "from 0 to below 1")?;
        }
        let some = stiffness + mass;
        check(some > 0.0, "stiffness tolerance plus mass tolerance", some, "", "above zero: the box is empty")?;
        Ok(Self { stiffness, mass })
    }

    /// Tolerance of k \[1\].
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Tolerance of m \[1\].
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// The centre first, then each of k and m off alone, then both the same way, then in opposite directions: relative changes (Δk/k, Δm/m).
    pub fn corners(&self) -> [[f64; 2]; 9] {
        let (k, m) = (self.stiffness, self.mass);
        [[0.0, 0.0], [k, 0.0], [-k, 0.0], [0.0, m], [0.0, -m], [k, m], [-k, -m], [k, -m], [-k, m]]
    }

    /// By how much surge frequencies may be off to either side \[1\]: f1 ∝ √(k/m), lowest and highest.
    pub fn frequency_factors(&self) -> [f64; 2] {
        [((1.0 - self.stiffness) / (1.0 + self.mass)).sqrt(), ((1.0 + self.stiffness) / (1.0 - self.mass)).sqrt()]
    }

    /// The spring with k and m off by relative changes.
    ///
    /// # Errors
    /// [`Error::Value`] where the changed spring is none.
    pub fn changed(spring: &Spring, [stiffness, mass]: [f64; 2]) -> Result<Spring, Error> {
        let mut parameters = spring.parameters().clone();
        parameters.stiffness *= 1.0 + stiffness;
        parameters.mass *= 1.0 + mass;
        parameters.nominal_force = Some(spring.nominal_force());
        Spring::new(parameters)?.with_masses_per_winding(spring.masses_per_winding())
    }
}
