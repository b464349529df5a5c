//! Windings that meet, against figures of independent programs, by hand and by what must be conserved.

mod follower;
mod laws;
mod random;
mod reference;
mod seats;
mod stepping;
mod steps;
mod uneven;
mod wound;
