//! L of many samples at once, against the sum over the turns of each sample alone.

mod every_motion;
mod paper_springs;

use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::motion::Windings;
use coilsense::signals::sampled_window;
use coilsense::{EndInput, Excitation, Motion, Spring, Start, VelocityProfile};
use every_motion::motions;
use paper_springs::{s_t, s_t_with};

/// The coil of a spring.
fn coil(spring: &Spring) -> MaxwellSum {
    MaxwellSum::new(spring, SelfDistance::AsPrinted)
}

/// Each sample by itself: a series of one sample is summed turn by turn.
fn one_by_one(coil: &MaxwellSum, windings: &Windings) -> Vec<f64> {
    let one = |sample| Windings::new(vec![windings.ends(sample)], windings.row(sample).to_vec()).unwrap();
    (0..windings.samples()).map(|sample| coil.series(&one(sample))[0]).collect()
}

/// The largest relative difference.
fn off(ours: &[f64], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    ours.iter().zip(theirs).fold(0.0, |worst: f64, (a, b)| worst.max((a / b - 1.0).abs()))
}

/// S_T hit, driven at its resonance until neighbours come and go by a tenth, and moved slowly and far.
fn ways(spring: &Spring) -> Vec<Motion> {
    let driven = |amplitude, frequency| {
        let input = EndInput::harmonic(amplitude, frequency, -1.0);
        Excitation::new(0.23, input, EndInput::Held, Start::Massless).unwrap()
    };
    let hit = Excitation::end_stop(0.23, 3.0, VelocityProfile::Linear).unwrap();
    let all =
        [Excitation::impact(0.23, 0.25).unwrap(), hit, driven(68e-6, spring.surge_frequency()), driven(0.03, 3.0)];
    all.iter().map(|excitation| Motion::new(spring, excitation).unwrap()).collect()
}

#[test]
fn a_series_is_the_sum_over_the_turns_of_each_of_its_samples() {
    let whole = s_t();
    let fraction = Spring::new(s_t_with(|p| p.inductance_windings = Some(49.3))).unwrap();
    let times = sampled_window(10_000.0, 0.9, 1.0).unwrap();
    for spring in [whole, fraction] {
        let coil = coil(&spring);
        for motion in ways(&spring) {
            let windings = motion.windings(&times).unwrap();
            let (series, alone) = (coil.series(&windings), one_by_one(&coil, &windings));
            // Either is off by 2e-15 of the true sum, and distances of 4 mm between positions of 0.2 m by 1e-14 each.
            assert!(off(&series, &alone) < 5e-15, "{:?}: {:e}", motion.excitation(), off(&series, &alone));
            let along = coil.along(&motion, &times, 0.0).unwrap();
            assert_eq!((along.second_order, along.exact), (0, times.len()));
            let along: Vec<f64> = along.samples.iter().map(|sample| sample.inductance).collect();
            assert!(off(&along, &alone) < 5e-15, "{:?}: {:e}", motion.excitation(), off(&along, &alone));
        }
    }
}

#[test]
fn a_bounded_series_is_within_its_bounds_and_its_tolerance_however_it_comes_about() {
    let spring = s_t();
    let coil = coil(&spring);
    let times = sampled_window(10_000.0, 0.75, 1.0).unwrap();
    for motion in ways(&spring) {
        let windings = motion.windings(&times).unwrap();
        let exact = coil.series(&windings);
        for tolerance in [1e-9, 1e-6, 1e-3] {
            let of_positions = coil.series_within(&windings, tolerance).unwrap();
            let along = coil.along(&motion, &times, tolerance).unwrap();
            for series in [&of_positions, &along] {
                assert_eq!(series.second_order + series.exact, times.len());
                for (ours, exact) in series.samples.iter().zip(&exact) {
                    assert!((ours.inductance - exact).abs() <= ours.bound, "{:?}", motion.excitation());
                    assert!(ours.bound <= tolerance.max(1e-14) * ours.inductance, "{tolerance}");
                }
            }
            // Both see the same turns: only samples whose bound is just the tolerance may go either way.
            assert!(along.exact.abs_diff(of_positions.exact) <= 2, "{} {}", along.exact, of_positions.exact);
        }
    }
}

#[test]
fn a_motion_of_any_kind_has_the_inductance_of_its_windings() {
    let even: Vec<f64> = (0..150).map(|k| 1.7e-3 * f64::from(k)).collect();
    let uneven: Vec<f64> = (0..40).rev().map(|k| 1e-4 * f64::from(k * k)).collect();
    for (index, motion) in motions().iter().enumerate() {
        let coil = coil(motion.spring());
        let times = if index % 3 == 0 { &uneven } else { &even };
        let expected = one_by_one(&coil, &motion.windings(times).unwrap());
        for tolerance in [0.0, 1e-4] {
            let along = coil.along(motion, times, tolerance).unwrap();
            for (ours, expected) in along.samples.iter().zip(&expected) {
                // Positions are those of the motion to 1e-12 of their peak, which L follows.
                let allowed = ours.bound + 1e-12 * expected;
                assert!(
                    (ours.inductance - expected).abs() <= allowed,
                    "{:?} {:?}",
                    motion.mount(),
                    motion.excitation()
                );
            }
        }
    }
}

#[test]
fn turns_that_meet_pass_or_stand_far_apart_are_summed_turn_by_turn() {
    let spring = s_t();
    let coil = coil(&spring);
    // Sample k of 20: the second turn wanders through the third, all others at 4 mm; the last one is far away.
    let row = |k: u32| {
        let mut turns: Vec<f64> = (0..52).map(|turn| 2e-3 + 4e-3 * f64::from(turn)).collect();
        turns[1] += 4e-4 * f64::from(k);
        turns[51] += 1.0;
        turns
    };
    let positions: Vec<f64> = (0..20).flat_map(row).collect();
    let windings = Windings::new(vec![[0.0, 0.208]; 20], positions).unwrap();
    let series = coil.series(&windings);
    for (sample, inductance) in series.iter().enumerate() {
        let expected = coil.at_positions(windings.row(sample)).unwrap();
        assert!(*inductance == expected || (inductance.is_infinite() && expected.is_infinite()), "{sample}");
    }
    assert!(coil.series_within(&windings, 1e-6).unwrap().exact == 20);
}
