//! Modes against an eigen-solver, transmittance against a direct solve, both of nalgebra.
//!
//! | ours | theirs |
//! |---|---|
//! | `ChainModes::frequencies`, `::shape` | `nalgebra::SymmetricEigen` of the stiffness matrix of eq. (5) |
//! | `transmittance::chain` | `nalgebra` LU solve of eqs. (5)–(7) with a harmonic force on end 1 |

mod paper_springs;

use coilsense::modes::{ChainModes, continuous_frequency};
use coilsense::{FarEnd, Spring, transmittance};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use paper_springs::{s_a, s_t, s_t_with};

/// S_,xᵀ K S_,x of eq. (5) \[N/m\].
fn stiffness_matrix(spring: &Spring) -> DMatrix<f64> {
    let n = spring.chain_masses();
    let k = n as f64 * spring.stiffness();
    DMatrix::from_fn(n, n, |i, j| {
        let end = usize::from(i == 0) + usize::from(i == n - 1);
        match i.abs_diff(j) {
            0 => k * (2 + end) as f64,
            1 => -k,
            _ => 0.0,
        }
    })
}

#[test]
fn modes_are_those_of_the_stiffness_matrix() {
    for spring in [s_t(), s_a(), Spring::new(s_t_with(|p| p.windings = 1.0)).unwrap()] {
        let n = spring.chain_masses();
        let per_mass = stiffness_matrix(&spring) / (spring.mass() / n as f64);
        let mut theirs: Vec<f64> = SymmetricEigen::new(per_mass.clone()).eigenvalues.iter().map(|e| e.sqrt()).collect();
        theirs.sort_by(f64::total_cmp);
        let modes = ChainModes::of(&spring);
        for (ours, theirs) in modes.frequencies().iter().zip(&theirs) {
            // The eigen-solver's own error, 1e-15 of the largest eigenvalue on the smallest: 1e-12.
            assert!((ours / theirs - 1.0).abs() < 1e-12, "{ours} {theirs}");
        }
        for mode in 1..=n {
            let shape = DVector::from_fn(n, |i, _| modes.shape(mode, i + 1).unwrap());
            let residual = &per_mass * &shape - &shape * modes.frequencies()[mode - 1].powi(2);
            assert!(residual.amax() < 1e-13 * per_mass.amax(), "mode {mode}: {}", residual.amax());
        }
    }
}

#[test]
fn modes_with_an_end_mass_obey_every_equation_of_the_chain() {
    for windings in [1.0, 2.0, 52.0, 200.0] {
        for end_mass in [1e-6, 0.02, 1.0, 1e3, 1e6] {
            let spring = Spring::new(s_t_with(|p| p.windings = windings)).unwrap();
            let n = spring.chain_masses();
            let modes = ChainModes::mounted(&spring, FarEnd::Mass(end_mass));
            assert_eq!(modes.count(), n + 1);
            let k = n as f64 * spring.stiffness();
            for (index, omega) in modes.frequencies().iter().enumerate() {
                let shape = |winding| modes.shape(index + 1, winding).unwrap();
                let end = modes.end_shapes()[index];
                // The end mass: its inertia is the pull of the last half segment, to rounding of shapes of size 1.
                let (inertia, pull) = (end_mass * omega * omega * end, 2.0 * k * (end - shape(n)));
                assert!((inertia - pull).abs() < 1e-12 * (2.0 * k + pull.abs()), "N {n} M {end_mass} mode {index}");
                // The first winding.
                let next = if n > 1 { shape(2) } else { end };
                let right = if n > 1 { k * (next - shape(1)) } else { 2.0 * k * (end - shape(1)) };
                let force = right - 2.0 * k * shape(1);
                let inertia = -spring.mass() / n as f64 * omega * omega * shape(1);
                assert!(
                    // Above cut-off the first windings may stand so still that they underflow.
                    (force - inertia).abs() <= 1e-11 * k * shape(1).abs().max(next.abs()).max(1e-290),
                    "N {n} M {end_mass} mode {index}"
                );
            }
        }
    }
}

#[test]
fn an_end_mass_swings_as_beta_tan_beta_says() {
    // N → ∞: β tan β = m/M; at N = 52 within 3e-5.
    for ratio in [0.1, 1.0 / 3.0, 1.0, 5.0] {
        let spring = s_t();
        let modes = ChainModes::mounted(&spring, FarEnd::Mass(spring.mass() / ratio));
        let beta = modes.frequencies()[0] * spring.transit_time();
        assert!((beta * beta.tan() / ratio - 1.0).abs() < 2e-4, "{ratio}");
        let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if middle * f64::tan(middle) < ratio { low = middle } else { high = middle }
        }
        assert!((beta / low - 1.0).abs() < 1.2e-4, "{ratio}: {beta} {low}");
    }
}

#[test]
fn eq_3_is_the_limit_of_many_windings() {
    let mut last = f64::INFINITY;
    for windings in [10.0, 100.0, 1000.0] {
        let spring = Spring::new(s_t_with(|p| p.windings = windings)).unwrap();
        let chain = ChainModes::of(&spring).frequencies()[0];
        let gap = 1.0 - chain / continuous_frequency(spring.transit_time(), 1);
        // sin x / x with x = π/2N: second order in 1/N.
        let expected = (std::f64::consts::PI / (2.0 * windings)).powi(2) / 6.0;
        assert!((gap / expected - 1.0).abs() < 0.01);
        assert!(gap < last);
        last = gap;
    }
}

#[test]
fn transmittance_agrees_with_a_direct_solve() {
    for spring in [s_t(), s_a()] {
        let n = spring.chain_masses();
        let end = 2.0 * n as f64 * spring.stiffness();
        let mass = spring.mass() / n as f64;
        for hertz in [1.0, 20.0, 50.0, 130.0, 700.0, 1500.0, 2000.0, 8000.0] {
            let omega = hertz * std::f64::consts::TAU;
            // Unknowns x_1…x_N; the free end 1 carries the force: −F_i = 2Nk (u1 − x_1) at F_i = 1, so its segment pulls with 1.
            let mut dynamic = stiffness_matrix(&spring);
            dynamic[(0, 0)] -= end;
            for i in 0..n {
                dynamic[(i, i)] -= mass * omega * omega;
            }
            let mut load = DVector::zeros(n);
            load[0] = -1.0;
            let x = dynamic.lu().solve(&load).expect("not on a pole");
            let theirs = end * -x[n - 1];
            let ours = transmittance::chain(n, spring.transit_time(), omega);
            assert!((ours - theirs).abs() < 1e-10 * theirs.abs().max(1e-6), "{hertz} Hz: {ours} {theirs}");
        }
    }
}

#[test]
fn the_poles_of_eq_1_are_the_fixed_free_frequencies() {
    let tau = s_t().transit_time();
    for (pole, hertz) in [27.03, 81.10, 135.16, 189.23].into_iter().enumerate() {
        let omega = (pole as f64 + 0.5) * std::f64::consts::PI / tau;
        assert!((omega / std::f64::consts::TAU - hertz).abs() < 0.01);
        assert!(transmittance::continuous(tau, omega).abs() > 1e12);
    }
}

#[test]
fn a_mode_that_is_not_there_is_an_error_naming_it() {
    let error = ChainModes::of(&s_t()).shape(53, 1).unwrap_err();
    assert_eq!(error.to_string(), "mode must be from 1 to 52, got 53");
}
