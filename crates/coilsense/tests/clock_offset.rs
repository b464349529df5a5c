//! Two clocks that saw the same motion: the offset between them, and how far to trust it.

use std::f64::consts::TAU;

use coilsense::measures::ClockOffset;
use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;

const INTERVAL: f64 = 1.0 / 500.0;
const SAMPLES: usize = 8000;

/// A motion over time.
type Motion = Box<dyn Fn(f64) -> f64>;

/// Thirteen sines at once.
fn shaking(random: &mut Pcg64, from: f64, to: f64) -> Motion {
    let sines: Vec<(f64, f64)> =
        (0..13).map(|_| (random.random_range(from..to), random.random_range(0.0..TAU))).collect();
    Box::new(move |time| sines.iter().map(|(frequency, phase)| (TAU * frequency * time + phase).sin()).sum())
}

/// Five hits that ring down.
fn hits(random: &mut Pcg64) -> Motion {
    let frequency = random.random_range(20.0..50.0);
    let at: Vec<f64> = (0..5).map(|_| random.random_range(1.0..15.0)).collect();
    Box::new(move |time| {
        let since = at.iter().map(|at| time - at).filter(|since| *since >= 0.0);
        since.map(|since| (-0.01 * TAU * frequency * since).exp() * (TAU * frequency * since).sin()).sum()
    })
}

/// What a device records whose clock is ahead by `ahead`, with noise, gain and sign of its own.
fn record(motion: &Motion, ahead: f64, gain: f64, noise: f64, random: &mut Pcg64) -> Vec<f64> {
    let sample = |n: usize| {
        let chance: f64 = StandardNormal.sample(random);
        gain * (motion(n as f64 * INTERVAL - ahead) + noise * chance)
    };
    (0..SAMPLES).map(sample).collect()
}

/// Share of 60 seeds in which the interval holds the truth, and the largest error \[samples\].
fn coverage(make: impl Fn(&mut Pcg64) -> Motion, noise: f64) -> (f64, f64) {
    const SEEDS: u64 = 60;
    let (mut held, mut worst) = (0, 0.0_f64);
    for seed in 0..SEEDS {
        let random = &mut Pcg64::seed_from_u64(seed);
        let motion = make(random);
        let ahead = random.random_range(-1.0..1.0);
        let first = record(&motion, 0.0, 1.0, noise, random);
        let second = record(&motion, ahead, -3.0, noise, random);
        let found = ClockOffset::between(&first, &second, [5.0, 2.0], INTERVAL).unwrap();
        // Both clocks read 5 and 2 at their first samples; the second's motion is late by `ahead`.
        let error = found.offset - (5.0 - 2.0 - ahead);
        held += usize::from(error.abs() <= found.half_width);
        worst = worst.max(error.abs() / INTERVAL);
        assert!(found.correlation < 0.0, "the second device has the other sign");
    }
    (held as f64 / SEEDS as f64, worst)
}

/// Lower bound of the 99 % interval of a share of 95 % in 60 trials: 0.95 − 2.576 √(0.95·0.05/60).
const LEAST: f64 = 0.877;

#[test]
fn the_interval_holds_the_offset_as_often_as_it_says() {
    type Case = (&'static str, fn(&mut Pcg64) -> Motion, f64, f64);
    let fast: fn(&mut Pcg64) -> Motion = |random| shaking(random, 2.0, 40.0);
    let slow: fn(&mut Pcg64) -> Motion = |random| shaking(random, 0.05, 1.0);
    // The largest error is what noise of that size leaves: several intervals of the motion's own information.
    let cases: [Case; 5] = [
        ("shaking", fast, 0.02, 0.01),
        ("shaking", fast, 1.0, 0.3),
        ("hits", hits, 0.02, 0.1),
        ("hits", hits, 0.05, 0.2),
        ("slow", slow, 0.3, 3.0),
    ];
    for (name, make, noise, most) in cases {
        let (share, worst) = coverage(make, noise);
        println!("{name}, noise {noise}: held {share:.3}, worst error {worst:.1e} samples");
        assert!(share >= LEAST, "{name}, noise {noise}: {share}");
        assert!(worst <= most, "{name}, noise {noise}: {worst} samples");
    }
}

#[test]
fn without_noise_a_fraction_of_a_sample_is_seen() {
    let random = &mut Pcg64::seed_from_u64(7);
    let motion = shaking(random, 2.0, 40.0);
    let (first, second) = (record(&motion, 0.0, 1.0, 0.0, random), record(&motion, 0.1234, 1.0, 0.0, random));
    let found = ClockOffset::between(&first, &second, [0.0, 0.0], INTERVAL).unwrap();
    // What is left is the low-pass's end effect, in the twentieth of the record next to its ends that is left out.
    assert!((found.offset + 0.1234).abs() < 1e-4 * INTERVAL, "{found:?}");
}

#[test]
fn a_motion_that_repeats_itself_or_none_at_all_is_refused() {
    let random = &mut Pcg64::seed_from_u64(3);
    let sine: Motion = Box::new(|time| (TAU * 7.0 * time).sin());
    let still: Motion = Box::new(|_| 0.0);
    for (motion, noise, word) in [(&sine, 0.0, "repeats itself"), (&still, 1.0, "resemble")] {
        let (first, second) = (record(motion, 0.0, 1.0, noise, random), record(motion, 0.1, 1.0, noise, random));
        let message = ClockOffset::between(&first, &second, [0.0, 0.0], INTERVAL).unwrap_err().to_string();
        assert!(message.contains(word), "{message}");
    }
    assert!(ClockOffset::between(&[0.0; 10], &[0.0; 10], [0.0, 0.0], INTERVAL).is_err());
    assert!(ClockOffset::between(&[0.0; 500], &[0.0; 500], [0.0, 0.0], INTERVAL).is_err());
}
