//! The two ends over frequency as the page asks for them, held against the two-port, which knows no modes, and against the wire's own equations.
#![cfg(feature = "workshop")]

use coilsense::identify::Trust;
use coilsense::two_port::{Load, TwoPort};
use coilsense::{Damping, Spring};
use coilsense_lab::spec::Spec;
use coilsense_web::Engine;
use coilsense_web::answer::Answer;
use serde_json::Value;

const ANKLE: &str = include_str!("../../../examples/sea-ankle.toml");
const CAR: &str = include_str!("../../../examples/car-suspension.toml");
const ROAD: &str = include_str!("../../../examples/road-c-20mps.csv");

fn meta(answer: &Answer) -> Value {
    serde_json::from_str(&answer.meta()).unwrap()
}

fn spring(text: &str) -> Spring {
    let spec = Spec::parse("spec", text, &|_| Ok(ROAD.to_owned())).unwrap();
    spec.spring.spring
}

/// Size and phase of a number that an answer tells.
fn told(answer: &Value, name: &str) -> (f64, f64) {
    (answer[name][0].as_f64().unwrap(), answer[name][1].as_f64().unwrap())
}

#[test]
fn the_held_spring_lets_through_what_the_two_port_says() {
    let two_port = TwoPort::chain(&spring(ANKLE), Damping::Modal(0.005)).unwrap();
    let engine = Engine::new();
    for frequency in [1.0, 2.42, 20.0, 27.03, 54.06, 100.0, 200.0] {
        let found = meta(&engine.response_at(ANKLE, 0, 2, 1, frequency, 52).unwrap());
        let ends = two_port.at(std::f64::consts::TAU * frequency).unwrap();
        let through = ends.transmittance(&Load::HELD);
        // Sums over 52 modes keep 1e-11 of their largest term; F_i is a hundredth of that where it all but vanishes.
        let (size, phase) = told(&found, "through");
        assert!((size / through.norm() - 1.0).abs() < 1e-9, "{frequency}: {size} {}", through.norm());
        assert!((phase - through.arg()).sin().abs() < 1e-9);
        assert!((told(&found, "own").0 * 760.0 / ends.drive_point().norm() - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_curve_has_the_limits_and_the_peaks_of_the_wire() {
    let engine = Engine::new();
    let curve = engine.response(ANKLE, 0, 0, 1).unwrap();
    let found = meta(&curve);
    let trust = Trust::of(spring(ANKLE).transit_time(), 0.01).unwrap();
    // 52 masses for a wire: 1e-4 of these frequencies.
    for (name, limit) in [("through", trust.output_for_input), ("length", trust.deflection_for_input)] {
        let until = found["until"][name].as_f64().unwrap();
        assert!((until / limit - 1.0).abs() < 2e-4, "{name}: {until} {limit}");
    }
    // Undamped, F_i vanishes half way between the modes, and what it is divided into has no limit there.
    let peaks = found["peaks"].as_array().unwrap();
    assert_eq!(peaks.len(), 4);
    for (number, peak) in peaks.iter().enumerate() {
        let hertz = (number as f64 + 0.5) / (2.0 * spring(ANKLE).transit_time());
        assert!((peak[0].as_f64().unwrap() / hertz - 1.0).abs() < 5e-3, "{peak}");
        assert_eq!(peak[1], Value::Null);
    }
    assert_eq!(found["undamped"], true);
    let rising = curve.find("frequency").unwrap().windows(2).all(|two| two[0] < two[1]);
    assert!(rising && curve.find("through").unwrap().len() < 5000);
    // Damped, each has a top: what the two-port has there, and less on both sides. The wire's damping is that of its modes, between which it is small.
    let damped = meta(&engine.response(ANKLE, 0, 2, 1).unwrap());
    let two_port = TwoPort::chain(&spring(ANKLE), Damping::Modal(0.005)).unwrap();
    let through = |hertz: f64| two_port.at(std::f64::consts::TAU * hertz).unwrap().transmittance(&Load::HELD).norm();
    for peak in damped["peaks"].as_array().unwrap() {
        let (hertz, top) = (peak[0].as_f64().unwrap(), peak[1].as_f64().unwrap());
        assert!((top / through(hertz) - 1.0).abs() < 1e-9, "{peak}");
        // A thousandth of the frequency is some tenths of a half width.
        assert!(top > through(0.999 * hertz) && top > through(1.001 * hertz), "{peak}");
    }
    assert_eq!(damped["undamped"], false);
}

#[test]
fn the_coil_that_is_drawn_pulls_with_the_forces_that_are_told() {
    let mut car = Engine::new();
    car.add_file("road-c-20mps.csv".to_owned(), ROAD.to_owned());
    let sea = Engine::new();
    // A loop needs a mass there, which no question of this is about.
    let force =
        ANKLE.replace("end2 = \"held\"", "end2 = \"force\"").replace("[control]", "[control]\nload_mass = \"1 kg\"");
    for (engine, text, masses, damping) in [(&sea, ANKLE, 1, 2), (&sea, &force, 2, 0), (&car, CAR, 4, 0)] {
        let spring = spring(text).with_masses_per_winding(masses).unwrap();
        for frequency in [1.0, 30.0, 61.0] {
            let answer = engine.response_at(text, 0, damping, masses, frequency, 2000).unwrap();
            let found = meta(&answer);
            let (real, imaginary) = (answer.find("real").unwrap(), answer.find("imaginary").unwrap());
            let last = real.len() - 1;
            assert_eq!(last, spring.chain_masses() + 1);
            // An end segment is half as long as the others; where end 2 is pulled, motion is counted in m/N.
            let pull = |one: usize, two: usize| {
                let stretch = (real[two] - real[one]).hypot(imaginary[two] - imaginary[one]);
                let scale = if text == force { spring.stiffness() } else { 1.0 };
                2.0 * spring.chain_masses() as f64 * scale * stretch
            };
            let ends = [pull(0, 1), pull(last - 1, last)];
            let names = if found["driven"] == 2 { ["other", "own"] } else { ["own", "other"] };
            for (name, pull) in names.iter().zip(ends) {
                assert!((pull / told(&found, name).0 - 1.0).abs() < 1e-8, "{frequency} {name}: {pull}");
            }
            let apart = (real[last] - real[0]).hypot(imaginary[last] - imaginary[0]);
            let scale = if text == force { spring.stiffness() } else { 1.0 };
            assert!((scale * apart / told(&found, "byLength").0 - 1.0).abs() < 1e-9, "{frequency}");
        }
    }
}

#[test]
fn a_mass_at_end_2_takes_its_share_from_the_start() {
    let mut engine = Engine::new();
    engine.add_file("road-c-20mps.csv".to_owned(), ROAD.to_owned());
    let found = meta(&engine.response_at(CAR, 0, 0, 4, 0.01, 10).unwrap());
    let share = 325.0 / (325.0 + spring(CAR).mass());
    // The swing at 1.4 Hz adds (0.01/1.4)² times m/M.
    assert!((told(&found, "through").0 / share - 1.0).abs() < 1e-5);
    // On a mass of a tenth of that of the spring, the ends never agree.
    let light = CAR.replace("325 kg", "0.2 kg");
    assert_eq!(meta(&engine.response(&light, 0, 0, 4).unwrap())["until"]["through"], Value::Null);
}

#[test]
fn what_there_is_not_is_refused_in_a_line() {
    let engine = Engine::new();
    for (condition, damping, masses, frequency, places) in
        [(9, 0, 1, 1.0, 10), (0, 9, 1, 1.0, 10), (0, 0, 0, 1.0, 10), (0, 0, 1, 0.0, 10), (0, 0, 1, 1.0, 1)]
    {
        let refused = engine.response_at(ANKLE, condition, damping, masses, frequency, places).unwrap_err();
        assert!(!refused.is_empty() && !refused.contains('\n'), "{refused}");
    }
}
