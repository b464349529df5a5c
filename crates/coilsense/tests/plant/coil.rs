//! How near a plant's windings are, and L and F_L by them: beside the positions of `Motion`, `Clash` and Maxwell's sum over them.

use coilsense::calibrate::Calibration;
use coilsense::inductance::{MaxwellSum, SecondOrder, SelfDistance};
use coilsense::plant::{ModalPlant, Order};
use coilsense::sections::{Section, Sections};
use coilsense::sensors::InductanceSensor;
use coilsense::{Clash, Damping, FarEnd, Motion, Mount, Spring};
use coilsense_rt::Real;

use super::forms::by_matrices;
use super::steps::{inputs, motion};
use super::{Course, FAR_ENDS, mounts, s_t};

const STEP: f64 = 2e-4;
/// So fine that what is straight between samples is a sine.
const FINE: f64 = 4e-5;
const SAMPLES: usize = 400;

fn coil(spring: &Spring) -> (MaxwellSum, Calibration, [f64; 2]) {
    let sum = MaxwellSum::new(spring, SelfDistance::AsPrinted);
    let calibration = Calibration::theoretical(spring, &sum, 0.23).unwrap();
    (sum, calibration, [0.19, 0.27])
}

/// A number of each sample: smallest pitch \[m\], L \[H\], F_L \[N\].
type Read = [f64; 3];

/// By positions, without modes of the plant: L by Maxwell's sum, exactly.
fn by_positions(spring: &Spring, mount: &Mount, inputs: &[[f64; 2]]) -> Vec<Read> {
    let (sum, calibration, _) = coil(spring);
    let motion: Motion = motion(spring, mount, STEP, inputs);
    let times: Vec<f64> = (0..inputs.len()).map(|k| k as f64 * STEP).collect();
    let windings = motion.windings(&times).unwrap();
    let inductances = sum.series(&windings);
    let forces = InductanceSensor::new(spring, calibration).force(&inductances);
    let closest = |time: &f64| Clash::of(&motion, &[*time]).unwrap().smallest_pitch;
    times
        .iter()
        .map(closest)
        .zip(inductances)
        .zip(forces)
        .map(|((pitch, henry), force)| [pitch, henry, force])
        .collect()
}

/// By steps, with the bounds of L and of F_L.
fn by_steps<T: Real + Into<f64>, const MODES: usize, const PITCHES: usize, const GAPS: usize>(
    plant: &ModalPlant,
    inputs: &[[f64; 2]],
) -> Vec<(Read, [f64; 2])> {
    let (sum, calibration, lengths) = coil(plant.spring());
    let near = plant.windings(2e-3).unwrap().settings::<T, MODES, PITCHES>().unwrap();
    let made = plant.coil(&sum, calibration, lengths).unwrap();
    assert!(made.left() <= 1e-11, "{} {}", made.inductance().len(), made.left());
    let steps = plant.settings::<MODES>().unwrap().plant::<T>(STEP).unwrap();
    let mut state = steps.settled(inputs[0].map(T::nearest));
    let each = inputs.iter().map(|row| {
        steps.step(&mut state, row.map(T::nearest));
        // As many coefficients as were needed, each a type of its own.
        let reading = match made.inductance().len() {
            9 => made.settings::<T, MODES, GAPS, 9>().unwrap().reading(&steps, &state),
            10 => made.settings::<T, MODES, GAPS, 10>().unwrap().reading(&steps, &state),
            11 => made.settings::<T, MODES, GAPS, 11>().unwrap().reading(&steps, &state),
            12 => made.settings::<T, MODES, GAPS, 12>().unwrap().reading(&steps, &state),
            13 => made.settings::<T, MODES, GAPS, 13>().unwrap().reading(&steps, &state),
            terms => panic!("{terms} coefficients: one more row here"),
        };
        let pitch = near.closest_pitch(&steps, &state);
        let read = [pitch, reading.inductance, reading.force].map(Into::into);
        (read, [reading.inductance_bound, reading.force_bound].map(Into::into))
    });
    each.collect()
}

fn agree<const MODES: usize, const PITCHES: usize, const GAPS: usize>(spring: &Spring, mount: &Mount) {
    let plant = ModalPlant::new(spring, mount, 0.23, Order::All).unwrap();
    for course in [Course::Rough, Course::Ramps, Course::Slow] {
        let inputs = inputs(course, spring, mount, SAMPLES);
        let theirs = by_positions(spring, mount, &inputs);
        let way = theirs.iter().fold(0.0_f64, |way, read| way.max((read[0] - theirs[0][0]).abs())).max(1e-6);
        for (k, ((ours, bounds), theirs)) in
            by_steps::<f64, MODES, PITCHES, GAPS>(&plant, &inputs).iter().zip(&theirs).enumerate()
        {
            let what = format!("{mount:?}, {course:?}, sample {k}: {ours:?} within {bounds:?} of {theirs:?}");
            assert!((ours[0] - theirs[0]).abs() < 1e-9 * way, "{what}");
            assert!((ours[1] - theirs[1]).abs() <= bounds[0], "{what}");
            assert!((ours[2] - theirs[2]).abs() <= bounds[1], "{what}");
            // A bound that says nothing is none.
            assert!(bounds[0] < 1e-3 * theirs[1] && bounds[1] < 0.5, "{what}");
        }
        for ((ours, bounds), theirs) in by_steps::<f32, MODES, PITCHES, GAPS>(&plant, &inputs).iter().zip(&theirs) {
            // Places of the modes are those of single precision, too: 1e-4 of the way.
            let what = format!("{mount:?}, {course:?}, single: {ours:?} within {bounds:?} of {theirs:?}");
            assert!((ours[0] - theirs[0]).abs() < 1e-4 * way + 5e-9, "{what}");
            assert!((ours[1] - theirs[1]).abs() <= 1.1 * bounds[0], "{what}");
            assert!((ours[2] - theirs[2]).abs() <= 1.1 * bounds[1], "{what}");
        }
    }
}

#[test]
fn windings_and_inductance_are_those_of_the_motion() {
    for mount in mounts() {
        match mount.far_end() {
            FarEnd::Mass(_) => agree::<13, 11, 11>(&s_t(12.0), &mount),
            _ => agree::<12, 11, 11>(&s_t(12.0), &mount),
        }
    }
}

#[test]
fn fifty_two_windings_and_parts_of_one_are_those_of_the_motion() {
    for far_end in FAR_ENDS {
        let mount = Mount::new(far_end, Damping::Modal(0.005)).unwrap();
        let refined = s_t(12.4).with_masses_per_winding(3).unwrap();
        match far_end {
            FarEnd::Mass(_) => {
                agree::<53, 51, 51>(&s_t(52.0), &mount);
                agree::<37, 33, 11>(&refined, &mount);
            }
            _ => {
                agree::<52, 51, 51>(&s_t(52.0), &mount);
                agree::<36, 33, 11>(&refined, &mount);
            }
        }
    }
}

#[test]
fn the_bound_covers_windings_that_nearly_meet_and_says_when_they_would() {
    let mount = Mount::new(FarEnd::Position, Damping::Modal(0.005)).unwrap();
    let spring = s_t(52.0);
    let plant = ModalPlant::new(&spring, &mount, 0.23, Order::All).unwrap();
    let (mut met, mut near) = (0, 0);
    // Blows of ever more m/s: from nothing to windings that meet.
    for speed in [-6.0, 0.2, 1.0, 3.0, 6.0, 18.0] {
        let blow = |k: usize| [speed * STEP * (k.min(10) as f64), 0.0];
        let inputs: Vec<[f64; 2]> = (0..200).map(blow).collect();
        let theirs = by_positions(&spring, &mount, &inputs);
        for ((ours, bounds), theirs) in by_steps::<f64, 52, 51, 51>(&plant, &inputs).iter().zip(&theirs) {
            if theirs[0] <= 0.0 {
                met += 1;
                assert_eq!(bounds[0], f64::MAX, "windings at {} m", theirs[0]);
            } else if bounds[0] < f64::MAX {
                near += usize::from(bounds[0] > 1e-3 * theirs[1]);
                assert!((ours[1] - theirs[1]).abs() <= bounds[0], "{ours:?} within {bounds:?} of {theirs:?}");
                assert!((ours[2] - theirs[2]).abs() <= bounds[1], "{ours:?} within {bounds:?} of {theirs:?}");
            }
        }
    }
    assert!(met > 10 && near > 100, "{met} samples with windings that meet, {near} with a bound above 1e-3");
}

#[test]
fn the_bound_is_that_of_the_second_order_form() {
    let mount = Mount::new(FarEnd::Mass(0.1), Damping::None).unwrap();
    let spring = s_t(52.0);
    let plant = ModalPlant::new(&spring, &mount, 0.23, Order::All).unwrap();
    let (sum, ..) = coil(&spring);
    let inputs = inputs(Course::Ramps, &spring, &mount, SAMPLES);
    let motion = motion(&spring, &mount, STEP, &inputs);
    for (k, (ours, bounds)) in by_steps::<f64, 53, 51, 51>(&plant, &inputs).iter().enumerate().skip(10).step_by(7) {
        let windings = motion.windings(&[k as f64 * STEP]).unwrap();
        let [first, last] = windings.ends(0);
        let even = |turn: usize| first + (turn as f64 + 0.5) / 52.0 * (last - first);
        let off: Vec<f64> = windings.row(0).iter().enumerate().map(|(turn, place)| place - even(turn)).collect();
        let theirs = SecondOrder::about(&sum, last - first).unwrap().at_displacements(&off).unwrap();
        // What polynomials leave comes on top, and a share of the remainder.
        let slack = 2e-11 * theirs.inductance;
        assert!((ours[1] - theirs.inductance).abs() < slack, "sample {k}: {ours:?}, {theirs:?}");
        let most = 1.005 * theirs.bound + slack;
        assert!((theirs.bound..most).contains(&bounds[0]), "sample {k}: {bounds:?}, {theirs:?}");
    }
}

#[test]
fn few_modes_tell_f_l_within_the_error_that_is_told() {
    for far_end in FAR_ENDS {
        let mount = Mount::new(far_end, Damping::Modal(0.01)).unwrap();
        let spring = s_t(52.0);
        let (sum, calibration, lengths) = coil(&spring);
        let few = ModalPlant::new(&spring, &mount, 0.23, Order::Modes(6)).unwrap();
        let all = ModalPlant::new(&spring, &mount, 0.23, Order::All).unwrap();
        let (slow, fast) =
            (few.coil_error(&sum, calibration, 80.0).unwrap(), few.coil_error(&sum, calibration, 250.0).unwrap());
        assert!(slow < 0.1 * fast && fast < 0.1, "{far_end:?}: {slow:e} up to 80 Hz, {fast:e} up to 250 Hz");
        assert_eq!(all.coil_error(&sum, calibration, 1e4).unwrap(), 0.0);
        assert_eq!(few.coil_error(&sum, calibration, 1e4).unwrap(), f64::INFINITY);

        // A sine that swells over forty periods is nearly steady; F_L less a second-order part is what an error of its response leaves.
        let frequency = 250.0;
        let told = few.coil_error(&sum, calibration, frequency).unwrap();
        let size = 1e-5;
        let swelling = |k: usize| {
            let time = k as f64 * FINE;
            let swell = (time * frequency / 40.0).min(1.0);
            [size * swell * swell * (3.0 - 2.0 * swell) * (std::f64::consts::TAU * frequency * time).sin(), 0.0]
        };
        let force = |plant: &ModalPlant| -> Vec<f64> {
            let made = plant.coil(&sum, calibration, lengths).unwrap();
            let inputs: Vec<[f64; 2]> = (0..8000).map(swelling).collect();
            let read = |mode_count: usize| match mode_count {
                8 => by_count::<8>(plant, &made, &inputs),
                52 => by_count::<52>(plant, &made, &inputs),
                _ => by_count::<53>(plant, &made, &inputs),
            };
            read(plant.count())
        };
        let worst = force(&few).iter().zip(force(&all)).fold(0.0_f64, |worst, (few, all)| worst.max((few - all).abs()));
        let share = worst / (spring.stiffness() * size);
        assert!(share < 1.5 * told + 1e-6, "{far_end:?}: {share:e} where {told:e} is told");
        assert!(share > 0.2 * told, "{far_end:?}: {share:e} where {told:e} is told");
    }
}

fn by_count<const MODES: usize>(
    plant: &ModalPlant,
    made: &coilsense::plant::ModalCoil,
    inputs: &[[f64; 2]],
) -> Vec<f64> {
    let steps = plant.settings::<MODES>().unwrap().plant::<f64>(FINE).unwrap();
    let coil = made.settings::<f64, MODES, 51, 13>().unwrap();
    let mut state = steps.settled(inputs[0]);
    let each = inputs.iter().map(|row| {
        steps.step(&mut state, *row);
        coil.reading(&steps, &state).force
    });
    each.collect()
}

#[test]
fn what_is_not_known_has_no_bound() {
    let plant = ModalPlant::new(&s_t(12.0), &Mount::default(), 0.23, Order::All).unwrap();
    let out_of = |inputs: [f64; 2]| {
        let read = by_steps::<f64, 12, 11, 11>(&plant, &[[0.0; 2], inputs]);
        read[1].1
    };
    let within = out_of([1e-3, 0.0]);
    assert!(within[0] < 1e-9 && within[1] < 1.0, "{within:?}");
    for beyond in [[0.041, 0.0], [-0.041, 0.0], [0.3, 0.0], [f64::NAN, 0.0]] {
        assert_eq!(out_of(beyond), [f64::MAX; 2], "{beyond:?}");
    }
}

#[test]
fn what_has_no_neighbours_or_no_lengths_is_refused() {
    let plant = |spring: &Spring| ModalPlant::new(spring, &Mount::default(), 0.23, Order::All).unwrap();
    let refused = |spring: &Spring, lengths: [f64; 2]| {
        let (_, calibration, _) = coil(&s_t(12.0));
        let sum = MaxwellSum::new(spring, SelfDistance::AsPrinted);
        plant(spring).coil(&sum, calibration, lengths).unwrap_err().to_string()
    };
    let one = s_t(1.0);
    assert!(plant(&one).windings(2e-3).unwrap_err().to_string().contains("at least 2"));
    assert!(refused(&one, [0.2, 0.26]).contains("at least 2"));
    assert!(plant(&s_t(12.0)).windings(0.0).unwrap_err().to_string().contains("contact pitch"));
    assert!(refused(&s_t(12.0), [0.0, 0.26]).contains("shortest length"));
    assert!(refused(&s_t(12.0), [0.26, 0.2]).contains("longest length"));
    assert!(refused(&s_t(12.0), [0.2, 0.22]).contains("mean length"));
    assert!(refused(&s_t(12.0), [1e-4, 5.0]).contains("lose digits"));
    assert!(refused(&s_t(12.0), [0.2, f64::NAN]).contains("longest length"));
    let section = Section {
        windings: 6.0,
        pitch: [4e-3; 2],
        coil_diameter: [16e-3, 18e-3],
        wire_diameter: 2e-3,
        telescopes: false,
    };
    let cone = Spring::of_sections(Sections::new(vec![section], 79.3e9, 7850.0).unwrap(), 0.0, (0.02, 0.03)).unwrap();
    let other = MaxwellSum::new(&cone, SelfDistance::AsPrinted);
    let (_, calibration, lengths) = coil(&s_t(12.0));
    let told = plant(&s_t(6.0)).coil(&other, calibration, lengths).unwrap_err().to_string();
    assert!(told.contains("coil of sections"), "{told}");
}

#[test]
fn f_l_in_a_straight_line_is_that_of_small_motions() {
    let spring = s_t(12.0);
    let (sum, calibration, lengths) = coil(&spring);
    for mount in mounts() {
        let plant = ModalPlant::new(&spring, &mount, 0.23, Order::All).unwrap();
        let made = plant.coil(&sum, calibration, lengths).unwrap();
        let space = plant.state_space(Some(&made));
        assert_eq!((space.c.len(), space.d.len(), space.d_rate[4]), (5, 5, [0.0; 2]));
        for hertz in [1.0, 40.0, 130.0] {
            let theirs = plant.coil_response(&made, hertz).unwrap();
            for (input, expected) in theirs.iter().enumerate() {
                let ours = by_matrices(&space, std::f64::consts::TAU * hertz, 4, input);
                assert!((ours - expected).norm() < 1e-10 * theirs[0].norm().max(theirs[1].norm()), "{mount:?} {hertz}");
            }
        }
        // Both ways of a motion so small that its square does not show, against Maxwell's sum at the motion's positions.
        let sampled = plant.sampled(STEP, Some(&made)).unwrap();
        let courses = inputs(Course::Slow, &spring, &mount, 300);
        let small = |sign: f64| courses.iter().map(|row| row.map(|value| 1e-3 * sign * value)).collect::<Vec<_>>();
        let (plus, minus) = (by_positions(&spring, &mount, &small(1.0)), by_positions(&spring, &mount, &small(-1.0)));
        let mut x = vec![0.0; sampled.a.len()];
        let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
        // A motion begins under the inputs of its first sample, and so do states.
        let first = small(1.0)[0];
        for (u, (plus, minus)) in small(1.0).iter().zip(plus.iter().zip(&minus)) {
            let u = [u[0] - first[0], u[1] - first[1]];
            let dot = |row: &[f64]| row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>();
            let ours = dot(&sampled.c[4]) + sampled.d[4][0] * u[0] + sampled.d[4][1] * u[1];
            let theirs = 0.5 * (plus[2] - minus[2]);
            worst = worst.max((ours - theirs).abs());
            peak = peak.max(theirs.abs());
            let next = sampled.a.iter().zip(&sampled.b).map(|(row, b)| dot(row) + b[0] * u[0] + b[1] * u[1]);
            let next: Vec<f64> = next.collect();
            x = next;
        }
        assert!(worst < 1e-6 * peak && peak > 1e-5, "{mount:?}: {worst:e} of {peak:e}");
    }
}
