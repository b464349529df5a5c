//! The spectrum against sines of known amplitude, Parseval's theorem and a plain sum.

use std::f64::consts::{PI, TAU};

use coilsense::measures::{Spectrum, alias_of};
use num_complex::Complex64;
use proptest::prelude::*;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

/// `samples` times of a series sampled at `rate`, and a function at them.
fn sampled(rate: f64, samples: u32, function: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let times: Vec<f64> = (0..samples).map(|n| f64::from(n) / rate).collect();
    let values = times.iter().map(|&time| function(time)).collect();
    (times, values)
}

#[test]
fn a_sine_on_a_line_shows_its_amplitude() {
    // Even, odd, prime and highly composite lengths, lines from the third to the last but two.
    for samples in [64, 81, 997, 2500, 4096] {
        for line in [3, 7, samples / 3, samples / 2 - 3] {
            let (rate, phase) = (1000.0, 0.7);
            let frequency = f64::from(line) * rate / f64::from(samples);
            let (times, values) = sampled(rate, samples, |t| 0.3 + 2.5 * (TAU * frequency * t + phase).cos());
            let spectrum = Spectrum::of(&times, &values).unwrap();
            let found = spectrum.amplitudes()[line as usize];
            assert!((found / 2.5 - 1.0).abs() < 1e-12, "{samples} {line} {found}");
            assert!((spectrum.frequencies()[line as usize] / frequency - 1.0).abs() < 1e-12);
            assert!((spectrum.amplitudes()[0] - 0.3).abs() < 1e-12);
            // The taper spreads a sine over three lines, which together hold all of its power.
            let spacing = rate / f64::from(samples);
            let band = spectrum.rms_within(frequency - spacing, frequency + spacing);
            assert!((band / (2.5 / 2.0_f64.sqrt()) - 1.0).abs() < 1e-12, "{samples} {line} {band}");
            let outside = spectrum.rms_within(frequency + 2.0 * spacing, rate / 2.0);
            assert!(outside < 1e-12, "{outside}");
        }
    }
}

#[test]
fn half_way_between_two_lines_a_sine_loses_142_hundredths_of_a_decibel() {
    let (times, values) = sampled(1000.0, 1000, |t| (TAU * 200.5 * t).sin());
    let spectrum = Spectrum::of(&times, &values).unwrap();
    let largest = spectrum.amplitudes().iter().copied().fold(0.0, f64::max);
    // Hann half a line off: 8/(3π); the mirror line at −200.5 adds below 1e-6.
    assert!((largest / (8.0 / (3.0 * PI)) - 1.0).abs() < 1e-5, "{largest}");
    assert!((20.0 * largest.log10() + 1.4236).abs() < 1e-3);
}

#[test]
fn white_noise_keeps_its_rms_in_the_whole_and_in_proportion_in_a_band() {
    let mut generator = Pcg64::seed_from_u64(3);
    let samples = 100_000;
    let values: Vec<f64> = (0..samples)
        .map(|_| {
            let normal: f64 = StandardNormal.sample(&mut generator);
            2.0 + 0.5 * normal
        })
        .collect();
    let times: Vec<f64> = (0..samples).map(|n| f64::from(n) * 1e-4).collect();
    let spectrum = Spectrum::of(&times, &values).unwrap();
    let rms = (values.iter().map(|v| v * v).sum::<f64>() / f64::from(samples)).sqrt();
    // Three standard deviations of a power tapered by Hann: √(2 · 35/18 / 1e5) = 0.6 % of the variance, 0.04 % of this rms.
    assert!((spectrum.rms_within(0.0, 5000.0) / rms - 1.0).abs() < 0.01);
    let moving = spectrum.rms_within(1e-3, 5000.0);
    assert!((moving / 0.5 - 1.0).abs() < 0.01, "{moving}");
    // A fifth of the band holds a fifth of the power, to three standard deviations.
    let fifth = spectrum.rms_within(1000.0, 2000.0).powi(2) / 0.25;
    assert!((fifth / 0.2 - 1.0).abs() < 0.05, "{fifth}");
}

#[test]
fn the_mean_is_in_the_band_from_zero_and_in_no_other() {
    let (times, values) = sampled(100.0, 101, |_| -3.0);
    let spectrum = Spectrum::of(&times, &values).unwrap();
    assert!((spectrum.rms_within(0.0, 10.0) - 3.0).abs() < 1e-14);
    assert!(spectrum.rms_within(0.5, 50.0) < 1e-14);
    assert_eq!(spectrum.rms_within(10.0, 5.0), 0.0);
}

#[test]
fn the_fast_transform_is_the_plain_sum() {
    let samples = 45_u32;
    let (times, values) = sampled(10.0, samples, |t| (3.0 * t).sin() + t * t - 0.2 * t * t * t);
    let mean = values.iter().sum::<f64>() / f64::from(samples);
    let spectrum = Spectrum::of(&times, &values).unwrap();
    let largest = spectrum.amplitudes().iter().copied().fold(0.0, f64::max);
    for line in 1..=samples / 2 {
        let term = |n: u32| {
            let angle = TAU * f64::from(n) / f64::from(samples);
            let taper = 0.5 - 0.5 * angle.cos();
            taper * (values[n as usize] - mean) * Complex64::cis(-angle * f64::from(line))
        };
        let plain = (0..samples).map(term).sum::<Complex64>().norm() * 4.0 / f64::from(samples);
        assert!((spectrum.amplitudes()[line as usize] - plain).abs() < 1e-12 * largest, "{line}");
    }
}

#[test]
fn folding_is_even_periodic_and_leaves_what_is_below_half_the_rate() {
    for (frequency, alias) in
        [(0.0, 0.0), (30.0, 30.0), (50.0, 50.0), (54.0, 46.0), (100.0, 0.0), (130.0, 30.0), (170.0, 30.0)]
    {
        assert!((alias_of(frequency, 100.0) - alias).abs() < 1e-13, "{frequency}");
        assert!((alias_of(-frequency, 100.0) - alias).abs() < 1e-13, "{frequency}");
    }
}

#[test]
fn a_sine_sampled_too_slowly_shows_at_its_alias() {
    for frequency in [54.0, 162.0, 216.0, 1234.0] {
        let (times, values) = sampled(100.0, 200, |t| (TAU * frequency * t + 0.4).sin());
        let spectrum = Spectrum::of(&times, &values).unwrap();
        let line = (alias_of(frequency, 100.0) / 0.5).round() as usize;
        assert!((spectrum.amplitudes()[line] - 1.0).abs() < 1e-10, "{frequency}");
    }
}

#[test]
fn a_series_that_is_not_uniform_is_refused_by_time() {
    let uneven = Spectrum::of(&[0.0, 1.0, 2.5, 3.0], &[0.0; 4]).unwrap_err().to_string();
    assert!(uneven.starts_with("time[2] must be uniform, 2 s here, got 2.5 s"), "{uneven}");
    assert!(Spectrum::of(&[0.0, 0.1], &[0.0; 2]).unwrap_err().to_string().contains("at least 3"));
    assert!(Spectrum::of(&[0.0, 0.1, 0.2], &[0.0; 2]).unwrap_err().to_string().contains("values must hold 3"));
}

proptest! {
    /// Whatever numbers come in, the answer is an error or a spectrum of numbers.
    #[test]
    fn no_input_gives_a_panic_or_a_silent_nan(
        values in prop::collection::vec(prop_oneof![prop::num::f64::ANY, -1e9..1e9], 0..40),
        start in prop_oneof![prop::num::f64::ANY, -10.0..10.0],
        step in prop_oneof![prop::num::f64::ANY, 1e-6..1.0],
        from in prop::num::f64::ANY,
        to in prop::num::f64::ANY,
    ) {
        let times: Vec<f64> = (0..values.len()).map(|n| start + n as f64 * step).collect();
        if let Ok(spectrum) = Spectrum::of(&times, &values) {
            prop_assert!(spectrum.amplitudes().iter().all(|a| a.is_finite()));
            prop_assert!(spectrum.frequencies().iter().all(|f| f.is_finite()));
            prop_assert!(spectrum.rms_within(from, to).is_finite());
        }
    }
}
