//! What of a spec makes a speed map doubtful: lengths out of range, damping that no coil has, a cam that is written too coarsely.
//!
//! Next door: the answer (`answer`).

use super::SpeedMap;
use crate::quantity::digits;
use crate::spec::CamRows;

/// Fewest rows of a cam's file for a period of the harmonic that has the first surge frequency: a spline then keeps 99 % of it.
const LEAST_ROWS: f64 = 6.0;
/// Share of the lift's second derivative that rounding may make.
const ROUNDED: f64 = 0.05;

/// Each in a sentence.
pub(super) fn of(map: &SpeedMap) -> Vec<String> {
    let cam = map.cam.rows.iter().flat_map(|rows| [coarse(map, rows), rounded(rows)]).flatten();
    out_of_range(map).into_iter().chain(map.spec.mount.doubt()).chain(cam).collect()
}

/// Lengths that the cam takes the spring to and that are not in use, as the spec says.
fn out_of_range(map: &SpeedMap) -> Option<String> {
    let (min, max) = map.spec.spring.spring.operating_range();
    let (shortest, longest) = (map.cam.length - map.cam.lift, map.cam.length);
    // A micrometre is rounding of a length as it is written.
    (shortest < min - 1e-6).then(|| {
        format!(
            "lengths from {:.2} to {:.2} mm leave the range in use, {:.2} to {:.2} mm.",
            1e3 * shortest,
            1e3 * longest,
            1e3 * min,
            1e3 * max
        )
    })
}

/// Rows too far apart for the lowest harmonic that meets the first surge frequency.
fn coarse(map: &SpeedMap, rows: &CamRows) -> Option<String> {
    let harmonic = map.campbell.lines.first()?.frequency / (map.range.to * map.range.ratio);
    let period = 1.0 / (harmonic * rows.step);
    (period < LEAST_ROWS).then(|| {
        format!(
            "the cam's rows lie up to {} deg apart, {} a period of harmonic {harmonic:.0}, which has the first surge frequency at the highest speed: what \
             is between them is made up. Take a finer table.",
            digits(360.0 * rows.step),
            digits(period)
        )
    })
}

/// Lifts rounded so far that their steps are accelerations.
///
/// Second differences of numbers that are rounded to q have an rms of q/√12 · √6 over the step's square.
fn rounded(rows: &CamRows) -> Option<String> {
    let made = rows.digit * 0.5f64.sqrt() / (rows.step * rows.step);
    (made > ROUNDED * rows.bend).then(|| {
        format!(
            "the cam's lifts are rounded to {} mm, which alone makes {} % of its acceleration (rms): float and surge may be those of the rounding. Take a \
             table with more digits, or a smoothed one.",
            digits(1e3 * rows.digit),
            digits((100.0 * made / rows.bend).min(100.0))
        )
    })
}
