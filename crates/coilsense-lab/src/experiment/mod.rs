//! An experiment like that of the paper's section IV, processed as IV-C says: from the logs that an `experiment.toml` lists to Figs. 5 and 6.
//!
//! `spring` takes stiffness, offset and the curve of eq. (13) from the calibration run, `fast` and `slow` read the logs of a run, `stated` asks whether it moves as it states, `mean` holds
//! means with their standard errors, `findings` says what rises, what is biased and what drifts, `answer` puts it into words, `account` what was left out. Next door: the
//! file itself (`crate::spec`), logs (`crate::recording`), how it looks (`crate::report`).

mod account;
mod answer;
mod fast;
mod findings;
mod mean;
mod outcome;
mod slow;
mod spring;
mod stated;

pub use answer::answer;
pub(crate) use answer::{pair, probability};
pub use fast::{Excerpt, Fast};
pub use findings::{Drift, Findings, Offset, Peak};
pub use mean::Mean;
pub use outcome::{Experiment, Run};
pub use slow::Slow;
pub use spring::{Curve, SpringLine};

use crate::message::Message;
use crate::recording::RecordingError;
use crate::spec::SpecError;

/// The forces whose means are compared: by the load cell, by deflection, by inductance.
pub const FORCES: [coilsense::Channel; 3] =
    [coilsense::Channel::OutputForce, coilsense::Channel::DeflectionForce, coilsense::Channel::InductanceForce];

/// An experiment that cannot be processed: one line with file, row and column, or file, line and key.
#[derive(Debug, thiserror::Error)]
pub enum ExperimentError {
    /// Its description is wrong.
    #[error(transparent)]
    Spec(#[from] SpecError),
    /// A log is wrong.
    #[error(transparent)]
    Log(#[from] RecordingError),
    /// What a log holds cannot be processed.
    #[error("{file}: {message}")]
    Refused {
        /// The file.
        file: String,
        /// What is wrong, and what is allowed.
        message: String,
    },
}

impl ExperimentError {
    fn of(file: &std::path::Path, message: impl std::fmt::Display) -> Self {
        Self::Refused { file: file.display().to_string(), message: message.to_string() }
    }
}

impl From<ExperimentError> for Message {
    fn from(error: ExperimentError) -> Self {
        match error {
            ExperimentError::Log(error) => error.into(),
            ExperimentError::Spec(_) | ExperimentError::Refused { .. } => error.to_string().into(),
        }
    }
}
