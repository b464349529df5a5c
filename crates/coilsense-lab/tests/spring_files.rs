//! Spring files that cannot be used: each gives one line naming file, line, key, value and what is allowed.

use coilsense_lab::spec::SpringSpec;
use proptest::prelude::*;

const GOOD: &str = include_str!("../data/springs/S_T.toml");

/// The good file with one line replaced.
fn with(key: &str, line: &str) -> String {
    let replace = |old: &str| {
        if old.starts_with(&format!("{key} ")) { line.to_owned() } else { old.to_owned() }
    };
    GOOD.lines().map(replace).collect::<Vec<_>>().join("\n")
}

fn refusal(text: &str) -> String {
    let message = SpringSpec::parse("S.toml", text).expect_err(text).to_string();
    assert!(!message.contains('\n'), "more than one line: {message}");
    message
}

#[test]
fn a_good_file_is_read() {
    let named = SpringSpec::parse("S.toml", GOOD).unwrap();
    assert_eq!(named.name, "S_T");
    assert_eq!(named.spring.nominal_force(), 760.0 * (0.264 - 0.104));
    let hexadecimal = with("windings", "windings = 0x34");
    assert_eq!(SpringSpec::parse("S.toml", &hexadecimal).unwrap().spring.windings(), 52.0);
    let overridden =
        with("max_length", "max_length = \"264 mm\"\nnominal_force = \"0.1 kN\"\ninductance_windings = 51.5");
    let spring = SpringSpec::parse("S.toml", &overridden).unwrap().spring;
    assert_eq!((spring.nominal_force(), spring.inductance_windings()), (100.0, 51.5));
}

#[test]
fn each_fault_is_named_with_its_place_and_value() {
    let cases = [
        ("mass", "mass = \"-65 g\"", "S.toml:10: mass = \"-65 g\": mass must be above zero and finite, got -0.065 kg"),
        ("mass", "mass = \"nan g\"", "S.toml:10: mass = \"nan g\": mass must be above zero and finite, got NaN kg"),
        ("mass", "mass = \"inf kg\"", "S.toml:10: mass = \"inf kg\": mass must be above zero and finite, got inf kg"),
        ("mass", "mass = nan", "S.toml:10: mass = nan: must be a mass with its unit (kg, g, mg, lb, oz)"),
        ("mass", "mass = 0.065", "S.toml:10: mass = 0.065: must be a mass with its unit (kg, g, mg, lb, oz)"),
        ("mass", "mass = \"65 mm\"", "S.toml:10: mass = \"65 mm\": must be a mass with its unit (kg, g, mg, lb, oz)"),
        ("mass", "mass = [1]", "S.toml:10: mass = [1]: must be a mass with its unit (kg, g, mg, lb, oz)"),
        ("mass", "", "S.toml:4: [spring] lacks the key \"mass\": a mass with its unit (kg, g, mg, lb, oz)"),
        (
            "stiffness",
            "stiffness = \"0 N/m\"",
            "S.toml:11: stiffness = \"0 N/m\": stiffness must be above zero and finite, got 0 N/m",
        ),
        ("windings", "windings = 0", "S.toml:7: windings = 0: windings must be above zero and at most 100000, got 0"),
        (
            "windings",
            "windings = 200000",
            "S.toml:7: windings = 200000: windings must be above zero and at most 100000, got 200000",
        ),
        (
            "mass",
            "mass = \"1e12 kg\"",
            "S.toml:10: mass = \"1e12 kg\": mass must be from 1e-9 to 1e9 kg, got 1000000000000 kg",
        ),
        (
            "mass",
            "mass = \"\"\"65 x\n\"\"\"",
            "S.toml:10: mass = \"\"\"65 x …: must be a mass with its unit (kg, g, mg, lb, oz)",
        ),
        ("windings", "windings = \"52\"", "S.toml:7: windings = \"52\": must be a number without a unit"),
        (
            "wire_radius",
            "wire_radius = \"8 mm\"",
            "S.toml:9: wire_radius = \"8 mm\": wire radius must be below the coil radius of 0.008 m, got 0.008 m",
        ),
        (
            "max_length",
            "max_length = \"190 mm\"",
            "S.toml:13: max_length = \"190 mm\": max length must be above the min length of 0.196 m, got 0.19 m",
        ),
        ("name", "name = \"\"", "S.toml:5: name = \"\": must be a text in quotes, on one line, of 1 to 200 characters"),
        (
            "name",
            "",
            "S.toml:4: [spring] lacks the key \"name\": a text in quotes, on one line, of 1 to 200 characters",
        ),
    ];
    for (key, line, expected) in cases {
        assert_eq!(refusal(&with(key, line)), expected);
    }
}

#[test]
fn an_unknown_key_is_named_with_the_nearest_known_one() {
    let message = refusal(&with("stiffness", "stifness = \"760 N/m\""));
    assert!(
        message.starts_with("S.toml:11: unknown key \"stifness\" in [spring]; did you mean \"stiffness\"?"),
        "{message}"
    );
    let message = refusal("[sprung]\nname = \"x\"");
    assert!(message.starts_with("S.toml:1: unknown table \"sprung\"; did you mean \"spring\"?"), "{message}");
}

#[test]
fn what_is_no_toml_or_has_no_spring_is_said() {
    assert_eq!(refusal(""), "S.toml: the table [spring] is missing");
    assert_eq!(refusal("spring = 3"), "S.toml:1: spring must be a table [spring]");
    let message = refusal(&with("mass", "mass = "));
    assert!(message.starts_with("S.toml:10: not TOML: "), "{message}");
    let message = refusal(&with("mass", "mass = \"65 g\"\nmass = \"66 g\""));
    assert!(message.starts_with("S.toml:11: not TOML: duplicate key"), "{message}");
}

#[test]
fn a_missing_file_is_named() {
    let message = SpringSpec::read(std::path::Path::new("/no/such/S_T.toml")).unwrap_err().to_string();
    assert!(message.starts_with("/no/such/S_T.toml: cannot be read: "), "{message}");
}

proptest! {
    #[test]
    fn no_text_makes_the_reader_panic(text in "(\\[spring\\]\n)?([a-z_]{1,12} ?= ?[ -~]{0,20}\n){0,12}") {
        let _ = SpringSpec::parse("S.toml", &text);
    }

    #[test]
    fn no_value_makes_the_reader_panic(key in "mass|windings|max_length|name", value in "[ -~]{0,20}") {
        let _ = SpringSpec::parse("S.toml", &with(&key, &format!("{key} = {value}")));
    }
}
