//! Lines made exact: each fitted over all hits together, beside the lines near it, over as long as it rings.
//!
//! Next door: the lines to start from (`lines`), the fit (`pole_fit`), what lines mean (`mode_series`).

use std::collections::HashMap;
use std::sync::Arc;

use num_complex::Complex;
use realfft::{RealFftPlanner, RealToComplex};

use super::fitted::{Fitted, without_doubles};
use super::hits::Hit;
use super::lines::Peak;
use super::median::median;
use super::pole_fit::{Block, Fit, amplitudes, fit};
use super::residuals::{left_over, near_excess};
use super::ringing::Series;
use super::sampling::Sampling;

/// How many e-foldings a stretch lasts, where the next hit leaves room.
const FOLDS: f64 = 8.0;
/// Lines of the transform on either side of the line that is fitted.
const HALF_BAND: f64 = 30.0;
/// Shortest stretch \[samples\].
const LEAST: usize = 24;
/// Most lines that a look at what is left may add to a fit.
const MOST_ADDED: usize = 3;
/// Values of transforms that are kept, at most: 64 MB.
const MOST_KEPT: usize = 4_000_000;
/// Modes that are looked for where no peak is.
const GUESSED: usize = 6;
/// A hit whose ringing fits this much worse than the others' is left out (something else happened in it).
const WORSE: f64 = 4.0;

/// A stretch of a series whose transform, over noise and √N, is kept: series, first sample, length.
type Stretch = (usize, usize, usize);

/// Fits lines to a record.
pub(super) struct Refiner<'a> {
    series: &'a [Series<'a>],
    hits: &'a [Hit],
    rate: f64,
    samples: usize,
    planner: RealFftPlanner<f64>,
    plans: HashMap<usize, Arc<dyn RealToComplex<f64>>>,
    transforms: HashMap<Stretch, Arc<Vec<Complex<f64>>>>,
    kept: usize,
}

impl<'a> Refiner<'a> {
    pub(super) fn new(series: &'a [Series<'a>], hits: &'a [Hit], sampling: &Sampling) -> Self {
        let planner = RealFftPlanner::new();
        Self {
            series,
            hits,
            rate: sampling.rate,
            samples: sampling.samples,
            planner,
            plans: HashMap::new(),
            transforms: HashMap::new(),
            kept: 0,
        }
    }

    /// The lines behind `peaks`, strongest first.
    pub(super) fn lines(&mut self, peaks: &[Peak]) -> Vec<Fitted> {
        let lines = self.merged(peaks);
        self.together(lines)
    }

    /// The lines to which `lines` are fitted, each beside the others, strongest first.
    pub(super) fn together(&mut self, mut lines: Vec<Fitted>) -> Vec<Fitted> {
        for round in 0..3 {
            for index in 0..lines.len() {
                if let Some(better) = self.refit(&lines, index, round > 0) {
                    lines[index] = better;
                }
            }
            lines = without_doubles(lines);
            if round < 2 {
                self.look_for_modes(&mut lines);
            }
        }
        lines.retain(|line| line.standard.is_finite());
        for index in 0..lines.len() {
            lines[index].elsewhere = self.elsewhere(&lines, index);
        }
        lines
    }

    /// A line's amplitudes in the series in which it was not fitted, its pole as it was found.
    fn elsewhere(&mut self, lines: &[Fitted], index: usize) -> Vec<(usize, usize, Complex<f64>)> {
        let line = &lines[index];
        let mut found = Vec::new();
        for series in (0..self.series.len()).filter(|series| !line.series.contains(series)) {
            let mut stretches = self.stretches(line.pole);
            stretches.retain(|(hit, _)| line.hits.contains(hit));
            let Some(band) = band_about(line.pole, &stretches) else { continue };
            let mut near: Vec<&Fitted> = lines
                .iter()
                .enumerate()
                .filter(|(other, of)| *other != index && of.pole.im > band.0 && of.pole.im < band.1)
                .map(|(_, of)| of)
                .collect();
            near.sort_by(|a, b| b.strength.total_cmp(&a.strength));
            let mut poles = vec![line.pole];
            poles.extend(near.iter().take(5).map(|of| of.pole));
            let fixed: Vec<Complex<f64>> = if half_band(&stretches).is_some_and(|half| line.pole.im < 1.5 * half) {
                vec![line.pole.conj()]
            } else {
                Vec::new()
            };
            let blocks = self.blocks(&[series], &stretches, band);
            let Some(amplitudes) =
                amplitudes(&blocks, &poles, &fixed).or_else(|| amplitudes(&blocks, &poles[..1], &fixed))
            else {
                continue;
            };
            for (block, amplitudes) in blocks.iter().zip(&amplitudes) {
                let scale = 2.0 * self.series[block.series].noise * (block.length as f64).sqrt();
                found.push((block.series, block.hit, amplitudes[0] * scale));
            }
        }
        found
    }

    /// Adds modes that no spectrum shows apart, broad ones on the flank of the strongest line: where the strongest line's series has them,
    /// if the fit then finds one.
    fn look_for_modes(&mut self, lines: &mut Vec<Fitted>) {
        let strongest =
            lines.iter().filter(|line| line.standard.is_finite()).max_by(|a, b| a.strength.total_cmp(&b.strength));
        let Some(base) = strongest.cloned() else { return };
        let ends = self.series.len() > 1;
        let number = |series: &[usize]| if ends && series == [1] { 2 } else { 1 };
        let first = base.pole / number(&base.series) as f64;
        for mode in 1..=GUESSED {
            let guess = first * mode as f64;
            // What is there but not sure may be a fit that went astray.
            let near = |line: &Fitted| {
                (line.pole.im - guess.im).abs() < 0.04 * guess.im && -line.pole.re > 6.0 * line.standard
            };
            let slow = -guess.re > 4.0 * base.standard && guess.im < 0.9 * std::f64::consts::PI;
            if !slow || lines.iter().any(near) {
                continue;
            }
            let series = if ends { vec![(mode + 1) % 2] } else { vec![0] };
            lines.push(Fitted { series, pole: guess, standard: f64::INFINITY, amplitudes: Vec::new(), ..base.clone() });
            let found = self.refit(lines, lines.len() - 1, false);
            lines.pop();
            if let Some(found) = found.filter(|found| found.is_mode(guess)) {
                lines.push(Fitted { strength: (found.pole.re / found.standard).powi(2), ..found });
            }
        }
    }

    /// Peaks of all series as lines: those at one frequency are one.
    fn merged(&self, peaks: &[Peak]) -> Vec<Fitted> {
        let mut sorted = peaks.to_vec();
        sorted.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        let mut lines: Vec<Fitted> = Vec::new();
        for peak in sorted {
            let angle = std::f64::consts::TAU * peak.frequency / self.rate;
            let pole = Complex::new(-1.0 / (peak.folding * self.rate), angle);
            let near = |line: &&mut Fitted| (line.pole.im - angle).abs() < 1.5 * (line.pole.re.abs() + pole.re.abs());
            match lines.iter_mut().find(near) {
                Some(line) => {
                    if !line.series.contains(&peak.series) {
                        line.series.push(peak.series);
                    }
                }
                None => lines.push(Fitted {
                    series: vec![peak.series],
                    pole,
                    standard: f64::INFINITY,
                    freedom: 1.0,
                    hits: Vec::new(),
                    amplitudes: Vec::new(),
                    elsewhere: Vec::new(),
                    strength: peak.strength,
                }),
            }
        }
        lines
    }

    /// One line fitted again, given where the others are.
    fn refit(&mut self, lines: &[Fitted], index: usize, look: bool) -> Option<Fitted> {
        let line = &lines[index];
        let stretches = self.stretches(line.pole);
        let half = half_band(&stretches)?;
        let centre = line.pole.im;
        let band = band_about(line.pole, &stretches)?;
        let others = lines
            .iter()
            .enumerate()
            .filter(|(other, of)| *other != index && of.series.iter().any(|series| line.series.contains(series)));
        let (mut free, mut fixed) = (vec![line.pole], Vec::new());
        for (_, other) in others {
            let distance = (other.pole.im - centre).abs();
            // A line that has decayed within a few samples of the stretch leaves no trace that could be fitted.
            if other.pole.im > band.0 && other.pole.im < band.1 && free.len() < 6 {
                free.push(other.pole);
            } else if distance < 2.5 * half && fixed.len() < 4 {
                fixed.push(other.pole);
            }
        }
        if centre < 1.5 * half {
            fixed.push(line.pole.conj());
        }
        let mut blocks = self.blocks(&line.series, &stretches, band);
        let mut found = fit(&blocks, &free, &fixed).or_else(|| {
            free.truncate(1);
            fit(&blocks, &free, &fixed)
        })?;
        if look {
            (blocks, found) = self.without_bad_hits(blocks, found, &fixed);
            for _ in 0..MOST_ADDED {
                let Some(pole) = left_over(&blocks, &found, band) else { break };
                let mut more = found.poles.clone();
                more.push(pole);
                match fit(&blocks, &more, &fixed) {
                    Some(better) if better.excess < found.excess => found = better,
                    _ => break,
                }
            }
        }
        Some(self.fitted(line, &blocks, &found))
    }

    /// Where each hit's stretch begins and how long it is: as long as the line rings, or until the next hit.
    fn stretches(&self, pole: Complex<f64>) -> Vec<(usize, usize)> {
        let wanted = (FOLDS / pole.re.abs().max(1e-9)) as usize;
        let stretch = |index: usize| {
            let end = self.hits.get(index + 1).map_or(self.samples, |hit| hit.onset);
            let room = end.saturating_sub(self.hits[index].after);
            (index, quick_length(room.min(wanted.max(LEAST))))
        };
        let all: Vec<(usize, usize)> =
            (0..self.hits.len()).map(stretch).filter(|(_, length)| *length >= LEAST).collect();
        let longest = all.iter().map(|(_, length)| *length).max().unwrap_or(0);
        // A stretch far shorter than the others has no lines of its own in their band.
        all.into_iter().filter(|(_, length)| 8 * length >= longest).collect()
    }

    fn blocks(&mut self, series: &[usize], stretches: &[(usize, usize)], band: (f64, f64)) -> Vec<Block> {
        let mut blocks = Vec::new();
        for &(hit, length) in stretches {
            let turn = std::f64::consts::TAU / length as f64;
            let first = ((band.0 / turn).ceil() as usize).max(2);
            let last = ((band.1 / turn).floor() as usize).min(length / 2 - 1);
            if last < first + 8 {
                continue;
            }
            for &index in series {
                let Some(transform) = self.transform(index, self.hits[hit].after, length) else { continue };
                let angles: Vec<f64> = (first..=last).map(|line| turn * line as f64).collect();
                let turns = angles.iter().map(|angle| Complex::cis(-angle)).collect();
                let values = transform[first..=last].to_vec();
                blocks.push(Block { series: index, hit, angles, turns, values, length });
            }
        }
        blocks
    }

    /// A stretch's transform, which lines near one another share.
    fn transform(&mut self, series: usize, start: usize, length: usize) -> Option<Arc<Vec<Complex<f64>>>> {
        let key = (series, start, length);
        if let Some(known) = self.transforms.get(&key) {
            return Some(known.clone());
        }
        let planner = &mut self.planner;
        let plan = self.plans.entry(length).or_insert_with(|| planner.plan_fft_forward(length)).clone();
        let mut input = self.series[series].force(start..start + length);
        let mut output = plan.make_output_vec();
        plan.process(&mut input, &mut output).ok()?;
        let scale = 1.0 / (self.series[series].noise * (length as f64).sqrt()).max(f64::MIN_POSITIVE);
        output.iter_mut().for_each(|value| *value *= scale);
        if self.kept > MOST_KEPT {
            self.transforms.clear();
            self.kept = 0;
        }
        self.kept += output.len();
        let output = Arc::new(output);
        self.transforms.insert(key, output.clone());
        Some(output)
    }

    /// Leaves out hits in whose stretch something else happened.
    fn without_bad_hits(&self, blocks: Vec<Block>, found: Fit, fixed: &[Complex<f64>]) -> (Vec<Block>, Fit) {
        let square = |residual: &Vec<Complex<f64>>| {
            residual.iter().map(Complex::norm_sqr).sum::<f64>() / residual.len().max(1) as f64
        };
        let squares: Vec<f64> = found.residuals.iter().map(square).collect();
        let usual = median(&mut squares.clone());
        let bad: Vec<usize> =
            blocks.iter().zip(&squares).filter(|(_, s)| **s > WORSE * usual).map(|(block, _)| block.hit).collect();
        let kept: Vec<Block> = blocks.iter().filter(|block| !bad.contains(&block.hit)).cloned().collect();
        if bad.is_empty() || kept.is_empty() {
            return (blocks, found);
        }
        match fit(&kept, &found.poles, fixed) {
            Some(better) => (kept, better),
            None => (blocks, found),
        }
    }

    fn fitted(&self, line: &Fitted, blocks: &[Block], found: &Fit) -> Fitted {
        let amplitudes = blocks.iter().zip(&found.amplitudes).map(|(block, amplitudes)| {
            let scale = 2.0 * self.series[block.series].noise * (block.length as f64).sqrt();
            (block.series, block.hit, amplitudes[0] * scale)
        });
        let mut hits: Vec<usize> = blocks.iter().map(|block| block.hit).collect();
        hits.dedup();
        Fitted {
            series: line.series.clone(),
            pole: found.poles[0],
            standard: found.standard[0] * near_excess(blocks, found).sqrt(),
            freedom: 2.0 * found.freedom as f64,
            hits,
            amplitudes: amplitudes.collect(),
            elsewhere: Vec::new(),
            strength: line.strength,
        }
    }
}

/// Half the width of the band in which a line is fitted \[rad per sample\].
fn half_band(stretches: &[(usize, usize)]) -> Option<f64> {
    let mut lengths: Vec<usize> = stretches.iter().map(|(_, length)| *length).collect();
    lengths.sort_unstable();
    Some(std::f64::consts::TAU * HALF_BAND / *lengths.get(lengths.len() / 2)? as f64)
}

fn band_about(pole: Complex<f64>, stretches: &[(usize, usize)]) -> Option<(f64, f64)> {
    let half = half_band(stretches)?;
    Some(((pole.im - half).max(0.0), (pole.im + half).min(0.98 * std::f64::consts::PI)))
}

/// The largest length up to `room` that a fast transform likes: 2^k times 1, 1.25 or 1.5.
fn quick_length(room: usize) -> usize {
    let mut power = 1;
    while 2 * power <= room {
        power *= 2;
    }
    let fits = |length: usize| length <= room && length.is_multiple_of(2);
    [power + power / 2, power + power / 4, power].into_iter().find(|length| fits(*length)).unwrap_or(power)
}
