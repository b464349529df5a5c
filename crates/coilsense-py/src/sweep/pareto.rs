//! `coilsense.pareto` and `Pareto`: the designs of a sweep on the Pareto front.
//!
//! Next door: what its numbers hang on (`sensitivity`), the folder (`dataset`).

use std::path::PathBuf;
use std::sync::Arc;

use coilsense_lab::pareto::{Question, Study, answer};
use coilsense_lab::report::{add_pareto, pareto_json, pareto_text};
use coilsense_lab::sweep::Dataset;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::{Folder, by_title};
use crate::errors::IntoPython;
use crate::long_work::interruptible;
use crate::names::{Names, listed};
use crate::results::study_result;
use crate::value::getters;

/// The designs of a sweep on the Pareto front; made by `pareto`. ``str()`` of it is what ``coilsense pareto`` prints.
///
/// The best in the first objective comes first.
///
/// Examples
/// --------
/// >>> import coilsense, tempfile
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> over = {"spring.stiffness [N/m]": [600, 700, 800], "spring.mass [kg]": [0.06, 0.065]}
/// >>> designs = coilsense.sweep(spec, over, tempfile.mkdtemp(), columns=["f1", "nominal_force"])
/// >>> front = coilsense.pareto(designs, minimize="nominal_force", maximize="f1")
/// >>> front.knee in front.rows, front.values.shape == (len(front), 2)
/// (True, True)
#[pyclass(name = "Pareto", module = "coilsense", frozen, eq)]
pub struct PyPareto {
    study: Arc<Study>,
    folder: PathBuf,
}

impl PartialEq for PyPareto {
    fn eq(&self, other: &Self) -> bool {
        self.study == other.study
    }
}

getters! {
    PyPareto, self;
    /// The answer, a sentence each.
    answer: Vec<String> = answer(&self.study);
    /// Numbers of the rows of the sweep that are on the front, shape (designs,).
    rows<'py>(py): Bound<'py, PyArray1<u64>> = PyArray1::from_slice(py, &self.study.rows);
    /// Titles of the objectives' columns, those to be minimized first.
    objectives: Vec<String> = self.study.question.objectives.iter().map(|objective| objective.title.clone()).collect();
    /// The row of the knee: the design with the least sum of objectives as shares of the front's ranges.
    knee: u64 = self.study.rows[self.study.knee];
    /// All columns of the designs on the front, by title: arrays of numbers, lists of texts and of truths.
    columns<'py>(py): PyResult<Bound<'py, PyDict>> =
        by_title(py, self.study.front.columns.iter().map(|(title, data)| (title.as_str(), data.clone())));
}

study_result! {
    PyPareto, self;
    /// Everything, under the names of results.json.
    to_dict = pareto_json(&self.study);
    /// All columns of the designs on the front as a data frame of pandas; ``pip install coilsense[pandas]``.
    to_pandas = "front_frame";
    /// Draws the front in its first two objectives with matplotlib; ``pip install coilsense[plot]``.
    plot = "pareto_plot";
    str = pareto_text(&self.study);
    html = "pareto_html";
    /// Writes what ``coilsense pareto --out`` writes: report.html, results.json, pareto.csv, pareto.parquet and figures; all of it or nothing.
    save(date, output; dataset = Dataset::open(&self.folder).python()?) = add_pareto(&self.study, &dataset, date, output);
}

#[pymethods]
impl PyPareto {
    /// The objectives of each design on the front, shape (designs, objectives).
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let shape = [self.study.rows.len(), self.study.question.objectives.len()];
        self.study.values.clone().into_pyarray(py).reshape(shape)
    }

    /// The row of the best design in each objective, by its title.
    #[getter]
    fn extremes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (objective, place) in self.study.question.objectives.iter().zip(&self.study.extremes) {
            dict.set_item(&objective.title, self.study.rows[*place])?;
        }
        Ok(dict)
    }

    fn __len__(&self) -> usize {
        self.study.rows.len()
    }

    fn __repr__(&self) -> String {
        let (front, compared) = (self.study.rows.len(), self.study.counts.compared);
        format!("<Pareto of {}: {front} of {compared} designs, knee in row {}>", self.folder.display(), self.knee())
    }
}

/// The Pareto front of a sweep: designs that cannot be improved in one objective without a loss in another.
///
/// Never on the front are rows in which windings would touch, that could not be judged, that fail a condition, or that lack a number for an objective.
///
/// Parameters
/// ----------
/// sweep : SweepDataset, str or os.PathLike
///     A folder that `sweep` made; it may still be running.
/// minimize, maximize : str or sequence of str, optional
///     Columns of which little or much is wanted, with or without their units: ``"F_o.rmsd"``, ``"mass"``, ``"f1"``. At least one.
/// where : str or sequence of str, optional
///     What a design has to meet: ``"mass < 100 g"``, ``"worst = \"resonance\""``, ``"laser.meets = yes"``.
///
/// Returns
/// -------
/// Pareto
///
/// Raises
/// ------
/// SweepError
///     For a column that is not there or holds no numbers, a condition that says nothing, and where no row is left to compare.
///
/// Examples
/// --------
/// >>> import coilsense, tempfile
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> over = {"spring.stiffness [N/m]": [600, 700, 800], "spring.mass [kg]": [0.06, 0.065]}
/// >>> designs = coilsense.sweep(spec, over, tempfile.mkdtemp(), columns=["f1", "nominal_force"])
/// >>> front = coilsense.pareto(designs, minimize="nominal_force", maximize="f1")
/// >>> len(front), front.objectives
/// (3, ['nominal_force [N]', 'f1 [Hz]'])
#[pyfunction]
#[pyo3(signature = (sweep, *, minimize=None, maximize=None, r#where=None))]
pub fn pareto(
    py: Python<'_>,
    sweep: Folder<'_>,
    minimize: Option<Names>,
    maximize: Option<Names>,
    r#where: Option<Names>,
) -> PyResult<PyPareto> {
    let folder = sweep.path()?;
    let (minimize, maximize) = (listed(minimize, "minimize")?, listed(maximize, "maximize")?);
    let r#where = listed(r#where, "where")?;
    let of = folder.clone();
    let study = interruptible(py, move || {
        let dataset = Dataset::open(&of)?;
        let question = Question::new(dataset.plan(), &minimize, &maximize, &r#where)?;
        Study::of(&dataset, question)
    })?;
    Ok(PyPareto { study: Arc::new(study.python()?), folder })
}
