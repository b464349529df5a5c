//! What a calibration is made of: points from arrays, recordings and logs, and the law that goes on to force.
//!
//! Next door: what is made of them (the parent).

use std::path::PathBuf;

use coilsense::calibrate::CalibrationPoints;
use coilsense_lab::calibration::request::{LENGTH_AT_ZERO_FORCE, STIFFNESS};
use coilsense_lab::calibration::{ForceLaw, Measured, read_lab_data};
use coilsense_lab::recording::request::LAB_DATA;
use coilsense_lab::recording::{Cleaning, Points};
use coilsense_lab::request::Given;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{Error, IntoPython};
use crate::log_options::LogOptions;
use crate::long_work::interruptible;
use crate::quantity::{Anything, neither};
use crate::recording::PyRecording;
use crate::series::Series;
use crate::spring_argument::Known;

/// Where points come from.
#[derive(FromPyObject)]
pub enum PointsArgument<'py> {
    /// A log that was read.
    Recording(Bound<'py, PyRecording>),
    /// Lengths and inductances.
    Arrays(Series<'py>, Series<'py>),
    /// A log.
    Path(PathBuf),
    /// Something else.
    Other(Anything),
}

/// The points; `zero` is the length of the coil where positions read zero \[m\].
pub fn measured(
    py: Python<'_>,
    points: PointsArgument<'_>,
    zero: Option<f64>,
    preset: Option<String>,
    columns: Option<Bound<'_, PyDict>>,
    units: Option<Bound<'_, PyDict>>,
) -> PyResult<Measured> {
    let of_a_path = matches!(points, PointsArgument::Path(_));
    if !of_a_path && (preset.is_some() || columns.is_some() || units.is_some()) {
        return Err(Error::new_err("preset, columns and units go with the path of a log only"));
    }
    match points {
        PointsArgument::Recording(recording) => Measured::of_log(&Points::of(&recording.get().0), zero).python(),
        PointsArgument::Arrays(lengths, inductances) => {
            of_arrays(&lengths.values("points[0]")?, &inductances.values("points[1]")?, zero)
        }
        PointsArgument::Other(object) => {
            Err(neither("points", "a Recording, the path of a log, or a tuple of lengths and inductances", &object))
        }
        PointsArgument::Path(path) if preset.as_deref() == Some(LAB_DATA) => {
            let needed = "length_at_zero is needed: the file holds displacements, the curve is one of lengths";
            let zero = zero.ok_or_else(|| Error::new_err(needed))?;
            interruptible(py, move || read_lab_data(&path, zero))?.python()
        }
        PointsArgument::Path(path) => {
            let options = LogOptions { columns, units, preset, ..LogOptions::default() };
            let mapping = options.mapping()?;
            let points = interruptible(py, move || Points::read(&path, &mapping, &Cleaning::default()))?.python()?;
            Measured::of_log(&points, zero).python()
        }
    }
}

fn of_arrays(lengths: &[f64], inductances: &[f64], zero: Option<f64>) -> PyResult<Measured> {
    let lengths: Vec<f64> = lengths.iter().map(|length| zero.unwrap_or(0.0) + length).collect();
    let points = CalibrationPoints::new(&lengths, inductances).python()?;
    Ok(Measured {
        file: "points".to_owned(),
        points,
        standard_errors: Vec::new(),
        resistances: Vec::new(),
        unused: Vec::new(),
        rows: (1..=lengths.len()).collect(),
        zero_length: zero,
        account: Vec::new(),
        simulated: false,
    })
}

/// The law by arguments, or by a spec's spring with its tolerances taken as evenly spread.
pub fn force(given: &Given, spec: Option<&Known>) -> PyResult<Option<ForceLaw>> {
    let told = [&STIFFNESS, &LENGTH_AT_ZERO_FORCE].map(|row| given.holds(row));
    match (spec, told) {
        (Some(spec), [false, false]) => {
            let (stiffness, even) = (spec.spring.stiffness(), 1.0 / 3.0_f64.sqrt());
            Ok(Some(ForceLaw {
                stiffness,
                stiffness_u: even * stiffness * spec.stiffness_tolerance,
                rest_length: spec.spring.rest_length(),
                rest_length_u: even * spec.rest_length_tolerance,
            }))
        }
        (Some(_), ..) => Err(Error::new_err("spring and stiffness say the same thing; give one of them")),
        (None, [true, true] | [false, false]) => Ok(ForceLaw::given(given)),
        _ => Err(Error::new_err("stiffness and length_at_zero_force go together")),
    }
}
