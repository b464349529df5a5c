//! `coilsense.EndInput`: how one end is driven.
//!
//! Next door: both ends and the start together (the parent).

use coilsense::excitation::{EndInput, Excitation, Harmonic, Sampled, Start};
use coilsense_lab::quantity::Dimension::{self, Angle, Force, Frequency, Length, Time};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::errors::IntoPython;
use crate::quantity::{Anything, Quantity, neither};
use crate::samples::Samples;
use crate::series::Series;
use crate::value::{Kind, value_of_kinds};

/// How an end is driven, counted from its mean: metres where its position is prescribed, newtons where its force is.
///
/// Made by ``EndInput.held``, ``harmonic``, ``harmonics``, ``chirp``, ``step``, ``ramp``, ``half_sine`` or ``sampled``.
///
/// Examples
/// --------
/// >>> from coilsense import EndInput
/// >>> EndInput.step(height=0.01, at=0.2)
/// EndInput.step(height=0.01, at=0.2)
/// >>> EndInput.ramp(0.01, 0.1, 0.2).displacement([0.0, 0.2, 1.0])
/// array([0.   , 0.005, 0.01 ])
#[pyclass(name = "EndInput", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyEndInput(pub EndInput);

/// Amplitude, frequency and phase of a sine.
type Component = (Quantity, Quantity, Quantity);

/// The sines of a sum.
#[derive(FromPyObject)]
enum Components {
    Listed(Vec<Component>),
    Other(Anything),
}

/// What an end is driven by: its position, or the force on it.
const AT_AN_END: [Dimension; 2] = [Length, Force];

impl PyEndInput {
    /// Lets through what an excitation would let through.
    fn checked(input: EndInput) -> PyResult<Self> {
        Excitation::new(1.0, input.clone(), EndInput::Held, Start::Rest).python().map(|_| Self(input))
    }

    fn as_kind<'py>(&self, py: Python<'py>) -> PyResult<Kind<'py>> {
        let kind = |name| Kind::new(py, name);
        match &self.0 {
            EndInput::Held => Ok(kind("held")),
            EndInput::Harmonics(harmonics) => {
                let each = harmonics.iter().map(|sine| (sine.amplitude, sine.frequency, sine.phase));
                kind("harmonics").with("components", each.collect::<Vec<_>>())
            }
            EndInput::Chirp { amplitude, from, to, duration, phase } => kind("chirp")
                .with("amplitude", amplitude)?
                .with("first_frequency", from)?
                .with("last_frequency", to)?
                .with("duration", duration)?
                .with("phase", phase),
            EndInput::Step { height, at } => kind("step").with("height", height)?.with("at", at),
            EndInput::Ramp { height, from, duration } => {
                kind("ramp").with("height", height)?.with("begin", from)?.with("duration", duration)
            }
            EndInput::HalfSine { height, from, duration } => {
                kind("half_sine").with("height", height)?.with("begin", from)?.with("duration", duration)
            }
            EndInput::Sampled(sampled) => kind("sampled")
                .with("times", PyArray1::from_slice(py, sampled.times()))?
                .with("values", PyArray1::from_slice(py, sampled.values())),
        }
    }
}

value_of_kinds! {
    /// Which constructor makes it: "held", "harmonics", "chirp", "step", "ramp", "half_sine" or "sampled".
    PyEndInput, "EndInput"; "held", "harmonics", "chirp", "step", "ramp", "half_sine", "sampled"
}

#[pymethods]
impl PyEndInput {
    /// It stays at its mean.
    ///
    /// Returns
    /// -------
    /// EndInput
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.EndInput.held().displacement(1.0)
    /// 0.0
    #[staticmethod]
    fn held() -> Self {
        Self(EndInput::Held)
    }

    /// One sine: amplitude sin(2 pi frequency t + phase).
    ///
    /// Parameters
    /// ----------
    /// amplitude : float or str
    ///     [m], or [N] at an end under force.
    /// frequency : float or str
    ///     [Hz], above zero.
    /// phase : float or str, optional
    ///     At t = 0 [rad].
    ///
    /// Returns
    /// -------
    /// EndInput
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.EndInput.harmonic("5 mm", "10 Hz").displacement([0.0, 0.025]).round(6)
    /// array([0.   , 0.005])
    #[staticmethod]
    #[pyo3(signature = (amplitude, frequency, phase=Quantity::Number(0.0)), text_signature = "(amplitude, frequency, phase=0.0)")]
    fn harmonic(amplitude: Quantity, frequency: Quantity, phase: Quantity) -> PyResult<Self> {
        let amplitude = amplitude.si_of("amplitude", &AT_AN_END)?;
        let (frequency, phase) = (frequency.si("frequency", Frequency)?, phase.si("phase", Angle)?);
        Self::checked(EndInput::harmonic(amplitude, frequency, phase))
    }

    /// A sum of sines.
    ///
    /// Parameters
    /// ----------
    /// components : sequence of (float or str, float or str, float or str)
    ///     Amplitude [m or N], frequency [Hz] and phase [rad] of each.
    ///
    /// Returns
    /// -------
    /// EndInput
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> both = coilsense.EndInput.harmonics([("5 mm", "10 Hz", 0.0), ("1 mm", "20 Hz", "90 deg")])
    /// >>> round(both.displacement(0.0), 6)
    /// 0.001
    #[staticmethod]
    fn harmonics(components: Components) -> PyResult<Self> {
        let harmonic = |(amplitude, frequency, phase): &Component| {
            Ok(Harmonic {
                amplitude: amplitude.si_of("components", &AT_AN_END)?,
                frequency: frequency.si("components", Frequency)?,
                phase: phase.si("components", Angle)?,
            })
        };
        match components {
            Components::Listed(sines) => {
                Self::checked(EndInput::Harmonics(sines.iter().map(harmonic).collect::<PyResult<_>>()?))
            }
            Components::Other(object) => {
                Err(neither("components", "a sequence of tuples of amplitude, frequency and phase", &object))
            }
        }
    }

    /// A sine whose frequency runs linearly from one value to another, and which then stays where it is.
    ///
    /// Parameters
    /// ----------
    /// amplitude : float or str
    ///     [m or N].
    /// first_frequency, last_frequency : float or str
    ///     At t = 0 and at the end of the chirp [Hz], not below zero.
    /// duration : float or str
    ///     [s], above zero.
    /// phase : float or str, optional
    ///     At t = 0 [rad].
    ///
    /// Returns
    /// -------
    /// EndInput
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> sweep = coilsense.EndInput.chirp("1 mm", "1 Hz", "100 Hz", "10 s")
    /// >>> sweep.displacement(0.0), sweep.kind
    /// (0.0, 'chirp')
    #[staticmethod]
    #[pyo3(signature = (amplitude, first_frequency, last_frequency, duration, phase=Quantity::Number(0.0)),
           text_signature = "(amplitude, first_frequency, last_frequency, duration, phase=0.0)")]
    fn chirp(
        amplitude: Quantity,
        first_frequency: Quantity,
        last_frequency: Quantity,
        duration: Quantity,
        phase: Quantity,
    ) -> PyResult<Self> {
        Self::checked(EndInput::Chirp {
            amplitude: amplitude.si_of("amplitude", &AT_AN_END)?,
            from: first_frequency.si("first_frequency", Frequency)?,
            to: last_frequency.si("last_frequency", Frequency)?,
            duration: duration.si("duration", Time)?,
            phase: phase.si("phase", Angle)?,
        })
    }

    /// A jump.
    ///
    /// Parameters
    /// ----------
    /// height : float or str
    ///     How far [m or N].
    /// at : float or str
    ///     When [s], not below zero.
    ///
    /// Returns
    /// -------
    /// EndInput
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.EndInput.step("5 mm", "100 ms").displacement([0.05, 0.2])
    /// array([0.   , 0.005])
    #[staticmethod]
    fn step(height: Quantity, at: Quantity) -> PyResult<Self> {
        let (height, at) = (height.si_of("height", &AT_AN_END)?, at.si("at", Time)?);
        Self::checked(EndInput::Step { height, at })
    }

    /// A straight rise.
    ///
    /// Parameters
    /// ----------
    /// height : float or str
    ///     How far [m or N].
    /// begin : float or str
    ///     When it begins [s], not below zero.
    /// duration : float or str
    ///     How long it lasts [s], above zero.
    ///
    /// Returns
    /// -------
    /// EndInput
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.EndInput.ramp("5 mm", 0.1, 0.2).displacement([0.0, 0.2, 1.0])
    /// array([0.    , 0.0025, 0.005 ])
    #[staticmethod]
    fn ramp(height: Quantity, begin: Quantity, duration: Quantity) -> PyResult<Self> {
        let (from, duration) = (begin.si("begin", Time)?, duration.si("duration", Time)?);
        Self::checked(EndInput::Ramp { height: height.si_of("height", &AT_AN_END)?, from, duration })
    }

    /// Half a sine, up and back: a bump.
    ///
    /// Parameters
    /// ----------
    /// height : float or str
    ///     How far [m or N].
    /// begin : float or str
    ///     When it begins [s], not below zero.
    /// duration : float or str
    ///     How long it lasts [s], above zero.
    ///
    /// Returns
    /// -------
    /// EndInput
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.EndInput.half_sine("5 mm", 0.0, 0.2).displacement([0.1, 0.3])
    /// array([0.005, 0.   ])
    #[staticmethod]
    fn half_sine(height: Quantity, begin: Quantity, duration: Quantity) -> PyResult<Self> {
        let (from, duration) = (begin.si("begin", Time)?, duration.si("duration", Time)?);
        Self::checked(EndInput::HalfSine { height: height.si_of("height", &AT_AN_END)?, from, duration })
    }

    /// A recorded series, straight from sample to sample, constant before the first and after the last.
    ///
    /// Parameters
    /// ----------
    /// times : array_like of float, shape (samples,)
    ///     [s], strictly increasing; steps may be uneven.
    /// values : array_like of float, shape (samples,)
    ///     [m, or N at an end under force].
    ///
    /// Returns
    /// -------
    /// EndInput
    ///
    /// Raises
    /// ------
    /// Error
    ///     For no samples, series of different lengths, a value that is not finite, or a time not after its predecessor.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.EndInput.sampled([0.0, 0.1, 0.3], [0.0, 1e-3, 2e-3]).displacement(0.2)
    /// 0.0015
    #[staticmethod]
    fn sampled(times: Series<'_>, values: Series<'_>) -> PyResult<Self> {
        Self::checked(EndInput::Sampled(Sampled::new(times.to_vec("times")?, values.to_vec("values")?).python()?))
    }

    /// Displacement from the mean.
    ///
    /// Parameters
    /// ----------
    /// time : float, str or array_like of float
    ///     [s].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the time
    ///     [m, or N at an end under force].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> ramp = coilsense.EndInput.ramp(0.01, 0.1, 0.2)
    /// >>> ramp.displacement("200 ms"), ramp.displacement([[0.0], [1.0]]).shape
    /// (0.005, (2, 1))
    fn displacement<'py>(&self, py: Python<'py>, time: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        time.each(py, "time", Time, |time| self.0.displacement(time))
    }

    /// Velocity, from the right where it jumps.
    ///
    /// Parameters
    /// ----------
    /// time : float, str or array_like of float
    ///     [s].
    ///
    /// Returns
    /// -------
    /// float or numpy.ndarray, of the shape of the time
    ///     [m/s, or N/s at an end under force].
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.EndInput.ramp(0.01, 0.1, 0.2).velocity([0.0, 0.2])
    /// array([0.  , 0.05])
    fn velocity<'py>(&self, py: Python<'py>, time: Samples<'py>) -> PyResult<Bound<'py, PyAny>> {
        time.each(py, "time", Time, |time| self.0.velocity(time))
    }
}
