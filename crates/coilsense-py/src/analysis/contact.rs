//! What windings did when they met, as a dict of arrays.
//!
//! Next door: the case that it is of (`case`).

use coilsense::contact::Touch;
use coilsense_lab::study::Contacts;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::series::frozen;

/// Everything of one run, in SI; nan where something lasted to the end.
pub fn contact<'py>(py: Python<'py>, contacts: &Contacts) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("first_contact", contacts.first)?;
    dict.set_item("holds_until", contacts.holds_until)?;
    dict.set_item("until", contacts.until)?;
    dict.set_item("energy_lost", contacts.balance.lost)?;
    dict.set_item("least_cam_force", contacts.least_cam_force)?;
    dict.set_item("touches", touches(py, contacts)?)?;
    dict.set_item("meetings", meetings(py, contacts)?)?;
    dict.set_item("lifts", lifts(py, contacts)?)?;
    dict.set_item("floats", floats(py, contacts)?)?;
    Ok(dict)
}

fn touches<'py>(py: Python<'py>, contacts: &Contacts) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let between: Vec<String> = contacts.touches.iter().map(|touch| contacts.between(touch).words()).collect();
    dict.set_item("between", between)?;
    let column = |of: &dyn Fn(&Touch) -> f64| frozen(py, contacts.touches.iter().map(of).collect());
    dict.set_item("time", column(&|touch| touch.time))?;
    dict.set_item("turn", column(&|touch| contacts.turn(touch)))?;
    dict.set_item("closing_speed", column(&|touch| touch.closing_speed))?;
    dict.set_item("duration", column(&|touch| lasted(touch.time, touch.parted)))?;
    dict.set_item("impulse", column(&|touch| touch.impulse))?;
    dict.set_item("pressed", column(&|touch| touch.pressed))?;
    dict.set_item("energy_lost", column(&|touch| touch.lost))?;
    Ok(dict)
}

fn lasted(from: f64, until: Option<f64>) -> f64 {
    until.map_or(f64::NAN, |until| until - from)
}

fn meetings<'py>(py: Python<'py>, contacts: &Contacts) -> PyResult<Bound<'py, PyList>> {
    let list = PyList::empty(py);
    for meeting in &contacts.meetings {
        let dict = PyDict::new(py);
        dict.set_item("between", meeting.between.words())?;
        dict.set_item("touches", meeting.count)?;
        dict.set_item("share_of_time_closed", meeting.closed)?;
        dict.set_item("largest_closing_speed", meeting.speed)?;
        dict.set_item("impulse", meeting.impulse)?;
        dict.set_item("largest_impulse", meeting.largest_impulse)?;
        dict.set_item("energy_lost", meeting.lost)?;
        list.append(dict)?;
    }
    Ok(list)
}

fn lifts<'py>(py: Python<'py>, contacts: &Contacts) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let ends: Vec<u8> = contacts.lifts.iter().map(|lift| if lift.is_end2 { 2 } else { 1 }).collect();
    dict.set_item("end", ends)?;
    dict.set_item("time", frozen(py, contacts.lifts.iter().map(|lift| lift.time).collect()))?;
    dict.set_item("duration", frozen(py, contacts.lifts.iter().map(|lift| lasted(lift.time, lift.back)).collect()))?;
    Ok(dict)
}

fn floats<'py>(py: Python<'py>, contacts: &Contacts) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let each = || contacts.floats.iter();
    dict.set_item("time", frozen(py, each().map(|float| float.time).collect()))?;
    dict.set_item("duration", frozen(py, each().map(|float| lasted(float.time, float.back)).collect()))?;
    dict.set_item("closing_speed", frozen(py, each().map(|float| float.closing_speed).collect()))?;
    dict.set_item("impulse", frozen(py, each().map(|float| float.impulse).collect()))?;
    Ok(dict)
}
