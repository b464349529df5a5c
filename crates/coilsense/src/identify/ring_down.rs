//! One tap's ringing beside what the modes that were found make of it: for people to look at.
//!
//! Next door: the fit of all taps together (`refine`).

use nalgebra::{DMatrix, DVector};

use super::line::Line;
use super::ringing::{Part, Series};
use super::sampling::Sampling;
use super::taps::Tap;

/// How many e-foldings of the slowest line are shown, and at most how long \[s\].
const FOLDS: f64 = 4.0;
const LONGEST: f64 = 4.0;

/// What was recorded after the strongest tap, and the sum of the lines that die out.
#[derive(Debug, Clone, PartialEq)]
pub struct RingDown {
    /// In which part of the forces.
    pub part: Part,
    /// When the tap was \[s\].
    pub tap: f64,
    /// Time since the tap \[s\], shape `samples`.
    pub time: Vec<f64>,
    /// Force less the slow one \[N\], shape `samples`.
    pub measured: Vec<f64>,
    /// Fitted lines \[N\], shape `samples`.
    pub fitted: Vec<f64>,
}

/// The strongest tap's ring-down in the part of the strongest line; amplitudes by least squares, poles as they were found from all taps.
pub(super) fn of(lines: &[Line], series: &[Series], taps: &[Tap], sampling: &Sampling) -> Option<RingDown> {
    let decaying = || lines.iter().filter(|line| line.decays);
    let part = decaying().max_by(|a, b| a.strength.total_cmp(&b.strength))?.part;
    let index = series.iter().position(|series| Some(series.part) == part).unwrap_or(0);
    let shown = series.get(index)?;
    let strongest = (0..taps.len()).max_by(|&a, &b| taps[a].strength.total_cmp(&taps[b].strength))?;
    let poles: Vec<(f64, f64)> = decaying()
        .filter(|line| line.part.is_none_or(|part| part == shown.part))
        .filter_map(|line| {
            let angular = std::f64::consts::TAU * line.frequency.value / sampling.rate;
            let ratio = line.ratio?.value.clamp(0.0, 0.999);
            Some((ratio * angular, angular * (1.0 - ratio * ratio).sqrt()))
        })
        .collect();
    let slowest = poles.iter().map(|pole| pole.0).fold(f64::INFINITY, f64::min);
    let start = taps[strongest].after;
    let end = taps.get(strongest + 1).map_or(sampling.samples, |tap| tap.onset);
    let wanted = (FOLDS / slowest).min(LONGEST * sampling.rate) as usize;
    let count = end.saturating_sub(start).min(wanted);
    let measured = shown.flat.get(start..start + count)?.to_vec();
    let columns = 2 * poles.len();
    if count < 4 * columns.max(4) {
        return None;
    }
    let shape = |sample: usize, column: usize| {
        let (decay, angular) = poles[column / 2];
        let (sine, cosine) = (angular * sample as f64).sin_cos();
        (-decay * sample as f64).exp() * if column.is_multiple_of(2) { cosine } else { sine }
    };
    let matrix = DMatrix::from_fn(count, columns, shape);
    let normal = matrix.tr_mul(&matrix);
    let right = matrix.tr_mul(&DVector::from_column_slice(&measured));
    let amplitudes = normal.cholesky()?.solve(&right);
    let fitted = (&matrix * amplitudes).iter().copied().collect();
    let since = |sample: usize| sampling.time(start + sample) - taps[strongest].time;
    Some(RingDown {
        part: shown.part,
        tap: taps[strongest].time,
        time: (0..count).map(since).collect(),
        measured,
        fitted,
    })
}
