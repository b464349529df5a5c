//! Turns of magnetic wire.
//!
//! | ours | held against |
//! |---|---|
//! | rows of 1 to 8 turns, μr 1 to 20 | axisymmetric finite elements, `reference/permeable_rings.py` |
//! | an odd number of turns | the same integrals without the mirror in the middle |
//! | a thin ring | μ₀ r (ln(8r/a) − 2 + μr/4) |
//! | wire that is not magnetic | the sum of thin rings at the geometric mean distance |
//! | the current along a coil | Neumann's helix less Maxwell's rings |

use std::f64::consts::TAU;

use coilsense::inductance::theories::{Coil, HelixSelf, ReturnPath, helix};
use coilsense::inductance::{
    Leads, MU_0, MaxwellSum, PermeableRings, SelfDistance, SteelCoil, SteelWindings, inductance_along,
    mutual_inductance,
};

#[test]
fn rows_are_those_of_finite_elements() {
    let path = format!("{}/tests/golden/permeable_rings.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let rows: Vec<Vec<f64>> =
        text.lines().skip(2).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    assert!(rows.len() >= 23, "{}", rows.len());
    for row in rows {
        let [turns, coil, wire, diameters, pitch, permeability, henry, error] = row[..] else { panic!("{row:?}") };
        let rings = PermeableRings::new(turns as usize, coil, wire, permeability).unwrap();
        let off = rings.inductance(pitch).unwrap() / henry - 1.0;
        println!("{turns} turns at {diameters} d, {permeability}: {off:e}");
        assert!(error / henry < 1e-8);
        // Edges so near to one another need more points where the wire is more permeable.
        let within = match (diameters < 1.1, permeability) {
            (true, 20.0) => 1e-3,
            (true, 5.0) => 2e-4,
            (true, 2.0) => 2e-5,
            (_, 20.0) => 3e-5,
            _ => 1e-5,
        };
        assert!(off.abs() < within, "{turns} turns at {diameters} d, {permeability}: {off:e}");
    }
}

#[test]
fn an_odd_number_of_turns_has_one_in_the_middle() {
    // By the same integrals in a program of their own (NumPy), without the mirror that halves the unknowns here.
    let (coil, wire) = (8.47e-3, 1.41e-3);
    for (turns, pitch, permeability, nanohenry) in
        [(3, 1.2, 1.0, 124.292112), (3, 1.2, 2.5, 143.159144), (5, 1.3, 1.0, 242.324305), (5, 1.3, 2.5, 277.137469)]
    {
        let rings = PermeableRings::new(turns, coil, wire, permeability).unwrap();
        let off = rings.inductance(pitch * 2.0 * wire).unwrap() / (1e-9 * nanohenry) - 1.0;
        // Its rules for the wires' sections are finer, which is 4e-6 of it.
        assert!(off.abs() < 1e-5, "{turns} turns at {pitch} d, {permeability}: {off:e}");
    }
}

#[test]
fn a_thin_ring_has_a_quarter_of_its_permeability_inside() {
    let (coil, wire) = (0.1, 2e-4);
    for permeability in [1.0, 2.5, 10.0] {
        let thin = MU_0 * coil * ((8.0 * coil / wire).ln() - 2.0 + 0.25 * permeability);
        let ring = PermeableRings::new(1, coil, wire, permeability).unwrap().inductance(1e-3).unwrap();
        assert!((ring / thin - 1.0).abs() < 1e-5, "{permeability}: {ring} and {thin}");
    }
}

#[test]
fn wire_that_is_not_magnetic_is_a_row_of_thin_rings() {
    // Thin wire far apart: the self term of round wire, and rings of no thickness.
    let (coil, wire, pitch, turns) = (0.02, 1e-4, 2e-3, 7);
    let own = MU_0 * coil * ((8.0 * coil / wire).ln() - 1.75);
    let others = (1..turns).map(|lag| 2.0 * f64::from(turns - lag) * mutual_inductance(coil, f64::from(lag) * pitch));
    let rings = f64::from(turns) * own + others.sum::<f64>();
    let row = PermeableRings::new(7, coil, wire, 1.0).unwrap().inductance(pitch).unwrap();
    assert!((row / rings - 1.0).abs() < 1e-5, "{row} and {rings}");
}

#[test]
fn what_it_does_not_hold_for_is_refused_in_a_line() {
    let new = |turns, coil, wire, permeability| PermeableRings::new(turns, coil, wire, permeability);
    for (made, part) in [
        (new(0, 8e-3, 1e-3, 2.0), "turns must be 1 to 150"),
        (new(151, 8e-3, 1e-3, 2.0), "turns must be 1 to 150"),
        (new(4, 8e-3, 9e-3, 2.0), "wire radius must be below the coil's 0.008 m"),
        (new(4, 8e-3, 1e-3, 0.99), "permeability must be 1 to 20"),
        (new(4, 8e-3, 1e-3, 60.0), "permeability must be 1 to 20"),
        (new(4, 8e-3, 1e-3, f64::NAN), "permeability must be 1 to 20"),
        (new(4, -1.0, 1e-3, 2.0), "coil radius"),
    ] {
        let message = made.map(|_| ()).unwrap_err().to_string();
        assert!(message.contains(part) && message.lines().count() == 1, "{message}");
    }
    let rings = new(4, 8e-3, 1e-3, 2.0).unwrap();
    for pitch in [0.0, 2.0e-3, 2.07e-3, f64::NAN, f64::INFINITY] {
        let message = rings.inductance(pitch).unwrap_err().to_string();
        assert!(message.contains("pitch must be at least 1.04 wire diameters"), "{message}");
    }
}

/// S1 of the measured runs, as it is at its length without displacement.
const S1: ([f64; 3], f64) = ([41.904, 8.47e-3, 1.41e-3], 0.11817);

fn coil([windings, radius, wire]: [f64; 3]) -> Coil {
    Coil::new(windings, radius, wire).unwrap()
}

#[test]
fn between_its_lengths_a_coil_is_what_is_solved_there() {
    let (numbers, measured_at) = S1;
    let diameter = 2.0 * numbers[2];
    let length = |pitch: f64| pitch * diameter * numbers[0];
    let range = [length(1.05), length(1.6)];
    let steel = SteelCoil::new(&coil(numbers), measured_at, Leads::Open, range).unwrap();
    for (permeability, within) in [(1.0, 1e-6), (2.0, 2e-6), (5.0, 3e-5), (20.0, 3e-4)] {
        let curve = steel.of(permeability).unwrap();
        for pitch in [1.05, 1.0562, 1.09, 1.163, 1.3, 1.47, 1.6] {
            let length = length(pitch).clamp(range[0], range[1]);
            let solved = SteelCoil::at_length(&coil(numbers), measured_at, Leads::Open, permeability, length).unwrap();
            let off = curve.inductance(length) / solved - 1.0;
            assert!(off.abs() < within, "{pitch} d, {permeability}: {off:e}");
        }
    }
    // Beyond it there is no answer, rather than a polynomial's.
    let curve = steel.of(2.0).unwrap();
    assert!(curve.inductance(0.999 * range[0]).is_nan() && curve.inductance(1.001 * range[1]).is_nan());
}

#[test]
fn current_along_a_coil_is_what_a_helix_has_more_than_rings() {
    for (windings, radius, wire, pitches) in
        [(41.904, 8.47e-3, 1.41e-3, [1.05, 1.25, 1.5]), (52.0, 8e-3, 1e-3, [1.4, 2.0, 2.6])]
    {
        for pitch in pitches {
            let of = |turns: f64| {
                let coil = coil([turns, radius, wire]);
                MaxwellSum::of_coil(&coil, SelfDistance::GeometricMean).at_length(pitch * 2.0 * wire * turns)
            };
            let (whole, share) = (f64::floor(windings), f64::fract(windings));
            let rings = of(whole) + share * (of(whole + 1.0) - of(whole));
            let length = pitch * 2.0 * wire * windings;
            let helix = helix(&coil([windings, radius, wire]), length, HelixSelf::GeometricMean, ReturnPath::Open);
            let along = inductance_along(length, radius, Leads::Open).unwrap();
            let left = 1e9 * (helix - rings - along);
            println!("{windings} at {pitch} d: {left} nH of {} nH", 1e9 * along);
            // What the ends of a helix and of rings differ by.
            assert!(left.abs() < 6.0 && left.abs() < 0.15 * 1e9 * along, "{left}");
        }
    }
}

#[test]
fn current_crowds_inside_by_three_tenths_of_the_square_of_the_radii() {
    // −0.3 (a/r)² of L: against uniform current, the sum of rings at the geometric mean distance.
    for (ratio, pitch, windings) in [(0.1, 1.5, 30), (0.15, 1.5, 30), (0.1, 2.0, 50)] {
        let (radius, wire) = (0.01, 0.01 * ratio);
        let step = pitch * 2.0 * wire;
        let crowded = PermeableRings::new(windings, radius, wire, 1.0).unwrap().inductance(step).unwrap();
        let even = coil([windings as f64, radius, wire]);
        let even = MaxwellSum::of_coil(&even, SelfDistance::GeometricMean).at_length(step * windings as f64);
        let share = (crowded / even - 1.0) / (ratio * ratio);
        println!("a/r {ratio}, {pitch} d: {share} (a/r)²");
        assert!((-0.45..-0.15).contains(&share), "{share}");
    }
}

#[test]
fn a_radius_shrinks_so_that_the_wire_keeps_its_length() {
    let (numbers, measured_at) = S1;
    let steel = SteelCoil::new(&coil(numbers), measured_at, Leads::Open, [0.124, 0.178]).unwrap();
    let wire = |length: f64| (TAU * numbers[0] * steel.coil_radius(length)).hypot(length);
    assert!((steel.coil_radius(measured_at) / numbers[1] - 1.0).abs() < 1e-12);
    for length in [0.124, 0.15, 0.178] {
        assert!((wire(length) / wire(measured_at) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_coil_between_whole_windings_lies_between_those_at_its_pitch() {
    let (_, radius, wire) = (0.0, 8e-3, 1e-3);
    let (pitch, measured_at) = (2.6e-3, 0.021);
    let of = |windings: f64| {
        let coil = coil([windings, radius, wire]);
        let at = measured_at * windings / 10.0;
        SteelCoil::at_length(&coil, at, Leads::LeftOut, 2.0, pitch * windings).unwrap()
    };
    let [less, between, more] = [10.0, 10.4, 11.0].map(of);
    assert!((between / (less + 0.4 * (more - less)) - 1.0).abs() < 1e-12);
}

#[test]
fn coils_that_touch_or_are_none_are_refused_in_a_line() {
    let (numbers, measured_at) = S1;
    let new = |numbers, leads, range| SteelCoil::new(&coil(numbers), measured_at, leads, range).map(|_| ());
    let touching = 2.0 * numbers[2] * numbers[0];
    for (refused, part) in [
        (new(numbers, Leads::Open, [touching, 0.178]), "1.04 wire diameters a winding (nearer turns touch and short)"),
        (new(numbers, Leads::Open, [0.13, 3.0]), "below that at which the wire is stretched straight"),
        (new(numbers, Leads::Open, [0.15, 0.13]), "longest length must be above the shortest"),
        (new(numbers, Leads::Beside(5e-3), [0.13, 0.15]), "leads must be above the coil radius"),
        (new([200.0, 8e-3, 1e-3], Leads::Open, [0.5, 0.6]), "windings must be from 1 to 149"),
    ] {
        let message = refused.unwrap_err().to_string();
        assert!(message.contains(part) && message.lines().count() == 1, "{message}");
    }
    let steel = SteelCoil::new(&coil(numbers), measured_at, Leads::Open, [0.124, 0.178]).unwrap();
    for permeability in [0.9, 21.0, f64::NAN] {
        let message = steel.of(permeability).unwrap_err().to_string();
        assert!(message.contains("permeability must be 1 to 20"), "{message}");
    }
}

#[test]
fn the_bias_of_a_ringing_spring_hardly_depends_on_its_wire() {
    // S_T at 230 mm, its first mode of 4 mm: what the mean of L over a cycle makes of the force, in percent of F_nom.
    let spring = coilsense::paper::s_t();
    let (turns, length) = (52, 0.23);
    let pitch = length / turns as f64;
    let even: Vec<f64> = (0..turns).map(|turn| (turn as f64 + 0.5) * pitch).collect();
    let moved = |amplitude: f64| -> Vec<f64> {
        even.iter().map(|place| place + amplitude * (std::f64::consts::PI * place / length).sin()).collect()
    };
    let bias = |permeability: f64| {
        let steel =
            SteelWindings::about(turns, spring.coil_radius(), spring.wire_radius(), permeability, pitch).unwrap();
        let at = |positions: &[f64]| steel.at_positions(positions).unwrap();
        let phases = 32;
        let cycle = (0..phases).map(|phase| at(&moved(4e-3 * (TAU * phase as f64 / phases as f64).cos())));
        let (mut mean, mut bound) = (0.0, 0.0_f64);
        for found in cycle {
            mean += found.inductance / phases as f64;
            bound = bound.max(found.bound);
        }
        let stretched = |by: f64| at(&even.iter().map(|place| place * (1.0 + by)).collect::<Vec<f64>>()).inductance;
        let slope = (stretched(1e-3) - stretched(-1e-3)) / (2e-3 * length);
        let percent = |henry: f64| 100.0 * spring.stiffness() * henry / slope / spring.nominal_force();
        (percent(mean - at(&even).inductance), percent(bound).abs())
    };
    for (permeability, expected) in [(1.0, -0.105), (2.5, -0.109)] {
        let (found, bound) = bias(permeability);
        println!("{permeability}: {found} % of F_nom, within {bound}");
        assert!((found - expected).abs() < 2e-3 && bound < 0.01, "{permeability}: {found}, {bound}");
    }
}

#[test]
fn the_parts_of_a_springs_inductance_are_those_that_the_book_tells() {
    // S1 of the measured runs at 1.05, 1.25 and 1.5 wire diameters a winding, percent of its L (with its constant of −112 nH).
    let ([windings, radius, wire], measured_at) = S1;
    let permeability = 2.08;
    let book = [
        // Crowding, the current along, magnetised by its own current and by the coil's field.
        (1.05, [-0.77, 1.4, 3.1, 9.8]),
        (1.25, [-0.77, 2.2, 3.8, 7.4]),
        (1.5, [-0.77, 3.4, 4.4, 5.6]),
    ];
    for (pitch, expected) in book {
        let length = pitch * 2.0 * wire * windings;
        let own = coil([windings, radius, wire]);
        let of = |permeability, leads| SteelCoil::at_length(&own, measured_at, leads, permeability, length).unwrap();
        let whole = of(permeability, Leads::Open) - 112e-9;
        let along = of(1.0, Leads::Open) - of(1.0, Leads::LeftOut);
        // Of the coil as it is there, between whole windings.
        let there =
            SteelCoil::new(&own, measured_at, Leads::LeftOut, [length, 1.01 * length]).unwrap().coil_radius(length);
        let even = |turns: f64| {
            MaxwellSum::of_coil(&coil([turns, there, wire]), SelfDistance::GeometricMean)
                .at_length(length * turns / windings)
        };
        let air = even(41.0) + windings.fract() * (even(42.0) - even(41.0));
        let by_itself = MU_0 * there * windings * (permeability - 1.0) / 4.0;
        let magnetised = of(permeability, Leads::LeftOut) - of(1.0, Leads::LeftOut);
        let found =
            [of(1.0, Leads::LeftOut) - air, along, by_itself, magnetised - by_itself].map(|part| 100.0 * part / whole);
        println!("{pitch} d: {found:?} %");
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 0.2, "{pitch} d: {found}, {expected}");
        }
    }
}
