//! What is wrong with a log, in one line.
//!
//! Next door: who finds it (`text`, `selection`, `order`, `complete`, `spacing`).

use std::fmt::Display;
use std::path::Path;

/// Why a log cannot be used, in one line that names file, line and column, what is there, and what would do.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct RecordingError(String);

impl RecordingError {
    /// About a file as a whole.
    pub(crate) fn of_file(file: &Path, message: impl Display) -> Self {
        Self(format!("{}: {message}", file.display()))
    }

    /// About a line of a text, or a row of a file that has no lines.
    pub(crate) fn of_line(file: &Path, line: u64, message: impl Display) -> Self {
        Self(format!("{}:{line}: {message}", file.display()))
    }

    /// About what somebody has typed.
    pub(crate) fn of_words(message: impl Display) -> Self {
        Self(message.to_string())
    }
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
