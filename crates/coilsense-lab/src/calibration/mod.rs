//! A calibration: measured pairs of length and inductance, the curve through them, and the theories beside it.
//!
//! `measured` holds the pairs and where they come from, `log` takes them from a log and `lab_data` from one rig's files, `plan` says what is wanted, `outcome` works it
//! off, `curve` is a relation that was fitted and `taken` what it makes of the points, beside its rivals; `force` goes on to newtons, `answer` puts it into words. Next door: the formulas (`coilsense::calibrate`), how it looks (`report`).

mod answer;
mod applied;
mod curve;
mod force;
mod lab_data;
mod log;
mod measured;
mod median;
mod outcome;
mod permeabilities;
mod plan;
pub mod request;
mod steel;
mod stored;
mod taken;

pub use answer::answer;
pub(crate) use answer::with_error;
pub use applied::Applied;
pub use curve::Curve;
pub use lab_data::{lab_data_of, read_lab_data};
pub use measured::{Measured, Unused};
pub(crate) use median::median;
pub use outcome::{Assessment, Outcome, THEORY_POINTS};
pub use permeabilities::ByPermeability;
pub use plan::{Method, Plan, Preload, Relation, SteelPlan};
pub use taken::{ByNumber, Contest, Rival, Taken};

use crate::message::Message;
use crate::stored::StoredError;
pub use crate::stored::{ForceLaw, Reading, StoredCalibration};

/// A calibration that cannot be made: one line with the file or quantity, the value and what is allowed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct CalibrationError(Message);

impl CalibrationError {
    pub(crate) fn new(message: impl Into<Message>) -> Self {
        Self(message.into())
    }

    /// Of a file, with what is wrong in it.
    pub(crate) fn of(file: &str, message: impl Into<Message>) -> Self {
        Self(Message::from(format!("{file}: ")) + message)
    }
}

impl From<StoredError> for CalibrationError {
    fn from(error: StoredError) -> Self {
        Self(error.into())
    }
}

impl From<CalibrationError> for Message {
    fn from(error: CalibrationError) -> Self {
        error.0
    }
}
