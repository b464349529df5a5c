//! `coilsense.rig`, `experiment` and `Experiment`: a test rig's logs, simulated, and an experiment of such logs worked off.
//!
//! Next door: single logs (`recording`), the spec (`spec_argument`).

use std::path::PathBuf;
use std::sync::Arc;

use coilsense_lab::experiment::{Experiment, Findings};
use coilsense_lab::output::Output;
use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::Repairs;
use coilsense_lab::report::{add_experiment, experiment_json, experiment_text};
use coilsense_lab::rig::{Rig, RigError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{OutputError, refused};
use crate::json;
use crate::long_work::{interruptible, watched};
use crate::quantity::{Quantity, positive, rate};
use crate::results::{laid_out, plain, save};
use crate::spec_argument::SpecArgument;

/// Adds class and functions to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyExperiment>()?;
    module.add_function(wrap_pyfunction!(rig, module)?)?;
    module.add_function(wrap_pyfunction!(experiment, module)?)
}

/// An experiment with sines of rising frequency, worked off; made by `experiment`. ``str()`` of it is what ``coilsense experiment`` prints.
///
/// Notes
/// -----
/// Source: [Weijde2017] section IV.
#[pyclass(name = "Experiment", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyExperiment(Arc<(Experiment, Findings)>);

#[pymethods]
impl PyExperiment {
    /// The answer, a sentence each.
    #[getter]
    fn answer(&self) -> Vec<String> {
        coilsense_lab::experiment::answer(&self.0.0, &self.0.1)
    }

    /// The runs in recorded order, each a dict under the names of results.json: deviations of F_o from F_x, means of the forces.
    #[getter]
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.to_dict(py)?.get_item("runs")
    }

    /// Where F_o and F_x part most: run, frequency_hz, and how many times its neighbours' the deviations are; None without a sine.
    #[getter]
    fn peak<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.to_dict(py)?.get_item("peak")
    }

    /// Mean forces against those of the runs before and after: a dict of run, force, value [N], standard_error [N], and whether it is seen.
    #[getter]
    fn biases<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let (experiment, findings) = (&self.0.0, &self.0.1);
        let one = |(run, force, offset): &(usize, coilsense::Channel, coilsense_lab::experiment::Offset)| {
            let dict = PyDict::new(py);
            dict.set_item("run", &experiment.runs[*run].spec.name)?;
            dict.set_item("frequency", experiment.runs[*run].spec.frequency)?;
            dict.set_item("force", force.name())?;
            dict.set_item("value", offset.value)?;
            dict.set_item("standard_error", offset.error)?;
            dict.set_item("seen", offset.is_seen())?;
            Ok(dict)
        };
        findings.offsets.iter().map(one).collect()
    }

    /// How each force's mean changes over the experiment, a dict each under the names of results.json.
    #[getter]
    fn drift<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.to_dict(py)?.get_item("drift")
    }

    /// Stiffness by the calibration run, or as it was given [N/m].
    #[getter]
    fn stiffness(&self) -> f64 {
        self.0.0.line.stiffness
    }

    /// F_nom, of which shares are taken [N].
    #[getter]
    fn nominal_force(&self) -> f64 {
        self.0.0.spec.nominal_force
    }

    /// Whether the data are simulated.
    #[getter]
    fn simulated(&self) -> bool {
        self.0.0.simulated
    }

    /// Writes what ``coilsense experiment --out`` writes: report.html, results.json, figures; all of it or nothing.
    ///
    /// Parameters
    /// ----------
    /// folder : str or os.PathLike
    ///     Its other files are left alone.
    /// date : str, optional
    ///     What the report carries; without it, today's.
    ///
    /// Returns
    /// -------
    /// int
    ///     How many files.
    #[pyo3(signature = (folder, date=None))]
    fn save(&self, py: Python<'_>, folder: PathBuf, date: Option<String>) -> PyResult<usize> {
        save(py, &folder, date, |date, output| add_experiment(&self.0.0, &self.0.1, date, output))
    }

    /// Everything, under the names of results.json.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        json::loads(py, experiment_json(&self.0.0, &self.0.1, None))
    }

    /// The runs as a data frame of pandas; ``pip install coilsense[pandas]``.
    ///
    /// Returns
    /// -------
    /// pandas.DataFrame
    fn to_pandas<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        laid_out(slf.py(), "runs_frame", (slf,))
    }

    /// Draws the deviation of F_o from F_x over frequency with matplotlib; ``pip install coilsense[plot]``.
    ///
    /// Parameters
    /// ----------
    /// axes : matplotlib.axes.Axes, optional
    ///     Where; without it, in a new figure.
    ///
    /// Returns
    /// -------
    /// matplotlib.axes.Axes
    #[pyo3(signature = (axes=None))]
    fn plot<'py>(slf: &Bound<'py, Self>, axes: Option<Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        laid_out(slf.py(), "experiment_plot", (slf, axes))
    }

    fn __len__(&self) -> usize {
        self.0.0.runs.len()
    }

    fn __str__(&self) -> String {
        plain(&experiment_text(&self.0.0, &self.0.1))
    }

    fn __repr__(&self) -> String {
        let said = if self.simulated() { ", simulated" } else { "" };
        format!("<Experiment {}: {} runs{said}>", self.0.0.spec.file, self.__len__())
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        laid_out(slf.py(), "experiment_html", (slf,))
    }
}

fn unwritable(error: coilsense_lab::output::OutputError) -> PyErr {
    OutputError::new_err(error.to_string())
}

/// The logs of a simulated test rig: a folder that `experiment` works off, as it would those of a real one.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     Its spring, one damping in [mount], and what differs from the paper's rig in [rig].
/// out : str or os.PathLike
///     Folder for experiment.toml and two CSV files per run; its other files are left alone.
/// seed : int, optional
///     Seed of noise, of each instrument's own errors and of hits; without it, that of [uncertainty].
///
/// Returns
/// -------
/// list of str
///     What a reader must know before using the files.
///
/// Raises
/// ------
/// Error
///     For settings that do not fit spring, instruments or each other, or a folder that cannot be written; nothing is written then.
#[pyfunction]
#[pyo3(signature = (spec, out, seed=None))]
fn rig(py: Python<'_>, spec: SpecArgument<'_>, out: PathBuf, seed: Option<u64>) -> PyResult<Vec<String>> {
    let spec = spec.spec(py)?;
    let rig = Rig::new(&spec, seed.unwrap_or(spec.uncertainty.seed)).map_err(refused)?;
    let mut output = Output::begin(&out).map_err(unwritable)?;
    let written = watched(py, None, |progress| rig.write(&mut output, progress))?;
    if let Err(error) = written {
        return Err(match error {
            RigError::Interrupted => pyo3::exceptions::PyKeyboardInterrupt::new_err(()),
            other => refused(other),
        });
    }
    output.commit().map_err(unwritable)?;
    Ok(rig.warnings().to_vec())
}

/// An experiment of logs that an experiment.toml lists, worked off: means, biases, drifts, and where F_o and F_x part.
///
/// Parameters
/// ----------
/// folder : str or os.PathLike
///     With experiment.toml; see book/src/guide/experiment.md.
/// drop_incomplete, sort, merge_repeated, fill_gaps, resample
///     What may be mended in each of its logs, as `open_log` takes it; by default nothing.
///
/// Returns
/// -------
/// Experiment
///
/// Raises
/// ------
/// Error
///     One line with file, row and column, or file, line and key.
#[pyfunction]
#[pyo3(signature = (folder, *, drop_incomplete=false, sort=false, merge_repeated=false, fill_gaps=None, resample=None))]
fn experiment(
    py: Python<'_>,
    folder: PathBuf,
    drop_incomplete: bool,
    sort: bool,
    merge_repeated: bool,
    fill_gaps: Option<Quantity>,
    resample: Option<Quantity>,
) -> PyResult<PyExperiment> {
    let repairs = Repairs {
        drop_incomplete,
        sort,
        merge_repeated,
        fill_gaps: positive(fill_gaps.as_ref(), "fill_gaps", Dimension::Time)?,
        resample: rate(resample.as_ref(), "resample")?,
        ..Repairs::default()
    };
    let experiment = interruptible(py, move || Experiment::read(&folder, &repairs))?.map_err(refused)?;
    let findings = Findings::of(&experiment);
    Ok(PyExperiment(Arc::new((experiment, findings))))
}
