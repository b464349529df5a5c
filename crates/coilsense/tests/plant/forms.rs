//! Responses, orders, matrices, other k, m and ζ, and what is refused.

use coilsense::plant::{ModalPlant, Order, StateSpace};
use coilsense::two_port::TwoPort;
use coilsense::{Damping, FarEnd, Mount, Spring, SpringParameters};
use coilsense_rt::Refused;

use super::{Course, FAR_ENDS, dampings, mounts, s_t};

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
        let space = plant.state_space(None);
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
pub fn by_matrices(space: &StateSpace, drive: f64, output: usize, input: usize) -> num_complex::Complex64 {
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
        let sampled = plant.sampled(step, None).unwrap();
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
    let creeping = Mount::new(FarEnd::Position, Damping::StiffnessProportional { time: 10.0 }).unwrap();
    let refused = ModalPlant::new(&spring, &creeping, 0.23, Order::All).unwrap_err().to_string();
    assert!(refused.starts_with("damping ratio of mode 1 must be at most 1000, got 16"), "{refused}");
    let plant = ModalPlant::new(&spring, &Mount::default(), 0.23, Order::All).unwrap();
    assert_eq!(plant.sampled(0.0, None).unwrap_err().to_string(), "step must be above zero and finite, got 0 s");
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
