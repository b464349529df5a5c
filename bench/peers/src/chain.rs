//! The chain of eqs. (4)–(6) as an integrator wants it, and the judgement of end forces.

use std::f64::consts::TAU;
use std::path::Path;

use crate::jobs::{self, Drive, Motion};

/// How end 1 moves.
enum Input {
    Held,
    Harmonic { amplitude: f64, omega: f64, phase: f64 },
    Sampled { values: Vec<f64>, rate: f64 },
}

impl Input {
    fn at(&self, t: f64) -> f64 {
        match self {
            Self::Held => 0.0,
            Self::Harmonic { amplitude, omega, phase } => amplitude * (omega * t + phase).sin(),
            Self::Sampled { values, rate } => {
                let index = ((t * rate) as usize).min(values.len() - 2);
                let part = t * rate - index as f64;
                values[index] + part * (values[index + 1] - values[index])
            }
        }
    }
}

/// A motion job with its files read.
pub struct MotionJob {
    pub name: String,
    pub windings: usize,
    /// Sample times \[s\].
    pub times: Vec<f64>,
    start: jobs::Start,
    input: Input,
    length: f64,
    /// N k \[N/m\], m/N \[kg\], l0/N \[m\].
    segment_stiffness: f64,
    winding_mass: f64,
    segment_rest: f64,
    reference: [Vec<f64>; 2],
}

impl MotionJob {
    pub fn read(folder: &Path, job: Motion) -> anyhow::Result<Self> {
        let n = job.spring.windings as f64;
        let mut input_force = jobs::doubles(folder, &job.reference, 2 * job.samples)?;
        let output_force = input_force.split_off(job.samples);
        let input = match job.u1 {
            Drive::Held => Input::Held,
            Drive::Harmonic { amplitude, frequency, phase } => {
                Input::Harmonic { amplitude, omega: TAU * frequency, phase }
            }
            Drive::Sampled { file } => {
                Input::Sampled { values: jobs::doubles(folder, &file, job.samples)?, rate: job.rate }
            }
        };
        Ok(Self {
            name: job.job,
            windings: job.spring.windings,
            times: (0..job.samples).map(|index| index as f64 / job.rate).collect(),
            start: job.start,
            input,
            length: job.mean_length,
            segment_stiffness: n * job.spring.stiffness,
            winding_mass: job.spring.mass / n,
            segment_rest: job.spring.rest_length / n,
            reference: [input_force, output_force],
        })
    }

    /// Positions, then velocities, at t = 0.
    pub fn start_state(&self, state: &mut [f64]) {
        let n = self.windings;
        for i in 0..n {
            let along = (i as f64 + 0.5) / n as f64;
            let line = |[first, last]: [f64; 2]| first + along * (last - first);
            state[i] = line(self.start.position);
            state[n + i] = line(self.start.velocity);
        }
    }

    /// d/dt of positions and velocities.
    pub fn rates(&self, t: f64, state: &[f64], rate: &mut [f64]) {
        let [first, last] = self.end_forces(t, &state[..self.windings]);
        self.rates_between(first, last, self.segment_rest, state, rate);
    }

    /// The same for a change of the state alone: Jacobian times vector.
    pub fn jacobian_times(&self, vector: &[f64], result: &mut [f64]) {
        let (n, k) = (self.windings, self.segment_stiffness);
        self.rates_between(2.0 * k * vector[0], -2.0 * k * vector[n - 1], 0.0, vector, result);
    }

    fn rates_between(&self, first: f64, last: f64, rest: f64, state: &[f64], rate: &mut [f64]) {
        let n = self.windings;
        let (x, v) = state.split_at(n);
        let (moved, pushed) = rate.split_at_mut(n);
        moved.copy_from_slice(v);
        let per_mass = 1.0 / self.winding_mass;
        let mut tension = first;
        for (pair, push) in x.windows(2).zip(pushed.iter_mut()) {
            let next = self.segment_stiffness * (pair[1] - pair[0] - rest);
            *push = (next - tension) * per_mass;
            tension = next;
        }
        pushed[n - 1] = (last - tension) * per_mass;
    }

    /// F_i and F_o \[N\] of given positions, eq. (7) less the rest lengths.
    pub fn end_forces(&self, t: f64, x: &[f64]) -> [f64; 2] {
        let (twice, half_rest) = (2.0 * self.segment_stiffness, 0.5 * self.segment_rest);
        [twice * (x[0] - self.input.at(t) - half_rest), twice * (self.length - x[self.windings - 1] - half_rest)]
    }

    /// max |F − F_ref| over max |F_ref − F_x|, the worse of both ends.
    pub fn error(&self, forces: &[Vec<f64>; 2]) -> f64 {
        let n = self.windings as f64;
        let static_force =
            |t: &f64| self.segment_stiffness / n * (self.length - self.input.at(*t) - n * self.segment_rest);
        let of_end = |ours: &Vec<f64>, reference: &Vec<f64>| {
            if ours.len() != reference.len() {
                return f64::INFINITY;
            }
            let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
            for ((ours, reference), t) in ours.iter().zip(reference).zip(&self.times) {
                peak = peak.max((reference - static_force(t)).abs());
                // Not f64::max, which would let a NaN pass.
                let error = (ours - reference).abs();
                worst = if error <= worst { worst } else { error };
            }
            worst / peak
        };
        let [first, last] = [0, 1].map(|end| of_end(&forces[end], &self.reference[end]));
        if first >= last { first } else { last }
    }
}
