//! What is refused, and in which words.

use coilsense::End;
use coilsense::geometry::{EndType, Geometry};
use coilsense::helix::{
    Ends, Hand, Helix, Holding, Modes, Response, Rod, RodParameters, Surge, Turning, buckling_length, inextensible,
};
use coilsense::{Excitation, Mount, Spring, SpringParameters};

use proptest::prelude::*;

use crate::cases::{standard, standard_parameters, steel};

#[test]
fn a_wire_that_could_not_be_is_refused_in_one_line() {
    let refused = |change: fn(&mut RodParameters), words: &str| {
        let mut parameters = standard_parameters();
        change(&mut parameters);
        assert_eq!(Rod::new(parameters).unwrap_err().to_string(), words);
    };
    refused(|p| p.wire_diameter = -1.0, "wire diameter must be above zero and finite, got -1 m");
    refused(|p| p.wire_diameter = 0.02, "wire diameter must be below the coil diameter of 0.01 m, got 0.02 m");
    refused(|p| p.coil_radius = f64::NAN, "coil radius must be above zero and finite, got NaN m");
    refused(|p| p.windings = 1e5, "windings must be at most 10000, got 100000");
    refused(|p| p.rest_span = -0.1, "rest span must be finite and not below zero, got -0.1 m");
    refused(|p| p.shear_modulus = 0.0, "shear modulus must be from 1e0 to 1e13 Pa, got 0 Pa");
    refused(
        |p| (p.youngs_modulus, p.shear_modulus) = (300e9, 80e9),
        "youngs modulus must be at most three shear moduli, 240000000000 Pa, got 300000000000 Pa",
    );
    refused(|p| p.density = 0.0, "density must be above zero and finite, got 0 kg/m3");
}

#[test]
fn what_cannot_be_asked_is_refused_in_one_line() {
    let rod = standard();
    let helix = Helix::new(&rod, 0.05, Turning::Held).unwrap();
    let modes = Modes::new(&helix, Ends::clamped()).unwrap();
    let says = |error: coilsense::Error, words: &str| {
        let text = error.to_string();
        assert!(text.contains(words) && !text.contains('\n'), "{text}");
    };
    says(Helix::new(&rod, 0.0, Turning::Held).unwrap_err(), "span must be above zero and below 0.24");
    says(Helix::new(&rod, 0.25, Turning::Free).unwrap_err(), "where the wire is nearly straight, got 0.25 m");
    says(helix.at(f64::INFINITY).unwrap_err(), "span must be finite");
    says(modes.count_below(-1.0).unwrap_err(), "frequency must be finite and not below zero, got -1 Hz");
    says(modes.count_below(1e12).unwrap_err(), "frequency must be one that the helix can be divided for");
    says(modes.frequencies(0).unwrap_err(), "count must be from 1 to 10000, got 0");
    says(modes.mode(0).unwrap_err(), "index must be from 1 to 10000, got 0");
    says(Holding::hinged(f64::NAN).unwrap_err(), "direction must be finite, got NaN rad");
    says(Response::new(&helix, Ends::clamped(), -0.1).unwrap_err(), "loss must be from 0 to 1, got -0.1");
    says(
        inextensible::force(&rod, 0.3, Turning::Held).unwrap_err(),
        "span must be from zero to below the wire's length",
    );
    let flat = Rod::new(RodParameters { rest_span: 0.005, ..standard_parameters() }).unwrap();
    says(buckling_length(&flat, Ends::clamped(), Turning::Held).unwrap_err(), "where the windings touch, got 0.005 m");
    // A rotation that nothing holds has no shape of its own.
    let loose = Modes::new(&helix, Ends::both(Holding::swivel())).unwrap();
    assert_eq!(loose.frequencies(1).unwrap(), [0.0]);
    says(loose.mode(1).unwrap_err(), "index must be that of a mode that swings, got 1");
}

/// Any number at all, and often one of a size that springs have.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), 0.0..3.0_f64, (-9.0..9.0_f64).prop_map(|e| 10_f64.powf(e))]
}

/// A coil within decades of a common one, and its stretch.
fn any_coil() -> impl Strategy<Value = (RodParameters, f64)> {
    (prop::collection::vec(-1.0..1.0_f64, 7), any::<bool>()).prop_map(|(exponents, left)| {
        let power = |index: usize, decades: f64| 10_f64.powf(decades * exponents[index]);
        let (wire, windings) = (1e-3 * power(0, 3.0), 10.0 * power(1, 1.5));
        let coil_radius = wire * (0.51 + 3.0 * power(2, 2.0));
        let rest_span = windings * wire * (1.0 + power(3, 1.5));
        let youngs_modulus = 2e11 * power(4, 1.5);
        let shear_modulus = youngs_modulus / (2.0 + 0.9 * exponents[5].abs());
        let hand = if left { Hand::Left } else { Hand::Right };
        let density = 7850.0;
        let parameters = RodParameters {
            wire_diameter: wire,
            coil_radius,
            windings,
            rest_span,
            youngs_modulus,
            shear_modulus,
            density,
            hand,
        };
        (parameters, rest_span * power(6, 0.5))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn no_number_panics(numbers in prop::collection::vec(any_number(), 9), ball in any::<bool>()) {
        let rod = Rod::new(RodParameters {
            wire_diameter: numbers[0],
            coil_radius: numbers[1],
            windings: numbers[2],
            rest_span: numbers[3],
            youngs_modulus: 1e9 * numbers[4].abs(),
            shear_modulus: 4e8 * numbers[4].abs(),
            density: numbers[5],
            ..standard_parameters()
        });
        if let Ok(helix) = rod.and_then(|rod| Helix::new(&rod, numbers[6], Turning::Held)) {
            prop_assert!(helix.force().is_finite() && helix.coil_radius() > 0.0);
            let ends = if ball { Ends::both(Holding::ball()) } else { Ends::clamped() };
            if let Ok(modes) = Modes::new(&helix, ends) {
                let _ = modes.count_below(numbers[7]);
                for frequency in modes.frequencies(3).unwrap_or_default() {
                    prop_assert!(frequency.is_finite() && frequency >= 0.0);
                }
            }
            let response = Response::new(&helix, ends, 0.01).and_then(|r| r.reaction(numbers[8], End::One, End::Two));
            let _ = response;
        }
    }

    #[test]
    fn every_coil_that_could_be_wound_has_modes((parameters, span) in any_coil()) {
        let rod = Rod::new(parameters).unwrap();
        if let Ok(helix) = Helix::new(&rod, span, Turning::Free) {
            let modes = Modes::new(&helix, Ends::swivel()).unwrap();
            let found = modes.frequencies(4).unwrap();
            prop_assert!(found.windows(2).all(|pair| pair[0] <= pair[1]) && found[3].is_finite());
            for mode in modes.lowest(4).unwrap() {
                prop_assert!(mode.line_strength().is_finite() && mode.frequency() > 0.0);
            }
        }
    }

    #[test]
    fn every_coil_that_swings_moves((parameters, span) in any_coil(), held in 0..4_usize) {
        let rod = Rod::new(parameters).unwrap();
        let ends = [Ends::clamped(), Ends::swivel(), Ends::pinned(), Ends::both(Holding::swivel())][held];
        let spring = Spring::new(SpringParameters {
            rest_length: parameters.rest_span,
            windings: parameters.windings,
            coil_radius: parameters.coil_radius,
            wire_radius: 0.5 * parameters.wire_diameter,
            mass: rod.mass(),
            stiffness: rod.flat_stiffness(),
            min_length: parameters.rest_span,
            max_length: 2.0 * parameters.rest_span,
            nominal_force: None,
            inductance_windings: None,
            sections: None,
        });
        let (Ok(spring), Ok(helix)) = (spring, Helix::new(&rod, span, Turning::Held)) else { return Ok(()) };
        let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel()).unwrap();
        match Surge::new(&spring, &geometry, &helix, ends) {
            Ok(surge) => {
                prop_assert!(held < 3);
                let motion = surge.motion(&Mount::default(), &Excitation::impact(span, 0.1).unwrap()).unwrap();
                let period = 1.0 / surge.spring().surge_frequency();
                let [before, after] = [0.0, 10.0 * period].map(|time| motion.energy(time).unwrap());
                prop_assert!(before.is_finite() && (after - before).abs() < 1e-9 * before, "{} {}", before, after);
                let forces = motion.end_forces(&[0.3 * period]).unwrap();
                prop_assert!(forces.input[0].is_finite() && forces.output[0].is_finite());
            }
            Err(error) => prop_assert!(!error.to_string().contains('\n')),
        }
    }
}
