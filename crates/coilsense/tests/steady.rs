//! A steady start: the motion that sines leave after a long time.

mod paper_springs;

use std::f64::consts::TAU;

use coilsense::excitation::Harmonic;
use coilsense::two_port::TwoPort;
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Start};
use paper_springs::s_t;

const PERIOD: f64 = 0.445 / 12.0;

/// 12 periods in 445 ms and their second harmonic, which meets the first mode.
fn distorted_sine() -> EndInput {
    let sine = |amplitude, number: f64, phase| Harmonic { amplitude, frequency: number / PERIOD, phase };
    EndInput::Harmonics(vec![sine(1e-3, 1.0, 0.7), sine(2e-5, 2.0, 1.4)])
}

fn motion(far_end: FarEnd, damping: Damping, start: Start) -> Motion {
    let excitation = Excitation::new(0.14, distorted_sine(), EndInput::Held, start).unwrap();
    Motion::mounted(&s_t(), &Mount::new(far_end, damping).unwrap(), &excitation).unwrap()
}

#[test]
fn every_period_is_like_the_first() {
    for damping in [Damping::None, Damping::Modal(0.005), Damping::StiffnessProportional { time: 2e-5 }] {
        for far_end in [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.3)] {
            let motion = motion(far_end, damping.clone(), Start::Steady);
            let at = |period: f64| {
                let times: Vec<f64> = (0..50).map(|index| PERIOD * (period + f64::from(index) / 50.0)).collect();
                motion.end_forces(&times).unwrap()
            };
            let (first, late) = (at(0.0), at(200.0));
            let peak = first.input.iter().chain(&first.output).fold(0.0, |peak: f64, force| peak.max(force.abs()));
            for (a, b) in first.input.iter().chain(&first.output).zip(late.input.iter().chain(&late.output)) {
                // Phases of the highest mode, 1800 Hz, are 1e5 rad after 200 periods: 2e-11 of rounding on what is near resonance.
                assert!((a - b).abs() < 1e-10 * peak, "{damping:?} {far_end:?}: {a} and {b} of {peak}");
            }
        }
    }
}

#[test]
fn a_long_wait_ends_in_the_steady_state() {
    let (steady, waiting) = (
        motion(FarEnd::Position, Damping::Modal(0.01), Start::Steady),
        motion(FarEnd::Position, Damping::Modal(0.01), Start::Rest),
    );
    // 270 whole periods are 10 s, in which the slowest mode decays by e^(−0.01·340·10) = 2e-15.
    let times: Vec<f64> = (0..80).map(|index| 270.0 * PERIOD + 1e-3 * f64::from(index)).collect();
    let [now, then] = [&steady, &waiting].map(|motion| motion.end_forces(&times).unwrap().output);
    for (a, b) in now.iter().zip(&then) {
        assert!((a - b).abs() < 1e-10, "{a} and {b}");
    }
}

#[test]
fn its_forces_are_those_of_the_two_port() {
    let damping = Damping::Modal(0.005);
    let motion = motion(FarEnd::Position, damping.clone(), Start::Steady);
    let port = TwoPort::chain(&s_t(), damping).unwrap();
    let times: Vec<f64> = (0..400).map(|index| 0.3e-3 * f64::from(index)).collect();
    let forces = motion.end_forces(&times).unwrap();
    for (index, &time) in times.iter().enumerate() {
        let (mut input, mut output) = (s_t().static_force(0.14), s_t().static_force(0.14));
        for (amplitude, number, phase) in [(1e-3, 1.0, 0.7), (2e-5, 2.0, 1.4)] {
            let omega = TAU * number / PERIOD;
            let swing = num_complex::Complex64::from_polar(amplitude, omega * time + phase);
            let at = port.at(omega).unwrap();
            input -= (at.drive_point() * swing).im;
            output -= (at.transfer() * swing).im;
        }
        // 1e-10 of the peak, as both take differences near a resonance.
        assert!((forces.input[index] - input).abs() < 3e-9, "{} and {input}", forces.input[index]);
        assert!((forces.output[index] - output).abs() < 3e-9, "{} and {output}", forces.output[index]);
    }
}

#[test]
fn what_never_settles_is_refused() {
    let held = EndInput::Held;
    let ramp = EndInput::Ramp { height: 1e-3, from: 0.0, duration: 0.1 };
    let error = Excitation::new(0.14, ramp, held.clone(), Start::Steady).unwrap_err().to_string();
    assert_eq!(error, "inputs of a steady start that are no sines must be 0, got 1");
    let spring = s_t();
    let mode = coilsense::modes::ChainModes::of(&spring).frequencies()[0];
    // The nearest double whose 2π-fold is the mode's own frequency; one of three neighbours is.
    let exact = [mode / TAU, (mode / TAU).next_up(), (mode / TAU).next_down()].into_iter().find(|f| TAU * f == mode);
    let input = EndInput::harmonic(1e-3, exact.expect("a double"), 0.0);
    let excitation = Excitation::new(0.14, input, held, Start::Steady).unwrap();
    let error = Motion::new(&spring, &excitation).unwrap_err().to_string();
    assert!(error.starts_with("frequency of a sine at the undamped mode 1 must be off that mode's"), "{error}");
}

#[test]
fn relaxation_counts_decades_from_the_age_of_the_preload() {
    let relaxation = coilsense::relaxation::Relaxation::new(1e-3, 50.0).unwrap();
    for (time, decades) in [(0.0, 0.0), (450.0, 1.0), (4950.0, 2.0)] {
        // A few roundings of a logarithm.
        assert!((relaxation.lost_share(time) - 1e-3 * decades).abs() < 1e-17);
    }
    assert!(coilsense::relaxation::Relaxation::new(1e-3, 0.0).is_err());
    assert!(coilsense::relaxation::Relaxation::new(1.5, 1.0).is_err());
}
