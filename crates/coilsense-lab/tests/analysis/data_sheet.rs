//! The data sheet of S_T against numbers by hand and the book (theory).

use coilsense_lab::data_sheet::DataSheet;

use super::{S_T, STILL, close, spec};

fn sheet(more: &str) -> DataSheet {
    DataSheet::of(&spec(&format!("{S_T}\n{more}{STILL}"))).unwrap()
}

#[test]
fn single_numbers_of_s_t() {
    let sheet = sheet("");
    let value = |key: &str| {
        let rows = sheet.groups.iter().flat_map(|(_, rows)| rows);
        rows.into_iter().find(|row| row.key == key).unwrap_or_else(|| panic!("no {key}")).value.unwrap()
    };
    let transit = (0.065_f64 / 760.0).sqrt();
    for (key, expected, tolerance) in [
        // By hand from Table I: √(km), (l − N 2ρ)/τ, k (l_max − l0).
        ("wave_impedance_n_s_per_m", 7.0285, 1e-4),
        ("nominal_force_n", 121.6, 1e-12),
        ("transit_time_s", transit, 1e-12),
        ("clash_speed_at_min_m_per_s", 0.092 / transit, 1e-9),
        ("clash_speed_at_max_m_per_s", 0.160 / transit, 1e-9),
        ("solid_length_m", 0.104, 1e-12),
        ("gap_at_min_length_m", 0.196 / 52.0 - 0.002, 1e-9),
        // Book: theory, sections 1 and 4, to their digits: 54.065 Hz; √(2ρG) = 35.8 MPa per m/s.
        ("surge_frequency_hz", 54.065, 1e-5),
        ("impact_stress_pa_per_m_per_s", (2.0_f64 * 7850.0 * 81.5e9).sqrt(), 1e-9),
        // The mass that 52 turns of this steel have; book: theory, section 3: 64.5 g.
        ("mass_by_geometry_kg", 0.0645, 1e-3),
    ] {
        close(value(key), expected, tolerance);
    }
}

#[test]
fn the_third_of_the_mass_is_a_good_rule_for_heavy_ends_only() {
    let sheet = sheet("");
    let error = |mount: &str| {
        let of_mount = sheet.surge.iter().find(|other| other.mount.starts_with(mount));
        of_mount.unwrap_or_else(|| panic!("no {mount}")).third_rule_error_percent
    };
    // Book: theory, section 4: +0.1 % at m/M = ⅓, +10.3 % without a mass.
    assert_eq!(error("both ends held"), None);
    assert!((error("end mass three times").unwrap() - 0.1).abs() < 0.05);
    assert!((error("end 2 free").unwrap() - 10.3).abs() < 0.05);
    assert!(sheet.surge.iter().filter(|mount| mount.is_the_specs).count() == 1 && sheet.surge[0].is_the_specs);
}

#[test]
fn a_mount_with_a_mass_is_the_specs_own() {
    let sheet = sheet("[mount]\nend2 = \"mass\"\nend_mass = \"2 kg\"\n");
    let own = sheet.surge.iter().find(|mount| mount.is_the_specs).unwrap();
    // √(k/(M + m/3))/2π, of which a mass thirty times the spring's errs by 1e-5.
    close(own.chain_hz[0], (760.0_f64 / (2.0 + 0.065 / 3.0)).sqrt() / std::f64::consts::TAU, 1e-4);
}

#[test]
fn neighbours_of_s_t_lie_around_its_surge() {
    let sheet = sheet("");
    let of = |name: &str, place: &str| {
        let neighbour = sheet.neighbours.iter().find(|n| n.name == name && n.place.contains(place)).unwrap();
        neighbour.frequency_hz.unwrap()
    };
    // Book: theory, section 3: lateral 40 Hz at 230 mm, torsional 60 Hz; estimates, good to a tenth.
    assert!((of("lateral", "230.0") / 40.0 - 1.0).abs() < 0.1, "{}", of("lateral", "230.0"));
    assert!((of("torsional", "") / 60.0 - 1.0).abs() < 0.1, "{}", of("torsional", ""));
}

#[test]
fn windings_touch_at_one_length_whoever_asks() {
    let of = |text: &str| spec(&format!("{text}\n{STILL}")).spring;
    let table = |text: &str| text[text.find("[spring]").unwrap()..text.find("[mount]").unwrap()].to_owned();
    let wound = of(&table(include_str!("../../../../examples/own-geometry.toml")));
    let valve = of(&table(include_str!("../../../../examples/valve-spring.toml")));
    // Pulled shut by its initial tension at its rest length; 7.75 windings of 4 mm; 52 of 2 mm.
    for (spring, solid) in [(&wound, 0.0615), (&valve, 0.031), (&of(S_T), 0.104)] {
        close(spring.solid_length(), solid, 1e-12);
        close(spring.geometry.solid_length(), solid, 1e-12);
        let masses = spring.spring.chain_masses() as f64;
        // A gap per winding; at the solid length it is none, and windings lie a wire apart.
        let length = spring.spring.operating_range().0;
        close(spring.gap(length / masses), (length - solid) / spring.spring.windings(), 1e-9);
        close(spring.winding_pitch(solid / masses), spring.spring.wire_diameter(), 1e-12);
    }
    // The valve's spring open: 7 mm for 5.75 windings.
    close(valve.winding_pitch(0.038 / 6.0), 0.004 + 0.007 / 5.75, 1e-9);
}
