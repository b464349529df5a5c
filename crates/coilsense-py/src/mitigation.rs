//! `coilsense.mitigate` and `Mitigation`: what to do about ringing, every way of it judged.
//!
//! Next door: one way of doing it (`remedy`), the spec (`spec_argument`), the log (`recording`).

mod remedy;

use std::path::PathBuf;
use std::sync::Arc;

use coilsense_lab::calibration::Applied;
use coilsense_lab::mitigation::export::Precision;
use coilsense_lab::mitigation::request::{
    BANDWIDTH, END2, LENGTH_AT_ZERO, MASS_TOLERANCE, MOST_LAG, NOISE, RATE, SEEDS, STIFFNESS_TOLERANCE,
};
use coilsense_lab::mitigation::{Ranking, Request, Study, Truth};
use coilsense_lab::recording::Recording;
use coilsense_lab::report::{add_mitigation, mitigation_json, mitigation_text};
use coilsense_lab::spec::Spec;
use pyo3::prelude::*;

use crate::calibration::StoredArgument;
use crate::count::Count;
use crate::errors::{Error, IntoPython, refused, unknown};
use crate::long_work::interruptible;
use crate::names::Word;
use crate::quantity::{Quantity, given, wrong};
use crate::recording::recording;
use crate::results::{save, study_result};
use crate::spec_argument::SpecArgument;
use crate::value::getters;
pub use remedy::PyRemedy;

/// In which numbers the target computes, by its word.
fn precision(word: &str) -> PyResult<Precision> {
    match word {
        "single" => Ok(Precision::Single),
        "double" => Ok(Precision::Double),
        _ => Err(unknown("precision", &["single", "double"], word)),
    }
}

/// Every way of doing something about ringing, judged on the same runs; made by `mitigate`. ``str()`` of it is what ``coilsense mitigate``
/// prints.
///
/// Filters of F_i are to give k·Δl, the force of a spring without mass; estimators are to give F_o. A sequence of `Remedy`, best first, filters
/// before estimators.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
/// >>> mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
/// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25), mount)
/// >>> record = motion.signals(coilsense.sampled_window(2500, 0, 4))
/// >>> advice = coilsense.mitigate(text, record, seeds=1)
/// >>> advice.best_filter.name in advice.to_pandas().index
/// True
#[pyclass(name = "Mitigation", module = "coilsense", frozen, sequence)]
pub struct PyMitigation {
    answer: Arc<Ranking>,
    spec: Spec,
}

getters! {
    PyMitigation, self;
    /// The remedies, best first by their worst case; filters of F_i, then estimators of F_o.
    remedies: Vec<PyRemedy> = (0..self.answer.judged.len()).map(|place| PyRemedy::of(&self.answer, place)).collect();
    /// The remedies as dicts under the names of results.json, errors in N, angles in degrees as their names say.
    ranking<'py>(py): PyResult<Bound<'py, PyAny>> = self.to_dict(py)?.get_item("candidates");
    /// What cannot be, and why: name and reason.
    left_out: Vec<(String, String)> =
        self.answer.left_out.iter().map(|left| (left.name.clone(), left.reason.clone())).collect();
    /// The best filter of F_i that is not too late; where all are too late, the least late. None without filters.
    best_filter: Option<PyRemedy> = self.best(Truth::Static);
    /// The best estimator of F_o that is not too late. None without estimators.
    best_estimator: Option<PyRemedy> = self.best(Truth::Output);
    /// How often the controller samples [Hz].
    rate: f64 = self.answer.study.rate;
    /// White noise of F_i [N rms].
    noise: f64 = self.answer.study.noise;
    /// Up to which frequency the force moves by itself [Hz].
    bandwidth: f64 = self.answer.study.bandwidth;
}

study_result! {
    PyMitigation, self;
    /// Everything, under the names of results.json.
    to_dict = mitigation_json(&self.answer);
    /// The ranking as a data frame of pandas; ``pip install coilsense[pandas]``.
    to_pandas = "ranking_frame";
    /// Draws worst errors over lags with matplotlib, the best marked; ``pip install coilsense[plot]``.
    plot = "mitigation_plot";
    str = mitigation_text(&self.answer);
    html = "mitigation_html";
}

#[pymethods]
impl PyMitigation {
    /// Writes what ``coilsense mitigate --out`` writes: report.html, results.json, the trade-off as a figure, settings as JSON, C and Rust.
    ///
    /// Parameters
    /// ----------
    /// folder : str or os.PathLike
    ///     Its other files are left alone.
    /// date : str, optional
    ///     What the report carries; without it, today's.
    /// precision : {"single", "double"}
    ///     Numbers of the exported settings.
    /// overwrite : bool
    ///     Whether files are replaced, too, that coilsense did not write or that have changed since.
    ///
    /// Returns
    /// -------
    /// int
    ///     How many files.
    #[pyo3(signature = (folder, date=None, precision="single", overwrite=false))]
    fn save(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        date: Option<String>,
        precision: &str,
        overwrite: bool,
    ) -> PyResult<usize> {
        let precision = self::precision(precision)?;
        save(py, &folder, date, overwrite, |date, output| {
            add_mitigation(&self.answer, &self.spec, date, precision, output)
        })
    }

    fn __len__(&self) -> usize {
        self.answer.judged.len()
    }

    fn __getitem__(&self, place: isize) -> PyResult<PyRemedy> {
        let count = self.__len__();
        let at = if place < 0 { count.checked_add_signed(place) } else { usize::try_from(place).ok() };
        let at = at.filter(|at| *at < count);
        let beyond =
            || pyo3::exceptions::PyIndexError::new_err(format!("there are {count} remedies, got place {place}"));
        Ok(PyRemedy::of(&self.answer, at.ok_or_else(beyond)?))
    }

    fn __repr__(&self) -> String {
        let name = |remedy: Option<PyRemedy>| remedy.map_or("none".to_owned(), |remedy| remedy.name().to_owned());
        let (filter, estimator) = (name(self.best_filter()), name(self.best_estimator()));
        format!("<Mitigation of {} remedies: filter {filter}, estimator {estimator}>", self.__len__())
    }
}

impl PyMitigation {
    fn best(&self, truth: Truth) -> Option<PyRemedy> {
        let (best, _) = self.answer.best(truth)?;
        let place = self.answer.judged.iter().position(|(candidate, _)| std::ptr::eq(candidate, best))?;
        Some(PyRemedy::of(&self.answer, place))
    }
}

/// What to do about ringing: filters and estimators, designed for the spring and judged over its tolerances.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     Spring, mount and conditions.
/// record : Recording, Signals, pandas.DataFrame, mapping, str or os.PathLike, optional
///     Judge on a record in place of the conditions: F_i, u1, u2 (none where end 2 is held) and, for estimators, F_o.
/// stated : bool
///     Judge on the stated scenario in place of the conditions: an impact while end 1 moves, 2.5 kHz, 0.24 N of noise, 50 seeds.
/// rate : float or str, optional
///     How often the controller samples [Hz]; a record has its own. Without it, 1/sample_time of the spec's [control], or 2.5 kHz.
/// noise : float or str, optional
///     White noise of F_i [N rms per sample]; without it, that of the spec's quietest load cell at end 1, or 0.2 % of the nominal force.
/// bandwidth : float or str, optional
///     Up to which frequency the force moves by itself [Hz]; without it, the goal's bandwidth, or f1/20.
/// stiffness_tolerance, mass_tolerance : float or str, optional
///     By how much k and m may be off, either way, as shares [1]. Without them, the spec's own, that of m with the model's uncertainty of f1, or
///     10 %.
/// most_lag : float or str
///     Most lag at the bandwidth that what is advised may have [rad]; without it, 30 degrees.
/// seeds : int
///     Series of noise, 1 to 1000.
/// length_at_zero : float or str, optional
///     Length of the coil where u1 and u2 of the record read zero [m]; without it, by the mean of F_i.
/// calibration : StoredCalibration, str or os.PathLike, optional
///     The coil's length by the record's L, in place of an end that was not recorded, or as the length where u1 and u2 read zero.
/// end2 : {"held", "free", "mass"}, optional
///     What end 2 is tied to in the record; where it is held, no u2 is needed. Without it, as the spec's mount.
///
/// Returns
/// -------
/// Mitigation
///
/// Raises
/// ------
/// Error
///     For a spec without conditions to judge on, or a setting that makes no sense.
/// LogError
///     For a record without one of the channels, not evenly sampled, of another spring, or with a turned sign.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
/// >>> mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
/// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25), mount)
/// >>> record = motion.signals(coilsense.sampled_window(2500, 0, 4))
/// >>> advice = coilsense.mitigate(text, record, seeds=1)
/// >>> advice.best_filter.lag < 0.53  # 30 degrees
/// True
#[pyfunction]
#[pyo3(signature = (spec, record=None, *, stated=false, rate=None, noise=None, bandwidth=None, stiffness_tolerance=None,
                    mass_tolerance=None, most_lag=None, seeds=Count::Number(5), length_at_zero=None, calibration=None, end2=None),
       text_signature = "(spec, record=None, *, stated=False, rate=None, noise=None, bandwidth=None, stiffness_tolerance=None, \
                         mass_tolerance=None, most_lag=None, seeds=5, length_at_zero=None, calibration=None, end2=None)")]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per option of the command")]
pub fn mitigate(
    py: Python<'_>,
    spec: SpecArgument<'_>,
    record: Option<Bound<'_, PyAny>>,
    stated: bool,
    rate: Option<Quantity>,
    noise: Option<Quantity>,
    bandwidth: Option<Quantity>,
    stiffness_tolerance: Option<Quantity>,
    mass_tolerance: Option<Quantity>,
    most_lag: Option<Quantity>,
    seeds: Count,
    length_at_zero: Option<Quantity>,
    calibration: Option<StoredArgument<'_>>,
    end2: Option<Word>,
) -> PyResult<PyMitigation> {
    let spec = spec.spec(py)?;
    if stated && record.is_some() {
        return Err(Error::new_err("record and stated are two things to judge on; give one of them"));
    }
    if calibration.is_some() && (record.is_none() || length_at_zero.is_some()) {
        return Err(Error::new_err("calibration needs a record, and takes the place of length_at_zero"));
    }
    let given = given([
        (&RATE, rate.into()),
        (&NOISE, noise.into()),
        (&BANDWIDTH, bandwidth.into()),
        (&STIFFNESS_TOLERANCE, stiffness_tolerance.into()),
        (&MASS_TOLERANCE, mass_tolerance.into()),
        (&MOST_LAG, most_lag.into()),
        (&SEEDS, seeds.into()),
        (&LENGTH_AT_ZERO, length_at_zero.into()),
        (&END2, end2.into()),
    ])?;
    let asked = Request::of(&given).map_err(wrong)?;
    spec.needs_chain("mitigate").map_err(refused)?;
    spec.needs_no_contact("mitigate").map_err(refused)?;
    let study = match (stated, record) {
        (true, _) => Study::stated(&spec.spring.spring).python()?,
        (false, Some(record)) => on(&spec, &asked, &recording(py, &record)?, calibration)?,
        (false, None) => Study::of(&spec, &asked).map_err(refused)?,
    };
    let file = spec.file.clone();
    let answer = interruptible(py, move || study.run())?.map_err(|error| refused(format!("{file}: {error}")))?;
    Ok(PyMitigation { answer: Arc::new(answer), spec })
}

/// On a record, its lengths by its inductance where a calibration is given.
fn on(spec: &Spec, asked: &Request, record: &Recording, calibration: Option<StoredArgument<'_>>) -> PyResult<Study> {
    let Some(calibration) = calibration else { return Study::on(spec, asked, record).python() };
    let applied = Applied::new(&calibration.stored()?, record.signals(), &record.account().file.display().to_string());
    Study::on_lengths(spec, asked, record, &applied.python()?).python()
}
