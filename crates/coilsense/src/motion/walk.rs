//! The modal coordinates from sample to sample of an equidistant series: each exponential is carried on by one product, and found anew
//! every so often.
//!
//! Next door: the closed solution that is walked along (`closed`), end forces at many times at once (`phasor_sum`).

use num_complex::Complex64;

use super::closed::{Closed, Drive, Segment};
use super::oscillator::exponential;

/// Samples from one exact value to the next: so many products lose as many roundings, 1e-14.
const SAMPLES: usize = 64;

const I: Complex64 = Complex64::new(0.0, 1.0);

/// Numbers of one kind for each exponential of a segment, real and imaginary parts apart.
#[derive(Default)]
struct Phasors {
    real: Vec<f64>,
    imaginary: Vec<f64>,
}

impl Phasors {
    fn clear(&mut self) {
        self.real.clear();
        self.imaginary.clear();
    }

    fn push(&mut self, value: Complex64) {
        self.real.push(value.re);
        self.imaginary.push(value.im);
    }

    /// Each times its factor.
    fn carry(&mut self, factors: &Self) {
        let parts = self.real.iter_mut().zip(&mut self.imaginary);
        for ((real, imaginary), (cos, sin)) in parts.zip(factors.real.iter().zip(&factors.imaginary)) {
            (*real, *imaginary) = (*real * cos - *imaginary * sin, *real * sin + *imaginary * cos);
        }
    }
}

/// Calls `visit` with each sample's number and modal coordinates q_j, shape `count`, of equidistant times in order.
pub(super) fn along(closed: &Closed, times: &[f64], step: f64, mut visit: impl FnMut(usize, &[f64])) {
    let mut coordinates = vec![0.0; closed.oscillators.len()];
    let (mut values, mut factors) = (Phasors::default(), Phasors::default());
    let mut sample = 0;
    while sample < times.len() {
        let segment = closed.segment_at(times[sample]);
        let drives: Vec<&Drive> = closed.drives.iter().filter(|drive| drive.sine.acts_at(times[sample])).collect();
        let modes = begin(segment, times[sample], step, &mut values, &mut factors);
        let mut sines: Vec<Complex64> = drives.iter().map(|drive| phasor(drive, times[sample])).collect();
        let turns: Vec<Complex64> = drives.iter().map(|drive| exponential(I * drive.sine.angular * step)).collect();
        let end = (sample + SAMPLES).min(times.len());
        while sample < end && holds(closed, segment, &drives, times[sample]) {
            coordinates.fill(0.0);
            for (mode, value) in modes.iter().zip(&values.real) {
                coordinates[*mode] += value;
            }
            for (drive, sine) in drives.iter().zip(&sines) {
                drive.add_coordinates(*sine, times[sample], &mut coordinates);
            }
            visit(sample, &coordinates);
            values.carry(&factors);
            sines.iter_mut().zip(&turns).for_each(|(sine, turn)| *sine *= turn);
            sample += 1;
        }
    }
}

/// The exponentials of a segment at a time, and what carries them on by a step; returns the mode of each.
fn begin(segment: &Segment, time: f64, step: f64, values: &mut Phasors, factors: &mut Phasors) -> Vec<usize> {
    values.clear();
    factors.clear();
    let parts = segment.exponentials.iter().filter(|part| part.coefficient != Complex64::default());
    parts
        .map(|part| {
            values.push(part.coefficient * exponential(part.root * (time - segment.from)));
            factors.push(exponential(part.root * step));
            part.mode
        })
        .collect()
}

/// Whether the same free motion and the same sines are in force.
fn holds(closed: &Closed, segment: &Segment, drives: &[&Drive], time: f64) -> bool {
    let acting = closed.drives.iter().filter(|drive| drive.sine.acts_at(time)).count();
    // As many that act, and all of those before: the same ones.
    let same = acting == drives.len() && drives.iter().all(|drive| drive.sine.acts_at(time));
    same && std::ptr::eq(closed.segment_at(time), segment)
}

/// e^(i(ω(t − since) + φ)).
fn phasor(drive: &Drive, time: f64) -> Complex64 {
    exponential(I * (drive.sine.angular * (time - drive.sine.since) + drive.sine.phase))
}
