//! `coilsense.Excitation`, `EndInput` and `Start`: what is done to a spring.
//!
//! Next door: what it does then (`motion`), how it is mounted (`mount`).

mod input;
mod start;

use coilsense::excitation::{End, EndInput, Excitation, Start, VelocityProfile, traverse_velocity};
use coilsense_lab::quantity::Dimension::{Length, Velocity};
use pyo3::prelude::*;

pub use input::PyEndInput;
pub use start::PyStart;

use crate::errors::{Error, IntoPython};
use crate::noun::{Noun, named};
use crate::quantity::Quantity;
use crate::spring::PySpring;
use crate::value::{getters, named_value};

/// How the ends move and how the windings start.
///
/// Parameters
/// ----------
/// mean_length : float or str
///     Length about which the ends move [m].
/// end1, end2 : EndInput, optional
///     How each end is driven; held without it.
/// start : Start, optional
///     How the windings start; at rest without it.
///
/// Raises
/// ------
/// Error
///     For a length that is not above zero, or a steady start with an input that is neither held nor made of sines.
///
/// Examples
/// --------
/// >>> from coilsense import EndInput, Excitation, Start
/// >>> shaken = Excitation(0.23, end1=EndInput.harmonic(0.005, 1.5), start=Start.massless())
/// >>> [round(length, 6) for length in shaken.length_bounds]
/// [0.225, 0.235]
#[pyclass(name = "Excitation", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyExcitation(pub Excitation);

getters! {
    PyExcitation, self;
    /// Length about which the ends move [m].
    mean_length: f64 = self.0.mean_length();
    /// How end 1 is driven.
    end1: PyEndInput = PyEndInput(self.0.input(End::One).clone());
    /// How end 2 is driven.
    end2: PyEndInput = PyEndInput(self.0.input(End::Two).clone());
    /// How the windings start.
    start: PyStart = PyStart(self.0.start().clone());
    /// Shortest and longest length that prescribed positions can reach [m], each end at its own worst moment.
    length_bounds: (f64, f64) = self.0.length_bounds();
}

named_value! {
    /// The arguments by name, nouns as dicts of their own.
    PyExcitation, self;
    mean_length, end1, end2, start,
}

#[pymethods]
impl PyExcitation {
    #[new]
    #[pyo3(signature = (mean_length, end1=None, end2=None, start=None))]
    fn new(
        mean_length: Quantity,
        end1: Option<Noun<'_, PyEndInput>>,
        end2: Option<Noun<'_, PyEndInput>>,
        start: Option<Noun<'_, PyStart>>,
    ) -> PyResult<Self> {
        let end1 = named(end1.as_ref(), "end1")?;
        let end2 = named(end2.as_ref(), "end2")?;
        let start = named(start.as_ref(), "start")?;
        let input = |end: Option<&PyEndInput>| end.map_or(EndInput::Held, |end| end.0.clone());
        let start = start.map_or(Start::Rest, |start| start.0.clone());
        Excitation::new(mean_length.si("mean_length", Length)?, input(end1), input(end2), start).python().map(Self)
    }

    /// Impact ("heel strike"): both ends stop dead at t = 0 while every winding still moves.
    ///
    /// Parameters
    /// ----------
    /// length : float or str
    ///     l [m].
    /// velocity : float or str
    ///     v [m/s], positive from end 1 to end 2.
    ///
    /// Returns
    /// -------
    /// Excitation
    ///
    /// Notes
    /// -----
    /// Source: [Weijde2017] section III-B, first condition.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Excitation.impact("230 mm", "25 cm/s").start
    /// Start.moving(velocity=0.25, profile='uniform')
    #[staticmethod]
    fn impact(length: Quantity, velocity: Quantity) -> PyResult<Self> {
        let (length, velocity) = (length.si("length", Length)?, velocity.si("velocity", Velocity)?);
        Excitation::impact(length, velocity).python().map(Self)
    }

    /// End stop: end 2, moving until t = 0, stops dead; the windings still move.
    ///
    /// Parameters
    /// ----------
    /// length : float or str
    ///     l [m].
    /// velocity : float or str
    ///     v [m/s], positive when the spring was getting longer.
    /// profile : {"uniform", "linear"}, optional
    ///     How v is shared out over the windings; linear if end 1 stood still.
    ///
    /// Returns
    /// -------
    /// Excitation
    ///
    /// Notes
    /// -----
    /// Source: [Weijde2017] section III-B, second condition.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> coilsense.Excitation.end_stop("230 mm", "25 cm/s").start
    /// Start.moving(velocity=0.25, profile='linear')
    #[staticmethod]
    #[pyo3(signature = (length, velocity, profile="linear"))]
    fn end_stop(length: Quantity, velocity: Quantity, profile: &str) -> PyResult<Self> {
        let (length, velocity) = (length.si("length", Length)?, velocity.si("velocity", Velocity)?);
        Excitation::end_stop(length, velocity, start::profile(profile)?).python().map(Self)
    }

    /// An input on one end, the other held.
    ///
    /// Parameters
    /// ----------
    /// mean_length : float or str
    ///     Length about which the end moves [m].
    /// end : {1, 2}
    ///     Which end.
    /// input : EndInput
    ///     How it is driven.
    /// start : Start, optional
    ///     How the windings start; at rest without it.
    ///
    /// Returns
    /// -------
    /// Excitation
    ///
    /// Notes
    /// -----
    /// Source: [Weijde2017] section III-B, third condition.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> shaken = coilsense.Excitation.harmonic("230 mm", 1, coilsense.EndInput.harmonic("5 mm", "10 Hz"))
    /// >>> shaken.end1.kind, shaken.end2.kind
    /// ('harmonics', 'held')
    #[staticmethod]
    #[pyo3(signature = (mean_length, end, input, start=None))]
    fn harmonic(
        mean_length: Quantity,
        end: i64,
        input: Noun<'_, PyEndInput>,
        start: Option<Noun<'_, PyStart>>,
    ) -> PyResult<Self> {
        let input = input.named("input")?;
        let start = named(start.as_ref(), "start")?;
        let start = start.map_or(Start::Rest, |start| start.0.clone());
        let mean_length = mean_length.si("mean_length", Length)?;
        Excitation::harmonic(mean_length, self::end(end)?, input.0.clone(), start).python().map(Self)
    }
}

/// Velocity of the paper's end stops: the operating range traversed in a step time of one second.
///
/// Parameters
/// ----------
/// spring : Spring
///
/// Returns
/// -------
/// float
///     v = (max_length - min_length) / 1 s [m/s].
///
/// Notes
/// -----
/// Source: [Weijde2017] eq. 12.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> spring = coilsense.Spring.of_paper("S_T")
/// >>> round(coilsense.traverse_velocity(spring), 6)
/// 0.068
#[pyfunction(name = "traverse_velocity")]
pub fn py_traverse_velocity(spring: Noun<'_, PySpring>) -> PyResult<f64> {
    let spring = spring.named("spring")?;
    Ok(traverse_velocity(&spring.0))
}

/// An end by its number.
pub fn end(number: i64) -> PyResult<End> {
    match number {
        1 => Ok(End::One),
        2 => Ok(End::Two),
        _ => Err(Error::new_err(format!("end must be 1 or 2, got {number}"))),
    }
}

/// The word for a profile.
pub fn profile_word(profile: VelocityProfile) -> &'static str {
    match profile {
        VelocityProfile::Uniform => "uniform",
        VelocityProfile::Linear => "linear",
    }
}
