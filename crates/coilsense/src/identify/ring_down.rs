//! One hit's ringing beside what the modes that were found make of it: for people to look at.
//!
//! Next door: the fit of all hits together (`refine`).

use nalgebra::DVector;

use super::decaying::decaying_pairs;
use super::hits::Hit;
use super::line::Line;
use super::ringing::{Part, Series};
use super::sampling::Sampling;

/// How many e-foldings of the slowest line are shown, and at most how long \[s\].
const FOLDS: f64 = 4.0;
const LONGEST: f64 = 4.0;

/// What was recorded after the strongest hit, and the sum of the lines that decay.
#[derive(Debug, Clone, PartialEq)]
pub struct RingDown {
    /// In which part of the forces.
    pub part: Part,
    /// When the hit was \[s\].
    pub hit: f64,
    /// Time since the hit \[s\], shape `samples`.
    pub time: Vec<f64>,
    /// Force less the slow one \[N\], shape `samples`.
    pub measured: Vec<f64>,
    /// Fitted lines \[N\], shape `samples`.
    pub fitted: Vec<f64>,
}

/// The strongest hit's ring-down in the part of the strongest line; amplitudes by least squares, poles as they were found from all hits.
pub(super) fn of(lines: &[Line], series: &[Series], hits: &[Hit], sampling: &Sampling) -> Option<RingDown> {
    let decaying = || lines.iter().filter(|line| line.decays);
    let part = decaying().max_by(|a, b| a.strength.total_cmp(&b.strength))?.part;
    let index = series.iter().position(|series| Some(series.part) == part).unwrap_or(0);
    let shown = series.get(index)?;
    let strongest = (0..hits.len()).max_by(|&a, &b| hits[a].strength.total_cmp(&hits[b].strength))?;
    let poles: Vec<(f64, f64)> = decaying()
        .filter(|line| line.part.is_none_or(|part| part == shown.part))
        .filter_map(|line| {
            let angular = std::f64::consts::TAU * line.frequency.value / sampling.rate;
            let ratio = line.ratio?.value.clamp(0.0, 0.999);
            Some((ratio * angular, angular * (1.0 - ratio * ratio).sqrt()))
        })
        .collect();
    let slowest = poles.iter().map(|pole| pole.0).fold(f64::INFINITY, f64::min);
    let start = hits[strongest].after;
    let end = hits.get(strongest + 1).map_or(sampling.samples, |hit| hit.onset);
    let wanted = (FOLDS / slowest).min(LONGEST * sampling.rate) as usize;
    let count = end.saturating_sub(start).min(wanted);
    let columns = 2 * poles.len();
    if count < 4 * columns.max(4) {
        return None;
    }
    let measured = shown.flat(start..start + count);
    let matrix = decaying_pairs(&poles, count);
    let normal = matrix.tr_mul(&matrix);
    let right = matrix.tr_mul(&DVector::from_column_slice(&measured));
    let amplitudes = normal.cholesky()?.solve(&right);
    let fitted = (&matrix * amplitudes).iter().copied().collect();
    let since = |sample: usize| sampling.time(start + sample) - hits[strongest].time;
    Some(RingDown {
        part: shown.part,
        hit: hits[strongest].time,
        time: (0..count).map(since).collect(),
        measured,
        fitted,
    })
}
