//! Springs and mounts that cannot be: each is refused in one line that names file, line, key, value and what is allowed.

use super::fixtures::{BY_GEOMETRY, BY_VALUES, check, read};

#[test]
fn a_spring_by_values_that_cannot_be_is_refused() {
    #[rustfmt::skip]
    let faults = [
        ["no TOML", r#"mass = "65 g""#, r#"mass = "65 g"#,
            r#"S.toml:7: not TOML: invalid basic string, expected `"`"#],
        ["a key twice", r#"mass = "65 g""#, "mass = \"65 g\"\nmass = \"66 g\"",
            "S.toml:8: not TOML: duplicate key"],
        ["an unknown table", "[mount]", "[mounting]",
            r#"S.toml:12: unknown table "mounting"; did you mean "mount"? Allowed: spring, mount, contact, condition, cam, sensor, goal, uncertainty, rig, control, spec_version"#],
        ["an unknown key", "stiffness", "stifness",
            r#"S.toml:8: unknown key "stifness" in [spring]; did you mean "stiffness"? Allowed: name, rest_length, min_length, max_length, windings, stiffness, mass, coil_radius, wire_radius, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding, section"#],
        ["an outer diameter", "coil_radius = \"8 mm\"", "outer_diameter = \"18 mm\"",
            r#"S.toml:5: unknown key "outer_diameter" in [spring]; did you mean "coil_radius" (half the mean diameter: half of the outer one less the wire's)? Allowed: name, rest_length, min_length, max_length, windings, stiffness, mass, coil_radius, wire_radius, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding, section"#],
        ["a pitch", "coil_radius =", "pitch =",
            r#"S.toml:5: unknown key "pitch" in [spring]; did you mean "windings" (the pitch follows from rest_length and windings)? Allowed: name, rest_length, min_length, max_length, windings, stiffness, mass, coil_radius, wire_radius, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding, section"#],
        ["a letter", "stiffness", "k",
            r#"S.toml:8: unknown key "k" in [spring]; did you mean "stiffness"? Allowed: name, rest_length, min_length, max_length, windings, stiffness, mass, coil_radius, wire_radius, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding, section"#],
        ["a key like no other", "stiffness", "colour",
            r#"S.toml:8: unknown key "colour" in [spring]; allowed: name, rest_length, min_length, max_length, windings, stiffness, mass, coil_radius, wire_radius, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding, section"#],
        ["a Greek letter", "damping_ratio", "zeta",
            r#"S.toml:14: unknown key "zeta" in [mount]; did you mean "damping_ratio"? Allowed: end2, end_mass, follower_mass, ends_tilt, ends_turn, end1_tilt, end2_tilt, end1_turn, end2_turn, misalignment, damping_ratio, first_mode_damping_ratio, mass_damping, stiffness_damping"#],
        ["an unknown key of another table", "damping_ratio", "damping",
            r#"S.toml:14: unknown key "damping" in [mount]; did you mean "damping_ratio"? Allowed: end2, end_mass, follower_mass, ends_tilt, ends_turn, end1_tilt, end2_tilt, end1_turn, end2_turn, misalignment, damping_ratio, first_mode_damping_ratio, mass_damping, stiffness_damping"#],
        ["[[mount]]", "[mount]", "[[mount]]",
            "S.toml:12: mount must be a table [mount]"],
        ["no mass", "mass = \"65 g\"\n", "",
            r#"S.toml:1: [spring] lacks the key "mass": a mass with its unit (kg, g, mg, lb, oz)"#],
        ["no name", "name = \"S_T\"\n", "",
            r#"S.toml:1: [spring] lacks the key "name": a text in quotes, on one line, of 1 to 200 characters"#],
        ["no rest length", "rest_length = \"104 mm\"\n", "",
            r#"S.toml:1: [spring] lacks the key "rest_length": a length with its unit (m, cm, mm, um, µm, nm, in, inch, ", ft, mil)"#],
        ["an empty name", r#""S_T""#, r#"" ""#,
            r#"S.toml:2: name = " ": must be a text in quotes, on one line, of 1 to 200 characters"#],
        ["a name that is endless", r#""S_T""#, r#""SSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSS""#,
            r#"S.toml:2: name = "SSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSS …: must be a text in quotes, on one line, of 1 to 200 characters"#],
        ["a name of two lines", r#""S_T""#, r#""S\nT""#,
            r#"S.toml:2: name = "S\nT": must be a text in quotes, on one line, of 1 to 200 characters"#],
        ["a mass in mm", r#""65 g""#, r#""65 mm""#,
            r#"S.toml:7: mass = "65 mm": must be a mass with its unit (kg, g, mg, lb, oz)"#],
        ["a mass without unit", r#""65 g""#, "0.065",
            "S.toml:7: mass = 0.065: must be a mass with its unit (kg, g, mg, lb, oz)"],
        ["a mass without unit, as text", r#""65 g""#, r#""0.065""#,
            r#"S.toml:7: mass = "0.065": must be a mass with its unit (kg, g, mg, lb, oz)"#],
        ["a decimal comma", r#""65 g""#, r#""65,0 g""#,
            r#"S.toml:7: mass = "65,0 g": must be a mass with its unit (kg, g, mg, lb, oz); write 65.0 g with a point"#],
        ["a decimal comma in the wrong unit", r#""65 g""#, r#""65,0 mm""#,
            r#"S.toml:7: mass = "65,0 mm": must be a mass with its unit (kg, g, mg, lb, oz)"#],
        ["thousands", r#""65 g""#, r#""1,065.5 g""#,
            r#"S.toml:7: mass = "1,065.5 g": must be a mass with its unit (kg, g, mg, lb, oz)"#],
        ["windings with a unit", "= 52", r#"= "52""#,
            r#"S.toml:4: windings = "52": must be a number without a unit"#],
        ["a negative mass", r#""65 g""#, r#""-65 g""#,
            r#"S.toml:7: mass = "-65 g": mass must be above zero and finite, got -0.065 kg"#],
        ["a mass of zero", r#""65 g""#, r#""0 g""#,
            r#"S.toml:7: mass = "0 g": mass must be above zero and finite, got 0 kg"#],
        ["a mass that is NaN", r#""65 g""#, r#""nan g""#,
            r#"S.toml:7: mass = "nan g": mass must be above zero and finite, got NaN kg"#],
        ["an endless mass", r#""65 g""#, r#""inf g""#,
            r#"S.toml:7: mass = "inf g": mass must be above zero and finite, got inf kg"#],
        ["a huge mass", r#""65 g""#, r#""1e300 g""#,
            r#"S.toml:7: mass = "1e300 g": mass must be from 1e-9 to 1e9 kg, got 1e297 kg"#],
        ["no windings", "= 52", "= 0",
            "S.toml:4: windings = 0: windings must be above zero and at most 100000, got 0"],
        ["windings that are NaN", "= 52", "= nan",
            "S.toml:4: windings = nan: windings must be above zero and at most 100000, got NaN"],
        ["a million windings", "= 52", "= 1_000_000",
            "S.toml:4: windings = 1_000_000: windings must be above zero and at most 100000, got 1000000"],
        ["hardly a winding", "= 52", "= 1e-12",
            "S.toml:4: windings = 1e-12: active windings must be from 1e-9 to 1e9, got 0.000000000001"],
        ["more windings than can be simulated", "= 52\ncoil_radius = \"8 mm\"\nwire_radius = \"1 mm\"", "= 100_000\ncoil_radius = \"8 mm\"\nwire_radius = \"100 nm\"",
            r#"S.toml:22: sample_rate = "10 kHz": 100000 windings are too many to simulate over time; up to 50000 are taken"#],
        ["a wire as thick as the coil", r#""1 mm""#, r#""8 mm""#,
            r#"S.toml:6: wire_radius = "8 mm": wire radius must be below the coil radius of 0.008 m, got 0.008 m"#],
        ["a coil as large as the earth", r#""8 mm""#, r#""6e8 m""#,
            r#"S.toml:5: coil_radius = "6e8 m": coil diameter must be from 1e-9 to 1e9 m, got 1200000000 m"#],
        ["a range reversed", r#""264 mm""#, r#""190 mm""#,
            r#"S.toml:10: max_length = "190 mm": max length must be above the min length of 0.196 m, got 0.19 m"#],
        ["a range of nothing", r#""264 mm""#, r#""196 mm""#,
            r#"S.toml:10: max_length = "196 mm": max length must be above the min length of 0.196 m, got 0.196 m"#],
        ["a range below the solid length", r#""196 mm""#, r#""103.9 mm""#,
            r#"S.toml:9: min_length = "103.9 mm": must be at least the solid length of 104 mm, at which all windings touch"#],
        ["a compression spring that is pulled", r#"mass = "65 g""#, "mass = \"65 g\"\nend_type = \"open-ground\"",
            r#"S.toml:11: max_length = "264 mm": must be at most the rest_length of 104 mm: ends that are "open-ground" cannot be pulled"#],
        ["windings that do not fit between the ends", r#""104 mm""#, r#""0.5 mm""#,
            r#"S.toml:3: rest_length = "0.5 mm": rest length must be at least the solid length of 0.104 m, got 0.0005 m"#],
        ["a value that is a table", r#""65 g""#, "{ g = 65 }",
            "S.toml:7: mass = { g = 65 }: must be a mass with its unit (kg, g, mg, lb, oz)"],
        ["a wire diameter beside a mass", r#"wire_radius = "1 mm""#, r#"wire_diameter = "2 mm""#,
            "S.toml:5: coil_radius in [spring] is no key of a spring by geometry (which wire_diameter or coil_diameter makes it); allowed: name, rest_length, min_length, max_length, windings, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding"],
        ["tolerances of a wire in a spring by values", r#"mass = "65 g""#, "mass = \"65 g\"\nwire_diameter_tolerance = \"1 %\"",
            "S.toml:8: wire_diameter_tolerance in [spring] is no key of a spring by values (without wire_diameter and coil_diameter); allowed: name, rest_length, min_length, max_length, windings, stiffness, mass, coil_radius, wire_radius, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding"],
        ["an initial tension that is negative", r#"mass = "65 g""#, "mass = \"65 g\"\ninitial_tension = \"-1 N\"",
            r#"S.toml:8: initial_tension = "-1 N": must be from 0 to 1e9 N"#],
        ["an initial tension that closes the spring", r#"mass = "65 g""#, "mass = \"65 g\"\ninitial_tension = \"79.04 N\"",
            r#"S.toml:8: initial_tension = "79.04 N": must be below 79.040000 N, stiffness times rest length"#],
        ["an initial tension of a compression spring", r#"mass = "65 g""#, "mass = \"65 g\"\nend_type = \"closed\"\ninitial_tension = \"5 N\"",
            r#"S.toml:9: initial_tension = "5 N": must be zero for a compression spring"#],
        ["a compression spring below its solid length", "\"104 mm\"\nwindings", "\"103 mm\"\nend_type = \"closed\"\nwindings",
            r#"S.toml:3: rest_length = "103 mm": rest length must be at least the solid length of 0.106 m, got 0.103 m"#],
        ["an end type that is not there", r#"mass = "65 g""#, "mass = \"65 g\"\nend_type = \"hook\"",
            r#"S.toml:8: end_type = "hook": must be one of "hooks", "open", "open-ground", "closed", "closed-ground""#],
        ["a tolerance of all", r#"mass = "65 g""#, "mass = \"65 g\"\nstiffness_tolerance = \"100 %\"",
            r#"S.toml:8: stiffness_tolerance = "100 %": must be below 100 %"#],
        ["a tolerance as a number", r#"mass = "65 g""#, "mass = \"65 g\"\nstiffness_tolerance = 0.05",
            "S.toml:8: stiffness_tolerance = 0.05: must be a share with its unit (%, ppm)"],
        ["a tolerance as long as the spring", r#"mass = "65 g""#, "mass = \"65 g\"\nrest_length_tolerance = \"104 mm\"",
            r#"S.toml:8: rest_length_tolerance = "104 mm": must be below rest_length"#],
        ["an unknown self term", r#"mass = "65 g""#, "mass = \"65 g\"\nself_distance = \"printed\"",
            r#"S.toml:8: self_distance = "printed": must be one of "as-printed", "geometric-mean""#],
        ["a turn that is not there", r#"mass = "65 g""#, "mass = \"65 g\"\ninductance_windings = 0.2",
            "S.toml:8: inductance_windings = 0.2: inductance windings must be from 0.5 to 100000, got 0.2"],
        ["a nominal force of zero", r#"mass = "65 g""#, "mass = \"65 g\"\nnominal_force = \"0 N\"",
            r#"S.toml:8: nominal_force = "0 N": nominal force must be above zero and finite, got 0 N"#],
    ];
    check(BY_VALUES, &faults);
}

#[test]
fn a_spring_by_geometry_that_cannot_be_is_refused() {
    #[rustfmt::skip]
    let faults = [
        ["an outer diameter", "coil_diameter = \"16 mm\"", "outer_diameter = \"18 mm\"",
            r#"S.toml:8: unknown key "outer_diameter" in [spring]; did you mean "coil_diameter" (the mean diameter: the outer one less the wire's)? Allowed: name, rest_length, min_length, max_length, windings, stiffness, mass, coil_radius, wire_radius, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding, section"#],
        ["a letter of another kind", "windings = 52", "windings = 52\nk = \"760 N/m\"",
            r#"S.toml:7: unknown key "k" in [spring]; did you mean "stiffness", which only a spring by values has? Allowed: name, rest_length, min_length, max_length, windings, stiffness, mass, coil_radius, wire_radius, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding, section"#],
        ["a stiffness beside wire and coil", "windings = 52", "windings = 52\nstiffness = \"760 N/m\"",
            "S.toml:7: stiffness in [spring] is no key of a spring by geometry (which wire_diameter or coil_diameter makes it); allowed: name, rest_length, min_length, max_length, windings, wire_diameter, coil_diameter, total_windings, end_type, material, model, hand, stiffness_at, shear_modulus, youngs_modulus, density, shear_modulus_temperature, resistivity, relative_permeability, relative_permeability_tolerance, initial_tension, nominal_force, inductance_windings, self_distance, stiffness_tolerance, mass_tolerance, initial_tension_tolerance, rest_length_tolerance, wire_diameter_tolerance, coil_diameter_tolerance, windings_tolerance, shear_modulus_tolerance, density_tolerance, endurance_shear_strength, ultimate_shear_strength, masses_per_winding"],
        ["no coil", "coil_diameter = \"16 mm\"\n", "",
            r#"S.toml:1: [spring] lacks the key "coil_diameter": a length with its unit (m, cm, mm, um, µm, nm, in, inch, ", ft, mil)"#],
        ["a wire as thick as the coil", r#""2 mm""#, r#""16 mm""#,
            r#"S.toml:7: wire_diameter = "16 mm": wire diameter must be below the coil diameter of 0.016 m, got 0.016 m"#],
        ["a wire of nothing", r#""2 mm""#, r#""0 mm""#,
            r#"S.toml:7: wire_diameter = "0 mm": wire diameter must be above zero and finite, got 0 m"#],
        ["a wire that is NaN", r#""2 mm""#, r#""NaN mm""#,
            r#"S.toml:7: wire_diameter = "NaN mm": wire diameter must be above zero and finite, got NaN m"#],
        ["a range below the solid length", r#""196 mm""#, r#""100 mm""#,
            r#"S.toml:4: min_length = "100 mm": must be at least the solid length of 104 mm, at which all windings touch"#],
        ["a compression spring that is pulled", "\"104 mm\"\nmin_length = \"196 mm\"\nmax_length = \"264 mm\"\nwindings = 52\nwire_diameter = \"2 mm\"\ncoil_diameter = \"16 mm\"\nend_type = \"hooks\"", "\"264 mm\"\nmin_length = \"196 mm\"\nmax_length = \"264.1 mm\"\nwindings = 52\nwire_diameter = \"2 mm\"\ncoil_diameter = \"16 mm\"\nend_type = \"closed-ground\"",
            r#"S.toml:5: max_length = "264.1 mm": must be at most the rest_length of 264 mm: ends that are "closed-ground" cannot be pulled"#],
        ["an unknown material", r#""CuBe2""#, r#""cheese""#,
            r#"S.toml:10: material = "cheese": no material of that name; there are steel EN 10270-1, steel EN 10270-2, stainless 1.4310, stainless 1.4568, stainless 1.4401, CuSn6, CuBe2, CuZn36, Inconel X-750, Ti-6Al-4V (music wire is steel EN 10270-1)"#],
        ["a material by number", r#""CuBe2""#, "2",
            "S.toml:10: material = 2: must be a text in quotes, on one line, of 1 to 200 characters"],
        ["a soft modulus", "windings = 52", "windings = 52\nshear_modulus = \"0 GPa\"",
            r#"S.toml:7: shear_modulus = "0 GPa": shear modulus must be from 1e0 to 1e13 Pa, got 0 Pa"#],
        ["a density in the wrong unit", "windings = 52", "windings = 52\ndensity = \"7850 g\"",
            r#"S.toml:7: density = "7850 g": must be a density with its unit (kg/m3, kg/m³, g/cm3)"#],
        ["fewer windings in total than active", "windings = 52", "windings = 52\ntotal_windings = 50",
            "S.toml:7: total_windings = 50: total windings must be at least the 52 active ones, got 50"],
        ["a compression spring below its solid length", r#""hooks""#, r#""closed""#,
            r#"S.toml:3: rest_length = "104 mm": rest length must be at least the solid length of 0.11 m, got 0.104 m"#],
        ["an initial tension that closes the spring", "windings = 52", "windings = 52\ninitial_tension = \"50 N\"",
            r#"S.toml:7: initial_tension = "50 N": initial tension must be below 45.89843749999999 N, stiffness times rest length, got 50 N"#],
        ["tolerances that leave nothing sure", "windings = 52", "windings = 52\nwire_diameter_tolerance = \"20 %\"\ncoil_diameter_tolerance = \"25 %\"",
            r#"S.toml:7: wire_diameter_tolerance = "20 %": the tolerances leave 110 % of doubt in the stiffness; must be below 100 %"#],
        ["a spring whose stiffness is beyond all springs", "\"16 mm\"", "\"2001 m\"",
            "S.toml:1: [spring]: stiffness must be from 1e-9 to 1e9 N/m, got 0.0000000000002256229348139136 N/m"],
    ];
    check(BY_GEOMETRY, &faults);
}

#[test]
fn a_number_with_a_decimal_comma_is_told_to_have_a_point() {
    let message = read(&BY_VALUES.replace("windings = 52", "windings = 52,5   # counted")).unwrap_err();
    assert!(message.starts_with("S.toml:4: not TOML: ") && message.ends_with("; write 52.5 with a point"), "{message}");
}

#[test]
fn a_spring_whose_ends_are_not_told_may_be_used_either_way() {
    // Pushed, pulled, and through the rest length: hooks, which are assumed, say nothing against it.
    for rest in ["104 mm", "103.6 mm", "230 mm", "300 mm"] {
        read(&BY_VALUES.replace("\"104 mm\"", &format!("\"{rest}\""))).expect(rest);
    }
}

#[test]
fn a_spring_with_initial_tension_is_closed_at_its_rest_length() {
    let wound = BY_VALUES.replace("\"104 mm\"", "\"200 mm\"\ninitial_tension = \"5 N\"");
    let expected =
        r#"S.toml:10: min_length = "196 mm": must be at least the solid length of 200 mm, at which all windings touch"#;
    assert_eq!(read(&wound).unwrap_err(), expected);
}

#[test]
fn a_mount_that_cannot_be_is_refused() {
    #[rustfmt::skip]
    let faults = [
        ["an end that is not there", r#""held""#, r#""free""#,
            r#"S.toml:13: end2 = "free": must be one of "held", "force", "mass""#],
        ["an end mass without a mass's end", "damping_ratio", "end_mass = \"2 kg\"\ndamping_ratio",
            r#"S.toml:14: end_mass in [mount] is no key of an end 2 that is "held"; allowed: end2, follower_mass, ends_tilt, ends_turn, end1_tilt, end2_tilt, end1_turn, end2_turn, misalignment, damping_ratio, mass_damping, stiffness_damping"#],
        ["a mass's end without a mass", r#""held""#, r#""mass""#,
            r#"S.toml:12: [mount] lacks the key "end_mass": a mass with its unit (kg, g, mg, lb, oz)"#],
        ["a negative damping", "0.005", "-0.1",
            "S.toml:14: damping_ratio = -0.1: must be from 0 to 10"],
        ["a damping in per cent", "0.005", r#""0.5 %""#,
            r#"S.toml:14: damping_ratio = "0.5 %": must be a number without a unit, or a list of them"#],
        ["a damping that is NaN", "0.005", "nan",
            "S.toml:14: damping_ratio = nan: must be from 0 to 10"],
        ["a damping beyond all", "0.005", "11",
            "S.toml:14: damping_ratio = 11: must be from 0 to 10"],
        ["no damping in the list", "0.005", "[]",
            "S.toml:14: damping_ratio = []: must be a number without a unit, or a list of them"],
        ["a damping twice", "0.005", "[0, 0.01, -0.0]",
            "S.toml:14: damping_ratio = [0, 0.01, -0.0]: 0 is there twice; give each once"],
        ["too many dampings", "0.005", "[0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 0.1, 0.11, 0.12, 0.13, 0.14, 0.15, 0.16, 0.17, 0.18, 0.19, 0.2, 0.21, 0.22, 0.23, 0.24, 0.25, 0.26, 0.27, 0.28, 0.29, 0.3, 0.31, 0.32, 0.33, 0.34, 0.35, 0.36, 0.37, 0.38, 0.39, 0.4, 0.41, 0.42, 0.43, 0.44, 0.45, 0.46, 0.47, 0.48, 0.49, 0.5, 0.51, 0.52, 0.53, 0.54, 0.55, 0.56, 0.57, 0.58, 0.59, 0.6, 0.61, 0.62, 0.63, 0.64]",
            "S.toml:14: damping_ratio = [0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 0.1, 0.11, 0.12, 0.1 …: must be at most 64 ratios, got 65"],
        ["two kinds of damping", "0.005", "0.005\nmass_damping = \"2 1/s\"",
            r#"S.toml:15: mass_damping = "2 1/s": only one kind of damping can be given, and damping_ratio is"#],
        ["a rate as a time", "damping_ratio = 0.005", r#"mass_damping = "2 s""#,
            r#"S.toml:14: mass_damping = "2 s": must be a rate with its unit (1/s)"#],
        ["a rate beyond all", "damping_ratio = 0.005", r#"mass_damping = "1e5 1/s""#,
            r#"S.toml:14: mass_damping = "1e5 1/s": must be at most 6786.2 1/s, where the first mode's ζ is 10"#],
        ["a dashpot beyond all", "damping_ratio = 0.005", r#"stiffness_damping = "1 s""#,
            r#"S.toml:14: stiffness_damping = "1 s": must be at most 0.058943 s, where the first mode's ζ is 10"#],
    ];
    check(BY_VALUES, &faults);
}

#[test]
fn an_end_mass_that_cannot_be_is_refused() {
    #[rustfmt::skip]
    let faults = [
        ["a mass of zero", r#""2 kg""#, r#""0 kg""#,
            r#"S.toml:14: end_mass = "0 kg": must be above zero and finite"#],
        ["a huge mass", r#""2 kg""#, r#""1e12 kg""#,
            r#"S.toml:14: end_mass = "1e12 kg": must be from 1e-9 to 1e9 kg"#],
        ["a first mode's damping that is negative", r#""2 kg""#, "\"2 kg\"\nfirst_mode_damping_ratio = -1",
            "S.toml:15: first_mode_damping_ratio = -1: must be from 0 to 10"],
        ["a first mode's damping beside another kind", r#""2 kg""#, "\"2 kg\"\nfirst_mode_damping_ratio = 0.3\nmass_damping = \"2 1/s\"",
            "S.toml:15: first_mode_damping_ratio = 0.3: goes with damping_ratio only"],
    ];
    check(BY_GEOMETRY, &faults);
}
