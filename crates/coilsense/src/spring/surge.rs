//! The wave that runs through a spring: how long it takes, how often it comes back, what it pulls with.
//!
//! Next door: the spring (the parent), all of its modes (`crate::modes`).

use super::Spring;

impl Spring {
    /// First surge frequency of the chain with both ends held \[Hz\].
    ///
    /// f = M/(πτ) sin(π/2M), M the chain's masses; [`Self::surge_frequency`] is its limit for many
    ///
    /// Source:   `[Weijde2017]` eqs. 5–6, as [`crate::modes::ChainModes`].
    /// Valid:    no damping, windings that never touch.
    /// Accuracy: 4e-16 relative.
    pub fn chain_frequency(&self) -> f64 {
        let Some(sections) = self.sections() else { return chain_frequency(self.chain_masses(), self.transit_time()) };
        let [stiffer, heavier] = self.scales(sections);
        let lumps = sections.lumps(self.masses_per_winding);
        crate::bidiagonal::first_frequency(&lumps.masses, &lumps.stiffnesses) * (stiffer / heavier).sqrt()
            / std::f64::consts::TAU
    }

    /// The band in which the first surge frequency of the real coil lies, both ends held \[Hz\].
    ///
    /// From that of a chain of one mass per winding to that of the continuous bar, and beyond both by max(0.2 %, 25 %/N)
    ///
    /// Source:   helical rods with prestress, two formulations: valve spring of 5.75 windings 388.7 Hz held (391.4 Hz where its flat coil
    ///           has the formula's k with shear), 391.4 Hz free to turn, where the chain has 399.0 and the bar 403.6 Hz; car spring of 6.5
    ///           windings 50.7 Hz (52.3, 52.7); S_T −0.11 to +0.16 %.
    /// Valid:    round wire, N from some 5 windings on; for fewer the width is a guess.
    /// Accuracy: holds all the springs above.
    pub fn first_frequency_band(&self) -> (f64, f64) {
        let windings = self.whole_windings();
        let beyond = (0.25 / windings as f64).max(0.002);
        let chain = match self.sections() {
            Some(_) => Self { masses_per_winding: 1, ..self.clone() }.chain_frequency(),
            None => chain_frequency(windings, self.transit_time()),
        };
        let bar = self.surge_frequency();
        (chain * (1.0 - beyond), bar * (1.0 + beyond))
    }

    /// Dynamic spring characteristic \[s\]: the time in which a surge wave runs through the coil once.
    ///
    /// τ = √(m/k); of a coil of sections half a period of its first surge, π/ω_1
    ///
    /// Source:   `[Weijde2017]` eq. 2; [`crate::sections::Sections::first_frequency`].
    /// Valid:    a uniform coil; of sections, while all windings are open.
    /// Accuracy: 2e-16 relative (one division, one root).
    pub fn transit_time(&self) -> f64 {
        let Some(sections) = self.sections() else { return (self.parameters.mass / self.parameters.stiffness).sqrt() };
        let [stiffer, heavier] = self.scales(sections);
        std::f64::consts::PI / sections.first_frequency() * (heavier / stiffer).sqrt()
    }

    /// f1: first surge frequency of the continuous coil with both ends held \[Hz\], everywhere in coilsense.
    ///
    /// f1 = ω_1 / 2π = 1 / (2τ)
    ///
    /// Source:   `[Weijde2017]` eq. 3 with n = 1.
    /// Valid:    a uniform undamped coil, windings that never touch.
    /// Accuracy: 3e-16 relative.
    /// Differs:  the chain's own first mode ([`crate::modes::ChainModes::frequencies`]) lies lower, 0.015 % for S_T.
    pub fn surge_frequency(&self) -> f64 {
        0.5 / self.transit_time()
    }

    /// Wave impedance \[N s/m\]: what an impact adds to an end force, per m/s.
    ///
    /// Z = √(k m)
    ///
    /// Source:   d'Alembert's solution of the one-dimensional wave equation: an impact at v changes an end force by ±v Z.
    /// Valid:    a uniform coil, times below τ, N → ∞.
    /// Accuracy: 2e-16 relative.
    pub fn wave_impedance(&self) -> f64 {
        (self.parameters.stiffness * self.parameters.mass).sqrt()
    }
}

/// First frequency of a chain of so many masses with both ends held \[Hz\].
fn chain_frequency(masses: usize, transit_time: f64) -> f64 {
    let masses = masses as f64;
    masses / (std::f64::consts::PI * transit_time) * (0.5 * std::f64::consts::PI / masses).sin()
}
