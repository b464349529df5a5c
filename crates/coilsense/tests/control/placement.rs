//! The placement rule.

use std::f64::consts::FRAC_PI_2;

use coilsense::Channel;
use coilsense::modes::ChainModes;

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
