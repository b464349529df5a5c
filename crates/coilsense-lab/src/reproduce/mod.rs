//! The paper's simulations, all of them: both springs, five conditions, two protocols, beside the printed numbers.
//!
//! Next door: the printed numbers (`published`), the figures' drawing (`coilsense_figure`), the pages and files (`report`).

mod case;
mod cell;

mod figures;
mod protocol;
mod reason;

use std::path::Path;

use coilsense::Spring;
#[cfg(not(target_family = "wasm"))]
use rayon::prelude::*;

pub use crate::condition::Condition;
pub(crate) use case::all_file_stems;
pub use case::{Case, CaseResult, Maxima};
pub use cell::Cell;
pub use figures::NamedFigure;
pub use protocol::{PAPER_NOMINAL_FORCE_FACTOR, Protocol};
pub use reason::{Reason, TOLERANCE_POINTS};

use crate::published::{PublishedCell, PublishedError, published_cells};
use crate::spec::{SpecError, SpringSpec, read_text};

/// What can go wrong on the way to the paper's tables.
#[derive(Debug, thiserror::Error)]
pub enum ReproduceError {
    /// A spring file cannot be used.
    #[error(transparent)]
    Spec(#[from] SpecError),
    /// A spring cannot carry a condition.
    #[error("{spring}, {condition}")]
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

/// Most windings for which the tables are computed: the inductance of every sample is a sum over all pairs.
const MOST_WINDINGS: f64 = 1000.0;

#[cfg(feature = "reference")]
const S_T: &str = include_str!("../../data/springs/S_T.toml");
#[cfg(feature = "reference")]
const S_A: &str = include_str!("../../data/springs/S_A.toml");
// Without their comments.
#[cfg(not(feature = "reference"))]
const S_T: &str = include_str!(concat!(env!("OUT_DIR"), "/S_T.toml"));
#[cfg(not(feature = "reference"))]
const S_A: &str = include_str!(concat!(env!("OUT_DIR"), "/S_A.toml"));

/// The paper's two springs, by the names its tables use.
#[derive(Debug, Clone, PartialEq)]
pub struct PaperSprings {
    springs: [(&'static str, Spring); 2],
    /// What the files say that the tables do not take.
    unused: Vec<String>,
}

impl PaperSprings {
    /// Table I.
    ///
    /// # Errors
    /// [`ReproduceError::Spec`] where the compiled-in files are damaged.
    pub fn built_in() -> Result<Self, ReproduceError> {
        let read = |file, text| SpringSpec::parse(file, text).map(|named| named.spring);
        let s_t = read("data/springs/S_T.toml", S_T)?;
        let s_a = read("data/springs/S_A.toml", S_A)?;
        Ok(Self { springs: [("S_T", s_t), ("S_A", s_a)], unused: Vec::new() })
    }

    /// `S_T.toml` and `S_A.toml` of a folder.
    ///
    /// # Errors
    /// [`ReproduceError::Spec`] for the first file that is missing or cannot be used.
    pub fn read(folder: &Path) -> Result<Self, ReproduceError> {
        let (s_t, of_s_t) = Self::read_one(&folder.join("S_T.toml"), "S_A")?;
        let (s_a, of_s_a) = Self::read_one(&folder.join("S_A.toml"), "S_T")?;
        let unused = [of_s_t, of_s_a].into_iter().flatten().collect();
        Ok(Self { springs: [("S_T", s_t), ("S_A", s_a)], unused })
    }

    /// One of the two, which must not be the other, and whose inductance must be one that a length can be read from; and what of the file is not used.
    fn read_one(file: &Path, other: &str) -> Result<(Spring, Option<String>), SpecError> {
        let text = read_text(file)?;
        let SpringSpec { name, spring, .. } = SpringSpec::parse(&file.display().to_string(), &text)?;
        if name == other {
            let allowed = "another name: the file stands in the other spring's place";
            return Err(SpecError::unsuitable(file, "name", format!("{name:?}"), allowed));
        }
        for (key, windings) in [("windings", spring.windings()), ("inductance_windings", spring.inductance_windings())]
        {
            if !(1.5..=MOST_WINDINGS).contains(&windings) {
                let allowed = format!("from 1.5 to {MOST_WINDINGS} to reproduce the tables");
                return Err(SpecError::unsuitable(file, key, windings, allowed));
            }
        }
        Ok((spring, unused(file, &text)))
    }

    /// Whether each of the two is the paper's.
    fn are_table_i(&self) -> Result<[bool; 2], ReproduceError> {
        // A page has no others.
        if cfg!(target_family = "wasm") {
            return Ok([true; 2]);
        }
        let table_i = Self::built_in()?;
        Ok([0, 1].map(|number| self.springs[number].1 == table_i.springs[number].1))
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

/// What of a spring's file the tables do not take, which are those of ends that move as the paper says, of an undamped chain.
fn unused(file: &Path, text: &str) -> Option<String> {
    let document: toml::Table = text.parse().ok()?;
    let mut left: Vec<String> = document.keys().filter(|key| *key != "spring").map(|key| format!("[{key}]")).collect();
    let model = document.get("spring").and_then(|spring| spring.get("model")).and_then(toml::Value::as_str);
    left.extend(model.filter(|model| *model != "chain").map(|model| format!("model = {model:?}")));
    (!left.is_empty()).then(|| {
        format!(
            "{}: not used here: {}. The tables are those of the paper's undamped chain under the paper's conditions; `coilsense analyze` takes all of it.",
            file.display(),
            left.join(", ")
        )
    })
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
    // Both protocols are always run: what a cell of one cannot explain, the other's difference may.
    let cases = Case::distinct(&springs, &Protocol::ALL)?;
    // In a browser there is one thread, and rayon is a tenth of what the page loads for the paper.
    #[cfg(target_family = "wasm")]
    let each = cases.into_iter();
    #[cfg(not(target_family = "wasm"))]
    let each = cases.into_par_iter();
    let mut cases: Vec<CaseResult> = each.map(Case::run).collect::<Result<_, _>>()?;
    let table_i = springs.are_table_i()?;
    let springs_are_table_i = table_i == [true; 2];
    let fill = |published: PublishedCell| {
        let place = springs.each().position(|(name, _)| name == published.spring);
        Cell::fill(published, &cases, protocols, place.is_some_and(|place| table_i[place]))
    };
    let cells = published_cells()?.into_iter().map(fill).collect();
    for result in &mut cases {
        result.case.protocols.retain(|protocol| protocols.contains(protocol));
    }
    cases.retain(|result| !result.case.protocols.is_empty());
    Ok(Reproduction { springs, springs_are_table_i, protocols: protocols.to_vec(), cases, cells })
}

impl Reproduction {
    /// The simulation of a spring under a condition, by the tables protocol where it was run.
    pub fn case(&self, spring: &str, condition: Condition) -> Option<&CaseResult> {
        let fits = |result: &&CaseResult| result.case.spring_name == spring && result.case.condition == condition;
        let tables = |result: &&CaseResult| result.case.protocols.contains(&Protocol::Tables);
        let mut candidates = self.cases.iter().filter(fits);
        candidates.clone().find(tables).or_else(|| candidates.next())
    }

    /// What a reader must know before using a number: what of the springs' files is not used, lengths outside of the operating range, windings that
    /// touch.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = self.springs.unused.clone();
        warnings.extend(self.of_cases());
        warnings
    }

    /// The same of the motions alone.
    pub(crate) fn of_cases(&self) -> impl Iterator<Item = String> {
        self.cases.iter().flat_map(CaseResult::warnings)
    }
}
