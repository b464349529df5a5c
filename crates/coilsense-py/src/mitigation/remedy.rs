//! `coilsense.Remedy`: one way of doing something about ringing; what it is worth, run on arrays, and as code for a controller.
//!
//! Next door: all of them, ranked (the parent).

use std::sync::Arc;

use coilsense_lab::mitigation::export::{Export, Settings};
use coilsense_lab::mitigation::{Candidate, Judgement, Ranking, Truth};
use coilsense_rt::Measured;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::precision;
use crate::errors::{Error, refused};
use crate::json;
use crate::long_work::of_series;
use crate::series::Series;
use crate::value::{Arguments, getters};

/// A filter of F_i or an estimator of F_o, designed for a spring and judged; an item of `Mitigation`.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
/// >>> mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
/// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25), mount)
/// >>> record = motion.signals(coilsense.sampled_window(2500, 0, 4))
/// >>> advice = coilsense.mitigate(text, record, seeds=1)
/// >>> best = advice.best_filter
/// >>> best.against, best.worst_rms_error < 1
/// ('k·Δl', True)
#[pyclass(name = "Remedy", module = "coilsense", frozen)]
pub struct PyRemedy {
    answer: Arc<Ranking>,
    place: usize,
}

impl PyRemedy {
    /// The one at a place of the ranking, which must be there.
    pub fn of(answer: &Arc<Ranking>, place: usize) -> Self {
        Self { answer: Arc::clone(answer), place }
    }

    fn candidate(&self) -> &Candidate {
        &self.answer.judged[self.place].0
    }

    fn judgement(&self) -> &Judgement {
        &self.answer.judged[self.place].1
    }

    fn numbers(&self) -> PyResult<&dyn Settings> {
        let nothing = || Error::new_err(format!("{} has no settings: it is measured as it is", self.candidate().name));
        self.candidate().settings().ok_or_else(nothing)
    }

    /// What a file of it is called, where nothing else is asked for.
    fn usual_name(&self) -> &'static str {
        match self.candidate().truth {
            Truth::Static => "force_filter",
            Truth::Output => "force_estimator",
        }
    }

    fn exported<T>(
        &self,
        name: Option<&str>,
        precision: &str,
        make: impl FnOnce(&Export<'_>) -> PyResult<T>,
    ) -> PyResult<T> {
        let name = name.unwrap_or(self.usual_name());
        let export = Export::new(name, self.answer.study.rate, self::precision(precision)?, self.numbers()?);
        make(&export.map_err(refused)?)
    }
}

getters! {
    PyRemedy, self;
    /// In words.
    pub name: &str = &self.candidate().name;
    /// Where it comes from: "raw", "textbook" or "fitted".
    origin: &'static str = self.candidate().origin.name();
    /// What its force is to be: "k·Δl" or "F_o".
    against: &'static str = self.candidate().truth.name();
    /// Rms error on the nominal spring [N].
    rms_error: f64 = self.judgement().nominal;
    /// The largest rms error of a run over the tolerances [N].
    worst_rms_error: f64 = self.judgement().worst;
    /// In which run.
    worst_run: &str = &self.judgement().worst_run;
    /// Rms error once the truth is shifted by the delay at which it fits best [N].
    aligned_rms_error: f64 = self.judgement().aligned;
    /// That delay [s].
    delay: f64 = self.judgement().delay;
    /// Lag at the bandwidth [rad]; below zero it leads.
    lag: f64 = self.judgement().lag;
    /// Noise that comes out over noise that goes in, rms [1].
    noise_gain: f64 = self.judgement().noise_gain;
    /// How long after an impact the error stays above a tenth of what the impact makes [s].
    settling: f64 = self.judgement().settling;
}

#[pymethods]
impl PyRemedy {
    /// The numbers that make it, by name; None for what is measured as it is.
    #[getter]
    fn settings<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let settings = self.candidate().settings().map(|settings| serde_json::to_string(&settings.numbers()));
        settings.map(|text| json::loads(py, text)).transpose()
    }

    /// Runs it over series, sample by sample as a controller would, from a spring that rests as it is at the first sample.
    ///
    /// Parameters
    /// ----------
    /// force : array_like of float, shape (samples,)
    ///     F_i [N], at the rate of the `Mitigation`.
    /// u1, u2 : array_like of float, shape (samples,), optional
    ///     Positions of the ends [m]; needed by what reads them, which is every estimator and the deflection.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray, shape (samples,)
    ///     What it gives [N]: k·Δl or F_o, as `against` says.
    ///
    /// Raises
    /// ------
    /// Error
    ///     For series of different lengths, a value that is not finite, or positions that are missing.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
    /// >>> mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25), mount)
    /// >>> record = motion.signals(coilsense.sampled_window(2500, 0, 4))
    /// >>> advice = coilsense.mitigate(text, record, seeds=1)
    /// >>> advice.best_filter.apply(record["F_i"]).shape == record.time.shape
    /// True
    #[pyo3(signature = (force, u1=None, u2=None))]
    fn apply<'py>(
        slf: &Bound<'py, Self>,
        force: Series<'_>,
        u1: Option<Series<'_>>,
        u2: Option<Series<'_>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let remedy = slf.get();
        let needs_ends = remedy.candidate().truth == Truth::Output || !remedy.filters_force();
        let ends = match (u1, u2) {
            (Some(u1), Some(u2)) => Some((u1, u2)),
            (None, None) if !needs_ends => None,
            _ => return Err(Error::new_err(format!("{} needs u1 and u2 beside the force", remedy.name()))),
        };
        let force = force.values("force")?;
        let measured = match &ends {
            Some((u1, u2)) => joined(&force, &u1.values("u1")?, &u2.values("u2")?)?,
            None => joined(&force, &vec![0.0; force.len()], &vec![0.0; force.len()])?,
        };
        // The longest, a filter of many states, takes about a hundred nanoseconds a sample.
        let steps = measured.len().saturating_mul(50);
        let given = of_series(slf, steps, &[], move |remedy, _| remedy.candidate().run(&measured))?;
        Ok(given.into_pyarray(slf.py()))
    }

    /// Its settings as a C header that runs alone (C99).
    ///
    /// Parameters
    /// ----------
    /// name : str, optional
    ///     What type and functions are called; without it force_filter or force_estimator.
    /// precision : {"single", "double"}
    ///     ``float`` or ``double``.
    ///
    /// Returns
    /// -------
    /// str
    ///
    /// Raises
    /// ------
    /// Error
    ///     For a name that is none in C and Rust, or what has no settings.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
    /// >>> mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25), mount)
    /// >>> record = motion.signals(coilsense.sampled_window(2500, 0, 4))
    /// >>> advice = coilsense.mitigate(text, record, seeds=1)
    /// >>> "force_filter_step" in advice.best_filter.to_c()
    /// True
    #[pyo3(signature = (name=None, precision="single"))]
    fn to_c(&self, name: Option<&str>, precision: &str) -> PyResult<String> {
        self.exported(name, precision, |export| export.c().map_err(refused))
    }

    /// Its settings as a Rust constant for coilsense-rt.
    ///
    /// Parameters
    /// ----------
    /// name : str, optional
    ///     What the constant is called; without it force_filter or force_estimator.
    /// precision : {"single", "double"}
    ///     ``f32`` or ``f64``.
    ///
    /// Returns
    /// -------
    /// str
    #[pyo3(signature = (name=None, precision="single"))]
    fn to_rust(&self, name: Option<&str>, precision: &str) -> PyResult<String> {
        self.exported(name, precision, |export| Ok(export.rust()))
    }

    /// Its settings as JSON, in full precision.
    ///
    /// Parameters
    /// ----------
    /// name : str, optional
    ///     What it is called; without it force_filter or force_estimator.
    ///
    /// Returns
    /// -------
    /// str
    #[pyo3(signature = (name=None))]
    fn to_json(&self, name: Option<&str>) -> PyResult<String> {
        self.exported(name, "double", |export| {
            serde_json::to_string_pretty(&export.json()).map(|text| text + "\n").map_err(refused)
        })
    }

    /// What it is worth, by the names of its attributes.
    ///
    /// Returns
    /// -------
    /// dict
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let dict = PyDict::new(py);
        dict.set_item("name", self.name())?;
        dict.set_item("origin", self.origin())?;
        dict.set_item("against", self.against())?;
        dict.set_item("rms_error", self.rms_error())?;
        dict.set_item("worst_rms_error", self.worst_rms_error())?;
        dict.set_item("worst_run", self.worst_run())?;
        dict.set_item("aligned_rms_error", self.aligned_rms_error())?;
        dict.set_item("delay", self.delay())?;
        dict.set_item("lag", self.lag())?;
        dict.set_item("noise_gain", self.noise_gain())?;
        dict.set_item("settling", self.settling())?;
        dict.set_item("settings", self.settings(py)?)?;
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        let judged = self.judgement();
        format!(
            "<Remedy {}: {} of {} N worst, lag {} rad>",
            self.candidate().name,
            self.against(),
            judged.worst,
            self.lag()
        )
    }
}

impl PyRemedy {
    /// Whether it takes nothing but F_i: two springs of different length under the same force make no difference to it.
    fn filters_force(&self) -> bool {
        let at = |ends: [f64; 2]| self.candidate().run(&[Measured { force: 1.0, ends }]);
        at([0.0, 0.1]) == at([0.0, 0.2])
    }
}

fn joined(force: &[f64], u1: &[f64], u2: &[f64]) -> PyResult<Vec<Measured<f64>>> {
    for (name, series, unit) in [("force", force, "N"), ("u1", u1, "m"), ("u2", u2, "m")] {
        if series.len() != force.len() {
            let (wanted, got) = (force.len(), series.len());
            return Err(Error::new_err(format!("{name} must hold {wanted} values, as force does, got {got}")));
        }
        if let Some(place) = series.iter().position(|value| !value.is_finite()) {
            return Err(Error::new_err(format!("{name}[{place}] must be finite, got {} {unit}", series[place])));
        }
    }
    let each = force.iter().zip(u1).zip(u2);
    Ok(each.map(|((force, first), second)| Measured { force: *force, ends: [*first, *second] }).collect())
}
