//! `coilsense.rig`, `experiment` and `Experiment`: a test rig's logs, simulated, and an experiment of such logs processed.
//!
//! Next door: single logs (`recording`), the spec (`spec_argument`).

use std::path::PathBuf;
use std::sync::Arc;

use coilsense_lab::experiment::{Experiment, Findings};
use coilsense_lab::output::Output;
use coilsense_lab::recording::Cleaning;
use coilsense_lab::report::{add_experiment, experiment_json, experiment_text};
use coilsense_lab::rig::{Rig, RigError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::count::{Count, number};
use crate::errors::{IntoPython, OutputError, refused};
use crate::long_work::{interruptible, watched};
use crate::quantity::{Quantity, cleaning, given};
use crate::results::study_result;
use crate::spec_argument::SpecArgument;
use crate::value::getters;

/// An experiment with sines of rising frequency, processed; made by `experiment`. ``str()`` of it is what ``coilsense experiment`` prints.
///
/// Notes
/// -----
/// Source: [Weijde2017] section IV.
///
/// Examples
/// --------
/// >>> import coilsense, pathlib, tempfile
/// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
/// >>> settings = '\n[rig]\nfrequencies = 5\nduration = "8 s"\nreadings = 10\nhits = 1\n'
/// >>> folder = pathlib.Path(tempfile.mkdtemp()) / "rig"
/// >>> warnings = coilsense.rig(text + settings, folder, seed=3)
/// >>> found = coilsense.experiment(folder)
/// >>> found.simulated, round(found.stiffness)
/// (True, 760)
#[pyclass(name = "Experiment", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyExperiment(Arc<(Experiment, Findings)>);

getters! {
    PyExperiment, self;
    /// The answer, a sentence each.
    answer: Vec<String> = coilsense_lab::experiment::answer(&self.0.0, &self.0.1);
    /// The runs in recorded order, each a dict under the names of results.json: deviations of F_o from F_x, means of the forces.
    rows<'py>(py): PyResult<Bound<'py, PyAny>> = self.to_dict(py)?.get_item("runs");
    /// Where F_o and F_x part most: run, frequency_hz, and how many times its neighbours' the deviations are; None without a sine.
    peak<'py>(py): PyResult<Bound<'py, PyAny>> = self.to_dict(py)?.get_item("peak");
    /// How each force's mean changes over the experiment, a dict each under the names of results.json.
    drift<'py>(py): PyResult<Bound<'py, PyAny>> = self.to_dict(py)?.get_item("drift");
    /// Stiffness by the calibration run, or as it was given [N/m].
    stiffness: f64 = self.0.0.line.stiffness;
    /// F_nom, of which shares are taken [N].
    nominal_force: f64 = self.0.0.spec.nominal_force;
    /// Whether the data are simulated.
    simulated: bool = self.0.0.simulated;
}

study_result! {
    PyExperiment, self;
    /// Everything, under the names of results.json.
    to_dict = experiment_json(&self.0.0, &self.0.1, None);
    /// The runs as a data frame of pandas; ``pip install coilsense[pandas]``.
    to_pandas = "runs_frame";
    /// Draws the deviation of F_o from F_x over frequency with matplotlib; ``pip install coilsense[plot]``.
    plot = "experiment_plot";
    str = experiment_text(&self.0.0, &self.0.1);
    html = "experiment_html";
    /// Writes what ``coilsense experiment --out`` writes: report.html, results.json, figures; all of it or nothing.
    save(date, output) = add_experiment(&self.0.0, &self.0.1, date, output);
}

#[pymethods]
impl PyExperiment {
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

    fn __len__(&self) -> usize {
        self.0.0.runs.len()
    }

    fn __repr__(&self) -> String {
        let said = if self.simulated() { ", simulated" } else { "" };
        format!("<Experiment {}: {} runs{said}>", self.0.0.spec.file, self.__len__())
    }
}

fn unwritable(error: coilsense_lab::output::OutputError) -> PyErr {
    OutputError::new_err(crate::errors::in_python(error))
}

/// The logs of a simulated test rig: a folder that `experiment` processes, as it would those of a real one.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     Its spring, one damping in [mount], and what differs from the paper's rig in [rig].
/// out : str or os.PathLike
///     Folder for experiment.toml and two CSV files per run; its other files are left alone.
/// seed : int, optional
///     Seed of noise, of each instrument's own errors and of hits; without it, that of [uncertainty].
/// overwrite : bool
///     Whether files are replaced, too, that coilsense did not write or that have changed since.
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
///
/// Examples
/// --------
/// >>> import coilsense, pathlib, tempfile
/// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
/// >>> settings = '\n[rig]\nfrequencies = 5\nduration = "8 s"\nreadings = 10\nhits = 1\n'
/// >>> folder = pathlib.Path(tempfile.mkdtemp()) / "rig"
/// >>> warnings = coilsense.rig(text + settings, folder, seed=3)
/// >>> (folder / "experiment.toml").exists()
/// True
#[pyfunction]
#[pyo3(signature = (spec, out, seed=None, overwrite=false))]
pub fn rig(
    py: Python<'_>,
    spec: SpecArgument<'_>,
    out: PathBuf,
    seed: Option<Count>,
    overwrite: bool,
) -> PyResult<Vec<String>> {
    let (spec, seed) = (spec.spec(py)?, number(seed.as_ref(), "seed")?);
    let rig = Rig::new(&spec, seed.unwrap_or(spec.uncertainty.seed)).map_err(refused)?;
    let mut output = Output::begin(&out).map_err(unwritable)?.overwriting(overwrite);
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

/// An experiment of logs that an experiment.toml lists, processed: means, biases, drifts, and where F_o and F_x part.
///
/// Parameters
/// ----------
/// folder : str or os.PathLike
///     With experiment.toml; see book/src/guide/experiment.md.
/// drop_incomplete, sort, merge_repeated, unwrap, fill_gaps, resample, repair_up_to
///     What may be cleaned in each of its logs, as `open_log` takes it; by default nothing.
///
/// Returns
/// -------
/// Experiment
///
/// Raises
/// ------
/// Error
///     One line with file, row and column, or file, line and key.
///
/// Examples
/// --------
/// >>> import coilsense, pathlib, tempfile
/// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
/// >>> settings = '\n[rig]\nfrequencies = 5\nduration = "8 s"\nreadings = 10\nhits = 1\n'
/// >>> folder = pathlib.Path(tempfile.mkdtemp()) / "rig"
/// >>> warnings = coilsense.rig(text + settings, folder, seed=3)
/// >>> len(coilsense.experiment(folder)) == len(coilsense.experiment(folder).rows)
/// True
#[pyfunction]
#[pyo3(signature = (folder, *, drop_incomplete=false, sort=false, merge_repeated=false, unwrap=false, fill_gaps=None, resample=None,
                    repair_up_to=None))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per option of the command")]
pub fn experiment(
    py: Python<'_>,
    folder: PathBuf,
    drop_incomplete: bool,
    sort: bool,
    merge_repeated: bool,
    unwrap: bool,
    fill_gaps: Option<Quantity>,
    resample: Option<Quantity>,
    repair_up_to: Option<Quantity>,
) -> PyResult<PyExperiment> {
    let said = cleaning(drop_incomplete, sort, merge_repeated, unwrap, fill_gaps, resample, repair_up_to);
    let cleaning = Cleaning::of(&given(said)?);
    let experiment = interruptible(py, move || Experiment::read(&folder, &cleaning))?.python()?;
    let findings = Findings::of(&experiment);
    Ok(PyExperiment(Arc::new((experiment, findings))))
}
