//! How the spring moves in a run: at rest at position after position, or swinging.
//!
//! Next door: when (`plan`), what instruments make of it (`log`).

use std::f64::consts::{PI, TAU};

use coilsense::excitation::{Harmonic, Sampled};
use coilsense::{EndInput, Error, Excitation, Motion, Start};
use rand::RngExt;
use rand_pcg::Pcg64;

use super::Rig;
use super::plan::{Kind, MOVING, Run, calibration_step};

/// Motion of a run.
#[derive(Debug, Clone)]
pub(super) enum Course {
    /// Slow from position to position, each \[m\] held for `step` \[s\] less the time of moving.
    Resting { positions: Vec<f64>, step: f64 },
    /// The same period again and again \[s\].
    Periodic { motion: Box<Motion>, period: f64 },
    /// Hits at these times \[s\].
    Hit { motion: Box<Motion>, times: Vec<f64> },
}

/// Straight pieces of which a hit, half a sine, is made.
const PIECES: usize = 8;

impl Rig {
    /// The motion of a run whose record begins `lead` \[s\] after t = 0.
    pub(super) fn course(&self, run: &Run, lead: f64, randomness: &mut Pcg64) -> Result<Course, Error> {
        Ok(match run.kind {
            Kind::Preload => Course::Resting { positions: vec![0.0], step: f64::INFINITY },
            Kind::Calibration => {
                let last = (self.settings.calibration_positions - 1) as f64;
                let place = |index: usize| self.settings.calibration_travel * (index as f64 / last - 0.5);
                let positions = (0..self.settings.calibration_positions).map(place).collect();
                Course::Resting { positions, step: calibration_step(&self.settings) }
            }
            Kind::Harmonic => {
                let motion = self.motion(self.distorted_sine(run.frequency, lead, randomness), Start::Steady)?;
                Course::Periodic { motion, period: run.frequency.recip() }
            }
            Kind::Hit => {
                let (input, times) = self.hits(run.duration, lead, randomness)?;
                Course::Hit { motion: self.motion(input, Start::Rest)?, times }
            }
        })
    }

    fn motion(&self, input: EndInput, start: Start) -> Result<Box<Motion>, Error> {
        let excitation = Excitation::new(self.length, input, EndInput::Held, start)?;
        Motion::mounted(&self.spring, &self.mount, &excitation).map(Box::new)
    }

    /// a (sin θ + d sin 2θ), θ = 2πf (t − lead) + φ: the record begins anywhere in the period.
    fn distorted_sine(&self, frequency: f64, lead: f64, randomness: &mut Pcg64) -> EndInput {
        let amplitude = self.settings.amplitude;
        let phase = randomness.random_range(0.0..TAU) - TAU * frequency * lead;
        let mut sines = vec![Harmonic { amplitude, frequency, phase }];
        if self.settings.distortion > 0.0 {
            let (amplitude, frequency) = (self.settings.distortion * amplitude, 2.0 * frequency);
            sines.push(Harmonic { amplitude, frequency, phase: 2.0 * phase });
        }
        EndInput::Harmonics(sines)
    }

    /// Hits spread over a run, none alike, and when each begins.
    fn hits(&self, duration: f64, lead: f64, randomness: &mut Pcg64) -> Result<(EndInput, Vec<f64>), Error> {
        let between = duration / self.settings.hits_per_run as f64;
        let (mut begins, mut times, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for number in 0..self.settings.hits_per_run {
            // In the first third of its share of the run, so that it is heard out.
            let begin = lead + between * (number as f64 + randomness.random_range(0.05..0.3));
            let height = self.settings.hit_height * randomness.random_range(0.7..=1.3);
            let lasting = self.settings.hit_duration * randomness.random_range(0.8..=1.2);
            for piece in 0..=PIECES {
                let share = piece as f64 / PIECES as f64;
                times.push(begin + share * lasting);
                values.push(if piece == PIECES { 0.0 } else { height * (PI * share).sin() });
            }
            begins.push(begin);
        }
        Ok((EndInput::Sampled(Sampled::new(times, values)?), begins))
    }

    /// u1 \[m\] and F_o \[N\] at `times` \[s\], without relaxation.
    pub(super) fn ends(&self, course: &Course, times: &[f64]) -> Result<(Vec<f64>, Vec<f64>), Error> {
        match course {
            Course::Resting { positions, step } => {
                let u1: Vec<f64> = times.iter().map(|&time| resting(positions, *step, time)).collect();
                let force = u1.iter().map(|u1| self.spring.static_force(self.length - u1)).collect();
                Ok((u1, force))
            }
            Course::Periodic { motion, .. } | Course::Hit { motion, .. } => {
                let u1 = motion.ends(times)?.into_iter().map(|[u1, _]| u1).collect();
                Ok((u1, motion.end_forces(times)?.output))
            }
        }
    }
}

/// Where the actuator is: from one position to the next it goes as half a period of a cosine.
///
/// The spring follows without ringing: a move of Δ in time T leaves windings up to (π/ωT)² Δ/2 behind, 0.04 µm or 0.1 mN for 0.9 mm
/// in 1 s with S_T.
pub(super) fn resting(positions: &[f64], step: f64, time: f64) -> f64 {
    let index = ((time / step).max(0.0) as usize).min(positions.len() - 1);
    let (from, to) = (positions[index.saturating_sub(1)], positions[index]);
    let elapsed = if step.is_finite() { time - index as f64 * step } else { time };
    if elapsed >= MOVING { to } else { from + (to - from) * 0.5 * (1.0 - (PI * elapsed.max(0.0) / MOVING).cos()) }
}
