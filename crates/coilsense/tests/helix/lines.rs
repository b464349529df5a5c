//! What each mode puts into a force sensor, against the tables of an independent program.

use coilsense::End;
use coilsense::helix::{Ends, Hand, Helix, Kind, Mode, Modes, Response, Rod, RodParameters, Turning};

use crate::cases::{car, helix, knee, relative, s_a, s_t, standard, valve, valve_of};

fn modes(helix: &Helix, count: usize) -> Vec<Mode> {
    Modes::new(helix, Ends::clamped()).unwrap().lowest(count).unwrap()
}

/// First of a kind.
fn first(modes: &[Mode], kind: Kind) -> &Mode {
    modes.iter().find(|mode| mode.kind() == kind).unwrap()
}

fn unloaded() -> Helix {
    Helix::new(&standard(), standard().parameters().rest_span, Turning::Held).unwrap()
}

#[test]
fn strengths_of_axial_torsional_and_sideways_lines() {
    // Printed: axial, torsional, sideways pair. Ours is the residue (`laws`); the table's own normalisation is not stated and lies up to 1.5 %
    // (axial) and 5 % (torsional) beside it, the car's pair 13 %, where three lines overlap.
    for (name, helix, [axial, torsional, pair]) in [
        ("S_T 196", helix(&s_t(), 0.196), [1.0005, 0.0041, 0.0005]),
        ("S_T 230", helix(&s_t(), 0.230), [0.998, 0.0109, 0.0007]),
        ("S_T 264", helix(&s_t(), 0.264), [0.992, 0.0209, 0.0009]),
        ("S_A 102", helix(&s_a(), 0.102), [0.987, 0.0004, 0.0014]),
        ("knee 105", helix(&knee(), 0.105), [0.997, 0.0053, 0.0024]),
        ("valve 43", helix(&valve(), 0.043), [0.846, 0.092, 0.010]),
        ("car 223.3", helix(&car(), 0.2233), [0.823, 0.062, 0.072]),
        ("standard", unloaded(), [0.943, 0.026, 0.015]),
    ] {
        let modes = modes(&helix, 4);
        let sideways: f64 = modes.iter().filter(|mode| mode.kind() == Kind::Lateral).map(Mode::line_strength).sum();
        let (a, t) = (first(&modes, Kind::Axial).line_strength(), first(&modes, Kind::Torsional).line_strength());
        assert!(relative(a, axial) < 0.015, "{name}: {a} {axial}");
        // Half a unit of the last printed digit on top.
        assert!((t - torsional).abs() < 0.05 * torsional + 5e-5, "{name}: {t} {torsional}");
        assert!((sideways - pair).abs() < 0.13 * pair + 5e-5, "{name}: {sideways} {pair}");
    }
}

#[test]
fn the_torsional_line_of_s_t_has_one_per_cent_of_the_axial_one() {
    let modes = modes(&helix(&s_t(), 0.230), 4);
    let torsional = first(&modes, Kind::Torsional);
    assert!((torsional.frequency() - 60.8).abs() < 0.05);
    // 1.1 % to its last digit.
    assert!((torsional.line_strength() / first(&modes, Kind::Axial).line_strength() - 0.011).abs() < 5e-4);
}

#[test]
fn modes_one_by_one_are_those_found_together() {
    let modes = Modes::new(&helix(&valve(), 0.043), Ends::clamped()).unwrap();
    for (index, mode) in modes.lowest(5).unwrap().iter().enumerate() {
        let alone = modes.mode(index + 1).unwrap();
        // Roots are found to 4e-13 from other brackets.
        assert!(relative(alone.frequency(), mode.frequency()) < 1e-11);
        assert!(relative(alone.line_strength(), mode.line_strength()) < 1e-6);
    }
}

#[test]
fn kinds_of_the_rows() {
    let kinds = |helix: &Helix| -> String {
        let letter = |mode: Mode| match mode.kind() {
            Kind::Axial => 'A',
            Kind::Torsional => 'T',
            Kind::Lateral => 'L',
            Kind::Mixed => 'm',
        };
        modes(helix, 10).into_iter().map(letter).collect()
    };
    assert_eq!(kinds(&helix(&s_t(), 0.230)), "LLATLLATLL");
    assert_eq!(kinds(&helix(&s_a(), 0.102)), "LLATLLATLL");
    assert_eq!(kinds(&unloaded()), "LLATLLATAL");
    // Printed: A T L L A L L/A T A L, where the ninth has half of its energy along the axis.
    assert_eq!(kinds(&helix(&valve(), 0.043)), "ATLLALmTmL");
}

#[test]
fn shares_add_up_and_long_springs_have_pure_modes() {
    for mode in modes(&helix(&s_t(), 0.230), 10) {
        let shares = mode.shares();
        let sum = shares.axial + shares.torsional + shares.lateral + shares.within;
        // Rounding of four quotients.
        assert!((sum - 1.0).abs() < 1e-14);
        assert!(shares.within < 2e-3 && shares.axial.max(shares.torsional).max(shares.lateral) > 0.98);
    }
}

#[test]
fn side_force_and_couples_of_a_slow_pull() {
    // N/N and mm, printed to two digits or more.
    for (name, helix, side, tilting) in [
        ("S_T", helix(&s_t(), 0.230), 0.0046, 0.53),
        ("S_A", helix(&s_a(), 0.102), 0.0088, 0.45),
        ("valve", helix(&valve(), 0.043), 0.058, 1.09),
        ("valve 5.5", helix(&valve_of(5.5), 0.043), 0.0013, 0.58),
        ("valve 6.0", helix(&valve_of(6.0), 0.043), 0.077, 1.35),
        ("car", helix(&car(), 0.2233), 0.0019, 0.58),
        ("standard", unloaded(), 0.012, 0.31),
    ] {
        let response = Response::new(&helix, Ends::clamped(), 0.0).unwrap();
        let reaction = response.reaction(0.0, End::One, End::Two).unwrap();
        // Half a unit of the second digit is up to 5 % of the value.
        assert!(relative(reaction.side_force(), side) < 0.03, "{name}: {}", reaction.side_force());
        assert!(relative(1e3 * reaction.tilting_couple(), tilting) < 0.015, "{name}: {}", reaction.tilting_couple());
        // What is held at both ends is in balance: the other end feels the opposite.
        let other = response.reaction(0.0, End::One, End::One).unwrap();
        for (one, two) in reaction.force().iter().zip(other.force()) {
            assert!((one + two).norm() < 1e-8 * reaction.force()[2].norm());
        }
    }
}

#[test]
fn side_force_and_couples_at_the_axial_resonance() {
    // N/N, mm, mm; the couple about the axis without its sign. Tables are at some damping, not stated: 1 % where lines overlap (car).
    for (name, helix, side, tilting, axis) in [
        ("S_T", helix(&s_t(), 0.230), 0.025, 0.74, 0.76),
        ("S_A", helix(&s_a(), 0.102), 0.038, 0.86, 0.15),
        ("valve", helix(&valve(), 0.043), 0.21, 2.1, 3.2),
        ("car", helix(&car(), 0.2233), 0.21, 15.7, 19.4),
        ("standard", unloaded(), 0.12, 1.1, 0.65),
    ] {
        let modes = modes(&helix, 4);
        let reaction = first(&modes, Kind::Axial).reaction(End::Two);
        // Half a unit of the second digit is up to 5 %.
        assert!(relative(reaction.side_force(), side) < 0.035, "{name}: {}", reaction.side_force());
        assert!(relative(1e3 * reaction.tilting_couple(), tilting) < 0.03, "{name}: {}", reaction.tilting_couple());
        assert!(relative(1e3 * reaction.axis_couple().abs(), axis) < 0.03, "{name}: {}", reaction.axis_couple());
    }
}

#[test]
fn near_a_sideways_line_the_side_force_is_large() {
    // S_A at three quarters of the bar's f1, between 121.5 Hz and the axial line: 0.30 N/N and 4.6 mm, printed to two digits.
    let response = Response::new(&helix(&s_a(), 0.102), Ends::clamped(), 0.0).unwrap();
    let reaction = response.reaction(0.75 * 166.95, End::One, End::Two).unwrap();
    assert!(relative(reaction.side_force(), 0.30) < 0.02 && relative(1e3 * reaction.tilting_couple(), 4.6) < 0.015);
}

#[test]
fn the_first_surge_is_the_strongest_axial_line_near_that_of_a_bar() {
    // Length, first surge \[Hz\] with clamped ends: of the car's spring at 293.3 mm two modes share it, 51 % at 51.0 and 42 % at 52.0 Hz.
    for (case, length, expected) in
        [(s_t(), 0.230, 54.079), (s_a(), 0.102, 167.077), (valve(), 0.043, 388.737), (car(), 0.2933, 51.02)]
    {
        let modes = Modes::new(&helix(&case, length), Ends::clamped()).unwrap();
        assert!(relative(modes.first_surge().unwrap(), expected) < 1e-4, "{length}: {}", modes.first_surge().unwrap());
    }
    // A coil so long that dozens of sideways modes lie near is the bar.
    let slender = Rod::new(RodParameters {
        wire_diameter: 1e-3,
        coil_radius: 5e-3,
        windings: 2000.0,
        rest_span: 2.2,
        youngs_modulus: 206e9,
        shear_modulus: 81.5e9,
        density: 7850.0,
        hand: Hand::Right,
    })
    .unwrap();
    let state = Helix::new(&slender, 2.4, Turning::Held).unwrap();
    let bar = 0.5 * (state.stiffness() / slender.mass()).sqrt();
    assert!(relative(Modes::new(&state, Ends::clamped()).unwrap().first_surge().unwrap(), bar) < 2e-3);
}
