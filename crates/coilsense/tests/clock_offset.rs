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

/// What a device records whose clock runs slow by `drift` and reads `ahead` late in the middle of `samples`.
fn drifting(
    motion: &Motion,
    (ahead, drift): (f64, f64),
    samples: usize,
    rate: f64,
    noise: f64,
    random: &mut Pcg64,
) -> Vec<f64> {
    let middle = 0.5 * samples as f64 / rate;
    let sample = |n: usize| {
        let chance: f64 = StandardNormal.sample(random);
        let time = n as f64 / rate;
        motion(time + ahead + drift * (time - middle)) + noise * chance
    };
    (0..samples).map(sample).collect()
}

#[test]
fn a_drift_over_ten_minutes_is_found_with_its_interval() {
    // 600 s at 100 Hz; the offset runs by 30 ms, a fifth of a period of the fastest motion, or by four periods of it.
    const RATE: f64 = 100.0;
    const COUNT: usize = 60_000;
    for (seed, drift, to) in [(1, -50e-6, 6.0), (2, 50e-6, 30.0), (3, 0.0, 6.0), (4, 120e-6, 20.0), (5, -90e-6, 40.0)] {
        let random = &mut Pcg64::seed_from_u64(seed);
        let motion = shaking(random, 0.1, to);
        let first = drifting(&motion, (0.0, 0.0), COUNT, RATE, 0.1, random);
        let second = drifting(&motion, (-0.25, drift), COUNT, RATE, 0.1, random);
        let found = ClockOffset::between(&first, &second, [0.0, 0.0], 1.0 / RATE).unwrap();
        let told = found.drift.unwrap();
        println!("{:.4} ± {:.4} ppm, {:?}", 1e6 * told.rate, 1e6 * told.half_width, found);
        // A thousand samples' noise of a tenth on a slope of at least 20/s each: below 0.1 ppm; two half-widths, five seeds.
        assert!((told.rate - drift).abs() < 2.0 * told.half_width && told.half_width < 0.2e-6, "{told:?}");
        for time in [0.0, 300.0, 600.0] {
            let truth = -0.25 + drift * (time - 300.0);
            assert!((found.added(time) - truth).abs() < 2.0 * found.half_width_at(time), "{time}: {found:?}");
            assert!(found.half_width_at(time) < 1e-4, "{time}: {found:?}");
        }
    }
}

#[test]
fn the_interval_of_a_drift_holds_it_as_often_as_it_says() {
    type Case = (&'static str, fn(&mut Pcg64) -> Motion, f64);
    let fast: fn(&mut Pcg64) -> Motion = |random| shaking(random, 2.0, 40.0);
    // 16 s at 500 Hz: 100 ppm are 1.6 ms.
    let cases: [Case; 4] =
        [("shaking", fast, 0.02), ("shaking", fast, 1.0), ("hits", hits, 0.005), ("hits", hits, 0.02)];
    for (name, make, noise) in cases {
        const SEEDS: u64 = 60;
        let (mut held, mut both, mut fitted) = (0, 0, 0);
        for seed in 0..SEEDS {
            let random = &mut Pcg64::seed_from_u64(1000 + seed);
            let motion = make(random);
            let (ahead, drift) = (random.random_range(-1.0..1.0), random.random_range(-100e-6..100e-6));
            let first = drifting(&motion, (0.0, 0.0), SAMPLES, 500.0, noise, random);
            let second = drifting(&motion, (ahead, drift), SAMPLES, 500.0, noise, random);
            let found = ClockOffset::between(&first, &second, [0.0, 0.0], INTERVAL).unwrap();
            let ends = [0.0, 16.0].map(|time| {
                let truth = ahead + drift * (time - 8.0);
                (found.added(time) - truth).abs() <= found.half_width_at(time)
            });
            both += usize::from(ends == [true; 2]);
            if let Some(told) = found.drift {
                fitted += 1;
                held += usize::from((told.rate - drift).abs() <= told.half_width);
            }
        }
        println!("{name}, noise {noise}: {fitted} of {SEEDS} drifts, {held} held; offsets at both ends {both}");
        assert!(held as f64 >= LEAST * fitted as f64 - 0.5, "{name}, noise {noise}: {held} of {fitted}");
        assert!(both as f64 >= 0.85 * SEEDS as f64, "{name}, noise {noise}: {both}");
    }
}

#[test]
fn a_drift_that_a_record_does_not_tell_is_left_in_the_interval() {
    let random = &mut Pcg64::seed_from_u64(11);
    let short = shaking(random, 0.05, 1.0);
    let first = drifting(&short, (0.0, 0.0), 8000, 500.0, 0.3, random);
    let second = drifting(&short, (-0.25, 0.0), 8000, 500.0, 0.3, random);
    let found = ClockOffset::between(&first, &second, [0.0, 0.0], 1.0 / 500.0).unwrap();
    println!("{found:?}");
    assert!(found.drift.is_none(), "{found:?}");
    let far = 16.0;
    let (there, alone) = (found.half_width_at(far), 100e-6 * (far - found.at));
    assert!(there >= alone && there <= alone + found.half_width, "{found:?}");
    assert!((found.added(far) + 0.25).abs() < there, "{found:?}");
}

#[test]
fn one_second_that_moves_in_ten_minutes_is_refused() {
    // Nineteen of twenty parts hold noise alone, so that nothing tells the scatter: ±41 s was told.
    let random = &mut Pcg64::seed_from_u64(11);
    let early: Motion = Box::new(|time| {
        let since = [1.0, 1.21, 1.47, 1.83].into_iter().map(|at| time - at).filter(|since| *since >= 0.0);
        since.map(|since| (-20.0 * since).exp() * (100.0 * since).sin()).sum()
    });
    let first = drifting(&early, (0.0, 0.0), 60_000, 100.0, 0.01, random);
    let second = drifting(&early, (-0.25, 0.0), 60_000, 100.0, 0.01, random);
    let message = ClockOffset::between(&first, &second, [0.0, 0.0], 0.01).unwrap_err().to_string();
    let refused = ["hardly tell", "the noise is too large"];
    assert!(refused.iter().any(|why| message.contains(why)), "{message}");
}

#[test]
fn two_records_that_have_nothing_in_common_stay_refused_over_ten_minutes() {
    let random = &mut Pcg64::seed_from_u64(12);
    let (one, other) = (shaking(random, 0.1, 6.0), shaking(random, 0.1, 6.0));
    let first = drifting(&one, (0.0, 0.0), 60_000, 100.0, 0.1, random);
    for (motion, noise) in [(&other, 0.1), (&(Box::new(|_: f64| 0.0) as Motion), 1.0)] {
        let second = drifting(motion, (0.0, 0.0), 60_000, 100.0, noise, random);
        let message = ClockOffset::between(&first, &second, [0.0, 0.0], 0.01).unwrap_err().to_string();
        println!("{message}");
    }
    let sine: Motion = Box::new(|time| (TAU * 3.0 * time).sin());
    let first = drifting(&sine, (0.0, 0.0), 60_000, 100.0, 0.01, random);
    let second = drifting(&sine, (-0.25, 50e-6), 60_000, 100.0, 0.01, random);
    let message = ClockOffset::between(&first, &second, [0.0, 0.0], 0.01).unwrap_err().to_string();
    assert!(message.contains("repeats itself"), "{message}");
}

#[test]
fn a_parabola_is_refused_for_late_it_looks_tilted() {
    // Trends are taken out, and of t² a delay leaves nothing but a trend: 0 ± 8 ms was told of 300 ms.
    for (seed, noise) in [(21, 1e-3), (22, 1e-2)] {
        let random = &mut Pcg64::seed_from_u64(seed);
        let motion: Motion = Box::new(|time| (time / 16.0).powi(2));
        let (first, second) = (record(&motion, 0.0, 1.0, noise, random), record(&motion, 0.3, 1.0, noise, random));
        let message = ClockOffset::between(&first, &second, [0.0, 0.0], INTERVAL).unwrap_err().to_string();
        assert!(message.contains("parabola"), "{message}");
    }
}

#[test]
fn an_offset_that_is_hardly_told_is_refused() {
    // A swell over all of the record in noise as large: some seeds come near enough to be judged, and are sure to a second at best.
    for seed in 0..40 {
        let random = &mut Pcg64::seed_from_u64(seed);
        let motion: Motion = Box::new(|time| (0.3 * time).sin() + 0.3 * (0.11 * time).cos());
        let (first, second) = (record(&motion, 0.0, 1.0, 0.5, random), record(&motion, 0.3, 1.0, 0.5, random));
        if let Ok(found) = ClockOffset::between(&first, &second, [0.0, 0.0], INTERVAL) {
            assert!(found.half_width < 0.02 * 16.0, "{found:?}");
        }
    }
}
