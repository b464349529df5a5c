//! A noun of this package as an argument.
//!
//! Next door: words (`names`), numbers (`quantity`, `samples`).

use pyo3::PyClass;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::pyclass::boolean_struct::True;

use crate::quantity::Anything;

/// A noun, or something else, which is refused by the argument's name.
pub enum Noun<'py, T: PyClass> {
    /// The noun.
    It(Bound<'py, T>),
    /// Something else.
    Other(Anything),
}

impl<'a, 'py, T: PyClass> FromPyObject<'a, 'py> for Noun<'py, T> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        match object.cast::<T>() {
            Ok(noun) => Ok(Self::It(noun.to_owned())),
            Err(_) => object.extract().map(Self::Other),
        }
    }
}

impl<T: PyClass<Frozen = True> + Sync> Noun<'_, T> {
    /// The noun, by the argument's name.
    ///
    /// # Errors
    /// `TypeError` for something else.
    pub fn named(&self, name: &str) -> PyResult<&T> {
        match self {
            Self::It(noun) => Ok(noun.get()),
            Self::Other(object) => {
                let article = if T::NAME.starts_with(['A', 'E', 'I', 'O', 'U']) { "an" } else { "a" };
                let (wanted, got) = (T::NAME, object.class());
                Err(PyTypeError::new_err(format!("{name} must be {article} {wanted}, got {got}")))
            }
        }
    }
}

/// One that may be left out.
///
/// # Errors
/// As [`Noun::named`].
pub fn named<'a, T: PyClass<Frozen = True> + Sync>(
    noun: Option<&'a Noun<'_, T>>,
    name: &str,
) -> PyResult<Option<&'a T>> {
    noun.map(|noun| noun.named(name)).transpose()
}
