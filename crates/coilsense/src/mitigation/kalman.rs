//! Settings of the modal Kalman filter.
//!
//! Next door: the Riccati equation (`riccati`), a bank of filters (`bank`), the steps (`coilsense-rt`).

use coilsense_rt::{ModalKalman, Mode};
use nalgebra::{DMatrix, DVector};

use super::riccati::steady_covariance;
use super::sampled_spring::SampledSpring;
use crate::error::{Error, above_zero, called, check, not_negative};

/// What the filter is to expect, in forces at end 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KalmanNoise {
    /// White noise of F_i \[N rms per sample\], above zero.
    pub force: f64,
    /// How fast all windings together are knocked about against the ends \[m/s per √s\], zero or above: impacts, all modes at once.
    pub shock: f64,
    /// What else adds to every mode \[N per √s\], above zero: higher forgets faster and lets more noise through.
    pub ringing: f64,
    /// How fast the bias wanders \[N per √s\], above zero.
    pub drift: f64,
}

impl KalmanNoise {
    fn checked(&self) -> Result<(), Error> {
        above_zero(called("force", "noise of the force"), self.force, "N")?;
        not_negative(called("shock", "noise of the shocks"), self.shock, "m/s/sqrt(s)")?;
        above_zero(called("ringing", "noise of the ringing"), self.ringing, "N/sqrt(s)")?;
        above_zero(called("drift", "drift of the bias"), self.drift, "N/sqrt(s)")?;
        Ok(())
    }
}

/// Steady-state Kalman filter of the first `MODES` modes and a force bias; modal coordinates are their forces at end 1 \[N\].
///
/// Φ_j = e^(−ζωT) [[c + rs, s/√(1−ζ²)], [−s/√(1−ζ²), c − rs]], c, s = cos, sin(ω√(1−ζ²) T), r = ζ/√(1−ζ²);
/// Q = σ_s² T Φ b bᵀ Φᵀ + σ_r² T on every modal state, b what a velocity of all windings does to them, σ_d² T on the bias; K = P hᵀ/(h P hᵀ + r), P the steady covariance of the prediction
///
/// Source:   `[Simon2006]` section 7.3; modes of [`crate::modes::ChainModes`], ends moving straight between samples.
/// Valid:    ω_j below half of the sampling rate; ζ_j below 1. Without the bias a stiffness off by 10 % is taken for ringing.
/// Accuracy: K 1e-9 relative, against SciPy (`reference/mitigation.py`); with all modes, no noise and K = 0 the exact motion.
///
/// # Errors
/// [`Error::Value`] for a number of modes that are not there or not below half of the sampling rate, and for noise that is not above zero.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::{Damping, mitigation::{KalmanNoise, SampledSpring, modal_kalman}};
/// let sampled = SampledSpring::new(&spring, &Damping::Modal(0.005), 2500.0)?;
/// let noise = KalmanNoise { force: 0.24, shock: 0.1, ringing: 2.0, drift: 0.5 };
/// let filter = modal_kalman::<3>(&sampled, &noise)?;
/// assert!((filter.modes[0].output + 1.0).abs() < 1e-12); // an odd mode pulls at both ends in turn
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn modal_kalman<const MODES: usize>(
    spring: &SampledSpring,
    noise: &KalmanNoise,
) -> Result<ModalKalman<f64, MODES>, Error> {
    noise.checked()?;
    let frequencies = spring.modes().frequencies();
    let below = frequencies.iter().filter(|omega| **omega < std::f64::consts::PI * spring.rate()).count();
    let allowed = format!("from 1 to {below}, the modes below half of the sampling rate");
    check((1..=below).contains(&MODES), "number of modes", MODES as f64, "", allowed)?;
    let mut modes: [Mode<f64>; MODES] = std::array::from_fn(|index| mode(spring, index));
    let (transition, measured, process) = model(&modes, spring.rate(), noise);
    let variance = noise.force * noise.force;
    let covariance = steady_covariance(&transition, &measured, &process, variance)?;
    let seen = &covariance * &measured;
    let gains = &seen / (measured.dot(&seen) + variance);
    for (index, mode) in modes.iter_mut().enumerate() {
        mode.gain = [gains[2 * index], gains[2 * index + 1]];
    }
    Ok(ModalKalman {
        stiffness: spring.spring().stiffness(),
        rest_length: spring.spring().rest_length(),
        rate: spring.rate(),
        bias_gain: gains[2 * MODES],
        modes,
    })
}

/// Mode `index` (from zero) over one sample, its gain left at zero.
fn mode(spring: &SampledSpring, index: usize) -> Mode<f64> {
    let modes = spring.modes();
    let (omega, ratio) = (modes.frequencies()[index], spring.ratios()[index]);
    let swing = (1.0 - ratio * ratio).sqrt();
    let (sine, cosine) = (omega * swing / spring.rate()).sin_cos();
    let decay = (-ratio * omega / spring.rate()).exp();
    let (across, along) = (decay * sine / swing, decay * ratio / swing * sine);
    let input = modes.input_weights()[index];
    let force = 2.0 * modes.masses() as f64 * spring.spring().stiffness() * input;
    let [first, second] = modes.participations();
    Mode {
        turn: [[decay * cosine + along, across], [-across, decay * cosine - along]],
        kick: [-force * first[index] / omega, -force * second[index] / omega],
        input: 1.0,
        output: modes.output_weights()[index] / input,
        gain: [0.0; 2],
    }
}

/// Φ, h and Q of modes and bias, the bias last.
fn model(modes: &[Mode<f64>], rate: f64, noise: &KalmanNoise) -> (DMatrix<f64>, DVector<f64>, DMatrix<f64>) {
    let size = 2 * modes.len() + 1;
    let mut transition = DMatrix::identity(size, size);
    let mut measured = DVector::zeros(size);
    let mut process = DMatrix::identity(size, size) * (noise.ringing * noise.ringing / rate);
    for (index, mode) in modes.iter().enumerate() {
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            transition[(2 * index + row, 2 * index + column)] = mode.turn[row][column];
        }
        measured[2 * index] = mode.input;
    }
    measured[size - 1] = 1.0;
    // A uniform velocity against the ends is a jump of both ends the other way.
    let mut shock = DVector::zeros(size);
    for (index, mode) in modes.iter().enumerate() {
        shock[2 * index + 1] = mode.kick[0] + mode.kick[1];
    }
    let shock = &transition * shock;
    process += &shock * shock.transpose() * (noise.shock * noise.shock / rate);
    process[(size - 1, size - 1)] = noise.drift * noise.drift / rate;
    (transition, measured, process)
}
