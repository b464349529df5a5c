//! How wrong an estimate of ringing can be on any spring of a band, proven rather than sampled.
//!
//! Next door: the filter (`kalman`), the box (`tolerance`).

use coilsense_rt::{Measured, ModalKalman};
use num_complex::Complex64;

use super::sampled_spring::SampledSpring;
use super::tolerance::ToleranceBox;
use crate::error::{Error, check};

/// Largest error of F_o per ringing of F_i \[1\] that a filter makes while a mode rings steadily, on every spring of the box; shape `MODES`.
///
/// max over ω_j(box) of |G(e^(iωT)) − F_o/F_i|, bounded by the largest value on a grid plus half its spacing times Σ n |g_n|,
/// G the response of the filter's F_o to F_i with both ends held, g_n its answer to an impulse
///
/// - `filter`: designed for `spring`; `tolerances`: all of whose frequencies are tried; 0 means no error, 1 as bad as k·Δl
///
/// Source:   |G(ω) − G(ω')| ≤ Σ n |g_n| |ω − ω'| from the triangle inequality.
/// Valid:    ringing that lasts against the filter's memory; modes of the box below half of the sampling rate.
/// Accuracy: above the true maximum by at most 0.01.
///
/// # Errors
/// [`Error::Value`] where a mode of the box lies beyond half of the sampling rate, or the filter forgets too slowly to tell.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::{Damping, mitigation::{KalmanNoise, SampledSpring, ToleranceBox, modal_kalman, ringing_error_bound}};
/// let sampled = SampledSpring::new(&spring, &Damping::Modal(0.005), 2500.0)?;
/// let filter = modal_kalman::<3>(&sampled, &KalmanNoise { force: 0.24, shock: 0.15, ringing: 2.0, drift: 0.5 })?;
/// let narrow = ringing_error_bound(&filter, &sampled, &ToleranceBox::new(0.001, 0.001)?)?;
/// assert!(narrow[0] < 0.1);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn ringing_error_bound<const MODES: usize>(
    filter: &ModalKalman<f64, MODES>,
    spring: &SampledSpring,
    tolerances: &ToleranceBox,
) -> Result<Vec<f64>, Error> {
    let answer = impulse(filter)?;
    let slope: f64 = answer.iter().enumerate().map(|(index, value)| index as f64 * value.abs()).sum();
    let [lowest, highest] = tolerances.frequency_factors();
    let frequencies = spring.modes().frequencies().iter().zip(&filter.modes);
    frequencies
        .enumerate()
        .map(|(index, (omega, mode))| {
            let (from, to) = (lowest * omega / spring.rate(), highest * omega / spring.rate());
            let quantity = format!("highest frequency of mode {} in the box", index + 1);
            let hertz = to * spring.rate() / std::f64::consts::TAU;
            let allowed = format!("below half of the sampling rate of {} Hz", spring.rate());
            check(to < std::f64::consts::PI, quantity, hertz, "Hz", allowed)?;
            let points = ((to - from) * slope / (2.0 * MARGIN)).ceil().max(2.0);
            let allowed = format!("at most {MOST_POINTS:e}: the filter forgets too slowly");
            check(points <= MOST_POINTS, "frequencies to try", points, "", allowed)?;
            let spacing = (to - from) / points;
            // The middle of every stretch: none of it is farther than half a spacing.
            let tried = (0..points as usize).map(|place| from + (place as f64 + 0.5) * spacing);
            let error = tried.map(|omega| (response(&answer, omega) - mode.output / mode.input).norm());
            Ok(error.fold(0.0, f64::max) + 0.5 * spacing * slope)
        })
        .collect()
}

/// How far a bound may lie above the maximum by the grid's spacing.
const MARGIN: f64 = 0.01;
/// Most frequencies that are tried for a mode.
const MOST_POINTS: f64 = 1e5;
/// Longest answer \[samples\].
const LONGEST: usize = 1 << 16;

/// F_o after 1 N in F_i at one sample, both ends held, until it has died away.
fn impulse<const MODES: usize>(filter: &ModalKalman<f64, MODES>) -> Result<Vec<f64>, Error> {
    let ends = [0.0, filter.rest_length];
    let mut state = filter.settled(&Measured { force: 0.0, ends });
    let mut answer = vec![filter.step(&mut state, &Measured { force: 1.0, ends }).output];
    let still = Measured { force: 0.0, ends };
    let mut quiet = 0;
    while quiet < QUIET {
        let told = answer.len() as f64;
        check(answer.len() < LONGEST, "samples until the filter has forgotten", told, "", format!("below {LONGEST}"))?;
        let value = filter.step(&mut state, &still).output;
        quiet = if value.abs() < DEAD { quiet + 1 } else { 0 };
        answer.push(value);
    }
    Ok(answer)
}

/// What counts as died away \[N\], for how many samples in a row.
const DEAD: f64 = 1e-9;
const QUIET: usize = 256;

/// Σ g_n e^(−iωn).
fn response(answer: &[f64], omega: f64) -> Complex64 {
    let turn = Complex64::cis(-omega);
    answer.iter().rev().fold(Complex64::new(0.0, 0.0), |sum, value| sum * turn + value)
}
