//! Lateral and torsional frequencies: the paper's spring, limits, buckling.

use std::f64::consts::{FRAC_PI_2, PI};

use coilsense::neighbours::{buckling_force, lateral_frequency, torsional_frequency};

use crate::paper_springs::s_t;
use crate::{of, relative, with};

#[test]
fn s_t_has_neighbours_around_its_surge() {
    let (spring, geometry) = (s_t(), of(&s_t()));
    let force = spring.static_force(0.230);
    let lateral = lateral_frequency(&geometry, spring.mass(), 0.230, force).unwrap();
    let torsional = torsional_frequency(&geometry, spring.mass()).unwrap();
    // Book: theory, section 3: near 40 and near 60 Hz; they are estimates to about 1 Hz.
    assert!((lateral - 40.0).abs() < 1.0, "{lateral}");
    assert!((torsional - 60.0).abs() < 1.5, "{torsional}");
    assert!(lateral < spring.surge_frequency() && spring.surge_frequency() < torsional);
}

#[test]
fn a_limp_spring_is_a_string_and_a_slack_one_a_beam() {
    // Windings so many and wire so thin that bending carries nothing: ½ √(F / m l).
    let limp = with(|p| (p.wire_diameter, p.total_windings) = (1e-4, None)).unwrap();
    let string = 0.5 * (0.5e-3_f64 / (0.01 * 0.230)).sqrt();
    let shear = 206e9 / 81.5e9 * limp.stiffness() * 0.230;
    assert!(shear > 0.5e-3);
    let ours = lateral_frequency(&limp, 0.01, 0.230, 0.5e-3).unwrap();
    // B κ²/F is 3 %.
    assert!(relative(ours, string) < 0.02, "{ours} {string}");
    // Without force and with little shear: a pinned beam, (π/2) √(B/(m l³)).
    let slender = of(&s_t());
    let length = 20.0;
    let bending = 206e9 * PI * 0.002_f64.powi(4) / 32.0 * length / (PI * 0.016 * 52.0 * (1.0 + 206.0 / 163.0));
    let beam = FRAC_PI_2 * (bending / (0.065 * length.powi(3))).sqrt();
    // B κ²/S is below 1e-6.
    assert!(relative(lateral_frequency(&slender, 0.065, length, 0.0).unwrap(), beam) < 1e-6);
}

#[test]
fn a_pushed_spring_swings_slower_until_it_buckles() {
    let geometry = of(&s_t());
    let push = buckling_force(&geometry, 0.230).unwrap();
    let at = |share: f64| lateral_frequency(&geometry, 0.065, 0.230, -share * push);
    let frequencies: Vec<f64> = [-1.0, 0.0, 0.5, 0.9, 0.999].iter().map(|&share| at(share).unwrap()).collect();
    assert!(frequencies.windows(2).all(|pair| pair[1] < pair[0]));
    // Near buckling f² falls in proportion to what is left of the push: 0.001 of it, to the curvature of the law.
    assert!((at(0.999).unwrap() / at(0.0).unwrap()).powi(2) < 1.1e-3);
    // The zero of the law is the buckling force, to the nine digits asked here.
    assert!(at(1.0 - 1e-9).is_ok() && at(1.0 + 1e-9).is_err());
    let error = at(1.001).unwrap_err().to_string();
    assert!(error.starts_with("force must be above -2.33") && error.contains("where the spring buckles"), "{error}");
    // Haringx: P (1 + P/S) = B π²/l².
    let shear = 206e9 / 81.5e9 * geometry.stiffness() * 0.230;
    let bending = 206e9 * PI * 0.002_f64.powi(4) / 32.0 * 0.230 / (PI * 0.016 * 52.0 * (1.0 + 206.0 / 163.0));
    assert!(relative(push * (1.0 + push / shear), bending * (PI / 0.230).powi(2)) < 1e-14);
}
