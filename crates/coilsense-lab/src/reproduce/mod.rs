//! The paper's simulations, all of them: both springs, five conditions, two protocols, beside the printed numbers.
//!
//! Next door: the printed numbers (`published`), the figures' drawing (`plot`), the pages and files (`report`).

mod case;
mod cell;
mod condition;
mod figures;
mod protocol;
mod reason;

use std::path::Path;

use coilsense::Spring;
use rayon::prelude::*;

pub use case::{Case, CaseResult};
pub use cell::{Cell, TOLERANCE_POINTS};
pub use condition::Condition;
pub use figures::NamedFigure;
pub use protocol::{PAPER_NOMINAL_FORCE_FACTOR, Protocol};
pub use reason::Reason;

use crate::published::{PublishedError, published_cells};
use crate::spec::{NamedSpring, SpecError};

/// What can go wrong on the way to the paper's tables.
#[derive(Debug, thiserror::Error)]
pub enum ReproduceError {
    /// A spring file cannot be used.
    #[error(transparent)]
    Spec(#[from] SpecError),
    /// A spring cannot carry a condition.
    #[error("{spring}, {condition}: {source}")]
    Case {
        /// Its name.
        spring: &'static str,
        /// The condition's name.
        condition: &'static str,
        /// What the science says.
        source: coilsense::Error,
    },
    /// The program's own data are damaged.
    #[error(transparent)]
    Published(#[from] PublishedError),
}

/// The paper's two springs, by the names its tables use.
#[derive(Debug, Clone, PartialEq)]
pub struct PaperSprings {
    springs: [(&'static str, Spring); 2],
}

impl PaperSprings {
    /// Table I.
    ///
    /// # Errors
    /// [`ReproduceError::Spec`] where the compiled-in files are damaged.
    pub fn built_in() -> Result<Self, ReproduceError> {
        let read = |file, text| NamedSpring::parse(file, text).map(|named| named.spring);
        let s_t = read(
            "data/springs/S_T.toml",
            include_str!("../../../../data/springs/S_T.toml"),
        )?;
        let s_a = read(
            "data/springs/S_A.toml",
            include_str!("../../../../data/springs/S_A.toml"),
        )?;
        Ok(Self {
            springs: [("S_T", s_t), ("S_A", s_a)],
        })
    }

    /// `S_T.toml` and `S_A.toml` of a folder.
    ///
    /// # Errors
    /// [`ReproduceError::Spec`] for the first file that is missing or cannot be used.
    pub fn read(folder: &Path) -> Result<Self, ReproduceError> {
        let read = |file| NamedSpring::read(&folder.join(file)).map(|named| named.spring);
        Ok(Self {
            springs: [("S_T", read("S_T.toml")?), ("S_A", read("S_A.toml")?)],
        })
    }

    /// S_T and its name.
    pub fn first(&self) -> (&'static str, &Spring) {
        (self.springs[0].0, &self.springs[0].1)
    }

    /// Name and spring, S_T first.
    pub fn each(&self) -> impl Iterator<Item = (&'static str, &Spring)> {
        self.springs.iter().map(|(name, spring)| (*name, spring))
    }
}

/// Everything the paper simulates, computed.
#[derive(Debug, Clone)]
pub struct Reproduction {
    /// The springs it was computed for.
    pub springs: PaperSprings,
    /// Whether they are those of Table I.
    pub springs_are_table_i: bool,
    /// The protocols that were run.
    pub protocols: Vec<Protocol>,
    /// Every distinct simulation.
    pub cases: Vec<CaseResult>,
    /// Tables II and III, printed and computed, in the paper's order.
    pub cells: Vec<Cell>,
}

/// Runs the protocols on the springs.
///
/// # Errors
/// [`ReproduceError`] where a spring cannot carry one of the conditions.
pub fn reproduce(springs: PaperSprings, protocols: &[Protocol]) -> Result<Reproduction, ReproduceError> {
    let cases = Case::distinct(&springs, protocols)?;
    let cases: Vec<CaseResult> = cases.into_par_iter().map(Case::run).collect::<Result<_, _>>()?;
    let springs_are_table_i = springs == PaperSprings::built_in()?;
    let cells = published_cells()?
        .into_iter()
        .map(|published| Cell::fill(published, &cases, springs_are_table_i))
        .collect();
    Ok(Reproduction {
        springs,
        springs_are_table_i,
        protocols: protocols.to_vec(),
        cases,
        cells,
    })
}

impl Reproduction {
    /// The simulation of a spring under a condition, by the tables protocol where it was run.
    pub fn case(&self, spring: &str, condition: Condition) -> Option<&CaseResult> {
        let fits = |result: &&CaseResult| result.case.spring_name == spring && result.case.condition == condition;
        let tables = |result: &&CaseResult| result.case.protocols.contains(&Protocol::Tables);
        let mut candidates = self.cases.iter().filter(fits);
        candidates.clone().find(tables).or_else(|| candidates.next())
    }

    /// What a reader must know before using a number: lengths outside of the operating range, windings that touch.
    pub fn warnings(&self) -> Vec<String> {
        self.cases.iter().flat_map(CaseResult::warnings).collect()
    }
}
