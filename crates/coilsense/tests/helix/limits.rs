//! Where the helix meets simpler models.

use std::f64::consts::{PI, TAU};

use coilsense::helix::{
    Ends, Hand, Helix, Kind, Modes, Rod, RodParameters, StiffnessAt, Turning, buckling_length, inextensible,
};

use crate::cases::{Case, frequencies, helix, relative, s_a, s_t, standard_parameters, valve, wire};

#[test]
fn a_thin_wire_follows_the_closed_form() {
    for (case, lengths) in
        [(s_t(), [0.150, 0.196, 0.264]), (s_a(), [0.082, 0.102, 0.300]), (valve(), [0.038, 0.043, 0.060])]
    {
        let (rod, geometry) = (wire(&case).thin(), &case.1);
        for (length, turning) in
            lengths.into_iter().flat_map(|length| [(length, Turning::Held), (length, Turning::Free)])
        {
            let span = geometry.active_span(length);
            let helix = Helix::new(&rod, span, turning).unwrap();
            // Two ways to the same figure; the force near rest is a small difference.
            assert!(relative(helix.stiffness(), inextensible::stiffness(&rod, span, turning).unwrap()) < 1e-9);
            assert!(relative(helix.force(), inextensible::force(&rod, span, turning).unwrap()) < 1e-9);
            // The slope of the force, by differences: 1e-8 of the cube of a step of 1e-3 and of rounding.
            let step = 1e-4 * span;
            let force = |span| inextensible::force(&rod, span, turning).unwrap();
            let slope = (force(span + step) - force(span - step)) / (2.0 * step);
            assert!(relative(slope, inextensible::stiffness(&rod, span, turning).unwrap()) < 1e-8);
        }
    }
}

#[test]
fn a_stretched_spring_grows_stiffer_and_a_compressed_one_softer() {
    let ratio = |case: &Case, length: f64| {
        let rod = wire(case);
        inextensible::stiffness(&rod, case.1.active_span(length), Turning::Held).unwrap() / rod.flat_stiffness()
    };
    // Printed to 1e-4; valve: spans 30, 35, 40 mm.
    for (case, length, printed) in [
        (s_t(), 0.196, 1.0073),
        (s_t(), 0.230, 1.0114),
        (s_t(), 0.264, 1.0161),
        (valve(), 0.038, 0.9835),
        (valve(), 0.043, 0.9864),
        (valve(), 0.048, 0.9899),
    ] {
        assert!((ratio(&case, length) - printed).abs() < 5.1e-5);
    }
}

#[test]
fn load_turns_the_sign_of_the_couple() {
    for (length, textbook) in [(0.196, -0.157), (0.230, -0.184), (0.264, -0.210)] {
        let stretched = helix(&s_t(), length);
        // The same shape without load.
        let shape = RodParameters { rest_span: length, ..*stretched.rod().parameters() };
        let unloaded = Helix::new(&Rod::new(shape).unwrap().thin(), length, Turning::Held).unwrap();
        let (tan, ratio) = (unloaded.pitch_angle().tan(), 206.0 / 163.0);
        let formula = -unloaded.coil_radius() * tan * (ratio - 1.0) / (1.0 + ratio * tan * tan);
        // Two ways to the same figure, and that figure as printed in mm.
        assert!(relative(unloaded.couple_per_force(), formula) < 1e-9);
        assert!((1e3 * formula - textbook).abs() < 1e-3);
        assert!(stretched.couple_per_force() > 1e-4);
    }
}

#[test]
fn a_short_arc_is_a_beam() {
    // 1e-5 rad of a helix 1 m long: it rises 1e-6 of its length, far less than its thickness.
    let (arc, length) = (1e-5, 1.0);
    let rod = Rod::new(RodParameters {
        wire_diameter: 1e-3,
        coil_radius: length / arc,
        windings: arc / TAU,
        rest_span: 0.1,
        ..standard_parameters()
    });
    let rod = rod.unwrap();
    let helix = Helix::new(&rod, 0.1, Turning::Held).unwrap();
    let p = rod.parameters();
    let unit = (p.youngs_modulus * (1e-3_f64 / 4.0).powi(2) / p.density).sqrt() / rod.wire_length().powi(2) / TAU;
    // Euler's beam with both ends held, each in two planes.
    for (value, euler) in frequencies(&helix, Ends::clamped(), 4).iter().zip([22.3733, 22.3733, 61.6728, 61.6728]) {
        // Shear and the inertia of turning sections lower it by some 30 (d/L)² = 3e-5; the figures have six digits.
        assert!(relative(value / unit, euler) < 5e-5, "{} {euler}", value / unit);
    }
}

#[test]
fn torsion_is_the_root_of_one_plus_nu_above_the_surge_of_a_long_spring() {
    for nu in [0.25, 0.3] {
        let rod = Rod::new(RodParameters {
            wire_diameter: 0.001,
            coil_radius: 0.025,
            windings: 200.0,
            rest_span: 0.21,
            youngs_modulus: 206e9,
            shear_modulus: 103e9 / (1.0 + nu),
            density: 7850.0,
            hand: Hand::Right,
        });
        let rod = rod.unwrap();
        // Stretched, so that the sideways modes lie above the surge.
        let modes = Modes::new(&Helix::new(&rod, 0.9, Turning::Held).unwrap(), Ends::clamped()).unwrap();
        let first = |kind| (1..20).map(|index| modes.mode(index).unwrap()).find(|mode| mode.kind() == kind).unwrap();
        let (axial, torsional) = (first(Kind::Axial).frequency(), first(Kind::Torsional).frequency());
        // Both limits hold to first order in the angle squared, (0.9/31)² = 8e-4, here times about 2.
        assert!(relative(torsional / axial, (1.0 + nu).sqrt()) < 2e-3, "{}", torsional / axial);
        let bar = 0.5 * (modes.helix().stiffness() / rod.mass()).sqrt();
        assert!(relative(axial, bar) < 1e-3, "{axial} {bar}");
    }
}

#[test]
fn it_buckles_where_haringx_says() {
    // `[EN13906-1]`: deflection at buckling over l0, seating factor 1/2 clamped and 1 pinned.
    let haringx = |slenderness: f64, seating: f64| {
        let (g, e) = (81.5, 206.0);
        let root = 1.0 - (1.0 - g / e) / (0.5 + g / e) * (PI / (seating * slenderness)).powi(2);
        (root >= 0.0).then(|| 0.5 / (1.0 - g / e) * (1.0 - root.sqrt()))
    };
    let buckles = |ratio: f64, slenderness: f64, ends: Ends| {
        let rod = Rod::new(RodParameters {
            wire_diameter: 0.02 * ratio,
            coil_radius: 0.01,
            windings: 20.0,
            rest_span: 0.02 * slenderness,
            youngs_modulus: 206e9,
            shear_modulus: 81.5e9,
            density: 7850.0,
            hand: Hand::Right,
        });
        let (rod, rest) = (rod.unwrap(), 0.02 * slenderness);
        buckling_length(&rod, ends, Turning::Held).unwrap().map(|span| 1.0 - span / rest)
    };
    // The formula has neither curvature of the wire nor its angle: O((d/D)²), a per cent at 0.1 and a quarter of that at 0.05.
    for (ratio, slenderness, tolerance) in [(0.1, 6.0, 0.015), (0.1, 8.0, 0.015), (0.05, 8.0, 0.004)] {
        for (ends, seating) in [(Ends::clamped(), 0.5), (Ends::pinned(), 1.0)] {
            let (found, formula) = (buckles(ratio, slenderness, ends).unwrap(), haringx(slenderness, seating).unwrap());
            assert!(relative(found, formula) < tolerance, "{ratio} {slenderness}: {found} {formula}");
        }
    }
    assert!(buckles(0.1, 4.0, Ends::clamped()).is_none() && haringx(4.0, 0.5).is_none());
    // There the lowest frequency has come down to zero: just before, it is a hundredth of that at rest or less.
    let rod = Rod::new(RodParameters { rest_span: 0.08, windings: 20.0, ..standard_parameters() }).unwrap();
    let span = buckling_length(&rod, Ends::pinned(), Turning::Held).unwrap().unwrap();
    let lowest = |span| frequencies(&Helix::new(&rod, span, Turning::Held).unwrap(), Ends::pinned(), 1)[0];
    assert!(lowest(span * (1.0 + 1e-6)) < 0.01 * lowest(0.08) && lowest(span * (1.0 - 1e-6)) == 0.0);
}

#[test]
fn stiffness_and_mass_are_what_was_given() {
    for (spring, geometry) in [s_t(), s_a(), valve()] {
        let rod = Rod::of_spring(&spring, &geometry, StiffnessAt::Range, Hand::Right).unwrap();
        let helix = Helix::new(&rod, geometry.active_span(spring.mid_length()), Turning::Held).unwrap();
        // One factor, rounded.
        assert!(relative(helix.stiffness(), spring.stiffness()) < 1e-12 && relative(rod.mass(), spring.mass()) < 1e-14);
        let flat = Rod::of_spring(&spring, &geometry, StiffnessAt::Flat, Hand::Right).unwrap();
        assert!(relative(flat.mass() * flat.pitch_angle().cos(), spring.mass()) < 1e-14);
        // Rolled flat, the solved rod with its shear has the k of the formula; the square of the pitch, 1e-8, is left. By the formula alone it would
        // be softer by 0.55 (d/2R)² or so: 0.9 % for S_T, 1 % for the valve spring, 1.4 % for S_A.
        let rolled = |rod: &Rod| {
            let p = rod.parameters();
            let span = 1e-4 * TAU * p.windings * p.coil_radius;
            Helix::new(&Rod::new(RodParameters { rest_span: span, ..*p }).unwrap(), span, Turning::Held)
                .unwrap()
                .stiffness()
        };
        assert!(relative(rolled(&flat), spring.stiffness()) < 3e-8);
        let shear = spring.stiffness() / rolled(&wire(&(spring.clone(), geometry))) - 1.0;
        let index = 2.0 * spring.coil_radius() / spring.wire_diameter();
        assert!((0.54..0.57).contains(&(shear * index * index)), "{}", shear * index * index);
    }
}
