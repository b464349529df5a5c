//! Steps in both precisions, beside `Motion` and beside the exponential of the masses' equations.

use coilsense::plant::{ModalPlant, Order};
use coilsense::signals::Channel;
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, Start};
use coilsense_rt::Real;

use super::{Course, FAR_ENDS, mounts, s_t};

/// Grids of lengths \[m\] and forces \[N\].
const LENGTHS: f64 = 4.656_612_873_077_393e-10;
const FORCES: f64 = 9.536_743_164_062_5e-7;

/// Inputs at samples, the second in newtons where it is a force.
pub fn inputs(course: Course, spring: &Spring, mount: &Mount, count: usize) -> Vec<[f64; 2]> {
    let scale = if mount.far_end() == FarEnd::Position { 1.0 } else { spring.stiffness() };
    // As an encoder counts: single precision holds them, and what lies half way between two.
    let on = |grid: f64, value: f64| (value / grid).round() * grid;
    let grids = [LENGTHS, if mount.far_end() == FarEnd::Position { LENGTHS } else { FORCES }];
    let counted = |[first, second]: [f64; 2]| [on(grids[0], first), on(grids[1], scale * second)];
    (0..count).map(|k| counted(course.at(k, count))).collect()
}

/// The motion of inputs that are straight between samples.
pub fn motion(spring: &Spring, mount: &Mount, step: f64, inputs: &[[f64; 2]]) -> Motion {
    let times: Vec<f64> = (0..inputs.len()).map(|k| k as f64 * step).collect();
    let recorded = |end: usize| {
        let values = inputs.iter().map(|both| both[end]).collect();
        EndInput::Sampled(coilsense::excitation::Sampled::new(times.clone(), values).unwrap())
    };
    let excitation = Excitation::new(0.23, recorded(0), recorded(1), Start::Rest).unwrap();
    Motion::mounted(spring, mount, &excitation).unwrap()
}

/// F_i, F_o, F_x of the motion half a step after each sample but the last: there no force of a dashpot jumps.
fn by_motion(spring: &Spring, mount: &Mount, step: f64, inputs: &[[f64; 2]]) -> [Vec<f64>; 3] {
    let motion = motion(spring, mount, step, inputs);
    let between: Vec<f64> = (0..inputs.len() - 1).map(|k| k as f64 * step + 0.5 * step).collect();
    let signals = motion.signals(&between).unwrap();
    [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce]
        .map(|channel| signals.channel(channel).unwrap().to_vec())
}

/// The same by steps of half that size.
fn by_steps<T: Real + Into<f64>, const MODES: usize>(
    plant: &ModalPlant,
    step: f64,
    inputs: &[[f64; 2]],
) -> [Vec<f64>; 3] {
    let steps = plant.settings::<MODES>().unwrap().plant::<T>(0.5 * step).unwrap();
    let mut state = steps.settled(inputs[0].map(T::nearest));
    let mut forces = [Vec::new(), Vec::new(), Vec::new()];
    for pair in inputs.windows(2) {
        let middle = [0.5 * (pair[0][0] + pair[1][0]), 0.5 * (pair[0][1] + pair[1][1])];
        let out = steps.step(&mut state, middle.map(T::nearest));
        for (series, value) in forces.iter_mut().zip([out.input, out.output, out.deflection]) {
            series.push(value.into());
        }
        steps.step(&mut state, pair[1].map(T::nearest));
    }
    forces
}

/// Largest difference over the largest peak of what oscillates.
fn off(ours: &[Vec<f64>; 3], theirs: &[Vec<f64>; 3]) -> f64 {
    let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
    for (ours, theirs) in ours.iter().zip(theirs) {
        assert_eq!(ours.len(), theirs.len());
        for (a, b) in ours.iter().zip(theirs) {
            worst = worst.max(if (a - b).is_nan() { f64::INFINITY } else { (a - b).abs() });
            peak = peak.max((b - theirs[0]).abs());
        }
    }
    worst / peak
}

/// What the last digit of a time means at the fastest mode, or 1e-10 where that is more: undamped for an hour, no way of evaluating knows better.
fn allowed(plant: &ModalPlant, until: f64) -> f64 {
    let fastest = plant.modes().iter().fold(0.0_f64, |fastest, mode| fastest.max(mode.frequency));
    f64::max(1e-10, 2.0 * f64::EPSILON * until * fastest)
}

fn agree<const MODES: usize>(spring: &Spring, mount: &Mount, steps: &[f64]) {
    // Twice as many steps as samples: 10⁵.
    let count = 50_001;
    let plant = ModalPlant::new(spring, mount, 0.23, Order::All).unwrap();
    for &step in steps {
        for course in [Course::Rough, Course::Ramps, Course::Slow] {
            let inputs = inputs(course, spring, mount, count);
            let theirs = by_motion(spring, mount, step, &inputs);
            let double = off(&by_steps::<f64, MODES>(&plant, step, &inputs), &theirs);
            let single = off(&by_steps::<f32, MODES>(&plant, step, &inputs), &theirs);
            let what = format!("{mount:?}, {course:?} in steps of {step} s");
            // 5.7e-10 at most, where 2.6e-9 is allowed: undamped and rough for 5000 s. All others are below 1e-10.
            assert!(double < allowed(&plant, step * count as f64), "{what}: {double:e}");
            // 8.7e-5 measured, where the peak is a thousandth of the preload, of which single precision has seven digits.
            assert!(single < 1e-4, "{what}: {single:e} in single precision");
        }
    }
}

/// Mounts of one kind.
fn mounted(wanted: FarEnd) -> impl Iterator<Item = Mount> {
    mounts().into_iter().filter(move |mount| mount.far_end() == wanted)
}

const STEPS: [f64; 4] = [1e-6, 1e-4, 1e-3, 0.1];

#[test]
fn steps_are_the_motion_between_two_positions() {
    mounted(FarEnd::Position).for_each(|mount| agree::<8>(&s_t(8.0), &mount, &STEPS));
}

#[test]
fn steps_are_the_motion_under_a_force() {
    mounted(FarEnd::Force).for_each(|mount| agree::<8>(&s_t(8.0), &mount, &STEPS));
}

#[test]
fn steps_are_the_motion_of_a_mass() {
    mounted(FAR_ENDS[2]).for_each(|mount| agree::<9>(&s_t(8.0), &mount, &STEPS));
}

#[test]
fn steps_of_fifty_two_modes_are_the_motion() {
    let spring = s_t(52.0);
    for damping in [Damping::None, Damping::Modal(0.005)] {
        for far_end in FAR_ENDS {
            let mount = Mount::new(far_end, damping.clone()).unwrap();
            match far_end {
                FarEnd::Mass(_) => agree::<53>(&spring, &mount, &[2e-4]),
                _ => agree::<52>(&spring, &mount, &[2e-4]),
            }
        }
    }
}

/// `tests/golden/plant.csv`, made by `reference/plant.py`: samples of 0.3 ms of S_T in eight masses, at 0.23 m.
#[test]
fn steps_are_the_exponential_of_the_masses_equations() {
    let path = format!("{}/tests/golden/plant.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(&path).expect(&path);
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect(&path)).collect();
    assert_eq!(rows.len(), 9 * 60, "{path}");
    for case in rows.chunks(60) {
        let far_end = match &case[0][0] {
            "position" => FarEnd::Position,
            "force" => FarEnd::Force,
            _ => FarEnd::Mass(0.1),
        };
        let damping = match &case[0][1] {
            "none" => Damping::None,
            "mass" => Damping::MassProportional { rate: 20.0 },
            _ => Damping::StiffnessProportional { time: 3e-4 },
        };
        let plant = ModalPlant::new(&s_t(8.0), &Mount::new(far_end, damping).unwrap(), 0.23, Order::All).unwrap();
        let worst = if plant.count() == 9 { beside::<9>(&plant, case) } else { beside::<8>(&plant, case) };
        // 1.4e-14 N measured, the last digit of 100 N, and 5e-19 m.
        assert!(worst[0] < 1e-13 && worst[1] < 1e-17, "{:?}: {worst:?}", plant.mount());
    }
}

/// Largest differences of forces \[N\] and of u2 \[m\].
fn beside<const MODES: usize>(plant: &ModalPlant, rows: &[csv::StringRecord]) -> [f64; 2] {
    let steps = plant.settings::<MODES>().unwrap().plant::<f64>(3e-4).unwrap();
    let mut state = steps.settled([0.0; 2]);
    let mut worst = [0.0_f64; 2];
    for row in rows {
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        let out = steps.step(&mut state, [number(2), number(3)]);
        for (column, ours) in [(4, out.input), (5, out.output), (6, out.deflection)] {
            worst[0] = worst[0].max((ours - number(column)).abs());
        }
        worst[1] = worst[1].max((out.end - number(7)).abs());
    }
    worst
}
