//! `coilsense.Spec`: a spring, its mount, conditions of use, sensors and a goal, from TOML.
//!
//! Next door: what is computed from it (`analysis`).

mod condition;

use std::path::{Path, PathBuf};

use coilsense_lab::data_sheet::DataSheet;
use coilsense_lab::report::data_sheet_json;
use coilsense_lab::spec::{Spec, template};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::errors::IntoPython;
use crate::json;
use crate::mount::PyMount;
use crate::spring::PySpring;
use crate::threads::spread;
use crate::value::{Arguments, getters};
pub use condition::PyCondition;

/// A spec: a spring, how it is mounted, what is done to it, what watches it, and what that should achieve.
///
/// Made by ``Spec.read`` from a file, or by ``Spec.parse`` from a text; ``Spec.template`` is a commented text to begin with. It is the one input
/// model of command, sweeps and Python; units are part of its text, every number here is SI.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> spec.spring == coilsense.Spring.of_paper("S_T")
/// True
/// >>> spec.sensors
/// ['load cell, motor side', 'load cell, load side', 'laser', 'LCR meter']
#[pyclass(name = "Spec", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PySpec {
    /// What it says.
    pub spec: Spec,
    /// Where files that it names lie.
    pub folder: Option<PathBuf>,
}

/// Reads files that lie in a folder.
pub fn beside(folder: Option<&Path>) -> impl Fn(&str) -> Result<String, String> {
    move |name: &str| {
        let path = folder.map_or_else(|| PathBuf::from(name), |folder| folder.join(name));
        std::fs::read_to_string(&path).map_err(|error| format!("{} cannot be read: {error}", path.display()))
    }
}

getters! {
    PySpec, self;
    /// The file's name, as messages call it.
    file: &str = &self.spec.file;
    /// Its text.
    text: &str = &self.spec.text;
    /// The spring's name.
    name: &str = &self.spec.spring.name;
    /// The spring, with its own mass whatever ``model`` says; of several the first.
    spring: PySpring = PySpring(self.spec.spring.as_given());
    /// Names of all springs, the first first.
    springs: Vec<&str> = self.spec.springs().map(|spring| spring.name.as_str()).collect();
    /// The conditions of use, as a list of `Condition`; may be empty.
    conditions: Vec<PyCondition> = self.spec.conditions.iter().cloned().map(PyCondition).collect();
    /// The sensors' names; may be empty.
    sensors: Vec<&str> = self.spec.sensors.iter().map(|sensor| sensor.name.as_str()).collect();
}

#[pymethods]
impl PySpec {
    /// Reads a spec from a file; files that it names are looked for beside it.
    ///
    /// Parameters
    /// ----------
    /// path : str or os.PathLike
    ///     The file.
    ///
    /// Returns
    /// -------
    /// Spec
    ///
    /// Raises
    /// ------
    /// SpecError
    ///     One line with file, line, key, value and what is allowed; or why the file cannot be read.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, pathlib, tempfile
    /// >>> file = pathlib.Path(tempfile.mkdtemp()) / "ankle.toml"
    /// >>> _ = file.write_text(coilsense.Spec.template("S_T"))
    /// >>> coilsense.Spec.read(file).spring.windings
    /// 52.0
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let spec = py.detach(|| Spec::read(&path)).python()?;
        Ok(Self { spec, folder: path.parent().map(PathBuf::from) })
    }

    /// Reads a spec from its text.
    ///
    /// Parameters
    /// ----------
    /// text : str
    ///     TOML.
    /// file : str, optional
    ///     What errors call it.
    /// folder : str or os.PathLike, optional
    ///     Where files that it names are looked for; the working folder without it.
    ///
    /// Returns
    /// -------
    /// Spec
    ///
    /// Raises
    /// ------
    /// SpecError
    ///     One line with file, line, key, value and what is allowed.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Spec.parse(coilsense.Spec.template("S_T")).name
    /// 'S_T'
    #[staticmethod]
    #[pyo3(signature = (text, file="spec.toml", folder=None))]
    fn parse(py: Python<'_>, text: &str, file: &str, folder: Option<PathBuf>) -> PyResult<Self> {
        let spec = py.detach(|| Spec::parse(file, text, &beside(folder.as_deref()))).python()?;
        Ok(Self { spec, folder })
    }

    /// A commented spec to change.
    ///
    /// Parameters
    /// ----------
    /// spring : {"S_T", "S_A", "pressed"}, optional
    ///     A spring of the paper, or a compression spring by wire, coil and material; without it, an extension spring.
    ///
    /// Returns
    /// -------
    /// str
    ///     TOML.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Spec.template("S_A").splitlines()[0]
    /// '# S_A: parallel spring in the drive train of the lower-leg prosthesis ANGELAA.'
    #[staticmethod]
    #[pyo3(signature = (spring=None))]
    fn template(spring: Option<&str>) -> PyResult<String> {
        template(spring).python()
    }

    /// The mount under each damping, by the damping's label.
    #[getter]
    fn mounts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for case in &self.spec.mount.cases {
            dict.set_item(&case.label, PyMount(case.mount.clone()).into_pyobject(py)?)?;
        }
        Ok(dict)
    }

    /// What follows from the spring alone: rate, mass, stress, lengths, surge frequencies, every mode of the coil as a helix.
    ///
    /// Returns
    /// -------
    /// dict
    ///     As ``coilsense spring --json`` prints it.
    ///
    /// Raises
    /// ------
    /// SpecError
    ///     For a spec of several springs.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
    /// >>> sorted(spec.data_sheet())[:3]
    /// ['bar_frequency_hz', 'clash_speed_at_max_m_per_s', 'clash_speed_at_min_m_per_s']
    fn data_sheet<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.spec.needs_one_spring("a data sheet").python()?;
        let sheet = spread(py, || DataSheet::of(&self.spec))?.python()?;
        json::loads(py, data_sheet_json(&sheet))
    }

    /// File and text by name.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("file", &self.spec.file)?;
        dict.set_item("text", &self.spec.text)?;
        Ok(dict)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let own = slf.get();
        let kept = (&own.spec.text, &own.spec.file, own.folder.as_deref());
        Ok((slf.get_type().getattr("parse")?, kept.into_pyobject(slf.py())?))
    }

    fn __repr__(&self) -> String {
        let (conditions, sensors) = (self.spec.conditions.len(), self.spec.sensors.len());
        format!("<Spec {}: {}, {conditions} conditions, {sensors} sensors>", self.spec.file, self.name())
    }
}
