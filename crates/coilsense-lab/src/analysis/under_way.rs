//! An analysis case by case, for who must turn to something else between two: a page that answers a hand. Cases of an earlier one that nothing
//! has changed since are taken as they are.
//!
//! Next door: all cases at once, on all of the processor's threads (the parent); what they share (`prepared`).

use super::prepared::{OverSprings, Prepared};
use super::{Analysis, AnalysisError, Case, run_case};
use crate::spec::Spec;

/// Numbers of earlier cases that are kept at most: 160 MB of signals, readings and what sensors see.
const MOST_KEPT: usize = 20_000_000;

/// All that a case depends on: the spec without other conditions, other dampings and its wording, where in the spec it stands, and its number,
/// which seeds its noise.
#[derive(Debug, Clone, PartialEq)]
struct Origin {
    spec: Spec,
    place: (usize, usize),
    number: usize,
}

/// A case that is computed.
#[derive(Debug)]
struct Settled {
    origin: Origin,
    case: Case,
    over: OverSprings,
}

/// Cases of earlier analyses.
#[derive(Debug, Default)]
pub struct Earlier(Vec<Settled>);

/// A spec whose cases are computed one after the other.
pub struct UnderWay {
    prepared: Prepared,
    /// What is the same in every case.
    shared: Spec,
    count: usize,
    settled: Vec<Settled>,
    earlier: Vec<Settled>,
}

/// What an analysis came to.
pub struct Concluded {
    /// The same, to the bit, as [`Analysis::run`] of the spec finds.
    pub analysis: Analysis,
    origins: Vec<(Origin, OverSprings)>,
}

impl UnderWay {
    /// Begins with a spec.
    ///
    /// # Errors
    /// As [`Analysis::run`], but for what only a case shows.
    pub fn begin(spec: Spec, Earlier(earlier): Earlier) -> Result<Self, AnalysisError> {
        if spec.conditions.is_empty() {
            return Err(AnalysisError::NoCondition(spec.file));
        }
        let count = spec.conditions.len() * spec.mount.cases.len();
        let prepared = Prepared::of(spec, &|_, _| true)?;
        let mut shared = prepared.spec.clone();
        (shared.text, shared.notes) = (String::new(), Vec::new());
        (shared.conditions, shared.mount.cases) = (Vec::new(), Vec::new());
        Ok(Self { prepared, shared, count, settled: Vec::new(), earlier })
    }

    /// How many cases are settled, and of how many.
    pub fn progress(&self) -> (usize, usize) {
        (self.settled.len(), self.count)
    }

    /// Settles the next case, if there is one; whether it had to be computed.
    ///
    /// # Errors
    /// What the science refuses; what is settled remains.
    pub fn step(&mut self) -> Result<bool, AnalysisError> {
        let number = self.settled.len();
        if number == self.count {
            return Ok(false);
        }
        let origin = self.origin(number);
        if let Some(known) = self.earlier.iter().position(|settled| settled.origin == origin) {
            self.settled.push(self.earlier.swap_remove(known));
            return Ok(false);
        }
        let Prepared { spec, sensors, coil, helices, .. } = &self.prepared;
        let case = run_case(spec, sensors, coil, helices, origin.place)?;
        let over = self.prepared.responses(&case)?;
        self.settled.push(Settled { origin, case, over });
        Ok(true)
    }

    /// Its cases, for the next one: of what was given up half way, too.
    pub fn earlier(self) -> Earlier {
        kept(self.settled.into_iter().chain(self.earlier))
    }

    /// Settles what is left, and concludes.
    ///
    /// # Errors
    /// What the science refuses.
    pub fn conclude(mut self) -> Result<Concluded, AnalysisError> {
        while self.settled.len() < self.count {
            self.step()?;
        }
        let (mut cases, mut origins) = (Vec::new(), Vec::new());
        for Settled { origin, case, over } in self.settled {
            cases.push(case);
            origins.push((origin, over));
        }
        let over = origins.iter().map(|(_, over)| over.clone()).collect();
        Ok(Concluded { analysis: self.prepared.conclude(cases, over, &|_, _| true)?, origins })
    }

    fn origin(&self, number: usize) -> Origin {
        let of = &self.prepared.spec;
        let dampings = of.mount.cases.len();
        let place @ (condition, damping) = (number / dampings, number % dampings);
        let mut spec = self.shared.clone();
        spec.conditions.push(of.conditions[condition].clone());
        spec.mount.cases.push(of.mount.cases[damping].clone());
        Origin { spec, place, number }
    }
}

impl Concluded {
    /// Its cases, for the next one.
    pub fn earlier(self) -> Earlier {
        let each = self.analysis.cases.into_iter().zip(self.origins);
        kept(each.map(|(case, (origin, over))| Settled { origin, case, over }))
    }
}

/// The first of those, as many as are worth their memory.
fn kept(all: impl Iterator<Item = Settled>) -> Earlier {
    let mut numbers = 0;
    Earlier(
        all.take_while(|settled| {
            numbers += settled.case.numbers();
            numbers <= MOST_KEPT
        })
        .collect(),
    )
}
