//! A coil wound in sections: pitch and diameter may change along each, so that it gets stiffer as windings close.
//!
//! Next door: the spring that it makes (`crate::spring`), what happens when windings close fast (`crate::contact`).

mod coil;
mod curve;
mod lumps;
mod polynomial;
mod stress;

pub use coil::{Section, Sections};
pub(crate) use lumps::Lumps;
