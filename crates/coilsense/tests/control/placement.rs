//! The placement rule.

use std::f64::consts::FRAC_PI_2;

use coilsense::control::{Controller, Drive, Environment, ForceLoop, Gains, Plant};
use coilsense::modes::ChainModes;
use coilsense::{Channel, Damping};

use crate::integral_loop;
use crate::paper_springs::s_t;

#[test]
fn integral_control_of_the_load_end_force_is_stable_only_for_a_crossover_below_zeta_omega_one() {
    let surge = ChainModes::of(&s_t()).frequencies()[0];
    for ratio in [0.001, 0.002, 0.005, 0.01, 0.02] {
        let margins = integral_loop(ratio, Channel::OutputForce, 0.0).margins().unwrap();
        // What the higher modes add to the first one's peak; the issue asks for 0.5 %.
        let off = margins.gain_limit / (ratio * surge) - 1.0;
        println!("ζ = {ratio}: crossover limit over ζ ω_1 is off by {:.4} %", 100.0 * off);
        assert!(off.abs() < 1e-3, "ζ = {ratio}: {off}");
        assert!((margins.critical_frequency / surge - 1.0).abs() < 1e-3);
    }
}

#[test]
fn the_motor_side_and_the_deflection_know_no_such_limit() {
    let surge = ChainModes::of(&s_t()).frequencies()[0];
    for channel in [Channel::InputForce, Channel::DeflectionForce] {
        for ratio in [0.001, 0.005, 0.02] {
            let looped = integral_loop(ratio, channel, 0.0);
            assert_eq!(looped.margins().unwrap().gain_limit, f64::INFINITY, "{channel:?}, ζ = {ratio}");
            // Also far beyond every surge frequency.
            assert_eq!(looped.trace().unwrap().unstable_poles(100.0 * surge), 0);
        }
    }
}

#[test]
fn past_its_limit_one_pair_of_poles_is_unstable() {
    let looped = integral_loop(0.005, Channel::OutputForce, 0.0);
    let (trace, limit) = (looped.trace().unwrap(), looped.margins().unwrap().gain_limit);
    assert_eq!([0.99, 1.01].map(|factor| trace.unstable_poles(factor * limit)), [0, 2]);
}

#[test]
fn a_pure_delay_has_its_textbook_margins() {
    // F_x with the far end held is k y: L = ω_c e^(−sT)/s.
    let delay = 2e-3;
    let margins = integral_loop(0.005, Channel::DeflectionForce, delay).margins().unwrap();
    assert!((margins.gain_limit * delay / FRAC_PI_2 - 1.0).abs() < 1e-9); // bisection to the last digit
    assert!((margins.critical_frequency * delay / FRAC_PI_2 - 1.0).abs() < 1e-9);
    // Straight lines between points 0.15 rad apart are exact for 1/s, and nearly so for the delay's phase.
    assert!((margins.crossover - 1.0).abs() < 1e-9);
    assert!((margins.phase - (FRAC_PI_2 - delay)).abs() < 1e-5);
    assert!((margins.delay - (FRAC_PI_2 - delay)).abs() < 1e-5);
    // |1 + L| ≥ 1/2 first fails at K T = 0.7 or so; from the definition, by a scan.
    let nearest = |gain: f64| {
        let scan = (1..200_000).map(|step| f64::from(step) * 1e-5);
        scan.map(|x| (1.0 - 2.0 * gain / x * x.sin() + (gain / x).powi(2)).sqrt()).fold(f64::INFINITY, f64::min)
    };
    assert!((nearest(margins.robust_gain * delay) - 0.5).abs() < 2e-3); // |1 + L| between points of the trace
}

#[test]
fn inductance_feeds_back_hardly_any_of_the_first_mode() {
    // Odd modes do not change L of a uniform coil: the limit lies where the second mode rings, far above that of F_o.
    let by_inductance = integral_loop(0.005, Channel::InductanceForce, 0.0).margins().unwrap();
    let at_the_load = integral_loop(0.005, Channel::OutputForce, 0.0).margins().unwrap();
    println!("limit of F_L over that of F_o: {}", by_inductance.gain_limit / at_the_load.gain_limit);
    assert!(by_inductance.gain_limit > 10.0 * at_the_load.gain_limit);
}

#[test]
fn two_integrators_are_damped_in_a_fast_loop_alone() {
    // F_x with the far end held is k y: L = a (x + 1)/x², x = T s, a = K k T. |1 + L|² has the minimum 1 − (2 − a)²/4, which is 1/4 at a = 2 − √3.
    let time = 0.1;
    let plain = integral_loop(0.005, Channel::DeflectionForce, 0.0);
    let proportional = 1.0 / (time * s_t().stiffness());
    let gains =
        Gains { proportional, integral: proportional / time, ..*Controller::proportional(1.0).unwrap().gains() };
    let controller = Controller::new(gains).unwrap();
    let looped = ForceLoop::new(plain.plant().clone(), controller, Channel::DeflectionForce, 0.0).unwrap();
    let margins = looped.margins().unwrap();
    assert_eq!((margins.gain_limit, margins.robust_gain), (f64::INFINITY, f64::INFINITY));
    let least = 2.0 - 3.0_f64.sqrt();
    assert!((margins.robust_from / least - 1.0).abs() < 5e-3, "{}", margins.robust_from); // |1 + L| between points of the trace
    // One integrator is damped however slow the loop is.
    assert_eq!(plain.margins().unwrap().robust_from, 0.0);
}

#[test]
fn a_drive_with_a_lag_is_not_robust_at_any_gain() {
    // F_x of a held spring under a velocity with a lag T: L = a / (s (1 + T s)), stable at any gain; with u = a T and x = ω T,
    // |1 + L|² = ((u − x²)² + x²) / (x² + x⁴), which is nowhere below 1/4 for a small u only.
    let bandwidth = 80.0;
    let drive = Drive::Velocity { bandwidth: Some(bandwidth) };
    let plant = Plant::new(&s_t(), Damping::Modal(0.005), drive, Environment::Held).unwrap();
    let controller = Controller::proportional(1.0 / s_t().stiffness()).unwrap();
    let looped = ForceLoop::new(plant, controller, Channel::DeflectionForce, 0.0).unwrap();
    let margins = looped.margins().unwrap();
    let keeps = |u: f64| {
        (0..20_000)
            .map(|index| 10.0_f64.powf(-3.0 + 3e-4 * f64::from(index)).powi(2))
            .all(|square| (u - square).powi(2) + square >= 0.25 * (square + square * square))
    };
    let (mut low, mut high) = (1e-3, 1e3);
    for _ in 0..50 {
        let middle = f64::sqrt(low * high);
        *(if keeps(middle) { &mut low } else { &mut high }) = middle;
    }
    let expected = low * std::f64::consts::TAU * bandwidth;
    assert_eq!((margins.gain_limit, margins.robust_from), (f64::INFINITY, 0.0));
    assert!((margins.robust_gain / expected - 1.0).abs() < 1e-2, "{} of {expected}", margins.robust_gain);
}
