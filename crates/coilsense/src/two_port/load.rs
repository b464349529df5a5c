//! What hangs on end 2: held, free, a mass, or any stiffness over frequency.
//!
//! Next door: the force that gets there ([`super::DynamicStiffness`]).

use num_complex::Complex64;

use crate::error::{Error, called, check};

/// A load at end 2, by the force over the displacement it answers with: −F_o = K_L U2.
///
/// ```
/// use coilsense::two_port::Load;
/// use num_complex::Complex64;
///
/// let hand = Load::stiffness(Complex64::new(300.0, 40.0))?; // N/m at the frequency in question
/// assert_eq!(hand.at(0.0), Some(Complex64::new(300.0, 40.0)));
/// assert_eq!(Load::mass(0.5)?.at(2.0), Some(Complex64::from(-2.0)));
/// assert!(Load::mass(-1.0).is_err());
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load(pub(super) Kind);

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    Held,
    Mass(f64),
    Stiffness(Complex64),
}

impl Load {
    /// End 2 does not move: K_L → ∞.
    pub const HELD: Self = Self(Kind::Held);

    /// Nothing at end 2: K_L = 0.
    pub const FREE: Self = Self(Kind::Stiffness(Complex64::ZERO));

    /// A rigid mass: K_L = −M ω².
    ///
    /// - `mass`: M \[kg\], from zero on
    ///
    /// # Errors
    /// [`Error::Value`] where it is below zero or not finite.
    pub fn mass(mass: f64) -> Result<Self, Error> {
        let holds = mass.is_finite() && mass >= 0.0;
        check(holds, "end_mass", mass, "kg", "zero or above and finite")?;
        Ok(Self(Kind::Mass(mass)))
    }

    /// Any linear load, by its force over displacement at the frequency in question.
    ///
    /// - `stiffness`: K_L \[N/m\]; a mechanical impedance Z_L (force over velocity, N s/m) is K_L = jω Z_L
    ///
    /// # Errors
    /// [`Error::Value`] where a part is not finite.
    pub fn stiffness(stiffness: Complex64) -> Result<Self, Error> {
        for (words, part) in
            [("real part of the load stiffness", stiffness.re), ("imaginary part of the load stiffness", stiffness.im)]
        {
            check(part.is_finite(), called("stiffness", words), part, "N/m", "finite")?;
        }
        Ok(Self(Kind::Stiffness(stiffness)))
    }

    /// K_L \[N/m\] at an angular frequency \[rad/s\]; `None` where end 2 is held.
    pub fn at(&self, angular_frequency: f64) -> Option<Complex64> {
        match self.0 {
            Kind::Held => None,
            Kind::Mass(mass) => Some(Complex64::from(-mass * angular_frequency * angular_frequency)),
            Kind::Stiffness(stiffness) => Some(stiffness),
        }
    }
}
