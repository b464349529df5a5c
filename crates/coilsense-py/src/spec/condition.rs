//! `coilsense.Condition`: a condition of use in a spec.
//!
//! Next door: the spec (the parent), what is done to the spring (`excitation`).

use coilsense_lab::spec::ConditionSpec;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::excitation::PyExcitation;
use crate::value::{self, Arguments, getters};

/// A condition of use in a spec: what is done to the spring, for how long, and what of it is judged.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> spec.conditions[0].kind, spec.conditions[0].duration
/// ('impact', 1.0)
#[pyclass(name = "Condition", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyCondition(pub ConditionSpec);

getters! {
    PyCondition, self;
    /// Its name.
    name: &str = &self.0.name;
    /// The spec's word for what is done, such as "impact".
    kind: &str = self.0.kind;
    /// What is done to the spring.
    excitation: PyExcitation = PyExcitation(self.0.excitation.clone());
    /// How long it is simulated [s].
    duration: f64 = self.0.duration;
    /// From when to when it is judged [s], as a tuple.
    window: (f64, f64) = self.0.window;
    /// Samples per second [Hz].
    sample_rate: f64 = self.0.sample_rate;
}

#[pymethods]
impl PyCondition {
    /// What it is by name, the excitation as a dict.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("name", self.name())?;
        dict.set_item("kind", self.kind())?;
        dict.set_item("excitation", self.excitation().into_pyobject(py)?)?;
        dict.set_item("duration", self.duration())?;
        dict.set_item("window", self.window())?;
        dict.set_item("sample_rate", self.sample_rate())?;
        value::plain(&dict)
    }

    fn __repr__(&self) -> String {
        let condition = &self.0;
        format!(
            "<Condition {}: {}, {} s at {} Hz>",
            condition.name, condition.kind, condition.duration, condition.sample_rate
        )
    }
}
