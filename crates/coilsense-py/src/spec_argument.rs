//! A spec as an argument: the noun, its file, or its text.
//!
//! Next door: a spring alone (`spring_argument`).

use std::path::{Path, PathBuf};

use coilsense_lab::spec::Spec;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::quantity::{Anything, neither};
use crate::spec::{PySpec, beside};

/// A spec.
#[derive(FromPyObject)]
pub enum SpecArgument<'py> {
    /// The noun.
    Spec(Bound<'py, PySpec>),
    /// Its text where that holds a line break, else its file.
    Text(String),
    /// Its file.
    Path(PathBuf),
    /// Something else.
    Other(Anything),
}

impl SpecArgument<'_> {
    /// What it says.
    pub fn spec(&self, py: Python<'_>) -> PyResult<Spec> {
        match self {
            Self::Spec(spec) => Ok(spec.get().spec.clone()),
            Self::Text(text) if text.contains('\n') => py.detach(|| Spec::parse("spec", text, &beside(None))).python(),
            Self::Text(path) => py.detach(|| Spec::read(Path::new(path))).python(),
            Self::Path(path) => py.detach(|| Spec::read(path)).python(),
            Self::Other(object) => Err(neither("spec", "a Spec, its file or its text", object)),
        }
    }
}
