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

/// What shear adds to the compliance of a flat coil of steel, from d/R: GJ/(κGA R²) with κ = 6 (1 + ν)²/(7 + 12ν + 4ν²), 1 + ν = 206/163.
fn shear(ratio: f64) -> f64 {
    let nu = 206.0 / 163.0 - 1.0_f64;
    ratio * ratio / 8.0 * (7.0 + 12.0 * nu + 4.0 * nu * nu) / (6.0 * (1.0 + nu) * (1.0 + nu))
}

#[test]
fn the_modes_of_s_t_are_those_of_its_helix() {
    let flat = S_T.replace("[spring]", "[spring]\nstiffness_at = \"flat\"");
    let sheet = DataSheet::of(&spec(&format!("{flat}\n{STILL}"))).unwrap();
    let lengths: Vec<f64> = sheet.modes_at.iter().map(|at| at.length_m).collect();
    assert_eq!(lengths, [0.196, 0.230, 0.264]);
    // The finite elements of the reference, five digits: ends held, hooks between held and free to tilt. Their flat coil has k without its shear;
    // here it has k with it, by one factor on both moduli, of which every frequency has the root.
    let factor = (1.0 + shear(2.0 / 8.0)).sqrt();
    let expected = [
        [(42.189, "lateral"), (42.193, "lateral"), (54.005, "axial"), (60.710, "torsional")],
        [(44.112, "lateral"), (44.118, "lateral"), (54.079, "axial"), (60.796, "torsional")],
        [(45.513, "lateral"), (45.520, "lateral"), (54.151, "axial"), (60.907, "torsional")],
    ];
    for (at, expected) in sheet.modes_at.iter().zip(expected) {
        assert!(at.held.modes.len() >= 10 && at.held.ends == "ends held" && !at.held.buckles);
        for (mode, (frequency, kind)) in at.held.modes.iter().zip(expected) {
            close(mode.frequency_hz, factor * frequency, 2e-5);
            assert_eq!(mode.kind, kind);
        }
        let rising = at.held.modes.windows(2).all(|pair| pair[0].frequency_hz <= pair[1].frequency_hz);
        let loosest = at.loosest.as_ref().unwrap();
        assert!(rising && loosest.ends == "ends free to tilt");
        assert!(loosest.modes[0].frequency_hz < at.held.modes[0].frequency_hz);
    }
    close(sheet.modes_at[1].loosest.as_ref().unwrap().modes[0].frequency_hz, factor * 40.29, 2e-4);
    // Torsion in the axial force: 1.1 % of the axial line; sideways 0.07 %.
    close(sheet.modes_at[1].held.modes[3].axial_strength, 0.0109, 0.03);
    close(sheet.modes_at[1].held.modes[0].axial_strength, 0.0007, 0.1);
}

#[test]
fn ends_that_are_held_otherwise_ring_otherwise() {
    let first = |mount: &str| {
        let sheet = sheet(&format!("[mount]\n{mount}\n"));
        let middle = sheet.modes_at[1].clone();
        (middle.held.modes[0].frequency_hz, middle.loosest.map(|loosest| loosest.modes[0].frequency_hz))
    };
    let (held, tilting) = first("");
    let tilting = tilting.unwrap();
    assert_eq!(first("ends_tilt = \"held\""), (held, None));
    assert_eq!(first("ends_tilt = \"free\""), (tilting, None));
    let (one, none) = first("ends_tilt = \"held\"\nend2_tilt = \"free\"");
    assert!(none.is_none() && tilting < one && one < held);
    // Torsion with a swivel has quarter waves: the lowest mode of all.
    let (swivel, _) = first("ends_tilt = \"held\"\nend2_turn = \"free\"");
    close(swivel, 30.36, 2e-3);
    // Both ends free to turn: half waves again, and the spinning coil is no buckled one.
    let sheet = sheet("[mount]\nends_tilt = \"held\"\nends_turn = \"free\"\n");
    let middle = &sheet.modes_at[1].held;
    close(middle.first("torsional").unwrap().frequency_hz, 60.7, 5e-3);
    assert!(!middle.buckles && middle.modes[0].frequency_hz > 40.0);
}

#[test]
fn a_cell_out_of_line_reads_side_forces_too() {
    let strengths = |mount: &str| {
        let sheet = sheet(&format!("[mount]\nends_tilt = \"held\"\n{mount}\n"));
        let mode = sheet.modes_at[1].held.modes[0].clone();
        (mode.axial_strength, mode.read_strength, mode.side_force_n_per_n.unwrap())
    };
    let (axial, read, _) = strengths("");
    assert_eq!(axial, read);
    let (axial, read, side) = strengths("misalignment = \"3 deg\"");
    close(read, axial * (0.052336 * side + 0.99863), 1e-5);
}

#[test]
fn a_stretched_helix_stiffens_and_a_seated_one_does_not_buckle() {
    let value = |sheet: &DataSheet, key: &str| {
        let rows = sheet.groups.iter().flat_map(|(_, rows)| rows);
        rows.into_iter().find(|row| row.key == key).map(|row| row.value.unwrap())
    };
    let s_t = sheet("");
    // The given k is the slope at mid range; it rises by 1.0161/1.0073 from end to end, and is not F/(l - l0).
    close(value(&s_t, "stiffness_at_mid_n_per_m").unwrap(), 760.0, 1e-9);
    let (low, high) = ("stiffness_at_min_n_per_m", "stiffness_at_max_n_per_m");
    close(value(&s_t, high).unwrap() / value(&s_t, low).unwrap(), 1.0161 / 1.0073, 2e-4);
    assert!(value(&s_t, "stiffness_from_rest_n_per_m").unwrap() < 0.995 * 760.0);
    assert_eq!(value(&s_t, "buckling_length_m"), None, "a spring that is pulled");
    let car = |ends: &str| {
        let text = include_str!("../../../../examples/car-suspension.toml");
        let table = &text[text.find("[spring]").unwrap()..text.find("[mount]").unwrap()];
        DataSheet::of(&spec(&format!("{table}\n[mount]\n{ends}\n{STILL}"))).unwrap()
    };
    let (seated, pinned) = (car(""), car("ends_tilt = \"free\""));
    assert!(seated.modes_at.iter().all(|at| !at.held.buckles));
    assert!(!seated.beyond_axial.iter().any(|text| text.contains("buckles")), "{:?}", seated.beyond_axial);
    assert!(pinned.modes_at[0].held.buckles && !pinned.modes_at[1].held.buckles);
    let buckled: Vec<&String> = pinned.beyond_axial.iter().filter(|text| text.contains("buckles")).collect();
    assert!(buckled.len() == 1 && buckled[0].contains("at 153.3 mm with ends free to tilt"), "{buckled:?}");
    assert!((0.1533..0.2233).contains(&value(&pinned, "buckling_length_m").unwrap()));
}

#[test]
fn the_coil_has_the_first_surge_of_its_helix() {
    let valve = |model: &str| {
        let text = include_str!("../../../../examples/valve-spring.toml");
        let table = &text[text.find("[spring]").unwrap()..text.find("[mount]").unwrap()];
        spec(&format!("{}{STILL}", table.replace("[spring]", &format!("[spring]\n{model}"))))
    };
    let (coil, chain) = (valve(""), valve("model = \"chain\""));
    // Its helix at 43 mm, whose moduli are larger by what shear would take (`shear`); and half of the root of k/m.
    close(coil.spring.spring.surge_frequency(), 388.737 * (1.0 + shear(4.0 / 12.5)).sqrt(), 1e-4);
    close(chain.spring.spring.surge_frequency(), 403.61, 1e-4);
    assert_eq!(coil.spring.mass, chain.spring.mass);
    assert_eq!(coil.spring.spring.stiffness(), chain.spring.spring.stiffness());
    assert_eq!(chain.spring.spring.mass(), chain.spring.mass);
    let told = |spec: &coilsense_lab::spec::Spec| DataSheet::of(spec).unwrap().beyond_axial;
    let surge = |text: &String| text.starts_with("f1 of the coil as a helix");
    assert!(told(&chain).iter().any(surge) && !told(&coil).iter().any(surge), "{:?}", told(&coil));
}

#[test]
fn a_damping_for_each_mode_counts_the_masses_of_the_coil() {
    let text = include_str!("../../../../examples/car-suspension.toml");
    let table = &text[text.find("[spring]").unwrap()..text.find("[mount]").unwrap()];
    let mount =
        "[mount]\nend2 = \"mass\"\nend_mass = \"325 kg\"\nfirst_mode_damping_ratio = 0.28\ndamping_ratio = 0.005\n";
    let spec = spec(&format!("{table}\n{mount}\n{STILL}"));
    // Seven windings of five masses, and the end mass: as it was read, before anything prepares it.
    let (spring, mount) = (&spec.spring.spring, &spec.mount.cases[0].mount);
    assert_eq!(spring.chain_masses(), 35);
    coilsense::Motion::mounted(spring, mount, &spec.conditions[0].excitation).unwrap();
}

#[test]
fn windings_touch_at_one_length_whoever_asks() {
    let of = |text: &str| spec(&format!("{text}\n{STILL}")).spring;
    let table = |text: &str| text[text.find("[spring]").unwrap()..text.find("[mount]").unwrap()].to_owned();
    let wound = of(&table(include_str!("../../../../examples/own-geometry.toml")));
    let valve = of(&table(include_str!("../../../../examples/valve-spring.toml")));
    // Pulled shut by its initial tension at its rest length; 7.75 windings of 4 mm; 52 of 2 mm.
    // The valve spring by values, as a measured one: its two dead windings are told, or there are none.
    let values = "[spring]\nname = \"measured\"\nrest_length = \"57 mm\"\nmin_length = \"38 mm\"\nmax_length = \"48 mm\"\nwindings = 5.75\nstiffness = \"29.03 kN/m\"\n\
        mass = \"44.5 g\"\ncoil_radius = \"12.5 mm\"\nwire_radius = \"2 mm\"\nend_type = \"closed-ground\"\n";
    let (told, bare) = (of(&format!("{values}total_windings = 7.75\n")), of(values));
    for (spring, solid) in [(&wound, 0.0615), (&valve, 0.031), (&told, 0.031), (&bare, 0.023), (&of(S_T), 0.104)] {
        close(spring.solid_length(), solid, 1e-12);
        close(spring.geometry.solid_length(), solid, 1e-12);
        let masses = spring.spring.whole_windings() as f64;
        // A gap per winding; at the solid length it is none, and windings lie a wire apart.
        let length = spring.spring.operating_range().0;
        close(spring.gap(length / masses), (length - solid) / spring.spring.windings(), 1e-9);
        close(spring.winding_pitch(solid / masses), spring.spring.wire_diameter(), 1e-12);
    }
    // The valve's spring open: 7 mm for 5.75 windings.
    close(valve.winding_pitch(0.038 / 6.0), 0.004 + 0.007 / 5.75, 1e-9);
}
