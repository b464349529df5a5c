//! `coilsense.plant` and `Plant`: the spring as a part of another's simulation.
//!
//! Next door: the motion of one condition (`motion`), a live spring (`stream`), the spring over frequency (`two_port`).

use std::path::PathBuf;

use coilsense::plant::StateSpace;
use coilsense_lab::plant::request::{
    ALSO, AS, BANDWIDTH, DAMPING_RATIO, ERROR, FMI, MEAN_LENGTH, MODES, PRECISION, STEP,
};
use coilsense_lab::plant::{Form, Plant, Request};
use coilsense_lab::report::write_export;
use coilsense_lab::request::Takes;
use num_complex::Complex64;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::count::Count;
use crate::errors::{Error, IntoPython, refused, unknown};
use crate::hertz::{angular, in_hertz};
use crate::long_work::interruptible;
use crate::names::Names;
use crate::quantity::{Quantity, given, wrong};
use crate::results::table_and_figure;
use crate::series::Series;
use crate::spec_argument::SpecArgument;
use crate::value::getters;

/// A spring on its mount as a linear system; made by `plant`. ``str()`` of it is what ``coilsense export`` prints.
///
/// Inputs count from their means: u1 [m], and u2 [m] or, where end 2 is tied to a force or a mass, the force on it [N]. Outputs are F_i, F_o, F_x [N] about the mean
/// force, u2 [m], and where ``also`` asks for it F_L [N] in a straight line about the mean.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> ankle = coilsense.plant(spec, damping_ratio=0.005, error=0.01, bandwidth=100)
/// >>> ankle.kept, ankle.available, ankle.error < 0.01
/// (5, 52, True)
/// >>> A, B, C, D = ankle.to_state_space()
/// >>> A.shape, B.shape, C.shape, D.shape
/// ((14, 14), (14, 2), (4, 14), (4, 2))
#[pyclass(name = "Plant", module = "coilsense", frozen)]
pub struct PyPlant(Plant);

/// What its outputs are, beside F_L.
const OUTPUTS: [&str; 4] = ["F_i", "F_o", "F_x", "u2"];

getters! {
    PyPlant, self;
    /// The inputs, in their order: ("u1", "u2"), or ("u1", "F_2") where a force moves end 2.
    inputs: (&'static str, &'static str) = ("u1", if self.is_held() { "u2" } else { "F_2" });
    /// The outputs of its matrices, in their order: "F_i", "F_o", "F_x", "u2", and "F_L" where that was asked for.
    outputs<'py>(py): PyResult<Bound<'py, PyTuple>> =
        PyTuple::new(py, OUTPUTS.into_iter().chain(self.0.coil.as_ref().map(|_| "F_L")).collect::<Vec<_>>());
    /// What to know of them, each in a line.
    warnings: Vec<String> = self.0.warnings.clone();
    /// How many of the spring's modes are kept.
    kept: usize = self.0.plant.kept();
    /// How many the spring has; where these are more, two stand for all others.
    available: usize = self.0.plant.available();
    /// Frequencies of its modes [Hz], shape (modes,); where not all are kept, the last two stand for all others.
    frequencies<'py>(py): Bound<'py, PyArray1<f64>> =
        self.0.plant.modes().iter().map(|mode| in_hertz(mode.frequency)).collect::<Vec<f64>>().into_pyarray(py);
    /// Their damping ratios [1], shape (modes,).
    damping_ratios<'py>(py): Bound<'py, PyArray1<f64>> = self.0.plant.ratios().collect::<Vec<f64>>().into_pyarray(py);
    /// What is missed of F_i, F_o and F_x, and of F_L where that was asked for, up to the bandwidth, over k times the motion of an end or over the force at end 2 [1]; None without a bandwidth, inf where a mode in it
    /// is left out.
    error: Option<f64> = self.0.error.map(|(_, error)| error);
    /// The length about which inputs count [m].
    mean_length: f64 = self.0.plant.mean_length();
    /// F_i = F_o = F_x there [N].
    mean_force: f64 = self.0.plant.mean_force();
}

/// A, B, C and D.
type Matrices<'py> =
    (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>);
/// A response and its angular frequencies.
type Frd<'py> = (Bound<'py, PyArray3<Complex64>>, Bound<'py, PyArray1<f64>>);

fn matrix<'py>(
    py: Python<'py>,
    rows: impl IntoIterator<Item = Vec<f64>>,
    columns: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let all: Vec<f64> = rows.into_iter().flatten().collect();
    let rows = all.len() / columns;
    all.into_pyarray(py).reshape([rows, columns])
}

fn matrices<'py>(
    py: Python<'py>,
    a: Vec<Vec<f64>>,
    b: &[[f64; 2]],
    c: Vec<Vec<f64>>,
    d: &[[f64; 2]],
) -> PyResult<Matrices<'py>> {
    let states = a.len();
    let pairs = |rows: &[[f64; 2]]| rows.iter().map(|row| row.to_vec()).collect::<Vec<_>>();
    Ok((matrix(py, a, states)?, matrix(py, pairs(b), 2)?, matrix(py, c, states)?, matrix(py, pairs(d), 2)?))
}

impl PyPlant {
    fn is_held(&self) -> bool {
        self.0.plant.far_end() == coilsense_rt::FarEnd::Position
    }
}

table_and_figure! {
    PyPlant;
    /// The modes as a data frame of pandas: frequency [Hz] and damping ratio; ``pip install coilsense[pandas]``.
    to_pandas = "plant_frame";
    /// Draws what the motion of end 1 does to F_i and F_o with matplotlib; ``pip install coilsense[plot]``.
    plot = "plant_plot";
}

#[pymethods]
impl PyPlant {
    /// A, B, C and D, as ``control.ss`` and ``scipy.signal.StateSpace`` take them.
    ///
    /// Parameters
    /// ----------
    /// step : float or str, optional
    ///     The matrices of steps of this length [s], exact for inputs that move straight from sample to sample; without it, continuous.
    ///
    /// Returns
    /// -------
    /// (numpy.ndarray, numpy.ndarray, numpy.ndarray, numpy.ndarray)
    ///     Of shapes (states, states), (states, 2), (outputs, states), (outputs, 2).
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a step that is not above zero, and without one for dashpots at the ends: they pull with the ends' velocity, which is no input.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense, numpy
    /// >>> ankle = coilsense.plant(coilsense.Spec.parse(coilsense.Spec.template("S_T")), damping_ratio=0.005, modes=5)
    /// >>> A, B, C, D = ankle.to_state_space("1 ms")
    /// >>> bool(abs(numpy.linalg.eigvals(A)).max() < 1)
    /// True
    #[pyo3(signature = (step=None))]
    fn to_state_space<'py>(&self, py: Python<'py>, step: Option<Quantity>) -> PyResult<Matrices<'py>> {
        if let Some(step) = step {
            let step = step.positive("step", coilsense_lab::quantity::Dimension::Time)?;
            let sampled = self.0.plant.sampled(step, self.0.coil.as_ref()).python()?;
            return matrices(py, sampled.a, &sampled.b, sampled.c, &sampled.d);
        }
        let StateSpace { a, b, c, d, d_rate } = self.0.plant.state_space(self.0.coil.as_ref());
        if d_rate.iter().flatten().any(|rate| *rate != 0.0) {
            let told = "stiffness_damping pulls with the ends' velocity, which is no input of a continuous state space; give step, or another damping";
            return Err(Error::new_err(told));
        }
        matrices(py, a, &b, c, &d)
    }

    /// The response of F_i, F_o and F_x, and of F_L where that was asked for, to both inputs, and its frequencies in rad/s, as ``control.frd`` takes them.
    ///
    /// Parameters
    /// ----------
    /// frequencies : array_like of float, shape (samples,)
    ///     [Hz], above zero.
    ///
    /// Returns
    /// -------
    /// (numpy.ndarray, numpy.ndarray)
    ///     Complex, of shape (3 or 4, 2, samples), in N/m or, of a force, 1; and of shape (samples,), in rad/s.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> ankle = coilsense.plant(coilsense.Spec.parse(coilsense.Spec.template("S_T")), damping_ratio=0.005)
    /// >>> response, omega = ankle.to_frd([1.0])
    /// >>> response.shape, round(float(response[1, 0, 0].real), 1)
    /// ((3, 2, 1), -760.4)
    fn to_frd<'py>(&self, py: Python<'py>, frequencies: Series<'_>) -> PyResult<Frd<'py>> {
        let frequencies = frequencies.values("frequencies")?;
        let (plant, coil) = (&self.0.plant, self.0.coil.as_ref());
        let rows = |&frequency: &f64| {
            let by_coil = coil.map(|coil| plant.coil_response(coil, frequency)).transpose()?;
            Ok(plant.response(frequency)?.into_iter().chain(by_coil).flatten().collect::<Vec<Complex64>>())
        };
        let each = frequencies.iter().map(rows).collect::<Result<Vec<_>, coilsense::Error>>().python()?;
        let outputs = if coil.is_some() { 4 } else { 3 };
        let all: Vec<Complex64> =
            (0..2 * outputs).flat_map(|place| each.iter().map(move |response| response[place])).collect();
        let omega: Vec<f64> = frequencies.iter().copied().map(angular).collect();
        Ok((all.into_pyarray(py).reshape([outputs, 2, omega.len()])?, omega.into_pyarray(py)))
    }

    /// Writes it, as ``coilsense export --out`` does.
    ///
    /// Parameters
    /// ----------
    /// path : str or os.PathLike
    ///     The file; its name without ending is the name in C and Rust.
    /// form : {"c", "rust", "state-space", "fmu"}
    ///     A header of C99, a constant for coilsense-rt, matrices as JSON, or an FMU for co-simulation and, in FMI 2.0, model exchange; a `UserWarning` says where no compiler made its binary.
    /// precision : {"single", "double"}
    ///     Numbers of a step in C; an FMU has double ones.
    /// step : float or str, optional
    ///     Adds matrices for this step [s] to a state space; of an FMU, that of its default experiment, 1 ms without it.
    /// fmi : {"2.0", "3.0"}, optional
    ///     Version of the standard that an FMU keeps to, 2.0 without it.
    /// overwrite : bool
    ///     Whether a file is replaced, too, that coilsense did not write or that has changed since.
    ///
    /// Returns
    /// -------
    /// int
    ///     How many files: one.
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a name that C cannot have, more modes than a file gets, or a step, a precision or a version of FMI that goes with another form.
    /// OutputError
    ///     Where nothing can be written.
    #[pyo3(signature = (path, form="c", precision="double", step=None, fmi=None, overwrite=false))]
    #[expect(clippy::too_many_arguments, reason = "they are Python's, by name")]
    fn save(
        &self,
        py: Python<'_>,
        path: PathBuf,
        form: &str,
        precision: &str,
        step: Option<Quantity>,
        fmi: Option<&str>,
        overwrite: bool,
    ) -> PyResult<usize> {
        let words: &[&str] = if let Takes::Word(words) = AS.takes { words } else { &[] };
        if !words.contains(&form) {
            return Err(unknown("form", words, form));
        }
        let given =
            given([(&AS, form.into()), (&STEP, step.into()), (&PRECISION, precision.into()), (&FMI, fmi.into())])?;
        let made = Plant { form: Form::of(&given).map_err(wrong)?, ..self.0.clone() };
        let left_out = interruptible(py, move || write_export(&made, &path, overwrite))?.python()?;
        if let Some(left_out) = left_out {
            let warned = std::ffi::CString::new(left_out).unwrap_or_default();
            PyErr::warn(py, &py.get_type::<PyUserWarning>(), &warned, 1)?;
        }
        Ok(1)
    }

    fn __str__(&self) -> String {
        self.0.summary()
    }

    fn __repr__(&self) -> String {
        let (kept, all) = (self.0.plant.kept(), self.0.plant.available());
        format!("<Plant of {kept} of {all} modes about {} m>", self.0.plant.mean_length())
    }
}

/// The spring of a spec as a linear system: modes, matrices, code for a controller.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     Spring, mount, one damping, and the mean length of its conditions.
/// modes : int, optional
///     How many of the spring's modes are kept, two more stand for all others; without it, as few as `error` asks for, else all.
/// error : float or str, optional
///     Error of F_i, F_o, F_x (and F_L, where `also` asks for it) up to `bandwidth`, over k times the motion of an end, or over the force at end 2 [1].
/// bandwidth : float or str, optional
///     Up to where it holds [Hz]; the error that is left is told up to there.
/// also : str or sequence of str, optional
///     Further outputs: "F_L", by the spring's inductance, and for C, Rust and an FMU "closest_pitch", of the windings; without it, F_i, F_o, F_x and u2 only.
/// damping_ratio : float or str, optional
///     One of the spec's where it names any [1]; without it, the spec's, where it has one.
/// mean_length : float or str, optional
///     Length about which inputs count [m]; without it, that of the spec's conditions, and the middle of the operating range where they have not one.
///
/// Returns
/// -------
/// Plant
///
/// Raises
/// ------
/// Error
///     For windings that meet, a helix, a coil of sections, several springs, several dampings of which none is named, and an order too low for the error.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spec = coilsense.Spec.parse(coilsense.Spec.template("S_T"))
/// >>> coilsense.plant(spec, damping_ratio=0.005).kept
/// 52
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per option of the command")]
#[pyo3(signature = (spec, *, also=None, modes=None, error=None, bandwidth=None, damping_ratio=None, mean_length=None))]
pub fn plant(
    py: Python<'_>,
    spec: SpecArgument<'_>,
    also: Option<Names>,
    modes: Option<Count>,
    error: Option<Quantity>,
    bandwidth: Option<Quantity>,
    damping_ratio: Option<Quantity>,
    mean_length: Option<Quantity>,
) -> PyResult<PyPlant> {
    let spec = spec.spec(py)?;
    let also = also.map(|names| names.listed("also")).transpose()?.map(|words| words.join(","));
    let given = given([
        (&ALSO, also.as_deref().into()),
        (&MODES, modes.into()),
        (&ERROR, error.into()),
        (&BANDWIDTH, bandwidth.into()),
        (&DAMPING_RATIO, damping_ratio.into()),
        (&MEAN_LENGTH, mean_length.into()),
    ])?;
    let request = Request::of(&given).map_err(wrong)?;
    interruptible(py, move || Plant::of(spec, &request))?.map(PyPlant).map_err(refused)
}
