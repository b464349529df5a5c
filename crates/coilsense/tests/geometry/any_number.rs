//! Properties: whatever is sent, an error or finite answers; never a panic.

use std::f64::consts::PI;

use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
use coilsense::modes::continuous_frequencies;
use coilsense::neighbours::{buckling_force, lateral_frequency, torsional_frequency};
use coilsense::{FarEnd, Spring};
use proptest::prelude::*;

use crate::paper_springs::s_t_with;
use crate::steel;

/// Any number at all, and often one of a size that springs have.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), -3.0..6.0_f64, (-12.0..12.0_f64).prop_map(|e| 10_f64.powf(e))]
}

fn any_end() -> impl Strategy<Value = EndType> {
    prop_oneof![
        Just(EndType::Hooks),
        Just(EndType::Open),
        Just(EndType::OpenGround),
        Just(EndType::Closed),
        Just(EndType::ClosedGround)
    ]
}

/// Everything that a geometry says, which must be finite, and above zero.
fn all_of(geometry: &Geometry) -> Vec<f64> {
    let mut values = vec![
        geometry.stiffness(),
        geometry.active_mass(),
        geometry.active_mass_at(0.1),
        geometry.total_mass(),
        geometry.index(),
        geometry.wahl_factor(),
        geometry.shear_stress(1.0),
        geometry.corrected_shear_stress(1.0),
        geometry.material().impact_stress(1.0),
        geometry.solid_length(),
        geometry.surge_frequency(),
        geometry.surge_frequency_en13906(),
        geometry.effective_rest_length(),
        torsional_frequency(geometry, 0.1).unwrap(),
        buckling_force(geometry, 0.1).unwrap(),
    ];
    values.extend(geometry.wire_resistance());
    values.extend(lateral_frequency(geometry, 0.1, 0.1, 0.0));
    values
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn no_number_panics_and_what_is_taken_gives_finite_answers(
        numbers in prop::collection::vec(any_number(), 14),
        end_type in any_end(),
        given_total in any::<bool>(),
    ) {
        let material = Material::new(MaterialParameters {
            shear_modulus: numbers[0].abs() * 1e9,
            youngs_modulus: numbers[1].abs() * 1e9,
            density: numbers[2].abs(),
            shear_modulus_temperature: None,
            expansion: None,
            resistivity: Some(numbers[3].abs() * 1e-6),
            relative_permeability: Some(numbers[4]),
        });
        let material = material.unwrap_or_else(|_| steel());
        let geometry = Geometry::new(GeometryParameters {
            wire_diameter: numbers[5],
            coil_diameter: numbers[6],
            active_windings: numbers[7],
            total_windings: given_total.then_some(numbers[8]),
            end_type,
            material,
            rest_length: numbers[9],
            initial_tension: numbers[10],
        });
        if let Ok(geometry) = geometry {
            for (index, value) in all_of(&geometry).into_iter().enumerate() {
                prop_assert!(value.is_finite() && value > 0.0, "value {} is {}", index, value);
            }
            for result in [
                torsional_frequency(&geometry, numbers[11]),
                lateral_frequency(&geometry, numbers[11], numbers[12], numbers[13]),
                buckling_force(&geometry, numbers[12]),
            ].into_iter().flatten() {
                prop_assert!(result.is_finite() && result > 0.0);
            }
        }
    }

    #[test]
    fn every_coil_that_could_be_wound_gives_finite_answers(
        exponents in prop::collection::vec(-1.0..1.0_f64, 7),
        end_type in any_end(),
    ) {
        // Decades about a steel spring of 1 mm wire, all that solids and springs have; the coil from 1.001 to 1e4 wires wide.
        let power = |index: usize, decades: f64| 10_f64.powf(decades * exponents[index]);
        let material = Material::new(MaterialParameters::elastic(8e10 * power(0, 1.5), 2e11 * power(1, 1.5), 8e3 * power(2, 2.0)));
        let (wire, windings) = (1e-3 * power(3, 3.0), 10.0 * power(4, 3.0));
        let geometry = Geometry::new(GeometryParameters {
            wire_diameter: wire,
            coil_diameter: wire * (1.0 + 3.0 * power(5, 3.5)),
            active_windings: windings,
            total_windings: None,
            end_type,
            material: material.unwrap(),
            rest_length: (windings + 3.0) * wire * (1.0 + power(6, 2.0)),
            initial_tension: 0.0,
        });
        for (index, value) in all_of(&geometry.unwrap()).into_iter().enumerate() {
            prop_assert!(value.is_finite() && value > 0.0, "value {} is {}", index, value);
        }
    }

    #[test]
    fn every_end_mass_has_its_root(exponent in -12.0..12.0_f64, mode in 1..40_usize) {
        let spring = Spring::new(s_t_with(|p| (p.mass, p.stiffness) = (1.0, 1.0))).unwrap();
        let Ok(frequencies) = continuous_frequencies(&spring, FarEnd::Mass(10_f64.powf(exponent)), mode) else {
            return Ok(());
        };
        let (beta, j) = (frequencies[mode - 1], mode as f64);
        prop_assert!((j - 1.0) * PI <= beta && beta <= (j - 0.5) * PI, "{}", beta);
    }
}
