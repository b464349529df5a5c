//! Loops on what an estimator makes of the measured force.

use coilsense::control::{Estimator, SampledLoop, simulate};
use coilsense::mitigation::{KalmanNoise, SampledSpring, modal_kalman, surge_notches};
use coilsense::{Channel, Damping};
use coilsense_rt::{Cascade, Measured};
use num_complex::Complex64;

use crate::integral_loop;
use crate::paper_springs::s_t;

const STEP: f64 = 4e-4;
const RATIO: f64 = 0.005;

fn kalman() -> Estimator {
    let spring = SampledSpring::new(&s_t(), &Damping::Modal(RATIO), 1.0 / STEP).unwrap();
    let noise = KalmanNoise { force: 0.24, shock: 0.15, ringing: 2.0, drift: 0.5 };
    Estimator::Kalman(Box::new(modal_kalman(&spring, &noise).unwrap()))
}

fn notches() -> Estimator {
    let spring = SampledSpring::new(&s_t(), &Damping::Modal(RATIO), 1.0 / STEP).unwrap();
    Estimator::Cascade(Cascade { sections: surge_notches(&spring, 3, 2.0).unwrap().try_into().unwrap() })
}

#[test]
fn an_estimators_response_is_that_of_its_steps() {
    let (rest, length) = (s_t().static_force(0.23), 0.23);
    for hertz in [3.0, 54.0, 108.0, 400.0] {
        let omega = std::f64::consts::TAU * hertz;
        let phase = |sample: u32| Complex64::from_polar(1.0, omega * STEP * f64::from(sample));
        for estimator in [kalman(), notches()] {
            let [by_force, by_stroke] = estimator.response(Complex64::from_polar(1.0, -omega * STEP));
            let count = 40_000;
            let (force, stroke) = (3.0, 1e-3);
            let made: Vec<f64> = match &estimator {
                Estimator::Cascade(cascade) => {
                    let mut state = cascade.settled(rest);
                    (0..count).map(|sample| cascade.step(&mut state, rest + force * phase(sample).re)).collect()
                }
                Estimator::Kalman(filter) => {
                    let mut state = filter.settled(&Measured { force: rest, ends: [0.0, length] });
                    let measured = |sample: u32| Measured {
                        force: rest + force * phase(sample).re,
                        ends: [-stroke * phase(sample).im, length],
                    };
                    (0..count).map(|sample| filter.step(&mut state, &measured(sample)).output).collect()
                }
            };
            // y = −u1 goes as a sine where F_i goes as a cosine: −j.
            let expected = by_force * force - Complex64::i() * by_stroke * stroke;
            for sample in [count - 1, count - 7] {
                let shown = (expected * phase(sample)).re;
                // What is left of the start after 16 s: nothing; positions are multiplied by rate² and k.
                let error = (made[sample as usize] - rest - shown).abs();
                assert!(error < 1e-7 * expected.norm().max(1.0), "{hertz} Hz: {error}");
            }
        }
    }
}

#[test]
fn a_loop_behind_an_estimator_loses_stability_where_predicted() {
    for (name, estimator) in [("Kalman", kalman()), ("notches", notches())] {
        let sampled = SampledLoop::new(&integral_loop(RATIO, Channel::InputForce, STEP), STEP).unwrap();
        let bare = sampled.margins().unwrap().gain_limit;
        let sampled = sampled.behind(estimator).unwrap();
        let limit = sampled.margins().unwrap().gain_limit;
        println!("{name}: crossover limit {limit:.3} rad/s; F_i itself {bare:.3}");
        assert!(limit.is_finite() && limit > 0.0);
        let samples = 50_000;
        let swing = |gain: f64| {
            let run = simulate(&sampled, gain, 1.0, samples).unwrap();
            if run.output.len() < samples {
                return f64::INFINITY;
            }
            let part = |range: std::ops::Range<usize>| {
                let mean = run.output[range.clone()].iter().sum::<f64>() / range.len() as f64;
                run.output[range].iter().map(|value| (value - mean).abs()).fold(0.0, f64::max)
            };
            part(43_750..50_000) / part(25_000..31_250)
        };
        // 2 % either way of the gain that was predicted.
        assert!(swing(0.98 * limit) < 1.0, "{name} rings on at 0.98 of its limit");
        assert!(swing(1.02 * limit) > 1.0, "{name} decays at 1.02 of its limit");
    }
}

#[test]
fn a_true_estimate_of_the_load_end_force_has_that_forces_limit() {
    let of_force = SampledLoop::new(&integral_loop(RATIO, Channel::OutputForce, 0.0), STEP).unwrap().margins().unwrap();
    let sampled = SampledLoop::new(&integral_loop(RATIO, Channel::InputForce, 0.0), STEP).unwrap();
    let of_estimate = sampled.behind(kalman()).unwrap().margins().unwrap();
    // Three modes of 52, a filter that trusts its measurements by half: within a fifth.
    let ratio = of_estimate.gain_limit / of_force.gain_limit;
    println!("limit of the estimate over that of F_o: {ratio}");
    assert!((0.8..1.25).contains(&ratio), "{ratio}");
}

#[test]
fn an_estimator_needs_f_i_and_positions_that_are_known() {
    let sampled = SampledLoop::new(&integral_loop(RATIO, Channel::OutputForce, 0.0), STEP).unwrap();
    assert_eq!(sampled.behind(kalman()).unwrap_err().to_string(), "signal F_i is missing");
}
