//! `coilsense.speed` and `SpeedMap`: up to which speed of the engine a spring follows its cam.
//!
//! Next door: the spec, whose tables `[cam]` and `[contact]` say what turns and what meets (`spec_argument`).

use std::sync::Arc;

use coilsense_lab::quantity::Dimension::Frequency;
use coilsense_lab::report::{add_speed, speed_columns, speed_json, speed_text};
use coilsense_lab::speed::{Range, SpeedMap, answer};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::refused;
use crate::long_work::watched;
use crate::quantity::Quantity;
use crate::results::study_result;
use crate::series::frozen;
use crate::spec_argument::SpecArgument;
use crate::value::getters;

/// A spring under a cam at each speed of the engine; made by `speed`. ``str()`` of it is what ``coilsense speed`` prints.
#[pyclass(name = "SpeedMap", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PySpeedMap(Arc<SpeedMap>);

getters! {
    PySpeedMap, self;
    /// The answer, a sentence each.
    answer: Vec<String> = answer(&self.0);
    /// The cam, in words.
    cam: &str = &self.0.cam.words;
    /// Each damping and rebound by its label, in the order of the spec.
    cases: Vec<&str> = self.0.spec.mount.cases.iter().map(|case| case.label.as_str()).collect();
    /// Frequencies that do not move with the speed [Hz], as (name, frequency): the first surge frequencies, the first torsional and lateral one.
    lines: Vec<(&str, f64)> = self.0.campbell.lines.iter().map(|line| (line.name.as_str(), line.frequency)).collect();
    /// Where a harmonic of the cam has the first surge frequency, as (harmonic, speed of the engine [Hz], its lift [m]).
    crossings: Vec<(usize, f64, f64)> = self.0.campbell.crossings.iter().map(|at| (at.harmonic, at.speed, at.amplitude)).collect();
}

study_result! {
    PySpeedMap, self;
    /// Everything, under the names of results.json; None stands for what does not apply.
    to_dict = speed_json(&self.0);
    /// A row for each run as a data frame of pandas, in SI; ``pip install coilsense[pandas]``.
    to_pandas = "speeds_frame";
    /// Draws largest and least force at end 1 over the speed with matplotlib; ``pip install coilsense[plot]``.
    plot = "speed_plot";
    str = speed_text(&self.0);
    html = "speed_html";
    /// Writes what ``coilsense speed --out`` writes: report.html, results.json, speed.csv and speed.parquet; all of it or nothing.
    save(date, output) = add_speed(&self.0, date, output);
}

#[pymethods]
impl PySpeedMap {
    /// The runs of each case by rising speed: a dict by the case's label of dicts of arrays in SI, ``speed_hz`` first; nan where a figure does not apply.
    #[getter]
    fn runs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (way, case) in self.0.spec.mount.cases.iter().enumerate() {
            let columns = PyDict::new(py);
            for (key, values) in speed_columns(&self.0, way) {
                columns.set_item(key, frozen(py, values))?;
            }
            dict.set_item(&case.label, columns)?;
        }
        Ok(dict)
    }

    /// Amplitudes of F_o's harmonics of the camshaft in each case [N]: a dict by the case's label of lists, one a speed, of amplitudes from the first
    /// harmonic on.
    #[getter]
    fn harmonics<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (way, case) in self.0.spec.mount.cases.iter().enumerate() {
            let each: Vec<&[f64]> = self.0.of_way(way).map(|point| point.harmonics.as_slice()).collect();
            dict.set_item(&case.label, each)?;
        }
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        format!("<SpeedMap of {}: {} runs in {} cases>", self.0.spec.file, self.0.points.len(), self.cases().len())
    }
}

/// A spring under a cam from speed to speed: forces, surge, windings that meet, a follower that floats.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     Its table [cam] says what moves end 1, [contact] what windings do when they meet.
/// from_ : float or str
///     Lowest speed of the engine [Hz].
/// to : float or str
///     Highest speed of the engine [Hz].
/// step : float or str, optional
///     From speed to speed [Hz]; 100 rpm without it. More are added about those at which a harmonic of the cam has the first surge frequency.
/// cam_ratio : float, optional
///     Turns of the camshaft for one of the engine.
/// progress : callable, optional
///     Called as ``progress(done, of)`` now and then; an exception of it stops the work.
///
/// Returns
/// -------
/// SpeedMap
///
/// Raises
/// ------
/// SpecError
///     For a spec that cannot be read.
/// Error
///     For a spec without [cam] or [contact], a range that is none, or what the science refuses at a speed.
#[pyfunction]
#[pyo3(signature = (spec, from_, to, *, step=Quantity::Number(100.0 / 60.0), cam_ratio=Quantity::Number(0.5), progress=None),
       text_signature = "(spec, from_, to, *, step=1.6666666666666667, cam_ratio=0.5, progress=None)")]
pub fn speed(
    py: Python<'_>,
    spec: SpecArgument<'_>,
    from_: Quantity,
    to: Quantity,
    step: Quantity,
    cam_ratio: Quantity,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<PySpeedMap> {
    let spec = spec.spec(py)?;
    let range = Range {
        from: from_.si("from_", Frequency)?,
        to: to.si("to", Frequency)?,
        step: step.si("step", Frequency)?,
        ratio: cam_ratio.plain("cam_ratio")?,
    };
    let map = watched(py, progress.as_ref(), |progress| SpeedMap::of(spec, range, progress))?.map_err(refused)?;
    Ok(PySpeedMap(Arc::new(map)))
}
