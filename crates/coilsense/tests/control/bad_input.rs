//! What a loop refuses, in words.

use coilsense::control::{Controller, Drive, Environment, ForceLoop, Gains, Plant, SampledLoop, simulate};
use coilsense::{Channel, Damping};

use crate::integral_loop;
use crate::paper_springs::s_t;

fn plant(damping: Damping, drive: Drive, environment: Environment) -> String {
    Plant::new(&s_t(), damping, drive, environment).unwrap_err().to_string()
}

#[test]
fn plants_name_what_is_wrong() {
    let held = Environment::Held;
    assert_eq!(
        plant(Damping::Modal(0.01), Drive::Velocity { bandwidth: Some(0.0) }, held),
        "drive bandwidth must be above zero and finite, got 0 Hz"
    );
    let motor = Drive::Force { mass: -1.0, friction: 0.0, bandwidth: None };
    assert_eq!(plant(Damping::None, motor, held), "motor mass must be above zero and finite, got -1 kg");
    let light = Environment::Impedance { mass: f64::NAN, damping: 0.0, stiffness: 0.0 };
    assert_eq!(
        plant(Damping::None, Drive::IDEAL_VELOCITY, light),
        "load mass must be finite and not below zero, got NaN kg"
    );
    assert!(
        plant(Damping::Hysteretic { loss_factor: 0.1 }, Drive::IDEAL_VELOCITY, held).starts_with("loss factor must be")
    );
}

#[test]
fn controllers_and_loops_name_what_is_wrong() {
    let controller = |gains| Controller::new(gains).unwrap_err().to_string();
    assert_eq!(
        controller(Gains::default()),
        "integral gain must be above zero where no other gain closes the loop, got 0"
    );
    assert_eq!(
        controller(Gains { derivative: 1.0, ..Gains::default() }),
        "derivative gain must be zero without a derivative bandwidth, got 1"
    );
    let base = integral_loop(0.01, Channel::InputForce, 0.0);
    let looped = |channel, delay| ForceLoop::new(base.plant().clone(), *base.controller(), channel, delay);
    assert_eq!(looped(Channel::U1, 0.0).unwrap_err().to_string(), "signal u1 is missing");
    assert!(looped(Channel::InputForce, -1.0).unwrap_err().to_string().starts_with("loop delay must be"));
    assert_eq!(
        base.clone().designed_for(0.0).unwrap_err().to_string(),
        "designed stiffness must be above zero and finite, got 0 N/m"
    );
    assert!(base.at(0.0).unwrap_err().to_string().starts_with("angular frequency must be above zero"));
}

#[test]
fn sampled_loops_name_what_is_wrong() {
    let base = integral_loop(0.01, Channel::InputForce, 1e-3);
    let message = |step: f64| SampledLoop::new(&base, step).unwrap_err().to_string();
    assert!(
        message(0.02).starts_with("half the sample rate must be above the surge frequency of 54.06"),
        "{}",
        message(0.02)
    );
    assert_eq!(message(3e-4), "loop delay must be a whole number of sample times of 0.0003 s, got 0.001 s");
    let sampled = SampledLoop::new(&base, 5e-4).unwrap();
    assert!(simulate(&sampled, f64::NAN, 1.0, 10).unwrap_err().to_string().starts_with("gain factor must be"));
    assert!(sampled.at(1e5).unwrap_err().to_string().starts_with("angular frequency must be above zero and at most"));
}
