//! TOML specs: the one input model of command, sweeps and page.
//!
//! Next door: the units in its strings (`quantity`), what is done with a spring (`reproduce`).

mod section;
mod spring;

pub use spring::NamedSpring;

use std::fmt::Display;
use std::path::Path;

/// Why a spec cannot be used, in one line that names file, line, key, value and what is allowed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct SpecError(String);

impl SpecError {
    /// A value that is fine by itself but not for the use at hand: `file: key = value: must be allowed`.
    pub(crate) fn unsuitable(file: &Path, key: &str, value: impl Display, allowed: impl Display) -> Self {
        Self(format!("{}: {key} = {value}: must be {allowed}", file.display()))
    }
}

/// `file:line: text`.
fn located(file: &str, text: &str, offset: usize, message: impl Display) -> SpecError {
    let line = 1 + text.as_bytes().iter().take(offset).filter(|&&byte| byte == b'\n').count();
    SpecError(format!("{file}:{line}: {message}"))
}
