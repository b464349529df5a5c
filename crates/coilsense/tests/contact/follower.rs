//! A follower that a cam pushes and cannot pull: it flies where it would have to be, and comes down again.

use coilsense::contact::{Chain, Contact, Touching};
use coilsense::excitation::{self, EndInput, Excitation};
use coilsense::{Channel, Damping, FarEnd, Motion, Mount, Spring, SpringParameters};

use super::laws::{PITCH, grid, spring};

const MASS: f64 = 0.11;

fn hard() -> Contact {
    Contact::default().at_pitch(PITCH).unwrap()
}

fn light() -> Spring {
    let parameters = SpringParameters { mass: 1e-6, ..spring(1).parameters().clone() };
    Spring::new(parameters).unwrap()
}

fn sine(amplitude: f64, frequency: f64) -> Excitation {
    let input = EndInput::harmonic(amplitude, frequency, 0.0);
    Excitation::new(0.048, input, EndInput::Held, excitation::Start::Massless).unwrap()
}

#[test]
fn a_mass_on_a_spring_without_mass_flies_as_by_hand() {
    let (amplitude, frequency) = (3e-3, 200.0);
    let angular = std::f64::consts::TAU * frequency;
    let (stiffness, pressed) = (29028.0_f64, 0.057 - 0.048);
    let motion = Motion::new(&light(), &sine(amplitude, frequency)).unwrap();
    let times = grid(12e-3, 400);
    let touching = Touching::of(&motion, &hard().with_follower(MASS).unwrap(), &times, false).unwrap();
    let course = touching.course.as_ref().unwrap();
    // N = k (δ0 + u) + M ü: gone where a (M ω² − k) sin ωt = k δ0.
    let leaves = (stiffness * pressed / (amplitude * (MASS * angular * angular - stiffness))).asin() / angular;
    let float = course.floats[0];
    assert!((float.time - leaves).abs() < 1e-7, "{} {leaves}", float.time);
    // Free: M ÿ = −k (δ0 + y).
    let own = (stiffness / MASS).sqrt();
    let (place, speed) = (amplitude * (angular * leaves).sin(), amplitude * angular * (angular * leaves).cos());
    let flies = |time: f64| {
        let since = own * (time - leaves);
        (pressed + place) * since.cos() + speed / own * since.sin() - pressed
    };
    let above = |time: f64| flies(time) - amplitude * (angular * time).sin();
    let (mut low, mut high) = (leaves + 1e-4, leaves + 1e-4);
    while above(high) > 0.0 {
        (low, high) = (high, high + 1e-5);
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if above(middle) > 0.0 { low = middle } else { high = middle }
    }
    let back = float.back.unwrap();
    assert!((back - low).abs() < 2e-6, "{back} {low}");
    assert!(float.impulse > 0.0 && (float.impulse / (MASS * float.closing_speed) - 1.0).abs() < 1e-3);
    // While it flies, u1 is where it is, and nothing pushes it.
    let u1 = touching.signals.channel(Channel::U1).unwrap();
    for (sample, time) in times.iter().enumerate().filter(|(_, time)| **time > leaves && **time < back) {
        // A third of the spring flies along: 3e-6 of the mass.
        assert!((u1[sample] - flies(*time)).abs() < 1e-7, "{}", u1[sample] - flies(*time));
    }
    assert!(course.balance.open().abs() < 1e-10 * course.balance.moved, "{:?}", course.balance);
}

#[test]
fn a_follower_that_stays_on_its_cam_changes_no_bit() {
    let motion = Motion::new(&spring(1), &sine(1e-3, 60.0)).unwrap();
    let times = grid(0.1, 2000);
    let touching = Touching::of(&motion, &hard().with_follower(MASS).unwrap(), &times, true).unwrap();
    assert!(touching.course.is_none());
    assert_eq!(touching.signals, motion.signals(&times).unwrap());
    assert_eq!(touching.windings, Some(motion.windings(&times).unwrap()));
}

#[test]
fn no_cam_pulls_and_no_follower_falls_through_it() {
    let lobe = EndInput::HalfSine { height: 6e-3, from: 2e-3, duration: 5e-3 };
    let excitation = Excitation::new(0.048, lobe, EndInput::Held, excitation::Start::Rest).unwrap();
    let dampings = [Damping::None, Damping::Modal(0.01), Damping::StiffnessProportional { time: 1e-6 }];
    for (damping, masses) in dampings.into_iter().flat_map(|damping| [(damping.clone(), 1), (damping, 4)]) {
        for far_end in [FarEnd::Position, FarEnd::Mass(0.2)] {
            let mount = Mount::new(far_end, damping.clone()).unwrap();
            let motion = Motion::mounted(&spring(masses), &mount, &excitation).unwrap();
            for contact in [hard(), Contact::hard(0.5).unwrap().at_pitch(PITCH).unwrap().with_lift_off(true)] {
                let seats = masses == 1 || far_end == FarEnd::Position;
                let contact = contact.with_ends(seats).with_follower(0.3).unwrap();
                let times = grid(0.02, 2000);
                let touching = Touching::of(&motion, &contact, &times, true).unwrap();
                let course = touching.course.as_ref().unwrap();
                assert!(course.given_up.is_none() && !course.floats.is_empty(), "{:?}", course.given_up);
                assert!(course.cam_force.iter().all(|force| *force > -1e-5));
                let open = course.balance.open().abs();
                assert!(open < 1e-9 * course.balance.moved, "{damping:?} {masses} {open:e} {:?}", course.balance);
                let reached = times.len() - course.end1.len();
                for (place, time) in course.end1.iter().zip(&times[reached..]) {
                    let cam = excitation.input(coilsense::End::One).displacement(*time);
                    assert!(place - cam > -1e-10, "{time}: {:e}", place - cam);
                }
            }
        }
    }
}

#[test]
fn what_no_follower_can_be_is_refused() {
    assert!(hard().with_follower(0.0).is_err());
    let error = Contact::elastic(1e9, 1.0).unwrap().with_follower(0.1).unwrap_err().to_string();
    assert!(error.contains("take hard ones"), "{error}");
    // End turns on a follower may be of any number of masses; on a mass at end 2 of one.
    let contact = hard().with_ends(true).with_follower(0.1).unwrap();
    assert!(
        Touching::of(&Motion::new(&spring(4), &sine(1e-3, 60.0)).unwrap(), &contact, &grid(0.1, 100), false).is_ok()
    );
    let mount = Mount::new(FarEnd::Mass(0.2), Damping::None).unwrap();
    let motion = Motion::mounted(&spring(4), &mount, &sine(1e-3, 60.0)).unwrap();
    let error = Touching::of(&motion, &contact, &grid(0.1, 100), false).unwrap_err().to_string();
    assert!(error.contains("end 2 is a mass"), "{error}");
    let chain = Chain::of(&spring(4), FarEnd::Position, PITCH, true).unwrap().on_follower(0.1).unwrap();
    assert!(chain.on_follower(0.1).unwrap_err().to_string().contains("at most one"));
}
