//! Against straight beam elements of another formulation, extrapolated (`reference/helix_elements.py`): an energy of nodes and their
//! rotations, its stretched state and its Hessian found in the discrete model. It shares no linearisation with the rod.

use std::collections::BTreeMap;

use coilsense::helix::{Ends, Helix, Modes, Turning};

use crate::cases::{car, helix, knee, relative, s_a, s_t, standard, valve};

/// Rows of a golden file by column name without its unit. A missing file fails.
fn golden(name: &str) -> Vec<BTreeMap<String, String>> {
    let path = format!("{}/tests/golden/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(&path).expect(&path);
    let bare = |header: &str| header.split(" [").next().unwrap_or_default().to_owned();
    let headers: Vec<String> = reader.headers().expect(&path).iter().map(bare).collect();
    let rows: Vec<BTreeMap<String, String>> = reader
        .records()
        .map(|record| headers.iter().cloned().zip(record.expect(&path).iter().map(str::to_owned)).collect())
        .collect();
    assert!(!rows.is_empty(), "{path} is empty");
    rows
}

fn number(row: &BTreeMap<String, String>, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {}", row[column]))
}

fn case(name: &str) -> Helix {
    match name {
        "S_T 196 mm" => helix(&s_t(), 0.196),
        "S_T 230 mm" => helix(&s_t(), 0.230),
        "S_T 264 mm" => helix(&s_t(), 0.264),
        "S_A 102 mm" => helix(&s_a(), 0.102),
        "valve 43 mm" => helix(&valve(), 0.043),
        "car 223.3 mm" => helix(&car(), 0.2233),
        "knee 105 mm" => helix(&knee(), 0.105),
        "test" => Helix::new(&standard(), standard().parameters().rest_span, Turning::Held).unwrap(),
        other => panic!("unknown case {other}"),
    }
}

#[test]
fn the_wires_are_those_of_the_elements() {
    let rows = golden("helix_modes_cases");
    for row in &rows {
        let helix = case(&row["case"]);
        let p = helix.rod().parameters();
        for (ours, column) in [
            (p.wire_diameter, "d"),
            (p.coil_radius, "R_0"),
            (p.windings, "N"),
            (p.rest_span, "l_0"),
            (helix.span(), "l"),
            (p.youngs_modulus, "E"),
            (p.shear_modulus, "G"),
            (p.density, "density"),
        ] {
            // Roundings of a few products.
            assert!(relative(ours, number(row, column)) < 2e-15, "{} {column}: {ours:e}", row["case"]);
        }
    }
    assert_eq!(rows.len(), 8);
}

/// What the rod has for a row of the table.
fn of_rod(row: &BTreeMap<String, String>, helix: &Helix) -> f64 {
    let modes = || Modes::new(helix, Ends::clamped()).unwrap();
    match row["quantity"].as_str() {
        "force [N]" => helix.force(),
        "couple [N m]" => helix.couple(),
        "frequency [Hz]" => modes().frequencies(12).unwrap()[number(row, "mode") as usize - 1],
        other => panic!("unknown quantity {other}"),
    }
}

#[test]
fn frequencies_and_static_state_are_those_of_the_elements() {
    let rows = golden("helix_modes").into_iter().filter(|row| row["quantity"] != "modes below [Hz]");
    let (mut worst, mut compared): (f64, usize) = (0.0, 0);
    for row in rows {
        let (value, estimate) = (number(&row, "value"), number(&row, "error estimate"));
        let ours = of_rod(&row, &case(&row["case"]));
        // The elements' own error estimate: 6.4e-9 to 7.0e-9 of forces and couples, 5.4e-10 to 1.2e-7 of frequencies. Measured 1.1e-10 and
        // 2.1e-9, a tenth of it or less: what the extrapolation has left.
        let what = format!("{} {} {}: {ours} {value}", row["case"], row["quantity"], row["mode"]);
        assert!((ours - value).abs() < estimate, "{what}, {:e}", relative(ours, value));
        assert!(estimate < 1.3e-7 * value.abs(), "{what}, estimated {estimate:e}");
        worst = worst.max(relative(ours, value));
        compared += 1;
    }
    println!("{compared} figures, worst {worst:e}");
    // Twelve frequencies of eight cases; force and couple of those under load.
    assert_eq!(compared, 8 * 12 + 7 * 2);
}

#[test]
fn as_many_modes_lie_below_a_frequency_as_elements_have() {
    let rows: Vec<_> = golden("helix_modes").into_iter().filter(|row| row["quantity"] == "modes below [Hz]").collect();
    for row in &rows {
        let modes = Modes::new(&case(&row["case"]), Ends::clamped()).unwrap();
        assert_eq!(modes.count_below(number(row, "value")).unwrap(), number(row, "mode") as usize, "{row:?}");
    }
    assert_eq!(rows.len(), 6);
}
