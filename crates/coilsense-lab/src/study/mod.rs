//! A spring simulated once: the one way from a spring, its mount and what is done to it to all that sensors watch.
//!
//! Next door: what is made of it (`analysis`, `sweep`, `reproduce`), the motion itself (`coilsense::motion`).

mod bent;
mod contacts;
mod helical;
mod masses;
mod seen;
mod simulation;
mod together;

pub use bent::Bent;
pub use contacts::{Between, Contacts, GRAZES, MEET, Meeting};
pub use helical::{EndLoads, Helical, Helices, Moved};
pub use masses::{ENOUGH, ENOUGH_WITH_CONTACT, Masses, enough_masses, mounted, prepare};
pub use seen::Seen;
pub use simulation::{Coil, Meets, Method, Setup, Simulation, simulate};
pub use together::{ADD_UP, together};
