//! Doing something about ringing, for people: every candidate on given conditions, ranked, and settings as files that a controller takes.
//!
//! ```text
//! Spec, log or the stated scenario ─► Study ─► runs over the tolerance box ─► candidates, each judged ─► ranking, advice ─► files
//! ```
//!
//! Next door: the designs (`coilsense::mitigation`), the steps (`coilsense-rt`), the answer as text and JSON (`report`).

mod candidate;
mod candidates;
mod ends;
pub mod export;
mod judge;
mod ranking;
mod recorded;
pub mod request;
mod residual;
mod run;
mod runs;
mod shaping;
mod shown;
mod sources;
mod start;
mod study;

pub use candidate::{Candidate, LeftOut, Origin, Truth};
pub use judge::Judgement;
pub use ranking::Ranking;
pub use recorded::Recorded;
pub use request::{OPTIONS, Refused, Request};
pub use residual::residual_vibration;
pub use shaping::{Shaped, Shaping};
pub use shown::{Made, Shown};
pub use sources::{Source, Sources};
pub use study::{Study, StudyError};
