//! How far a loop is from unstable, read off its trace.
//!
//! Next door: the trace (`trace`).

use num_complex::Complex64;

use super::trace::{Point, Trace};
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
    /// The factor on all gains up to which that distance is at least 1/2 (a sensitivity of 2) \[1\]; zero without one.
    pub robust_gain: f64,
    /// The factor from which on, up to [`Self::robust_gain`], that distance is kept \[1\]; zero where it is from the smallest on. Two
    /// integrators, as a PI controller on a drive of velocity has them, are the less damped the slower the loop is.
    pub robust_from: f64,
}

/// The distance from −1 that [`Margins::robust_gain`] keeps.
const ROBUST: f64 = 0.5;
/// What L may grow by from point to point of a trace: nearer factors are neighbours', with nothing in between.
const NEIGHBOURS: f64 = 1.5;

impl Margins {
    /// Reads a trace; `response` is asked again where it crosses the real axis. That of samples `ends` on that axis, at half their rate, and from
    /// there goes back on its other side: a crossing that changes no sign.
    pub(super) fn of(
        trace: &Trace,
        ends: Option<Point>,
        response: impl Fn(f64) -> Result<Complex64, Error>,
    ) -> Result<Self, Error> {
        let mut crossings = trace.negative_crossings(response)?;
        crossings.extend(ends.filter(|point| point.response.re < 0.0));
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
        let [robust_from, robust_gain] = robust_gains(trace, gain_limit);
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
            robust_gain,
            robust_from,
        })
    }
}

/// From which factor on all gains on and up to which the distance is kept at every smaller or, where slow loops do not keep it, every larger one: up to the
/// first at which it is not. Beyond its ends the trace is taken to go on in the direction that it has there.
fn robust_gains(trace: &Trace, limit: f64) -> [f64; 2] {
    let points = trace.points();
    let mut all: Vec<[f64; 2]> = points.iter().filter_map(|point| lost(point.response)).collect();
    all.extend(points.first().and_then(|slowest| lost(slowest.response)).map(|[_, to]| [0.0, to]));
    all.extend(points.last().and_then(|fastest| lost(fastest.response)).map(|[from, _]| [from, f64::INFINITY]));
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut kept_from = 0.0;
    for [from, to] in all {
        if from > NEIGHBOURS * kept_from {
            let up_to = limit.min(from);
            return if kept_from < up_to { [kept_from, up_to] } else { [0.0; 2] };
        }
        kept_from = to.max(kept_from);
    }
    if kept_from < limit { [kept_from, limit] } else { [0.0; 2] }
}

/// The factors on all gains between which a response is nearer to −1 than [`ROBUST`], where there are any: the roots of |1 + g L| in g.
fn lost(response: Complex64) -> Option<[f64; 2]> {
    let size = response.norm();
    let towards = -response.re / size;
    let room = towards * towards - (1.0 - ROBUST * ROBUST);
    (towards > 0.0 && room > 0.0).then(|| [-1.0, 1.0].map(|side| (towards + side * room.sqrt()) / size))
}
