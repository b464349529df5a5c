//! TOML specs: the one input model of command, sweeps and page.
//!
//! Next door: the units in its strings (`quantity`), what is done with a spring (`reproduce`).

mod section;
mod spring;

pub use spring::NamedSpring;

/// Why a spec cannot be used, in one line that names file, line, key, value and what is allowed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct SpecError(String);

/// `file:line: text`.
fn located(file: &str, text: &str, offset: usize, message: impl std::fmt::Display) -> SpecError {
    let line = 1 + text
        .as_bytes()
        .iter()
        .take(offset)
        .filter(|&&byte| byte == b'\n')
        .count();
    SpecError(format!("{file}:{line}: {message}"))
}
