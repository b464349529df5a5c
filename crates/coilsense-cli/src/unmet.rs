//! What `--check` was asked for and did not find.
//!
//! Next door: who asks (`analyze`, `identify`), the exit code (`main`).

/// The work is done and written, and the answer is no, or open; why, in a line.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct Unmet(pub String);
