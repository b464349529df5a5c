//! `coilsense.identify` and `Identification`: is it the spring that rings, and what spring is it?
//!
//! Next door: what was recorded (`recording`), values with intervals (`estimate`).

use std::sync::Arc;

use coilsense::identify::Estimate;
use coilsense_lab::identification::request::{
    ACCURACY_FORCE, ACCURACY_POSITION, END_MASS, END2, MASS, PREDICTION_TOLERANCE, TOLERANCE, TURN, WINDINGS, settings,
};
use coilsense_lab::identification::{Coil, Identified, spec_file};
use coilsense_lab::quantity::Dimension;
use coilsense_lab::report::{add_identification, identification_json, identification_text};
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyDeprecationWarning;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{Error, IntoPython, refused};
use crate::estimate::PyEstimate;
use crate::long_work::interruptible;
use crate::names::Word;
use crate::quantity::{Quantity, given, plain, positive, wrong};
use crate::recording::recording;
use crate::results::study_result;
use crate::spring_argument::SpringArgument;
use crate::value::getters;

/// What a record says of its spring; made by `identify`. ``str()`` of it is what ``coilsense identify`` prints.
///
/// Values with intervals are `Estimate`; what was not found is None, and `stiffness_refused` or `record_next` say why.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
/// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25), mount)
/// >>> record = motion.signals(coilsense.sampled_window(2500, 0, 4))
/// >>> found = coilsense.identify(record, spring=motion.spring)
/// >>> found.verdict, round(found.first_frequency.value, 1)
/// ('spring', 54.1)
#[pyclass(name = "Identification", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyIdentification(Arc<Identified>);

/// Frequencies [Hz] and density [N²/Hz].
type Density<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

getters! {
    PyIdentification, self;
    /// Whether the spring's own modes ring, in words.
    verdict: &'static str = self.0.found.verdict.answer.name();
    /// Why, the weightiest first.
    evidence: Vec<String> = self.0.found.verdict.evidence.clone();
    /// What to record next; empty where nothing is missing.
    record_next: Vec<String> = self.0.found.verdict.next.clone();
    /// The answer, a sentence each, the verdict first.
    answer: Vec<String> = coilsense_lab::identification::answer(&self.0);
    /// f1: frequency of the first mode with both ends held, undamped [Hz].
    first_frequency: Option<PyEstimate> = estimate(self.0.found.first_frequency);
    /// Where f1 lies with 95 % [Hz]: noise, and what a mount that gives may do to it; lowest and highest.
    first_frequency_range: Option<(f64, f64)> = self.0.found.first_range;
    /// ζ: damping ratio of the lowest mode that was found [1].
    damping_ratio: Option<PyEstimate> = estimate(self.0.found.ratio);
    /// Which mode that damping ratio belongs to.
    damping_ratio_mode: Option<usize> = self.0.found.ratio_mode;
    /// k: stiffness [N/m].
    stiffness: Option<PyEstimate> = estimate(self.0.found.stiffness.as_ref().ok().map(|line| line.stiffness));
    /// Why there is no stiffness; None where there is one.
    stiffness_refused: Option<String> = self.0.found.stiffness.as_ref().err().cloned();
    /// Length without force [m]; the position without force where only one end's was recorded.
    rest_length: Option<PyEstimate> = estimate(self.0.found.stiffness.as_ref().ok().map(|line| line.length_at_zero));
    /// m: mass of the coil that rings, k τ² [kg].
    mass: Option<PyEstimate> = estimate(self.0.found.mass);
    /// Where m lies with 95 % [kg]: noise, and what a mount that gives may do to f1; lowest and highest.
    mass_range: Option<(f64, f64)> = self.0.found.mass_range;
    /// τ: how long a wave takes from end to end [s].
    transit_time: Option<PyEstimate> = estimate(self.0.found.transit_time);
    /// Mass at end 2 [kg], where end 2 moves with the ringing.
    end_mass: Option<f64> = self.0.found.end_mass;
    /// Which mount the modes fit, in words; None without modes.
    mount: Option<&'static str> = self.0.found.mode_series.map(|series| series.name());
    /// The channel whose sign is turned; None where none is.
    sign_turned: Option<&'static str> = self.0.found.turned.map(|channel| channel.name());
    /// What may be the cause of the lines, the likeliest first, each a dict under the names of results.json.
    explanations<'py>(py): PyResult<Bound<'py, PyAny>> = self.to_dict(py)?.get_item("explanations");
    /// What instruments did to the forces, each a dict under the names of results.json.
    channels<'py>(py): PyResult<Bound<'py, PyAny>> = self.to_dict(py)?.get_item("channels");
    /// The lines of the record, lowest frequency first, each a dict under the names of results.json.
    lines<'py>(py): PyResult<Bound<'py, PyAny>> = self.to_dict(py)?.get_item("lines");
    /// Times of the hits [s], shape (hits,).
    hits<'py>(py): Bound<'py, PyArray1<f64>> =
        self.0.found.hits.iter().map(|hit| hit.time).collect::<Vec<_>>().into_pyarray(py);
    /// Samples per second [Hz].
    sample_rate: f64 = self.0.found.sampling.rate;
}

study_result! {
    PyIdentification, self;
    /// Everything, under the names of results.json.
    to_dict = identification_json(&self.0, None);
    /// The lines as a data frame of pandas; ``pip install coilsense[pandas]``.
    to_pandas = "lines_frame";
    /// Draws the spectrum with its lines by matplotlib; ``pip install coilsense[plot]``.
    plot = "identification_plot";
    str = identification_text(&self.0);
    html = "identification_html";
    /// Writes what ``coilsense identify --out`` writes: report.html, results.json, figures; all of it or nothing.
    save(date, output) = add_identification(&self.0, date, output);
}

#[pymethods]
impl PyIdentification {
    /// Times of the hits [s], shape (hits,): the former name of `hits`, until the next release.
    #[getter]
    fn taps<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let category = py.get_type::<PyDeprecationWarning>();
        PyErr::warn(py, &category, c"Identification.taps is called hits now", 1)?;
        Ok(self.hits(py))
    }

    /// Up to which frequencies [Hz] forces can be trusted to a tolerance [1]: a dict, or None where f1 is not known.
    #[getter]
    fn trust<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(trust) = self.0.found.trust else { return Ok(None) };
        let dict = PyDict::new(py);
        dict.set_item("tolerance", trust.tolerance)?;
        dict.set_item("output_for_input", trust.output_for_input)?;
        dict.set_item("deflection_for_input", trust.deflection_for_input)?;
        dict.set_item("deflection_for_output", trust.deflection_for_output)?;
        Ok(Some(dict))
    }

    /// Power spectral densities of the antisymmetric and symmetric component of the forces, or of the one force there is: for each frequencies [Hz] and density [N²/Hz], shape (lines,).
    ///
    /// Notes
    /// -----
    /// Source: [Welch1967]; Hann-tapered segments, half overlapping.
    #[getter]
    fn spectra<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (part, welch) in &self.0.found.spectra {
            let frequencies: Vec<f64> = (0..welch.density.len()).map(|line| line as f64 * welch.spacing).collect();
            let density: Density<'py> = (frequencies.into_pyarray(py), PyArray1::from_slice(py, &welch.density));
            dict.set_item(coilsense_lab::identification::component_name(Some(*part)), density)?;
        }
        Ok(dict)
    }

    /// What was found as the text of a spec that `Spec.parse` and ``coilsense analyze`` read.
    ///
    /// Parameters
    /// ----------
    /// windings : float, optional
    ///     Active windings [1], which no record tells.
    /// coil_radius : float or str, optional
    ///     To the wire's centre [m].
    /// wire_radius : float or str, optional
    ///     Of the wire [m].
    /// spring : Spring, Spec, str or os.PathLike, optional
    ///     A spring or a spec that tells these three.
    ///
    /// Returns
    /// -------
    /// str
    ///     TOML.
    ///
    /// Raises
    /// ------
    /// Error
    ///     Where the three are not given, or stiffness, length or first mode was not found.
    #[pyo3(signature = (windings=None, coil_radius=None, wire_radius=None, *, spring=None))]
    fn to_spec(
        &self,
        windings: Option<Quantity>,
        coil_radius: Option<Quantity>,
        wire_radius: Option<Quantity>,
        spring: Option<SpringArgument<'_>>,
    ) -> PyResult<String> {
        let windings = plain(windings.as_ref(), "windings")?;
        let known = spring.as_ref().map(SpringArgument::known).transpose()?;
        let radius = positive(coil_radius.as_ref(), "coil_radius", Dimension::Length)?;
        let wire = positive(wire_radius.as_ref(), "wire_radius", Dimension::Length)?;
        let coil = match (known, windings, radius, wire) {
            (Some(known), None, None, None) => {
                let (windings, coil_radius) = (known.spring.windings(), known.spring.coil_radius());
                Coil { windings, coil_radius, wire_radius: known.spring.wire_radius() }
            }
            (None, Some(windings), Some(coil_radius), Some(wire_radius)) => Coil { windings, coil_radius, wire_radius },
            _ => {
                let needed = "a spec needs windings, coil_radius and wire_radius, or spring: no log of forces and positions tells them";
                return Err(Error::new_err(needed));
            }
        };
        spec_file(&self.0, &coil).map_err(refused)
    }

    fn __repr__(&self) -> String {
        let first = self.0.found.first_frequency.map_or(String::new(), |first| format!(", f1={} Hz", first.value));
        format!("<Identification of {}: {}{first}>", self.0.file, self.verdict())
    }
}

fn estimate(found: Option<Estimate>) -> Option<PyEstimate> {
    found.map(PyEstimate::from)
}

/// Whether it is the spring that rings in a record, and what spring it is: f1, damping, stiffness, mass, each with its interval.
///
/// Parameters
/// ----------
/// record : Recording, Signals, pandas.DataFrame, mapping, str or os.PathLike
///     Forces, and positions where they were recorded, on an even clock; or the path of a log whose columns carry their channels' names.
/// spring : Spring, Spec, str or os.PathLike, optional
///     Predict f1 from a spring or a spec.
/// mass : float or str, optional
///     Mass of the active coil [kg]: with the stiffness it predicts f1.
/// windings : float, optional
///     Active windings [1]; modes are then also held against those of a chain with one mass for each winding.
/// end2 : {"held", "free", "mass"}, optional
///     What end 2 is tied to; without it the record decides.
/// end_mass : float or str, optional
///     Mass at end 2 [kg]; without it F_o over the acceleration of u2.
/// turn : {"F_i", "F_o", "u1", "u2"}, optional
///     Channel whose sign is turned before anything else.
/// prediction_tolerance : float or str
///     How far a predicted f1 may be off, as a share [1].
/// tolerance : float or str
///     Dynamic error up to which a force counts as trusted, as a share [1].
/// accuracy_force, accuracy_position : float or str
///     Limits of error of the sensors, as shares of reading [1], which the intervals then hold.
///
/// Returns
/// -------
/// Identification
///
/// Raises
/// ------
/// Error
///     For a record without a force, too short, or uneven in time; settings that make no sense.
/// LogError
///     For a log that cannot be read.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spring = coilsense.Spring.of_paper("S_T")
/// >>> mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
/// >>> times = coilsense.sampled_window(2500, 0, 4)
/// >>> hit = coilsense.Motion(spring, coilsense.Excitation.impact(0.23, 0.25), mount).signals(times)
/// >>> found = coilsense.identify(hit, spring=spring)
/// >>> found.verdict, round(found.first_frequency.value, 1)
/// ('spring', 54.1)
#[pyfunction]
#[pyo3(signature = (record, *, spring=None, mass=None, windings=None, end2=None, end_mass=None, turn=None, prediction_tolerance=Quantity::Number(0.05),
                    tolerance=Quantity::Number(0.01), accuracy_force=Quantity::Number(0.0), accuracy_position=Quantity::Number(0.0)),
       text_signature = "(record, *, spring=None, mass=None, windings=None, end2=None, end_mass=None, turn=None, prediction_tolerance=0.05, \
                         tolerance=0.01, accuracy_force=0.0, accuracy_position=0.0)")]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python, one per option of the command")]
pub fn identify(
    py: Python<'_>,
    record: &Bound<'_, PyAny>,
    spring: Option<SpringArgument<'_>>,
    mass: Option<Quantity>,
    windings: Option<Quantity>,
    end2: Option<Word>,
    end_mass: Option<Quantity>,
    turn: Option<Word>,
    prediction_tolerance: Quantity,
    tolerance: Quantity,
    accuracy_force: Quantity,
    accuracy_position: Quantity,
) -> PyResult<PyIdentification> {
    let known = spring.as_ref().map(SpringArgument::expected).transpose()?;
    if known.is_some() && (mass.is_some() || windings.is_some()) {
        return Err(Error::new_err("spring says mass and windings, too; give one of them"));
    }
    let given = given([
        (&MASS, mass.into()),
        (&WINDINGS, windings.into()),
        (&END2, end2.into()),
        (&END_MASS, end_mass.into()),
        (&TURN, turn.into()),
        (&PREDICTION_TOLERANCE, prediction_tolerance.into()),
        (&TOLERANCE, tolerance.into()),
        (&ACCURACY_FORCE, accuracy_force.into()),
        (&ACCURACY_POSITION, accuracy_position.into()),
    ])?;
    let settings = settings(&given, known).map_err(wrong)?;
    let recording = recording(py, record)?;
    let identified = interruptible(py, move || Identified::of(recording, &settings))?.python()?;
    Ok(PyIdentification(Arc::new(identified)))
}
