//! Which designs are worth a look: those than which no other is better in one respect and as good in all others.
//!
//! This file names what there is. Next door: the front of points that come in pieces (`front`), how points are compared in bulk
//! (`dominance`), the points of a front that one names first (`named`); what is asked of a sweep (`question`, `condition`) and what comes
//! of it (`study`, `pass`, `counts`), with its cloud thinned for a picture (`cloud`) and in words (`words`).

#[cfg(feature = "parquet")]
mod cloud;
#[cfg(feature = "parquet")]
mod condition;
#[cfg(feature = "parquet")]
mod counts;
mod dominance;
mod front;
mod named;
#[cfg(feature = "parquet")]
mod pass;
#[cfg(feature = "parquet")]
mod question;
#[cfg(feature = "parquet")]
mod study;
#[cfg(feature = "parquet")]
mod words;

#[cfg(feature = "parquet")]
pub use counts::Counts;
pub use front::Front;
pub use named::{extremes, knee, scaled};
#[cfg(feature = "parquet")]
pub use question::{Aim, Objective, Question};
#[cfg(feature = "parquet")]
pub use study::{Span, Study};
#[cfg(feature = "parquet")]
pub use words::answer;
