//! What is wrong with a log, in one line.
//!
//! Next door: who finds it (`text`, `selection`, `order`, `complete`, `spacing`).

use std::path::Path;

#[cfg(feature = "decoders")]
use crate::guarded::Damaged;
use crate::message::{Hint, Message};

/// Why a log cannot be used, in one line that names file, line and column, what is there, and what would do.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct RecordingError(Message);

impl RecordingError {
    /// About a file as a whole.
    pub(crate) fn of_file(file: &Path, message: impl Into<Message>) -> Self {
        Self(Message::from(format!("{}: ", file.display())) + message)
    }

    /// About a line of a text, or a row of a file that has no lines.
    pub(crate) fn of_line(file: &Path, line: u64, message: impl Into<Message>) -> Self {
        Self(Message::from(format!("{}:{line}: ", file.display())) + message)
    }

    /// What is said of the file, without its name.
    pub(super) fn without_file(self, file: &Path) -> Message {
        self.0.without(&format!("{}: ", file.display()))
    }

    /// About what somebody has typed.
    pub(crate) fn of_words(message: impl Into<Message>) -> Self {
        Self(message.into())
    }
}

#[cfg(feature = "decoders")]
impl From<Damaged> for RecordingError {
    fn from(damaged: Damaged) -> Self {
        Self::of_file(&damaged.file, Damaged::WORDS)
    }
}

impl From<RecordingError> for Message {
    fn from(error: RecordingError) -> Self {
        error.0
    }
}

/// The options that take a part of a log.
pub(super) fn window() -> Message {
    Message::from(Hint::Open("from")) + " and " + Hint::Open("to")
}

/// That incomplete rows may be left out.
pub(super) fn leave_out() -> Message {
    Message::from(Hint::Flag("drop_incomplete")) + " leaves such rows out"
}

/// A text of a file as a message quotes it: on one line, and not long.
pub(super) fn clipped(text: &str) -> String {
    const MOST: usize = 40;
    let plain: String = text.chars().take(MOST).collect();
    if text.chars().nth(MOST).is_some() { format!("{plain:?}…") } else { format!("{plain:?}") }
}

/// The same without quotes around it.
pub(super) fn shortened(text: &str) -> String {
    let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).take(60).collect();
    if text.chars().count() > 60 { format!("{plain}…") } else { plain }
}
