//! A force loop closed through the spring: where the sensor may sit, how fast the loop may be, what the world then feels.
//!
//! ```text
//! reference ─►(−)─► Controller ─► Drive ─► y = −u1 ─► spring (exact two-port) with its load ─► F_i, F_o, F_x or F_L ─┐
//!              ▲                                                                                              delay  │
//!              └─────────────────────────────────────────────────────────────────────────────────────────────────────┘
//! ```
//!
//! Over frequency no mode is left out: the spring is [`crate::two_port::TwoPort`]. The sampled loop ([`SampledLoop`]) sums all modes of the
//! chain, sample to sample without error for an ideal velocity source. [`OverTime`] runs every one of these loops, in samples or continuous,
//! on every force and behind every estimator, by poles that share no code with the response over frequency.
//!
//! ```
//! # let spring = coilsense::paper::s_t();
//! use coilsense::control::{Controller, Drive, Environment, ForceLoop, Plant};
//! use coilsense::{Channel, Damping};
//!
//! let plant = Plant::new(&spring, Damping::Modal(0.005), Drive::IDEAL_VELOCITY, Environment::Held)?;
//! // A velocity in proportion to the force error is integral force control;
//! let integral = Controller::proportional(1.0 / spring.stiffness())?; // crossover at 1 rad/s without the spring's mass
//! let load_side = ForceLoop::new(plant, integral, Channel::OutputForce, 0.0)?;
//! let surge = coilsense::modes::ChainModes::of(&spring).frequencies()[0];
//! // Stable only for a crossover below ζ ω_1.
//! assert!((load_side.margins()?.gain_limit / (0.005 * surge) - 1.0).abs() < 5e-3);
//! # Ok::<(), coilsense::Error>(())
//! ```
//!
//! Next door: the spring over frequency (`two_port`), its motion (`motion`).
//!
//! [`OverTime`]: crate::control::OverTime
//! [`SampledLoop`]: crate::control::SampledLoop

mod coil;
mod computer;
mod controller;
mod drive;
mod environment;
mod estimator;
mod force_loop;
mod kicked;
mod margins;
mod matrices;
mod over_time;
mod plant;
mod poles;
mod rational;
mod rendered;
mod run;
mod sampled;
mod stepped;
mod trace;

pub use controller::{Controller, Gains};
pub use drive::Drive;
pub use environment::Environment;
pub use estimator::Estimator;
pub use force_loop::ForceLoop;
pub use margins::Margins;
pub use over_time::{OverTime, simulate};
pub use plant::{Plant, Response};
pub use rendered::{Passivity, rendered_stiffness};
pub use run::Run;
pub use sampled::SampledLoop;
pub use trace::{Point, Trace};
