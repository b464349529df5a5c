//! Random chains, inputs and laws: none hangs, makes energy or lets windings through one another.

use coilsense::contact::{Chain, Contact, Drive, GivenUp, Path, Start, follow};
use coilsense::{Damping, EndInput};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

#[derive(Debug, Clone)]
struct Case {
    masses: Vec<f64>,
    stiffnesses: Vec<f64>,
    gaps: Vec<f64>,
    speeds: Vec<f64>,
    law: usize,
    restitution: f64,
    lifts: bool,
    amplitude: f64,
    frequency: f64,
    stretch: f64,
    damping: Option<f64>,
    moves: bool,
}

fn cases() -> impl Strategy<Value = Case> {
    (1_usize..9).prop_flat_map(|lumps| {
        let of =
            |from: f64, to: f64, count: usize| prop::collection::vec((from.ln()..to.ln()).prop_map(f64::exp), count);
        let gaps = prop::collection::vec(
            prop_oneof![3 => 1e-5..2e-3_f64, 1 => Just(f64::INFINITY), 1 => Just(0.0)],
            lumps + 1,
        );
        let speeds = prop::collection::vec(-2.0..2.0_f64, lumps);
        let law = (0_usize..3, 0.0..=1.0_f64, any::<bool>(), any::<bool>());
        let drive = (1e-6..2e-3_f64, 1.0..400.0_f64, -2e-3..2e-3_f64, prop::option::of(1e-7..1e-4_f64));
        (of(1e-3, 0.1, lumps), of(1e3, 1e6, lumps + 1), gaps, speeds, law, drive).prop_map(
            |(
                masses,
                stiffnesses,
                gaps,
                speeds,
                (law, restitution, lifts, moves),
                (amplitude, frequency, stretch, damping),
            )| Case {
                masses,
                stiffnesses,
                gaps,
                speeds,
                law,
                restitution,
                lifts,
                amplitude,
                frequency,
                stretch,
                damping,
                moves,
            },
        )
    })
}

fn holds(case: Case) -> Result<(), TestCaseError> {
    let Case { masses, stiffnesses, gaps, speeds, .. } = case;
    let lumps = masses.len();
    let chain = Chain::new(masses, stiffnesses.clone(), gaps.clone()).unwrap();
    let stiffest = stiffnesses.iter().copied().fold(0.0, f64::max);
    let contact = match case.law {
        0 => Contact::default(),
        1 => Contact::hard(case.restitution).unwrap(),
        _ => Contact::elastic(30.0 * stiffest, 2.0 * case.restitution).unwrap(),
    };
    let contact = contact.with_lift_off(case.lifts).with_most_events(100_000);
    let damping = case.damping.map_or(Damping::None, |time| Damping::StiffnessProportional { time });
    // End 2 moves away at first: what begins without a gap is not driven into itself at once.
    let away = Path::new(vec![0.0, 0.01], vec![vec![0.0, 0.0, 1e4 * case.stretch.abs()]]).unwrap();
    let first = if case.moves { EndInput::harmonic(-case.amplitude, case.frequency, 0.0) } else { EndInput::Held };
    let drives = [Drive::Input(first, 0.0), Drive::Path(away)];
    let start = Start { time: 0.0, places: vec![0.0; lumps], speeds };
    let times: Vec<f64> = (0..=500).map(|sample| f64::from(sample) * 1e-4).collect();
    let course = follow(&chain, &contact, &damping, drives, &start, &times).unwrap();
    let balance = course.balance;
    // Meetings take energy only, and all of it adds up; damping counts from the straight line, so that a moving end can gain by it.
    prop_assert!(balance.lost > -1e-12, "{balance:?}");
    let scale = balance.moved + balance.gained.abs() + balance.lost + balance.damped + 1e-3;
    prop_assert!(balance.open().abs() < 1e-10 * scale, "{balance:?} {:e}", balance.open());
    if course.given_up.is_none() {
        prop_assert_eq!(course.input.len(), times.len());
    }
    prop_assert!(course.given_up != Some(GivenUp::TooManyEvents), "{} events by {}", course.events, course.until);
    prop_assert!(course.input.iter().chain(&course.output).all(|force| force.is_finite()));
    if case.law < 2 {
        prop_assert!(course.deepest > -1e-11, "{:e}", course.deepest);
    }
    if case.lifts && case.damping.is_none() {
        let most = course.input.iter().chain(&course.output).copied().fold(f64::MIN, f64::max);
        prop_assert!(most < 1e-6, "{most}");
    }
    Ok(())
}

fn run(cases_: u32) {
    let config = Config { cases: cases_, failure_persistence: None, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    TestRunner::new_with_rng(config, rng).run(&cases(), holds).unwrap();
}

#[test]
fn random_chains_keep_their_books() {
    run(200);
}

#[test]
#[ignore = "ten thousand chains: some minutes"]
fn ten_thousand_random_chains_keep_their_books() {
    run(10_000);
}
