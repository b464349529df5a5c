//! Something by which a force errs, where it acts, and what the usual ones are called: the lines of a budget.
//!
//! Next door: how each acts on the force (`measurement`).

use crate::uncertainty::{Distribution, Input};

/// Noise of the readings.
pub const NOISE: &str = "sensor: noise";
/// Steps between readings.
pub const RESOLUTION: &str = "sensor: resolution";
/// Limits of error that are the same for every reading.
pub const FULL_SCALE: &str = "sensor: accuracy of full scale";
/// Limits of error in proportion to the reading.
pub const OF_READING: &str = "sensor: accuracy of reading";
/// The gain, as far as a calibration knows it.
pub const CALIBRATION: &str = "calibration";
/// Measured springs depart from the form of eq. (13).
pub const MEASURED_FORM: &str = "calibration form: measured springs";
/// Eq. (13) departs from a coil of magnetic wire.
pub const MAGNETIC_FORM: &str = "calibration form: magnetic wire";
/// The theory of magnetic wire departs from measured springs.
pub const STEEL_FORM: &str = "calibration form: theory of magnetic wire";
/// What a stored calibration says of itself.
pub const STORED_FORM: &str = "calibration: as stored";
/// A spring that was remounted since it was calibrated has another constant.
pub const REMOUNTING: &str = "calibration: remounting";
/// The coil's own theory departs from it.
pub const THEORY_FORM: &str = "calibration form: eq. (13) itself";
/// Gain and modulus drift.
pub const TEMPERATURE: &str = "temperature";
/// The stiffness is not the nominal one.
pub const STIFFNESS: &str = "tolerance of the stiffness";
/// Nor the rest length.
pub const REST_LENGTH: &str = "tolerance of the rest length";
/// Nor the initial tension.
pub const INITIAL_TENSION: &str = "tolerance of the initial tension";
/// Nor the compliance of the drive train.
pub const COMPLIANCE: &str = "tolerance of the drive train's compliance";

/// Where an input acts in the model, in the order in which budgets list them and Monte Carlos draw them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// Added to the force \[N\]: oscillation.
    Force,
    /// Added to the reading, in the native unit.
    Reading,
    /// A share of the reading, counted from the instrument's zero.
    Gain,
    /// Added to the length that is read from something else \[m\].
    Length,
    /// \[K\].
    Temperature,
    /// A share of the stiffness.
    Stiffness,
    /// Added to the rest length \[m\].
    RestLength,
    /// A share of the initial tension.
    InitialTension,
    /// Added to the compliance in series with the spring \[m/N\].
    Compliance,
}

/// Something by which a force errs.
#[derive(Debug, Clone, PartialEq)]
pub struct Cause {
    /// Where it acts.
    pub place: Place,
    /// What it is called, one of this module's or a kind's own.
    pub name: &'static str,
    /// How far it may be off, in the unit of its place.
    pub distribution: Distribution,
}

impl Cause {
    /// A normal one of that standard deviation; `None` of nothing.
    pub fn normal(place: Place, name: &'static str, standard: f64) -> Option<Self> {
        (standard > 0.0).then_some(Self { place, name, distribution: Distribution::Normal { standard } })
    }

    /// Anything within ±`half_width` alike; `None` of nothing.
    pub fn within(place: Place, name: &'static str, half_width: f64) -> Option<Self> {
        (half_width > 0.0).then_some(Self { place, name, distribution: Distribution::Rectangular { half_width } })
    }

    /// As the input of a model.
    pub fn into_input(self) -> Input {
        Input::new(self.name, 0.0, self.distribution)
    }
}
