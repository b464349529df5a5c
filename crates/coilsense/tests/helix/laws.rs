//! Laws that every helix keeps.

use std::f64::consts::TAU;

use coilsense::End;
use coilsense::helix::{Ends, Hand, Helix, Holding, Modes, Response, Rod, RodParameters, Turning};
use proptest::prelude::*;

use crate::cases::{frequencies, helix, relative, s_a, s_t, standard_parameters, valve};

fn mirrored(helix: &Helix) -> Helix {
    let rod = Rod::new(RodParameters { hand: Hand::Left, ..*helix.rod().parameters() }).unwrap();
    Helix::new(&rod, helix.span(), helix.turning()).unwrap()
}

#[test]
fn the_mirror_image_has_the_same_frequencies_and_opposite_couples() {
    for right in [helix(&s_t(), 0.230), helix(&valve(), 0.043)] {
        let left = mirrored(&right);
        assert!(relative(left.force(), right.force()) < 1e-13 && relative(left.couple(), -right.couple()) < 1e-12);
        assert!(relative(left.coil_radius(), right.coil_radius()) < 1e-14);
        assert!(relative(left.couple_per_force(), -right.couple_per_force()) < 1e-11);
        let (one, two) = (frequencies(&right, Ends::clamped(), 10), frequencies(&left, Ends::clamped(), 10));
        // The width to which roots are found, and rounding of long chains.
        one.iter().zip(two).for_each(|(one, two)| assert!(relative(two, *one) < 1e-9));
        let axial = |helix: &Helix| {
            let response = Response::new(helix, Ends::clamped(), 0.0).unwrap();
            response.reaction(10.0, End::One, End::Two).unwrap()
        };
        let (one, two) = (axial(&right), axial(&left));
        assert!(relative(two.side_force(), one.side_force()) < 1e-6);
        assert!(relative(two.axis_couple(), -one.axis_couple()) < 1e-6);
    }
}

#[test]
fn both_of_a_pair_are_found() {
    let modes = Modes::new(&helix(&s_t(), 0.230), Ends::clamped()).unwrap();
    let pair = modes.frequencies(2).unwrap();
    // Printed to 1e-4 Hz; 1.2e-4 apart, relatively.
    assert!((pair[0] - 44.1122).abs() < 5.1e-5 && (pair[1] - 44.1176).abs() < 5.1e-5, "{pair:?}");
    assert_eq!(modes.count_below(44.115).unwrap(), 1);
    // Pinned they are 1e-5 apart.
    let pinned = frequencies(&helix(&s_t(), 0.230), Ends::pinned(), 2);
    assert!(pinned[0] < pinned[1] && pinned[1] < pinned[0] * (1.0 + 3e-5));
}

#[test]
fn a_hundred_modes_are_where_the_counts_are() {
    for (helix, ends) in [(helix(&s_t(), 0.230), Ends::clamped()), (helix(&s_a(), 0.102), Ends::pinned())] {
        let modes = Modes::new(&helix, ends).unwrap();
        let found = modes.frequencies(100).unwrap();
        for (index, pair) in found.windows(2).enumerate() {
            assert!(pair[0] <= pair[1]);
            // Between neighbours that are told apart there are as many as were found.
            if pair[1] > pair[0] * (1.0 + 1e-8) {
                assert_eq!(modes.count_below(0.5 * (pair[0] + pair[1])).unwrap(), index + 1);
            }
        }
        // Where two parts of the wire meet some modes have a node: their shapes are found as well as others'.
        let response = Response::new(&helix, ends, 0.0).unwrap();
        for index in (1..=100).step_by(3) {
            let mode = modes.mode(index).unwrap();
            let offset = 1e-7;
            let residue = |sign: f64| {
                let reaction = response.reaction(mode.frequency() * (1.0 + sign * offset), End::One, End::Two).unwrap();
                reaction.force()[2].re * sign * offset / helix.stiffness()
            };
            let mean = 0.5 * (residue(1.0) + residue(-1.0)).abs();
            // What the pair's other mode adds does not cancel where it lies close: 4e-4 of the first pair's.
            assert!(relative(mean, mode.line_strength()) < 1e-3, "{index}: {mean} {}", mode.line_strength());
        }
    }
}

#[test]
fn the_dynamic_stiffness_follows_the_state_from_length_to_length() {
    // Both states of a thin wire, whose section is across it: how the ends move from one length to the next, and what they feel.
    let rod = Rod::new(standard_parameters()).unwrap().thin();
    let (span, step) = (0.050, 1e-6);
    let at = |span| Helix::new(&rod, span, Turning::Held).unwrap();
    let (before, now, after) = (at(span - step), at(span), at(span + step));
    let per_length = |value: fn(&Helix) -> f64| (value(&after) - value(&before)) / (2.0 * step);
    let (radius, angle) = (per_length(Helix::coil_radius), per_length(Helix::pitch_angle));
    let mut motion = [0.0; 12];
    for (first, sweep) in [(0, 0.0), (6, TAU * 7.6)] {
        let (s, c) = f64::sin_cos(sweep);
        // The wire's end moves outwards and turns about the radius, both of which leave its arm's direction.
        (motion[first], motion[first + 1]) = (radius * c, radius * s);
        (motion[first + 3], motion[first + 4]) = (angle * c, angle * s);
    }
    motion[8] = 1.0;
    let stiffness = Response::new(&now, Ends::clamped(), 0.0).unwrap().stiffness(0.0).unwrap();
    let feels: Vec<f64> = stiffness.iter().map(|row| row.iter().zip(motion).map(|(k, u)| k.re * u).sum()).collect();
    let (force, couple) = (per_length(Helix::force), per_length(Helix::couple));
    // Under a couple C about the axis the rotation vector of an end has half of C × θ in its couple.
    let lean = 0.5 * now.couple();
    // The point of the holding has moved with the wire's end: the load has an arm to it.
    let load = now.force();
    let couples = |first: usize, pull: f64, lean: f64| {
        let [x, y] = [motion[first], motion[first + 1]];
        let [about_x, about_y] = [motion[first + 3], motion[first + 4]];
        [-y * pull - lean * about_y, x * pull + lean * about_x]
    };
    let ([x1, y1], [x2, y2]) = (couples(0, -load, -lean), couples(6, load, lean));
    let expected = [[0.0, 0.0, -force, x1, y1, -couple], [0.0, 0.0, force, x2, y2, couple]];
    let scales = [force, force, force, 0.005 * force, 0.005 * force, 0.005 * force];
    for (i, (value, expected)) in feels.iter().zip(expected.iter().flatten()).enumerate() {
        // Differences over 4e-5 of the length: their square and rounding.
        assert!((value - expected).abs() < 1e-6 * scales[i % 6], "{i}: {value} {expected}");
    }
}

#[test]
fn actio_is_reactio() {
    for (helix, ends) in
        [(helix(&s_a(), 0.102), Ends::clamped()), (helix(&valve(), 0.043), Ends::both(Holding::hinged(0.7).unwrap()))]
    {
        let response = Response::new(&helix, ends, 0.01).unwrap();
        for frequency in [0.0, 30.0, 1000.0] {
            let stiffness = response.stiffness(frequency).unwrap();
            for i in 0..12 {
                for j in 0..12 {
                    // Entries of an index pair share a unit and a size.
                    let size = (stiffness[i][i].norm() * stiffness[j][j].norm()).sqrt();
                    assert!((stiffness[i][j] - stiffness[j][i]).norm() < 1e-9 * size, "{i} {j}");
                }
                // A loss takes energy from whoever moves an end.
                assert!(stiffness[i][i].im > 0.0);
            }
        }
    }
}

#[test]
fn a_line_strength_is_the_residue_of_the_response() {
    for (helix, ends) in [
        (helix(&s_t(), 0.230), Ends::clamped()),
        (helix(&valve(), 0.043), Ends::clamped()),
        (helix(&s_a(), 0.102), Ends::pinned()),
    ] {
        let modes = Modes::new(&helix, ends).unwrap();
        let response = Response::new(&helix, ends, 0.0).unwrap();
        for index in 3..=6 {
            let mode = modes.mode(index).unwrap();
            if mode.line_strength() < 1e-3 {
                continue;
            }
            // The mean of both sides takes out what the other modes add.
            let offset = 1e-5;
            let residue = |sign: f64| {
                let reaction = response.reaction(mode.frequency() * (1.0 + sign * offset), End::One, End::Two).unwrap();
                reaction.force()[2].re * sign * offset / helix.stiffness()
            };
            let mean = 0.5 * (residue(1.0) + residue(-1.0)).abs();
            assert!(relative(mean, mode.line_strength()) < 1e-4, "{index}: {mean} {}", mode.line_strength());
            // Close to the line all that the end feels is the mode's.
            let close = response.reaction(mode.frequency() * (1.0 + 1e-8), End::One, End::Two).unwrap();
            let (one, two) = (close.axis_couple(), mode.reaction(End::Two).axis_couple());
            assert!(relative(one, two) < 1e-4, "{index}: {one} {two}");
        }
    }
}

#[test]
fn held_ends_do_not_move_and_the_wire_is_where_it_says() {
    let helix = helix(&valve(), 0.043);
    let mode = Modes::new(&helix, Ends::clamped()).unwrap().mode(1).unwrap();
    let (wire, shape) = (mode.wire(), mode.shape());
    let last = wire.len() - 1;
    assert_eq!(wire.len(), shape.len());
    for at in [0, last] {
        // Exactly zero but for the products that bring it there.
        assert!(shape[at].iter().all(|value| value.abs() < 1e-12));
    }
    let radius = wire[last / 3][0].hypot(wire[last / 3][1]);
    assert!(relative(radius, helix.coil_radius()) < 1e-12 && relative(wire[last][2], helix.span()) < 1e-12);
    let largest = shape.iter().map(|[x, y, z]| (x * x + y * y + z * z).sqrt()).fold(0.0, f64::max);
    assert!((largest - 1.0).abs() < 1e-12);
}

#[test]
fn modes_are_orthogonal() {
    let modes = Modes::new(&helix(&valve(), 0.043), Ends::clamped()).unwrap();
    let shapes: Vec<_> = (1..=8).map(|index| modes.mode(index).unwrap().shape().to_vec()).collect();
    let product = |i: usize, j: usize| -> f64 {
        shapes[i].iter().flatten().zip(shapes[j].iter().flatten()).map(|(one, other)| one * other).sum()
    };
    for i in 0..8 {
        for j in 0..i {
            // The wire's own rotation is left out: (d/4R)² of the energy, 0.6 %.
            assert!(product(i, j).abs() < 0.01 * (product(i, i) * product(j, j)).sqrt(), "{i} {j}");
        }
    }
}

/// Coils that could be wound, stretched or compressed.
fn any_helix() -> impl Strategy<Value = Helix> {
    (2.0..60.0_f64, 4.0..15.0_f64, 1.2..4.0_f64, 0.6..2.5_f64, any::<bool>()).prop_filter_map(
        "a helix",
        |(windings, index, pitch, stretch, left)| {
            let rod = Rod::new(RodParameters {
                wire_diameter: 0.001,
                coil_radius: 0.0005 * index,
                windings,
                rest_span: windings * 0.001 * pitch,
                hand: if left { Hand::Left } else { Hand::Right },
                ..standard_parameters()
            });
            Helix::new(&rod.ok()?, windings * 0.001 * pitch * stretch, Turning::Held).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn more_modes_lie_below_a_higher_frequency(helix in any_helix(), which in 0..4_usize) {
        let holding = [Holding::clamped(), Holding::pinned(), Holding::ball(), Holding::hinged(0.3).unwrap()][which];
        let modes = Modes::new(&helix, Ends::new(Holding::clamped(), holding)).unwrap();
        let found = modes.frequencies(12).unwrap();
        let mut last = 0;
        for step in 0..200 {
            let frequency = f64::from(step) / 200.0 * found[11] * 1.2;
            let count = modes.count_below(frequency).unwrap();
            prop_assert!(count >= last);
            // Each of those that were found is counted.
            let counted = found.iter().filter(|value| **value < frequency).count();
            prop_assert!(frequency == 0.0 || frequency > found[11] || count == counted, "{} {} {}", frequency, count, counted);
            last = count;
        }
    }
}
