//! A loop's response along the imaginary axis, as finely as it turns: crossings, encirclements, the smallest distance from −1.
//!
//! Next door: whose response (`force_loop`, `sampled`), the margins read off it (`margins`).

use std::f64::consts::{FRAC_PI_2, PI};

use num_complex::Complex64;

use crate::error::{Error, called, check};

/// One point of a loop's response.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// ω \[rad/s\].
    pub angular_frequency: f64,
    /// L(jω) \[1\], negative feedback left out: the loop is unstable where it goes round −1.
    pub response: Complex64,
}

/// L(jω) from a frequency far below everything to one far above, neighbouring points at most [`Trace::TURN`] apart in phase.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    points: Vec<Point>,
    /// Poles at the origin: −d ln|L| / d ln ω at the lowest frequency.
    integrators: f64,
}

/// Most points of a trace.
const MOST_POINTS: usize = 400_000;

impl Trace {
    /// Largest change of phase from point to point \[rad\], of L and of its distance from −1 at any gain below the stable one.
    pub const TURN: f64 = 0.15;

    /// Traces `response` from `from` to `to` \[rad/s\], with at least the frequencies of `known` between them, refined until it turns slowly.
    ///
    /// # Errors
    /// Those of `response`; [`Error::Value`] where the range is empty or the response turns too quickly to be followed.
    pub(super) fn of(
        response: impl Fn(f64) -> Result<Complex64, Error>,
        from: f64,
        to: f64,
        known: impl IntoIterator<Item = f64>,
    ) -> Result<Self, Error> {
        let holds = from > 0.0 && to > from && to.is_finite();
        check(
            holds,
            called("to", "upper angular frequency"),
            to,
            "rad/s",
            format!("above the lower one of {from} rad/s"),
        )?;
        let decades = (to / from).log10();
        let count = (60.0 * decades).ceil() as usize;
        let mut frequencies: Vec<f64> =
            (0..count).map(|index| from * (to / from).powf(index as f64 / count as f64)).collect();
        // Not what rounding makes of it, which may lie beyond.
        frequencies.push(to);
        frequencies.extend(known.into_iter().filter(|frequency| (from..to).contains(frequency)));
        frequencies.sort_by(f64::total_cmp);
        frequencies.dedup();
        let point = |angular_frequency| Ok(Point { angular_frequency, response: response(angular_frequency)? });
        let mut points = vec![point(frequencies[0])?];
        let mut largest = points[0].response.norm();
        for pair in frequencies.windows(2) {
            let (first, last) = (points[points.len() - 1], point(pair[1])?);
            largest = largest.max(last.response.norm());
            refine(&point, [first, last], NOISE * largest, &mut points)?;
        }
        let (low, next) = (points[0], point(1.01 * points[0].angular_frequency)?);
        let integrators = -(next.response.norm() / low.response.norm()).ln() / 1.01_f64.ln();
        Ok(Self { points, integrators: integrators.round() })
    }

    /// Its points, lowest frequency first.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Poles of the closed loop in the right half plane at a gain \[1\] (Nyquist; the open loop has none but at the origin).
    pub fn unstable_poles(&self, gain: f64) -> usize {
        let turned: f64 = self
            .points
            .windows(2)
            .map(|pair| ((1.0 + gain * pair[1].response) / (1.0 + gain * pair[0].response)).arg())
            .sum();
        // From the origin's poles on, 1 + L starts n quarter turns behind and would end where it is without feedback.
        let expected = self.integrators.max(0.0) * FRAC_PI_2;
        ((expected - turned) / PI).round().max(0.0) as usize
    }

    /// Where L is real and below zero: ω \[rad/s\] and |L|, found by bisection on `response`.
    pub(super) fn negative_crossings(
        &self,
        response: impl Fn(f64) -> Result<Complex64, Error>,
    ) -> Result<Vec<Point>, Error> {
        let mut crossings = Vec::new();
        for pair in self.points.windows(2) {
            let [first, last] = [pair[0], pair[1]];
            if (first.response.im > 0.0) == (last.response.im > 0.0) || first.response.re.min(last.response.re) >= 0.0 {
                continue;
            }
            let crossing = bisect(&response, first, last)?;
            if crossing.response.re < 0.0 {
                crossings.push(crossing);
            }
        }
        Ok(crossings)
    }

    /// Where |L| falls through `size`: ω \[rad/s\], by straight lines of ln|L| over ln ω.
    pub(super) fn falls_through(&self, size: f64) -> Vec<Point> {
        let above = |point: &Point| point.response.norm() > size;
        let pairs = self.points.windows(2).filter(|pair| above(&pair[0]) && !above(&pair[1]));
        pairs
            .map(|pair| {
                let [first, last] = [&pair[0], &pair[1]];
                let fall = (first.response.norm() / last.response.norm()).ln();
                let share = (first.response.norm() / size).ln() / fall;
                let frequency =
                    first.angular_frequency * (last.angular_frequency / first.angular_frequency).powf(share);
                let turn = (last.response / first.response).arg();
                Point {
                    angular_frequency: frequency,
                    response: Complex64::from_polar(size, first.response.arg() + share * turn),
                }
            })
            .collect()
    }

    /// Smallest |1 + K L|: how near the response comes to −1 at a gain K.
    pub fn distance(&self, gain: f64) -> f64 {
        self.points.iter().map(|point| (1.0 + gain * point.response).norm()).fold(f64::INFINITY, f64::min)
    }
}

/// Below this share of what came before, a response may be what rounding leaves of terms that cancel; its phase then says nothing.
const NOISE: f64 = 1e-13;

/// Appends points between the first, which is there, and the last until each turns by at most [`Trace::TURN`] and grows by at most a half;
/// responses below `noise` are let be.
fn refine(
    point: &impl Fn(f64) -> Result<Point, Error>,
    [first, last]: [Point; 2],
    noise: f64,
    points: &mut Vec<Point>,
) -> Result<(), Error> {
    let mut pending = vec![last];
    let mut from = first;
    while let Some(&to) = pending.last() {
        let (width, ratio) = (to.angular_frequency - from.angular_frequency, to.response / from.response);
        let smooth = ratio.arg().abs() <= Trace::TURN && (0.7..=1.5).contains(&ratio.norm());
        let silent = from.response.norm().max(to.response.norm()) <= noise;
        if smooth || silent || width <= 1e-13 * to.angular_frequency {
            points.push(to);
            from = to;
            pending.pop();
            continue;
        }
        let total = points.len() + pending.len();
        check(total < MOST_POINTS, "points of a loop's response", total as f64, "", format!("at most {MOST_POINTS}"))?;
        pending.push(point(from.angular_frequency + 0.5 * width)?);
    }
    Ok(())
}

/// The zero of Im L between two points of different sign.
fn bisect(response: &impl Fn(f64) -> Result<Complex64, Error>, first: Point, last: Point) -> Result<Point, Error> {
    let (mut low, mut high) = (first.angular_frequency, last.angular_frequency);
    let rising = last.response.im > 0.0;
    loop {
        let middle = 0.5 * (low + high);
        let found = response(middle)?;
        if middle <= low || middle >= high {
            return Ok(Point { angular_frequency: middle, response: found });
        }
        if (found.im > 0.0) == rising { high = middle } else { low = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_point_lies_beyond_the_range_by_rounding() {
        // Half the rate of a loop is where its response ends: 0.3 ms was refused by the last digit, as nearly every second step was.
        for tenths in 1..200 {
            let to = PI / (1e-4 * f64::from(tenths));
            let within = |frequency: f64| {
                assert!((1e-3..=to).contains(&frequency), "{frequency} of {to}");
                Ok(Complex64::new(1.0, 0.0) / Complex64::new(1.0, frequency))
            };
            let trace = Trace::of(within, 1e-3, to, []).unwrap();
            assert_eq!(trace.points().last().unwrap().angular_frequency, to);
        }
    }
}
