//! What a calibration tells beside its curve: the coil for one permeability of its wire after the other.
//!
//! Next door: calibrations as the command makes them (`coilsense-cli`'s tests), the theory (`coilsense`, `tests/permeable`).

use coilsense::inductance::theories::Coil;
use coilsense::inductance::{Leads, SteelCoil};
use coilsense_lab::calibration::{ByPermeability, Measured, Outcome, Plan};
use coilsense_lab::recording::{Cleaning, Mapping, Points};
use coilsense_lab::request::Given;

const LENGTHS: [f64; 6] = [0.126, 0.136, 0.146, 0.156, 0.166, 0.176];

/// The measured spring S1.
fn coil() -> Coil {
    Coil::new(41.904, 8.47e-3, 1.41e-3).unwrap()
}

fn steel() -> SteelCoil {
    SteelCoil::new(&coil(), LENGTHS[0], Leads::Open, [0.1235, 0.1785]).unwrap()
}

/// Points on it at a permeability of 2.1, 50 nH above.
fn outcome(coil: Option<Coil>) -> Outcome {
    let curve = steel().of(2.1).unwrap();
    let row = |length: &f64| format!("0,{length},{}\n", curve.inductance(*length) + 5e-8);
    let text = format!("u1 [m],u2 [m],L [H]\n{}", LENGTHS.iter().map(row).collect::<String>());
    let points = Points::of_text("s1.csv", text.into_bytes(), &Mapping::default(), &Cleaning::default()).unwrap();
    let plan = Plan { coil, ..Plan::of(&Given::default(), None).unwrap() };
    Outcome::new(Measured::of_log(&points, None).unwrap(), plan).unwrap()
}

#[test]
fn the_permeability_of_the_points_leaves_their_constant_alone() {
    let told = ByPermeability::of(&outcome(Some(coil())), &LENGTHS).unwrap();
    assert!(told.permeabilities.len() == 31 && (told.permeabilities[11] - 2.1).abs() < 1e-12);
    let curve = steel().of(2.1).unwrap();
    for (length, henry) in LENGTHS.iter().zip(&told.inductances[11]) {
        // Both are polynomials over nearly the same lengths.
        assert!((henry / curve.inductance(*length) - 1.0).abs() < 3e-6, "{henry}");
    }
    assert!(told.inductances.windows(2).all(|pair| pair[0].iter().zip(&pair[1]).all(|(less, more)| less < more)));
}

#[test]
fn a_straight_line_between_two_of_its_permeabilities_is_6e_5_of_l_off() {
    let told = ByPermeability::of(&outcome(Some(coil())), &LENGTHS).unwrap();
    let mut most: f64 = 0.0;
    for (place, pair) in told.inductances.windows(2).enumerate() {
        let between = steel().of(told.permeabilities[place] + 0.05).unwrap();
        for (index, length) in LENGTHS.iter().enumerate() {
            let line = 0.5 * (pair[0][index] + pair[1][index]);
            most = most.max((line / between.inductance(*length) - 1.0).abs());
        }
    }
    println!("{most:e}");
    assert!((1e-5..7e-5).contains(&most), "{most:e}");
}

#[test]
fn without_a_coil_or_with_turns_that_touch_nothing_is_told() {
    assert_eq!(ByPermeability::of(&outcome(None), &LENGTHS), None);
    // So many windings that they lie at 1.03 wire diameters at the shortest point.
    let close = Coil::new(0.126 / (1.03 * 2.82e-3), 8.47e-3, 1.41e-3).unwrap();
    assert_eq!(ByPermeability::of(&outcome(Some(close)), &LENGTHS), None);
}
