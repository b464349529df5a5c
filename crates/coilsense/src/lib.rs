//! How far one can trust a force measured through a coil spring.
//!
//! Robots measure force through springs: a load cell at one end, a deflection sensor, the spring's own inductance. All assume a
//! spring without mass. A real coil rings inside ("surge") after an impact or near a resonance, and then its two ends disagree.
//! This crate holds the science of that: no files, no printing, no clock. Read the modules in their order and you walk the corridor
//!
//! ```text
//! Spring + Excitation ─► Motion ─► Signals ─► Estimate ─► Measures
//! ```
//!
//! The model is that of van der Weijde, van Ostayen and Vallery, *Influence of Internal Oscillations on Force Sensing in Coil
//! Springs*: a chain of N winding masses, Maxwell's summation for the inductance. It ends where windings touch (see
//! [`measures::Clash`]; [`contact`] goes on from there), and it moves along the spring's axis only: no lateral or torsional motion, no initial tension. What moves
//! besides, and how near, [`helix`] tells; [`helix::Surge`] puts all of it behind the same [`Motion`].
//!
//! SI units at every door. Positions grow from end 1 to end 2; force is tension-positive.
//!
//! ```
//! use coilsense::inductance::{MaxwellSum, SelfDistance};
//! use coilsense::{Calibration, Channel, Deviation, Excitation, InductanceSensor, Motion, paper};
//!
//! // S_T of the paper, hit at mid range: how far off is each force?
//! let spring = paper::s_t();
//! let motion = Motion::new(&spring, &Excitation::impact(spring.mid_length(), 0.25)?)?;
//! let times = coilsense::signals::sampled_window(10_000.0, 0.75, 1.0)?;
//! let mut signals = motion.signals(&times)?;
//!
//! let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
//! let inductance = coil.series(&motion.windings(&times)?);
//! let sensor = InductanceSensor::new(&spring, Calibration::theoretical(&spring, &coil, spring.mid_length())?);
//! signals.insert(Channel::InductanceForce, sensor.force(&inductance))?;
//!
//! let reference = signals.channel(Channel::DeflectionForce)?;
//! for (force, percent) in [(Channel::OutputForce, 1.44), (Channel::InductanceForce, 0.01)] {
//!     let deviation = Deviation::between(signals.channel(force)?, reference)?.relative_to(spring.nominal_force())?;
//!     assert!((100.0 * deviation.rmsd - percent).abs() < 0.01); // Table II of the paper
//! }
//! # Ok::<(), coilsense::Error>(())
//! ```

// What a user can send must not end in a panic, and a library does not print.
#![cfg_attr(
    not(test),
    warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, clippy::print_stderr)
)]

/// Masses and the springs between them to frequencies and shapes.
mod bidiagonal;

/// A coil whose pitch and diameter change to its static curve.
pub mod sections;

/// Parameters to a checked spring.
pub mod spring;

/// The paper's springs.
pub mod paper;

/// Wire and coil to stiffness, mass, stress and lengths.
pub mod geometry;

/// A stretched helix to every one of its modes.
pub mod helix;

/// A coil to the first frequencies of the motions that are left out.
pub mod neighbours;

/// What damps the windings to what each mode feels.
pub mod damping;

/// What holds end 2.
pub mod mount;

/// Time under load to lost force.
pub mod relaxation;

/// A mounted spring to its modes.
pub mod modes;

/// A spring to force out over force in.
pub mod transmittance;

/// A damped, loaded spring to its response over frequency.
pub mod two_port;

/// A drive, a spring and an environment to the limits of a force loop.
pub mod control;

/// What is done to the spring.
pub mod excitation;

/// Modes and an excitation to positions and forces over time.
pub mod motion;

/// A mounted spring to a part of someone else's simulation.
pub mod plant;

/// Positions of the windings to the inductance.
pub mod inductance;

/// Measured inductances to the curve that a sensor is told.
pub mod calibrate;

/// Contributions to a combined uncertainty.
pub mod uncertainty;

/// Positions and inductance to estimates of force, and what makes them err.
pub mod sensors;

/// Series over time, simulated or measured.
pub mod signals;

/// Windings that meet: from event to event.
pub mod contact;

/// A signal and its reference to how far off it is.
pub mod measures;

/// A spring and its tolerances to the settings of filters and observers.
pub mod mitigation;

/// A log to stiffness, mass and damping.
pub mod identify;

/// What can be wrong with what a user sends.
pub mod error;

/// A function to its integral.
mod quadrature;

/// The processor to the vector instructions that are used.
pub mod simd;

pub use calibrate::Calibration;
pub use damping::Damping;
pub use error::Error;
pub use excitation::{End, EndInput, Excitation, Start, VelocityProfile};
pub use measures::{Clash, Deviation};
pub use motion::Motion;
pub use mount::{FarEnd, Mount};
pub use sensors::InductanceSensor;
pub use signals::{Channel, Signals};
pub use spring::{Spring, SpringParameters};

/// The code of this crate's own README, run as a doctest.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct OwnReadme;

/// The README's code, run as a doctest.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

/// The book's Rust code, run as a doctest.
#[cfg(doctest)]
#[doc = include_str!("../../../book/src/guide/rust.md")]
struct Book;
