//! The bound on how near windings come, against the motions themselves.

mod every_motion;
mod paper_springs;

use coilsense::{Clash, EndInput, Excitation, Mount, Spring, Start, VelocityProfile};
use coilsense::{Damping, FarEnd, Motion};
use every_motion::motions;
use paper_springs::{s_a, s_t};
use proptest::prelude::*;

/// The five conditions of the paper's section III-B, as its tables have them.
fn conditions(spring: &Spring) -> Vec<(&'static str, Excitation)> {
    let (shortest, longest) = spring.operating_range();
    let range = longest - shortest;
    let cosine = |share: f64, frequency: f64| {
        let input = EndInput::harmonic(share * range, frequency, -std::f64::consts::FRAC_PI_2);
        Excitation::new(spring.mid_length(), input, EndInput::Held, Start::Massless).unwrap()
    };
    let surge = spring.surge_frequency();
    vec![
        ("impact", Excitation::impact(spring.mid_length(), 0.25).unwrap()),
        ("end stop max", Excitation::end_stop(longest, range, VelocityProfile::Linear).unwrap()),
        ("end stop min", Excitation::end_stop(shortest, -range, VelocityProfile::Uniform).unwrap()),
        ("half resonance", cosine(0.01, 0.5 * surge)),
        ("resonance", cosine(0.001, surge)),
    ]
}

/// The closest pitch that a grid of times shows.
fn closest(motion: &Motion, until: f64, samples: u32) -> f64 {
    let times: Vec<f64> = (0..=samples).map(|k| until * f64::from(k) / f64::from(samples)).collect();
    Clash::of(motion, &times).unwrap().smallest_pitch
}

#[test]
fn s_t_is_cleared_in_the_papers_conditions_without_a_look_at_its_windings() {
    let spring = s_t();
    for (name, excitation) in conditions(&spring) {
        for ratio in [0.0, 0.005] {
            let mount = Mount::new(FarEnd::Position, Damping::Modal(ratio)).unwrap();
            let motion = Motion::mounted(&spring, &mount, &excitation).unwrap();
            assert!(Clash::excluded(&motion, 1.0, spring.wire_diameter()), "{name}");
            let (bound, seen) = (motion.least_pitch(1.0), closest(&motion, 1.0, 4000));
            assert!(bound <= seen, "{name}: {bound} {seen}");
            // As the passport says; the bound does not make use of how damping stunts a resonance before it is steady.
            if ratio == 0.0 {
                assert!(seen - bound < 0.1e-3, "{name}: {bound} {seen}");
            }
        }
    }
}

#[test]
fn a_resonance_that_brings_windings_together_is_not_excluded() {
    let spring = s_t();
    let input = EndInput::harmonic(1e-3, spring.surge_frequency(), 0.0);
    let motion = Motion::new(&spring, &Excitation::new(0.23, input, EndInput::Held, Start::Rest).unwrap()).unwrap();
    assert!(closest(&motion, 1.0, 4000) < spring.wire_diameter());
    assert!(!Clash::excluded(&motion, 1.0, spring.wire_diameter()));
    // Early on it is: what grows linearly begins at nothing.
    assert!(Clash::excluded(&motion, 0.02, spring.wire_diameter()));
}

#[test]
fn no_motion_of_any_kind_comes_nearer_than_its_bound() {
    for motion in motions() {
        for until in [0.03, 0.4] {
            let (bound, seen) = (motion.least_pitch(until), closest(&motion, until, 800));
            // Positions are found to 1e-12 of their peak, a few decimetres.
            assert!(bound <= seen + 1e-12, "{bound} {seen}: {:?} {:?}", motion.mount(), motion.excitation());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn what_is_excluded_does_not_happen(
        strikes in -3.0..3.0f64, swings in 0.0..3e-3f64, share in 0.3..3.2f64, phase in 0.0..6.3f64,
        ratio in 0.0..0.02f64, stiff in proptest::bool::ANY, far_end in 0..3usize,
    ) {
        let spring = if stiff { s_a() } else { s_t() };
        let input = EndInput::harmonic(swings, share * spring.surge_frequency(), phase);
        let start = Start::Moving { velocity: strikes, profile: VelocityProfile::Linear };
        let excitation = Excitation::new(spring.mid_length(), input, EndInput::Held, start).unwrap();
        let far_end = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.2)][far_end];
        let mount = Mount::new(far_end, Damping::Modal(ratio)).unwrap();
        let motion = Motion::mounted(&spring, &mount, &excitation).unwrap();
        let touches = closest(&motion, 0.3, 1500) < spring.wire_diameter();
        prop_assert!(!(touches && Clash::excluded(&motion, 0.3, spring.wire_diameter())));
        prop_assert!(motion.least_pitch(0.3) <= closest(&motion, 0.3, 1500));
    }
}
