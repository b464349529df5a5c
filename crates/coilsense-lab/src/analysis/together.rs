//! Several springs between the same ends, simulated: the forces of each and of all.
//!
//! Next door: one spring (`case`), the sum (`crate::study::together`).

use coilsense::{Channel, Signals};

use super::{AnalysisError, Case, Progress, refused, simulate_alone};
use crate::series::{Column, Run};
use crate::spec::{Side, Spec};
use crate::study;

/// The springs of a spec, simulated.
#[derive(Debug, Clone)]
pub struct Together {
    /// Each spring, the first first.
    pub springs: Vec<Strand>,
    /// u1, u2, F_i, F_o and F_x of all, condition by condition, each under every damping.
    pub all: Vec<Signals>,
}

/// One of the springs.
#[derive(Debug, Clone)]
pub struct Strand {
    /// Which way it acts.
    pub side: Side,
    /// What was asked of it.
    pub spec: Spec,
    /// Its cases, in the order of [`Together::all`].
    pub cases: Vec<Case>,
}

impl Together {
    /// Simulates every condition under every damping, spring by spring. A spec of one spring has its forces as those of all.
    ///
    /// # Errors
    /// As [`super::simulate`].
    pub fn of(spec: &Spec, progress: &Progress<'_>) -> Result<Self, AnalysisError> {
        let each = spec.each();
        let count = each.len();
        let strand = |(number, (side, spec)): (usize, (Side, Spec))| {
            let watched = |done: usize, of: usize| progress(number * of + done, count * of);
            let cases = simulate_alone(&spec, &watched)?;
            Ok(Strand { side, spec, cases })
        };
        let springs: Vec<Strand> = each.into_iter().enumerate().map(strand).collect::<Result<_, AnalysisError>>()?;
        let sum = |number: usize| {
            let each: Vec<(Side, &Signals)> =
                springs.iter().map(|strand| (strand.side, &strand.cases[number].signals)).collect();
            let case = &springs[0].cases[number];
            study::together(&each).map_err(|reason| refused(spec, case.condition, case.damping, reason))
        };
        let all = (0..springs[0].cases.len()).map(sum).collect::<Result<_, _>>()?;
        Ok(Self { springs, all })
    }

    /// The series of a case for a file: time, positions of the ends and the forces of all, then those of each spring under its name.
    pub fn series(&self, number: usize) -> Run<'_> {
        let (spec, case) = (&self.springs[0].spec, &self.springs[0].cases[number]);
        let mut run =
            Run::of(&spec.conditions[case.condition].name, &spec.mount.cases[case.damping].label, &self.all[number]);
        for strand in &self.springs {
            let own = strand.cases[number].signals.channels();
            for (channel, values) in own.filter(|(channel, _)| !matches!(channel, Channel::U1 | Channel::U2)) {
                let name = format!("{} {}", channel.name(), strand.spec.spring.name);
                run.columns.push(Column::new(name, channel.unit(), values));
            }
        }
        run
    }
}
