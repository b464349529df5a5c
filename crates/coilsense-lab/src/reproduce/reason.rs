//! Why a computed cell differs from the printed one.
//!
//! Next door: the cells (`cell`), the readings of the paper (`protocol`).

use super::{Condition, Protocol};
use crate::published::{PublishedCell, Table};

/// A computed cell differs from the printed one when it is further off than this \[percentage points\]: the print's rounding
/// (0.005) and the freedom of where its samples fell.
pub const TOLERANCE_POINTS: f64 = 0.02;

/// One place where text and printed numbers part, or where a number cannot be pinned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reason {
    /// (a) End stop min is printed for a uniform velocity.
    UniformContraction,
    /// (b) The harmonic rows are printed for a cosine from the massless state.
    MasslessStart,
    /// (c) S_A's printed cells imply another F_nom.
    NominalForce,
    /// (d) Table III prints the signed maximum.
    SignedMaximum,
    /// (e) A maximum depends on where the samples fall, and the printed one lies within what that can do.
    Sampling,
    /// (f) A maximum that lies outside of what sampling can do.
    Unexplained,
    /// (g) The springs are not those of Table I.
    OtherSprings,
}

impl Reason {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::UniformContraction,
        Self::MasslessStart,
        Self::NominalForce,
        Self::SignedMaximum,
        Self::Sampling,
        Self::Unexplained,
        Self::OtherSprings,
    ];

    /// The letter that marks a cell.
    pub fn letter(self) -> char {
        match self {
            Self::UniformContraction => 'a',
            Self::MasslessStart => 'b',
            Self::NominalForce => 'c',
            Self::SignedMaximum => 'd',
            Self::Sampling => 'e',
            Self::Unexplained => 'f',
            Self::OtherSprings => 'g',
        }
    }

    /// The reason in a sentence.
    pub fn sentence(self) -> &'static str {
        match self {
            Self::UniformContraction => {
                "The text has the end stop's velocity rise linearly along the coil; the printed \"min\" rows are those of a uniform velocity."
            }
            Self::MasslessStart => {
                "The text says \"a sinusoid\"; the printed rows are those of a cosine, started as a spring without mass would be at t = 0."
            }
            Self::NominalForce => {
                "Eq. (14) with Table I gives S_A 373.1 N; every printed cell of S_A is smaller by the one factor 0.925, as if F_nom were 403.4 N. Cause unknown."
            }
            Self::SignedMaximum => {
                "The text says maximum deviations; the printed ones are signed, max(F − F_x), so a force that is only ever too low shows 0.00."
            }
            Self::Sampling => {
                "A maximum hangs on the highest modes and on where samples fall: over sample rates from 1 to 20 kHz, in steps of 0.1 kHz, it runs through a range that holds the printed value."
            }
            Self::Unexplained => {
                "A maximum that no sample rate from 1 to 20 kHz, in steps of 0.1 kHz, brings to the printed value. Not explained; the paper names neither its solver nor its sample times."
            }
            Self::OtherSprings => "The springs are not those of Table I, for which the paper's numbers hold.",
        }
    }

    /// The reasons of a cell that differs from its printed value: where its protocol departs from the tables protocol, and then
    /// those of the same cell under the tables protocol.
    pub(super) fn of(differing: &Differing<'_>, of_tables: &[Self]) -> Vec<Self> {
        let text = differing.protocol == Protocol::Text;
        let cell = differing.cell;
        let maximum = cell.table == Table::Three;
        let within = differing
            .sampling_range
            .is_some_and(|(low, high)| (low - TOLERANCE_POINTS..=high + TOLERANCE_POINTS).contains(&cell.percent));
        let applies = |reason: &Self| match reason {
            Self::UniformContraction => text && cell.condition == Condition::EndStopMin,
            Self::MasslessStart => text && cell.condition.is_harmonic(),
            Self::NominalForce => text && cell.spring == "S_A",
            Self::SignedMaximum => text && maximum && differing.signed_matters,
            Self::Sampling => !text && maximum && within,
            Self::Unexplained => !text && maximum && !within && differing.table_i,
            Self::OtherSprings => !differing.table_i,
        };
        let reasons: Vec<Self> =
            Self::ALL.into_iter().filter(|reason| applies(reason) || of_tables.contains(reason)).collect();
        if reasons.is_empty() { vec![Self::Unexplained] } else { reasons }
    }
}

/// A computed cell that differs from its printed value, and what bears on why.
pub(super) struct Differing<'a> {
    pub cell: &'a PublishedCell,
    pub protocol: Protocol,
    /// Its signed and absolute maxima differ.
    pub signed_matters: bool,
    /// Its lowest and highest value over sample rates \[% of F_nom\].
    pub sampling_range: Option<(f64, f64)>,
    /// The springs are those of Table I.
    pub table_i: bool,
}
