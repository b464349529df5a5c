//! Designs against SciPy's.

use coilsense::mitigation::{KalmanNoise, low_pass, modal_kalman, notch};
use coilsense_rt::{Biquad, Mode};
use num_complex::Complex64;

use super::{paper_springs, sampled_at};

/// Rows of a CSV of `reference/` after its two header lines.
fn rows(name: &str) -> Vec<Vec<String>> {
    let path = format!("{}/tests/golden/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let rows: Vec<Vec<String>> =
        text.lines().skip(2).map(|line| line.split(',').map(str::to_owned).collect()).collect();
    assert!(rows.len() > 20, "{name} holds too little to prove anything");
    rows
}

fn number(row: &[String], column: usize) -> f64 {
    row[column].parse().unwrap()
}

fn response(sections: &[Biquad<f64>], omega: f64) -> Complex64 {
    let z = Complex64::cis(-omega);
    sections.iter().map(|s| (s.b0 + s.b1 * z + s.b2 * z * z) / (1.0 + s.a1 * z + s.a2 * z * z)).product()
}

#[test]
fn low_passes_and_notches_are_scipys() {
    for row in rows("mitigation_filters") {
        let (frequency, rate, at) = (number(&row, 2), number(&row, 3), number(&row, 4));
        let sections = match row[0].as_str() {
            "low-pass" => low_pass(number(&row, 1) as usize, frequency, rate).unwrap(),
            "notch" => vec![notch(frequency, number(&row, 1), rate).unwrap()],
            other => panic!("{other}"),
        };
        let ours = response(&sections, std::f64::consts::TAU * at / rate);
        let theirs = Complex64::new(number(&row, 5), number(&row, 6));
        // Of a peak of 1. Poles 0.013 from z = 1 (order 4 at 10 Hz) let a rounding of either side's coefficients grow by 1/0.013².
        assert!((ours - theirs).norm() < 1e-12, "{row:?}: {ours} against {theirs}");
    }
}

/// The modes and the bias gain of a filter of any number of modes.
fn designed(row: &[String]) -> (Vec<Mode<f64>>, f64) {
    let spring = if row[0] == "S_T" { paper_springs::s_t() } else { paper_springs::s_a() };
    let sampled = sampled_at(&spring, number(row, 2), number(row, 3));
    let noise =
        KalmanNoise { force: number(row, 4), shock: number(row, 5), ringing: number(row, 6), drift: number(row, 7) };
    of_modes(&sampled, &noise, number(row, 1) as usize)
}

fn of_modes(
    sampled: &coilsense::mitigation::SampledSpring,
    noise: &KalmanNoise,
    modes: usize,
) -> (Vec<Mode<f64>>, f64) {
    fn of<const MODES: usize>(
        sampled: &coilsense::mitigation::SampledSpring,
        noise: &KalmanNoise,
    ) -> (Vec<Mode<f64>>, f64) {
        let filter = modal_kalman::<MODES>(sampled, noise).unwrap();
        (filter.modes.to_vec(), filter.bias_gain)
    }
    match modes {
        1 => of::<1>(sampled, noise),
        2 => of::<2>(sampled, noise),
        3 => of::<3>(sampled, noise),
        5 => of::<5>(sampled, noise),
        other => panic!("{other} modes"),
    }
}

#[test]
fn gains_solve_scipys_riccati_equation() {
    let mut largest = 0.0_f64;
    for row in rows("mitigation_kalman") {
        let (modes, bias_gain) = designed(&row);
        let state = number(&row, 8) as usize;
        let ours = modes.get(state / 2).map_or(bias_gain, |mode| mode.gain[state % 2]);
        let error = (ours - number(&row, 9)).abs();
        // SciPy's own residual is below 1e-11 of P, and gains are up to 0.3.
        assert!(error < 1e-9 * ours.abs().max(0.01), "{row:?}: {ours}");
        largest = largest.max(error);
        if let Some(mode) = modes.get(state / 2) {
            // Their eigenvectors are good to some 1e-13.
            assert!((mode.output - number(&row, 10)).abs() < 1e-11, "{row:?}: {}", mode.output);
        }
    }
    assert!(largest > 0.0, "two routes that agree to the last bit are one");
}
