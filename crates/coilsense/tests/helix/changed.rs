//! Wires whose moduli and density are multiplied, and the static force over a range, against helices that are found anew.

use coilsense::helix::{Ends, Helix, Holding, Rod, RodParameters, StaticCurve, Surge, Turning};
use coilsense::signals::sampled_window;
use coilsense::{Damping, End, EndInput, Excitation, Mount, Start};

use crate::cases::{car, helix, s_t, valve};

fn most(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

#[test]
fn moduli_and_density_scale_forces_and_frequencies_of_the_same_shape() {
    let tilting = Holding::hinged(0.7).unwrap();
    for (case, length, ends) in
        [(s_t(), 0.230, Ends::clamped()), (valve(), 0.043, Ends::new(tilting, Holding::clamped()))]
    {
        let (stiffer, faster) = (1.13, 0.94);
        let found = helix(&case, length);
        let parameters = found.rod().parameters();
        let anew = Rod::new(RodParameters {
            youngs_modulus: stiffer * parameters.youngs_modulus,
            shear_modulus: stiffer * parameters.shear_modulus,
            density: stiffer / (faster * faster) * parameters.density,
            ..*parameters
        })
        .unwrap();
        let anew = Helix::new(&anew, found.span(), Turning::Held).unwrap();
        let anew = Surge::new(&case.0, &case.1, &anew, ends).unwrap();
        let changed = Surge::new(&case.0, &case.1, &found, ends).unwrap().changed(stiffer, faster).unwrap();
        // Damping by ratios and by the stiffness scale differently; both ends move.
        let input = EndInput::harmonic(1e-4, 0.4 * anew.modes()[0].frequency(), 0.2);
        for damping in [Damping::None, Damping::Modal(0.01), Damping::StiffnessProportional { time: 1e-6 }] {
            let mount = Mount::new(coilsense::FarEnd::Position, damping).unwrap();
            for end in [End::One, End::Two] {
                let excitation = Excitation::harmonic(length, end, input.clone(), Start::Massless).unwrap();
                let times = sampled_window(20_000.0, 0.0, 0.02).unwrap();
                let [one, other] =
                    [changed.motion(&mount, &excitation).unwrap(), anew.motion(&mount, &excitation).unwrap()];
                let forces = [&one, &other].map(|motion| motion.end_forces(&times).unwrap());
                let moving = most(forces[1].input.iter().map(|force| force - forces[1].input[0]));
                let apart = most(forces[0].input.iter().zip(&forces[1].input).map(|(a, b)| a - b))
                    .max(most(forces[0].output.iter().zip(&forces[1].output).map(|(a, b)| a - b)));
                // Modes are found to 1e-10 of their frequency, and turn for some fifty periods.
                assert!(apart < 1e-7 * moving, "{apart} N of {moving} N");
                let [one, other] = [changed.reactions(&one, &times).unwrap(), anew.reactions(&other, &times).unwrap()];
                for at in 0..2 {
                    for axis in 0..3 {
                        let apart = most(one[at].force[axis].iter().zip(&other[at].force[axis]).map(|(a, b)| a - b));
                        assert!(apart < 1e-7 * moving, "force {axis}: {apart} N of {moving} N");
                        let apart = most(one[at].couple[axis].iter().zip(&other[at].couple[axis]).map(|(a, b)| a - b));
                        assert!(apart < 1e-7 * moving * 0.02, "couple {axis}: {apart} N m");
                    }
                }
            }
        }
    }
}

#[test]
fn a_factor_that_is_not_above_zero_is_refused() {
    let case = s_t();
    let surge = Surge::new(&case.0, &case.1, &helix(&case, 0.230), Ends::clamped()).unwrap();
    for (stiffness, frequency) in [(0.0, 1.0), (-1.0, 1.0), (f64::NAN, 1.0), (1.0, 0.0), (1.0, f64::INFINITY)] {
        assert!(surge.changed(stiffness, frequency).is_err(), "{stiffness} {frequency}");
    }
}

#[test]
fn the_static_curve_is_the_force_at_every_length() {
    for (case, between) in [(s_t(), (0.19, 0.27)), (valve(), (0.036, 0.050)), (car(), (0.15, 0.30))] {
        let rod = *helix(&case, 0.5 * (between.0 + between.1)).rod();
        for turning in [Turning::Held, Turning::Free] {
            let curve = StaticCurve::new(&rod, turning, between).unwrap();
            for step in 0..=40 {
                let span = between.0 + (between.1 - between.0) * f64::from(step) / 40.0;
                let force = Helix::new(&rod, span, turning).unwrap().force();
                assert!((curve.force(span) - force).abs() < 1e-10 * force.abs().max(1.0), "{span}: {force}");
            }
        }
        assert!(StaticCurve::new(&rod, Turning::Held, (between.1, between.0)).is_err());
        assert!(StaticCurve::new(&rod, Turning::Held, (0.0, between.1)).is_ok());
        assert!(StaticCurve::new(&rod, Turning::Held, (between.0, f64::NAN)).is_err());
    }
}
