//! The sampled loop: its formula, its limit, and the run over time.

use coilsense::control::{Controller, Drive, Environment, ForceLoop, Gains, Plant, SampledLoop, simulate};
use coilsense::{Channel, Damping};
use num_complex::Complex64;

use crate::integral_loop;
use crate::paper_springs::s_t;

/// Growth of the ringing from the first quarter of a run to its last.
fn growth(sampled: &SampledLoop, gain: f64, samples: usize) -> f64 {
    let run = simulate(sampled, gain, 1.0, samples).unwrap();
    let force = &run.output;
    if force.len() < samples {
        return f64::INFINITY; // ran away
    }
    let swing = |part: &[f64]| {
        let mean = part.iter().sum::<f64>() / part.len() as f64;
        part.iter().map(|value| (value - mean).abs()).fold(0.0, f64::max)
    };
    swing(&force[samples - samples / 8..]) / swing(&force[samples / 2..samples / 2 + samples / 8])
}

#[test]
fn the_run_over_time_loses_stability_at_the_predicted_gain() {
    for (feedback, late, seconds) in [
        (Channel::OutputForce, 0, 20.0),
        (Channel::OutputForce, 2, 20.0),
        (Channel::InputForce, 1, 4.0),
        (Channel::DeflectionForce, 3, 2.0),
    ] {
        let step = 4e-4;
        let looped = integral_loop(0.005, feedback, f64::from(late) * step);
        let sampled = SampledLoop::new(&looped, step).unwrap();
        let limit = sampled.margins().unwrap().gain_limit;
        let samples = (seconds / step) as usize;
        let (mut low, mut high) = (0.9 * limit, 1.1 * limit);
        assert!(growth(&sampled, low, samples) < 1.0 && growth(&sampled, high, samples) > 1.0, "{feedback:?}, {late}");
        for _ in 0..7 {
            let middle = 0.5 * (low + high);
            if growth(&sampled, middle, samples) < 1.0 { low = middle } else { high = middle }
        }
        let off = 0.5 * (low + high) / limit - 1.0;
        println!(
            "{feedback:?}, {late} steps late: crossover limit {limit:.3} rad/s, the run loses it {:.3} % off",
            100.0 * off
        );
        // The issue asks for 2 %; what bisection and the length of the run leave is less.
        assert!(off.abs() < 5e-3, "{feedback:?}, {late}: {off}");
    }
}

#[test]
fn a_loop_that_alternates_from_sample_to_sample_has_a_limit() {
    let (step, tau) = (4e-4, std::f64::consts::TAU);
    // z − 1 + K k h = 0: stable for K k h < 2, then with z = −1. Crossovers are 1/s here, so that K k = 1.
    let sampled = SampledLoop::new(&integral_loop(0.01, Channel::DeflectionForce, 0.0), step).unwrap();
    let margins = sampled.margins().unwrap();
    assert!((margins.gain_limit * step / 2.0 - 1.0).abs() < 1e-12, "{}", margins.gain_limit);
    assert!((margins.critical_frequency * step / std::f64::consts::PI - 1.0).abs() < 1e-12);
    assert!(margins.stable);
    // A command acts at the next sample at the earliest, so that a pole leaves for infinity as the gain grows: a limit is always there.
    let motor = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: Some(300.0) };
    for drive in [Drive::IDEAL_VELOCITY, Drive::Velocity { bandwidth: Some(40.0) }, motor] {
        for feedback in Channel::FORCES {
            let plant = Plant::new(&s_t(), Damping::Modal(0.01), drive, Environment::Held).unwrap();
            let looped = ForceLoop::new(plant, Controller::proportional(1e-3).unwrap(), feedback, 0.0).unwrap();
            let limit = SampledLoop::new(&looped, 1e-3).unwrap().margins().unwrap().gain_limit;
            assert!(limit > 0.0 && limit.is_finite(), "{drive:?} {feedback:?}: {limit}");
        }
    }
    // A load cell's modes are folded to any place below half the rate; whatever lies there, runs on both sides of the limit tell.
    let (mut alternate, mut ring) = (0, 0);
    for tenths in [36, 40, 44, 50, 56, 60, 64, 70, 80] {
        let step = 1e-4 * f64::from(tenths);
        for feedback in [Channel::InputForce, Channel::OutputForce] {
            for ratio in [0.01, 0.05, 0.2] {
                let sampled = SampledLoop::new(&integral_loop(ratio, feedback, 0.0), step).unwrap();
                let margins = sampled.margins().unwrap();
                let half = margins.critical_frequency * step > 0.999_999 * std::f64::consts::PI;
                if half {
                    alternate += 1
                } else {
                    ring += 1
                }
                assert!(
                    margins.gain_limit > 0.0 && margins.gain_limit.is_finite(),
                    "{feedback:?} {ratio} {step}: {margins:?}"
                );
                let grows = |share: f64| {
                    let run = simulate(&sampled, share * margins.gain_limit, 1.0, 40_000).unwrap();
                    let last =
                        run.output.iter().rev().take(4000).fold(0.0_f64, |most, force| most.max((force - 1.0).abs()));
                    run.output.len() < 40_000 || last > 1.0
                };
                let place = margins.critical_frequency / tau;
                assert!(
                    !grows(0.98) && grows(1.02),
                    "{feedback:?} {ratio} {step}: {} at {place} Hz",
                    margins.gain_limit
                );
            }
        }
    }
    assert!(alternate > 5 && ring > 5, "{alternate} alternate, {ring} ring");
}

#[test]
fn a_mass_at_end_2_rests_before_the_reference_comes() {
    // By the mounted spring's motion and by poles, which damp other modes and so hardly at all here: a mean force was counted as response, 8000 % of the step.
    for feedback in [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce] {
        let run = |damping| {
            let load = Environment::Impedance { mass: 0.02, damping, stiffness: 0.0 };
            let plant = Plant::new(&s_t(), Damping::Modal(1e-4), Drive::IDEAL_VELOCITY, load).unwrap();
            let controller = Controller::proportional(0.05 / s_t().stiffness()).unwrap();
            let looped = ForceLoop::new(plant, controller, feedback, 5e-4).unwrap();
            simulate(&SampledLoop::new(&looped, 5e-4).unwrap(), 1.0, 1.0, 2000).unwrap().output
        };
        let (mounted, poles) = (run(0.0), run(1e-9));
        let peak = poles.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
        assert!(peak > 0.0 && peak < 1.0, "{feedback:?}: {peak}");
        for (index, (one, other)) in mounted.iter().zip(&poles).enumerate() {
            assert!((one - other).abs() < 0.05 * peak, "{feedback:?} {index}: {one} for {other}, peak {peak}");
        }
    }
}

#[test]
fn the_closed_loop_in_samples_is_the_run_over_time_s_own_response() {
    let tau = std::f64::consts::TAU;
    let step = 2e-3;
    for (feedback, drive) in [
        (Channel::OutputForce, Drive::IDEAL_VELOCITY),
        (Channel::InputForce, Drive::Velocity { bandwidth: Some(60.0) }),
        (Channel::DeflectionForce, Drive::IDEAL_VELOCITY),
    ] {
        let plant = Plant::new(&s_t(), Damping::Modal(0.03), drive, Environment::Held).unwrap();
        let controller = Controller::new(Gains { proportional: 6.0 / s_t().stiffness(), ..Gains::default() }).unwrap();
        let looped = ForceLoop::new(plant.clone(), controller, feedback, step).unwrap();
        let sampled = SampledLoop::new(&looped, step).unwrap();
        assert!(sampled.margins().unwrap().stable, "{feedback:?}");
        // The response to a kick of the reference: the difference of what a step gives, until it has died away.
        let run = simulate(&sampled, 1.0, 1.0, 8000).unwrap();
        let kicked = |series: &[f64], omega: f64| -> Complex64 {
            let before = std::iter::once(&0.0).chain(series);
            let each = series.iter().zip(before).enumerate();
            each.map(|(index, (now, before))| Complex64::from_polar(now - before, -omega * step * index as f64)).sum()
        };
        for hertz in [1.0, 20.0, 54.0, 107.0, 170.0, 240.0] {
            let omega = tau * hertz;
            let read = sampled.read(omega, sampled.at(omega).unwrap());
            // What is fed back, from sample to sample, and the end force as the sum of its copies.
            let mut summed = Complex64::ZERO;
            for copy in -600..=600 {
                let at = omega + tau / step * f64::from(copy);
                let response = plant.at(at.abs()).unwrap();
                let read = if at < 0.0 { read.conj() } else { read };
                let part = sampled.closed(at.abs(), &response, read).output;
                summed += if at < 0.0 { part.conj() } else { part };
            }
            let found = kicked(&run.output, omega);
            assert!(
                (summed - found).norm() < 2e-3 * found.norm().max(1e-2),
                "{feedback:?} {hertz}: {summed} for {found}"
            );
        }
    }
}

#[test]
fn modes_and_sampling_copies_give_one_response() {
    for (feedback, tolerance) in
        [(Channel::OutputForce, 1e-3), (Channel::InductanceForce, 1e-3), (Channel::InputForce, 2e-2)]
    {
        let sampled = SampledLoop::new(&integral_loop(0.01, feedback, 0.0), 4e-4).unwrap();
        let with = |drive: Drive, environment: Environment| {
            let plant = Plant::new(&s_t(), Damping::Modal(0.01), drive, environment).unwrap();
            let looped = ForceLoop::new(plant, Controller::proportional(1.0 / 760.0).unwrap(), feedback, 0.0);
            SampledLoop::new(&looped.unwrap(), 4e-4).unwrap()
        };
        // Something as stiff as a wall changes nothing but the way of computing, nor does a lag far above the chain's cut-off.
        let wall = Environment::Impedance { mass: 0.0, damping: 0.0, stiffness: 1e12 };
        let copies = with(Drive::IDEAL_VELOCITY, wall);
        let lagged = with(Drive::Velocity { bandwidth: Some(1e9) }, Environment::Held);
        for hertz in [1.0, 20.0, 50.0, 54.1, 80.0, 108.0, 300.0, 700.0, 1200.0] {
            let [exact, summed, pushed] =
                [&sampled, &copies, &lagged].map(|looped| looped.at(std::f64::consts::TAU * hertz).unwrap());
            assert!((exact - pushed).norm() < 1e-5 * exact.norm(), "{feedback:?} at {hertz} Hz: {exact} {pushed}");
            // 81 copies of a response that falls with the square of frequency leave this.
            assert!(
                (exact - summed).norm() < tolerance * exact.norm().max(1e-4),
                "{feedback:?} at {hertz} Hz: {exact} {summed}"
            );
        }
    }
}

#[test]
fn ever_faster_samples_become_the_continuous_loop() {
    let looped = integral_loop(0.01, Channel::OutputForce, 0.0);
    let omega = std::f64::consts::TAU * 30.0;
    let exact = looped.at(omega).unwrap();
    // A command held for h is late by h/2; that taken off, what is left falls with the square of the step.
    let error = |step: f64| {
        let sampled = SampledLoop::new(&looped, step).unwrap().at(omega).unwrap();
        (sampled * num_complex::Complex64::from_polar(1.0, 0.5 * omega * step) - exact).norm()
    };
    let order = (error(2e-4) / error(1e-4)).log2();
    assert!((order - 2.0).abs() < 0.05, "order {order}");
}

#[test]
fn an_end_mass_and_an_observer_run_as_predicted() {
    let environment = Environment::Impedance { mass: 1.0, damping: 0.0, stiffness: 0.0 };
    let plant = Plant::new(&s_t(), Damping::Modal(0.02), Drive::IDEAL_VELOCITY, environment).unwrap();
    let gains = Gains { proportional: 1.0 / 760.0, observer_bandwidth: Some(0.1), ..Gains::default() };
    let looped = ForceLoop::new(plant, Controller::new(gains).unwrap(), Channel::InputForce, 4e-4).unwrap();
    let sampled = SampledLoop::new(&looped, 4e-4).unwrap();
    let limit = sampled.margins().unwrap().gain_limit;
    assert!(limit.is_finite() && limit > 0.0);
    let samples = 20_000;
    assert!(growth(&sampled, 0.95 * limit, samples) < 1.0, "{limit}");
    assert!(growth(&sampled, 1.05 * limit, samples) > 1.0, "{limit}");
}
