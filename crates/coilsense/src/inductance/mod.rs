//! The spring as a coil: complete elliptic integrals, the mutual inductance of two rings, Maxwell's sum over the windings.
//!
//! Next door: where the windings are (`motion`), what a meter makes of L (`calibrate`, `sensors`).

pub mod elliptic;
mod maxwell;
mod mutual;
mod self_term;

pub use maxwell::MaxwellSum;
pub use mutual::{MU_0, mutual_inductance};
pub use self_term::SelfDistance;
