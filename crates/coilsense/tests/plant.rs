//! A plant against the motion that it is a step of, on every mount, damping and straight input.
//!
//! | ours | beside |
//! |---|---|
//! | steps of `coilsense_rt::Plant`, both precisions | `Motion` of recordings, which shares modes but no step |
//! | the same, in double precision | exponential of the masses' equations in mpmath, 20 digits, no modes |
//! | `ModalPlant::response` | `TwoPort`, in closed form |
//! | `StateSpace`, `Sampled` | the modal sums, the steps |

use coilsense::plant::{ModalPlant, Order, StateSpace};
use coilsense::signals::Channel;
use coilsense::two_port::TwoPort;
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, SpringParameters, Start};
use coilsense_rt::{Real, Refused};

fn s_t(windings: f64) -> Spring {
    Spring::new(SpringParameters { windings, ..coilsense::paper::S_T }).unwrap()
}

const FAR_ENDS: [FarEnd; 3] = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.1)];

fn dampings() -> [Damping; 7] {
    [
        Damping::None,
        Damping::Modal(0.005),
        Damping::StiffnessProportional { time: 3e-4 },
        Damping::MassProportional { rate: 20.0 },
        Damping::Modal(1.0),
        Damping::Modal(3.0),
        Damping::StiffnessProportional { time: 1e-6 },
    ]
}

fn mounts() -> Vec<Mount> {
    let each = FAR_ENDS.into_iter().flat_map(|far_end| dampings().map(|damping| (far_end, damping)));
    each.map(|(far_end, damping)| Mount::new(far_end, damping).unwrap()).collect()
}

/// Both inputs of a sample k, some rough and some slow; one begins late, one comes to rest.
#[derive(Clone, Copy, Debug)]
enum Course {
    Rough,
    Ramps,
    Slow,
}

impl Course {
    fn at(self, k: usize, count: usize) -> [f64; 2] {
        let t = k as f64;
        match self {
            // Of a congruential series: every mode is hit.
            Self::Rough => {
                let noise = |seed: u64| {
                    let mixed = (k as u64 + seed).wrapping_mul(0x9E37_79B9_7F4A_7C15);
                    (mixed ^ (mixed >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9) as f64 / u64::MAX as f64 - 0.5
                };
                if k == 0 { [0.0; 2] } else { [1e-4 * noise(1), 2e-4 * noise(77)] }
            }
            Self::Ramps => {
                let ramp = |from: f64, until: f64| ((t - from) / (until - from)).clamp(0.0, 1.0);
                [2e-3 * ramp(10.0, 14.0), -1e-3 * ramp(20.0, 0.3 * count as f64)]
            }
            Self::Slow => [1e-3 * (0.013 * t).sin(), 1e-3 * ((0.002 * t).cos() - 1.0)],
        }
    }
}

/// Grids of lengths \[m\] and forces \[N\].
const LENGTHS: f64 = 4.656_612_873_077_393e-10;
const FORCES: f64 = 9.536_743_164_062_5e-7;

/// Inputs at samples, the second in newtons where it is a force.
fn inputs(course: Course, spring: &Spring, mount: &Mount, count: usize) -> Vec<[f64; 2]> {
    let scale = if mount.far_end() == FarEnd::Position { 1.0 } else { spring.stiffness() };
    // As an encoder counts: single precision holds them, and what lies half way between two.
    let on = |grid: f64, value: f64| (value / grid).round() * grid;
    let grids = [LENGTHS, if mount.far_end() == FarEnd::Position { LENGTHS } else { FORCES }];
    let counted = |[first, second]: [f64; 2]| [on(grids[0], first), on(grids[1], scale * second)];
    (0..count).map(|k| counted(course.at(k, count))).collect()
}

/// F_i, F_o, F_x of the motion half a step after each sample but the last: there no force of a dashpot jumps.
fn by_motion(spring: &Spring, mount: &Mount, step: f64, inputs: &[[f64; 2]]) -> [Vec<f64>; 3] {
    let times: Vec<f64> = (0..inputs.len()).map(|k| k as f64 * step).collect();
    let recorded = |end: usize| {
        let values = inputs.iter().map(|both| both[end]).collect();
        EndInput::Sampled(coilsense::excitation::Sampled::new(times.clone(), values).unwrap())
    };
    let excitation = Excitation::new(0.23, recorded(0), recorded(1), Start::Rest).unwrap();
    let motion = Motion::mounted(spring, mount, &excitation).unwrap();
    let between: Vec<f64> = times[..times.len() - 1].iter().map(|time| time + 0.5 * step).collect();
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

fn norm(response: &[[num_complex::Complex64; 2]; 3]) -> f64 {
    response.iter().flatten().fold(0.0, |most, value| most.max(value.norm()))
}

#[test]
fn its_response_is_that_of_the_two_port() {
    let spring = s_t(52.0);
    for damping in dampings() {
        let mount = Mount::new(FarEnd::Position, damping.clone()).unwrap();
        let plant = ModalPlant::new(&spring, &mount, 0.23, Order::All).unwrap();
        let port = TwoPort::chain(&spring, damping).unwrap();
        for hertz in [0.1, 10.0, 53.0, 300.0, 1700.0, 5000.0] {
            let ours = plant.response(hertz).unwrap();
            let theirs = port.at(std::f64::consts::TAU * hertz).unwrap().matrix();
            for (ours, theirs) in ours.iter().zip(theirs) {
                for (ours, theirs) in ours.iter().zip(theirs) {
                    assert!((ours - theirs).norm() < 1e-11 * norm(&plant.response(hertz).unwrap()), "{hertz} Hz");
                }
            }
        }
    }
}

#[test]
fn an_order_keeps_the_error_that_was_asked_for() {
    let spring = s_t(52.0);
    for mount in mounts() {
        let all = ModalPlant::new(&spring, &mount, 0.23, Order::All).unwrap();
        for (error, bandwidth) in [(0.1, 50.0), (0.01, 100.0), (1e-4, 200.0), (1e-9, 700.0)] {
            let plant = ModalPlant::new(&spring, &mount, 0.23, Order::Within { error, bandwidth }).unwrap();
            assert!(plant.error(bandwidth).unwrap() <= error);
            let [one, other] = match mount.far_end() {
                FarEnd::Position => [spring.stiffness(); 2],
                _ => [spring.stiffness(), 1.0],
            };
            // At frequencies that were not looked at.
            for share in [0.01, 0.337, 0.777, 0.9999] {
                let hertz = share * bandwidth;
                let (ours, theirs) = (plant.response(hertz).unwrap(), all.response(hertz).unwrap());
                let rounding = 1e-13 * norm(&theirs);
                for (ours, theirs) in ours.iter().zip(&theirs) {
                    let missed = [(ours[0] - theirs[0]).norm() / one, (ours[1] - theirs[1]).norm() / other];
                    // Rounding beside a resonance that both have.
                    assert!(missed.iter().all(|missed| *missed <= error + rounding), "{mount:?} {hertz}: {missed:?}");
                }
            }
            if plant.kept() > 1 && plant.kept() < plant.available() {
                let fewer = ModalPlant::new(&spring, &mount, 0.23, Order::Modes(plant.kept() - 1)).unwrap();
                assert!(fewer.error(bandwidth).unwrap() > error, "as few as it can be");
            }
        }
    }
}

#[test]
fn what_is_left_out_falls_with_the_third_and_the_fifth_power() {
    // What stands for modes beyond n has their inertia, Σ 1/j²; what is missed of a force at the other end goes with 1/n³, and at the own end, whose
    // next term is kept too, with 1/n⁵. Of both the first is left.
    let spring = s_t(400.0);
    let error = |modes| {
        let plant = ModalPlant::new(&spring, &Mount::default(), 0.23, Order::Modes(modes)).unwrap();
        plant.error(20.0).unwrap()
    };
    let order = (error(8) / error(32)).log2() / 2.0;
    assert!((2.5..4.6).contains(&order), "{order}");
}

#[test]
fn another_stiffness_mass_and_damping_are_those_of_another_spring() {
    let spring = s_t(8.0);
    let parameters = spring.parameters().clone();
    let other = Spring::new(SpringParameters { stiffness: 1100.0, mass: 0.045, ..parameters.clone() }).unwrap();
    let heavy = Spring::new(SpringParameters { stiffness: 1100.0, ..parameters }).unwrap();
    for far_end in FAR_ENDS {
        let (mass, other) = if let FarEnd::Mass(_) = far_end { (0.065, &heavy) } else { (0.045, &other) };
        match far_end {
            FarEnd::Mass(_) => changed_is_other::<9>(&spring, other, far_end, mass),
            _ => changed_is_other::<8>(&spring, other, far_end, mass),
        }
    }
}

fn changed_is_other<const MODES: usize>(spring: &Spring, other: &Spring, far_end: FarEnd, mass: f64) {
    let settings = |spring: &Spring, damping| {
        let mount = Mount::new(far_end, damping).unwrap();
        ModalPlant::new(spring, &mount, 0.23, Order::All).unwrap().settings::<MODES>().unwrap()
    };
    // Of dashpots, ζ_1 is β ω_1/2 of the spring that has them.
    let dashpots = settings(other, Damping::StiffnessProportional { time: 3e-5 });
    let cases = [
        (settings(spring, Damping::None), settings(other, Damping::Modal(0.02))),
        (settings(spring, Damping::Modal(0.5)), settings(other, Damping::Modal(0.02))),
        (settings(spring, Damping::StiffnessProportional { time: 7e-5 }), dashpots),
    ];
    for (ours, theirs) in cases {
        let changed = ours.changed::<f64>(1100.0, mass, theirs.damping_ratio, 3e-4).unwrap();
        let other = theirs.plant::<f64>(3e-4).unwrap();
        let (mut a, mut b) = (changed.settled([0.0; 2]), other.settled([0.0; 2]));
        for k in 0..2000 {
            let inputs = Course::Slow.at(k, 2000);
            let (ours, theirs) = (changed.step(&mut a, inputs), other.step(&mut b, inputs));
            assert!((ours.input - theirs.input).abs() < 1e-10 && (ours.output - theirs.output).abs() < 1e-10);
            assert!((ours.deflection - theirs.deflection).abs() < 1e-10 && (ours.end - theirs.end).abs() < 1e-12);
        }
    }
}

#[test]
fn matrices_are_the_same_plant() {
    let spring = s_t(8.0);
    for mount in mounts() {
        let plant = ModalPlant::new(&spring, &mount, 0.23, Order::Modes(4)).unwrap();
        assert_eq!((plant.kept(), plant.count()), (4, 6));
        let space = plant.state_space();
        for hertz in [1.0, 40.0, 130.0] {
            let drive = std::f64::consts::TAU * hertz;
            let theirs = plant.response(hertz).unwrap();
            for (output, row) in theirs.iter().enumerate() {
                for (input, expected) in row.iter().enumerate() {
                    let ours = by_matrices(&space, drive, output, input);
                    assert!((ours - expected).norm() < 1e-10 * norm(&theirs), "{mount:?} {hertz}: {ours} {expected}");
                }
            }
        }
    }
}

/// C (iΩ − A)⁻¹ B + D + iΩ D_v.
fn by_matrices(space: &StateSpace, drive: f64, output: usize, input: usize) -> num_complex::Complex64 {
    use num_complex::Complex64;
    let s = Complex64::new(0.0, drive);
    let states = space.a.len();
    let matrix = nalgebra::DMatrix::from_fn(states, states, |row, column| {
        (if row == column { s } else { Complex64::ZERO }) - space.a[row][column]
    });
    let right = nalgebra::DVector::from_fn(states, |row, _| Complex64::from(space.b[row][input]));
    let solved = matrix.lu().solve(&right).unwrap();
    let through: Complex64 = space.c[output].iter().zip(solved.iter()).map(|(weight, x)| *weight * x).sum();
    through + space.d[output][input] + s * space.d_rate[output][input]
}

#[test]
fn matrices_of_a_step_give_what_steps_give() {
    let spring = s_t(8.0);
    for mount in mounts() {
        let plant = ModalPlant::new(&spring, &mount, 0.23, Order::Modes(5)).unwrap();
        let count = plant.count();
        let (step, samples) = (2e-4, 10_000);
        let sampled = plant.sampled(step).unwrap();
        let mut x = vec![0.0; sampled.a.len()];
        let steps = plant.settings::<7>().map(|settings| settings.plant::<f64>(step).unwrap()).unwrap();
        assert_eq!(count, 7);
        let mut state = steps.settled([0.0; 2]);
        let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
        for k in 0..samples {
            let u = Course::Slow.at(k, samples);
            let out = steps.step(&mut state, u);
            for (output, value) in [out.input, out.output, out.deflection].into_iter().enumerate() {
                let of_states: f64 = sampled.c[output].iter().zip(&x).map(|(c, x)| c * x).sum();
                let ours = of_states + sampled.d[output][0] * u[0] + sampled.d[output][1] * u[1];
                worst = worst.max((ours - (value - plant.mean_force())).abs());
                peak = peak.max(ours.abs());
            }
            let next = |row: &Vec<f64>, b: &[f64; 2]| {
                row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>() + b[0] * u[0] + b[1] * u[1]
            };
            x = sampled.a.iter().zip(&sampled.b).map(|(row, b)| next(row, b)).collect();
        }
        assert!(worst < 1e-10 * peak, "{mount:?}: {worst:e} of {peak}");
    }
}

#[test]
fn what_no_plant_can_have_is_refused_in_a_line() {
    let spring = s_t(8.0);
    let told = |order| ModalPlant::new(&spring, &Mount::default(), 0.23, order).unwrap_err().to_string();
    assert_eq!(told(Order::Modes(0)), "modes must be from 1 to 8, got 0");
    assert_eq!(told(Order::Modes(9)), "modes must be from 1 to 8, got 9");
    let within = |error, bandwidth| told(Order::Within { error, bandwidth });
    assert_eq!(within(0.0, 100.0), "error must be above zero and below one, got 0");
    assert_eq!(within(0.1, -1.0), "bandwidth must be above zero and finite, got -1 Hz");
    let plant = ModalPlant::new(&spring, &Mount::default(), 0.23, Order::All).unwrap();
    assert_eq!(plant.sampled(0.0).unwrap_err().to_string(), "step must be above zero and finite, got 0 s");
    assert_eq!(plant.settings::<7>().unwrap_err().to_string(), "modes must hold 7 values, got 8");
    let settings = plant.settings::<8>().unwrap();
    for (k, m, ratio, step, refused) in [
        (0.0, 0.065, 0.0, 1e-4, Refused::Stiffness),
        (760.0, f64::NAN, 0.0, 1e-4, Refused::Mass),
        (760.0, 0.065, -0.1, 1e-4, Refused::DampingRatio),
        (760.0, 0.065, 1001.0, 1e-4, Refused::DampingRatio),
        (760.0, 0.065, 0.0, 0.0, Refused::Step),
        (760.0, 0.065, 0.0, 1e7, Refused::Step),
    ] {
        assert_eq!(settings.changed::<f64>(k, m, ratio, step).unwrap_err(), refused);
    }
    let loaded = Mount::new(FarEnd::Mass(0.1), Damping::None).unwrap();
    let loaded = ModalPlant::new(&spring, &loaded, 0.23, Order::All).unwrap().settings::<9>().unwrap();
    assert_eq!(loaded.changed::<f32>(760.0, 0.07, 0.0, 1e-4).unwrap_err(), Refused::Mass);
}
