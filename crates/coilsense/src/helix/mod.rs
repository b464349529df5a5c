//! Every motion of a real coil: axial, torsional and sideways, with the wire's prestress.
//!
//! The wire of a stretched (or compressed) spring as an exact rod: `Rod` is the wire without load, `Helix` its state at a length,
//! `Ends` what holds it, `Modes` its natural frequencies, `Surge` all of them ready for a motion over time, between two ends that move
//! along the axis. Next door: the axial chain alone (`modes`), which also takes a force or a mass at end 2; formulas for a first look (`neighbours`);
//! what a motion tells (`motion`).

mod block;
mod buckling;
mod chain;
mod changed;
mod ends;
mod first_surge;
pub mod inextensible;
mod mode;
mod modes;
mod mounted;
mod of_spring;
mod reaction;
mod reaction_series;
mod response;
mod rod;
mod segment;
mod shares;
mod state;
mod static_curve;
mod surge;

pub use buckling::buckling_length;
pub use changed::ChangedSurge;
pub use ends::{Ends, Holding};
pub use mode::Mode;
pub use modes::Modes;
pub use of_spring::StiffnessAt;
pub use reaction::Reaction;
pub use reaction_series::ReactionSeries;
pub use response::Response;
pub use rod::{Hand, Rod, RodParameters};
pub use shares::{Kind, Shares};
pub use state::{Helix, Turning};
pub use static_curve::StaticCurve;
pub use surge::Surge;
