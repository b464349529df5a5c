//! Motions of their first modes only, against those of all.

mod every_motion;
mod paper_springs;

use coilsense::{EndInput, Excitation, Motion, Start};
use every_motion::{motions, off};
use paper_springs::s_t;

#[test]
fn a_truncated_motion_stays_within_its_stated_bound() {
    let times: Vec<f64> = (0..4000).map(|k| f64::from(k) * 1.3e-4).collect();
    for motion in motions() {
        let full = motion.end_forces(&times).unwrap();
        for modes in [1, 4, motion.modes().count()] {
            let truncated = motion.truncated(modes).unwrap();
            let forces = truncated.end_forces(&times).unwrap();
            let bound = truncated.truncation_bound();
            for (end, (ours, theirs)) in
                [(&forces.input, &full.input), (&forces.output, &full.output)].into_iter().enumerate()
            {
                let worst = ours.iter().zip(theirs).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
                assert!(
                    worst <= bound[end] + 1e-9,
                    "{worst:e} {bound:?} {modes}: {:?} {:?}",
                    motion.mount(),
                    motion.excitation()
                );
            }
            let stream: Vec<f64> = truncated.stream(1.3e-4).unwrap().take(4000).map(|sample| sample.output).collect();
            assert!(off(&stream, &forces.output) < 1e-11, "{:?} {:?}", motion.mount(), motion.excitation());
        }
    }
    let refused = |modes| motions()[0].truncated(modes).unwrap_err().to_string();
    assert_eq!(refused(0), "modes must be from 1 to 52, got 0");
    assert_eq!(refused(53), "modes must be from 1 to 52, got 53");
}

#[test]
fn a_bound_at_a_resonance_of_what_is_left_out_is_infinite() {
    let spring = s_t();
    let on_mode_5 = coilsense::modes::ChainModes::of(&spring).frequencies()[4] / std::f64::consts::TAU;
    let excitation =
        Excitation::new(0.23, EndInput::harmonic(1e-4, on_mode_5, 0.0), EndInput::Held, Start::Rest).unwrap();
    let bound = Motion::new(&spring, &excitation).unwrap().truncated(2).unwrap().truncation_bound();
    // To rounding of 2πf it is either infinite or too large to be of any use; never NaN.
    assert!(bound.iter().all(|force| *force > 1e6), "{bound:?}");
}

#[test]
fn the_static_remainder_is_worth_keeping() {
    // 10 Hz on S_T, one mode kept: what the others do at rest is most of what is missing.
    let spring = s_t();
    let input = EndInput::harmonic(1e-3, 10.0, 0.0);
    let excitation = Excitation::new(0.23, input.clone(), EndInput::Held, Start::Massless).unwrap();
    let motion = Motion::new(&spring, &excitation).unwrap();
    let one = motion.truncated(1).unwrap();
    let time = [0.325];
    let (full, kept) = (motion.end_forces(&time).unwrap().input[0], one.end_forces(&time).unwrap().input[0]);
    // Without the remainder: all modes' inertia is m/3, the first one's 2m/π².
    let acceleration = -1e-3 * (20.0 * std::f64::consts::PI).powi(2);
    let missing = spring.mass() * (1.0 / 3.0 - 2.0 / std::f64::consts::PI.powi(2)) * acceleration;
    assert!((full - kept).abs() < 0.2 * missing.abs(), "{} of {missing}", full - kept);
}
