//! How far a loop is from unstable, read off its trace.
//!
//! Next door: the trace (`trace`).

use num_complex::Complex64;

use super::trace::Trace;
use crate::error::Error;

/// Margins of a loop, with all gains times a common factor as the thing to change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Whether the loop is stable as it is.
    pub stable: bool,
    /// The factor on all gains up to which the loop is stable, from a small one on \[1\]; infinite without a limit, zero where it is unstable
    /// from the smallest gain on.
    pub gain_limit: f64,
    /// Where it then oscillates \[rad/s\]; zero without a limit.
    pub critical_frequency: f64,
    /// Where |L| falls through 1 for the last time \[rad/s\]; zero where it never does.
    pub crossover: f64,
    /// The least phase margin over all such crossings \[rad\]; infinite where there is none.
    pub phase: f64,
    /// The delay that would use it up \[s\].
    pub delay: f64,
    /// Least distance of L from −1 \[1\]: the inverse of the largest sensitivity.
    pub modulus: f64,
    /// The factor on all gains at which that distance is still 1/2 (a sensitivity of 2) \[1\].
    pub robust_gain: f64,
}

/// The distance from −1 that [`Margins::robust_gain`] keeps.
const ROBUST: f64 = 0.5;

impl Margins {
    /// Reads a trace; `response` is asked again where it crosses the real axis.
    pub(super) fn of(trace: &Trace, response: impl Fn(f64) -> Result<Complex64, Error>) -> Result<Self, Error> {
        let crossings = trace.negative_crossings(response)?;
        // From a small gain on, a pole first reaches the axis where −L is largest.
        let first = crossings.iter().max_by(|a, b| (-a.response.re).total_cmp(&(-b.response.re)));
        let limit = first.map_or(f64::INFINITY, |point| -1.0 / point.response.re);
        let small = if limit.is_finite() { 0.5 * limit } else { 1.0 };
        let from_start = trace.unstable_poles(small) == 0;
        let (gain_limit, critical_frequency) = match (from_start, first) {
            (false, _) => (0.0, first.map_or(0.0, |point| point.angular_frequency)),
            (true, None) => (f64::INFINITY, 0.0),
            (true, Some(point)) => (limit, point.angular_frequency),
        };
        let falls = trace.falls_through(1.0);
        let margin = |response: Complex64| std::f64::consts::PI - response.arg().abs();
        let phase = falls.iter().map(|point| margin(point.response)).fold(f64::INFINITY, f64::min);
        // A delay turns L clockwise: from its own phase down to −π.
        let late = |response: Complex64| (response.arg() + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU);
        let delay =
            falls.iter().map(|point| late(point.response) / point.angular_frequency).fold(f64::INFINITY, f64::min);
        Ok(Self {
            stable: trace.unstable_poles(1.0) == 0,
            gain_limit,
            critical_frequency,
            crossover: falls.last().map_or(0.0, |point| point.angular_frequency),
            phase,
            delay,
            modulus: trace.distance(1.0),
            robust_gain: robust_gain(trace, gain_limit),
        })
    }
}

/// Largest gain below `limit` that keeps its distance, by bisection of its logarithm; without a limit up to 1e12.
fn robust_gain(trace: &Trace, limit: f64) -> f64 {
    if limit == 0.0 {
        return 0.0;
    }
    let mut high = limit.min(1e12);
    if trace.distance(high) >= ROBUST && limit.is_infinite() {
        return f64::INFINITY;
    }
    let mut low = 1e-9 * high;
    for _ in 0..60 {
        let middle = (low * high).sqrt();
        if (trace.distance(middle)) >= ROBUST { low = middle } else { high = middle }
    }
    low
}
