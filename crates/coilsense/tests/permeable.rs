//! Turns of magnetic wire.
//!
//! | ours | held against |
//! |---|---|
//! | rows of 4 and 8 turns, μr 1 to 20 | axisymmetric finite elements of another author |
//! | an odd number of turns | the same integrals without the mirror in the middle |
//! | a thin ring | μ₀ r (ln(8r/a) − 2 + μr/4) |
//! | wire that is not magnetic | the sum of thin rings at the geometric mean distance |

use coilsense::inductance::{MU_0, PermeableRings, mutual_inductance};

#[test]
fn rows_are_those_of_finite_elements() {
    let (coil, wire) = (8.47e-3, 1.41e-3);
    let permeabilities = [1.0, 1.5, 2.0, 5.0, 20.0];
    for (turns, pitch, expected) in [
        (4, 1.1, [195.411, 206.858, 216.784, 262.786, 434.63]),
        (4, 1.6, [161.780, 170.206, 177.694, 215.277, 377.66]),
        (8, 1.3, [439.749, 464.060, 484.894, 579.105, 923.20]),
    ] {
        for (permeability, nanohenry) in permeabilities.into_iter().zip(expected) {
            let rings = PermeableRings::new(turns, coil, wire, permeability).unwrap();
            let off = rings.inductance(pitch * 2.0 * wire).unwrap() / (1e-9 * nanohenry) - 1.0;
            assert!(off.abs() < 5e-5, "{turns} turns at {pitch} d, {permeability}: {off:e}");
        }
    }
    // By the boundary integrals of another author, on 48 points of an edge.
    for (pitch, permeability, nanohenry) in [
        (1.5, 1.0, 518.2463),
        (1.5, 2.0, 569.586),
        (1.5, 5.0, 679.009),
        (1.05, 1.0, 673.0685),
        (1.05, 2.0, 753.7318),
        (1.05, 5.0, 922.904),
    ] {
        let rings = PermeableRings::new(10, coil, wire, permeability).unwrap();
        let off = rings.inductance(pitch * 2.0 * wire).unwrap() / (1e-9 * nanohenry) - 1.0;
        // Of edges so near to one another 24 points tell less where the wire is more permeable.
        let within = if pitch < 1.1 && permeability > 3.0 { 2e-4 } else { 1e-4 };
        assert!(off.abs() < within, "{pitch} d, {permeability}: {off:e}");
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
