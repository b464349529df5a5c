//! Laws that hold whatever the gains.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use coilsense::control::{Controller, Drive, Environment, ForceLoop, Gains, Passivity, Plant, rendered_stiffness};
use coilsense::{Channel, Damping, Spring};
use num_complex::Complex64;

use crate::integral_loop;
use crate::paper_springs::{s_t, s_t_with};

const MOTOR: Drive = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: Some(800.0) };

fn gains() -> Gains {
    Gains {
        proportional: 0.8,
        integral: 5.0,
        derivative: 0.01,
        derivative_bandwidth: Some(60.0),
        feed_forward: 1.0,
        observer_bandwidth: Some(4.0),
    }
}

#[test]
fn a_loop_meets_an_environment_as_its_rendered_stiffness_does() {
    // (1 + L_E)/(1 + L_held) = (K_r + K_E)/(K_0 + K_E), K_0 what is rendered without control: one equation, two routes.
    let environment = Environment::Impedance { mass: 0.7, damping: 3.0, stiffness: 250.0 };
    for drive in [Drive::IDEAL_VELOCITY, Drive::Velocity { bandwidth: Some(40.0) }, MOTOR] {
        for feedback in [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce] {
            let looped = |gains: Gains, environment| {
                let plant = Plant::new(&s_t(), Damping::Modal(0.01), drive, environment).unwrap();
                ForceLoop::new(plant, Controller::new(gains).unwrap(), feedback, 1e-3).unwrap()
            };
            for hertz in [0.3, 5.0, 27.0, 54.0, 90.0, 150.0] {
                let omega = TAU * hertz;
                let meets = Complex64::new(250.0 - 0.7 * omega * omega, 3.0 * omega);
                let closed = rendered_stiffness(&looped(gains(), Environment::Held), omega).unwrap();
                let faint = Gains { proportional: 1e-30, ..Gains::default() };
                let open = rendered_stiffness(&looped(faint, Environment::Held), omega).unwrap();
                let [with, held] =
                    [environment, Environment::Held].map(|e| 1.0 + looped(gains(), e).at(omega).unwrap());
                let expected = (closed + meets) / (open + meets);
                // Rounding of ratios near the spring's resonances.
                assert!((with / held / expected - 1.0).norm() < 1e-9, "{drive:?} {feedback:?} {hertz}");
            }
        }
    }
}

#[test]
fn a_light_spring_on_a_motor_keeps_rouths_limit() {
    // M s³ + b s² + k s + K_I k: stable for K_I < b/M.
    let spring = Spring::new(s_t_with(|parameters| parameters.mass = 1e-7)).unwrap();
    let drive = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None };
    for feedback in [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce] {
        let plant = Plant::new(&spring, Damping::Modal(0.01), drive, Environment::Held).unwrap();
        let looped = ForceLoop::new(plant, Controller::integral(1.0).unwrap(), feedback, 0.0).unwrap();
        let margins = looped.margins().unwrap();
        // A third of the spring's mass over the motor's, 2e-8, is below what bisection needs.
        assert_relative_eq!(margins.gain_limit, 15.0, max_relative = 1e-6);
        assert_relative_eq!(margins.critical_frequency, (760.0_f64 / 2.0).sqrt(), max_relative = 1e-6);
    }
}

#[test]
fn slow_references_are_tracked_and_slow_motions_of_the_world_are_not_felt() {
    let looped = integral_loop(0.01, Channel::InputForce, 0.0);
    let slow = 1e-3;
    assert!((looped.tracking(slow).unwrap() - 1.0).norm() < 2e-3); // 1/(1 + s)
    // k s/(s + 1) of a spring without mass.
    let expected = 760.0 * Complex64::new(0.0, slow) / Complex64::new(1.0, slow);
    assert!((rendered_stiffness(&looped, slow).unwrap() / expected - 1.0).norm() < 1e-6);
}

#[test]
fn without_a_delay_a_slow_integral_loop_renders_a_passive_spring() {
    for feedback in [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce] {
        let passivity = Passivity::of(&integral_loop(0.005, feedback, 0.0), 500.0).unwrap();
        assert_eq!(passivity.active, Vec::<[f64; 2]>::new(), "{feedback:?}");
        assert!(passivity.least > 0.0);
    }
}

#[test]
fn a_delay_makes_the_rendered_spring_active() {
    let looped = |delay| integral_loop(0.0, Channel::DeflectionForce, delay);
    let delay = 5e-3;
    let passivity = Passivity::of(&looped(delay), 400.0).unwrap();
    // Without ringing: Re(k e^…/(s + ω_c e^(−sT))) < 0 where cos(ωT) < 0: first at a quarter period of the delay.
    assert!(!passivity.active.is_empty());
    let quarter = 0.25 / delay;
    assert!((passivity.active[0][0] / quarter - 1.0).abs() < 0.25, "{:?}", passivity.active);
}
