//! A spring that is known beforehand, as an argument: a noun, or a spec or its file.
//!
//! Next door: the nouns (`spring`, `spec`).

use std::path::PathBuf;

use coilsense::Spring;
use coilsense_lab::identification::Expected;
use coilsense_lab::spec::SpringSpec;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::quantity::{Anything, neither};
use crate::spec::PySpec;
use crate::spring::PySpring;

/// A spring, or a spec that has one.
#[derive(FromPyObject)]
pub enum SpringArgument<'py> {
    /// The noun.
    Spring(Bound<'py, PySpring>),
    /// A spec.
    Spec(Bound<'py, PySpec>),
    /// A spec's file, of which only the table `[spring]` is read.
    Path(PathBuf),
    /// Something else.
    Other(Anything),
}

/// What is known of it.
pub struct Known {
    /// The spring.
    pub spring: Spring,
    /// How far the stiffness may be off, either way, as a share \[1\].
    pub stiffness_tolerance: f64,
    /// How far the rest length may be off, either way \[m\].
    pub rest_length_tolerance: f64,
}

impl SpringArgument<'_> {
    /// What it lets expect of a log.
    pub fn expected(&self) -> PyResult<Expected> {
        match self {
            Self::Spec(spec) => Ok(Expected::of_spec(&spec.get().spec.spring)),
            Self::Path(path) => Ok(Expected::of_spec(&SpringSpec::read(path).python()?)),
            Self::Spring(_) | Self::Other(_) => Ok(Expected::of_spring(&self.known()?.spring)),
        }
    }

    /// The spring and its tolerances; a noun has none.
    pub fn known(&self) -> PyResult<Known> {
        match self {
            Self::Spring(spring) => {
                Ok(Known { spring: spring.get().0.clone(), stiffness_tolerance: 0.0, rest_length_tolerance: 0.0 })
            }
            Self::Spec(spec) => Ok(of_spec(&spec.get().spec.spring)),
            Self::Path(path) => Ok(of_spec(&SpringSpec::read(path).python()?)),
            Self::Other(object) => Err(neither("spring", "a Spring, a Spec or its file", object)),
        }
    }
}

fn of_spec(spec: &SpringSpec) -> Known {
    Known {
        spring: spec.spring.clone(),
        stiffness_tolerance: spec.stiffness_tolerance(),
        rest_length_tolerance: spec.rest_length_tolerance(),
    }
}
