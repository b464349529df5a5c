//! The column that stands for the coil, beside figures of an independent program of the same column, and beside the helix.

use coilsense::End;
use coilsense::geometry::Geometry;
use coilsense::helix::{Ends, Helix, Modes, Turning};
use coilsense::neighbours::Column;

use crate::cases::{Case, car, knee, relative, s_a, s_t, valve, wire};

fn span(geometry: &Geometry, length: f64) -> f64 {
    geometry.active_span(length)
}

#[test]
fn the_column_has_the_figures_of_another_program() {
    // Length, clamped, pinned \[Hz\]; what the program printed.
    let rows: [(Case, f64, f64, f64); 7] = [
        (s_t(), 0.196, 42.20, 37.49),
        (s_t(), 0.230, 44.13, 40.29),
        (s_t(), 0.264, 45.53, 42.29),
        (s_a(), 0.102, 121.86, 85.90),
        (valve(), 0.043, 503.3, 262.0),
        (car(), 0.2233, 55.83, 13.80),
        (knee(), 0.105, 81.07, 69.40),
    ];
    for (case, length, clamped, pinned) in rows {
        let rod = wire(&case);
        let span = span(&case.1, length);
        let force = Helix::new(&rod, span, Turning::Held).unwrap().force();
        let column = Column::new(&rod, span, force).unwrap();
        // Its digits, and the length of the wire: along the helix or around the flat coil (0.4 % of S_T's stretched wire).
        // Its digits; the car's spring is near buckling, where f² is the small difference of two forces: 1 % of F makes 5 % of f.
        let within = if pinned < 20.0 { 0.04 } else { 4e-3 };
        assert!(relative(column.pinned().unwrap(), pinned) < within, "{length}: {:?} {pinned}", column.pinned());
        assert!(relative(column.clamped().unwrap(), clamped) < 4e-3, "{length}: {:?} {clamped}", column.clamped());
    }
}

#[test]
fn the_column_is_near_the_helix_where_windings_are_many() {
    for (case, length, within) in
        [(s_t(), 0.230, 5e-4), (knee(), 0.105, 1.5e-3), (s_a(), 0.102, 5e-3), (valve(), 0.043, 0.05)]
    {
        let rod = wire(&case);
        let helix = Helix::new(&rod, span(&case.1, length), Turning::Held).unwrap();
        let column = Column::new(&rod, helix.span(), helix.force()).unwrap();
        let lateral = |ends: Ends| {
            let modes = Modes::new(&helix, ends).unwrap().lowest(6).unwrap();
            let side =
                modes.iter().find(|mode| mode.reaction(End::Two).side_force() > 2.0 || mode.line_strength() < 1e-9);
            side.unwrap().frequency()
        };
        assert!(relative(column.clamped().unwrap(), lateral(Ends::clamped())) < within, "{length}");
        assert!(relative(column.pinned().unwrap(), lateral(Ends::pinned())) < within, "{length} pinned");
        let modes = Modes::new(&helix, Ends::clamped()).unwrap().lowest(6).unwrap();
        let torsion = modes.iter().find(|mode| mode.kind() == coilsense::helix::Kind::Torsional).unwrap();
        assert!(relative(column.torsional(), torsion.frequency()) < 0.03, "{length}: {}", column.torsional());
    }
}

#[test]
fn a_column_buckles_where_the_formula_says_and_ends_that_are_held_carry_more() {
    let rod = wire(&car());
    let of = |force: f64| Column::new(&rod, 0.2, -force).unwrap();
    // The push at which each ceases to swing, by halving.
    let limit = |swings: &dyn Fn(&Column) -> bool| {
        let (mut low, mut high) = (0.0, 1e6);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if swings(&of(middle)) { low = middle } else { high = middle }
        }
        low
    };
    let (pinned, clamped) = (limit(&|it| it.pinned().is_some()), limit(&|it| it.clamped().is_some()));
    // P (1 + P/S) = B κ², κ = π/l and 2π/l; S = k l E/G.
    let p = rod.parameters();
    let shear = rod.flat_stiffness() * 0.2 * p.youngs_modulus / p.shear_modulus;
    let ratio = |push: f64| push * (1.0 + push / shear);
    assert!(relative(ratio(clamped), 4.0 * ratio(pinned)) < 1e-6, "{pinned} {clamped}");
    assert!(Column::new(&rod, 0.0, 1.0).is_err() && Column::new(&rod, 0.2, f64::NAN).is_err());
}
