//! Random chains, inputs and laws: none hangs, makes energy or lets windings through one another.

use coilsense::contact::{Chain, Contact, Drive, GivenUp, Path, Start, Touching, follow};
use coilsense::excitation::{Sampled, VelocityProfile};
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, SpringParameters};
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

/// A spring on a mount under an input, as a spec would have it.
#[derive(Debug, Clone)]
struct Use {
    windings: usize,
    masses: usize,
    length: f64,
    pitch: f64,
    velocity: f64,
    far_end: usize,
    damping: usize,
    inputs: [usize; 2],
    amplitude: f64,
    frequency: f64,
    restitution: f64,
    is_elastic: bool,
    ends: bool,
    lifts: bool,
    follower: Option<f64>,
}

fn uses() -> impl Strategy<Value = Use> {
    let spring = (2_usize..9, 1_usize..4, 0.5..0.95_f64, 0.2..0.6_f64, -6.0..6.0_f64);
    let mount = (0_usize..3, 0_usize..5);
    let inputs = (0_usize..7, 0_usize..7, 1e-5..4e-3_f64, 5.0..600.0_f64);
    let follower = proptest::option::of(0.01..1.0_f64);
    let contact = (0.0..=1.0_f64, any::<bool>(), any::<bool>(), any::<bool>(), follower);
    (spring, mount, inputs, contact).prop_map(
        |(
            (windings, masses, length, pitch, velocity),
            (far_end, damping),
            (first, second, amplitude, frequency),
            (restitution, is_elastic, ends, lifts, follower),
        )| Use {
            windings,
            masses,
            length,
            pitch,
            velocity,
            far_end,
            damping,
            inputs: [first, second],
            amplitude,
            frequency,
            restitution,
            is_elastic,
            ends: ends && (masses == 1 || far_end != 2),
            lifts,
            follower: follower.filter(|_| !is_elastic),
        },
    )
}

fn input(kind: usize, size: f64, frequency: f64) -> EndInput {
    let period = 1.0 / frequency;
    match kind {
        0 => EndInput::Held,
        1 => EndInput::harmonic(size, frequency, 0.4),
        2 => EndInput::Chirp { amplitude: size, from: 0.2 * frequency, to: frequency, duration: 0.03, phase: 0.0 },
        3 => EndInput::Step { height: size, at: 0.5 * period },
        4 => EndInput::Ramp { height: size, from: 0.2 * period, duration: period },
        5 => EndInput::HalfSine { height: -size, from: 0.0, duration: 0.5 * period },
        _ => {
            let samples = (0..20).map(|sample| 0.3 * period * f64::from(sample)).collect();
            let values = (0..20).map(|sample| size * f64::from(sample * 7 % 5 - 2) / 3.0).collect();
            EndInput::Sampled(Sampled::new(samples, values).unwrap())
        }
    }
}

/// Its motion, contact, and the pitch at which windings touch \[m\].
fn used(case: &Use) -> (Motion, Contact, f64) {
    let rest_length = 0.01 * case.windings as f64;
    let spring = Spring::new(SpringParameters {
        rest_length,
        windings: case.windings as f64,
        coil_radius: 0.0125,
        wire_radius: 0.001,
        mass: 0.006 * case.windings as f64,
        stiffness: 3e4,
        min_length: 0.3 * rest_length,
        max_length: 0.99 * rest_length,
        nominal_force: None,
        inductance_windings: None,
        sections: None,
    });
    let spring = spring.unwrap().with_masses_per_winding(case.masses).unwrap();
    let far_end = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.05)][case.far_end];
    let damping = match case.damping {
        0 => Damping::None,
        1 => Damping::MassProportional { rate: 40.0 },
        2 => Damping::StiffnessProportional { time: 1e-5 },
        _ => Damping::Modal(0.01),
    };
    let second = if far_end == FarEnd::Position { case.amplitude } else { 3e4 * case.amplitude };
    let velocity = case.velocity;
    let excitation = Excitation::new(
        case.length * rest_length,
        input(case.inputs[0], case.amplitude, case.frequency),
        input(case.inputs[1], second, case.frequency),
        coilsense::Start::Moving { velocity, profile: VelocityProfile::Linear },
    );
    let mount = Mount::new(far_end, damping).unwrap();
    let motion = Motion::mounted(&spring, &mount, &excitation.unwrap()).unwrap();
    let contact = match case.is_elastic {
        true => Contact::elastic(1e7, case.restitution).unwrap(),
        false => Contact::hard(case.restitution).unwrap(),
    };
    let pitch = case.pitch * 0.01 * case.length;
    let contact = contact.at_pitch(pitch).unwrap().with_ends(case.ends).with_lift_off(case.lifts);
    let contact = match case.follower {
        Some(mass) => contact.with_follower(mass).unwrap(),
        None => contact,
    };
    (motion, contact.with_most_events(50_000), pitch)
}

fn spring_holds(case: Use) -> Result<(), TestCaseError> {
    let (motion, contact, pitch) = used(&case);
    let times: Vec<f64> = (0..=300).map(|sample| f64::from(sample) * 1e-4).collect();
    let touching = match Touching::of(&motion, &contact, &times, true) {
        Ok(touching) => touching,
        // A recording may begin with an end inside a winding.
        Err(error) => {
            prop_assert!(error.to_string().contains("they overlap"), "{error}");
            return Ok(());
        }
    };
    let Some(course) = &touching.course else { return Ok(()) };
    prop_assert!(course.given_up != Some(GivenUp::TooManyEvents), "{} events by {}", course.events, course.until);
    let balance = course.balance;
    let scale = balance.moved + balance.gained.abs() + balance.lost + balance.damped.abs() + 1e-3;
    prop_assert!(balance.open().abs() < 1e-10 * scale, "{balance:?} {:e}", balance.open());
    prop_assert!(balance.lost > -1e-12, "{balance:?}");
    let windings = touching.windings.as_ref().unwrap();
    prop_assert_eq!(windings.samples(), touching.signals.time().len());
    prop_assert!(course.cam_force.iter().all(|force| *force > -1e-3), "{:?}", course.cam_force);
    if !case.is_elastic {
        // Seats, a follower and its cam among them.
        prop_assert!(course.deepest > -1e-11, "{:e}", course.deepest);
        let first = touching.first_contact().unwrap_or(f64::INFINITY);
        let from = times.partition_point(|time| *time < first);
        for sample in from..windings.samples() {
            let row = windings.row(sample);
            let least = row.iter().zip(&row[case.masses..]).map(|(a, b)| b - a).fold(f64::INFINITY, f64::min);
            prop_assert!(least > pitch - 1e-11, "{sample}: {:e}", least - pitch);
        }
    }
    for (_, values) in touching.signals.channels() {
        prop_assert!(values.iter().all(|value| value.is_finite()));
    }
    prop_assert!(touching.holds_until(1.0).unwrap() <= times[300]);
    Ok(())
}

fn run_springs(count: u32) {
    let config = Config { cases: count, failure_persistence: None, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    TestRunner::new_with_rng(config, rng).run(&uses(), spring_holds).unwrap();
}

#[test]
fn random_springs_keep_their_books() {
    run_springs(200);
}

#[test]
#[ignore = "ten thousand springs: some minutes"]
fn ten_thousand_random_springs_keep_their_books() {
    run_springs(10_000);
}
