//! Which speeds are run: steps, and more of them where a harmonic of the cam has the first surge frequency.
//!
//! Next door: those crossings (`campbell`), one speed (`point`).

use super::{Campbell, Range};

/// Speeds of one way, ascending, and how many of them stand beside the steps.
pub(super) struct Speeds {
    /// \[Hz\].
    pub each: Vec<f64>,
    /// Those that no step has.
    pub added: usize,
}

/// Speeds nearer than this share of themselves are one.
const SAME: f64 = 1e-4;

impl Speeds {
    /// The steps of a range, each crossing, and what lies half a half-power bandwidth below and above it: there a mode of damping ratio ζ
    /// answers with 1/√2 of its peak, f1 (1 ± ζ)/n.
    pub fn of(range: &Range, campbell: &Campbell, damping_ratio: f64) -> Self {
        let mut each = range.steps();
        let steps = each.len();
        let within = |speed: &f64| (range.from..=range.to).contains(speed);
        let about = |speed: f64| [speed, speed * (1.0 - damping_ratio), speed * (1.0 + damping_ratio)];
        each.extend(campbell.crossings.iter().flat_map(|crossing| about(crossing.speed)).filter(within));
        each.sort_by(f64::total_cmp);
        each.dedup_by(|a, b| (*a - *b).abs() < SAME * *b);
        let added = each.len().saturating_sub(steps);
        Self { each, added }
    }
}
