//! Parts in series: against the equations of all masses solved at once, the whole spring, and each other.

use coilsense::two_port::{Cascade, Load, Matrix, TwoPort};
use coilsense::{Damping, End, Spring};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use super::paper_springs::{s_t, s_t_with};
use super::{chain, dampings, distance, wave};

/// So many of S_T's 52 windings.
fn part(windings: f64) -> Spring {
    Spring::new(s_t_with(|p| {
        p.mass *= windings / 52.0;
        p.stiffness *= 52.0 / windings;
        p.windings = windings;
    }))
    .unwrap()
}

fn of(spring: &Spring, damping: Damping) -> Cascade {
    TwoPort::chain(spring, damping).unwrap().into()
}

fn joined<'a>(parts: impl IntoIterator<Item = &'a Cascade>) -> Cascade {
    parts.into_iter().cloned().reduce(|left, right| left.then(&right)).unwrap()
}

/// Largest distance of an entry, relative to the largest entry.
fn off(ours: Matrix, theirs: Matrix) -> f64 {
    let both = ours.into_iter().flatten().zip(theirs.into_iter().flatten());
    let worst = both.fold(0.0_f64, |worst, (a, b)| worst.max((a - b).norm()));
    worst / theirs.iter().flatten().fold(0.0_f64, |largest, entry| largest.max(entry.norm()))
}

/// Off all resonances of S_T and its parts, below and above the chain's cut-off of 11 200 rad/s.
const OMEGAS: [f64; 6] = [0.0, 3.0, 250.0, 2000.0, 9000.0, 30_000.0];

#[test]
fn a_spring_that_was_cut_in_two_is_the_whole() {
    for damping in [Damping::None, Damping::Hysteretic { loss_factor: 0.04 }] {
        for cut in [26.0, 20.0, 1.0] {
            let two = of(&part(cut), damping.clone()).then(&of(&part(52.0 - cut), damping.clone()));
            for omega in OMEGAS {
                let (whole, two) = (chain(&s_t(), damping.clone(), omega), two.at(omega).unwrap());
                assert!(off(two.matrix(), whole.matrix()) < 1e-11, "{omega} {cut}");
                // Above cut-off k_t is some 1e-150 of k_d, and right all the same.
                assert!(distance(two.transfer(), whole.transfer()) < 1e-11, "{omega} {cut}");
                if omega > 0.0 {
                    assert!(off(two.receptance(), whole.receptance()) < 1e-11, "{omega} {cut}");
                }
                for load in loads() {
                    for (ours, theirs) in [
                        (two.transmittance(&load), whole.transmittance(&load)),
                        (two.motion_ratio(&load), whole.motion_ratio(&load)),
                    ] {
                        assert!(
                            (ours - theirs).norm() <= 1e-11 * theirs.norm(),
                            "{omega} {cut} {load:?}: {ours} {theirs}"
                        );
                    }
                    assert!((two.loaded(&load) - whole.loaded(&load)).norm() <= 1e-11 * whole.drive_point().norm());
                }
            }
        }
    }
    let half = Cascade::from(TwoPort::wave(&part(26.0), Damping::None).unwrap());
    let (two, whole) = (half.then(&half).at(777.0).unwrap(), wave(&s_t(), Damping::None, 777.0));
    assert!(off(two.matrix(), whole.matrix()) < 1e-11);
}

fn loads() -> [Load; 4] {
    [Load::HELD, Load::FREE, Load::mass(0.3).unwrap(), Load::stiffness(Complex64::new(310.0, 95.0)).unwrap()]
}

#[test]
fn damping_about_a_line_of_its_own_is_not_that_of_the_whole() {
    // What must not get this answer: the half's line follows the joint, which the whole spring's damping would brake.
    let damping = Damping::StiffnessProportional { time: 3e-5 };
    let half = of(&part(26.0), damping.clone());
    let (two, whole) = (half.then(&half).at(700.0).unwrap(), chain(&s_t(), damping, 700.0));
    assert!(off(two.matrix(), whole.matrix()) > 1e-4);
}

/// The equations of every mass and both ends at once: what is between `U1, X_1 … X_n, U2`.
struct Assembled {
    stiffness: DMatrix<Complex64>,
}

impl Assembled {
    fn new(points: usize) -> Self {
        Self { stiffness: DMatrix::zeros(points, points) }
    }

    fn tie(&mut self, from: usize, stiffness: Complex64) {
        for (row, column, sign) in [(0, 0, 1.0), (1, 1, 1.0), (0, 1, -1.0), (1, 0, -1.0)] {
            self.stiffness[(from + row, from + column)] += stiffness * sign;
        }
    }

    fn weigh(&mut self, point: usize, mass: f64, omega: f64) {
        self.stiffness[(point, point)] -= Complex64::from(mass * omega * omega);
    }

    /// N masses from a point on, half a segment at each end; the point where it ends.
    fn chain(&mut self, from: usize, spring: &Spring, loss: f64, omega: f64) -> usize {
        let count = spring.chain_masses();
        let segment = Complex64::new(1.0, loss) * spring.stiffness() * count as f64;
        for mass in 1..=count {
            self.weigh(from + mass, spring.mass() / count as f64, omega);
            self.tie(from + mass - 1, if mass == 1 { 2.0 * segment } else { segment });
        }
        self.tie(from + count, 2.0 * segment);
        from + count + 1
    }

    /// D of the first and last point: forces of tension, so end 1's is turned.
    fn matrix(&self) -> Matrix {
        let points = self.stiffness.nrows();
        let inner = self.stiffness.view((1, 1), (points - 2, points - 2)).into_owned().lu();
        let column =
            |point: usize| DVector::from_iterator(points - 2, (1..points - 1).map(|row| self.stiffness[(row, point)]));
        let ends = [0, points - 1];
        let condensed = ends.map(|row| {
            ends.map(|end| {
                let moved = inner.solve(&column(end)).expect("no resonance of the inner masses");
                self.stiffness[(row, end)] - (column(row).transpose() * moved)[(0, 0)]
            })
        });
        [condensed[0].map(|entry| -entry), condensed[1]]
    }
}

#[test]
fn a_mass_at_the_joint_is_that_of_the_equations_of_all_masses() {
    let (left, right, loss) = (part(20.0), part(32.0), 0.02);
    let damping = Damping::Hysteretic { loss_factor: loss };
    let mass = Cascade::mass(0.35).unwrap();
    let skin = Cascade::link(9e3, 4.0).unwrap();
    let parts = [of(&left, damping.clone()), mass.clone(), of(&right, damping), skin, mass];
    for omega in [3.0, 55.0, 250.0, 2000.0, 9000.0] {
        let ours = joined(&parts).at(omega).unwrap();
        let mut all = Assembled::new(20 + 32 + 4);
        let joint = all.chain(0, &left, loss, omega);
        all.weigh(joint, 0.35, omega);
        let heel = all.chain(joint, &right, loss, omega);
        all.tie(heel, Complex64::new(9e3, 4.0 * omega));
        all.weigh(heel + 1, 0.35, omega);
        let theirs = all.matrix();
        // A direct solve of 54 unknowns, condition number up to 1e4.
        assert!(off(ours.matrix(), theirs) < 1e-11, "{omega}: {:e}", off(ours.matrix(), theirs));
        assert!(distance(ours.transfer(), theirs[0][1]) < 1e-9, "{omega}");
    }
}

#[test]
fn it_does_not_matter_which_are_joined_first() {
    for damping in dampings(20) {
        let spring = of(&part(20.0), damping);
        let (mass, link) = (Cascade::mass(0.2).unwrap(), Cascade::link(500.0, 3.0).unwrap());
        for omega in OMEGAS {
            let at = |cascade: Cascade| cascade.at(omega).unwrap();
            let one = at(spring.then(&mass).then(&link));
            let other = at(spring.then(&mass.then(&link)));
            assert!(off(one.matrix(), other.matrix()) < 1e-14);
            let [one, other] = [one, other].map(|at| at.transmission());
            assert!(off(one, other) < 1e-14 || !one[0][0].is_finite());
        }
    }
}

#[test]
fn a_cascade_seen_from_its_other_end_is_mirrored() {
    let parts =
        [of(&part(20.0), Damping::Modal(0.01)), Cascade::mass(0.2).unwrap(), Cascade::link(500.0, 3.0).unwrap()];
    let ahead = joined(&parts).at(330.0).unwrap();
    let back = joined(parts.iter().rev()).at(330.0).unwrap();
    assert!(distance(ahead.drive_point(End::One), back.drive_point(End::Two)) < 1e-14);
    assert!(distance(ahead.drive_point(End::Two), back.drive_point(End::One)) < 1e-14);
    assert!(distance(ahead.transfer(), back.transfer()) < 1e-14);
    // −ω is the conjugate.
    let behind = joined(&parts).at(-330.0).unwrap();
    assert!(off(behind.matrix(), ahead.matrix().map(|row| row.map(|entry| entry.conj()))) < 1e-15);
}

#[test]
fn a_load_is_the_part_that_it_stands_for() {
    let spring = of(&s_t(), Damping::Modal(0.01));
    let mass = Cascade::mass(0.3).unwrap();
    for omega in [0.0, 40.0, 900.0] {
        let (bare, hung) = (spring.at(omega).unwrap(), spring.then(&mass).at(omega).unwrap());
        let load = Load::mass(0.3).unwrap();
        assert!((bare.loaded(&load) - hung.loaded(&Load::FREE)).norm() <= 1e-13 * bare.drive_point(End::One).norm());
        assert!(distance(bare.motion_ratio(&load), hung.motion_ratio(&Load::FREE)) < 1e-13);
        let skin = spring.then(&Cascade::link(310.0, 2.0).unwrap()).at(omega).unwrap();
        let load = Load::stiffness(Complex64::new(310.0, 2.0 * omega)).unwrap();
        assert!(distance(bare.transmittance(&load), skin.transmittance(&Load::HELD)) < 1e-13);
    }
    // Carried along at rest: M / (M + m of all parts).
    let rest = mass.then(&spring).at(0.0).unwrap();
    let carried = rest.transmittance(&Load::mass(1.0).unwrap());
    assert!((carried.re - 1.0 / (1.3 + s_t().mass())).abs() < 1e-14);
}

#[test]
fn a_joint_that_rings_undamped_is_infinite_and_its_ratios_are_not() {
    // Two links of 300 N/m about 6 kg at √(600/6) = 10 rad/s, both ends held: the joint's stiffnesses cancel.
    let link = Cascade::link(300.0, 0.0).unwrap();
    let at = joined([&link, &Cascade::mass(6.0).unwrap(), &link]).at(10.0).unwrap();
    for entry in at.matrix().as_flattened() {
        assert!(entry.re.is_infinite() && !entry.im.is_nan());
    }
    // U1 = 0, and the joint and end 2 free: 300 (U2 − X) = 0, so F_o/F_i … in numbers: F_o = F_i − 600 X, X = F_i/300.
    assert!(distance(at.transmittance(&Load::HELD), Complex64::from(-1.0)) < 1e-15);
    assert!(at.transmission().as_flattened().iter().all(|entry| entry.is_finite()));
    // A rigid mass has no stiffness either, and a mass on a mass is one of both.
    let two = Cascade::mass(1.0).unwrap().then(&Cascade::mass(2.0).unwrap()).at(10.0).unwrap();
    assert!(two.drive_point(End::One).re.is_infinite() && two.transfer().re.is_infinite());
    assert_eq!(two.loaded(&Load::FREE), Complex64::from(-300.0));
    // A dashpot at rest is a gap: nothing gets through, and nothing is not a number.
    let gap = joined([&of(&s_t(), Damping::None), &Cascade::link(0.0, 5.0).unwrap(), &of(&s_t(), Damping::None)])
        .at(0.0)
        .unwrap();
    assert_eq!(gap.transfer().norm(), 0.0);
    // Force in at an end that nothing holds: no number, and so infinite.
    assert_eq!(gap.transmittance(&Load::HELD).re, f64::INFINITY);
    assert_eq!(gap.drive_point(End::Two).norm(), 0.0);
}

#[test]
fn a_long_cascade_neither_overflows_nor_loses_its_first_spring() {
    // 200 springs in series: k/200; above cut-off only the first is felt.
    let spring = of(&s_t(), Damping::None);
    let all = joined(std::iter::repeat_n(&spring, 200));
    let rest = all.at(0.0).unwrap();
    assert!((rest.drive_point(End::One).re / (s_t().stiffness() / 200.0) - 1.0).abs() < 1e-12);
    let fast = all.at(30_000.0).unwrap();
    let first = chain(&s_t(), Damping::None, 30_000.0);
    assert!(distance(fast.drive_point(End::One), first.drive_point()) < 1e-12);
    assert_eq!(fast.transfer().norm(), 0.0);
}

#[test]
fn what_is_no_part_and_no_frequency_is_refused_by_name() {
    let told = |error: coilsense::Error| error.to_string();
    assert_eq!(told(Cascade::mass(-1.0).unwrap_err()), "mass must be finite and not below zero, got -1 kg");
    assert_eq!(told(Cascade::mass(f64::NAN).unwrap_err()), "mass must be finite and not below zero, got NaN kg");
    assert_eq!(told(Cascade::link(-1.0, 0.0).unwrap_err()), "stiffness must be finite and not below zero, got -1 N/m");
    let damping = "damping of the link must be finite and not below zero, got inf N s/m";
    assert_eq!(told(Cascade::link(1.0, f64::INFINITY).unwrap_err()), damping);
    let nothing = "stiffness must be above zero where the link has no damping, got 0 N/m";
    assert_eq!(told(Cascade::link(0.0, 0.0).unwrap_err()), nothing);
    let at = |cascade: &Cascade, omega: f64| cascade.at(omega).unwrap_err().to_string();
    let finite = "angular frequency must be finite and at most 1e12 in size, got";
    assert_eq!(at(&Cascade::mass(1.0).unwrap(), f64::NAN), format!("{finite} NaN rad/s"));
    // Each spring refuses what it cannot take.
    let both = Cascade::mass(1.0).unwrap().then(&of(&part(10_400.0), Damping::None));
    assert!(at(&both, 9e11).contains("finite and at most"), "{}", at(&both, 9e11));
}
