//! `coilsense.SweepDataset`.
//!
//! Next door: what decides its rows (`plan`).

use std::collections::BTreeMap;
use std::path::PathBuf;

use coilsense_lab::sweep::Dataset;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::by_title;
use super::plan::PySweepPlan;
use crate::count::Count;
use crate::errors::IntoPython;
use crate::names::Names;
use crate::results::laid_out;
use crate::value::getters;

/// A sweep on disk: a folder with a manifest and one Parquet file a chunk.
///
/// What exists under its final name was whole when it came there; a run that was killed is continued, and leaves the same files as one that was not.
/// Chunks bear a digest: what is not as it was written is never read as rows. pandas, Polars, DuckDB and Dask read the folder as it is.
///
/// Parameters
/// ----------
/// folder : path-like
///     Made where it is not there; gone on with where it holds the same plan.
/// plan : SweepPlan, optional
///     Without it the folder is opened to be read. With it the folder is held until :meth:`close`, the end of a ``with`` block, or the end of this
///     object.
///
/// Raises
/// ------
/// SweepError
///     Where the folder cannot be written or read, is held by another run, has a manifest that was changed, or holds another sweep: then it says
///     what differs.
///
/// Examples
/// --------
/// >>> import coilsense, tempfile
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> over = {"spring.stiffness [N/m]": [600, 700, 800], "spring.mass [kg]": [0.06, 0.065]}
/// >>> designs = coilsense.sweep(spec, over, tempfile.mkdtemp(), columns=["f1", "nominal_force"])
/// >>> len(designs), designs.plan.titles[-1]
/// (6, 'nominal_force [N]')
#[pyclass(name = "SweepDataset", module = "coilsense", frozen)]
pub struct PySweepDataset {
    dataset: Dataset,
    pub(super) folder: PathBuf,
}

getters! {
    PySweepDataset, self;
    /// The folder.
    folder: PathBuf = self.folder.clone();
    /// What its rows are made by.
    plan: PySweepPlan = PySweepPlan(self.dataset.plan().clone());
    /// Numbers of the chunks that are not there yet, or are to be made anew, in order.
    missing: PyResult<Vec<u64>> = self.dataset.missing().python();
    /// Chunks that were there when the folder was opened with a plan and were not as they had been written, by number: how that shows. One that is
    /// written leaves them.
    damaged: BTreeMap<u64, String> = self.dataset.damaged().into_iter().collect();
}

#[pymethods]
impl PySweepDataset {
    #[new]
    #[pyo3(signature = (folder, plan=None))]
    fn new(py: Python<'_>, folder: PathBuf, plan: Option<&PySweepPlan>) -> PyResult<Self> {
        let dataset = py.detach(|| match plan {
            Some(plan) => Dataset::create_or_open(&folder, &plan.0),
            None => Dataset::open(&folder),
        });
        Ok(Self { dataset: dataset.python()?, folder })
    }

    /// Writes a chunk's bytes under another name, lets them come to rest on the disk, and gives them their name.
    ///
    /// Parameters
    /// ----------
    /// index : int
    ///     Of the chunk, from 0.
    /// data : bytes
    ///     Of :meth:`SweepPlan.chunk_bytes`.
    ///
    /// Raises
    /// ------
    /// SweepError
    ///     Where that fails, and for bytes that are not those of this chunk; nothing is left of the chunk then.
    ///
    /// Returns
    /// -------
    /// None
    fn write(&self, py: Python<'_>, index: Count, data: &[u8]) -> PyResult<()> {
        let index = index.number("index")?;
        py.detach(|| self.dataset.write(index, data)).python()
    }

    /// Lets go of the folder, so that another run may write to it; from here on it is only read. So does the end of a ``with`` block.
    ///
    /// Returns
    /// -------
    /// None
    fn close(&self, py: Python<'_>) {
        py.detach(|| self.dataset.release());
    }

    fn __enter__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    #[pyo3(signature = (_kind, _raised, _traceback, /))]
    fn __exit__(
        &self,
        py: Python<'_>,
        _kind: &Bound<'_, PyAny>,
        _raised: &Bound<'_, PyAny>,
        _traceback: &Bound<'_, PyAny>,
    ) {
        self.close(py);
    }

    /// Columns of all chunks that are there, in the order of rows.
    ///
    /// Parameters
    /// ----------
    /// titles : sequence of str, optional
    ///     As :attr:`SweepPlan.titles` has them; without it all.
    ///
    /// Returns
    /// -------
    /// dict
    ///     Arrays of numbers (NaN where a design was refused), lists of texts and truths, by title.
    ///
    /// Raises
    /// ------
    /// SweepError
    ///     For a title that is not there, or a chunk that is not as it was written: :func:`sweep` on the same folder makes it anew.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, tempfile
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> over = {"spring.stiffness [N/m]": [600, 700, 800], "spring.mass [kg]": [0.06, 0.065]}
    /// >>> designs = coilsense.sweep(spec, over, tempfile.mkdtemp(), columns=["f1", "nominal_force"])
    /// >>> designs.read("f1 [Hz]")["f1 [Hz]"].round(1)
    /// array([50. , 48. , 54. , 51.9, 57.7, 55.5])
    #[pyo3(signature = (titles=None))]
    fn read<'py>(&self, py: Python<'py>, titles: Option<Names>) -> PyResult<Bound<'py, PyDict>> {
        let titles = titles.map(|names| names.listed("titles")).transpose()?;
        let titles = titles.unwrap_or_else(|| self.dataset.plan().titles());
        let names: Vec<&str> = titles.iter().map(String::as_str).collect();
        let columns = py.detach(|| self.dataset.read(&names)).python()?;
        by_title(py, names.into_iter().zip(columns))
    }

    /// How the rows that are there went.
    ///
    /// Returns
    /// -------
    /// dict
    ///     ``rows``, of them ``ok``, ``clash``, ``refused``, and ``reasons``: pairs of a count and a text, the commonest first.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, tempfile
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> over = {"spring.stiffness [N/m]": [600, 700, 800], "spring.mass [kg]": [0.06, 0.065]}
    /// >>> designs = coilsense.sweep(spec, over, tempfile.mkdtemp(), columns=["f1", "nominal_force"])
    /// >>> designs.tally()["ok"]
    /// 6
    fn tally<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let tally = py.detach(|| self.dataset.tally()).python()?;
        let dict = PyDict::new(py);
        for (name, count) in
            [("rows", tally.rows), ("ok", tally.ok), ("clash", tally.clash), ("refused", tally.refused)]
        {
            dict.set_item(name, count)?;
        }
        dict.set_item("reasons", tally.reasons)?;
        Ok(dict)
    }

    /// All rows that are there as a data frame of pandas, or some of their columns.
    ///
    /// Parameters
    /// ----------
    /// titles : sequence of str, optional
    ///     As :attr:`SweepPlan.titles` has them; without it all.
    ///
    /// Returns
    /// -------
    /// pandas.DataFrame
    ///
    /// Raises
    /// ------
    /// ImportError
    ///     Without pandas: ``pip install 'coilsense[pandas]'``.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, tempfile
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> over = {"spring.stiffness [N/m]": [600, 700, 800], "spring.mass [kg]": [0.06, 0.065]}
    /// >>> designs = coilsense.sweep(spec, over, tempfile.mkdtemp(), columns=["f1", "nominal_force"])
    /// >>> designs.to_pandas(["spring.mass [kg]", "f1 [Hz]"]).shape
    /// (6, 2)
    #[pyo3(signature = (titles=None))]
    fn to_pandas<'py>(&self, py: Python<'py>, titles: Option<Names>) -> PyResult<Bound<'py, PyAny>> {
        let columns = self.read(py, titles)?;
        py.import("coilsense._frames")?.call_method1("frame", (columns,))
    }

    /// Draws one column over another with matplotlib, a dot a design; ``pip install coilsense[plot]``.
    ///
    /// Parameters
    /// ----------
    /// over, of : str
    ///     Columns of numbers, as :attr:`SweepPlan.titles` has them.
    /// ax : matplotlib.axes.Axes, optional
    ///     Where; without it, in a new figure.
    ///
    /// Returns
    /// -------
    /// matplotlib.axes.Axes
    ///
    /// Raises
    /// ------
    /// SweepError
    ///     For a title that is not there.
    #[pyo3(signature = (over, of, ax=None))]
    fn plot<'py>(
        slf: &Bound<'py, Self>,
        over: &str,
        of: &str,
        ax: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        laid_out(slf.py(), "sweep_plot", (slf, over, of, ax))
    }

    fn __len__(&self) -> PyResult<usize> {
        let plan = self.dataset.plan();
        let there = |chunk: u64| {
            let rows = plan.rows_of(chunk);
            (rows.end - rows.start) as usize
        };
        Ok(plan.rows() as usize - self.dataset.missing().python()?.into_iter().map(there).sum::<usize>())
    }

    fn __repr__(&self) -> PyResult<String> {
        let plan = self.dataset.plan();
        let missing = self.dataset.missing().python()?.len() as u64;
        let (whole, of) = (plan.chunks() - missing, plan.chunks());
        Ok(format!(
            "<SweepDataset in {}: {} of {} rows, {whole} of {of} chunks>",
            self.folder.display(),
            self.__len__()?,
            plan.rows()
        ))
    }
}
