//! Every motion of a real coil: axial, torsional and sideways, with the wire's prestress.
//!
//! The wire of a stretched (or compressed) spring as an exact rod: [`Rod`] is the wire without load, [`Helix`] its state at a length,
//! [`Ends`] what holds it, [`Modes`] its natural frequencies. Next door: the axial chain alone (`modes`), formulas for a first look
//! (`neighbours`).

mod block;
mod chain;
mod ends;
pub mod inextensible;
mod modes;
mod of_spring;
mod rod;
mod segment;
mod state;

pub use ends::{Ends, Holding};
pub use modes::Modes;
pub use of_spring::StiffnessAt;
pub use rod::{Hand, Rod, RodParameters};
pub use state::{Helix, Turning};
