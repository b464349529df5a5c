//! The modal coordinates q_j over time: free part per mode, one shared sine per input, and the modes near a drive apart.
//!
//! Next door: one forced oscillator (`forced`); what the coordinates mean in metres and newtons (the parent).

use std::f64::consts::TAU;

use super::forced::ForcedOscillator;
use super::project_line;
use crate::excitation::EndInput;
use crate::modes::{ChainModes, end_sign};

/// Modes closer than this share of their frequency to a drive take the divided difference of [`ForcedOscillator`]; the rest
/// lose at most its inverse, a factor 20, of rounding.
const NEAR: f64 = 0.05;

/// A start relative to the straight line between the ends.
pub(super) enum Relative {
    /// Itself a straight line, by its values at both ends: projected in closed form.
    Line([f64; 2]),
    /// Already projected on the modes, shape `N`.
    Pattern(Vec<f64>),
}

impl Relative {
    fn projected(&self, modes: &ChainModes) -> Vec<f64> {
        match self {
            Self::Line(line) => project_line(modes, *line),
            Self::Pattern(coordinates) => coordinates.clone(),
        }
    }
}

/// All modal coordinates as functions of time.
#[derive(Debug, Clone)]
pub(super) struct Modal {
    frequencies: Vec<f64>,
    /// q_j free = cosine_j cos ω_j t + sine_j sin ω_j t.
    cosines: Vec<f64>,
    sines: Vec<f64>,
    drives: Vec<Drive>,
}

/// One harmonic input: its steady part on the modes far from it, and the modes near it.
#[derive(Debug, Clone)]
struct Drive {
    angular: f64,
    phase: f64,
    /// Amplitude of sin(ωt + φ) in each mode; zero for those near.
    gains: Vec<f64>,
    /// Mode index and modal acceleration amplitude of each mode near the drive.
    near: Vec<(usize, f64)>,
}

impl Modal {
    pub(super) fn new(
        modes: &ChainModes,
        displacement: &Relative,
        velocity: &Relative,
        inputs: [&EndInput; 2],
    ) -> Self {
        let frequencies = modes.frequencies().to_vec();
        let mut cosines = displacement.projected(modes);
        let mut sines = velocity.projected(modes);
        for (rate, frequency) in sines.iter_mut().zip(&frequencies) {
            *rate /= frequency;
        }
        let drives: Vec<Drive> = inputs
            .iter()
            .enumerate()
            .filter_map(|(end, input)| Drive::new(modes, end, input))
            .collect();
        for drive in &drives {
            // The steady part does not start from rest: the free part takes off what it starts with.
            for (mode, gain) in drive.gains.iter().enumerate() {
                cosines[mode] -= gain * drive.phase.sin();
                sines[mode] -= gain * drive.phase.cos() * drive.angular / frequencies[mode];
            }
        }
        Self {
            frequencies,
            cosines,
            sines,
            drives,
        }
    }

    /// q_j at `time` into `values`, shape `N`.
    pub(super) fn coordinates(&self, time: f64, values: &mut [f64]) {
        let free = self.frequencies.iter().zip(&self.cosines).zip(&self.sines);
        for (value, ((frequency, cosine), sine)) in values.iter_mut().zip(free) {
            let (s, c) = (frequency * time).sin_cos();
            *value = cosine * c + sine * s;
        }
        for drive in &self.drives {
            let steady = (drive.angular * time + drive.phase).sin();
            for (value, gain) in values.iter_mut().zip(&drive.gains) {
                *value += gain * steady;
            }
            for &(mode, acceleration) in &drive.near {
                let oscillator = drive.oscillator(self.frequencies[mode]);
                values[mode] += acceleration * oscillator.displacement(time);
            }
        }
    }

    /// q̇_j at `time` into `values`, shape `N`.
    pub(super) fn rates(&self, time: f64, values: &mut [f64]) {
        let free = self.frequencies.iter().zip(&self.cosines).zip(&self.sines);
        for (value, ((frequency, cosine), sine)) in values.iter_mut().zip(free) {
            let (s, c) = (frequency * time).sin_cos();
            *value = frequency * (sine * c - cosine * s);
        }
        for drive in &self.drives {
            let steady = drive.angular * (drive.angular * time + drive.phase).cos();
            for (value, gain) in values.iter_mut().zip(&drive.gains) {
                *value += gain * steady;
            }
            for &(mode, acceleration) in &drive.near {
                let oscillator = drive.oscillator(self.frequencies[mode]);
                values[mode] += acceleration * oscillator.velocity(time);
            }
        }
    }
}

impl Drive {
    /// The drive of a harmonic input at end 0 or 1: q̈_j + ω_j² q_j = c_j σ a ω² sin(ωt + φ), σ = 1 at end 1 and σ_j at end 2.
    fn new(modes: &ChainModes, end: usize, input: &EndInput) -> Option<Self> {
        let EndInput::Harmonic {
            amplitude,
            frequency,
            phase,
        } = *input
        else {
            return None;
        };
        let angular = TAU * frequency;
        let mut drive = Self {
            angular,
            phase,
            gains: vec![0.0; modes.count()],
            near: Vec::new(),
        };
        let each = modes.frequencies().iter().zip(modes.participations());
        for (index, (natural, participation)) in each.enumerate() {
            let sign = if end == 0 { 1.0 } else { end_sign(index + 1) };
            let acceleration = participation * sign * amplitude * angular * angular;
            if (natural - angular).abs() < NEAR * natural {
                drive.near.push((index, acceleration));
            } else {
                drive.gains[index] = acceleration / ((natural - angular) * (natural + angular));
            }
        }
        Some(drive)
    }

    fn oscillator(&self, natural: f64) -> ForcedOscillator {
        ForcedOscillator {
            natural,
            drive: self.angular,
            phase: self.phase,
        }
    }
}

/// φ_j(i) as a matrix, one row per mode: shape `N × N`, row-major.
pub(super) fn shape_rows(modes: &ChainModes) -> Vec<f64> {
    let count = modes.count();
    (1..=count)
        .flat_map(|mode| (1..=count).map(move |winding| modes.shape_at(mode, winding)))
        .collect()
}
