//! A motion from modes that were found elsewhere: numerically, by nalgebra, from the matrices of the equations of motion.
//!
//! | ours | theirs |
//! |---|---|
//! | a motion of the chain in closed form | the same chain's modes as a table |
//! | a motion of unequal masses and segments | Newmark's integration of the equations of motion |

mod paper_springs;

use coilsense::modes::{ModalModel, ModalParameters};
use coilsense::{Damping, End, EndInput, Excitation, FarEnd, Motion, Mount, Spring, Start};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use paper_springs::s_t_with;

/// Masses \[kg\] in a row, with a segment \[N/m\] before and behind each.
struct Row {
    masses: Vec<f64>,
    segments: Vec<f64>,
    far_end: FarEnd,
}

impl Row {
    fn even(spring: &Spring, far_end: FarEnd) -> Self {
        let n = spring.chain_masses();
        let inner = n as f64 * spring.stiffness();
        let segments = (0..=n).map(|index| if index == 0 || index == n { 2.0 * inner } else { inner }).collect();
        Self { masses: vec![spring.mass() / n as f64; n], segments, far_end }
    }

    fn stiffness(&self) -> f64 {
        1.0 / self.segments.iter().map(|segment| segment.recip()).sum::<f64>()
    }

    /// M and K of the masses, and of end 2 where it is free; what a displacement of end 1 and of end 2 pulls them with.
    fn matrices(&self) -> (DVector<f64>, DMatrix<f64>, [DVector<f64>; 2]) {
        let n = self.masses.len();
        let free = n + usize::from(self.far_end != FarEnd::Position);
        let mut stiffness = DMatrix::zeros(free, free);
        for (index, k) in self.segments.iter().enumerate() {
            for (i, sign_i) in [(index.wrapping_sub(1), -1.0), (index, 1.0)] {
                for (j, sign_j) in [(index.wrapping_sub(1), -1.0), (index, 1.0)] {
                    if i < free && j < free {
                        stiffness[(i, j)] += sign_i * sign_j * k;
                    }
                }
            }
        }
        let mut masses = DVector::from_fn(free, |index, _| self.masses.get(index).copied().unwrap_or(0.0));
        if let FarEnd::Mass(mass) = self.far_end {
            masses[n] = mass;
        }
        let mut pulls = [DVector::zeros(free), DVector::zeros(free)];
        pulls[0][0] = self.segments[0];
        match self.far_end {
            FarEnd::Position => pulls[1][n - 1] = self.segments[n],
            _ => pulls[1][n] = 1.0,
        }
        (masses, stiffness, pulls)
    }

    /// Modes by an eigen-solver; an end without mass is eliminated first.
    fn model(&self) -> ModalModel {
        let n = self.masses.len();
        let (masses, stiffness, _) = self.matrices();
        let massless = self.far_end == FarEnd::Force;
        let kept = if massless { n } else { masses.len() };
        let mut reduced = stiffness.view((0, 0), (kept, kept)).into_owned();
        if massless {
            // End 2 moves with the last mass.
            reduced[(n - 1, n - 1)] -= self.segments[n];
        }
        let root = DVector::from_fn(kept, |index, _| masses[index].sqrt());
        let scaled = DMatrix::from_fn(kept, kept, |i, j| reduced[(i, j)] / (root[i] * root[j]));
        let eigen = SymmetricEigen::new(scaled);
        let mut order: Vec<usize> = (0..kept).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        let shape = |mode: usize, mass: usize| eigen.eigenvectors[(mass, mode)] / root[mass];
        let end = |mode: usize| match self.far_end {
            FarEnd::Position => 0.0,
            FarEnd::Force => shape(mode, n - 1),
            FarEnd::Mass(_) => shape(mode, n),
        };
        let k = self.stiffness();
        let places = (1..=n).map(|count| self.segments[..count].iter().map(|segment| k / segment).sum()).collect();
        let parameters = ModalParameters {
            far_end: self.far_end,
            masses: self.masses.clone(),
            places,
            end_segments: [self.segments[0], self.segments[n]],
            frequencies: order.iter().map(|mode| eigen.eigenvalues[*mode].sqrt()).collect(),
            shapes: order.iter().flat_map(|mode| (0..n).map(|mass| shape(*mode, mass))).collect(),
            end_shapes: order.iter().map(|mode| end(*mode)).collect(),
        };
        ModalModel::new(k, parameters).unwrap()
    }
}

const MEAN: f64 = 0.23;

fn far_ends() -> [FarEnd; 3] {
    [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.4)]
}

/// What is done to a spring whose end 2 is so tied.
fn excitations(far_end: FarEnd, masses: usize) -> Vec<Excitation> {
    let second = match far_end {
        FarEnd::Position => EndInput::Held,
        _ => EndInput::Step { at: 0.01, height: 0.5 },
    };
    let uneven: Vec<f64> = (0..masses).map(|index| 1e-3 * ((3 * index) as f64).sin()).collect();
    let at = |index: usize| (index as f64 + 0.5) / masses as f64 * MEAN + uneven[index];
    let pushed = Start::Windings { positions: (0..masses).map(at).collect(), velocities: uneven.clone() };
    let sine = EndInput::harmonic(1e-3, 40.0, 0.3);
    vec![
        Excitation::new(MEAN, EndInput::Step { at: 0.0, height: 2e-3 }, second.clone(), Start::Rest).unwrap(),
        Excitation::new(MEAN, sine.clone(), EndInput::Held, Start::Massless).unwrap(),
        Excitation::new(MEAN, sine, second, pushed).unwrap(),
    ]
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let size = a.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / size
}

#[test]
fn a_table_of_the_chains_modes_moves_as_the_chain() {
    let spring = Spring::new(s_t_with(|p| p.windings = 9.0)).unwrap();
    let times: Vec<f64> = (0..300).map(|index| 1e-4 * f64::from(index)).collect();
    for far_end in far_ends() {
        for damping in [Damping::None, Damping::Modal(0.03), Damping::StiffnessProportional { time: 1e-4 }] {
            for excitation in excitations(far_end, spring.chain_masses()) {
                let mount = Mount::new(far_end, damping.clone()).unwrap();
                let chain = Motion::mounted(&spring, &mount, &excitation).unwrap();
                let model = Row::even(&spring, far_end).model();
                let table = Motion::of_modes(&spring, model, damping.clone(), &excitation).unwrap();
                let (ours, theirs) = (table.end_forces(&times).unwrap(), chain.end_forces(&times).unwrap());
                assert!(largest_difference(&theirs.input, &ours.input) < 1e-9, "{mount:?}");
                assert!(largest_difference(&theirs.output, &ours.output) < 1e-9, "{mount:?}");
                let positions = |motion: &Motion| motion.windings(&times).unwrap().positions().to_vec();
                assert!(largest_difference(&positions(&chain), &positions(&table)) < 1e-9);
                for time in [0.0, 0.013] {
                    let energies = [chain.energy(time).unwrap(), table.energy(time).unwrap()];
                    assert!((energies[0] / energies[1] - 1.0).abs() < 1e-9, "{mount:?} {energies:?}");
                }
                let least = [chain.least_pitch(0.03), table.least_pitch(0.03)];
                // The table's bound is the tighter: it knows the shapes.
                assert!(least[1] >= least[0] - 1e-12, "{least:?}");
            }
        }
    }
}

#[test]
fn unequal_masses_and_segments_move_as_newmark_integrates_them() {
    for far_end in far_ends() {
        let row = Row {
            masses: vec![0.004, 0.009, 0.002, 0.006, 0.011],
            segments: vec![9e3, 4e3, 7e3, 2.5e3, 6e3, 1.1e4],
            far_end,
        };
        let spring = Spring::new(s_t_with(|p| p.stiffness = row.stiffness())).unwrap();
        let rest = spring.rest_length();
        let input = EndInput::harmonic(1e-3, 60.0, 0.0);
        let excitation = Excitation::new(MEAN, input.clone(), EndInput::Held, Start::Massless).unwrap();
        let motion = Motion::of_modes(&spring, row.model(), Damping::None, &excitation).unwrap();
        let (steps, step) = (40_000, 1e-6);
        let (masses, stiffness, pulls) = row.matrices();
        let free = masses.len();
        // Displacements from the mean state at which all is still, by the trapezoidal rule; an end without mass follows at once.
        let to_solve = DMatrix::from_diagonal(&masses) * (4.0 / (step * step)) + &stiffness;
        let solver = to_solve.lu();
        let mut place = DVector::zeros(free);
        let mut speed = motion_start(&row, input.velocity(0.0));
        let mut pull = DVector::zeros(free);
        let mut forces = [Vec::new(), Vec::new()];
        let mean_force = spring.stiffness() * (MEAN - rest);
        let end_forces = |place: &DVector<f64>, u1: f64| {
            let n = row.masses.len();
            let second = if far_end == FarEnd::Position { 0.0 } else { place[n] };
            [row.segments[0] * (place[0] - u1), row.segments[n] * (second - place[n - 1])]
                .map(|force| mean_force + force)
        };
        for index in 0..=steps {
            let time = f64::from(index) * step;
            if index > 0 {
                let next_pull = &pulls[0] * input.displacement(time);
                let inertia =
                    DVector::from_fn(free, |i, _| masses[i] * (4.0 / (step * step) * place[i] + 4.0 / step * speed[i]));
                let right = inertia + (&pull - &stiffness * &place) + &next_pull;
                let next = solver.solve(&right).unwrap();
                speed = (&next - &place) * (2.0 / step) - &speed;
                (place, pull) = (next, next_pull);
            }
            if index % 100 == 0 {
                let [first, last] = end_forces(&place, input.displacement(time));
                forces[0].push(first);
                forces[1].push(last);
            }
        }
        let times: Vec<f64> = (0..forces[0].len()).map(|index| index as f64 * 100.0 * step).collect();
        let ours = motion.end_forces(&times).unwrap();
        // Second order: (ωΔt)²/12 over 40 ms of the highest mode, 2e3 rad/s.
        let size = forces[0].iter().fold(0.0_f64, |size, force| size.max((force - mean_force).abs()));
        // A force at end 2 is what it is prescribed to be: only its difference says something.
        for (theirs, ours) in forces.iter().zip([&ours.input, &ours.output]) {
            let off = theirs.iter().zip(ours).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            assert!(off < 1e-4 * size, "{far_end:?}: {off} of {size}");
        }
    }
}

/// Velocities on the massless line when end 1 sets out with `velocity`.
fn motion_start(row: &Row, velocity: f64) -> DVector<f64> {
    let (k, n) = (row.stiffness(), row.masses.len());
    let free = n + usize::from(row.far_end != FarEnd::Position);
    let share = |count: usize| row.segments[..count].iter().map(|segment| k / segment).sum::<f64>();
    DVector::from_fn(free, |index, _| match row.far_end {
        FarEnd::Position => velocity * (1.0 - share(index + 1)),
        _ => velocity,
    })
}

#[test]
fn modes_that_cannot_be_are_refused_in_one_line() {
    let good = || ModalParameters {
        far_end: FarEnd::Position,
        masses: vec![1.0, 1.0],
        places: vec![0.25, 0.75],
        end_segments: [4.0, 4.0],
        frequencies: vec![2.0, 3.0],
        shapes: vec![1.0, 1.0, 1.0, -1.0],
        end_shapes: vec![0.0, 0.0],
    };
    assert!(ModalModel::new(1.0, good()).is_ok());
    let refused = |change: &dyn Fn(&mut ModalParameters)| {
        let mut parameters = good();
        change(&mut parameters);
        ModalModel::new(1.0, parameters).unwrap_err().to_string()
    };
    type Change = fn(&mut ModalParameters);
    let cases: [(Change, &str); 8] = [
        (|p| p.masses.clear(), "masses"),
        (|p| p.masses[1] = -1.0, "mass must be finite and above zero"),
        (|p| p.places[1] = 1.5, "place must be above 0.25, below 1"),
        (|p| p.places.pop().map_or((), drop), "places"),
        (|p| p.frequencies[1] = 1.0, "frequency must be above 2"),
        (|p| p.shapes.pop().map_or((), drop), "shapes"),
        (|p| p.shapes[0] = f64::NAN, "shapes"),
        (|p| p.end_segments[0] = 0.0, "stiffness of an end segment must be finite and above zero"),
    ];
    for (change, expected) in cases {
        let message = refused(&change);
        assert!(message.contains(expected) && !message.contains('\n'), "{message}");
    }
    assert!(ModalModel::new(f64::NAN, good()).is_err());
    // A motion's inductance needs evenly wound windings.
    let spring = Spring::new(s_t_with(|p| p.windings = 4.0)).unwrap();
    let excitation = Excitation::impact(MEAN, 0.25).unwrap();
    assert_eq!(excitation.input(End::Two).displacement(0.0), 0.0);
    let model = Row::even(&spring, FarEnd::Position).model();
    let motion = Motion::of_modes(&spring, model, Damping::None, &excitation).unwrap();
    let sum = coilsense::inductance::MaxwellSum::new(&spring, coilsense::inductance::SelfDistance::AsPrinted);
    let message = sum.along(&motion, &[0.0, 0.1], 1e-6).unwrap_err().to_string();
    assert!(message.contains("equal masses"), "{message}");
}
