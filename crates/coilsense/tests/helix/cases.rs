//! The springs of the figures, their constants scaled to flat-coil stiffness and mass.

use std::f64::consts::{PI, TAU};

use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material, MaterialParameters};
use coilsense::helix::{Ends, Hand, Helix, Modes, Rod, RodParameters, Turning};
use coilsense::{Spring, SpringParameters, paper};

/// Moduli and density of spring steel, as `data/materials.toml` of the lab has them.
pub fn steel() -> Material {
    Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0)).unwrap()
}

/// A spring with its geometry.
pub type Case = (Spring, Geometry);

pub fn s_t() -> Case {
    let spring = paper::s_t();
    let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel()).unwrap();
    (spring, geometry)
}

pub fn s_a() -> Case {
    let spring = paper::s_a();
    let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel()).unwrap();
    (spring, geometry)
}

/// A spring whose stiffness and mass are the formulas'.
fn drawn(parameters: GeometryParameters, min_length: f64, max_length: f64) -> Case {
    let geometry = Geometry::new(parameters).unwrap();
    let spring = Spring::new(SpringParameters {
        rest_length: geometry.effective_rest_length(),
        windings: parameters.active_windings,
        coil_radius: 0.5 * parameters.coil_diameter,
        wire_radius: 0.5 * parameters.wire_diameter,
        mass: geometry.active_mass(),
        stiffness: geometry.stiffness(),
        min_length,
        max_length,
        nominal_force: None,
        inductance_windings: None,
        sections: None,
    });
    (spring.unwrap(), geometry)
}

/// The valve spring of `examples/valve-spring.toml`.
pub fn valve() -> Case {
    valve_of(5.75)
}

/// The same with other windings.
pub fn valve_of(windings: f64) -> Case {
    let parameters = GeometryParameters {
        wire_diameter: 0.004,
        coil_diameter: 0.025,
        active_windings: windings,
        total_windings: None,
        end_type: EndType::ClosedGround,
        material: steel(),
        rest_length: 0.057,
        initial_tension: 0.0,
    };
    drawn(parameters, 0.038, 0.048)
}

/// The car's spring of `examples/car-suspension.toml`.
pub fn car() -> Case {
    let parameters = GeometryParameters {
        wire_diameter: 0.0125,
        coil_diameter: 0.115,
        active_windings: 6.5,
        total_windings: None,
        end_type: EndType::ClosedGround,
        material: steel(),
        rest_length: 0.350,
        initial_tension: 0.0,
    };
    drawn(parameters, 0.1533, 0.2933)
}

/// The knee spring of `examples/own-geometry.toml`.
pub fn knee() -> Case {
    let parameters = GeometryParameters {
        wire_diameter: 0.0015,
        coil_diameter: 0.012,
        active_windings: 40.0,
        total_windings: None,
        end_type: EndType::Hooks,
        material: steel(),
        rest_length: 0.0615,
        initial_tension: 8.0,
    };
    drawn(parameters, 0.080, 0.130)
}

/// The spring on which helices are commonly compared, without load.
pub fn standard() -> Rod {
    Rod::new(standard_parameters()).unwrap()
}

pub fn standard_parameters() -> RodParameters {
    let angle = 8.5744_f64.to_radians();
    RodParameters {
        wire_diameter: 0.001,
        coil_radius: 0.005,
        windings: 7.6,
        rest_span: std::f64::consts::TAU * 7.6 * 0.005 * angle.tan(),
        youngs_modulus: 206e9,
        shear_modulus: 206e9 / 2.6,
        density: 7900.0,
        hand: Hand::Right,
    }
}

/// The wire of a case as the programs of the figures have it: the formulas of the flat coil, which know no shear, brought to the spring's k and m.
pub fn wire((spring, geometry): &Case) -> Rod {
    let material = geometry.material();
    let (d, radius, windings) = (spring.wire_diameter(), spring.coil_radius(), spring.windings());
    let stiffness = material.shear_modulus() * d.powi(4) / (64.0 * radius.powi(3) * windings);
    let mass = material.density() * 0.25 * PI * d.powi(2) * TAU * radius * windings;
    Rod::new(RodParameters {
        wire_diameter: d,
        coil_radius: radius,
        windings,
        rest_span: geometry.active_span(spring.rest_length()),
        youngs_modulus: spring.stiffness() / stiffness * material.youngs_modulus(),
        shear_modulus: spring.stiffness() / stiffness * material.shear_modulus(),
        density: spring.mass() / mass * material.density(),
        hand: Hand::Right,
    })
    .unwrap()
}

/// [`wire`] at a length of the spring, brought there with its ends held.
pub fn helix(case: &Case, length: f64) -> Helix {
    Helix::new(&wire(case), case.1.active_span(length), Turning::Held).unwrap()
}

pub fn frequencies(helix: &Helix, ends: Ends, count: usize) -> Vec<f64> {
    Modes::new(helix, ends).unwrap().frequencies(count).unwrap()
}

pub fn relative(value: f64, expected: f64) -> f64 {
    ((value - expected) / expected).abs()
}
