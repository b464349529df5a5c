//! A whole number from Python that is not below zero: how many, or which.
//!
//! Next door: numbers with a unit (`quantity`).

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyInt;

use crate::errors::Error;
use crate::quantity::Anything;

/// A whole number, from zero on.
#[derive(FromPyObject)]
pub enum Count {
    /// It.
    Number(u64),
    /// One that is below zero or beyond all bounds, or something else.
    Other(Anything),
}

impl Count {
    /// It, by the argument's name.
    ///
    /// # Errors
    /// `Error` for another whole number, `TypeError` for something else.
    pub fn number(&self, name: &str) -> PyResult<u64> {
        let wanted = format!("{name} must be a whole number, not below zero");
        match self {
            Self::Number(number) => Ok(*number),
            Self::Other(object) => Python::attach(|py| {
                let object = object.bind(py);
                if object.is_instance_of::<PyInt>() {
                    return Err(Error::new_err(format!("{wanted}, got {object}")));
                }
                Err(PyTypeError::new_err(format!("{wanted}, got {}", object.get_type().name()?)))
            }),
        }
    }

    /// The same as a number of things in memory.
    ///
    /// # Errors
    /// As [`Self::number`].
    pub fn size(&self, name: &str) -> PyResult<usize> {
        // A larger one is refused by whoever counts so far.
        Ok(usize::try_from(self.number(name)?).unwrap_or(usize::MAX))
    }
}

/// One that may be left out.
///
/// # Errors
/// As [`Count::number`].
pub fn number(count: Option<&Count>, name: &str) -> PyResult<Option<u64>> {
    count.map(|count| count.number(name)).transpose()
}
