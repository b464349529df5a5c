//! Laws of physics that the exact motion must keep, whatever a reference says.

mod paper_springs;

use approx::assert_relative_eq;
use coilsense::{End, EndInput, Excitation, Motion, Spring, Start, VelocityProfile};
use paper_springs::{s_a, s_t, s_t_with};

fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |peak, value| peak.max(value.abs()))
}

fn times() -> Vec<f64> {
    coilsense::signals::sampled_window(2_000.0, 0.0, 1.0).unwrap()
}

#[test]
fn energy_is_constant_while_both_ends_are_held() {
    for spring in [s_t(), s_a()] {
        let impact = Excitation::impact(spring.mid_length(), 0.25).unwrap();
        let stop = Excitation::end_stop(spring.operating_range().0, -0.1, VelocityProfile::Linear).unwrap();
        for excitation in [impact, stop] {
            let motion = Motion::new(&spring, &excitation).unwrap();
            let at_start = motion.energy(0.0).unwrap();
            for time in [0.1, 0.333, 0.5, 0.99, 1.0] {
                // Rounding of positions: 1e-16 of a length against deflections of a thousandth of it.
                assert_relative_eq!(motion.energy(time).unwrap(), at_start, max_relative = 1e-12);
            }
        }
    }
}

#[test]
fn an_impact_starts_with_its_kinetic_energy() {
    let spring = s_t();
    let motion = Motion::new(&spring, &Excitation::impact(spring.rest_length(), 0.25).unwrap()).unwrap();
    let kinetic = 0.5 * spring.mass() * 0.25 * 0.25;
    assert_relative_eq!(motion.energy(0.0).unwrap(), kinetic, max_relative = 1e-12);
}

#[test]
fn mirrored_inputs_give_mirrored_forces() {
    let spring = s_t();
    let input = EndInput::harmonic(1e-3, 20.0, 0.3);
    let mirrored = EndInput::harmonic(-1e-3, 20.0, 0.3);
    let one = Excitation::harmonic(0.23, End::One, input, Start::Rest).unwrap();
    let two = Excitation::harmonic(0.23, End::Two, mirrored, Start::Rest).unwrap();
    let times = times();
    let from_one = Motion::new(&spring, &one).unwrap().end_forces(&times).unwrap();
    let from_two = Motion::new(&spring, &two).unwrap().end_forces(&times).unwrap();
    let tolerance = 1e-12 * peak(&from_one.input); // rounding of some fifty modes
    for sample in 0..times.len() {
        assert!((from_one.input[sample] - from_two.output[sample]).abs() < tolerance);
        assert!((from_one.output[sample] - from_two.input[sample]).abs() < tolerance);
    }
}

#[test]
fn inputs_superpose() {
    let spring = s_a();
    let one = EndInput::harmonic(1e-4, 150.0, 0.3);
    let two = EndInput::harmonic(2e-4, 330.0, -1.0);
    let held = EndInput::Held;
    let forces = |end1: &EndInput, end2: &EndInput| {
        let excitation = Excitation::new(0.1, end1.clone(), end2.clone(), Start::Rest).unwrap();
        Motion::new(&spring, &excitation).unwrap().end_forces(&times()).unwrap()
    };
    let (both, first, second) = (forces(&one, &two), forces(&one, &held), forces(&held, &two));
    let constant = spring.static_force(0.1);
    let tolerance = 1e-11 * peak(&both.output); // near-resonant parts of a thousand times their sum
    for sample in 0..both.output.len() {
        let sum = first.output[sample] + second.output[sample] - constant;
        assert!((both.output[sample] - sum).abs() < tolerance);
    }
}

#[test]
fn the_difference_of_the_end_forces_accelerates_the_coil() {
    // Newton: F_o − F_i = m · acceleration of the mean winding, the latter by a second difference of order 2.
    let spring = s_t();
    let input = EndInput::harmonic(1e-3, 40.0, 0.0);
    let excitation = Excitation::harmonic(0.23, End::One, input, Start::Rest).unwrap();
    let motion = Motion::new(&spring, &excitation).unwrap();
    let time = 0.4321;
    let mean = |t: f64| -> f64 {
        let windings = motion.windings(&[t]).unwrap();
        windings.row(0).iter().sum::<f64>() / windings.count() as f64
    };
    let forces = motion.end_forces(&[time]).unwrap();
    let error = |step: f64| {
        let acceleration = (mean(time + step) - 2.0 * mean(time) + mean(time - step)) / (step * step);
        (spring.mass() * acceleration - (forces.output[0] - forces.input[0])).abs()
    };
    let (coarse, fine) = (error(2e-5), error(1e-5));
    assert!(fine < 1e-3 && (3.5..4.5).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
}

#[test]
fn work_at_the_driven_end_becomes_energy() {
    let spring = s_t();
    let input = EndInput::harmonic(1e-3, 40.0, 0.0);
    let excitation = Excitation::harmonic(0.23, End::One, input.clone(), Start::Massless).unwrap();
    let motion = Motion::new(&spring, &excitation).unwrap();
    // Simpson's rule over 0.1 s; the spring pulls end 1 with +F_i, so the end does the work −F_i u̇1 on it.
    let count = 20_000;
    let times: Vec<f64> = (0..=count).map(|k| 0.1 * f64::from(k) / f64::from(count)).collect();
    let forces = motion.end_forces(&times).unwrap();
    let power = |k: usize| -forces.input[k] * input.velocity(times[k]);
    let weight = |k: usize| match k {
        0 => 1.0,
        k if k == times.len() - 1 => 1.0,
        k if k % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let work: f64 = (0..times.len()).map(|k| weight(k) * power(k)).sum::<f64>() * 0.1 / f64::from(count) / 3.0;
    let gained = motion.energy(0.1).unwrap() - motion.energy(0.0).unwrap();
    assert_relative_eq!(work, gained, max_relative = 1e-8); // Simpson over the highest mode's period
}

#[test]
fn an_impact_carries_the_wave_impedance() {
    // N → ∞: until the wave comes back the end forces are shifted by ∓ v √(km), as a constant.
    let velocity = 0.25;
    let mut errors = Vec::new();
    for windings in [50.0, 200.0, 800.0] {
        let spring = Spring::new(s_t_with(|p| p.windings = windings)).unwrap();
        let motion = Motion::new(&spring, &Excitation::impact(0.23, velocity).unwrap()).unwrap();
        // The mean over the middle half of the first transit: the chain rings about the plateau at its cut-off.
        let tau = spring.transit_time();
        let times: Vec<f64> = (0..400).map(|k| tau * (0.25 + 0.5 * f64::from(k) / 400.0)).collect();
        let forces = motion.end_forces(&times).unwrap();
        let rise = velocity * spring.wave_impedance();
        let constant = spring.static_force(0.23);
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64 - constant;
        errors.push((mean(&forces.input) / rise - 1.0).abs());
        errors.push((mean(&forces.output) / rise + 1.0).abs());
    }
    assert!(errors[0] < 0.02 && errors[4] < 0.002, "{errors:?}");
    assert!(errors[4] < errors[0], "no convergence: {errors:?}");
}

#[test]
fn a_slow_drive_moves_the_spring_as_if_it_had_no_mass() {
    let spring = s_t();
    let input = EndInput::harmonic(1e-3, 0.05, 0.0);
    let excitation = Excitation::harmonic(0.23, End::Two, input, Start::Massless).unwrap();
    let motion = Motion::new(&spring, &excitation).unwrap();
    let forces = motion.end_forces(&[0.5, 1.0]).unwrap();
    let [u1, u2] = motion.ends(&[1.0]).unwrap()[0];
    // Inertia is (f/f1)² of the force swing: 1e-6 · 0.76 N.
    assert_relative_eq!(forces.input[1], spring.static_force(u2 - u1), epsilon = 2e-6);
    assert_relative_eq!(forces.output[1], spring.static_force(u2 - u1), epsilon = 2e-6);
}

#[test]
fn on_a_mode_the_answer_grows_without_bound_and_stays_smooth_in_frequency() {
    let spring = s_t();
    let mode = coilsense::modes::ChainModes::of(&spring).frequencies()[2] / std::f64::consts::TAU;
    let force_at = |frequency: f64, time: f64| {
        let input = EndInput::harmonic(1e-5, frequency, 0.7);
        let excitation = Excitation::harmonic(0.23, End::One, input, Start::Rest).unwrap();
        Motion::new(&spring, &excitation).unwrap().end_forces(&[time]).unwrap().output[0]
    };
    let constant = spring.static_force(0.23);
    let swing = |from: f64| {
        let period = 1.0 / mode;
        (0..100).map(|k| (force_at(mode, from + period * f64::from(k) / 100.0) - constant).abs()).fold(0.0, f64::max)
    };
    assert_relative_eq!(swing(2.0) / swing(1.0), 2.0, max_relative = 0.02); // grows as t, other modes beside
    // A frequency that is off by 1e-12 changes the answer by no more than 1e-12 · ωt of it: no spike at resonance.
    let (on, off) = (force_at(mode, 1.234), force_at(mode * (1.0 + 1e-12), 1.234));
    assert_relative_eq!(on, off, max_relative = 1e-8);
}

#[test]
fn the_motion_can_be_asked_at_any_times_in_any_order() {
    let spring = s_t();
    let motion = Motion::new(&spring, &Excitation::impact(0.23, 0.25).unwrap()).unwrap();
    let forward = motion.end_forces(&[0.1, 0.2, 0.9]).unwrap();
    let backward = motion.end_forces(&[0.9, 0.2, 0.1]).unwrap();
    assert_eq!(forward.input[0], backward.input[2]);
    assert_eq!(forward.output[2], backward.output[0]);
}

#[test]
fn end_forces_are_the_strain_of_the_end_segments() {
    let spring = s_a();
    let motion = Motion::new(&spring, &Excitation::impact(0.1, 0.25).unwrap()).unwrap();
    let times = [0.0, 0.01, 0.5, 1.0];
    let (forces, windings) = (motion.end_forces(&times).unwrap(), motion.windings(&times).unwrap());
    let n = windings.count() as f64;
    let (end_stiffness, rest) = (2.0 * n * spring.stiffness(), 0.5 * spring.rest_length() / n);
    for sample in 0..times.len() {
        let ([u1, u2], row) = (windings.ends(sample), windings.row(sample));
        // 2Nk times the rounding of a position.
        let tolerance = end_stiffness * 1e-16;
        assert!((forces.input[sample] - end_stiffness * (row[0] - u1 - rest)).abs() < tolerance);
        assert!((forces.output[sample] - end_stiffness * (u2 - row[row.len() - 1] - rest)).abs() < tolerance);
    }
}
