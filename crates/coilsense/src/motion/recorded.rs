//! End forces under recordings: where their samples and the times asked for lie on one grid, every jump of a recording's rate is a kick at a
//! point of it, and all are processed together.
//!
//! Next door: the kicks' sum (`kicked_blocks`), what else drives the motion (`closed`, `forces`), recordings off the grid (`march`).

use num_complex::Complex64;

use super::closed::Closed;
use super::forces::{EndForces, is_equidistant};
use super::kicked_blocks::{self, Answer, Kicks};
use super::oscillator::{Oscillator, Roots};
use super::phasor_sum::Target;
use super::{Motion, step_of};
use crate::excitation::{EndInput, Sampled};
use crate::modes::end_sign;

/// How far samples may be from the grid, in roundings of the last time: as much as equidistant times may be from being so.
const ROUNDINGS: f64 = 4.0;

/// Points of the grid for each sample and each time asked for: beyond, most points are empty, and going from sample to sample is quicker.
const MOST_POINTS: usize = 4;

impl Motion {
    /// Both forces at equidistant times, or `None` where that is to be found from time to time: no recording on one grid with the times
    /// (uneven samples, samples between the grid's points, fewer than are worth it, a begin before t = 0), or another input, or a mode,
    /// that has no closed solution.
    pub(super) fn under_recordings(&self, times: &[f64]) -> Option<EndForces> {
        if !is_equidistant(times) {
            return None;
        }
        let inputs = self.inputs();
        let recordings = inputs.map(|input| OnGrid::of(input, times));
        if recordings.iter().all(Option::is_none) {
            return None;
        }
        // Superposition: the start and the other inputs have their own solution, and each recording begins from rest.
        let others = [0, 1].map(|end| if recordings[end].is_some() { &EndInput::Held } else { inputs[end] });
        let closed = Closed::new(&self.modes, &self.ratios, self.start.clone(), others)?;
        let mut forces = self.together(&closed, others, times);
        for (end, recording) in recordings.into_iter().enumerate() {
            if let Some(recording) = recording {
                let per = self.static_force_per(end);
                recording.add_displacements(inputs[end], times, [&mut forces.input, &mut forces.output], per);
                self.add_kicks(&closed.oscillators, end, &recording, &mut forces);
            }
        }
        Some(forces)
    }

    /// Adds what an input's kicks give both ends beyond a spring without mass; parities as for equidistant times without a recording.
    fn add_kicks(&self, oscillators: &[Oscillator], end: usize, recording: &OnGrid<'_>, forces: &mut EndForces) {
        let skipped = recording.skipped.min(forces.input.len());
        let kicks = recording.kicks();
        let [input, output] = [&mut forces.input[skipped..], &mut forces.output[skipped..]];
        let [weights, output_weights] = self.modes.weights();
        if !self.modes.is_mirrored() {
            for (weights, values) in [(weights, input), (output_weights, output)] {
                let answers = self.answers(oscillators, end, |mode| weights[mode]);
                kicked_blocks::add(&answers, &kicks, &mut [Target { values, sign: 1.0 }]);
            }
            return;
        }
        for parity in [1.0, -1.0] {
            let weight = |mode: usize| if end_sign(mode + 1) == parity { weights[mode] } else { 0.0 };
            let answers = self.answers(oscillators, end, weight);
            let targets = [Target { values: &mut *input, sign: 1.0 }, Target { values: &mut *output, sign: -parity }];
            kicked_blocks::add(&answers, &kicks, &mut { targets });
        }
    }

    /// What a unit kick of an input gives: `2Nk Σ_j w_j (q_j + β q̇_j)` of modes that set out from zero at −c_j.
    fn answers(&self, oscillators: &[Oscillator], end: usize, weight: impl Fn(usize) -> f64) -> Vec<Answer> {
        let (scale, dashpot) = (self.force_scale(), self.mount.damping().dashpot_time());
        let mut answers = Vec::with_capacity(oscillators.len());
        let each = self.modes.participations()[end].iter().zip(oscillators).enumerate();
        for (mode, (participation, oscillator)) in each.filter(|(mode, _)| weight(*mode) != 0.0) {
            let of_root = |root: Complex64, unit: Complex64| {
                let coefficient = scale * weight(mode) * participation * unit * (1.0 + dashpot * root);
                Answer { root, coefficient }
            };
            match oscillator.roots() {
                Roots::Pair(root) => answers.push(of_root(root, Complex64::new(0.0, 1.0 / root.im))),
                Roots::Real(slow, fast) => {
                    let unit = Complex64::from(1.0 / (slow - fast));
                    answers.extend([of_root(slow.into(), -unit), of_root(fast.into(), unit)]);
                }
            }
        }
        answers.retain(|answer| answer.coefficient != Complex64::default());
        answers
    }
}

/// A recording that has one grid with the times asked for. The grid begins at its first sample.
struct OnGrid<'a> {
    recording: &'a Sampled,
    /// Between points of the grid \[s\].
    step: f64,
    /// Points from sample to sample, and from time to time; one of them is 1.
    per_sample: usize,
    per_time: usize,
    /// Times before the first sample.
    skipped: usize,
    /// The point at which the first of the other times lies.
    first: usize,
    /// Points up to the last time.
    points: usize,
}

impl<'a> OnGrid<'a> {
    /// - `times`: equidistant
    fn of(input: &'a EndInput, times: &[f64]) -> Option<Self> {
        let EndInput::Sampled(recording) = input else {
            return None;
        };
        let samples = recording.times();
        if !is_equidistant(samples) {
            return None;
        }
        let ratio = step_of(times) / step_of(samples);
        let [per_sample, per_time] = if ratio >= 0.75 { [1.0, ratio.round()] } else { [(1.0 / ratio).round(), 1.0] };
        let ([begin, end], [first, last]) = (bounds(samples), bounds(times));
        // From the longer of the two, whose roundings are the smaller share.
        let step = if end - begin >= last - first { step_of(samples) / per_sample } else { step_of(times) / per_time };
        let offset = ((first - begin) / step).round();
        let until = offset + (times.len() - 1) as f64 * per_time;
        // All three are straight lines: where they agree at both ends, they agree between.
        let on =
            |time: f64, point: f64| (time - begin - point * step).abs() <= ROUNDINGS * f64::EPSILON * end.max(last);
        let whole = (samples.len() - 1) as f64 * per_sample;
        if !(on(first, offset) && on(last, until) && on(end, whole)) || until >= most_points(samples, times) {
            return None;
        }
        let skipped = (-offset / per_time).ceil().max(0.0);
        Some(Self {
            recording,
            step,
            per_sample: per_sample as usize,
            per_time: per_time as usize,
            skipped: skipped as usize,
            first: (offset + skipped * per_time) as usize,
            points: (until + 1.0).max(0.0) as usize,
        })
    }

    /// The jump of the rate at each point, shape `points`. What happens at t = 0 belongs to the start.
    ///
    /// Differences of values over one step: those of times would have the rounding of times in them.
    fn kicks(&self) -> Kicks {
        let values = self.recording.values();
        let rate = 1.0 / (self.per_sample as f64 * self.step);
        let mut velocities = vec![0.0; self.points];
        let places = velocities.iter_mut().step_by(self.per_sample);
        let before = std::iter::once(&values[0]).chain(values);
        let after = values[1..].iter().chain(values.last());
        for (place, ((before, value), after)) in places.zip(before.zip(values).zip(after)) {
            *place = ((after - value) - (value - before)) * rate;
        }
        if let Some(first) = velocities.first_mut().filter(|_| self.recording.times()[0] <= 0.0) {
            *first = 0.0;
        }
        Kicks::new(self.step, &velocities, self.first, self.per_time)
    }

    /// Adds `per` times the displacements to each of the targets.
    fn add_displacements(&self, input: &EndInput, times: &[f64], targets: [&mut [f64]; 2], per: f64) {
        if per == 0.0 {
            return;
        }
        let values = self.recording.values();
        let is_time_by_time = self.per_sample == 1 && self.per_time == 1;
        let between = if is_time_by_time { Vec::new() } else { input.displacements(times) };
        let (held, moving) = if is_time_by_time {
            (self.skipped.min(times.len()), &values[self.first.min(values.len() - 1)..])
        } else {
            (0, &*between)
        };
        for target in targets {
            let (before, after) = target.split_at_mut(held);
            let (during, after) = after.split_at_mut(moving.len().min(after.len()));
            before.iter_mut().for_each(|force| *force += per * values[0]);
            during.iter_mut().zip(moving).for_each(|(force, value)| *force += per * value);
            after.iter_mut().for_each(|force| *force += per * values[values.len() - 1]);
        }
    }
}

/// First and last.
fn bounds(times: &[f64]) -> [f64; 2] {
    [times[0], times[times.len() - 1]]
}

/// Points of a grid beyond which it is not worth it.
fn most_points(samples: &[f64], times: &[f64]) -> f64 {
    (MOST_POINTS * (samples.len() + times.len())) as f64
}
