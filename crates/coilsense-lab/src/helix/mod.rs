//! A coil as a helix: every mode at the lengths that it is used at, with its ends held as they are.
//!
//! Next door: the helix itself (`coilsense::helix`), what says how the ends are held (`spec`), what the modes say of the axial model
//! (`data_sheet`).

mod held;
mod lines;
mod modes;
mod shape;

pub use held::Held;
pub use lines::{BandOfKind, CurveOfKind, Lines, WayLines};
pub use modes::{Coil, ModeLine, ModesAt, UnderEnds};
pub use shape::{EndReaction, ModeShape};
