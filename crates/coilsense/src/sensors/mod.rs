//! What a sensor makes of the spring: an estimate of force from what it can see, and what that errs by.
//!
//! ```text
//! Quantity ─ on(Site) ─► Sensor ─► Instrument:  signals ─ quantity ─► native unit ─ Readout ─► reading ─ force ─► N
//! (a kind, its settings)             └─ Measurement: what each input of the model may be off by ─► uncertainty::Budget
//! ```
//!
//! One file a kind: `load_cell`, `deflection`, `two_encoder`, `inductance`. This one is the table of them; who adds a kind writes its file
//! and is led through the matches below by the compiler.
//!
//! Next door: what happens in the spring (`motion`), how far off the estimate is (`measures`), what budgets are (`uncertainty`).

pub mod cause;
mod deflection;
mod inductance;
mod instrument;
mod load_cell;
mod measurement;
mod readout;
mod sensor;
mod two_encoder;

pub use cause::{Cause, Place};
pub use deflection::deflection_force;
pub use inductance::{FormBy, InductanceSensor, magnetic_form, usual_form};
pub use instrument::Instrument;
pub use measurement::{Limits, Measurement, SpringDoubt};
pub use readout::{MAX_ORDER, Readout, ReadoutParameters, ReadoutSteps};
pub use sensor::{Native, Sensor, Site};
pub use two_encoder::{TwoEncoder, USUAL_COMPLIANCE_TOLERANCE};

use std::sync::Arc;

use crate::error::Error;
use crate::excitation::End;
use crate::inductance::OverLength;
use crate::signals::Channel;
use crate::spring::Spring;
use sensor::Row;

/// A kind of sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A load cell at an end.
    LoadCell,
    /// Encoders, a potentiometer or a laser at the spring's ends.
    Deflection,
    /// An encoder behind a drive train, and one at end 2.
    TwoEncoder,
    /// The spring's own inductance.
    Inductance,
}

/// What a sensor measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// The force at an end \[N\].
    Force(End),
    /// u2 − u1 \[m\].
    Deflection,
    /// The elongation between a motor-side encoder and end 2 \[m\].
    TwoEncoder {
        /// Of the drive train \[m/N\].
        compliance: f64,
        /// How far that may be off, either way, as a share \[1\].
        compliance_tolerance: f64,
        /// Its whole play \[m\].
        backlash: f64,
    },
    /// The spring's inductance \[H\].
    Inductance {
        /// Whether eq. (13) is not fitted to the spring but to Maxwell's sum.
        uncalibrated: bool,
        /// Standard deviation of the departure from eq. (13)'s form, as a share of the travel \[1\].
        form: f64,
        /// How that is known.
        form_by: FormBy,
        /// Standard deviation of what mounting the spring anew adds, as a share of the travel \[1\].
        remounting: f64,
    },
}

impl Kind {
    /// All kinds, in the order in which they are listed.
    pub const ALL: [Self; 4] = [Self::LoadCell, Self::Deflection, Self::TwoEncoder, Self::Inductance];

    const fn row(self) -> &'static Row {
        match self {
            Self::LoadCell => &load_cell::ROW,
            Self::Deflection => &deflection::ROW,
            Self::TwoEncoder => &two_encoder::ROW,
            Self::Inductance => &inductance::ROW,
        }
    }

    /// Its word, in a spec and everywhere else.
    pub const fn word(self) -> &'static str {
        self.row().word
    }

    /// The kind of a word.
    pub fn named(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.word() == word)
    }

    /// What its readings are.
    pub const fn native(self) -> Native {
        self.row().native
    }

    /// Whether it watches a signal.
    pub fn watches(self, channel: Channel) -> bool {
        self.row().watches.contains(&channel)
    }

    /// Full scale of an instrument of which nobody says it, in its native unit: what the spring in use gives it to see.
    pub fn natural_range(self, spring: &Spring, coil: &dyn OverLength) -> f64 {
        (self.row().natural_range)(spring, coil)
    }
}

impl Quantity {
    /// Its kind.
    pub const fn of_kind(self) -> Kind {
        match self {
            Self::Force(_) => Kind::LoadCell,
            Self::Deflection => Kind::Deflection,
            Self::TwoEncoder { .. } => Kind::TwoEncoder,
            Self::Inductance { .. } => Kind::Inductance,
        }
    }

    /// The word of its kind.
    pub const fn kind(self) -> &'static str {
        self.of_kind().word()
    }

    /// The SI unit of its readings.
    pub const fn unit(self) -> &'static str {
        self.of_kind().native().unit()
    }

    /// Whether the force is an estimate by something else than a force, which takes the spring to be the nominal one.
    pub fn estimates(self) -> bool {
        self.of_kind().native() != Native::Force
    }

    /// Set up on a spring.
    ///
    /// # Errors
    /// What the kind says of its values: [`TwoEncoder::new`], [`crate::Calibration::theoretical`].
    pub fn on(self, site: &Site<'_>) -> Result<Arc<dyn Sensor>, Error> {
        match self {
            Self::Force(end) => Ok(load_cell::at(end)),
            Self::Deflection => Ok(deflection::on(site)),
            Self::TwoEncoder { compliance, compliance_tolerance, backlash } => {
                two_encoder::on(site, compliance, compliance_tolerance, backlash)
            }
            Self::Inductance { uncalibrated: _, form, form_by, remounting } => {
                inductance::on(site, [form, remounting], form_by)
            }
        }
    }

    /// What else the same instrument could watch, each with its name: another place, a better drive train.
    pub fn alternatives(self) -> Vec<(&'static str, Self)> {
        match self {
            Self::Force(end) => load_cell::alternatives(end),
            Self::TwoEncoder { compliance, compliance_tolerance, .. } => {
                two_encoder::alternatives(compliance, compliance_tolerance)
            }
            Self::Deflection | Self::Inductance { .. } => Vec::new(),
        }
    }

    /// What mounting the spring anew adds to that, as a share of the travel \[1\]; `None` of kinds without such a form.
    pub fn remounting_mut(&mut self) -> Option<&mut f64> {
        match self {
            Self::Inductance { remounting, .. } => Some(remounting),
            Self::Force(_) | Self::Deflection | Self::TwoEncoder { .. } => None,
        }
    }

    /// How far its calibration may be off the form that it takes, as a share of the travel \[1\]; `None` of kinds without such a form.
    pub fn form_mut(&mut self) -> Option<&mut f64> {
        match self {
            Self::Inductance { form, .. } => Some(form),
            Self::Force(_) | Self::Deflection | Self::TwoEncoder { .. } => None,
        }
    }
}
