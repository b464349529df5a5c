//! What end 2 meets: nothing that moves, or a mass on a spring and a damper.
//!
//! Next door: the drive at the other end (`drive`), the spring between them (`plant`).

use num_complex::Complex64;

use crate::error::{Error, called, not_negative};
use crate::two_port::Load;

/// What end 2 meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Environment {
    /// It does not move.
    Held,
    /// A mass on a spring and a damper to the ground: K_L = k_L + jω b_L − ω² M_L, each zero or above.
    Impedance {
        /// M_L \[kg\].
        mass: f64,
        /// b_L \[N s/m\].
        damping: f64,
        /// k_L \[N/m\].
        stiffness: f64,
    },
}

impl Environment {
    /// Lets through an environment whose numbers are sound.
    pub(super) fn checked(self) -> Result<Self, Error> {
        if let Self::Impedance { mass, damping, stiffness } = self {
            not_negative(called("mass", "load mass"), mass, "kg")?;
            not_negative(called("damping", "load damping"), damping, "N s/m")?;
            not_negative(called("stiffness", "load stiffness"), stiffness, "N/m")?;
        }
        Ok(self)
    }

    /// The load at one angular frequency \[rad/s\].
    pub(super) fn at(&self, angular_frequency: f64) -> Result<Load, Error> {
        match *self {
            Self::Held => Ok(Load::HELD),
            Self::Impedance { mass, damping: 0.0, stiffness: 0.0 } => Load::mass(mass),
            Self::Impedance { mass, damping, stiffness } => {
                let elastic = stiffness - mass * angular_frequency * angular_frequency;
                Load::stiffness(Complex64::new(elastic, damping * angular_frequency))
            }
        }
    }
}
