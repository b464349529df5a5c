//! The coil: its kernel, its derivatives, its second-order form. The test command runs this once for each vector path.
//!
//! | ours | theirs |
//! |---|---|
//! | `mutual_inductances` | eqs. 8 and 9 in mpmath, 40 digits |
//! | `mutual_inductance_derivatives`, `MaxwellSum::gradient`, `::hessian` of two turns | the same differentiated at 300 digits |
//! | `MaxwellSum::gradient`, `::hessian` of a spring | difference quotients of our own L |
//! | `MaxwellSum::series_within`, `SecondOrder` | our own exact sum |

mod paper_springs;

use coilsense::inductance::{
    MU_0, MaxwellSum, SecondOrder, SelfDistance, mutual_inductance, mutual_inductance_derivatives, mutual_inductances,
};
use coilsense::{End, EndInput, Error, Excitation, Motion, Spring, SpringParameters, Start, VelocityProfile};
use paper_springs::{s_a, s_t, s_t_with};
use proptest::prelude::*;

/// Rows of numbers of a golden file. A missing file fails.
fn golden(name: &str) -> Vec<Vec<f64>> {
    let path = format!("{}/tests/golden/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(&path).expect(&path);
    let rows: Vec<Vec<f64>> =
        reader.records().map(|row| row.expect(&path).iter().map(|text| text.parse().expect(text)).collect()).collect();
    assert!(rows.len() > 100, "{path}");
    rows
}

fn relative(ours: f64, theirs: f64) -> f64 {
    (ours / theirs - 1.0).abs()
}

fn coil(spring: &Spring) -> MaxwellSum {
    MaxwellSum::new(spring, SelfDistance::AsPrinted)
}

/// S_T with another number of windings.
fn with_windings(windings: f64) -> Spring {
    Spring::new(s_t_with(|parameters| parameters.windings = windings)).unwrap()
}

/// Two turns of radius 1 m.
fn two_rings() -> MaxwellSum {
    let change = |parameters: &mut SpringParameters| {
        (parameters.windings, parameters.coil_radius) = (2.0, 1.0);
    };
    coil(&Spring::new(s_t_with(change)).unwrap())
}

/// Uniform masses, each displaced by up to 0.3 of the pitch, without symmetry.
fn displaced(masses: usize, length: f64) -> Vec<f64> {
    let pitch = length / masses as f64;
    (0..masses).map(|index| pitch * (index as f64 + 0.5 + 0.3 * (1.0 + 2.3 * index as f64).sin())).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

#[test]
fn many_distances_hold_from_touching_to_far_rings() {
    let rows = golden("mutual_inductance");
    let ratios: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    // A power of two as radius keeps h/r exact.
    let distances: Vec<f64> = ratios.iter().map(|ratio| 0.5 * ratio).collect();
    let mut ours = vec![0.0; rows.len()];
    mutual_inductances(0.5, &distances, &mut ours).unwrap();
    for (row, (ours, distance)) in rows.iter().zip(ours.iter().zip(&distances)) {
        assert!(relative(ours / (0.5 * MU_0), row[1]) < 2e-15, "h/r = {:e}", row[0]);
        assert!(relative(*ours, mutual_inductance(0.5, *distance)) < 2e-15, "h/r = {:e}", row[0]);
    }
}

#[test]
fn derivatives_of_two_rings_hold_to_the_last_digits() {
    let pair = two_rings();
    for row in golden("inductance_derivatives") {
        let ratio = row[0];
        let rings = mutual_inductance_derivatives(1.0, ratio);
        for (order, ours) in [rings.value, rings.first, rings.second, rings.third].into_iter().enumerate() {
            assert!(relative(ours / MU_0, row[1 + order]) < 5e-15, "order {order} at h/r = {ratio:e}");
        }
        // The same on the vector path, through the doors of the coil.
        let gradient = pair.gradient([0.0, 0.0], &[0.0, ratio]).unwrap();
        let hessian = pair.hessian([0.0, 0.0], &[0.0, ratio]).unwrap();
        assert!(relative(gradient[2] / (2.0 * MU_0), row[2]) < 5e-15, "gradient at {ratio:e}");
        assert!(relative(-hessian[4 + 2] / (2.0 * MU_0), row[3]) < 5e-15, "Hessian at {ratio:e}");
    }
}

#[test]
fn a_value_does_not_depend_on_its_neighbours() {
    let distances: Vec<f64> = (0..77).map(|index| 1e-4 * 1.2_f64.powi(index)).collect();
    let mut together = vec![0.0; distances.len()];
    mutual_inductances(0.008, &distances, &mut together).unwrap();
    for (distance, expected) in distances.iter().zip(together) {
        let mut alone = [0.0];
        mutual_inductances(0.008, &[*distance], &mut alone).unwrap();
        assert_eq!(alone[0].to_bits(), expected.to_bits(), "h = {distance:e}");
    }
}

#[test]
fn rings_at_the_limits_give_limits() {
    let mut ours = [0.0; 6];
    mutual_inductances(0.008, &[0.0, -0.0, f64::NAN, f64::INFINITY, -0.01, 1e-300], &mut ours).unwrap();
    assert_eq!(ours[..2], [f64::INFINITY; 2]);
    assert!(ours[2].is_nan());
    assert!((0.0..1e-200).contains(&ours[3]), "{}", ours[3]);
    assert!(relative(ours[4], mutual_inductance(0.008, 0.01)) < 2e-15);
    assert!(relative(ours[5], MU_0 * 0.008 * ((8.0 * 0.008_f64).ln() + 300.0 * 10.0_f64.ln() - 2.0)) < 1e-15);
    let touching = mutual_inductance_derivatives(0.008, 0.0);
    assert_eq!([touching.value, touching.second], [f64::INFINITY; 2]);
    assert_eq!([touching.first, touching.third], [f64::NEG_INFINITY; 2]);
    assert!(mutual_inductance_derivatives(0.008, f64::NAN).third.is_nan());
}

#[test]
fn moving_the_whole_spring_changes_nothing() {
    for windings in [52.0, 10.4, 9.6, 1.0] {
        let spring = with_windings(windings);
        let masses = displaced(spring.chain_masses(), 0.23);
        let coil = coil(&spring);
        let gradient = coil.gradient([0.0, 0.23], &masses).unwrap();
        // Rounding of a sum of N terms.
        assert!(gradient.iter().sum::<f64>().abs() <= 1e-13 * largest(&gradient), "{windings}");
        let hessian = coil.hessian([0.0, 0.23], &masses).unwrap();
        let nodes = masses.len() + 2;
        for (index, row) in hessian.chunks_exact(nodes).enumerate() {
            assert!(row.iter().sum::<f64>().abs() <= 1e-13 * largest(&hessian), "{windings}");
            for (column, value) in row.iter().enumerate() {
                assert!((value - hessian[column * nodes + index]).abs() <= 1e-14 * largest(&hessian));
            }
        }
        let moved: Vec<f64> = masses.iter().map(|position| position + 0.5).collect();
        let shifted = coil.gradient([0.5, 0.73], &moved).unwrap();
        for (here, there) in gradient.iter().zip(shifted) {
            // Positions at 0.5 m are rounded to 1e-16 of 0.5 m, a hundredth of a pitch holds 5e-5 m.
            assert!((here - there).abs() <= 1e-11 * largest(&gradient));
        }
    }
}

#[test]
fn a_mirrored_spring_has_the_same_inductance_and_the_opposite_gradient() {
    for windings in [52.0, 10.4] {
        let spring = with_windings(windings);
        let (coil, length) = (coil(&spring), 0.23);
        let masses = displaced(spring.chain_masses(), length);
        let mirrored: Vec<f64> = masses.iter().rev().map(|position| length - position).collect();
        let sum = |masses: &[f64]| coil.matrix([0.0, length], masses).unwrap().iter().sum::<f64>();
        assert!(relative(sum(&masses), sum(&mirrored)) < 1e-13);
        let gradient = coil.gradient([0.0, length], &masses).unwrap();
        let opposite = coil.gradient([0.0, length], &mirrored).unwrap();
        for (one, other) in gradient.iter().zip(opposite.iter().rev()) {
            assert!((one + other).abs() <= 1e-12 * largest(&gradient));
        }
    }
}

/// L by the matrix of mutual inductances.
fn inductance(coil: &MaxwellSum, ends: [f64; 2], masses: &[f64]) -> f64 {
    coil.matrix(ends, masses).unwrap().iter().sum()
}

#[test]
fn the_matrix_sums_to_the_series() {
    for windings in [52.0, 10.4, 9.6] {
        let spring = with_windings(windings);
        let coil = coil(&spring);
        let motion = Motion::new(&spring, &Excitation::impact(0.23, 0.25).unwrap()).unwrap();
        let samples = motion.windings(&[0.0, 0.013, 0.4]).unwrap();
        for (sample, expected) in coil.series(&samples).into_iter().enumerate() {
            let sum = inductance(&coil, samples.ends(sample), samples.row(sample));
            assert!(relative(sum, expected) < 1e-14, "{windings}");
        }
        assert!(relative(coil.series(&samples)[0], coil.at_length(0.23)) < 1e-13);
    }
}

/// A chain's nodes, end 1, masses, end 2, as arguments of the coil.
fn split(nodes: &[f64]) -> ([f64; 2], &[f64]) {
    ([nodes[0], nodes[nodes.len() - 1]], &nodes[1..nodes.len() - 1])
}

#[test]
fn gradient_and_hessian_are_the_limits_of_difference_quotients_of_second_order() {
    for windings in [12.0, 10.4, 9.6] {
        let spring = with_windings(windings);
        let (coil, masses) = (coil(&spring), displaced(spring.chain_masses(), 0.05));
        let nodes: Vec<f64> = [0.0].into_iter().chain(masses).chain([0.05]).collect();
        let ((ends, masses), count) = (split(&nodes), nodes.len());
        let (gradient, hessian) = (coil.gradient(ends, masses).unwrap(), coil.hessian(ends, masses).unwrap());
        let moved = |node: usize, by: f64| {
            let mut nodes = nodes.clone();
            nodes[node] += by;
            nodes
        };
        for node in 0..count {
            let error = |step: f64| {
                let [more, less] = [moved(node, step), moved(node, -step)];
                let value = |nodes: &[f64]| inductance(&coil, split(nodes).0, split(nodes).1);
                let slope = |nodes: &[f64]| coil.gradient(split(nodes).0, split(nodes).1).unwrap();
                let of_gradient = (value(&more) - value(&less)) / (2.0 * step) - gradient[node];
                let of_hessian = (slope(&more)[node] - slope(&less)[node]) / (2.0 * step) - hessian[node * (count + 1)];
                [of_gradient, of_hessian]
            };
            // Steps of 1 % of the pitch: the next term of the error is then 1e-3 of it, and rounding far below.
            let (coarse, fine) = (error(4e-5), error(2e-5));
            for (coarse, fine, scale) in [(coarse[0], fine[0], &gradient), (coarse[1], fine[1], &hessian)] {
                let scale = largest(scale);
                // Where a turn has no part in a node (an end of a spring of whole windings), both are zero.
                let order = (coarse / fine).log2();
                assert!(coarse.abs() < 1e-9 * scale || (order - 2.0).abs() < 0.05, "{windings} {node}: {order}");
                assert!(fine.abs() < 2e-3 * scale);
            }
        }
    }
}

#[test]
fn the_second_order_form_has_the_gradient_and_hessian_of_the_coil() {
    let (spring, length) = (s_t(), 0.23);
    let coil = coil(&spring);
    let near = SecondOrder::about(&coil, length).unwrap();
    let uniform: Vec<f64> = (0..52).map(|index| (index as f64 + 0.5) * length / 52.0).collect();
    let gradient = coil.gradient([0.0, length], &uniform).unwrap();
    for (ours, theirs) in near.gradient().iter().zip(&gradient[1..53]) {
        assert!((ours - theirs).abs() < 1e-13 * largest(&gradient));
    }
    let hessian = coil.hessian([0.0, length], &uniform).unwrap();
    for (lag, curvature) in near.curvatures().iter().enumerate() {
        assert!(relative(-2.0 * curvature, hessian[54 + 2 + lag]) < 1e-12);
    }
}

#[test]
fn the_hessian_couples_only_modes_of_equal_parity() {
    let (spring, length) = (s_t(), 0.23);
    let uniform: Vec<f64> = (0..52).map(|index| (index as f64 + 0.5) * length / 52.0).collect();
    let hessian = coil(&spring).hessian([0.0, length], &uniform).unwrap();
    let shape = |mode: usize, index: usize| (mode as f64 * std::f64::consts::PI * (index as f64 + 0.5) / 52.0).sin();
    let product = |one: usize, other: usize| -> f64 {
        let pairs = (0..52).flat_map(|row| (0..52).map(move |column| (row, column)));
        pairs.map(|(row, column)| shape(one, row) * hessian[(row + 1) * 54 + column + 1] * shape(other, column)).sum()
    };
    let own = product(1, 1);
    assert!(product(1, 3).abs() > 1e-3 * own);
    for (one, other) in [(1, 2), (2, 3), (1, 4)] {
        assert!(product(one, other).abs() < 1e-11 * own, "{one} {other}");
    }
}

#[test]
fn the_second_order_form_errs_by_the_third_power_of_the_displacement() {
    let (spring, length) = (s_t(), 0.23);
    let (coil, pitch) = (coil(&spring), 0.23 / 52.0);
    let near = SecondOrder::about(&coil, length).unwrap();
    let error = |size: f64| {
        // All neighbours part, the later the more, so that third powers do not cancel: the largest strain is twice the size.
        let change = |index: usize| size * pitch * (index as f64).powi(2) / 52.0;
        let displacements: Vec<f64> = (0..52).map(change).collect();
        let turns: Vec<f64> =
            displacements.iter().enumerate().map(|(index, by)| (index as f64 + 0.5) * pitch + by).collect();
        let ours = near.at_displacements(&displacements).unwrap();
        let error = (ours.inductance - coil.at_positions(&turns).unwrap()).abs();
        assert!(error <= ours.bound, "{error:e} {:e}", ours.bound);
        (error, ours.bound)
    };
    let (coarse, fine) = (error(0.02), error(0.01));
    let order = (coarse.0 / fine.0).log2();
    assert!((order - 3.0).abs() < 0.2, "{order}");
    assert!((2.9..3.5).contains(&(coarse.1 / fine.1).log2()));
    assert!(fine.1 < 2.0 * fine.0, "{fine:?}");
}

/// The paper's conditions: impact, end stop, both resonances, and a slow sine.
fn conditions(spring: &Spring, surge: f64) -> Vec<(&'static str, Excitation)> {
    let length = spring.mid_length();
    let sine = |amplitude: f64, frequency: f64| {
        let input = EndInput::harmonic(amplitude, frequency, 0.3);
        Excitation::harmonic(length, End::One, input, Start::Massless).unwrap()
    };
    vec![
        ("impact", Excitation::impact(length, 0.25).unwrap()),
        ("end stop", Excitation::end_stop(length, 1.0, VelocityProfile::Linear).unwrap()),
        ("half resonance", sine(2e-3, 0.5 * surge)),
        ("resonance", sine(2e-4, surge)),
        ("slow", sine(5e-3, 10.0)),
    ]
}

#[test]
fn the_bound_holds_in_the_papers_conditions_and_is_not_absurd() {
    let times: Vec<f64> = (0..1003).map(|index| 1e-3 * index as f64).collect();
    for spring in [s_t(), s_a(), with_windings(51.4)] {
        let coil = coil(&spring);
        for (name, excitation) in conditions(&spring, spring.surge_frequency() * std::f64::consts::TAU) {
            let windings = Motion::new(&spring, &excitation).unwrap().windings(&times).unwrap();
            let exact = coil.series(&windings);
            for tolerance in [1e-7, 1e-4, 0.1] {
                let ours = coil.series_within(&windings, tolerance).unwrap();
                assert_eq!(ours.second_order + ours.exact, times.len());
                let (mut worst, mut bound) = (0.0_f64, 0.0_f64);
                for (sample, exact) in ours.samples.iter().zip(&exact) {
                    let error = (sample.inductance - exact).abs();
                    assert!(error <= sample.bound, "{name}: {error:e} above {:e}", sample.bound);
                    assert!(sample.bound <= tolerance * sample.inductance || sample.inductance == *exact);
                    (worst, bound) = (worst.max(error), bound.max(sample.bound));
                }
                if name == "resonance" && tolerance == 0.1 {
                    assert!(bound < 30.0 * worst, "{bound:e} for {worst:e}");
                }
                // An impact's third powers cancel in the sum but not in the bound.
                assert!(bound < 1000.0 * worst || bound < 1e-9 * exact[0], "{name}: {bound:e} for {worst:e}");
            }
            let none = coil.series_within(&windings, 0.0).unwrap();
            assert_eq!(none.exact, times.len());
            assert!(none.samples.iter().map(|sample| sample.inductance).eq(exact));
        }
    }
}

#[test]
fn turns_that_meet_are_named_or_infinite_but_never_a_panic() {
    let coil = coil(&with_windings(3.0));
    assert_eq!(coil.at_positions(&[0.01, 0.02, 0.01]), Ok(f64::INFINITY));
    let error = coil.gradient([0.0, 0.03], &[0.01, 0.02, 0.01]).unwrap_err().to_string();
    assert_eq!(error, "turns[2] must be apart from turns[0], got 0.01 m");
    assert!(coil.hessian([0.0, 0.03], &[0.01, 0.01, 0.02]).is_err());
    assert!(coil.matrix([0.0, 0.03], &[0.01, 0.01, 0.02]).is_err());
    let near = SecondOrder::about(&coil, 0.03).unwrap();
    assert_eq!(near.at_displacements(&[0.01, 0.0, 0.0]).unwrap().bound, f64::INFINITY);
}

/// Any number that can be sent, bad ones often.
fn anything() -> impl Strategy<Value = f64> {
    prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(0.0), Just(-1e300), -1.0..1.0_f64]
}

proptest! {
    #[test]
    fn bad_input_is_an_error_that_names_it(
        masses in proptest::collection::vec(anything(), 0..6),
        ends in [anything(), anything()],
        tolerance in anything(),
    ) {
        let coil = coil(&with_windings(4.0));
        let bad = masses.iter().position(|value| !value.is_finite());
        for result in [
            coil.gradient(ends, &masses),
            coil.hessian(ends, &masses),
            coil.matrix(ends, &masses),
            coil.at_positions(&masses).map(|value| vec![value]),
        ] {
            match &result {
                Err(Error::Count { found, .. }) => prop_assert!(*found == masses.len() && *found != 4),
                Err(error @ Error::Value { .. }) => prop_assert!(error.to_string().contains("got")),
                Err(other) => prop_assert!(false, "{other}"),
                Ok(values) => prop_assert!(masses.len() == 4 && bad.is_none() && values.iter().all(|v| !v.is_nan())),
            }
        }
        let near = SecondOrder::about(&coil, 0.05).unwrap().at_displacements(&masses);
        prop_assert!(near.is_ok() == (masses.len() == 4 && bad.is_none()));
        prop_assert!(SecondOrder::about(&coil, tolerance).is_ok() == (tolerance.is_finite() && tolerance > 0.0));
        let mut results = vec![0.0; 3];
        prop_assert!(mutual_inductances(0.008, &masses, &mut results).is_err() == (masses.len() != 3));
        if masses.len() == 3 {
            prop_assert!(masses.iter().zip(&results).all(|(distance, value)| distance.is_nan() == value.is_nan()));
        }
        prop_assert!(mutual_inductances(ends[0], &[], &mut []).is_err() || ends[0] > 0.0);
        let windings = Motion::new(&with_windings(4.0), &Excitation::impact(0.05, 0.1).unwrap()).unwrap();
        let windings = windings.windings(&[0.0]).unwrap();
        prop_assert!(coil.series_within(&windings, tolerance).is_ok() == (tolerance.is_finite() && tolerance >= 0.0));
    }
}
