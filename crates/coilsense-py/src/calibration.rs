//! `coilsense.calibrate` and `Calibration`: from measured lengths and inductances to the curve between them.
//!
//! Next door: the points (`recording`, or arrays), the arguments that several share (`quantity`).

use std::sync::Arc;

use coilsense_lab::calibration::request::{
    FORM, FREQUENCY, INVERSION, KNOWN_PERMEABILITY, LEADS, LENGTH_AT_ZERO, LENGTH_AT_ZERO_FORCE, METER_NOISE, METHOD,
    POINTS, RE_ZERO, STIFFNESS, STIFFNESS_UNCERTAINTY, THEORY,
};
use coilsense_lab::calibration::{Assessment, Curve, Outcome, Plan, StoredCalibration};
use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::request::PRESET;
use coilsense_lab::report::{add_calibration, calibration_json, calibration_text};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::calibration::arguments::{PreloadArgument, ReZeroArgument};
use crate::calibration::points::PointsArgument;
use crate::count::Count;
use crate::errors::{IntoPython, refused};
use crate::long_work::interruptible;
use crate::names::Word;
use crate::quantity::{Quantity, given, neither, wrong};
use crate::results::study_result;
use crate::samples::Samples;
use crate::spring_argument::SpringArgument;
use crate::value::getters;

mod arguments;
mod points;
mod stored;

pub use stored::{PyStoredCalibration, StoredArgument, open_calibration};

/// A curve between length and inductance, what it is worth, and the theories beside it; made by `calibrate`.
///
/// ``str()`` of it is what ``coilsense calibrate`` prints.
///
/// Notes
/// -----
/// 1/l = αL + β. Source: [Weijde2017] eq. 13.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
/// >>> fit.relation, len(fit.lengths)
/// ('inverse-length', 3)
/// >>> print(f"{1e3 * fit.length('2.6 uH'):.1f} mm")
/// 230.3 mm
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
    /// R² of L by 1/l = αL + β [1].
    r2: f64 = self.0.inverse_length.misfit.r2;
    /// Rms of lengths read less lengths measured, by the calibration that was asked for [m].
    rmse: f64 = self.0.taken.rmse(&self.0.measured);
    /// Lengths read less lengths measured, by the calibration that was asked for [m], shape (points,).
    residuals<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_vec(py, self.0.taken.residuals(&self.0.measured));
    /// Measured lengths [m], shape (points,).
    lengths<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, self.0.measured.points.lengths());
    /// Measured inductances [H], shape (points,).
    inductances<'py>(py): Bound<'py, PyArray1<f64>> = PyArray1::from_slice(py, self.0.measured.points.inductances());
    /// The calibration that was asked for: "inverse-length" (1/l = αL + β), "cubic" or "steel".
    relation: &'static str = self.0.plan.relation.name();
    /// Rms of lengths read less lengths measured over the points that it was not fitted to, or over all where there are none [% of the range].
    length_rms_percent_of_range: f64 = 100.0 * self.0.taken.rms_share;
    /// Relative permeability of the wire [1]; None but by the theory "steel".
    permeability: Option<f64> = self.steel().map(|fit| fit.permeability);
    /// Its standard uncertainty [1]; None where it was told.
    permeability_u: Option<f64> = self.steel().and_then(|fit| fit.permeability_u);
    /// L0, what hooks, leads and errors of windings and radius add [H]; None but by the theory "steel".
    offset: Option<f64> = self.steel().map(|fit| fit.offset + self.0.taken.shift);
    /// Its standard uncertainty [H].
    offset_u: Option<f64> = self.steel().map(|fit| fit.offset_u);
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
    /// The length at an inductance, by the calibration that was asked for; nan where it has none.
    ///
    /// Parameters
    /// ----------
    /// inductance : float, str or array_like of float
    ///     [H].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the inductance
    ///     [m].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
    /// >>> fit.length([2.5e-6, 2.6e-6]).round(4)
    /// array([0.2393, 0.2303])
    /// >>> round(fit.length("2.5 uH"), 4)
    /// 0.2393
    fn length<'py>(&self, py: Python<'py>, inductance: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        let taken = &self.0.taken;
        inductance.each(py, "inductance", Dimension::Inductance, |henry| taken.length(henry).unwrap_or(f64::NAN))
    }

    /// The standard uncertainty of the length at an inductance; nan where it cannot be told.
    ///
    /// Parameters
    /// ----------
    /// inductance : float, str or array_like of float
    ///     [H].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the inductance
    ///     [m].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
    /// >>> bool(fit.length_u(2.5e-6) > 0)
    /// True
    fn length_u<'py>(&self, py: Python<'py>, inductance: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        let taken = &self.0.taken;
        inductance.each(py, "inductance", Dimension::Inductance, |henry| taken.length_u(henry).unwrap_or(f64::NAN))
    }

    /// The calibration as a file's text, which `open_calibration` and ``coilsense import --calibration`` read.
    ///
    /// Parameters
    /// ----------
    /// date : str
    ///     The date that it carries, such as 2026-11-21.
    ///
    /// Returns
    /// -------
    /// str
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
    /// >>> fit.stored("2026-11-21").startswith("# Length from inductance")
    /// True
    fn stored(&self, date: &str) -> PyResult<String> {
        Ok(StoredCalibration::of(&self.0).python()?.to_text(date))
    }

    /// The inductance at a length, by the calibration that was asked for; nan where it does not reach.
    ///
    /// Parameters
    /// ----------
    /// length : float, str or array_like of float
    ///     [m].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the length
    ///     [H].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
    /// >>> fit.inductance([0.2, 0.23]).round(8)
    /// array([3.0e-06, 2.6e-06])
    fn inductance<'py>(&self, py: Python<'py>, length: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        length.each(py, "length", Dimension::Length, |metre| self.0.taken.inductance(metre))
    }

    fn __repr__(&self) -> String {
        let (points, fit, rmse) = (self.0.measured.points.lengths().len(), &self.0.inverse_length, self.rmse());
        match self.steel() {
            Some(steel) => {
                format!(
                    "<Calibration of {points} points: permeability={}, offset={}, rmse={rmse}>",
                    steel.permeability, steel.offset
                )
            }
            None if self.0.plan.relation.fewest() == 2 => {
                format!("<Calibration of {points} points: alpha={}, beta={}, rmse={rmse}>", fit.alpha, fit.beta)
            }
            None => format!("<Calibration of {points} points: {}, rmse={rmse}>", self.0.plan.relation.name()),
        }
    }
}

impl PyCalibration {
    /// The magnetic wire, where it was asked for.
    fn steel(&self) -> Option<&coilsense::calibrate::SteelFit> {
        match &self.0.taken.curve {
            Curve::Steel(fit) => Some(fit),
            _ => None,
        }
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
/// preload : float, str, or (float or str, float or str), optional
///     Length at the preload [m], and its inductance [H] where there is no point.
/// theory : {"steel"}, optional
///     Fit the theory of a coil of magnetic wire, by its permeability and one constant; two points are enough. Needs `spring`.
/// known_permeability : float, optional
///     Relative permeability of the wire where it is known [1].
/// leads : str, optional
///     Where the meter's current goes back: "open" (far away), the lead's distance from the axis, such as "50 mm", or "none" (no current along the coil).
/// meter_noise : float or str, optional
///     Standard uncertainty of a reading of L [H]; without it what readings of one point scatter by, else 0.05 % of L.
/// frequency : float or str, optional
///     Frequency at which the meter works [Hz].
/// form : {"inverse-length", "cubic"}, optional
///     Fit 1/l = αL + β, which is usual, or L = α/l + β + γ/l².
/// fit_points : int, optional
///     Fit so many of the points, spread from the shortest to the longest, and judge on the others.
/// re_zero : (float or str, float or str) or str, optional
///     A length [m] and an inductance [H] that the fitted curve is moved to, of a spring mounted anew.
/// inversion : {"exact", "25-lengths"}, optional
///     How a length is read from a theory; without it 25-lengths with the preset lab-data, else exact.
/// spring : Spring, Spec, str or os.PathLike, optional
///     Coil, stiffness and length at zero force, from a spring or a spec.
/// stiffness : float or str, optional
///     k, to go on to force [N/m]; with length_at_zero_force.
/// stiffness_uncertainty : float or str
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
#[pyo3(signature = (points, *, length_at_zero=None, method=None, preload=None, theory=None, known_permeability=None,
                    leads=None, meter_noise=None, frequency=None, form=None, fit_points=None, re_zero=None,
                    inversion=None, spring=None, stiffness=None, stiffness_uncertainty=Quantity::Number(0.0), length_at_zero_force=None, preset=None, columns=None, units=None),
       text_signature = "(points, *, length_at_zero=None, method=None, preload=None, theory=None, known_permeability=None, leads=None, \
                         meter_noise=None, frequency=None, form=None, fit_points=None, re_zero=None, inversion=None, spring=None, \
                         stiffness=None, stiffness_uncertainty=0.0, length_at_zero_force=None, preset=None, columns=None, units=None)")]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per option of the command")]
pub fn calibrate(
    py: Python<'_>,
    points: PointsArgument<'_>,
    length_at_zero: Option<Quantity>,
    method: Option<Word>,
    preload: Option<PreloadArgument>,
    theory: Option<Word>,
    known_permeability: Option<Quantity>,
    leads: Option<Word>,
    meter_noise: Option<Quantity>,
    frequency: Option<Quantity>,
    form: Option<Word>,
    fit_points: Option<Count>,
    re_zero: Option<ReZeroArgument>,
    inversion: Option<Word>,
    spring: Option<SpringArgument<'_>>,
    stiffness: Option<Quantity>,
    stiffness_uncertainty: Quantity,
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
        (&THEORY, theory.into()),
        (&KNOWN_PERMEABILITY, known_permeability.into()),
        (&LEADS, leads.into()),
        (&METER_NOISE, meter_noise.into()),
        (&FREQUENCY, frequency.into()),
        (&FORM, form.into()),
        (&POINTS, fit_points.into()),
        (&RE_ZERO, re_zero.as_ref().and_then(ReZeroArgument::text).into()),
        (&INVERSION, inversion.into()),
        (&PRESET, preset.as_deref().into()),
        (&STIFFNESS, stiffness.into()),
        (&STIFFNESS_UNCERTAINTY, stiffness_uncertainty.into()),
        (&LENGTH_AT_ZERO_FORCE, length_at_zero_force.into()),
    ])?;
    let zero = given.number(&LENGTH_AT_ZERO);
    let force = points::force(&given, spring.as_ref())?;
    let mut plan = Plan { force, ..Plan::of(&given, preload).map_err(wrong)? };
    if let Some(known) = &spring {
        plan = plan.of_spring(&known.spring, force).map_err(refused)?;
    }
    match re_zero {
        Some(ReZeroArgument::Pair(length, inductance)) => {
            let length = length.positive("re_zero[0]", Dimension::Length)?;
            plan.re_zero = Some((length, inductance.positive("re_zero[1]", Dimension::Inductance)?));
        }
        Some(ReZeroArgument::Other(object)) => {
            return Err(neither("re_zero", "a tuple of a length and an inductance, or both as a text", &object));
        }
        Some(ReZeroArgument::Text(_)) | None => {}
    }
    let measured = points::measured(py, points, zero, preset, columns, units)?;
    let outcome = interruptible(py, move || Outcome::new(measured, plan))?.python()?;
    Ok(PyCalibration(Arc::new(outcome)))
}
