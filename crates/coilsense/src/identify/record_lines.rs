//! The lines of a record with their numbers: those fitted after hits that are sure, and steady ones.
//!
//! Next door: peaks (`lines`), the fit (`refine`), what one line is (`line`), what they mean (`naming`).

use std::f64::consts::TAU;

use super::explain::Heard;
use super::fitted::Fitted;
use super::hits::Hit;
use super::line::{Line, Meaning};
use super::lines::{Peak, after_hits};
use super::mode_series::Observation;
use super::refine::Refiner;
use super::ringing::{Part, Series};
use super::sampling::Sampling;
use super::value::Estimate;
use crate::signals::Channel;
use crate::uncertainty::coverage_factor;

/// Lines that are fitted at most, the strongest.
const MOST_LINES: usize = 80;
/// The same times hits, and what is fitted in any case: a fit's cost goes with both.
const MOST_FITS: usize = 600;
const FEWEST_LINES: usize = 24;
/// What a line's own rate is over its uncertainty, at least.
const SURE: f64 = 6.0;
/// A part holds a line where its power is this many times the other's.
const DOMINANT: f64 = 10.0;

/// The lines of a record, lowest first.
pub(super) struct RecordLines {
    pub(super) lines: Vec<Line>,
    /// e-folding time of each \[s\].
    pub(super) foldings: Vec<f64>,
    /// What was heard of those that decay, lowest first.
    pub(super) heard: Vec<Heard>,
}

impl RecordLines {
    /// Lines after hits, fitted, and steady ones of spectra `spacing` \[Hz\] fine that are not among them.
    pub(super) fn of(series: &[Series], hits: &[Hit], sampling: &Sampling, steady: &[Peak], spacing: f64) -> Self {
        let mut lines: Vec<(Line, f64, Option<Fitted>)> = Vec::new();
        if !hits.is_empty() {
            let mut peaks: Vec<Peak> =
                series.iter().enumerate().flat_map(|(n, one)| after_hits(n, one, hits, sampling)).collect();
            peaks.sort_by(|a, b| b.strength.total_cmp(&a.strength));
            peaks.truncate(MOST_LINES.min((MOST_FITS / hits.len()).max(FEWEST_LINES)));
            let fitted = Refiner::new(series, hits, sampling).lines(&peaks);
            lines.extend(fitted.into_iter().filter_map(|fitted| {
                let (line, folding) = line_of(&fitted, series, sampling.rate)?;
                Some((line, folding, Some(fitted)))
            }));
        }
        for peak in steady {
            let known = lines
                .iter()
                .any(|(line, ..)| (line.frequency.value - peak.frequency).abs() < 3.0 * spacing + 3.0 * line.width());
            if !known && (hits.is_empty() || peak.strength > 100.0) {
                lines.push((steady_line(peak, series, spacing), f64::INFINITY, None));
            }
        }
        lines.sort_by(|a, b| a.0.frequency.value.total_cmp(&b.0.frequency.value));
        let mut found = Self { lines: Vec::new(), foldings: Vec::new(), heard: Vec::new() };
        for (index, (line, folding, fitted)) in lines.into_iter().enumerate() {
            let heard =
                fitted.filter(|_| line.decays).and_then(|fitted| Heard::of(index, &fitted, series, sampling.rate));
            found.heard.extend(heard);
            found.lines.push(line);
            found.foldings.push(folding);
        }
        found
    }
}

/// A fitted line, where it is sure, and its e-folding time \[s\].
pub(super) fn line_of(fitted: &Fitted, series: &[Series], rate: f64) -> Option<(Line, f64)> {
    let size = fitted.pole.norm();
    let factor = coverage_factor(0.95, fitted.freedom.max(1.0)).ok()?;
    let decays = -fitted.pole.re > 3.0 * fitted.standard;
    // What does not decay is as sure as its stretches are long.
    let pace = if decays { -fitted.pole.re } else { 10.0 * fitted.standard };
    if pace < SURE * fitted.standard || fitted.pole.re > 3.0 * fitted.standard || -fitted.pole.re > 0.5 * size {
        return None;
    }
    let power =
        |n: usize| fitted.amplitudes.iter().filter(|entry| entry.0 == n).map(|entry| entry.2.norm_sqr()).sum::<f64>();
    let powers: Vec<f64> = (0..series.len()).map(power).collect();
    let strongest = (0..series.len()).max_by(|&a, &b| powers[a].total_cmp(&powers[b]))?;
    let others = (0..series.len()).filter(|n| *n != strongest).map(|n| powers[n]).fold(0.0, f64::max);
    let part = (series.len() == 1 || powers[strongest] > DOMINANT * others).then_some(series[strongest].part);
    let amplitude = fitted.amplitudes.iter().map(|entry| entry.2.norm()).fold(0.0, f64::max);
    let line = Line {
        frequency: Estimate::new(size * rate / TAU, fitted.standard * rate / TAU, factor),
        ratio: Some(Estimate::new(-fitted.pole.re / size, fitted.standard / size, factor)),
        decays,
        amplitude,
        part,
        hits: fitted.hits.len(),
        strength: fitted.strength,
        meaning: Meaning::Unknown,
        reason: String::new(),
        half_power: Err("the line does not decay".to_owned()),
    };
    let folding = if decays { -1.0 / (fitted.pole.re * rate) } else { f64::INFINITY };
    Some((line, folding))
}

/// A steady line of a spectrum, as sure as the spectrum is fine.
fn steady_line(peak: &Peak, series: &[Series], spacing: f64) -> Line {
    Line {
        frequency: Estimate::new(peak.frequency, 0.25 * spacing, 2.0),
        ratio: None,
        decays: false,
        amplitude: peak.amplitude,
        part: Some(series[peak.series].part),
        hits: 0,
        strength: peak.strength,
        meaning: Meaning::Unknown,
        reason: String::new(),
        half_power: Err("no ring-down in the record".to_owned()),
    }
}

/// A line, as far as folding goes; `both`: whether both forces were recorded.
pub(super) fn seen(line: &Line, both: bool) -> Observation {
    // What does not decay is no candidate for a mode.
    let weight = if line.decays { line.strength } else { 1e-9 };
    let part = if both { line.part } else { Some(line.part.unwrap_or(Part::Single(Channel::OutputForce))) };
    Observation { frequency: line.frequency.value, standard: line.frequency.standard, weight, part }
}
