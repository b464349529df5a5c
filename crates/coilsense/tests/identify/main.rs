//! Identification on records whose every number is known.
//!
//! The springs are simulated with the library's own exact motion, which the other tests hold against independent integrators; what is
//! tested here is what a noisy record gives back.

mod channels;
mod lookalikes;
mod many;
mod mounts;
#[path = "../paper_springs/mod.rs"]
mod paper_springs;
mod predicted;
mod records;
mod satellites;
mod silent;
mod strangers;
