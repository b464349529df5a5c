//! Laws that hold whatever the gains.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use coilsense::control::{
    Controller, Drive, Environment, ForceLoop, Gains, OverTime, Passivity, Plant, SampledLoop, rendered_stiffness,
};
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

#[test]
fn a_spring_of_another_stiffness_than_the_designer_knows_is_read_by_his() {
    // The spring is 25 % stiffer than believed: deflection and inductance are read as 0.8 of the force, load cells as it is.
    let [is, believed] = [1.25, 1.0].map(|factor| factor * s_t().stiffness());
    let stiff = Spring::new(s_t_with(|parameters| parameters.stiffness = is)).unwrap();
    let drive = Drive::Velocity { bandwidth: Some(40.0) };
    for (feedback, read) in [
        (Channel::InputForce, 1.0),
        (Channel::OutputForce, 1.0),
        (Channel::DeflectionForce, 0.8),
        (Channel::InductanceForce, 0.8),
    ] {
        let plant = Plant::new(&stiff, Damping::Modal(0.02), drive, Environment::Held).unwrap();
        let controller = Controller::new(gains()).unwrap();
        let looped = ForceLoop::new(plant.clone(), controller, feedback, 1e-3).unwrap().designed_for(believed).unwrap();
        for hertz in [0.3, 5.0, 27.0, 90.0] {
            let s = Complex64::new(0.0, TAU * hertz);
            let Gains { proportional, integral, derivative, derivative_bandwidth, observer_bandwidth, feed_forward } =
                gains();
            let pid = proportional + integral / s + derivative * s / (1.0 + s / (TAU * derivative_bandwidth.unwrap()));
            let filter = (1.0 + s / (TAU * observer_bandwidth.unwrap())).powi(-2);
            // An observer leaves the lag of a velocity source out: P_n = k/s.
            let model = believed / s;
            let response = plant.at(TAU * hertz).unwrap().of(feedback).unwrap();
            let expected = (pid + filter / model) / (1.0 - filter) * (-1e-3 * s).exp() * read * response;
            let found = looped.at(TAU * hertz).unwrap();
            assert!((found / expected - 1.0).norm() < 1e-12, "{feedback:?} {hertz}: {found} for {expected}");
            // What the force is, not what is read of it.
            let tracking = (pid + feed_forward) / (1.0 - filter) * response / (1.0 + expected);
            assert!((looped.tracking(TAU * hertz).unwrap() / tracking - 1.0).norm() < 1e-12);
        }
    }
    // In samples and over time an integral brings what is read to the reference: the force is k/k_believed times it.
    let integral = Controller::proportional(5.0 / believed).unwrap();
    for (feedback, rest) in
        [(Channel::InputForce, 1.0), (Channel::DeflectionForce, 1.25), (Channel::InductanceForce, 1.25)]
    {
        let plant = Plant::new(&stiff, Damping::Modal(0.02), drive, Environment::Held).unwrap();
        let looped = ForceLoop::new(plant, integral, feedback, 1e-3).unwrap().designed_for(believed).unwrap();
        let sampled = SampledLoop::new(&looped, 1e-3).unwrap();
        for run in [OverTime::sampled(&sampled).unwrap(), OverTime::continuous(&looped).unwrap()] {
            let steps = (8.0 / run.step()) as usize;
            let last = *run.run(1.0, 1.0, steps).unwrap().output.last().unwrap();
            assert!((last - rest).abs() < 1e-6, "{feedback:?}: {last} for {rest}");
        }
        // Its limit of stability is that of a loop on a spring that is known, times what is read.
        let known = ForceLoop::new(looped.plant().clone(), integral, feedback, 1e-3).unwrap();
        let limits =
            [&looped, &known].map(|looped| SampledLoop::new(looped, 1e-3).unwrap().margins().unwrap().gain_limit);
        assert_relative_eq!(limits[0], limits[1] * rest, max_relative = 1e-9);
    }
}
