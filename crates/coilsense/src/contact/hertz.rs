//! How stiff two windings are where they meet, by Hertz.
//!
//! Next door: the law that takes it (`law`).

use std::f64::consts::PI;

use crate::error::{Error, above_zero, check};

/// Two windings that lie on each other over a full turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    /// Radius of the wire \[m\].
    pub wire_radius: f64,
    /// Length of the line on which they meet \[m\]: π D of a full turn.
    pub length: f64,
    /// E of the wire \[Pa\].
    pub youngs_modulus: f64,
    /// ν of the wire \[1\].
    pub poisson_ratio: f64,
}

impl Hertz {
    /// K_c = F/δ at a force F \[N\] \[N/m\]: two parallel cylinders of one radius ρ on a line of length L,
    /// δ = 2F(1 − ν²)/(π E L) (2 ln(4ρ/a) − 1), a² = 4 (F/L)(ρ/2)/(π E*), E* = E/2(1 − ν²).
    ///
    /// Source:   Johnson, *Contact Mechanics*, eqs. (4.43) and (5.57) of two halves of a cylinder each.
    /// Valid:    an even load over the line; a turn that closes point by point gives more. It hangs on F by a logarithm only: a factor of ten
    ///           in F moves it by a fifth or so.
    /// Accuracy: tens of percent of what real windings do, whose crowns are not straight. End forces do not care from 100 N k on.
    ///
    /// ```
    /// use coilsense::contact::Hertz;
    /// // A turn of 4 mm wire, 25 mm across, under 500 N.
    /// let turn = Hertz { wire_radius: 2e-3, length: 78.5e-3, youngs_modulus: 206e9, poisson_ratio: 0.3 };
    /// assert!((turn.stiffness(500.0)? / 2.2e9 - 1.0).abs() < 0.01);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Value`] for a radius, length, modulus or force that is not above zero, ν outside of 0 to 0.5, and a force that flattens the wire.
    pub fn stiffness(&self, force: f64) -> Result<f64, Error> {
        above_zero("wire_radius", self.wire_radius, "m")?;
        above_zero("length", self.length, "m")?;
        let e = self.youngs_modulus;
        check(e.is_finite() && e > 0.0, "youngs_modulus", e, "Pa", "above zero and finite")?;
        let nu = self.poisson_ratio;
        check((0.0..=0.5).contains(&nu), "poisson_ratio", nu, "", "from 0 to 0.5")?;
        above_zero("force", force, "N")?;
        let compliance = (1.0 - nu * nu) / e;
        let line = force / self.length;
        let half_width = (4.0 * line * self.wire_radius * compliance / PI).sqrt();
        let allowed = "so small that the wire stays round: a half width of contact below half its radius";
        check(half_width < 0.5 * self.wire_radius, "force", force, "N", allowed)?;
        let approach = 2.0 * line * compliance / PI * (2.0 * (4.0 * self.wire_radius / half_width).ln() - 1.0);
        Ok(force / approach)
    }
}
