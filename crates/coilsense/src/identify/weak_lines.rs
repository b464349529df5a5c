//! Lines that stronger ones hide: what is heard once the modes that were found are taken out of the forces.
//!
//! A mode's spectrum falls off as slowly as 1/Δf, so that a line of a few percent beside it is no peak. Only satellites are sought here
//! (`satellites`): what the verdict and f1 rest on is heard in the forces as they are (`record_lines`).

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::DVector;

use super::decaying::decaying_pairs;
use super::fitted::Fitted;
use super::hits::Hit;
use super::line::{Line, Meaning};
use super::lines::{Peak, after_hits};
use super::record_lines::line_of;
use super::refine::Refiner;
use super::ringing::Series;
use super::sampling::Sampling;
use super::taken_out::TakenOut;

/// How often what was found is taken out and listened again: what one line hides, a second look hears.
const ROUNDS: usize = 2;
/// Lines that are fitted in each, at most.
const MOST: usize = 16;
/// E-foldings after which a mode has gone.
const GONE: f64 = 10.0;
/// Values of the modes' shapes, at most: 40 MB.
const MOST_VALUES: usize = 5_000_000;
/// What is left of a mode lies this near it: widths at half power, or a share of its frequency \[1\].
const WIDTHS: f64 = 3.0;
const NEAR: f64 = 0.01;
/// What a fit leaves of a line is this share of it, at most \[1\].
const LEFT: f64 = 0.3;

/// Lines that decay beside the modes of `lines`.
pub(super) fn beside_modes(lines: &[Line], series: &[Series], hits: &[Hit], sampling: &Sampling) -> Vec<Line> {
    let is_mode = |line: &&Line| line.decays && matches!(line.meaning, Meaning::Mode(_) | Meaning::Alias { .. });
    let modes: Vec<Line> = lines.iter().filter(is_mode).cloned().collect();
    let near_mode = |frequency: f64| {
        let near = |mode: &Line| {
            let reach = (WIDTHS * mode.width()).max(NEAR * mode.frequency.value);
            (frequency - mode.frequency.value).abs() < reach
        };
        modes.iter().any(near)
    };
    let Some(beside) = without(&modes, series, hits, sampling) else { return Vec::new() };
    let mut fits: Vec<Fitted> = Vec::new();
    let mut found: Vec<Line> = Vec::new();
    for round in 0..ROUNDS {
        let hidden = if round == 0 { None } else { without(&found, &beside, hits, sampling) };
        let rest = hidden.as_ref().unwrap_or(&beside);
        let mut peaks: Vec<Peak> =
            rest.iter().enumerate().flat_map(|(n, one)| after_hits(n, one, hits, sampling)).collect();
        peaks.retain(|peak| !near_mode(peak.frequency));
        peaks.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        peaks.truncate(MOST);
        let mut more = Refiner::new(rest, hits, sampling).lines(&peaks);
        more.retain(|one| line_of(one, rest, sampling.rate).is_some_and(|(line, _)| may_be(&line, &found)));
        if more.is_empty() {
            break;
        }
        // Beside one another, those found first are what they were fitted without.
        if !fits.is_empty() {
            more.extend(fits);
            more = Refiner::new(&beside, hits, sampling).together(more);
        }
        fits = more;
        let lines = fits.iter().filter_map(|one| Some(line_of(one, &beside, sampling.rate)?.0));
        found = lines.filter(|line| line.decays && !near_mode(line.frequency.value)).collect();
    }
    found
}

/// Whether a line decays and is more than what a fit left of another.
fn may_be(line: &Line, found: &[Line]) -> bool {
    line.decays && !found.iter().any(|other| is_left_of(line, other))
}

/// Whether a line is no more than what a fit left of another.
fn is_left_of(line: &Line, other: &Line) -> bool {
    let apart = (line.frequency.value - other.frequency.value).abs();
    apart < other.width() && line.amplitude < LEFT * other.amplitude
}

/// The series less decaying lines, whose amplitudes after each hit are those of least squares; none without lines or where the record is too long.
fn without<'a>(lines: &[Line], series: &[Series<'a>], hits: &[Hit], sampling: &Sampling) -> Option<Vec<Series<'a>>> {
    let poles: Vec<(f64, f64)> = lines
        .iter()
        .filter_map(|line| {
            let angular = TAU * line.frequency.value / sampling.rate;
            let ratio = line.ratio?.value.clamp(0.0, 0.999);
            Some((ratio * angular, angular * (1.0 - ratio * ratio).sqrt()))
        })
        .collect();
    let slowest = poles.iter().map(|pole| pole.0).fold(f64::INFINITY, f64::min);
    let lasting = (GONE / slowest).min(sampling.samples as f64) as usize;
    let stretch = |index: usize| {
        let end = hits.get(index + 1).map_or(sampling.samples, |hit| hit.onset);
        (hits[index].after, end.saturating_sub(hits[index].after).min(lasting))
    };
    let columns = 2 * poles.len();
    let stretches: Vec<(usize, usize)> = (0..hits.len()).map(stretch).filter(|(_, n)| *n > 4 * columns).collect();
    let longest = stretches.iter().map(|(_, length)| *length).max()?;
    if columns == 0 || columns * longest > MOST_VALUES {
        return None;
    }
    let shapes = Arc::new(decaying_pairs(&poles, longest));
    let mut taken: Vec<TakenOut> = series.iter().map(|_| TakenOut::of(&shapes)).collect();
    let mut factor = None;
    for &(start, length) in &stretches {
        let own = shapes.rows(0, length);
        // Most stretches are as long as the slowest mode rings.
        if factor.as_ref().is_none_or(|(of, _)| *of != length) {
            factor = Some((length, own.tr_mul(&own).cholesky()?));
        }
        let Some((_, factor)) = &factor else { continue };
        for (one, taken) in series.iter().zip(&mut taken) {
            let amplitudes = factor.solve(&own.tr_mul(&DVector::from_column_slice(&one.flat(start..start + length))));
            taken.after_hit(start, length, amplitudes);
        }
    }
    Some(series.iter().zip(taken).map(|(one, taken)| one.without(taken)).collect())
}
