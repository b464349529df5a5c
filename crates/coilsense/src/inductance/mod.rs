//! The spring as a coil: complete elliptic integrals, the mutual inductance of two rings, Maxwell's sum over the windings.
//!
//! Theories of the whole coil, from the ideal solenoid to the helix, stand side by side in `theories`.
//!
//! Next door: where the windings are (`motion`), what a meter makes of L (`calibrate`, `sensors`).

mod by_pitch;
mod carry;
mod chebyshev;
mod coil;
mod derivatives;
mod distances;
pub mod elliptic;
mod evaluation;
mod expansion;
mod fits;
mod gradient;
mod lag_polynomials;
mod maxwell;
mod mutual;
mod near_uniform;
mod over_length;
mod pairs;
mod permeable;
mod quadratic;
mod reduced;
mod rings;
mod second_order;
mod self_term;
mod skin;
mod squares;
pub mod theories;
mod turn_block;
mod uniform;
mod within;

pub(crate) use by_pitch::ByPitch;
pub use derivatives::{MutualDerivatives, mutual_inductance_derivatives};
pub use maxwell::MaxwellSum;
pub use mutual::{MU_0, mutual_inductance, mutual_inductances};
pub use over_length::OverLength;
pub(crate) use permeable::{CLOSE, Changes, LEAST_FITTED, MOST_PERMEABLE};
pub use permeable::{
    LEAST_PITCH, Leads, PermeableRings, SteelCoil, SteelCurve, SteelTurns, SteelWindings, inductance_along,
};
pub use rings::mutual_inductance_of_rings;
pub use second_order::{BoundedInductance, SecondOrder};
pub use self_term::SelfDistance;
pub use skin::direct_up_to;
pub use within::BoundedSeries;
