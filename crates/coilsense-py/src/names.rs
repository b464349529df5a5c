//! Words and names from Python: one, or several.
//!
//! Next door: series of numbers (`series`).

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::quantity::Anything;

/// A text, or a sequence of texts.
#[derive(FromPyObject)]
pub enum Names {
    /// One.
    One(String),
    /// Several.
    Several(Vec<String>),
    /// Something else.
    Other(Anything),
}

impl Names {
    /// As a list, by the argument's name.
    ///
    /// # Errors
    /// `TypeError` for what is neither.
    pub fn listed(self, name: &str) -> PyResult<Vec<String>> {
        match self {
            Self::One(name) => Ok(vec![name]),
            Self::Several(names) => Ok(names),
            Self::Other(object) => {
                let got = object.class();
                Err(PyTypeError::new_err(format!("{name} must be a text or a sequence of texts, got {got}")))
            }
        }
    }
}

/// A text that is one of some words.
#[derive(FromPyObject)]
pub enum Word {
    /// It.
    Text(String),
    /// Something else.
    Other(Anything),
}

impl Word {
    /// The text, by the argument's name.
    ///
    /// # Errors
    /// `TypeError` for what is none.
    pub fn text(&self, name: &str) -> PyResult<&str> {
        match self {
            Self::Text(text) => Ok(text),
            Self::Other(object) => Err(PyTypeError::new_err(format!("{name} must be a text, got {}", object.class()))),
        }
    }
}

/// The names of an argument that may be left out.
///
/// # Errors
/// As [`Names::listed`].
pub fn listed(names: Option<Names>, name: &str) -> PyResult<Vec<String>> {
    names.map_or_else(|| Ok(Vec::new()), |names| names.listed(name))
}
