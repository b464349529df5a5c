//! Records whose ringing is not the spring's, and springs that other things ring beside.

use std::f64::consts::TAU;

use coilsense::identify::{Answer, Identification, Settings};
use coilsense::{Channel, Signals};
use rand::RngExt;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

use crate::paper_springs::s_t;
use crate::records::{RATE, noisy};

/// Half a minute of a spring without mass, swept slowly, with `extra(t)` \[N at end 1, N at end 2, m at end 1\] on top and noise.
fn massless(random: &mut Pcg64, extra: impl Fn(f64) -> [f64; 3]) -> Signals {
    let spring = s_t();
    let times: Vec<f64> = (0..75_000).map(|n| n as f64 / RATE).collect();
    let length = |t: f64| spring.mid_length() + 0.02 * (TAU * 0.1 * t.min(10.0)).sin();
    let mut columns: [Vec<f64>; 4] = Default::default();
    for &t in &times {
        let [input, output, motion] = extra(t);
        let force = spring.static_force(length(t) - motion);
        for (column, value) in columns.iter_mut().zip([force + input, force + output, motion, length(t)]) {
            column.push(value);
        }
    }
    let mut signals = Signals::new(times).unwrap();
    let noise = [0.05, 0.05, 5e-6, 5e-6];
    let channels = [Channel::InputForce, Channel::OutputForce, Channel::U1, Channel::U2];
    for ((channel, column), noise) in channels.into_iter().zip(columns).zip(noise) {
        signals.insert(channel, noisy(column, 0.0, noise, random)).unwrap();
    }
    signals
}

fn answer(signals: &Signals) -> Answer {
    Identification::of(signals, &Settings::default()).unwrap().verdict.answer
}

/// A structure beside the spring: hits make one or two modes of its own ring, seen by the load cells with any sign.
fn structure(seed: u64) -> Signals {
    let mut random = Pcg64::seed_from_u64(seed);
    let modes: Vec<[f64; 4]> = (0..random.random_range(1..3))
        .map(|_| {
            let frequency = 20.0 * 15.0_f64.powf(random.random::<f64>());
            let ratio = 0.002 * 10.0_f64.powf(random.random::<f64>());
            [frequency, ratio, random.random_range(-1.0..1.0), random.random_range(-1.0..1.0)]
        })
        .collect();
    let hits: Vec<f64> = (0..6).map(|hit| 11.0 + 3.0 * hit as f64 + random.random::<f64>()).collect();
    massless(&mut random, |t| {
        let mut sum = [0.0; 3];
        for [frequency, ratio, input, output] in &modes {
            for since in hits.iter().map(|hit| t - hit).filter(|since| *since >= 0.0) {
                let swing = (-ratio * TAU * frequency * since).exp() * (TAU * frequency * since).sin();
                sum[0] += 2.0 * input * swing;
                sum[1] += 2.0 * output * swing;
            }
        }
        sum
    })
}

/// Mains hum with harmonics on both load cells.
fn mains(seed: u64) -> Signals {
    let mut random = Pcg64::seed_from_u64(seed);
    let mains = if seed.is_multiple_of(2) { 50.0 } else { 60.0 } * (1.0 + random.random_range(-5e-4..5e-4));
    let parts: Vec<[f64; 4]> = (1..=5)
        .map(|multiple| {
            let size = random.random_range(0.1..0.6) / f64::from(multiple);
            [f64::from(multiple) * mains, size, random.random_range(-1.0..1.0), random.random_range(0.0..TAU)]
        })
        .collect();
    massless(&mut random, |t| {
        let swing = |part: &[f64; 4]| part[1] * (TAU * part[0] * t + part[3]).sin();
        [parts.iter().map(swing).sum(), parts.iter().map(|part| part[2] * swing(part)).sum(), 0.0]
    })
}

/// A controller's limit cycle: end 1 moves to and fro, not quite a sine, and the force follows.
fn limit_cycle(seed: u64) -> Signals {
    let mut random = Pcg64::seed_from_u64(seed);
    let frequency = random.random_range(8.0..120.0);
    let (size, third) = (random.random_range(2e-4..1e-3), random.random_range(0.05..0.3));
    massless(&mut random, |t| {
        let angle = TAU * frequency * t;
        [0.0, 0.0, size * (angle.sin() + third * (3.0 * angle).sin())]
    })
}

#[test]
fn what_is_not_the_spring_is_never_called_the_spring() {
    for seed in 0..12 {
        for (name, signals) in
            [("structure", structure(seed)), ("mains", mains(seed)), ("limit cycle", limit_cycle(seed))]
        {
            let found = Identification::of(&signals, &Settings::default()).unwrap();
            assert_ne!(found.verdict.answer, Answer::Spring, "{name}, seed {seed}: {:?}", found.verdict);
            assert!(!found.verdict.evidence.is_empty(), "{name}, seed {seed}: a verdict has its reason");
        }
    }
}

#[test]
fn hum_and_a_limit_cycle_are_called_what_they_are() {
    for seed in 0..12 {
        assert_eq!(answer(&mains(seed)), Answer::NotTheSpring, "mains, seed {seed}");
        assert_eq!(answer(&limit_cycle(seed)), Answer::NotTheSpring, "limit cycle, seed {seed}");
    }
}

#[test]
#[ignore = "a minute; run with `cargo test -p coilsense --test identify -- --ignored --nocapture`"]
fn three_hundred_strangers_are_never_called_the_spring() {
    for seed in 100..200 {
        for (name, signals) in
            [("structure", structure(seed)), ("mains", mains(seed)), ("limit cycle", limit_cycle(seed))]
        {
            assert_ne!(answer(&signals), Answer::Spring, "{name}, seed {seed}");
        }
    }
}
