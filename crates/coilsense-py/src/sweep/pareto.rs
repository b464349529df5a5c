//! `coilsense.pareto` and `Pareto`: the designs of a sweep that no other beats.
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
use crate::json;
use crate::long_work::interruptible;
use crate::results::{laid_out, plain, save};

/// The designs of a sweep that no other beats; made by `pareto`. ``str()`` of it is what ``coilsense pareto`` prints.
///
/// The best in the first objective comes first.
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

#[pymethods]
impl PyPareto {
    /// The answer, a sentence each.
    #[getter]
    fn answer(&self) -> Vec<String> {
        answer(&self.study)
    }

    /// Numbers of the rows of the sweep that are on the front, shape (designs,).
    #[getter]
    fn rows<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        PyArray1::from_slice(py, &self.study.rows)
    }

    /// Titles of the objectives' columns, those to be minimized first.
    #[getter]
    fn objectives(&self) -> Vec<String> {
        self.study.question.objectives.iter().map(|objective| objective.title.clone()).collect()
    }

    /// The objectives of each design on the front, shape (designs, objectives).
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let shape = [self.study.rows.len(), self.study.question.objectives.len()];
        self.study.values.clone().into_pyarray(py).reshape(shape)
    }

    /// The row of the knee: the design with the least sum of objectives as shares of the front's ranges.
    #[getter]
    fn knee(&self) -> u64 {
        self.study.rows[self.study.knee]
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

    /// All columns of the designs on the front, by title: arrays of numbers, lists of texts and of truths.
    #[getter]
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        by_title(py, self.study.front.columns.iter().map(|(title, data)| (title.as_str(), data.clone())))
    }

    /// Writes what ``coilsense pareto --out`` writes: report.html, results.json, pareto.csv, pareto.parquet and figures; all of it or nothing.
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
        let dataset = Dataset::open(&self.folder).python()?;
        save(py, &folder, date, |date, output| add_pareto(&self.study, &dataset, date, output))
    }

    /// Everything, under the names of results.json.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        json::loads(py, pareto_json(&self.study))
    }

    /// All columns of the designs on the front as a data frame of pandas; ``pip install coilsense[pandas]``.
    ///
    /// Returns
    /// -------
    /// pandas.DataFrame
    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("coilsense._frames")?.call_method1("frame", (self.columns(py)?,))
    }

    fn __len__(&self) -> usize {
        self.study.rows.len()
    }

    fn __str__(&self) -> String {
        plain(&pareto_text(&self.study))
    }

    fn __repr__(&self) -> String {
        let (front, compared) = (self.study.rows.len(), self.study.counts.compared);
        format!("<Pareto of {}: {front} of {compared} designs, knee in row {}>", self.folder.display(), self.knee())
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        laid_out(slf.py(), "pareto_html", (slf,))
    }
}

/// The designs of a sweep that no other beats: none is as good in every objective and better in one.
///
/// Rows that clash or are refused, fail a condition, or lack a number for an objective are never on the front.
///
/// Parameters
/// ----------
/// sweep : SweepDataset, str or os.PathLike
///     A folder that `sweep` made; it may still be running.
/// minimize, maximize : sequence of str
///     Columns of which little or much is wanted, with or without their units: ``"F_o.rmsd"``, ``"mass"``, ``"f1"``. At least one.
/// where : sequence of str
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
#[pyfunction]
#[pyo3(signature = (sweep, *, minimize=Vec::new(), maximize=Vec::new(), r#where=Vec::new()))]
pub fn pareto(
    py: Python<'_>,
    sweep: Folder<'_>,
    minimize: Vec<String>,
    maximize: Vec<String>,
    r#where: Vec<String>,
) -> PyResult<PyPareto> {
    let folder = sweep.path();
    let of = folder.clone();
    let study = interruptible(py, move || {
        let dataset = Dataset::open(&of)?;
        let question = Question::new(dataset.plan(), &minimize, &maximize, &r#where)?;
        Study::of(&dataset, question)
    })?;
    Ok(PyPareto { study: Arc::new(study.python()?), folder })
}
