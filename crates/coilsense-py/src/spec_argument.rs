//! A spec as an argument: the noun, or its file.
//!
//! Next door: a spring alone (`spring_argument`).

use std::path::PathBuf;

use coilsense_lab::spec::Spec;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::spec::PySpec;

/// A spec.
#[derive(FromPyObject)]
pub enum SpecArgument<'py> {
    /// The noun.
    Spec(Bound<'py, PySpec>),
    /// Its file.
    Path(PathBuf),
}

impl SpecArgument<'_> {
    /// What it says.
    pub fn spec(&self, py: Python<'_>) -> PyResult<Spec> {
        match self {
            Self::Spec(spec) => Ok(spec.get().spec.clone()),
            Self::Path(path) => py.detach(|| Spec::read(path)).python(),
        }
    }
}
