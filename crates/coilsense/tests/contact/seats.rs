//! End turns that lie down on a follower which flies, several masses to a winding: against small steps (Moreau's scheme, Gauss and Seidel's iteration), a
//! formulation that shares no code with the first. It converges to the events at first order.

use coilsense::contact::{Chain, Contact, Course, Drive, Path, Start, Touching, follow};
use coilsense::sections::{Section, Sections};
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, SpringParameters, excitation};

use super::laws::{PITCH, spring};

const FOLLOWER: f64 = 0.3;
const AMPLITUDE: f64 = 4.5e-3;
const ANGULAR: f64 = std::f64::consts::TAU * 150.0;
const UNTIL: f64 = 0.02;
const SAMPLES: usize = 200;
/// So many times as often forces are looked at, which are summed up.
const OFTEN: usize = 50;
/// Of the unloaded spring, and with end 1 in the middle of its motion \[m\].
const LENGTHS: [f64; 2] = [0.057, 0.040];

fn exact(per_winding: usize) -> Course {
    exact_with(per_winding, true)
}

fn exact_with(per_winding: usize, seats: bool) -> Course {
    let input = EndInput::harmonic(AMPLITUDE, ANGULAR / std::f64::consts::TAU, 0.0);
    let excitation = Excitation::new(LENGTHS[1], input, EndInput::Held, excitation::Start::Massless).unwrap();
    let motion = Motion::new(&spring(per_winding), &excitation).unwrap();
    let contact = Contact::default().at_pitch(PITCH).unwrap().with_ends(seats).with_follower(FOLLOWER).unwrap();
    let times: Vec<f64> =
        (0..=SAMPLES * OFTEN).map(|sample| UNTIL * sample as f64 / (SAMPLES * OFTEN) as f64).collect();
    Touching::followed(&motion, &contact, &times).unwrap()
}

/// Points cam, follower, lumps, end 2; pairs with the gap of the unloaded spring.
struct Stepped {
    inverse: Vec<f64>,
    stiffnesses: Vec<f64>,
    pairs: Vec<(usize, usize, f64)>,
    x: Vec<f64>,
    v: Vec<f64>,
    /// What end 2 has been given \[N s\].
    given: f64,
}

impl Stepped {
    /// In the massless state: every point as far, and as fast, as its share of the ends.
    fn new(per_winding: usize) -> Self {
        let spring = spring(per_winding);
        let (windings, lumps) = (spring.whole_windings(), spring.chain_masses());
        let last = lumps + 2;
        let mut inverse = vec![lumps as f64 / spring.mass(); last + 1];
        (inverse[0], inverse[1], inverse[last]) = (0.0, 1.0 / FOLLOWER, 0.0);
        let mut stiffnesses = vec![spring.stiffness() * lumps as f64; lumps + 1];
        (stiffnesses[0], stiffnesses[lumps]) = (2.0 * stiffnesses[0], 2.0 * stiffnesses[lumps]);
        let slack = LENGTHS[0] / windings as f64 - PITCH;
        let turn = |lumps_between: f64| slack * lumps_between / per_winding as f64;
        let mut pairs = vec![(0, 1, 0.0)];
        for lump in 1..=lumps {
            if lump <= per_winding {
                pairs.push((1, lump + 1, turn(lump as f64 - 0.5)));
            }
            if lump + per_winding <= lumps {
                pairs.push((lump + 1, lump + 1 + per_winding, slack));
            } else {
                pairs.push((lump + 1, last, turn(lumps as f64 - lump as f64 + 0.5)));
            }
        }
        let pressed = LENGTHS[1] - LENGTHS[0];
        let (mut x, mut v) = (vec![0.0; last + 1], vec![0.0; last + 1]);
        (x[last], v[1]) = (pressed, AMPLITUDE * ANGULAR);
        for lump in 0..lumps {
            let share = (lump as f64 + 0.5) / lumps as f64;
            (x[lump + 2], v[lump + 2]) = (pressed * share, v[1] * (1.0 - share));
        }
        Self { inverse, stiffnesses, pairs, x, v, given: 0.0 }
    }

    fn step(&mut self, time: f64, step: f64) {
        let Self { inverse, stiffnesses, pairs, x, v, given } = self;
        let cam = |time: f64| AMPLITUDE * (ANGULAR * time).sin();
        let last = x.len() - 1;
        v[0] = (cam(time + step) - cam(time)) / step;
        for (lump, stiffness) in stiffnesses.iter().enumerate() {
            let pull = stiffness * (x[lump + 2] - x[lump + 1]) * step;
            v[lump + 1] += pull * inverse[lump + 1];
            v[lump + 2] -= pull * inverse[lump + 2];
            *given += if lump + 2 == last { pull } else { 0.0 };
        }
        let is_near = |(first, second, gap): &&(usize, usize, f64)| {
            x[*second] - x[*first] + gap + 20.0 * step * (v[*second] - v[*first]).min(0.0) < 2e-6
        };
        let near: Vec<_> = pairs.iter().filter(is_near).collect();
        let mut impulses = vec![0.0; near.len()];
        for _ in 0..if near.is_empty() { 0 } else { 300 } {
            for (impulse, &&(first, second, gap)) in impulses.iter_mut().zip(&near) {
                // What lets the pair at most touch at the end of the step.
                let speed = v[second] - v[first] + (x[second] - x[first] + gap).max(0.0) / step;
                let more = (*impulse - speed / (inverse[first] + inverse[second])).max(0.0) - *impulse;
                *impulse += more;
                v[first] -= more * inverse[first];
                v[second] += more * inverse[second];
            }
        }
        let of_end2 = impulses.iter().zip(&near).filter(|(_, (_, second, _))| *second == last);
        *given -= of_end2.map(|(impulse, _)| impulse).sum::<f64>();
        x.iter_mut().zip(v).for_each(|(x, v)| *x += step * *v);
    }
}

/// Where the follower is at the same times, and what impulse end 2 has given by then \[m, N s\].
fn stepped(per_winding: usize, step: f64) -> Vec<[f64; 2]> {
    let every = (UNTIL / SAMPLES as f64 / step).round() as usize;
    let (mut chain, mut told) = (Stepped::new(per_winding), Vec::new());
    for count in 0..=SAMPLES * every {
        if count % every == 0 {
            told.push([chain.x[1], chain.given]);
        }
        chain.step(count as f64 * step, step);
    }
    told
}

#[test]
fn end_turns_lie_down_on_a_flying_follower_as_small_steps_say() {
    for per_winding in [2, 3] {
        let exact = exact(per_winding);
        assert!(exact.given_up.is_none() && exact.floats.len() > 2, "{:?} {:?}", exact.given_up, exact.floats);
        let seats = exact.touches.iter().filter(|touch| touch.points[0] == 1);
        let classes: std::collections::BTreeSet<usize> = seats.map(|touch| touch.points[1]).collect();
        // Every point of the first turn comes to lie on the follower.
        assert_eq!(classes.len(), per_winding, "{classes:?}");
        assert!(exact.balance.open().abs() < 1e-9 * exact.balance.moved, "{:?}", exact.balance);
        // What end 2 has been given: its force over time, and what its seat was struck with.
        let last = 6 * per_winding + 2;
        let mut given = vec![0.0];
        for sample in 0..SAMPLES {
            let [from, to] = [sample, sample + 1].map(|sample| UNTIL * sample as f64 / SAMPLES as f64);
            let forces = &exact.output[sample * OFTEN..=(sample + 1) * OFTEN];
            let even =
                forces.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).sum::<f64>() * (to - from) / OFTEN as f64;
            let struck = exact.touches.iter().filter(|touch| touch.points[1] == last && touch.impulse > 0.0);
            let struck: f64 =
                struck.filter(|touch| touch.time > from && touch.time <= to).map(|touch| touch.impulse).sum();
            given.push(given[sample] + even - struck);
        }
        let apart = |step: f64| {
            let stepped = stepped(per_winding, step);
            let each = stepped.iter().zip(exact.end1.iter().step_by(OFTEN)).zip(&given);
            let squares =
                each.map(|((stepped, end1), given)| [(stepped[0] - end1).powi(2), (stepped[1] - given).powi(2)]);
            let sum = squares.fold([0.0; 2], |sum, each| [sum[0] + each[0], sum[1] + each[1]]);
            sum.map(|sum| (sum / SAMPLES as f64).sqrt())
        };
        let apart = [2e-6, 1e-6, 5e-7, 2.5e-7, 1.25e-7].map(apart);
        // Of a lift of 4.5 mm and 11 N s.
        let [first, last] = [apart[0], apart[4]];
        assert!(last[0] < 5e-7 && last[1] < 1.5e-4, "{apart:?}");
        for quantity in 0..2 {
            let order = (first[quantity] / last[quantity]).ln() / 16.0_f64.ln();
            assert!((0.7..1.3).contains(&order), "{apart:?}: of order {order}");
        }
        // Without seats it goes elsewhere.
        let without = exact_with(per_winding, false);
        let each = without.end1.iter().zip(&exact.end1).map(|(without, with)| (without - with).abs());
        assert!(each.fold(0.0, f64::max) > 1e-4);
    }
}

/// A coil whose end turns lie closed on their seats, and the one next to each rises from it.
fn progressive(per_winding: usize) -> Spring {
    let section = |windings: f64, pitch: [f64; 2]| Section {
        windings,
        pitch,
        coil_diameter: [25e-3; 2],
        wire_diameter: 4e-3,
        telescopes: false,
    };
    let all = [
        section(1.0, [4e-3; 2]),
        section(1.5, [4e-3, 8e-3]),
        section(4.0, [8e-3; 2]),
        section(1.0, [8e-3, 4e-3]),
        section(1.0, [4e-3; 2]),
    ];
    let coil = Sections::new(all.to_vec(), 81.5e9, 7850.0).unwrap();
    let span = coil.span();
    Spring::of_sections(coil, 0.0, (0.5 * span, span)).unwrap().with_masses_per_winding(per_winding).unwrap()
}

/// So many turns of a cam that lifts by 8 mm over 130 degrees, 3-4-5-6, at an engine's speed \[rpm\]; how long they last \[s\].
fn turns(count: usize, rpm: f64) -> (Path, f64) {
    let period = 120.0 / rpm;
    let lobe = period * 130.0 / 360.0;
    let (mut knots, mut pieces) = (vec![0.0], Vec::new());
    for turn in 0..count {
        let begin = (turn as f64 + 0.3) * period;
        knots.extend([begin, begin + lobe]);
        let mut lift = vec![0.0; 7];
        for (power, c) in [(3, 1.0), (4, -3.0), (5, 3.0), (6, -1.0)] {
            lift[power] = 8e-3 * 64.0 * c / lobe.powi(power as i32);
        }
        pieces.extend([vec![0.0], lift]);
    }
    (Path::new(knots, pieces).unwrap(), count as f64 * period)
}

#[test]
fn on_a_follower_that_stays_on_its_cam_windings_do_what_they_do_on_the_cam() {
    for (spring, length, rpm, restitution) in
        [(progressive(4), 0.046, 5000.0, 0.0), (progressive(2), 0.046, 5000.0, 0.5), (spring(4), 0.0391, 6000.0, 0.5)]
    {
        let excitation = Excitation::new(length, EndInput::Held, EndInput::Held, excitation::Start::Rest).unwrap();
        let mount = Mount::new(FarEnd::Position, Damping::Modal(0.01)).unwrap();
        let motion = Motion::mounted(&spring, &mount, &excitation).unwrap();
        let (path, until) = turns(3, rpm);
        let times: Vec<f64> = (0..=3000).map(|sample| f64::from(sample) * until / 3e3).collect();
        let contact = Contact::hard(restitution).unwrap().at_pitch(PITCH).unwrap();
        let contact = contact.with_ends(true).with_lift_off(true);
        let run = |contact: Contact| Touching::driven(&motion, &contact, path.clone(), &times).unwrap();
        let (cam, follower) = (run(contact), run(contact.with_follower(0.02).unwrap()));
        assert!(cam.given_up.is_none() && follower.given_up.is_none() && follower.floats.is_empty());
        assert!(cam.events > 2 && cam.events == follower.events, "{} {}", cam.events, follower.events);
        for (on_cam, on_follower) in [(&cam.input, &follower.input), (&cam.output, &follower.output)] {
            let apart = on_cam.iter().zip(on_follower).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-4, "{apart} N");
        }
    }
}

#[test]
fn end_turns_do_not_throw_one_another_off_a_follower_without_end() {
    for (rpm, restitution) in [(7000.0, 0.0), (7119.0, 0.5)] {
        let excitation = Excitation::new(0.046, EndInput::Held, EndInput::Held, excitation::Start::Rest).unwrap();
        let mount = Mount::new(FarEnd::Position, Damping::Modal(0.01)).unwrap();
        let motion = Motion::mounted(&progressive(4), &mount, &excitation).unwrap();
        let (path, until) = turns(12, rpm);
        let times: Vec<f64> = (0..=10_000).map(|sample| f64::from(sample) * until / 1e4).collect();
        let contact = Contact::hard(restitution).unwrap().with_ends(true).with_lift_off(true);
        let contact = contact.with_follower(0.08).unwrap().with_most_events(20_000);
        let course = Touching::driven(&motion, &contact, path, &times).unwrap();
        // It flies each turn, and end turns meet on it while it does: one that sticks throws off the others, and they it, ever more slowly.
        assert!(course.given_up.is_none() && course.floats.len() >= 12, "{:?} {}", course.given_up, course.events);
        assert!(course.cam_force.iter().all(|force| *force > -1e-5) && course.deepest > -1e-10, "{}", course.deepest);
    }
}

#[test]
fn a_cam_of_chords_pulls_a_follower_no_more_for_the_end_turns_on_it() {
    // Up with 100 m/s², then back with 200: 300 N s² of inertia where the spring pushes with 24 N, so that the follower flies from the middle on. Each knot
    // takes 1 mm/s from the cam, less than what sticks.
    let lift = |time: f64| {
        let after = (time - 0.006).max(0.0);
        50.0 * time.min(0.006).powi(2) + 0.6 * after * f64::from(u8::from(after > 0.0)) - 100.0 * after * after
    };
    for per_winding in [1, 4] {
        let parameters = SpringParameters { stiffness: 2000.0, ..spring(1).parameters().clone() };
        let spring = Spring::new(parameters).unwrap().with_masses_per_winding(per_winding).unwrap();
        let excitation = Excitation::new(0.045, EndInput::Held, EndInput::Held, excitation::Start::Rest).unwrap();
        let motion = Motion::new(&spring, &excitation).unwrap();
        let knots: Vec<f64> = (0..=2400).map(|knot| f64::from(knot) * 5e-6).collect();
        let chord = |ends: &[f64]| vec![lift(ends[0]), (lift(ends[1]) - lift(ends[0])) / (ends[1] - ends[0])];
        let path = Path::new(knots.clone(), knots.windows(2).map(chord).collect()).unwrap();
        let times: Vec<f64> = (0..=1200).map(|sample| f64::from(sample) * 1e-5).collect();
        let contact = Contact::default().at_pitch(4e-3).unwrap().with_ends(true).with_follower(0.3).unwrap();
        let course = Touching::driven(&motion, &contact, path, &times).unwrap();
        let flies = times.iter().zip(&course.end1).map(|(time, end1)| end1 - lift(*time)).fold(0.0, f64::max);
        // 100 m/s² less what the spring does, over 6 ms: 1.9 mm.
        assert!(flies > 1.5e-3, "{per_winding}: {flies} m");
    }
}

#[test]
fn a_follower_that_begins_faster_or_slower_than_its_cam_is_not_held_to_it() {
    let chain = || Chain::of(&spring(2), FarEnd::Position, PITCH, true).unwrap().on_follower(0.3).unwrap();
    let lumps = chain().lumps();
    let held = || Drive::Input(EndInput::Held, 0.0);
    let contact = Contact::default().at_pitch(PITCH).unwrap();
    let times: Vec<f64> = (0..=200).map(|sample| f64::from(sample) * 1e-5).collect();
    let run = |speed: f64| {
        let mut speeds = vec![0.0; lumps];
        speeds[0] = speed;
        let start = Start { time: 0.0, places: vec![0.0; lumps], speeds };
        follow(&chain(), &contact, &Damping::None, [held(), held()], &start, &times).unwrap()
    };
    let (up, down) = (run(1.0), run(-1.0));
    assert!(up.end1[100] > 0.8e-3 && up.cam_force[1..100].iter().all(|force| *force == 0.0), "{}", up.end1[100]);
    assert!(down.end1.iter().all(|place| *place > -1e-12), "{:?}", down.end1.first());
    for course in [up, down] {
        assert!(course.balance.open().abs() < 1e-10 * (course.balance.lost + course.balance.gained.abs() + 1e-3));
    }
}
