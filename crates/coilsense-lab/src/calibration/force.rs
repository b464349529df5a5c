//! From length to force, with its uncertainty.
//!
//! Next door: how uncertain the length is (`coilsense::calibrate::ReadingUncertainty`).

use crate::spec::SpringSpec;

/// F = k(l − l0) with what is known of k and l0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceLaw {
    /// k \[N/m\].
    pub stiffness: f64,
    /// u(k) \[N/m\].
    pub stiffness_u: f64,
    /// l0, the length without force \[m\]; of a spring with initial tension, where its straight line meets zero.
    pub rest_length: f64,
    /// u(l0) \[m\].
    pub rest_length_u: f64,
}

impl ForceLaw {
    /// That of a spec's spring, with its tolerances taken as evenly spread.
    pub fn of(spec: &SpringSpec) -> Self {
        let (stiffness, even) = (spec.spring.stiffness(), 1.0 / 3.0_f64.sqrt());
        Self {
            stiffness,
            stiffness_u: even * stiffness * spec.stiffness_tolerance(),
            rest_length: spec.spring.rest_length(),
            rest_length_u: even * spec.rest_length_tolerance(),
        }
    }

    /// F \[N\] at a length \[m\].
    pub fn force(&self, length: f64) -> f64 {
        self.stiffness * (length - self.rest_length)
    }

    /// u(F) \[N\] at a length \[m\] that is itself known to `length_u` \[m\].
    ///
    /// u(F)² = k² u(l)² + (l − l0)² u(k)² + k² u(l0)²
    ///
    /// Source:   law of propagation, `[JCGM100]` eq. 10.
    /// Valid:    l, k and l0 found apart from each other; shares u(k)/k well below 1.
    /// Accuracy: first order: it leaves out u(k)² u(l)², 1e-4 of u(F)² where both are known to 1 % of the deflection.
    pub fn uncertainty(&self, length: f64, length_u: f64) -> f64 {
        let by_stiffness = (length - self.rest_length) * self.stiffness_u;
        (self.stiffness * length_u.hypot(self.rest_length_u)).hypot(by_stiffness)
    }
}
