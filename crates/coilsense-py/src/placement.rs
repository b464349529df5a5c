//! `coilsense.placement` and `Placement`: which force a control loop may feed back, and how fast it can then be.
//!
//! Next door: the spec, whose table `[control]` describes the loop (`spec_argument`).

use std::sync::Arc;

use coilsense::control::Run;
use coilsense_lab::placement::{Assessment, LoopRun, Placement};
use coilsense_lab::report::{add_placement, placement_json, placement_text};
use numpy::ToPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::refused;
use crate::long_work::interruptible;
use crate::results::study_result;
use crate::spec_argument::SpecArgument;
use crate::value::getters;

/// Every force judged as the one that is fed back; made by `placement`. ``str()`` of it is what ``coilsense placement`` prints.
///
/// Crossovers are those of the loop with a spring without mass; ``inf`` stands for what is without bound. Each figure is the worst over the
/// springs that the spec's tolerances allow, with surge frequencies as the model leaves them open.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
/// >>> loop = '\n[control]\ndrive = "velocity"\nsample_time = "0.4 ms"\n'
/// >>> placed = coilsense.placement(text + loop)
/// >>> placed.feed_back
/// 'F_i'
#[pyclass(name = "Placement", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyPlacement(Arc<Placement>);

getters! {
    PyPlacement, self;
    /// The answer, a sentence each.
    answer: Vec<String> = coilsense_lab::placement::answer(&self.0);
    /// The force to feed back: that of the fastest loop with a sensitivity of at most 2 at every damping in which neither end force rises
    /// above 3 times its static response.
    feed_back: &'static str = self.0.candidates[self.0.best].channel.name();
    /// The loop's crossover as it is set, with a spring without mass [Hz].
    crossover: f64 = self.0.crossover;
    /// The proportional gain that makes it so, in command units per N.
    gain: f64 = self.0.gain;
    /// The drive's command unit.
    command_unit: &'static str = self.0.control.drive.command_unit();
    /// The drive of all runs over time, in words.
    drive: String = coilsense_lab::placement::drive_words(&self.0.control.drive);
    /// Whether the loop on that force, run over time, turned unstable where predicted; None where there is no limit, or no run.
    confirmed: Option<bool> = self.0.best_run().verdict.confirmed();
}

study_result! {
    PyPlacement, self;
    /// Everything, under the names of results.json; None stands for what is without bound.
    to_dict = placement_json(&self.0);
    /// The limits as a data frame of pandas; ``pip install coilsense[pandas]``.
    to_pandas = "limits_frame";
    /// Draws the crossovers up to which each force may be fed back with matplotlib; ``pip install coilsense[plot]``.
    plot = "placement_plot";
    str = placement_text(&self.0);
    html = "placement_html";
    /// Writes what ``coilsense placement --out`` writes: report.html and results.json; all of it or nothing.
    save(date, output) = add_placement(&self.0, date, output);
}

#[pymethods]
impl PyPlacement {
    /// The limits of each force and, behind estimators, of each estimate: (stable, robust) crossover [Hz] by name, up to which it is stable and
    /// its sensitivity at most 2; zero where it is at none, and see ``robust_from``.
    #[getter]
    fn limits<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for force in &self.0.candidates {
            dict.set_item(force.channel.name(), (force.stable_crossover(), force.robust_crossover()))?;
        }
        for estimate in &self.0.estimates {
            dict.set_item(estimate.name, (estimate.stable_crossover, estimate.robust_crossover))?;
        }
        Ok(dict)
    }

    /// The crossover [Hz] from which on the sensitivity is at most 2, by name as in ``limits``; zero where it is in the slowest loop, too.
    #[getter]
    fn robust_from<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for force in &self.0.candidates {
            dict.set_item(force.channel.name(), force.robust_from())?;
        }
        for estimate in &self.0.estimates {
            dict.set_item(estimate.name, estimate.robust_from)?;
        }
        Ok(dict)
    }

    /// Margins of each force's loop as it is set, a dict per damping: stable, gain_limit [1], phase [rad], delay [s], modulus [1], and the
    /// peaks of F_i (drive) and F_o (load) over the reference with their frequencies [Hz]; None where the loop is unstable.
    #[getter]
    fn margins<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for force in &self.0.candidates {
            let each = force.judged.iter().zip(&self.0.dampings);
            let each =
                each.map(|(judged, damping)| margins(py, judged, &damping.label)).collect::<PyResult<Vec<_>>>()?;
            dict.set_item(force.channel.name(), each)?;
        }
        Ok(dict)
    }

    /// Each force and each estimate run over time with the drive of the spec, a dict by name: damping (where it has the least to spare), stiffness_off and
    /// surge_off (by which shares k and the first surge frequency of the spring are off on which that is), stable (by its response over frequency), ran_away_at [s], load and load_swing (F_o in the last tenth of a second's run and how far it moves,
    /// over a step of 1 % of F_nom), largest_command, limit_confirmed (stable at 0.98 and unstable at 1.02 times its predicted limit),
    /// coil_error (F_L read off the whole inductance, over the step), not_run (why), and the run itself: time [s], F_i, F_o and fed_back [N] less
    /// their means, command. None stands for what does not apply. Linear: no limits of command, no friction but viscous, no noise, no windings
    /// that touch.
    #[getter]
    fn over_time<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for run in &self.0.runs {
            dict.set_item(run.fed_back, over_time(py, run)?)?;
        }
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        format!(
            "<Placement of {}: feed back {}, crossover {} Hz>",
            self.0.spec.file,
            self.feed_back(),
            self.0.crossover
        )
    }
}

fn margins<'py>(py: Python<'py>, judged: &Assessment, damping: &str) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("damping", damping)?;
    dict.set_item("stable", judged.margins.stable)?;
    dict.set_item("gain_limit", judged.margins.gain_limit)?;
    dict.set_item("phase", judged.margins.phase)?;
    dict.set_item("delay", judged.margins.delay)?;
    dict.set_item("modulus", judged.margins.modulus)?;
    let [drive, load] = [0, 1].map(|end| judged.peaks.map(|peaks| peaks[end]));
    dict.set_item("drive_peak", drive.map(|peak| peak.size))?;
    dict.set_item("drive_peak_frequency", drive.map(|peak| peak.at))?;
    dict.set_item("load_peak", load.map(|peak| peak.size))?;
    dict.set_item("load_peak_frequency", load.map(|peak| peak.at))?;
    Ok(dict)
}

fn over_time<'py>(py: Python<'py>, run: &LoopRun) -> PyResult<Bound<'py, PyDict>> {
    let (dict, shown) = (PyDict::new(py), run.shown.as_ref().ok());
    dict.set_item("damping", &run.damping)?;
    dict.set_item("stiffness_off", run.off[0])?;
    dict.set_item("surge_off", run.off[1])?;
    dict.set_item("stable", run.stable)?;
    dict.set_item("ran_away_at", shown.and_then(|shown| shown.ran_away_at))?;
    dict.set_item("load", run.last.map(|[place, _]| place))?;
    dict.set_item("load_swing", run.last.map(|[_, swing]| swing))?;
    dict.set_item("largest_command", shown.map(|_| run.largest_command))?;
    dict.set_item("limit_confirmed", run.verdict.confirmed())?;
    dict.set_item("coil_error", run.coil_error)?;
    dict.set_item("not_run", run.shown.as_ref().err())?;
    let none = Run::default();
    let Run { time, input, output, fed_back, command, .. } = shown.unwrap_or(&none);
    for (name, series) in
        [("time", time), ("F_i", input), ("F_o", output), ("fed_back", fed_back), ("command", command)]
    {
        dict.set_item(name, shown.map(|_| series.to_pyarray(py)))?;
    }
    Ok(dict)
}

/// Which force a control loop may feed back: limits of stability and margins of F_i, F_o, F_x and F_L, and behind estimators.
///
/// Parameters
/// ----------
/// spec : Spec, str or os.PathLike
///     Its table [control] describes the loop.
///
/// Returns
/// -------
/// Placement
///
/// Raises
/// ------
/// SpecError
///     For a spec that cannot be read.
/// Error
///     For a spec without [control], or without damping.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
/// >>> loop = '\n[control]\ndrive = "velocity"\nsample_time = "0.4 ms"\n'
/// >>> placed = coilsense.placement(text + loop)
/// >>> stable, robust = placed.limits["F_o"]
/// >>> robust < stable
/// True
#[pyfunction]
pub fn placement(py: Python<'_>, spec: SpecArgument<'_>) -> PyResult<PyPlacement> {
    let spec = spec.spec(py)?;
    let placement = interruptible(py, move || Placement::of(spec))?.map_err(refused)?;
    Ok(PyPlacement(Arc::new(placement)))
}
