//! Arguments of `calibrate` that come in several forms.
//!
//! Next door: the points themselves (`points`), what is made of all (the parent).

use coilsense_lab::calibration::Preload;
use coilsense_lab::quantity::Dimension;
use pyo3::prelude::*;

use crate::quantity::{Anything, Quantity, positive};

/// A length and an inductance, as numbers or as the command has them.
#[derive(FromPyObject)]
pub enum ReZeroArgument {
    /// As the command has them.
    Text(String),
    /// Length and inductance.
    Pair(Quantity, Quantity),
    /// Something else.
    Other(Anything),
}

impl ReZeroArgument {
    /// The text, where it is one.
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            Self::Pair(..) | Self::Other(_) => None,
        }
    }
}

/// A preload's length, or its length and inductance.
#[derive(FromPyObject)]
pub enum PreloadArgument {
    /// Length and inductance.
    Pair(Quantity, Quantity),
    /// Its length alone.
    Length(Quantity),
}

impl PreloadArgument {
    /// The preload, its values above zero.
    pub fn preload(self) -> PyResult<Preload> {
        let (length, inductance) = match self {
            Self::Length(length) => (length, None),
            Self::Pair(length, inductance) => (length, Some(inductance)),
        };
        let inductance = positive(inductance.as_ref(), "preload[1]", Dimension::Inductance)?;
        Ok(Preload { length: length.positive("preload", Dimension::Length)?, inductance })
    }
}
