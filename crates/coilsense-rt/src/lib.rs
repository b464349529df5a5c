//! What a controller runs against the ringing of a coil spring: filters, observers and command shapers.
//!
//! no_std, no allocation, no panic, no dependency; each is *settings | state | step*: settings are plain numbers that the host computes
//! (`coilsense::mitigation`, `coilsense::plant`, or `coilsense mitigate --export`) and that do not move, the state does, and a step costs the same
//! every time. Generic over `f32` and `f64`.
//!
//! | for | type | a step takes | and gives |
//! |---|---|---|---|
//! | low-pass, notches | [`Cascade`] | a force | the force filtered |
//! | one surge period 2τ at once | [`Boxcar`], [`Comb`] | a force | all n·f1 nulled |
//! | any finite window | [`Window`] | a force | its weighted sum |
//! | F_o from F_i, u1, u2 by waves | [`DelayLineObserver`] | [`Measured`] | F_o |
//! | F_o from F_i, u1, u2 by modes | [`ModalKalman`], a [`Bank`] of them | [`Measured`] | [`Estimate`] |
//! | F_i made unbiased by F_L | [`Fusion`] | both forces | the force fused |
//! | the spring itself, in a simulation | [`Plant`] | u1, and u2 or a force | F_i, F_o, F_x ([`PlantOutput`]) |
//! | its inductance, and the force by it | [`PlantCoil`] | a [`PlantState`] | L, F_L, their bounds ([`CoilReading`]) |
//! | what an instrument makes of any of these | [`Readout`] | a quantity | the reading |
//! | how near its windings are | [`PlantWindings`] | a [`PlantState`] | the smallest pitch |
//! | commands that do not ring | [`Shaper`], [`Boxcar`], [`DoubleBoxcar`] | a command | the command shaped |
//!
//! Units are SI, force is tension-positive, positions grow from end 1 to end 2. A state starts `settled`: as if what it is given had been
//! so for ever, so that a preload is no step.
//!
//! ```
//! use coilsense_rt::{Biquad, Cascade};
//!
//! // A notch at a tenth of the sampling rate, Q = 2.
//! const NOTCH: Cascade<f32, 1> = Cascade {
//!     sections: [Biquad { b0: 0.8718836, b1: -1.4107374, b2: 0.8718836, a1: -1.4107374, a2: 0.7437672 }],
//! };
//! let mut state = NOTCH.settled(96.0);
//! let out = NOTCH.step(&mut state, 96.0);
//! assert!((out - 96.0).abs() < 1e-3);
//! ```

#![no_std]
// What runs on a robot must not stop it.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing))]

mod bank;
mod biquad;
mod boxcar;
mod comb;
mod delay;
mod delay_line;
mod elementary;
mod fusion;
mod kalman;
mod noise;
mod oscillator;
mod plant;
mod plant_coil;
mod plant_settings;
mod plant_windings;
mod readout;
mod real;
mod shaper;
mod window;

pub use bank::{Bank, BankState};
pub use biquad::{Biquad, Cascade, CascadeState};
pub use boxcar::{Boxcar, BoxcarState, DoubleBoxcar, DoubleBoxcarState};
pub use comb::{Comb, CombState};
pub use delay::{Delay, Ring};
pub use delay_line::{DelayLineObserver, DelayLineState};
pub use fusion::{Fusion, FusionState};
pub use kalman::{Estimate, KalmanState, Measured, ModalKalman, Mode};
pub use oscillator::ModeStep;
pub use plant::{Plant, PlantOutput, PlantState};
pub use plant_coil::{CoilReading, PlantCoil};
pub use plant_settings::{FarEnd, PlantMode, PlantSettings, Refused};
pub use plant_windings::PlantWindings;
pub use readout::{Readout, ReadoutMean, ReadoutPole, ReadoutState};
pub use real::Real;
pub use shaper::{Impulse, Shaper};
pub use window::Window;
