//! coilsense in the browser: the text of a spec in, curves, numbers and warnings out.
//!
//! ```text
//! page ── spec text, which case, which times ──► Engine ──► Answer { meta: JSON, arrays of doubles }
//! ```
//!
//! The spec is the one that the command reads, read by the same reader, so that a page's numbers and a page's errors are the command's. While
//! a slider moves, [`preview`] gives the curves of what the page shows; at rest [`exact`] gives the case as `coilsense analyze` does.
//!
//! Next door: what is computed (`coilsense_lab::analysis`), the page itself (`web/`), who makes the JavaScript (`bindgen/`).

#![cfg_attr(
    not(test),
    warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, clippy::print_stderr)
)]

pub mod answer;
pub mod catalogue;
mod contact;
mod door;
pub mod exact;
mod facts;
mod json;
#[cfg(feature = "workshop")]
pub mod log;
#[cfg(feature = "workshop")]
pub mod mitigate;
pub mod modes;
pub mod paper;
pub mod preview;
#[cfg(feature = "workshop")]
pub mod response;
#[cfg(feature = "workshop")]
pub mod verdict;
#[cfg(feature = "workshop")]
mod workshop;

pub use door::Engine;
