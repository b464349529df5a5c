//! What the literature says the inductance of a coil is: one formula, one file, all from the same [`Coil`] and its length.
//!
//! Lengths are those of the coil, end of wire to end of wire along the axis: N pitches. How far each is from a measured spring is judged
//! in `crate::calibrate`. Next door: windings that are not spread uniformly (`super::MaxwellSum`).

mod helix;
mod ideal;
mod lundin;
mod nagaoka;
mod round_wire;
mod theory;
mod wheeler;

pub use super::coil::Coil;
pub use helix::{HelixSelf, ReturnPath, helix};
pub use ideal::ideal_solenoid;
pub use lundin::lundin;
pub use nagaoka::{nagaoka, nagaoka_coefficient};
pub use round_wire::{nagaoka_rosa, rosa_mutual, rosa_mutual_sum, rosa_self};
pub use theory::Theory;
pub use wheeler::{wheeler_1928, wheeler_1982};
