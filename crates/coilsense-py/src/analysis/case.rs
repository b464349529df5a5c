//! `coilsense.Case`: a condition under one damping, simulated.
//!
//! Next door: all of them judged (the parent).

use coilsense_lab::analysis::Case;
use coilsense_lab::spec::{SensorSpec, Spec};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::measures::{PyClash, PyDeviation};
use crate::results::table_and_figure;
use crate::series::frozen;
use crate::signals::PySignals;
use crate::value::getters;

/// A condition of a spec under one of its dampings, simulated; made by `simulate` and `analyze`.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> case = coilsense.simulate(spec)[0]
/// >>> case.condition, case.damping
/// ('heel strike', 'ζ = 0')
/// >>> case.deviations["F_o"].rmsd > case.deviations["F_x"].rmsd
/// True
#[pyclass(name = "Case", module = "coilsense", frozen)]
pub struct PyCase {
    condition: String,
    damping: String,
    signals: Py<PySignals>,
    readings: Py<PyDict>,
    forces: Py<PyDict>,
    deviations: Py<PyDict>,
    judged: (usize, usize),
    clash: coilsense::Clash,
    lengths: (f64, f64),
    contact: Option<Py<PyDict>>,
}

impl PyCase {
    /// A case moved to Python.
    pub fn of(py: Python<'_>, spec: &Spec, sensors: &[SensorSpec], case: Case) -> PyResult<Self> {
        let contact = case.contacts.as_ref().map(|contacts| super::contact::contact(py, contacts)).transpose()?;
        let (readings, forces, deviations) = (PyDict::new(py), PyDict::new(py), PyDict::new(py));
        for (channel, deviation) in &case.ideal {
            deviations.set_item(channel.name(), PyDeviation(*deviation).into_pyobject(py)?)?;
        }
        for (sensor, reading) in sensors.iter().zip(case.readings) {
            readings.set_item(&sensor.name, frozen(py, reading.native))?;
            forces.set_item(&sensor.name, frozen(py, reading.force))?;
            deviations.set_item(&sensor.name, PyDeviation(reading.deviation).into_pyobject(py)?)?;
        }
        Ok(Self {
            condition: spec.conditions[case.condition].name.clone(),
            damping: spec.mount.cases[case.damping].label.clone(),
            signals: Py::new(py, PySignals::of(py, case.signals))?,
            readings: readings.unbind(),
            forces: forces.unbind(),
            deviations: deviations.unbind(),
            judged: (case.judged.start, case.judged.end),
            clash: case.clash,
            lengths: case.lengths,
            contact: contact.map(Bound::unbind),
        })
    }
}

getters! {
    PyCase, self;
    /// The condition's name.
    condition: &str = &self.condition;
    /// The damping's label.
    damping: &str = &self.damping;
    /// u1, u2, F_i, F_o, F_x, F_L and L from t = 0 on.
    signals<'py>(py): Py<PySignals> = self.signals.clone_ref(py);
    /// What each sensor reads, in its native unit, as a dict of arrays by the sensor's name.
    readings<'py>(py): Py<PyDict> = self.readings.clone_ref(py);
    /// The force that each reading means [N], as a dict of arrays by the sensor's name.
    forces<'py>(py): Py<PyDict> = self.forces.clone_ref(py);
    /// Deviation of F_i, F_o, F_x, F_L and of each sensor's force from the true one [N] over the judged samples, as a dict.
    deviations<'py>(py): Py<PyDict> = self.deviations.clone_ref(py);
    /// How near the windings come.
    clash: PyClash = PyClash(self.clash);
    /// Shortest and longest length of the spring [m], as a tuple.
    lengths: (f64, f64) = self.lengths;
    /// What windings, ends and a follower did when they met or parted, in SI; None where the spec has no table [contact]. A dict: ``first_contact``,
    /// ``holds_until`` (None where nobody asked), ``until``, ``energy_lost``, ``least_cam_force`` (None without a follower), ``touches``, ``lifts`` and
    /// ``floats`` as dicts of arrays (durations are nan where something lasted to the end), ``meetings`` as a list of a dict for each pair of
    /// neighbours.
    contact<'py>(py): Option<Py<PyDict>> = self.contact.as_ref().map(|contact| contact.clone_ref(py));
}

table_and_figure! {
    PyCase;
    /// Channels and the forces that readings mean [N] as a data frame of pandas over time; ``pip install coilsense[pandas]``.
    to_pandas = "case_frame";
    /// Draws the forces over time with matplotlib; ``pip install coilsense[plot]``.
    plot = "forces_plot";
}

#[pymethods]
impl PyCase {
    /// The samples that are judged, as a slice.
    #[getter]
    fn judged<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, pyo3::types::PySlice>> {
        let bound = |sample: usize| isize::try_from(sample).unwrap_or(isize::MAX);
        Ok(pyo3::types::PySlice::new(py, bound(self.judged.0), bound(self.judged.1), 1))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let samples = self.signals.bind(py).get().samples(py);
        Ok(format!("<Case {}, {}: {samples} samples>", self.condition, self.damping))
    }
}
