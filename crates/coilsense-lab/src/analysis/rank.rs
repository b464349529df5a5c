//! Which sensor comes first: one that meets the goal, of those one whose limits of error are known, of those the least uncertain.
//!
//! Next door: what is said of each (`verdict`).

use std::cmp::Ordering;

use super::verdict::Verdict;
use crate::spec::SensorSpec;

/// What a sensor is ranked by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rank {
    misses: bool,
    /// Whether its uncertainty is the least that it errs by: what makes it meet a goal may be what nobody told.
    at_least: bool,
    combined: f64,
}

impl Rank {
    /// Of a verdict.
    pub fn of(verdict: &Verdict) -> Self {
        Self::new(verdict.meets_always() == Some(false), verdict.has_limits, verdict.combined())
    }

    /// The same with another uncertainty \[N\] held against the goal.
    pub fn with(verdict: &Verdict, combined: f64, goal: Option<f64>) -> Self {
        let misses = verdict.too_slow || verdict.overload.is_some() || goal.is_some_and(|goal| combined > goal);
        Self::new(goal.is_some() && misses, verdict.has_limits, combined)
    }

    fn new(misses: bool, has_limits: bool, combined: f64) -> Self {
        Self { misses, at_least: !misses && !has_limits, combined }
    }

    /// Whether it comes before another.
    pub fn compared(&self, other: &Self) -> Ordering {
        let rank = |rank: &Self| (rank.misses, rank.at_least);
        rank(self).cmp(&rank(other)).then(self.combined.total_cmp(&other.combined))
    }
}

/// Whether a limit of error of a sensor is told; noise and resolution are none.
pub(super) fn has_limits(sensor: &SensorSpec) -> bool {
    let told = sensor.accuracy_full_scale + sensor.accuracy_reading + sensor.calibration_uncertainty;
    // Of a coil the calibration is doubted in any case.
    told > 0.0 || sensor.quantity.kind() == "inductance"
}
