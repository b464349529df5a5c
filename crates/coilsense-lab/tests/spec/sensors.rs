//! Sensors, goals and budgets that cannot be: each is refused in one line that names file, line, key, value and what is allowed.

use coilsense_lab::spec::Quantity;

use super::fixtures::{BY_VALUES, check, read};

#[test]
fn a_sensor_that_cannot_be_is_refused() {
    #[rustfmt::skip]
    let faults = [
        ["[sensor]", "[[sensor]]", "[sensor]",
            "S.toml:30: sensor must be tables [[sensor]]"],
        ["no kind", "kind = \"deflection\"\n", "",
            r#"S.toml:30: [[sensor]] 1 lacks the key "kind": one of "load-cell", "deflection", "two-encoder", "inductance""#],
        ["an unknown kind", r#""deflection""#, r#""potentiometer""#,
            r#"S.toml:32: kind = "potentiometer": must be one of "load-cell", "deflection", "two-encoder", "inductance""#],
        ["an unknown key", "resolution", "resolutoin",
            r#"S.toml:33: unknown key "resolutoin" in [[sensor]] 1; did you mean "resolution"? Allowed: kind, name, class, end, range, bandwidth, order, delay, averaging, sample_rate, noise, resolution, accuracy_full_scale, accuracy_reading, calibration_uncertainty, temperature_coefficient, compliance, compliance_tolerance, backlash, calibration, calibration_form, frequency, leads"#],
        ["a key of another kind", r#"resolution = "10 um""#, "end = 1",
            r#"S.toml:33: end in [[sensor]] 1 is no key of kind "deflection"; allowed: kind, name, class, range, bandwidth, order, delay, averaging, sample_rate, noise, resolution, accuracy_full_scale, accuracy_reading, calibration_uncertainty, temperature_coefficient"#],
        ["an end 3", "kind = \"deflection\"\nresolution = \"10 um\"", "kind = \"load-cell\"\nend = 3",
            "S.toml:33: end = 3: must be a whole number from 1 to 2"],
        ["an unknown class", r#"resolution = "10 um""#, r#"class = "laser""#,
            r#"S.toml:33: class = "laser": no class of that name for kind "deflection"; there are "laser triangulation distance meter", "laser distance meter of the paper", "linear potentiometer", "LVDT", "magnetic linear encoder", "optical linear encoder""#],
        ["a class of another kind", r#"resolution = "10 um""#, r#"class = "bench LCR meter""#,
            r#"S.toml:33: class = "bench LCR meter": no class of that name for kind "deflection"; there are "laser triangulation distance meter", "laser distance meter of the paper", "linear potentiometer", "LVDT", "magnetic linear encoder", "optical linear encoder""#],
        ["a range of zero", r#"resolution = "10 um""#, r#"range = "0 mm""#,
            r#"S.toml:33: range = "0 mm": must be above zero and finite"#],
        ["a range in the wrong unit", r#"resolution = "10 um""#, r#"range = "100 N""#,
            r#"S.toml:33: range = "100 N": must be a length with its unit (m, cm, mm, um, µm, nm, in, inch, ", ft, mil)"#],
        ["a resolution in the wrong unit", r#""10 um""#, r#""10 deg""#,
            r#"S.toml:33: resolution = "10 deg": must be a length with its unit (m, cm, mm, um, µm, nm, in, inch, ", ft, mil), or a share with its unit (%, ppm)"#],
        ["a resolution beyond its range", r#""10 um""#, r#""1 m""#,
            r#"S.toml:33: resolution = "1 m": must be from zero to the range of 0.068 m"#],
        ["a resolution that is negative", r#""10 um""#, r#""-1 um""#,
            r#"S.toml:33: resolution = "-1 um": must be from zero to the range of 0.068 m"#],
        ["noise that is NaN", r#"resolution = "10 um""#, r#"noise = "nan %""#,
            r#"S.toml:33: noise = "nan %": must be from zero to the range of 0.068 m"#],
        ["a bandwidth of zero", r#"resolution = "10 um""#, r#"bandwidth = "0 Hz""#,
            r#"S.toml:33: bandwidth = "0 Hz": must be above zero and finite"#],
        ["a bandwidth that is a number", r#"resolution = "10 um""#, "bandwidth = 1000",
            "S.toml:33: bandwidth = 1000: must be a frequency with its unit (Hz, kHz, MHz, rpm)"],
        ["a bandwidth beyond all", r#"resolution = "10 um""#, r#"bandwidth = "1e9 MHz""#,
            r#"S.toml:33: bandwidth = "1e9 MHz": must be from 1e-9 to 1e9 Hz"#],
        ["an order of zero", r#"resolution = "10 um""#, "order = 0",
            "S.toml:33: order = 0: must be a whole number from 1 to 8"],
        ["an order of 2.5", r#"resolution = "10 um""#, "order = 2.5",
            "S.toml:33: order = 2.5: must be a whole number from 1 to 8"],
        ["a delay that is negative", r#"resolution = "10 um""#, r#"delay = "-1 ms""#,
            r#"S.toml:33: delay = "-1 ms": must be from 0 to 1e9 s"#],
        ["averaging over nothing", r#"resolution = "10 um""#, r#"averaging = "0 ms""#,
            r#"S.toml:33: averaging = "0 ms": must be above zero and finite"#],
        ["a sample rate that is endless", r#"resolution = "10 um""#, r#"sample_rate = "inf Hz""#,
            r#"S.toml:33: sample_rate = "inf Hz": must be above zero and finite"#],
        ["limits of error of more than all", r#"resolution = "10 um""#, r#"accuracy_reading = "101 %""#,
            r#"S.toml:33: accuracy_reading = "101 %": must be from 0 to 100 %"#],
        ["limits of error without unit", r#"resolution = "10 um""#, "accuracy_full_scale = 0.1",
            "S.toml:33: accuracy_full_scale = 0.1: must be a length with its unit (m, cm, mm, um, µm, nm, in, inch, \", ft, mil), or a share with its unit (%, ppm)"],
        ["limits of error in the wrong unit", r#"resolution = "10 um""#, r#"accuracy_full_scale = "1 N""#,
            r#"S.toml:33: accuracy_full_scale = "1 N": must be a length with its unit (m, cm, mm, um, µm, nm, in, inch, ", ft, mil), or a share with its unit (%, ppm)"#],
        ["a gain that nobody knows", r#"resolution = "10 um""#, r#"calibration_uncertainty = "200 %""#,
            r#"S.toml:33: calibration_uncertainty = "200 %": must be from 0 to 100 %"#],
        ["a temperature coefficient beyond all", r#"resolution = "10 um""#, r#"temperature_coefficient = "200 %/K""#,
            r#"S.toml:33: temperature_coefficient = "200 %/K": must be at most 100 %/K either way"#],
        ["a temperature coefficient without its kelvin", r#"resolution = "10 um""#, r#"temperature_coefficient = "1 %""#,
            r#"S.toml:33: temperature_coefficient = "1 %": must be a temperature coefficient with its unit (1/K, %/K, ppm/K)"#],
        ["a backlash that is negative", "kind = \"deflection\"\nresolution = \"10 um\"", "kind = \"two-encoder\"\nbacklash = \"-1 um\"",
            r#"S.toml:33: backlash = "-1 um": must be from 0 to 1e9 m"#],
        ["a compliance as a stiffness", "kind = \"deflection\"\nresolution = \"10 um\"", "kind = \"two-encoder\"\ncompliance = \"1 N/m\"",
            r#"S.toml:33: compliance = "1 N/m": must be a compliance with its unit (m/N, mm/N, um/N, µm/N)"#],
        ["an unknown calibration", "kind = \"deflection\"\nresolution = \"10 um\"", "kind = \"inductance\"\ncalibration = \"none\"",
            r#"S.toml:33: calibration = "none": must be one of "fitted", "two-point", "steel", "theory", or the name of a .toml file that coilsense calibrate wrote"#],
        ["a form that is off by more than all", "kind = \"deflection\"\nresolution = \"10 um\"", "kind = \"inductance\"\ncalibration_form = \"140 %\"",
            r#"S.toml:33: calibration_form = "140 %": must be from 0 to 100 %"#],
        ["two of a name", r#"resolution = "10 um""#, "resolution = \"10 um\"\n[[sensor]]\nkind = \"load-cell\"\nname = \"Laser\"",
            r#"S.toml:36: name = "Laser": "Laser" makes the same column as the sensor "laser"; give each its own name"#],
        ["two of a kind without names", "name = \"laser\"\nkind = \"deflection\"", "kind = \"deflection\"\n[[sensor]]\nkind = \"deflection\"",
            r#"S.toml:32: [[sensor]] 2 name: "deflection" makes the same column as the sensor "deflection"; give each its own name"#],
        ["the name of a signal", r#""laser""#, r#""f_i""#,
            r#"S.toml:31: name = "f_i": "f_i" makes the same column as a signal of the simulation; give it another name"#],
    ];
    check(BY_VALUES, &faults);
}

#[test]
fn a_single_winding_has_no_sensor_by_inductance_and_needs_none() {
    let single = BY_VALUES.replace("windings = 52", "windings = 1");
    read(&single).expect("a laser");
    let coil = single.replace("kind = \"deflection\"\nresolution = \"10 um\"", "kind = \"inductance\"");
    let expected = r#"S.toml:32: kind = "inductance": "laser": must be another kind: the inductance of 1 winding does not change with the length"#;
    assert_eq!(read(&coil).unwrap_err(), expected);
    let few = coil.replace("windings = 1", "windings = 2");
    assert!(read(&few).unwrap().sensors[0].range > 0.0);
}

#[test]
fn a_goal_or_a_budget_that_cannot_be_is_refused() {
    #[rustfmt::skip]
    let faults = [
        ["[[goal]]", "[goal]", "[[goal]]",
            "S.toml:35: goal must be a table [goal]"],
        ["a table in a table", "[goal]", "[goal.force]\n[goal.x]",
            r#"S.toml:36: unknown key "x" in [goal]; allowed: error, bandwidth, force"#],
        ["an array of numbers in place of sensors", "[[sensor]]\nname = \"laser\"\nkind = \"deflection\"\nresolution = \"10 um\"\n", "[sensor]\n",
            "S.toml:30: sensor must be tables [[sensor]]"],
        ["no error", "error = \"1 %\"\n", "",
            r#"S.toml:35: [goal] lacks the key "error": a force with its unit (N, kN, mN, lbf, kgf, gf), or a share with its unit (%, ppm)"#],
        ["an error of zero", "\"1 %\"\n\n[unc", "\"0 N\"\n\n[unc",
            r#"S.toml:36: error = "0 N": must be above zero and finite"#],
        ["an error that is negative", "\"1 %\"\n\n[unc", "\"-1 %\"\n\n[unc",
            r#"S.toml:36: error = "-1 %": must be above zero and finite"#],
        ["an error that is endless", "\"1 %\"\n\n[unc", "\"inf N\"\n\n[unc",
            r#"S.toml:36: error = "inf N": must be above zero and finite"#],
        ["an error as a length", "\"1 %\"\n\n[unc", "\"1 mm\"\n\n[unc",
            r#"S.toml:36: error = "1 mm": must be a force with its unit (N, kN, mN, lbf, kgf, gf), or a share with its unit (%, ppm)"#],
        ["a bandwidth that is negative", "\"1 %\"\n\n[unc", "\"1 %\"\nbandwidth = \"-1 Hz\"\n\n[unc",
            r#"S.toml:37: bandwidth = "-1 Hz": must be above zero and finite"#],
        ["a force that is no reference", "\"1 %\"\n\n[unc", "\"1 %\"\nforce = \"F_L\"\n\n[unc",
            r#"S.toml:37: force = "F_L": must be one of "F_x", "F_i", "F_o""#],
        ["a coverage of nothing", r#""95 %""#, r#""0 %""#,
            r#"S.toml:39: coverage = "0 %": must be from 50 % to 99.99 %"#],
        ["a coverage of all", r#""95 %""#, r#""100 %""#,
            r#"S.toml:39: coverage = "100 %": must be from 50 % to 99.99 %"#],
        ["a coverage as a number", r#""95 %""#, "0.95",
            "S.toml:39: coverage = 0.95: must be a share with its unit (%, ppm)"],
        ["no trials", r#"coverage = "95 %""#, "trials = 0",
            "S.toml:39: trials = 0: must be a whole number from 1000 to 10000000"],
        ["more trials than a minute takes", r#"coverage = "95 %""#, "trials = 1_000_000_000",
            "S.toml:39: trials = 1_000_000_000: must be a whole number from 1000 to 10000000"],
        ["a seed below zero", r#"coverage = "95 %""#, "seed = -1",
            "S.toml:39: seed = -1: must be a whole number from 0 to 18446744073709551615"],
        ["a seed with a comma", r#"coverage = "95 %""#, "seed = 1.5",
            "S.toml:39: seed = 1.5: must be a whole number from 0 to 18446744073709551615"],
        ["a temperature in degrees", r#"coverage = "95 %""#, r#"temperature_change = "10 °C""#,
            r#"S.toml:39: temperature_change = "10 °C": must be a temperature difference with its unit (K)"#],
        ["a temperature change that is negative", r#"coverage = "95 %""#, r#"temperature_change = "-10 K""#,
            r#"S.toml:39: temperature_change = "-10 K": must be from 0 to 1000 K"#],
        ["a temperature at which springs melt", r#"coverage = "95 %""#, r#"temperature_change = "5000 K""#,
            r#"S.toml:39: temperature_change = "5000 K": must be from 0 to 1000 K"#],
        ["an unknown key", "coverage =", "converage =",
            r#"S.toml:39: unknown key "converage" in [uncertainty]; did you mean "coverage"? Allowed: temperature_change, coverage, trials, seed"#],
    ];
    check(BY_VALUES, &faults);
}

#[test]
fn an_uncalibrated_coil_is_trusted_less_where_its_wire_may_be_magnetic() {
    let form = |material: &str, calibration: &str| {
        let sensor = format!("kind = \"inductance\"\ncalibration = \"{calibration}\"");
        let text = BY_VALUES.replace("[mount]", &format!("{material}\n[mount]"));
        let spec = read(&text.replace("kind = \"deflection\"\nresolution = \"10 um\"", &sensor)).expect(material);
        match spec.sensors[0].quantity {
            Quantity::Inductance { form, .. } => form,
            _ => panic!(),
        }
    };
    // Steel, which is assumed; drawn stainless wire; a wire of unknown making.
    for magnetic in ["", "material = \"stainless 1.4310\""] {
        assert_eq!((form(magnetic, "theory"), form(magnetic, "fitted")), (0.30, 0.013), "{magnetic}");
    }
    for name in ["CuSn6", "CuBe2", "CuZn36", "Inconel X-750", "Ti-6Al-4V"] {
        assert_eq!(form(&format!("material = {name:?}"), "theory"), 0.14, "{name}");
    }
    assert_eq!(form("relative_permeability = 1.0005", "theory"), 0.14);
    // Where it is told, what eq. (13) leaves is computed: more through two ends, more of a permeability that may be larger.
    let told = "relative_permeability = 2.5";
    let [fitted, ends] = ["fitted", "two-point"].map(|way| form(told, way));
    assert!(0.0 < fitted && fitted < 0.02 && (1.5..3.5).contains(&(ends / fitted)), "{fitted}, {ends}");
    let wider = form(&format!("{told}\nrelative_permeability_tolerance = \"40 %\""), "fitted");
    assert!(wider > 1.05 * fitted, "{wider}, {fitted}");
    assert_eq!((form(told, "theory"), form(told, "steel"), form("", "two-point")), (0.30, 0.003, 0.014));
    let sensor = "kind = \"inductance\"";
    let text = BY_VALUES.replace("[mount]", "relative_permeability = 100\n[mount]");
    let refused = read(&text.replace("kind = \"deflection\"\nresolution = \"10 um\"", sensor)).unwrap_err().to_string();
    assert!(
        refused.contains("needs calibration_form") && refused.contains("permeability must be 1 to 20"),
        "{refused}"
    );
}
