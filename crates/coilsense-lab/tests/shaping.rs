//! What is left of ringing by shaped commands: closed forms on a chain of one mass, the exact motion, and what `mitigate` makes of a spec.
//!
//! Next door: filters and estimators (`mitigation`), the shapers by themselves (`coilsense`'s tests of its mitigation).

use coilsense::excitation::{EndInput, Sampled, Start};
use coilsense::mitigation::{SampledSpring, ToleranceBox, zero_vibration};
use coilsense::modes::ChainModes;
use coilsense::signals::sampled_window;
use coilsense::{Damping, Excitation, Motion, Spring, SpringParameters};
use coilsense_lab::mitigation::{Ranking, Request, Shaped, Study};
use coilsense_lab::report::{mitigation_json, mitigation_text};
use coilsense_lab::spec::Spec;
use std::f64::consts::PI;

/// S_T with one mass between its ends: one mode.
fn one_mass() -> Spring {
    Spring::new(SpringParameters { windings: 1.0, ..coilsense::paper::S_T }).unwrap()
}

/// Half a period of the mode is so many samples.
const HALF: f64 = 100.0;

fn rate(spring: &Spring) -> f64 {
    HALF * ChainModes::of(spring).frequencies()[0] / PI
}

fn answer() -> Ranking {
    let spring = one_mass();
    let dampings = vec![("undamped".to_owned(), Damping::None)];
    let rate = rate(&spring);
    let stated = Study::stated(&spring).unwrap();
    Study { dampings, nominal_damping: 0, rate, seeds: 1, bandwidth: 1.5, ..stated }.run().unwrap()
}

fn named<'a>(answer: &'a Ranking, name: &str) -> &'a Shaped {
    let shapers = &answer.shaping.as_ref().unwrap().shapers;
    shapers.iter().find(|shaped| shaped.name.starts_with(name)).unwrap()
}

#[test]
fn an_undamped_mode_rests_after_two_impulses_and_over_the_box_keeps_a_cosine() {
    let answer = answer();
    let (zv, zvd) = (named(&answer, "ZV,"), named(&answer, "ZVD,"));
    // Two halves, half a period apart: nothing but roundings of the angle.
    assert!(zv.first < 1e-12 && zvd.first < 1e-12, "{} {}", zv.first, zvd.first);
    // cos(π/2 · ω'/ω), ω'/ω = √(1.1/0.9) where k is 10 % more and m 10 % less, the farthest of the box; its square for three impulses.
    let left = (0.5 * PI * (1.1_f64 / 0.9).sqrt()).cos().abs();
    assert!((zv.first_worst - left).abs() < 1e-9 && (zvd.first_worst - left * left).abs() < 1e-9, "{}", zv.first_worst);
    assert_eq!(zv.worst_case, "k +10 %, m -10 %, undamped");
    // The mean of the impulses, and the last one.
    let samples = |time: f64| time * answer.study.rate;
    assert!((samples(zv.delay) - 0.5 * HALF).abs() < 1e-9 && (samples(zvd.delay) - HALF).abs() < 1e-9);
    // A whole delay may be a rounding short of whole; its share of the sample before or behind then counts as the last.
    assert!((samples(zv.length) - HALF).abs() <= 1.0 && (samples(zvd.length) - 2.0 * HALF).abs() <= 1.0);
    let plain = named(&answer, "the command, unshaped");
    assert!(plain.first == 1.0 && plain.delay == 0.0 && plain.settings().is_none() && zv.settings().is_some());
    // One mass has no other modes.
    assert_eq!(zv.higher_worst, 0.0);
}

/// The largest departure of F_i from the static force, from 0.05 s to 0.25 s after a step of 5 mm.
fn rings(spring: &Spring, rate: f64, mut shaped: impl FnMut(f64) -> f64) -> f64 {
    let times = sampled_window(rate, 0.0, 0.25).unwrap();
    let places: Vec<f64> = times.iter().map(|time| shaped(if *time > 0.01 { 0.005 } else { 0.0 })).collect();
    let drive = EndInput::Sampled(Sampled::new(times.clone(), places).unwrap());
    let excitation = Excitation::new(0.23, drive, EndInput::Held, Start::Rest).unwrap();
    let forces = Motion::new(spring, &excitation).unwrap().end_forces(&times).unwrap().input;
    let still = spring.static_force(0.225);
    let after = forces.iter().zip(&times).filter(|(_, time)| **time > 0.05);
    after.map(|(force, _)| (force - still).abs()).fold(0.0, f64::max)
}

#[test]
fn the_exact_motion_rings_as_is_foretold() {
    let nominal = one_mass();
    let rate = rate(&nominal);
    let zv = zero_vibration(&SampledSpring::new(&nominal, &Damping::None, rate).unwrap());
    let ratio = |spring: &Spring| {
        let mut state = zv.settled::<256>(0.0);
        rings(spring, rate, |x| zv.step(&mut state, x)) / rings(spring, rate, |x| x)
    };
    // A line from sample to sample is exact for this drive; what is left are roundings of 100 N.
    assert!(ratio(&nominal) < 1e-9, "{}", ratio(&nominal));
    let other = ToleranceBox::changed(&nominal, [0.1, -0.1]).unwrap();
    let predicted = named(&answer(), "ZV,").first_worst;
    // The peak lies between samples, at most half of one of 181 a period: (π/181)²/2.
    assert!((ratio(&other) / predicted - 1.0).abs() < 3e-4, "{} and {predicted}", ratio(&other));
}

#[test]
fn a_spec_whose_end_1_moves_is_told_to_shape_the_command_and_no_other() {
    let text = include_str!("../../../examples/sea-ankle.toml");
    let spec = Spec::parse("spec", text, &|_| Err("no files".to_owned())).unwrap();
    let asked = Request {
        rate: Some(2500.0),
        noise: None,
        bandwidth: None,
        stiffness_tolerance: Some(0.1),
        mass_tolerance: Some(0.1),
        most_lag: 30_f64.to_radians(),
        seeds: 1,
        length_at_zero: None,
        end2_held: None,
    };
    let study = Study::of(&spec, &asked).unwrap();
    let hit = Study { conditions: study.conditions[..1].to_vec(), ..study.clone() };
    let answer = Study { conditions: study.conditions[3..].to_vec(), ..study }.run().unwrap();
    let shaping = answer.shaping.as_ref().unwrap();
    assert_eq!(shaping.conditions, ["half resonance", "resonance"]);
    let (zv, ramp) = (named(&answer, "ZV,"), named(&answer, "mean over 2τ"));
    // Impulses half a period apart do nothing to mode 2; a mean over the period of all modes forgives 10 % as sin(0.1 π)/π does.
    assert!(zv.higher_worst > 0.9, "{}", zv.higher_worst);
    assert!(ramp.first < 0.01 && ramp.first_worst < 0.12 && ramp.higher_worst < 0.12, "{}", ramp.first_worst);
    assert_eq!(shaping.best().unwrap().name, ramp.name);
    assert!(mitigation_text(&answer).contains("Shape the command instead"));
    let told: serde_json::Value = serde_json::from_str(&mitigation_json(&answer).unwrap()).unwrap();
    assert_eq!(told["command_shaping"]["shapers"].as_array().unwrap().len(), 4);
    let hit = hit.run().unwrap();
    assert!(hit.shaping.is_none() && !mitigation_text(&hit).contains("Shape the command"));
}
