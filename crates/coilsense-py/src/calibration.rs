//! `coilsense.calibrate` and `Calibration`: from measured lengths and inductances to the curve between them.
//!
//! Next door: the points (`recording`, or arrays), the arguments that several share (`quantity`).

use std::sync::Arc;

use coilsense::inductance::theories::Coil;
use coilsense_lab::calibration::request::{
    INVERSION, LENGTH_AT_ZERO, LENGTH_AT_ZERO_FORCE, METHOD, STIFFNESS, STIFFNESS_UNCERTAINTY,
};
use coilsense_lab::calibration::{Assessment, Outcome, Plan, Preload};
use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::request::PRESET;
use coilsense_lab::report::{add_calibration, calibration_json, calibration_text};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::calibration::points::PointsArgument;
use crate::errors::{IntoPython, refused};
use crate::long_work::interruptible;
use crate::quantity::{Quantity, given, positive, wrong};
use crate::results::study_result;
use crate::series::Series;
use crate::spring_argument::SpringArgument;
use crate::value::getters;

mod points;

/// A curve between length and inductance, what it is worth, and the theories beside it; made by `calibrate`.
///
/// ``str()`` of it is what ``coilsense calibrate`` prints.
///
/// Notes
/// -----
/// 1/l = αL + β. Source: [Weijde2017] eq. 13.
#[pyclass(name = "Calibration", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyCalibration(Arc<Outcome>);

getters! {
    PyCalibration, self;
    /// α of 1/l = αL + β [1/(H m)].
    alpha: f64 = self.0.inverse_length.alpha;
    /// Standard error of α [1/(H m)]; None where no point is left to tell.
    alpha_se: Option<f64> = self.0.inverse_length.alpha_se;
    /// β of 1/l = αL + β [1/m].
    beta: f64 = self.0.inverse_length.beta;
    /// Standard error of β [1/m]; None where no point is left to tell.
    beta_se: Option<f64> = self.0.inverse_length.beta_se;
    /// Points less what was fitted.
    degrees_of_freedom: usize = self.0.inverse_length.degrees_of_freedom;
    /// R² of the lengths read [1].
    r2: f64 = self.0.inverse_length.misfit.r2;
    /// Rms of lengths read less lengths measured [m].
    rmse: f64 = self.0.inverse_length.misfit.rmse;
    /// Lengths read less lengths measured [m], shape (points,).
    residuals<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, &self.0.inverse_length.misfit.residuals);
    /// Measured lengths [m], shape (points,).
    lengths<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, self.0.measured.points.lengths());
    /// Measured inductances [H], shape (points,).
    inductances<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, self.0.measured.points.inductances());
    /// The theories beside the points, in their order: name, r2, rmse [m], rmse_share_of_range; or why one cannot be judged.
    theories<'py>(py): PyResult<Vec<Bound<'py, PyDict>>> =
        self.0.theories.iter().map(|judged| theory(py, judged)).collect();
    /// The answer, a sentence each.
    answer: Vec<String> = coilsense_lab::calibration::answer(&self.0);
}

study_result! {
    PyCalibration, self;
    /// Everything, under the names of results.json.
    to_dict = calibration_json(&self.0, None);
    /// The points as a data frame of pandas: what was measured, what is read, what is left; ``pip install coilsense[pandas]``.
    to_pandas = "points_frame";
    /// Draws points and curve with matplotlib; ``pip install coilsense[plot]``.
    plot = "calibration_plot";
    str = calibration_text(&self.0);
    html = "calibration_html";
    /// Writes what ``coilsense calibrate --out`` writes: report.html, results.json, figures; all of it or nothing.
    save(date, output) = add_calibration(&self.0, date, output);
}

#[pymethods]
impl PyCalibration {
    /// The length at an inductance, by 1/l = αL + β.
    ///
    /// Parameters
    /// ----------
    /// inductance : array_like of float, shape (samples,)
    ///     [H].
    ///
    /// Returns
    /// -------
    /// numpy.ndarray, shape (samples,)
    ///     [m].
    fn length<'py>(&self, py: Python<'py>, inductance: Series<'_>) -> Bound<'py, PyArray1<f64>> {
        let calibration = self.0.inverse_length.calibration();
        inductance.values().iter().map(|henry| calibration.length(*henry)).collect::<Vec<_>>().into_pyarray(py)
    }

    /// The inductance at a length, by 1/l = αL + β.
    ///
    /// Parameters
    /// ----------
    /// length : array_like of float, shape (samples,)
    ///     [m].
    ///
    /// Returns
    /// -------
    /// numpy.ndarray, shape (samples,)
    ///     [H].
    fn inductance<'py>(&self, py: Python<'py>, length: Series<'_>) -> Bound<'py, PyArray1<f64>> {
        let calibration = self.0.inverse_length.calibration();
        length.values().iter().map(|metre| calibration.inductance(*metre)).collect::<Vec<_>>().into_pyarray(py)
    }

    fn __repr__(&self) -> String {
        let (points, fit) = (self.0.measured.points.lengths().len(), &self.0.inverse_length);
        format!("<Calibration of {points} points: alpha={}, beta={}, rmse={}>", fit.alpha, fit.beta, fit.misfit.rmse)
    }
}

fn theory<'py>(py: Python<'py>, judged: &Assessment) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("name", judged.theory.name())?;
    match &judged.misfit {
        Ok(misfit) => {
            dict.set_item("r2", misfit.r2)?;
            dict.set_item("rmse", misfit.rmse)?;
            dict.set_item("rmse_share_of_range", misfit.rmse_share_of_range)?;
        }
        Err(reason) => dict.set_item("refused", reason)?,
    }
    Ok(dict)
}

/// The curve between length and inductance through measured points, with intervals, misfit and the theories beside it.
///
/// Parameters
/// ----------
/// points : Recording, str, os.PathLike, or (array_like, array_like)
///     A recording with u1, u2 or both, and L; or the path of such a log, read row by row without a clock; or lengths [m] and inductances
///     [H], each of shape (points,).
/// length_at_zero : float or str, optional
///     Length of the coil where positions read zero [m]; without it u2 - u1, or u2, is the length itself.
/// method : {"all", "two-point", "through-preload"}, optional
///     How the curve is put through the points; without it through-preload where a preload is given, two-point with the preset lab-data,
///     else all.
/// preload : float, or (float, float), optional
///     Length at the preload [m], and its inductance [H] where there is no point.
/// inversion : {"exact", "25-lengths"}, optional
///     How a length is read from a theory; without it 25-lengths with the preset lab-data, else exact.
/// spring : Spring, Spec, str or os.PathLike, optional
///     Coil, stiffness and length at zero force, from a spring or a spec.
/// stiffness : float or str, optional
///     k, to go on to force [N/m]; with length_at_zero_force.
/// stiffness_uncertainty : float
///     Its standard uncertainty, as a share [1].
/// length_at_zero_force : float or str, optional
///     Length of the coil at which its force is zero [m].
/// preset : {"lab-data"}, optional
///     The layout of a log by its path.
/// columns, units : dict, optional
///     Which column is which channel, for a log by its path; as `open_log` has them.
///
/// Returns
/// -------
/// Calibration
///
/// Raises
/// ------
/// Error
///     For points that no curve can be put through, or settings that do not fit each other.
/// LogError
///     For a log that cannot be read.
///
/// Notes
/// -----
/// 1/l = αL + β, squares of 1/l. Source: [Weijde2017] eq. 13.
///
/// Examples
/// --------
/// >>> import coilsense, numpy
/// >>> lengths = numpy.linspace(0.2, 0.26, 7)
/// >>> fit = coilsense.calibrate((lengths, (1 / lengths - 0.4) / 1.5e6))
/// >>> round(fit.alpha), round(fit.beta, 6)
/// (1500000, 0.4)
#[pyfunction]
#[pyo3(signature = (points, *, length_at_zero=None, method=None, preload=None, inversion=None, spring=None, stiffness=None,
                    stiffness_uncertainty=0.0, length_at_zero_force=None, preset=None, columns=None, units=None))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per option of the command")]
pub fn calibrate(
    py: Python<'_>,
    points: PointsArgument<'_>,
    length_at_zero: Option<Quantity>,
    method: Option<&str>,
    preload: Option<PreloadArgument>,
    inversion: Option<&str>,
    spring: Option<SpringArgument<'_>>,
    stiffness: Option<Quantity>,
    stiffness_uncertainty: f64,
    length_at_zero_force: Option<Quantity>,
    preset: Option<String>,
    columns: Option<Bound<'_, PyDict>>,
    units: Option<Bound<'_, PyDict>>,
) -> PyResult<PyCalibration> {
    let preload = preload.map(PreloadArgument::preload).transpose()?;
    let spring = spring.as_ref().map(SpringArgument::known).transpose()?;
    let given = given([
        (&LENGTH_AT_ZERO, length_at_zero.into()),
        (&METHOD, method.into()),
        (&INVERSION, inversion.into()),
        (&PRESET, preset.as_deref().into()),
        (&STIFFNESS, stiffness.into()),
        (&STIFFNESS_UNCERTAINTY, stiffness_uncertainty.into()),
        (&LENGTH_AT_ZERO_FORCE, length_at_zero_force.into()),
    ])?;
    let zero = given.number(&LENGTH_AT_ZERO);
    let plan = Plan {
        coil: spring.as_ref().map(|spec| Coil::of(&spec.spring)).transpose().map_err(refused)?,
        force: points::force(&given, spring.as_ref())?,
        ..Plan::of(&given, preload).map_err(wrong)?
    };
    let measured = points::measured(py, points, zero, preset, columns, units)?;
    let outcome = interruptible(py, move || Outcome::new(measured, plan))?.python()?;
    Ok(PyCalibration(Arc::new(outcome)))
}

/// A preload's length, or its length and inductance.
#[derive(FromPyObject)]
pub enum PreloadArgument {
    Pair(Quantity, Quantity),
    Length(Quantity),
}

impl PreloadArgument {
    fn preload(self) -> PyResult<Preload> {
        let (length, inductance) = match self {
            Self::Length(length) => (length, None),
            Self::Pair(length, inductance) => (length, Some(inductance)),
        };
        let inductance = positive(inductance.as_ref(), "preload[1]", Dimension::Inductance)?;
        Ok(Preload { length: length.positive("preload", Dimension::Length)?, inductance })
    }
}
