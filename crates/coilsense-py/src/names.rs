//! Names from Python: one, or several.
//!
//! Next door: series of numbers (`series`).

use pyo3::prelude::*;

/// A text, or a sequence of texts.
#[derive(FromPyObject)]
pub enum Names {
    /// One.
    #[pyo3(annotation = "str")]
    One(String),
    /// Several.
    #[pyo3(annotation = "sequence of str")]
    Several(Vec<String>),
}

impl Names {
    /// As a list.
    pub fn listed(self) -> Vec<String> {
        match self {
            Self::One(name) => vec![name],
            Self::Several(names) => names,
        }
    }
}

/// The names of an argument that may be left out.
pub fn listed(names: Option<Names>) -> Vec<String> {
    names.map_or_else(Vec::new, Names::listed)
}
