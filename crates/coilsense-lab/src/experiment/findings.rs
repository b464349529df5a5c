//! What the means and deviations of an experiment show: where they peak, what is biased there, what drifts.
//!
//! Next door: the numbers (`outcome`), the words (`answer`).

use coilsense::Channel;
use coilsense::measures::Trend;

use super::{Experiment, FORCES, Run};
use crate::spec::RunKind;

/// Standard errors from which on a difference counts as seen.
pub(super) const SEEN: f64 = 3.0;

/// By what share sums of a long record may round: 100 000 samples at 1e-16 each.
const ROUNDING: f64 = 1e-11;

/// What an experiment shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings {
    /// The sine at which F_o departs most from F_x.
    pub peak: Option<Peak>,
    /// Each force's mean against its neighbours' of every sine that has two, in recorded order: run, force, offset.
    pub offsets: Vec<(usize, Channel, Offset)>,
    /// Each force's drift over the experiment.
    pub drifts: Vec<Drift>,
}

/// Where the RMSD of F_o from F_x is largest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The run's place among [`Experiment::runs`].
    pub run: usize,
    /// Its RMSD over the larger of its neighbours' in frequency \[1\].
    pub rmsd_ratio: f64,
    /// The same of the largest deviation \[1\].
    pub maximum_ratio: f64,
}

/// A mean less the mean of its two neighbours'.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Offset {
    /// \[N\].
    pub value: f64,
    /// Its standard error \[N\].
    pub error: f64,
}

impl Offset {
    /// How many standard errors it is.
    pub fn ratio(&self) -> f64 {
        if self.error > 0.0 { self.value / self.error } else { 0.0 }
    }

    /// Whether it is more than chance.
    pub fn is_seen(&self) -> bool {
        self.ratio().abs() > SEEN
    }
}

/// How a force's mean changes over the experiment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drift {
    /// Which force.
    pub force: Channel,
    /// Last preload less first; none with one preload only.
    pub preloads: Option<Offset>,
    /// Over all runs in recorded order; none with fewer than three.
    pub trend: Option<Trend>,
}

impl Findings {
    /// Of an experiment.
    pub fn of(experiment: &Experiment) -> Self {
        let runs = &experiment.runs;
        let offsets = (1..runs.len().saturating_sub(1)).filter(|&index| runs[index].spec.kind == RunKind::Harmonic);
        let offsets = offsets.flat_map(|index| FORCES.map(|force| (index, force)));
        let offset =
            |(index, force): (usize, Channel)| Some((index, force, offset(&runs[index - 1..=index + 1], force)?));
        Self {
            peak: peak(experiment),
            offsets: offsets.filter_map(offset).collect(),
            drifts: FORCES.into_iter().filter_map(|force| drift(runs, force)).collect(),
        }
    }

    /// The offset of a force at a run.
    pub fn offset(&self, run: usize, force: Channel) -> Option<Offset> {
        self.offsets.iter().find(|(at, of, _)| (*at, *of) == (run, force)).map(|(_, _, offset)| *offset)
    }
}

fn peak(experiment: &Experiment) -> Option<Peak> {
    let mut sines: Vec<(usize, &Run)> = experiment.harmonics().collect();
    sines.sort_by(|a, b| a.1.spec.frequency.total_cmp(&b.1.spec.frequency));
    let rmsd = |run: &Run| run.fast.deviation.rmsd;
    let (place, &(index, run)) = sines.iter().enumerate().max_by(|a, b| rmsd(a.1.1).total_cmp(&rmsd(b.1.1)))?;
    let neighbours: Vec<&Run> =
        [place.checked_sub(1), Some(place + 1)].into_iter().flatten().filter_map(|at| Some(sines.get(at)?.1)).collect();
    let most = |of: &dyn Fn(&Run) -> f64| neighbours.iter().map(|run| of(run)).fold(0.0, f64::max);
    let ratio = |of: &dyn Fn(&Run) -> f64| if most(of) > 0.0 { of(run) / most(of) } else { f64::INFINITY };
    Some(Peak {
        run: index,
        rmsd_ratio: ratio(&rmsd),
        maximum_ratio: ratio(&|run: &Run| run.fast.deviation.maximum_absolute),
    })
}

/// F̄ − (F̄_before + F̄_after)/2 of three runs that follow each other, so that a steady drift falls out.
///
/// u² = u_F² + (u_before² + u_after²)/4, and the rounding of the sums
fn offset(three: &[Run], force: Channel) -> Option<Offset> {
    let [before, own, after] = three else { return None };
    let [before, own, after] = [before.mean(force)?, own.mean(force)?, after.mean(force)?];
    Some(Offset {
        value: own.mean - 0.5 * (before.mean + after.mean),
        error: own.judged_error().hypot(0.5 * before.judged_error().hypot(after.judged_error()))
            + ROUNDING * own.mean.abs(),
    })
}

fn drift(runs: &[Run], force: Channel) -> Option<Drift> {
    let means: Vec<f64> = runs.iter().filter_map(|run| run.mean(force)).map(|mean| mean.mean).collect();
    if means.is_empty() {
        return None;
    }
    let preloads: Vec<_> =
        runs.iter().filter(|run| run.spec.kind == RunKind::Preload).filter_map(|run| run.mean(force)).collect();
    let compared = match preloads.as_slice() {
        [first, .., last] => Some(Offset {
            value: last.mean - first.mean,
            error: first.judged_error().hypot(last.judged_error()) + ROUNDING * first.mean.abs(),
        }),
        _ => None,
    };
    Some(Drift { force, preloads: compared, trend: Trend::of(&means).ok() })
}
