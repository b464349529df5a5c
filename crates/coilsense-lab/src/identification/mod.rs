//! A measured log identified: is it the spring that rings, and what spring is it?
//!
//! Next door: the science (`coilsense::identify`), where logs come from (`crate::recording`), its report (`crate::report`).

mod answer;
mod expected;
pub mod request;
mod spec_file;

pub(crate) use answer::interval;
pub use answer::{answer, component_name};
pub use expected::Expected;
pub use spec_file::{Coil, SpecFileError, spec_file};

use coilsense::Signals;
use coilsense::identify::{Identification, Settings};

use crate::message::Message;
use crate::recording::Recording;

/// A log and what it says.
#[derive(Debug, Clone, PartialEq)]
pub struct Identified {
    /// The log's name, as it was given.
    pub file: String,
    /// What the log says of its being simulated, where it does.
    pub simulated: Option<String>,
    /// What became of its rows, line by line.
    pub account: Vec<String>,
    /// What was recorded.
    pub signals: Signals,
    /// What it says.
    pub found: Identification,
}

impl Identified {
    /// Identifies a log.
    ///
    /// # Errors
    /// [`IdentificationError`] with the log's name, for a log without a force, too short, or uneven in time.
    pub fn of(recording: Recording, settings: &Settings) -> Result<Self, IdentificationError> {
        let file = recording.account().file.display().to_string();
        // Says where a log is uneven, and how to clean it.
        recording.sample_rate().map_err(|error| IdentificationError(error.into()))?;
        let found = Identification::of(recording.signals(), settings)
            .map_err(|error| IdentificationError(format!("{file}: {error}").into()))?;
        Ok(Self {
            simulated: recording.simulated().map(str::to_owned),
            account: recording.account().lines(),
            signals: recording.into_signals(),
            found,
            file,
        })
    }
}

/// A log that cannot be identified.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{0}")]
pub struct IdentificationError(Message);

impl From<IdentificationError> for Message {
    fn from(error: IdentificationError) -> Self {
        error.0
    }
}
