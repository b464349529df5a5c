//! What must hold whatever the figures: the linear answer where nothing meets, momentum, energy, symmetry, limits, and what is refused.

use coilsense::contact::{Chain, Contact, Course, Drive, GivenUp, Path, Start, Touching, follow};
use coilsense::excitation::{Sampled, VelocityProfile};
use coilsense::{
    Channel, Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, SpringParameters, excitation, paper,
};

const NEVER: f64 = f64::INFINITY;

fn held() -> Drive {
    Drive::Input(EndInput::Held, 0.0)
}

pub fn grid(until: f64, samples: usize) -> Vec<f64> {
    (0..=samples).map(|sample| until * sample as f64 / samples as f64).collect()
}

/// Two masses on soft springs, thrown at one another.
fn two(masses: [f64; 2], speeds: [f64; 2], contact: &Contact, until: f64) -> Course {
    let chain = Chain::new(masses.to_vec(), vec![1e-6; 3], vec![NEVER, 1e-3, NEVER]).unwrap();
    let start = Start { time: 0.0, places: vec![0.0; 2], speeds: speeds.to_vec() };
    follow(&chain, contact, &Damping::None, [held(), held()], &start, &grid(until, 100)).unwrap()
}

#[test]
fn two_masses_part_as_newton_says() {
    for (restitution, masses) in [(0.0, [1.0, 3.0]), (0.5, [1.0, 3.0]), (1.0, [2.0, 2.0]), (0.3, [5.0, 0.1])] {
        let course = two(masses, [0.4, -0.1], &Contact::hard(restitution).unwrap(), 0.01);
        let touch = course.touches[0];
        assert!((touch.time - 1e-3 / 0.5).abs() < 1e-12 && (touch.closing_speed - 0.5).abs() < 1e-9);
        let reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
        assert!((touch.impulse - (1.0 + restitution) * reduced * 0.5).abs() < 1e-8, "{touch:?}");
        let lost = 0.5 * reduced * 0.25 * (1.0 - restitution * restitution);
        assert!((touch.lost - lost).abs() < 1e-9, "{touch:?} {lost}");
        assert!(restitution == 0.0 || touch.parted == Some(touch.time));
    }
    // Apart they never meet.
    assert!(two([1.0, 1.0], [-0.4, 0.1], &Contact::default(), 0.01).touches.is_empty());
}

#[test]
fn an_elastic_meeting_lasts_half_a_swing_and_loses_what_its_dashpot_takes() {
    let (stiffness, mass) = (1e5, 0.5);
    let course = two([1.0; 2], [0.4, -0.1], &Contact::elastic(stiffness, 0.0).unwrap(), 0.02);
    let touch = course.touches[0];
    let swing = (stiffness / mass).sqrt();
    assert!((touch.parted.unwrap() - touch.time - std::f64::consts::PI / swing).abs() < 1e-9);
    assert!((touch.pressed - 2.0 * mass * 0.5).abs() < 1e-7 && touch.impulse == 0.0 && touch.lost.abs() < 1e-15);
    // ζ = 0.3 of a pair of masses leaves e = 0.45.
    let course = two([1.0; 2], [0.4, -0.1], &Contact::elastic(stiffness, 0.3).unwrap(), 0.02);
    let kept = 1.0 - course.touches[0].lost / (0.5 * mass * 0.25);
    assert!((kept.sqrt() - 0.45).abs() < 0.01, "{}", kept.sqrt());
}

pub fn spring(masses: usize) -> Spring {
    let parameters = SpringParameters {
        rest_length: 0.057,
        windings: 6.0,
        coil_radius: 0.0125,
        wire_radius: 0.002,
        mass: 0.044549,
        stiffness: 29028.0,
        min_length: 0.035,
        max_length: 0.05,
        nominal_force: None,
        inductance_windings: None,
        sections: None,
    };
    Spring::new(parameters).unwrap().with_masses_per_winding(masses).unwrap()
}

/// The valve spring at its sixth: solid at 31 mm.
pub const PITCH: f64 = 0.031 / 6.0;

fn hard() -> Contact {
    Contact::default().at_pitch(PITCH).unwrap()
}

fn sine(amplitude: f64, frequency: f64) -> Excitation {
    let input = EndInput::harmonic(amplitude, frequency, 0.3);
    Excitation::new(0.048, input, EndInput::Held, excitation::Start::Rest).unwrap()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

#[test]
fn where_nothing_meets_the_chain_is_the_linear_motion() {
    let recording =
        EndInput::Sampled(Sampled::new(vec![0.0, 0.003, 0.007, 0.012], vec![0.0, 1e-4, -2e-4, 1e-4]).unwrap());
    let inputs = [
        EndInput::Held,
        EndInput::harmonic(3e-4, 300.0, 1.0),
        EndInput::Chirp { amplitude: 2e-4, from: 50.0, to: 500.0, duration: 0.015, phase: 0.1 },
        EndInput::Step { height: 2e-4, at: 0.004 },
        EndInput::Ramp { height: 4e-4, from: 0.002, duration: 0.003 },
        EndInput::HalfSine { height: 4e-4, from: 0.002, duration: 0.005 },
        recording,
    ];
    let ratios = (1..=7).map(|mode| 0.002 * f64::from(mode)).collect::<Vec<f64>>();
    let times = grid(0.02, 400);
    for far_end in [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.05)] {
        let modes = if far_end == FarEnd::Mass(0.05) { 7 } else { 6 };
        let dampings = [
            Damping::None,
            Damping::MassProportional { rate: 30.0 },
            Damping::StiffnessProportional { time: 2e-5 },
            Damping::Modal(0.01),
            Damping::ModalEach(ratios[..modes].to_vec()),
        ];
        for damping in dampings {
            for input in &inputs {
                let start = excitation::Start::Moving { velocity: 0.2, profile: VelocityProfile::Linear };
                let other = if far_end == FarEnd::Position {
                    EndInput::harmonic(1e-4, 90.0, 0.0)
                } else {
                    EndInput::harmonic(20.0, 90.0, 0.0)
                };
                let excitation = Excitation::new(0.048, input.clone(), other, start).unwrap();
                let mount = Mount::new(far_end, damping.clone()).unwrap();
                let motion = Motion::mounted(&spring(1), &mount, &excitation).unwrap();
                // Near enough to be followed, and never touching: only lift-off is asked about, of a spring that is pressed.
                let contact = Contact::default().at_pitch(1e-3).unwrap().with_lift_off(true).with_most_events(0);
                let far = Touching::followed(&motion, &contact, &times).unwrap();
                let linear = motion.end_forces(&times).unwrap();
                let scale = largest(&linear.output).max(largest(&linear.input));
                for (here, there) in [(&far.input, &linear.input), (&far.output, &linear.output)] {
                    let apart: Vec<f64> = here.iter().zip(there).map(|(a, b)| a - b).collect();
                    assert!(largest(&apart) < 1e-9 * scale, "{far_end:?} {damping:?} {input:?}: {}", largest(&apart));
                }
                assert!(
                    far.balance.open().abs() < 1e-10 * far.balance.moved.max(1e-3)
                        || matches!(input, EndInput::Step { .. }),
                    "{far_end:?} {damping:?} {input:?} {:?} {:e}",
                    far.balance,
                    far.balance.open()
                );
            }
        }
    }
}

#[test]
fn before_anything_meets_the_signals_are_the_linear_ones_bit_by_bit() {
    let motion = Motion::new(&spring(1), &sine(1.2e-3, 399.0)).unwrap();
    let times = grid(0.1, 2000);
    let touching = Touching::of(&motion, &hard(), &times, true).unwrap();
    let first = touching.first_contact().unwrap();
    let linear = motion.signals(&times).unwrap();
    let before = times.partition_point(|time| *time < first);
    assert!(before > 10 && before < times.len());
    for (channel, values) in linear.channels() {
        assert_eq!(&touching.signals.channel(channel).unwrap()[..before], &values[..before], "{channel:?}");
    }
    let apart = |channel| -> f64 {
        let pair = linear.channel(channel).unwrap().iter().zip(touching.signals.channel(channel).unwrap());
        pair.map(|(a, b): (&f64, &f64)| (a - b).abs()).fold(0.0, f64::max)
    };
    assert!(apart(Channel::OutputForce) > 10.0);
    // No windings pass through one another.
    let windings = touching.windings.unwrap();
    for sample in before..times.len() {
        let row = windings.row(sample);
        assert!(row.windows(2).all(|pair| pair[1] - pair[0] > PITCH - 1e-11), "{sample}");
    }
    // The same moment as the clash check.
    let clash = coilsense::measures::Clash::seen(&motion, &times, &motion.windings(&times).unwrap(), PITCH).unwrap();
    assert!((clash.first_contact.unwrap() - first).abs() < 1e-9);
}

#[test]
fn a_motion_that_stays_clear_is_left_alone() {
    let motion = Motion::new(&spring(1), &sine(1e-5, 100.0)).unwrap();
    let times = grid(0.1, 500);
    let touching = Touching::of(&motion, &hard(), &times, false).unwrap();
    assert!(touching.course.is_none() && touching.first_contact().is_none() && touching.touches().is_empty());
    assert_eq!(touching.signals, motion.signals(&times).unwrap());
    assert_eq!(touching.holds_until(1.0).unwrap(), 0.1);
}

#[test]
fn times_that_do_not_ascend_are_refused_where_nothing_meets_too() {
    let motion = Motion::new(&spring(1), &sine(1e-5, 100.0)).unwrap();
    let error = |times: &[f64]| Touching::of(&motion, &hard(), times, false).unwrap_err().to_string();
    assert!(error(&[]).contains("times"));
    assert!(error(&[0.0, 0.01, 0.005]).contains("time[2] must be above its predecessor of 0.01 s"));
    assert!(error(&[0.0, f64::NAN]).contains("time[1]"));
    assert!(error(&[-0.1, 0.0]).contains("time[0]"));
    // And a pitch at which the unloaded spring would overlap, which the bound alone would not see.
    let wide = Contact::default().at_pitch(0.0096).unwrap();
    let refused = Touching::of(&motion, &wide, &[0.0, 0.01], false).unwrap_err().to_string();
    assert!(refused.starts_with("contact pitch must be at most the 0.0095 m"), "{refused}");
}

#[test]
fn what_stays_together_is_calm_and_what_bounces_fully_is_lost() {
    let motion = Motion::new(&spring(1), &sine(1.5e-3, 399.0)).unwrap();
    let times = grid(0.3, 3000);
    let calm = Touching::of(&motion, &hard(), &times, false).unwrap();
    assert_eq!(calm.holds_until(5.0).unwrap(), 0.3);
    let wild = Touching::of(&motion, &Contact::hard(1.0).unwrap().at_pitch(PITCH).unwrap(), &times, false).unwrap();
    let until = wild.holds_until(5.0).unwrap();
    assert!(until < 0.25 && until > wild.first_contact().unwrap(), "{until}");
    assert!(wild.course.unwrap().given_up.is_none());
    assert!(calm.holds_until(0.0).is_err());
}

#[test]
fn a_mirrored_spring_does_the_mirrored_thing() {
    let (input, times) = (EndInput::harmonic(1.2e-3, 399.0, 0.0), grid(0.06, 600));
    let other = EndInput::harmonic(-1.2e-3, 399.0, 0.0);
    let one = Excitation::new(0.048, input, EndInput::Held, excitation::Start::Rest).unwrap();
    let two = Excitation::new(0.048, EndInput::Held, other, excitation::Start::Rest).unwrap();
    let each = [hard(), hard().with_ends(true), hard().with_ends(true).with_lift_off(true)];
    for (contact, masses) in each.into_iter().flat_map(|contact| [(contact, 1), (contact, 3)]) {
        let of = |excitation: &Excitation| {
            let motion = Motion::new(&spring(masses), excitation).unwrap();
            Touching::of(&motion, &contact, &times, false).unwrap()
        };
        let (first, second) = (of(&one), of(&two));
        assert!(first.touches().len() > 3);
        let pair = first
            .signals
            .channel(Channel::InputForce)
            .unwrap()
            .iter()
            .zip(second.signals.channel(Channel::OutputForce).unwrap());
        let apart = pair.map(|(a, b): (&f64, &f64)| (a - b).abs()).fold(0.0, f64::max);
        // Thousands of touches of turns that roll on their seats spread what rounding differs.
        assert!(apart < if masses == 1 { 1e-4 } else { 1e-2 }, "{masses} {apart}");
    }
}

#[test]
fn an_end_that_cannot_be_pulled_is_never_pulled() {
    let motion = Motion::new(&spring(1), &sine(1.5e-3, 399.0)).unwrap();
    let times = grid(0.2, 4000);
    let held = Touching::of(&motion, &hard().with_ends(true), &times, false).unwrap();
    let most = |touching: &Touching, channel| {
        touching.signals.channel(channel).unwrap().iter().copied().fold(f64::MIN, f64::max)
    };
    assert!(most(&held, Channel::InputForce) > 50.0);
    let free = Touching::of(&motion, &hard().with_ends(true).with_lift_off(true), &times, false).unwrap();
    assert!(most(&free, Channel::InputForce) < 1e-6 && most(&free, Channel::OutputForce) < 1e-6);
    let course = free.course.unwrap();
    assert!(!course.lifts.is_empty() && course.lifts.iter().all(|lift| lift.back.is_none_or(|back| back > lift.time)));
    assert!(course.balance.open().abs() < 1e-10 * course.balance.moved, "{:?}", course.balance);
}

#[test]
fn a_first_turn_rolls_on_its_seat_as_finely_as_it_is_cut() {
    let times: Vec<f64> = (0..=4000).map(|sample| f64::from(sample) * 5e-5).collect();
    let run = |masses: usize, ends: bool| {
        let input = EndInput::harmonic(2e-3, 380.0, 0.0);
        let excitation = Excitation::new(0.048, input, EndInput::Held, excitation::Start::Rest).unwrap();
        let motion = Motion::new(&spring(masses), &excitation).unwrap();
        let touching = Touching::of(&motion, &hard().with_ends(ends), &times, true).unwrap();
        let course = touching.course.as_ref().unwrap();
        assert!(course.balance.open().abs() < 1e-10 * course.balance.moved, "{:?}", course.balance);
        let windings = touching.windings.as_ref().unwrap();
        let first = touching.first_contact().unwrap();
        for sample in times.partition_point(|time| *time < first)..times.len() {
            let [u1, _] = windings.ends(sample);
            // Of a turn that lies on its seat down to a point, the point has its own share of the wire below it.
            for (point, place) in windings.row(sample)[..masses].iter().enumerate() {
                let share = (point as f64 + 0.5) / masses as f64;
                assert!(!ends || place - u1 > share * PITCH - 1e-11, "{masses} {sample} {point}");
            }
        }
        let of = |channel| {
            let force = touching.signals.channel(channel).unwrap();
            (force[2000..].iter().map(|force| force * force).sum::<f64>() / 2001.0).sqrt()
        };
        [of(Channel::InputForce), of(Channel::OutputForce)]
    };
    let finest = run(16, true);
    let off = |masses: usize| (run(masses, true)[1] / finest[1] - 1.0).abs();
    let (coarse, middle, fine) = (off(1), off(4), off(8));
    assert!(fine < middle && middle < coarse && fine < 0.01, "{coarse} {middle} {fine}");
    // The seats are no trifle: without them the answer is another one.
    assert!((run(8, false)[0] / finest[0] - 1.0).abs() > 2.0 * fine);
}

#[test]
fn what_cannot_be_followed_is_said() {
    let times = grid(0.1, 100);
    assert!(Contact::hard(1.1).is_err() && Contact::hard(f64::NAN).is_err() && Contact::elastic(0.0, 0.1).is_err());
    assert!(Contact::elastic(1e5, -0.1).is_err() && Contact::default().at_pitch(0.0).is_err());
    // A pitch at which the unloaded spring would overlap.
    let motion = Motion::new(&spring(1), &sine(1e-3, 300.0)).unwrap();
    let error = Touching::of(&motion, &Contact::default().at_pitch(0.01).unwrap(), &times, false).unwrap_err();
    assert!(error.to_string().starts_with("contact pitch must be at most the 0.0095 m"), "{error}");
    let mount = coilsense::Mount::new(coilsense::FarEnd::Mass(0.1), Damping::None).unwrap();
    let fine = Motion::mounted(&spring(4), &mount, &sine(1e-3, 300.0)).unwrap();
    let error = Touching::of(&fine, &hard().with_ends(true), &times, false).unwrap_err();
    assert!(error.to_string().starts_with("masses per winding must be one where windings meet their seats"), "{error}");
    // An end that goes on closing a solid spring.
    let chain = Chain::new(vec![1.0; 2], vec![100.0; 3], vec![1e-3; 3]).unwrap();
    let down = Drive::Path(Path::new(vec![0.0, 0.1], vec![vec![0.0, 0.1]]).unwrap());
    let start = Start { time: 0.0, places: vec![0.0; 2], speeds: vec![0.0; 2] };
    let course = follow(&chain, &Contact::default(), &Damping::None, [down, held()], &start, &times).unwrap();
    assert_eq!(course.given_up, Some(GivenUp::Solid));
    assert!((course.until - 0.03).abs() < 0.002 && course.input.len() < times.len());
    // Ratios ask for modes.
    let ratio = follow(&chain, &Contact::default(), &Damping::Modal(0.1), [held(), held()], &start, &times);
    assert!(ratio.unwrap_err().to_string().contains("zero for a chain whose modes are not given"));
    // A start that overlaps.
    let start = Start { time: 0.0, places: vec![1.0, 0.0], speeds: vec![0.0; 2] };
    let course = follow(&chain, &Contact::default(), &Damping::None, [held(), held()], &start, &times);
    assert!(course.unwrap_err().to_string().contains("they overlap"));
    // More events than allowed: what there is, and why it ends.
    let start = Start { time: 0.0, places: vec![0.0; 2], speeds: vec![0.2, -0.1] };
    let once = Contact::hard(0.9).unwrap().with_most_events(1);
    let course = follow(&chain, &once, &Damping::None, [held(), held()], &start, &times).unwrap();
    assert_eq!(course.given_up, Some(GivenUp::TooManyEvents));
    assert!(course.until > 0.0 && !course.input.is_empty());
}

#[test]
fn a_stack_that_chatters_ends_in_few_events() {
    // Pressed together by its ends, each meeting leaves 60 % of the speed: bounces without end in finite time, but for what sticks.
    let chain = Chain::new(vec![0.01; 5], vec![1e4; 6], vec![NEVER, 1e-3, 1e-3, 1e-3, 1e-3, NEVER]).unwrap();
    let press = Drive::Path(Path::new(vec![0.0, 0.01], vec![vec![0.0, 0.0, 120.0]]).unwrap());
    let start = Start { time: 0.0, places: vec![0.0; 5], speeds: vec![0.0; 5] };
    let damping = Damping::StiffnessProportional { time: 2e-5 };
    let course =
        follow(&chain, &Contact::hard(0.6).unwrap(), &damping, [press, held()], &start, &grid(0.1, 1000)).unwrap();
    assert!(course.given_up.is_none() && course.events < 20_000, "{}", course.events);
    // In the end all lie on one another.
    let last: Vec<_> = course.touches.iter().filter(|touch| touch.parted.is_none()).collect();
    assert_eq!(last.len(), 4, "{last:?}");
    let both = course.input[1000] + course.output[1000];
    assert!((both + 1e4 * (0.012 - 4e-3)).abs() < 1e-6, "{both}");
}

#[test]
fn a_spring_that_begins_solid_opens() {
    let spring = paper::s_a();
    let chain = Chain::of(&spring, FarEnd::Position, spring.wire_diameter(), false).unwrap();
    let (lumps, rest) = (spring.whole_windings(), spring.rest_length());
    let gap = rest / lumps as f64 - spring.wire_diameter();
    // All inner windings touch, the ends where the spring's half segments leave them.
    let shorter = gap * lumps as f64;
    let places: Vec<f64> = (0..lumps).map(|lump| -gap * (lump as f64 + 0.5)).collect();
    let start = Start { time: 0.0, places, speeds: vec![0.0; lumps] };
    let open = Drive::Path(
        Path::new(vec![0.0, 0.01], vec![vec![-shorter, 0.0, 3.0 * shorter / 1e-4, -2.0 * shorter / 1e-6]]).unwrap(),
    );
    let course = follow(&chain, &Contact::default(), &Damping::None, [held(), open], &start, &grid(0.03, 300)).unwrap();
    assert!(course.given_up.is_none());
    let largest = largest(&course.input);
    assert!(course.balance.open().abs() < 1e-10 * course.balance.moved && largest.is_finite(), "{:?}", course.balance);
    assert!(course.touches.iter().filter(|touch| touch.time == 0.0).all(|touch| touch.parted.is_some()));
}
