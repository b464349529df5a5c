//! At which distance a winding meets itself.
//!
//! Next door: the mutual inductance evaluated there (`mutual`).

/// Distance that stands for a winding's own wire in Maxwell's sum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SelfDistance {
    /// ½ ρ e^(−1/4): eq. (10) as the paper prints it.
    #[default]
    AsPrinted,
    /// ρ e^(−1/4): the geometric mean distance of a round section of radius ρ from itself.
    GeometricMean,
}

impl SelfDistance {
    /// The distance \[m\] for a wire radius ρ \[m\].
    ///
    /// h = ½ ρ e^(−1/4) or ρ e^(−1/4)
    ///
    /// - `wire_radius`: ρ \[m\]
    ///
    /// Source:   `[Weijde2017]` eq. 10; `[Maxwell1873]` art. 693.
    /// Valid:    direct current in a round wire, ρ far below the coil radius.
    /// Accuracy: 2e-16 relative.
    /// Differs:  eq. 10's ½ belongs to a diameter, but Table I's ρ is a radius (it gives the springs' masses). The ½ raises L by
    ///           the constant μ₀ r N ln 2, which the calibration of eq. 13 takes up: F_L does not change.
    ///
    /// ```
    /// use coilsense::inductance::SelfDistance;
    /// assert!((SelfDistance::GeometricMean.of_wire(1e-3) - 0.7788e-3).abs() < 1e-7);
    /// ```
    pub fn of_wire(self, wire_radius: f64) -> f64 {
        let geometric_mean = wire_radius * (-0.25_f64).exp();
        match self {
            Self::AsPrinted => 0.5 * geometric_mean,
            Self::GeometricMean => geometric_mean,
        }
    }
}
