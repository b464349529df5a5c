//! `coilsense.Clash`: windings that touch, where the linear model ends.
//!
//! Next door: forces that are off (`deviation`).

use coilsense::Clash;
use coilsense_lab::quantity::Dimension;
use pyo3::prelude::*;

use crate::count::Count;
use crate::errors::IntoPython;
use crate::long_work::of_series;
use crate::motion::PyMotion;
use crate::quantity::{Quantity, si};
use crate::series::Series;
use crate::value::{getters, named_value};

/// How near neighbouring windings come over a motion.
///
/// Made by ``Clash.of``; the constructor takes what is known already.
///
/// Parameters
/// ----------
/// smallest_pitch : float or str
///     Smallest distance between neighbouring windings [m], centre to centre; infinite for a single winding.
/// time : float or str
///     When [s].
/// winding : int
///     The lower-numbered of the two windings, from 1.
/// contact_pitch : float or str
///     At this pitch windings touch [m].
/// first_contact : float, str or None
///     First time at which they touch [s]; None where they stay clear.
///
/// Examples
/// --------
/// >>> import coilsense
/// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
/// >>> clash = coilsense.Clash.of(motion, coilsense.sampled_window(10_000, 0.0, 0.1))
/// >>> clash.happens, round(1e3 * clash.clearance, 3)
/// (False, 2.347)
#[pyclass(name = "Clash", module = "coilsense", frozen, eq)]
#[derive(PartialEq)]
pub struct PyClash(pub Clash);

getters! {
    PyClash, self;
    /// Smallest distance between neighbouring windings [m], centre to centre; infinite for a single winding.
    smallest_pitch: f64 = self.0.smallest_pitch;
    /// When they are that near [s].
    time: f64 = self.0.time;
    /// The lower-numbered of the two windings, from 1.
    winding: usize = self.0.winding;
    /// At this pitch windings touch [m].
    contact_pitch: f64 = self.0.contact_pitch;
    /// First time at which they touch [s]; None where they stay clear.
    first_contact: Option<f64> = self.0.first_contact;
    /// Whether windings touch.
    happens: bool = self.0.happens();
    /// Smallest distance between the wires' surfaces [m], below zero where they would overlap.
    clearance: f64 = self.0.clearance();
}

named_value! {
    /// The values by name.
    PyClash, self;
    smallest_pitch, time, winding, contact_pitch, first_contact,
}

#[pymethods]
impl PyClash {
    #[new]
    #[pyo3(signature = (*, smallest_pitch, time, winding, contact_pitch, first_contact))]
    fn new(
        smallest_pitch: Quantity,
        time: Quantity,
        winding: Count,
        contact_pitch: Quantity,
        first_contact: Option<Quantity>,
    ) -> PyResult<Self> {
        Ok(Self(Clash {
            smallest_pitch: smallest_pitch.si("smallest_pitch", Dimension::Length)?,
            time: time.si("time", Dimension::Time)?,
            winding: winding.size("winding")?,
            contact_pitch: contact_pitch.si("contact_pitch", Dimension::Length)?,
            first_contact: si(first_contact.as_ref(), "first_contact", Dimension::Time)?,
        }))
    }

    /// Of a motion, watched at some times; the first contact is then refined between samples.
    ///
    /// Parameters
    /// ----------
    /// motion : Motion
    ///     The motion.
    /// times : array_like of float, shape (samples,)
    ///     [s], strictly increasing.
    /// contact_pitch : float or str, optional
    ///     At this pitch windings touch [m]; without it the wire's diameter.
    ///
    /// Returns
    /// -------
    /// Clash
    ///
    /// Raises
    /// ------
    /// Error
    ///     For no times, or a time that is not finite, below zero, or not after its predecessor.
    ///
    /// Examples
    /// --------
    /// >>> import coilsense
    /// >>> motion = coilsense.Motion(coilsense.Spring.of_paper("S_T"), coilsense.Excitation.impact(0.23, 0.25))
    /// >>> coilsense.Clash.of(motion, coilsense.sampled_window(10_000, 0.0, 0.1)).happens
    /// False
    #[staticmethod]
    #[pyo3(signature = (motion, times, contact_pitch=None))]
    fn of(motion: &Bound<'_, PyMotion>, times: Series<'_>, contact_pitch: Option<Quantity>) -> PyResult<Self> {
        let contact_pitch = si(contact_pitch.as_ref(), "contact_pitch", Dimension::Length)?;
        let times = times.values("times")?;
        let steps = motion.get().steps_of_windings(times.len());
        let found = of_series(motion, steps, &times, move |motion, times| match contact_pitch {
            None => Clash::of(&motion.0, times),
            Some(pitch) => Clash::seen(&motion.0, times, &motion.0.windings(times)?, pitch),
        });
        found?.python().map(Self)
    }
}
