//! One motion, three ways to it: all equidistant times together, each time alone, step by step. And what they must refuse.

mod every_motion;
mod paper_springs;

use coilsense::excitation::Sampled;
use coilsense::motion::Live;
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, Start};
use every_motion::{dampings, motions, off, recording};
use paper_springs::s_t;
use proptest::prelude::*;

#[test]
fn together_alone_and_step_by_step_agree() {
    let (step, samples) = (1e-4, 6001);
    let times: Vec<f64> = (0..samples).map(|k| f64::from(k) * step).collect();
    for motion in motions() {
        let together = motion.end_forces(&times).unwrap();
        // In reverse order times are not equidistant steps forward, so each is evaluated alone.
        let backwards: Vec<f64> = times.iter().rev().copied().collect();
        let mut alone = motion.end_forces(&backwards).unwrap();
        alone.input.reverse();
        alone.output.reverse();
        let stream: Vec<_> = motion.stream(step).unwrap().take(times.len()).collect();
        let input: Vec<f64> = stream.iter().map(|sample| sample.input).collect();
        let output: Vec<f64> = stream.iter().map(|sample| sample.output).collect();
        for (what, ours, theirs) in [
            ("F_i alone", &alone.input, &together.input),
            ("F_o alone", &alone.output, &together.output),
            ("F_i stream", &input, &together.input),
            ("F_o stream", &output, &together.output),
        ] {
            let off = off(ours, theirs);
            // The last digit of a time, at the rate of the fastest mode: what no way of evaluating can know better.
            let tolerance = f64::max(1e-12, 2.0 * f64::EPSILON * times[times.len() - 1] * fastest_rate(&motion));
            assert!(off < tolerance, "{what} {off:e}: {:?} {:?}", motion.mount(), motion.excitation());
        }
    }
}

/// Highest frequency, or rate of decay where it is overdamped \[1/s\].
fn fastest_rate(motion: &Motion) -> f64 {
    let highest = motion.modes().frequencies().iter().fold(0.0_f64, |a, &b| a.max(b));
    match motion.mount().damping() {
        Damping::StiffnessProportional { time } => highest * f64::max(1.0, time * highest),
        _ => highest,
    }
}

#[test]
fn live_inputs_are_a_recording_taken_as_it_comes() {
    let spring = s_t();
    let step = 1.7e-4;
    for far_end in [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.1)] {
        let mount = Mount::new(far_end, Damping::Modal(0.01)).unwrap();
        let input = recording(3000, step);
        // Half the same at end 2: as metres, or as a force.
        let scale = if far_end == FarEnd::Position { 0.5 } else { 0.5 * spring.stiffness() };
        let knots: Vec<f64> = (0..3000).map(|k| f64::from(k) * step).collect();
        let values = knots.iter().map(|&t| scale * input.displacement(t)).collect();
        let second = EndInput::Sampled(Sampled::new(knots, values).unwrap());
        let excitation = Excitation::new(0.23, input.clone(), second.clone(), Start::Rest).unwrap();
        let motion = Motion::mounted(&spring, &mount, &excitation).unwrap();
        let mut live = Live::new(&spring, &mount, 0.23, step).unwrap();
        let times: Vec<f64> = (1..3000).map(|k| f64::from(k) * step).collect();
        let batch = motion.end_forces(&times).unwrap();
        let samples: Vec<_> =
            times.iter().map(|&t| live.advance([input.displacement(t), second.displacement(t)]).unwrap()).collect();
        let force = |of: fn(&coilsense::motion::ForceSample) -> f64| samples.iter().map(of).collect::<Vec<f64>>();
        // Live starts from rest before the first slope; a start at rest under a moving end is the same thing.
        assert!(off(&force(|sample| sample.input), &batch.input) < 1e-12);
        assert!(off(&force(|sample| sample.output), &batch.output) < 1e-12);
        assert_eq!(live.advance([f64::NAN, 0.0]).unwrap_err().to_string(), "input 1 must be finite, got NaN m");
    }
}

#[test]
fn forces_are_the_strain_of_the_end_segments_on_every_mount() {
    let spring = s_t();
    let n = spring.chain_masses() as f64;
    let (segment, rest) = (2.0 * n * spring.stiffness(), 0.5 * spring.rest_length() / n);
    for motion in motions().into_iter().filter(|motion| *motion.spring() == spring) {
        if matches!(motion.mount().damping(), Damping::StiffnessProportional { .. }) {
            continue; // there the dashpot pulls too
        }
        let times = [0.0, 0.07, 0.3, 0.600_01];
        let (forces, windings) = (motion.end_forces(&times).unwrap(), motion.windings(&times).unwrap());
        for sample in 0..times.len() {
            let ([u1, u2], row) = (windings.ends(sample), windings.row(sample));
            let strain = [row[0] - u1 - rest, u2 - row[row.len() - 1] - rest].map(|stretch| segment * stretch);
            // 2Nk of 8e4 N/m times the rounding of a position of 0.3 m.
            assert!((forces.input[sample] - strain[0]).abs() < 2e-11, "{:?}", motion.excitation());
            assert!((forces.output[sample] - strain[1]).abs() < 2e-11, "{:?}", motion.excitation());
        }
    }
}

#[test]
fn a_spring_carried_along_feels_no_damping() {
    // Both ends move alike at a constant speed, and so do the windings: nothing rings, whatever the damping.
    let spring = s_t();
    let drift = EndInput::Ramp { height: 0.5, from: 0.0, duration: 1.0 };
    for damping in dampings() {
        let excitation = Excitation::new(0.23, drift.clone(), drift.clone(), Start::Massless).unwrap();
        let mount = Mount::new(FarEnd::Position, damping).unwrap();
        let forces = Motion::mounted(&spring, &mount, &excitation).unwrap().end_forces(&[0.3, 0.9]).unwrap();
        for force in forces.input.iter().chain(&forces.output) {
            assert!((force - spring.static_force(0.23)).abs() < 1e-10);
        }
    }
}

#[test]
fn recordings_that_cannot_be_are_refused_by_index_and_value() {
    let says = |times: Vec<f64>, values: Vec<f64>| Sampled::new(times, values).unwrap_err().to_string();
    assert_eq!(says(vec![], vec![]), "sample times must hold at least 1 values, got 0");
    assert_eq!(says(vec![0.0, 1.0], vec![0.0]), "sample values must hold 2 values, got 1");
    assert_eq!(says(vec![0.0, f64::NAN], vec![0.0; 2]), "sample time[1] must be finite, got NaN s");
    assert_eq!(says(vec![0.0, 1.0], vec![0.0, f64::INFINITY]), "sample value[1] must be finite, got inf");
    assert_eq!(says(vec![1.0, 0.5], vec![0.0; 2]), "sample time[1] must be above its predecessor of 1 s, got 0.5 s");
}

#[test]
fn mounts_that_cannot_be_are_refused() {
    let says = |far_end, damping| Mount::new(far_end, damping).unwrap_err().to_string();
    assert_eq!(says(FarEnd::Mass(0.0), Damping::None), "end mass must be above zero and finite, got 0 kg");
    assert_eq!(
        says(FarEnd::Force, Damping::ModalEach(vec![0.1, -1.0])),
        "damping ratio[1] must be finite and not below zero, got -1"
    );
    let excitation = Excitation::impact(0.23, 0.25).unwrap();
    let refused = |damping| {
        let mount = Mount::new(FarEnd::Position, damping).unwrap();
        Motion::mounted(&s_t(), &mount, &excitation).unwrap_err().to_string()
    };
    assert_eq!(refused(Damping::Modal(1e200)).split(',').next(), Some("damping ratio of mode 1 must be at most 1000"));
    assert_eq!(refused(Damping::ModalEach(vec![0.1; 3])), "damping ratios must hold 52 values, got 3");
    assert!(
        refused(Damping::Hysteretic { loss_factor: 0.1 })
            .starts_with("loss factor must be zero for a motion over time")
    );
}

#[test]
fn curved_inputs_are_followed_exactly_however_overdamped_the_modes_are() {
    let spring = s_t();
    for time in [3e-4, 3e-3, 2e-2] {
        let input = EndInput::Chirp { amplitude: 1e-3, from: 0.0, to: 100.0, duration: 1.0, phase: 0.0 };
        let excitation = Excitation::new(0.23, input, EndInput::Held, Start::Rest).unwrap();
        let mount = Mount::new(FarEnd::Position, Damping::StiffnessProportional { time }).unwrap();
        let motion = Motion::mounted(&spring, &mount, &excitation).unwrap();
        // A step that is no multiple of the other: nothing is shared but the moments compared.
        let coarse: Vec<f64> = motion.stream(1e-3).unwrap().take(301).map(|sample| sample.input).collect();
        let fine: Vec<f64> =
            motion.stream(1e-3 / 7.0).unwrap().step_by(7).take(301).map(|sample| sample.input).collect();
        let rate = fastest_rate(&motion);
        assert!(
            off(&coarse, &fine) < f64::max(1e-12, 4.0 * f64::EPSILON * 0.3 * rate),
            "{time}: {:e}",
            off(&coarse, &fine)
        );
    }
}

#[test]
fn half_a_sine_on_a_mode_leaves_a_motion_that_no_longer_grows() {
    // Its period is that of mode 20: while it lasts the mode's answer is secular, afterwards it swings freely for a thousand seconds.
    let spring = s_t();
    let mode = coilsense::modes::ChainModes::of(&spring).frequencies()[19];
    let input = EndInput::HalfSine { height: 1e-3, from: 0.01, duration: std::f64::consts::PI / mode };
    let excitation = Excitation::new(0.23, input, EndInput::Held, Start::Rest).unwrap();
    let motion = Motion::new(&spring, &excitation).unwrap();
    let times: Vec<f64> = (0..100).map(|k| 1000.0 + 1e-4 * f64::from(k)).collect();
    let together = motion.end_forces(&times).unwrap().input;
    let alone: Vec<f64> = times.iter().map(|&time| motion.end_forces(&[time]).unwrap().input[0]).collect();
    // Phases of 1e7 radians, at 1e-16 of them each: 1e-9.
    assert!(off(&together, &alone) < 1e-8, "{:e}", off(&together, &alone));
    assert!((motion.energy(1000.0).unwrap() / motion.energy(1.0).unwrap() - 1.0).abs() < 1e-9);
}

#[test]
fn velocities_at_a_jump_are_those_just_after_it() {
    let spring = s_t();
    let excitation = Excitation::new(0.23, recording(100, 1e-3), EndInput::Held, Start::Rest).unwrap();
    let motion = Motion::new(&spring, &excitation).unwrap();
    for knot in [0.0, 0.02, 0.05] {
        let (at, after) = (motion.velocities(knot).unwrap(), motion.velocities(knot + 1e-9).unwrap());
        // Accelerations reach 1e4 m/s² at most.
        assert!(at.iter().zip(&after).all(|(at, after)| (at - after).abs() < 1e-4), "{knot}");
    }
}

#[test]
fn forces_exactly_at_a_step_hold_the_step_on_every_path() {
    let spring = s_t();
    // A chirp on the other end keeps the motion on the march.
    let chirp = EndInput::Chirp { amplitude: 1e-6, from: 1.0, to: 2.0, duration: 1.0, phase: 0.0 };
    let step = EndInput::Step { height: 1e-3, at: 0.1 };
    let excitation = Excitation::new(0.23, chirp, step, Start::Rest).unwrap();
    let motion = Motion::new(&spring, &excitation).unwrap();
    let forces = motion.end_forces(&[0.0999, 0.1, 0.1 + 1e-9]).unwrap();
    // Only end 2's half segment stretches at once: 2Nk times the step; the far end feels nothing yet.
    let jump = 2.0 * 52.0 * 760.0 * 1e-3;
    assert!((forces.output[1] - forces.output[0] - jump).abs() < 1e-2 * jump, "{forces:?}");
    assert!(
        (forces.output[2] - forces.output[1]).abs() < 1e-3 * jump && (forces.input[1] - forces.input[0]).abs() < 1.0
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever numbers come in, the answer is an error or finite forces.
    #[test]
    fn no_input_gives_a_panic_or_a_silent_nan(
        kind in 0_usize..7,
        a in prop::num::f64::ANY,
        b in prop::num::f64::ANY,
        c in prop_oneof![prop::num::f64::ANY, 0.01_f64..1.0],
        windings in 1_u32..40,
        mass in prop_oneof![prop::num::f64::ANY, 0.01_f64..1.0],
        damping in 0_usize..9,
    ) {
        let input = match kind {
            0 => EndInput::Held,
            1 => EndInput::harmonic(a, b, c),
            2 => EndInput::Chirp { amplitude: a, from: b, to: c, duration: 0.05, phase: 0.0 },
            3 => EndInput::Step { height: a, at: b },
            4 => EndInput::Ramp { height: a, from: b, duration: c },
            5 => EndInput::HalfSine { height: a, from: b, duration: c },
            _ => match Sampled::new(vec![0.0, b, c], vec![a, b, c]) {
                Ok(sampled) => EndInput::Sampled(sampled),
                Err(_) => EndInput::Held,
            },
        };
        let mut parameters = s_t().parameters().clone();
        parameters.windings = f64::from(windings);
        let spring = Spring::new(parameters).unwrap();
        let far_end = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(mass)][kind % 3];
        let damping = match damping {
            6 => Damping::Modal(c),
            7 => Damping::MassProportional { rate: c },
            8 => Damping::StiffnessProportional { time: c },
            known => dampings()[known].clone(),
        };
        let made = Mount::new(far_end, damping)
            .and_then(|mount| Ok((mount, Excitation::new(0.23, input.clone(), input, Start::Rest)?)))
            .and_then(|(mount, excitation)| Motion::mounted(&spring, &mount, &excitation));
        if let Ok(motion) = made {
            match motion.end_forces(&[0.0, 0.01, 0.06]) {
                Ok(forces) => prop_assert!(forces.input.iter().chain(&forces.output).all(|force| force.is_finite())),
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
        }
    }
}
