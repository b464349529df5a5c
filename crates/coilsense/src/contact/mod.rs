//! Windings that meet: a chain of lumps followed from event to event, exact to rounding in between.
//!
//! Between events a chain is linear, and its motion a power series in time; where two points meet or part, and where an end leaves its seat,
//! is a root of a polynomial. What touches is held together by forces that do not pull: a linear complementarity problem, solved directly.
//!
//! ```
//! use coilsense::contact::{Chain, Contact, Drive, Path, Start, follow};
//! use coilsense::{Damping, EndInput};
//!
//! // One lump of 1 kg between two springs, its seat 1 mm away: it is thrown at end 1 and stays there until the spring throws it back.
//! let chain = Chain::new(vec![1.0], vec![100.0, 100.0], vec![1e-3, f64::INFINITY])?;
//! let held = || Drive::Input(EndInput::Held, 0.0);
//! let start = Start { time: 0.0, places: vec![0.0], speeds: vec![-0.1] };
//! let course = follow(&chain, &Contact::default(), &Damping::None, [held(), held()], &start, &[0.0, 0.5])?;
//! assert_eq!(course.touches.len(), 1);
//! assert!((course.touches[0].impulse - 0.1).abs() < 0.01);
//! # Ok::<(), coilsense::Error>(())
//! ```

mod at_rest;
mod begin;
mod bonds;
mod book;
mod chain;
mod coefficients;
mod complementarity;
mod course;
mod damper;
mod drive;
mod events;
mod follow;
mod hertz;
mod knots;
mod law;
mod meet;
mod path;
mod polynomial;
mod run;
mod series;
mod start;
mod touching;

pub use chain::{Chain, Pair};
pub use course::{Balance, Course, Float, GivenUp, Lift, Touch};
pub use drive::Drive;
pub use follow::follow;
pub use hertz::Hertz;
pub use law::{Contact, Law};
pub use path::Path;
pub use start::Start;
pub use touching::{CHANGE, Touching};
