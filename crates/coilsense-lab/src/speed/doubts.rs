//! What of a spec makes a speed map doubtful: lengths out of range, unusually high damping, a cam that is written too coarsely.
//!
//! Next door: the answer (`answer`).

use super::SpeedMap;
use crate::quantity::digits;
use crate::spec::CamRows;

/// Fewest rows of a cam's file for a period of the harmonic that has the first surge frequency: a cubic spline then keeps 99.8 % of it,
/// sinc⁴(1/6) / Σ sinc⁴(1/6 + n).
const LEAST_ROWS: f64 = 6.0;
/// Share of the lift's second derivative that rounding may make.
const ROUNDED: f64 = 0.05;

/// Each in a sentence.
pub(super) fn of(map: &SpeedMap) -> Vec<String> {
    let cam = map.cam.rows.iter().flat_map(|rows| [coarse(map, rows), rounded(rows)]).flatten();
    let lengths = map.spec.spring.out_of_use(map.cam.length - map.cam.lift, map.cam.length);
    lengths.into_iter().chain(map.spec.mount.doubt()).chain(cam).collect()
}

/// Rows too far apart for the lowest harmonic that meets the first surge frequency.
fn coarse(map: &SpeedMap, rows: &CamRows) -> Option<String> {
    let harmonic = map.campbell.lines.first()?.frequency / (map.range.to * map.range.ratio);
    let period = 1.0 / (harmonic * rows.step);
    (period < LEAST_ROWS).then(|| {
        format!(
            "the cam's rows lie up to {} deg apart, {} for each period of harmonic {harmonic:.0}, which has the first surge frequency at the highest \
             speed: surge there is that of the interpolation. Take a finer table.",
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
            "the cam's lifts are rounded to {} mm, which alone makes {} % of its acceleration (rms): float and surge may come from rounding. Take a \
             table with more digits, or smooth it.",
            digits(1e3 * rows.digit),
            digits((100.0 * made / rows.bend).min(100.0))
        )
    })
}
