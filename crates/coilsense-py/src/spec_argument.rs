//! A spec as an argument: the noun, its file, or its text.
//!
//! Next door: a spring alone (`spring_argument`).

use std::path::{Path, PathBuf};

use coilsense_lab::spec::Spec;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::spec::{PySpec, beside};

/// A spec.
#[derive(FromPyObject)]
pub enum SpecArgument<'py> {
    /// The noun.
    #[pyo3(annotation = "Spec")]
    Spec(Bound<'py, PySpec>),
    /// Its text where that holds a line break, else its file.
    #[pyo3(annotation = "str")]
    Text(String),
    /// Its file.
    #[pyo3(annotation = "os.PathLike")]
    Path(PathBuf),
}

impl SpecArgument<'_> {
    /// What it says.
    pub fn spec(&self, py: Python<'_>) -> PyResult<Spec> {
        match self {
            Self::Spec(spec) => Ok(spec.get().spec.clone()),
            Self::Text(text) if text.contains('\n') => py.detach(|| Spec::parse("spec", text, &beside(None))).python(),
            Self::Text(path) => py.detach(|| Spec::read(Path::new(path))).python(),
            Self::Path(path) => py.detach(|| Spec::read(path)).python(),
        }
    }
}
