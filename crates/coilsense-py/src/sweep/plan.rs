//! `coilsense.SweepPlan`.
//!
//! Next door: the folder that its rows go into (`dataset`).

use std::path::PathBuf;
use std::sync::Arc;

use coilsense_lab::sweep::{Catalogue, Plan, PlanParameters, Sampling};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyTuple, PyType};

use super::by_title;
use crate::count::{Count, number};
use crate::errors::{IntoPython, SweepError, unknown};
use crate::json;
use crate::long_work::watched_in;
use crate::names::{Names, Word, listed};
use crate::quantity::{Anything, neither};
use crate::spec::{PySpec, beside};
use crate::threads::{self, spread};
use crate::value::getters;

/// All that decides the rows of a sweep.
///
/// A row is a function of the plan and its number: the same whichever chunk, thread or machine computes it.
///
/// Parameters
/// ----------
/// spec : Spec, path-like, or str
///     The spec whose values are varied: itself, a file, or its text where that holds a line break.
/// over : sequence of str
///     What is varied, ``"KEY=VALUES"`` each: ``"spring.stiffness=600..900 N/m"``, ``"mount.damping_ratio=log 1e-3..5e-2"``.
/// catalogue : path-like, or tuple of (list of str, list of list of str), optional
///     A table whose titles are keys and whose rows are designs: a CSV or Parquet file, or its titles and rows.
/// sampling : {"grid", "lhs", "monte-carlo", "sobol", "saltelli"}, optional
///     How rows are laid; without it a grid where all variables have points, else a Latin hypercube.
/// rows : int, optional
///     How many rows, for each of the catalogue where there is one; a grid has its own number.
/// seed : int
///     Of all randomness.
/// columns : sequence of str, optional
///     What is recorded: ``"mass"``, ``"F_o.rmsd"``, ``"F_o.max[heel strike]"``, ``"laser.combined"`` ...
/// chunk : int, optional
///     Rows of a file; without it by how long a row takes.
///
/// Raises
/// ------
/// SweepError
///     For a key, a value or a column that cannot be, in one line.
///
/// Notes
/// -----
/// Source: the same words as those of the command ``coilsense sweep``; see book/src/guide/sweep.md.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spec = '''
/// ... [spring]
/// ... name = "S_T"
/// ... model = "chain"
/// ... rest_length = "104 mm"
/// ... windings = 52
/// ... coil_radius = "8 mm"
/// ... wire_radius = "1 mm"
/// ... mass = "65 g"
/// ... stiffness = "760 N/m"
/// ... min_length = "196 mm"
/// ... max_length = "264 mm"
/// ... '''
/// >>> plan = coilsense.SweepPlan(spec, ["spring.stiffness=600..900 N/m : 4"], columns=["f1"])
/// >>> plan.rows
/// 4
/// >>> plan.chunk(0)["f1 [Hz]"].round(2)
/// array([48.04, 51.89, 55.47, 58.83])
#[pyclass(name = "SweepPlan", module = "coilsense", frozen, eq)]
pub struct PySweepPlan(pub Plan);

impl PartialEq for PySweepPlan {
    fn eq(&self, other: &Self) -> bool {
        self.0.parameters() == other.0.parameters()
    }
}

/// A spec: where it is, or what it says.
#[derive(FromPyObject)]
enum Source<'py> {
    Spec(PyRef<'py, PySpec>),
    Text(String),
    Path(PathBuf),
    Other(Anything),
}

impl Source<'_> {
    fn read(self, parameters: PlanParameters) -> PyResult<PlanParameters> {
        let read = match self {
            Self::Spec(spec) => parameters.with_text(&spec.spec.file, &spec.spec.text, &beside(spec.folder.as_deref())),
            Self::Text(text) if text.contains('\n') => parameters.with_text("spec", &text, &beside(None)),
            Self::Text(path) => parameters.with_spec(path.as_ref()),
            Self::Path(path) => parameters.with_spec(&path),
            Self::Other(object) => return Err(neither("spec", "a Spec, its file or its text", &object)),
        };
        read.python()
    }
}

/// A table of designs: what it says, or where it is.
#[derive(FromPyObject)]
enum Table {
    Cells(Vec<String>, Vec<Vec<String>>),
    Path(PathBuf),
    Other(Anything),
}

impl Table {
    fn read(self) -> PyResult<Catalogue> {
        match self {
            Self::Cells(titles, rows) => Ok(Catalogue { titles, rows }),
            Self::Path(path) => Catalogue::read(&path).python(),
            Self::Other(object) => {
                let wanted = "a data frame, the path of a table, or a tuple of its titles and its rows of texts";
                Err(neither("catalogue", wanted, &object))
            }
        }
    }
}

getters! {
    PySweepPlan, self;
    /// How many rows there are.
    rows: u64 = self.0.rows();
    /// How many chunks they fall into.
    chunks: u64 = self.0.chunks();
    /// Titles of all columns, in order, each with its unit in brackets where it holds numbers.
    titles: Vec<String> = self.0.titles();
    /// SHA-256 of all that decides the rows, in hexadecimal digits: of a spec its keys and their values, not its name, its comments or the order of its
    /// keys.
    digest: String = self.0.digest();
}

#[pymethods]
impl PySweepPlan {
    #[new]
    #[pyo3(signature = (spec, over=None, *, catalogue=None, sampling=None, rows=None, seed=Count::Number(0), columns=None, chunk=None),
           text_signature = "(spec, over=None, *, catalogue=None, sampling=None, rows=None, seed=0, columns=None, chunk=None)")]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per option of the command")]
    fn new(
        py: Python<'_>,
        spec: Source<'_>,
        over: Option<Names>,
        catalogue: Option<Table>,
        sampling: Option<Word>,
        rows: Option<Count>,
        seed: Count,
        columns: Option<Names>,
        chunk: Option<Count>,
    ) -> PyResult<Self> {
        let sampling = sampling.as_ref().map(|word| named(word.text("sampling")?)).transpose()?;
        let catalogue = catalogue.map(Table::read).transpose()?;
        let parameters = PlanParameters {
            over: listed(over, "over")?,
            catalogue,
            sampling,
            rows: number(rows.as_ref(), "rows")?,
            seed: seed.number("seed")?,
            columns: listed(columns, "columns")?,
            chunk_rows: number(chunk.as_ref(), "chunk")?,
            ..PlanParameters::default()
        };
        let parameters = spec.read(parameters)?;
        spread(py, || Plan::new(parameters))?.python().map(Self)
    }

    /// The plan of a text that :meth:`to_json` made.
    ///
    /// Parameters
    /// ----------
    /// text : str
    ///     JSON.
    ///
    /// Returns
    /// -------
    /// SweepPlan
    ///
    /// Raises
    /// ------
    /// SweepError
    ///     Where it is none.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> plan = coilsense.SweepPlan(spec, "spring.stiffness=600..900 N/m : 4", columns="f1")
    /// >>> coilsense.SweepPlan.from_json(plan.to_json()) == plan
    /// True
    #[staticmethod]
    fn from_json(text: &str) -> PyResult<Self> {
        Plan::from_json(text).python().map(Self)
    }

    /// All of it as a text that makes the same plan anywhere.
    ///
    /// Returns
    /// -------
    /// str
    ///     JSON.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> plan = coilsense.SweepPlan(spec, "spring.stiffness=600..900 N/m : 4", columns="f1")
    /// >>> len(plan.to_json()) > 100
    /// True
    fn to_json(&self) -> String {
        self.0.to_json()
    }

    /// All of it by name, with what was left open filled in.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        json::loads(py, Ok::<_, coilsense::Error>(self.0.to_json()))
    }

    /// The spec of a row: the author's text with the row's values in it.
    ///
    /// Parameters
    /// ----------
    /// row : int
    ///     Its number, counted from 0.
    ///
    /// Returns
    /// -------
    /// str
    ///     TOML, comments and all.
    ///
    /// Raises
    /// ------
    /// SweepError
    ///     For a row that is not there.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> plan = coilsense.SweepPlan(spec, "spring.stiffness=600..900 N/m : 4", columns="f1")
    /// >>> coilsense.Spec.parse(plan.spec_of(0)).spring.stiffness
    /// 600.0
    fn spec_of(&self, row: Count) -> PyResult<String> {
        self.0.spec_of(row.number("row")?).python()
    }

    /// Numbers of the rows of a chunk.
    ///
    /// Parameters
    /// ----------
    /// index : int
    ///     Of the chunk, from 0.
    ///
    /// Returns
    /// -------
    /// range
    ///     Empty for a chunk that is not there.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> plan = coilsense.SweepPlan(spec, "spring.stiffness=600..900 N/m : 4", columns="f1")
    /// >>> plan.rows_of(0)
    /// range(0, 4)
    fn rows_of<'py>(&self, py: Python<'py>, index: Count) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.0.rows_of(index.number("index")?);
        py.import("builtins")?.getattr("range")?.call1((rows.start, rows.end))
    }

    /// Computes the rows of a chunk.
    ///
    /// Parameters
    /// ----------
    /// index : int
    ///     Of the chunk, from 0.
    /// jobs : int, optional
    ///     Threads; without it as many as there are cores.
    ///
    /// Returns
    /// -------
    /// dict
    ///     Columns by title: arrays of numbers (NaN where a design was refused), lists of texts and truths.
    ///
    /// Raises
    /// ------
    /// SweepError
    ///     For a chunk that is not there.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> plan = coilsense.SweepPlan(spec, "spring.stiffness=600..900 N/m : 4", columns="f1")
    /// >>> plan.chunk(0)["f1 [Hz]"].round(1)
    /// array([48. , 51.9, 55.5, 58.8])
    #[pyo3(signature = (index, jobs=None))]
    fn chunk<'py>(&self, py: Python<'py>, index: Count, jobs: Option<Count>) -> PyResult<Bound<'py, PyDict>> {
        let index = index.number("index")?;
        let chunk = self.worked_off(py, jobs, |plan, go_on| plan.chunk(index, go_on))?;
        by_title(py, chunk.columns.iter().map(|(title, data)| (title.as_str(), data.clone())))
    }

    /// Computes the rows of a chunk as the bytes of their Parquet file.
    ///
    /// Parameters
    /// ----------
    /// index : int
    ///     Of the chunk, from 0.
    /// jobs : int, optional
    ///     Threads; without it as many as there are cores. The bytes are the same for any number.
    ///
    /// Returns
    /// -------
    /// bytes
    ///
    /// Raises
    /// ------
    /// SweepError
    ///     For a chunk that is not there.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> plan = coilsense.SweepPlan(spec, "spring.stiffness=600..900 N/m : 4", columns="f1")
    /// >>> plan.chunk_bytes(0)[:4]
    /// b'PAR1'
    #[pyo3(signature = (index, jobs=None))]
    fn chunk_bytes<'py>(&self, py: Python<'py>, index: Count, jobs: Option<Count>) -> PyResult<Bound<'py, PyBytes>> {
        let index = index.number("index")?;
        let bytes = self.worked_off(py, jobs, |plan, go_on| plan.chunk_bytes(index, go_on))?;
        Ok(PyBytes::new(py, &bytes))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let class: Bound<'py, PyType> = slf.get_type();
        Ok((class.getattr("from_json")?, PyTuple::new(slf.py(), [slf.get().to_json()])?))
    }

    fn __repr__(&self) -> String {
        let parameters = self.0.parameters();
        let sampling = parameters.sampling.map_or("", Sampling::name);
        let (rows, chunks) = (self.0.rows(), self.0.chunks());
        format!("<SweepPlan of {}: {rows} rows ({sampling}) in {chunks} chunks>", parameters.spec_file)
    }
}

impl PySweepPlan {
    /// Does part of the plan's work on so many threads; Ctrl-C stops it.
    fn worked_off<T: Send>(
        &self,
        py: Python<'_>,
        jobs: Option<Count>,
        work: impl FnOnce(&Plan, &(dyn Fn() -> bool + Sync)) -> Result<Option<T>, coilsense_lab::sweep::SweepError> + Send,
    ) -> PyResult<T> {
        let jobs = jobs.map(|jobs| jobs.size("jobs")).transpose()?;
        if jobs == Some(0) {
            return Err(SweepError::new_err("jobs must be at least 1, got 0"));
        }
        let pool = match jobs {
            Some(jobs) => Arc::new(threads::of(jobs)?),
            None => threads::pool(py)?,
        };
        let done = watched_in(&pool, py, None, |progress| work(&self.0, &|| progress(0, 0)))?;
        // It stops only where a signal has been raised, which came first.
        done.python()?.ok_or_else(|| PyKeyboardInterrupt::new_err(()))
    }
}

fn named(word: &str) -> PyResult<Sampling> {
    Sampling::named(word).ok_or_else(|| unknown("sampling", &Sampling::ALL.map(|(word, _)| word), word))
}
