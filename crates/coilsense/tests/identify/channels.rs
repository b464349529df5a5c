//! Channels that are held, coarse, clipped or filtered: what is found of them before anything is fitted, and what then rings.

use std::f64::consts::TAU;

use coilsense::identify::{Answer, ChannelCheck, Identification, Settings};
use coilsense::{Channel, FarEnd, Signals};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

use crate::paper_springs::s_t;
use crate::records::{RATE, bumped, hit, noisy, own};

const FORCES: [Channel; 2] = [Channel::InputForce, Channel::OutputForce];
/// f1 of S_T's chain with both ends held \[Hz\].
const FIRST: f64 = 54.057_265;

fn of(signals: &Signals) -> Identification {
    Identification::of(signals, &Settings::default()).unwrap()
}

/// The record with each force changed.
fn changed(signals: &Signals, mut change: impl FnMut(&[f64]) -> Vec<f64>) -> Signals {
    let mut other = signals.clone();
    for channel in FORCES {
        let values = change(signals.channel(channel).unwrap());
        other.insert(channel, values).unwrap();
    }
    other
}

fn held(values: &[f64], ratio: f64) -> Vec<f64> {
    // The last sample at which the device had a new value.
    (0..values.len()).map(|n| values[((n as f64 / ratio).floor() * ratio).ceil() as usize]).collect()
}

fn quantised(values: &[f64], digit: f64) -> Vec<f64> {
    values.iter().map(|value| digit * (value / digit).round()).collect()
}

/// Sections of second order of a Butterworth filter of an even order, by the bilinear transform with its corner warped; high-pass or low-pass.
fn filtered(values: &[f64], order: usize, corner: f64, high: bool, rate: f64) -> Vec<f64> {
    let warped = (std::f64::consts::PI * corner / rate).tan();
    let first = values[0];
    let mut out: Vec<f64> = values.iter().map(|value| value - first).collect();
    for section in 0..order / 2 {
        let q = 0.5 / (std::f64::consts::PI * (2 * section + 1) as f64 / (2 * order) as f64).sin();
        let scale = 1.0 + warped / q + warped * warped;
        let gain = if high { 1.0 } else { warped * warped } / scale;
        let middle = if high { -2.0 } else { 2.0 };
        let back = [2.0 * (warped * warped - 1.0) / scale, (1.0 - warped / q + warped * warped) / scale];
        let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
        for value in &mut out {
            let next = gain * (*value + middle * x[0] + x[1]) - back[0] * y[0] - back[1] * y[1];
            (x, y) = ([*value, x[0]], [next, y[0]]);
            *value = next;
        }
    }
    out.iter().map(|value| value + if high { 0.0 } else { first }).collect()
}

fn low_passed(signals: &Signals, order: usize, corner: f64, noise: f64) -> Signals {
    let mut random = Pcg64::seed_from_u64(17);
    changed(signals, |force| noisy(filtered(force, order, corner, false, RATE), 0.0, noise, &mut random))
}

fn is_plain(check: &ChannelCheck) -> bool {
    check.update_rate.is_none() && check.clipping.is_none() && check.low_pass.is_none() && check.high_pass.is_none()
}

#[test]
fn a_plain_record_has_plain_channels() {
    let records = [
        ("S_T", hit(&s_t(), 0.004, 3, [0.0; 3]).signals),
        ("lightly damped", hit(&s_t(), 0.001, 4, [0.0; 3]).signals),
        ("strongly damped", hit(&own(), 0.05, 5, [0.0; 3]).signals),
        ("held", bumped(FarEnd::Position, 2500.0)),
        ("free", bumped(FarEnd::Force, 2500.0)),
        ("with a mass", bumped(FarEnd::Mass(0.05), 2500.0)),
        ("sampled slowly", bumped(FarEnd::Position, 250.0)),
    ];
    for (name, signals) in records {
        let found = of(&signals);
        assert!(found.channels.iter().all(is_plain), "{name}: {:?}", found.channels);
        assert!(found.channels.iter().all(|check| check.repeated < 0.01), "{name}: {:?}", found.channels);
    }
}

#[test]
fn a_held_force_is_taken_at_its_own_pace() {
    let truth = hit(&s_t(), 0.004, 7, [0.0; 3]);
    let plain = of(&truth.signals);
    for ratio in [2.0, 3.0, 4.37, 6.1] {
        let found = of(&changed(&truth.signals, |force| held(force, ratio)));
        // A minute's changes tell the clock to a sample of their whole length.
        assert!((found.sampling.rate * ratio / RATE - 1.0).abs() < 1e-4, "{ratio}: {} Hz", found.sampling.rate);
        let rates: Vec<f64> = found.channels.iter().filter_map(|check| check.update_rate).collect();
        assert_eq!(rates.len(), 2, "{ratio}: {:?}", found.channels);
        assert!(found.verdict.evidence.iter().any(|line| line.contains("has a new value only every")), "{ratio}");
        // Held values are late by up to an interval, hits by as much.
        assert_eq!(found.hits.len(), plain.hits.len(), "{ratio}");
        assert!((found.first_frequency.unwrap().value / truth.frequency - 1.0).abs() < 0.01, "{ratio}");
    }
}

#[test]
fn a_line_above_half_the_update_rate_is_not_believed() {
    let signals = changed(&bumped(FarEnd::Position, 2500.0), |force| held(force, 25.0));
    let found = of(&signals);
    assert!((found.sampling.rate - 100.0).abs() < 0.01);
    assert_ne!(found.verdict.answer, Answer::Spring, "{:?}", found.verdict);
}

#[test]
fn a_slower_force_is_left_out_of_what_rings() {
    let truth = hit(&s_t(), 0.004, 8, [0.0; 3]);
    let mut signals = truth.signals.clone();
    let slow = held(signals.channel(Channel::OutputForce).unwrap(), 25.0);
    signals.insert(Channel::OutputForce, slow).unwrap();
    let found = of(&signals);
    assert!(!found.has_both_forces);
    assert_eq!(found.sampling.samples, truth.signals.time().len());
    assert_eq!(found.verdict.answer, Answer::Spring);
    assert!((found.first_frequency.unwrap().value / truth.frequency - 1.0).abs() < 1e-3);
    assert!(found.verdict.evidence.iter().any(|line| line.contains("F_o has a new value only every 10 ms (100 Hz)")));
}

#[test]
fn a_coarse_quiet_force_is_not_held() {
    let signals = hit(&s_t(), 0.004, 9, [0.0; 3]).signals;
    // Noise of S_T's cells is 0.036 N: from a third of it to six times as much.
    for digit in [0.01, 0.05, 0.2] {
        let found = of(&changed(&signals, |force| quantised(force, digit)));
        for check in &found.channels {
            assert_eq!(check.update_rate, None, "{digit}");
            assert!((check.last_digit.unwrap() / digit - 1.0).abs() < 1e-6, "{digit}: {check:?}");
            assert!(check.clipping.is_none() && check.low_pass.is_none(), "{digit}: {check:?}");
        }
    }
    let both = of(&changed(&signals, |force| held(&quantised(force, 0.05), 4.0)));
    assert!((both.sampling.rate - RATE / 4.0).abs() < 0.01, "held and coarse: {} Hz", both.sampling.rate);
}

#[test]
fn a_clipped_force_says_where_and_only_what_comes_after_is_fitted() {
    let truth = hit(&s_t(), 0.004, 10, [0.0; 3]);
    let rest = |force: &[f64]| force[force.len() - 1];
    let mut limits = Vec::new();
    let signals = changed(&truth.signals, |force| {
        let swing = force[50_000..].iter().map(|value| (value - rest(force)).abs()).fold(0.0, f64::max);
        let (low, high) = (rest(force) - 0.4 * swing, rest(force) + 0.4 * swing);
        limits.push((low, high));
        force.iter().map(|value| value.clamp(low, high)).collect()
    });
    let found = of(&signals);
    for (check, (low, high)) in found.channels.iter().zip(limits) {
        let clipping = check.clipping.unwrap();
        assert!(clipping.high == Some(high) || clipping.low == Some(low), "{clipping:?}");
        assert!(clipping.share > 0.0 && clipping.share < 0.5);
    }
    // What is left is linear: f1 as without limits.
    assert!((found.first_frequency.unwrap().value / truth.frequency - 1.0).abs() < 1e-3);
    assert!(found.verdict.evidence.iter().any(|line| line.contains("is clipped at")));
}

#[test]
fn one_lightly_damped_line_is_not_clipped_even_where_its_crests_share_a_digit() {
    let mut random = Pcg64::seed_from_u64(2);
    let times: Vec<f64> = (0..50_000).map(|n| f64::from(n) / RATE).collect();
    for digit in [0.0, 0.01, 0.1] {
        let swing = |t: f64| if t < 2.0 { 0.0 } else { (-0.02 * (t - 2.0)).exp() * (TAU * 20.0 * (t - 2.0)).sin() };
        let force = noisy(times.iter().map(|&t| swing(t)).collect(), 0.0, 1e-4, &mut random);
        let mut signals = Signals::new(times.clone()).unwrap();
        let values = if digit > 0.0 { quantised(&force, digit) } else { force };
        signals.insert(Channel::OutputForce, values).unwrap();
        let found = of(&signals);
        assert!(is_plain(&found.channels[0]), "{digit}: {:?}", found.channels);
    }
}

#[test]
fn hits_are_found_behind_a_loggers_low_pass() {
    let truth = hit(&s_t(), 0.004, 11, [0.0; 3]);
    let plain = of(&truth.signals);
    for (order, corner) in [(4, 70.0), (4, 150.0), (4, 300.0), (4, 500.0), (2, 200.0), (8, 200.0)] {
        let found = of(&low_passed(&truth.signals, order, corner, 1e-4));
        for check in &found.channels {
            // Bands are 12 % wide, and the floor has to fall by 3 dB.
            let seen = check.low_pass.unwrap();
            assert!((seen / corner).ln().abs() < 0.35, "order {order} at {corner} Hz: {seen} Hz");
        }
        let heard = plain.hits.iter().filter(|hit| found.hits.iter().any(|other| (other.time - hit.time).abs() < 0.05));
        assert_eq!(heard.count(), plain.hits.len(), "order {order} at {corner} Hz");
        assert!(found.hits.len() <= plain.hits.len() + 1, "order {order} at {corner} Hz: {:?}", found.hits);
        assert!((found.first_frequency.unwrap().value / FIRST - 1.0).abs() < 0.01, "order {order} at {corner} Hz");
        assert!(found.verdict.evidence.iter().any(|line| line.contains("is low-passed at about")));
    }
}

#[test]
fn white_noise_and_a_steep_filter_against_folding_are_no_low_pass() {
    let mut random = Pcg64::seed_from_u64(6);
    let times: Vec<f64> = (0..50_000).map(|n| f64::from(n) / RATE).collect();
    let noise = noisy(vec![0.0; times.len()], 0.0, 0.01, &mut random);
    for values in [filtered(&noise, 8, 0.4 * RATE, false, RATE), noise] {
        let mut signals = Signals::new(times.clone()).unwrap();
        signals.insert(Channel::InputForce, values).unwrap();
        assert!(is_plain(&of(&signals).channels[0]));
    }
    let ringing = low_passed(&hit(&s_t(), 0.004, 12, [0.0; 3]).signals, 8, 0.4 * RATE, 1e-4);
    assert!(of(&ringing).channels.iter().all(is_plain));
}

#[test]
fn behind_a_high_pass_there_is_no_stiffness() {
    let signals = hit(&s_t(), 0.004, 13, [0.0; 3]).signals;
    for (order, corner) in [(2, 1.0), (2, 10.0), (4, 150.0)] {
        let found = of(&changed(&signals, |force| filtered(force, order, corner, true, RATE)));
        assert!(found.channels.iter().all(|check| check.high_pass.is_some()), "order {order} at {corner} Hz");
        assert!(found.stiffness.is_err(), "order {order} at {corner} Hz");
        assert!(found.verdict.evidence.iter().any(|line| line.contains("slow motion")), "{:?}", found.verdict.evidence);
    }
}
