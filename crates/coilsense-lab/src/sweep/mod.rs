//! A million designs: a spec whose values are varied, each design judged, rows into a folder of Parquet files that a killed run continues.
//!
//! ```text
//! SPEC ─┐
//! OVER ─┼─► Plan ─► rows 0…n−1 ─► chunk ─► Design per row ─► columns ─► Parquet ─► Dataset (_manifest.json, chunk-000000.parquet …)
//! COLUMNS ┘
//! ```
//!
//! A row is a function of the plan and its number: the same whichever chunk, thread or machine computes it.
//!
//! Next door: reading a spec (`spec`), the analysis of a single design (`analysis`).

mod catalogue;
mod chosen;
mod chunk;
mod chunking;
mod column;
#[cfg(feature = "parquet")]
mod dataset;
mod design;
#[cfg(feature = "parquet")]
mod encoded;
#[cfg(feature = "parquet")]
mod folder;
mod forces;
mod identity;
#[cfg(feature = "parquet")]
mod manifest;
mod note;
mod permutation;
#[cfg(feature = "parquet")]
mod picked;
mod plan;
pub mod request;
mod sampling;
#[cfg(feature = "parquet")]
mod seal;
mod sobol;
mod spread;
#[cfg(feature = "parquet")]
mod table;
mod values;
mod variable;

pub use catalogue::Catalogue;
pub use chunk::{Chunk, Data};
#[cfg(feature = "parquet")]
pub(crate) use column::Kind;
pub use column::column_words;
#[cfg(feature = "parquet")]
pub use dataset::{Dataset, Tally};
#[cfg(feature = "parquet")]
pub(crate) use permutation::mixed;
pub use plan::{Plan, PlanParameters};
pub use sampling::Sampling;
#[cfg(feature = "parquet")]
pub(crate) use table::cell;

use crate::message::Message;

/// Why a sweep cannot be, in one line.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct SweepError(Message);

impl SweepError {
    pub(crate) fn new(message: impl Into<Message>) -> Self {
        Self(message.into())
    }

    fn of(what: &str, message: impl Into<Message>) -> Self {
        Self(Message::from(format!("{what}: ")) + message)
    }
}

impl From<SweepError> for Message {
    fn from(error: SweepError) -> Self {
        error.0
    }
}

impl From<crate::spec::SpecError> for SweepError {
    fn from(error: crate::spec::SpecError) -> Self {
        Self(error.to_string().into())
    }
}
