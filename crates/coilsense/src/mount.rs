//! How the spring is mounted: what end 2 is tied to, and what damps the windings.
//!
//! Next door: the modes that follow (`modes`), how the ends are driven (`excitation`).

use crate::damping::Damping;
use crate::error::{Error, above_zero};

/// What end 2 is tied to. End 1 always has a prescribed position.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum FarEnd {
    /// A prescribed position; held where the input is. The paper's case.
    #[default]
    Position,
    /// A prescribed force.
    Force,
    /// A mass \[kg\], above zero, pulled by the spring and by a prescribed force.
    Mass(f64),
}

/// End 2 and damping, checked.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mount {
    far_end: FarEnd,
    damping: Damping,
}

impl Mount {
    /// A mount; [`Mount::default`] is the paper's: both positions prescribed, no damping.
    ///
    /// # Errors
    /// [`Error::Value`] for an end mass that is not above zero, or damping below zero.
    pub fn new(far_end: FarEnd, damping: Damping) -> Result<Self, Error> {
        if let FarEnd::Mass(mass) = far_end {
            above_zero("end_mass", mass, "kg")?;
        }
        Ok(Self { far_end, damping: damping.checked()? })
    }

    /// What end 2 is tied to.
    pub fn far_end(&self) -> FarEnd {
        self.far_end
    }

    /// What damps the windings.
    pub fn damping(&self) -> &Damping {
        &self.damping
    }
}
