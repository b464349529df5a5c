//! One table a verb: what may be asked stands under the same names at every door, and what comes out has one form.
//!
//! With `COILSENSE_WRITE_DOCS=1` the schemas are written in place of being compared.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use coilsense_lab::mitigation::{Asked, OPTIONS, Study};
use coilsense_lab::report::{mitigation_json, mitigation_schema};
use coilsense_lab::request::IfAbsent;
use coilsense_lab::spec::Spec;
use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn text(file: &str) -> String {
    std::fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// What stands between `begin` and the next `end`.
fn between<'a>(text: &'a str, begin: &str, end: &str) -> &'a str {
    let rest = text.split_once(begin).unwrap_or_else(|| panic!("{begin:?} is not there")).1;
    rest.split_once(end).unwrap_or_else(|| panic!("{end:?} is not there")).0
}

#[test]
fn python_takes_the_options_of_the_table_with_their_defaults() {
    let stub = text("python/coilsense/_coilsense.pyi");
    let signature = between(&stub, "def mitigate(", ") ->");
    let arguments: Vec<(&str, &str)> = signature
        .split('*')
        .next_back()
        .unwrap_or_default()
        .split(',')
        .filter_map(|argument| argument.split_once(':'))
        .map(|(name, rest)| (name.trim(), rest.rsplit('=').next().unwrap_or_default().trim()))
        .filter(|(name, _)| *name != "stated")
        .collect();
    let names: Vec<&str> = arguments.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, OPTIONS.map(|row| row.name));
    for ((name, default), row) in arguments.iter().zip(&OPTIONS) {
        // Where Python leaves the default to the table, it says None.
        if *default != "None" {
            assert_eq!(default.parse().ok(), row.default_value(), "{name}");
        }
    }
}

#[test]
fn the_pages_form_has_every_option_and_no_other() {
    let form = text("web/src/mitigate/form.ts");
    let options = between(&form, "const OPTIONS: readonly Option[] = [", "\n];");
    let found: BTreeSet<&str> = options.split("name: '").skip(1).filter_map(|rest| rest.split('\'').next()).collect();
    let flags: Vec<String> = OPTIONS.iter().map(|row| row.flag()).collect();
    assert_eq!(found, flags.iter().map(String::as_str).collect());
    let choices = text("web/src/mitigate/choices.ts");
    for flag in &flags {
        assert!(choices.contains(&format!("'{flag}'")), "choices.ts: {flag}");
    }
}

#[test]
fn defaults_that_the_table_writes_can_be_read() {
    for row in &OPTIONS {
        assert_eq!(matches!(row.if_absent, IfAbsent::Value(_)), row.default_value().is_some(), "{}", row.name);
        assert!(!row.meaning.ends_with('.') && row.help().lines().count() == 1, "{}", row.name);
    }
}

/// A study that takes no second.
fn outcome() -> Value {
    let spec = text("examples/sea-ankle.toml");
    let spec = Spec::parse("spec.toml", &spec, &|name| Err(name.to_owned())).unwrap();
    let mut asked = Asked::of(|_| None).unwrap();
    asked.seeds = 1;
    let mut study = Study::of(&spec, &asked).unwrap();
    // One condition that moves u1, so that commands are shaped.
    study.conditions.retain(|(name, ..)| name == "half resonance");
    study.conditions.iter_mut().for_each(|condition| condition.2 = 0.2);
    serde_json::from_str(&mitigation_json(&study.run().unwrap()).unwrap()).unwrap()
}

#[test]
fn what_comes_out_is_what_the_schema_says() {
    let schema = mitigation_schema();
    let file = root().join("schemas/mitigation.json");
    let written = serde_json::to_string_pretty(&schema).unwrap() + "\n";
    if std::env::var_os("COILSENSE_WRITE_DOCS").is_some() {
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(&file, &written).unwrap();
    }
    let kept = std::fs::read_to_string(&file).unwrap_or_default();
    assert_eq!(kept, written, "schemas/mitigation.json: COILSENSE_WRITE_DOCS=1 writes it anew");
    let outcome = outcome();
    assert_eq!(outcome["schema"], "coilsense/mitigation/2");
    assert!(outcome["command_shaping"]["shapers"].as_array().is_some_and(|shapers| shapers.len() > 1));
    follows(&outcome, &schema, &schema, "");
    // The checker is one: a key that is not known, or not there, is found.
    let mut broken = outcome;
    broken["candidates"][0]["rms error [N]"] = Value::from(1.0);
    let found = std::panic::catch_unwind(|| follows(&broken, &schema, &schema, ""));
    assert!(found.is_err());
}

/// Objects have the keys that the schema lists, no other, and values of its types.
fn follows(value: &Value, schema: &Value, root: &Value, place: &str) {
    if let Some(reference) = schema["$ref"].as_str() {
        let name = reference.rsplit('/').next().unwrap_or_default();
        return follows(value, &root["$defs"][name], root, place);
    }
    if let Some(either) = schema["anyOf"].as_array() {
        if value.is_null() {
            return assert!(either.iter().any(|schema| schema["type"] == "null"), "{place}: null");
        }
        let other = either.iter().find(|schema| schema["type"] != "null").unwrap();
        return follows(value, other, root, place);
    }
    match value {
        Value::Object(object) => {
            let Some(properties) = schema["properties"].as_object() else { return };
            let listed: BTreeSet<&String> = properties.keys().collect();
            assert_eq!(object.keys().collect::<BTreeSet<_>>(), listed, "{place}");
            for (key, value) in object {
                follows(value, &properties[key], root, &format!("{place}/{key}"));
                let unit = ["_n", "_s", "_hz", "_rad"].iter().any(|suffix| key.ends_with(suffix));
                let is_number = properties[key]["type"].to_string().contains("number");
                assert!(!unit || is_number, "{place}/{key} has a unit and is no number");
                assert!(key.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_'), "{place}/{key}");
            }
        }
        Value::Array(values) => {
            for (index, value) in values.iter().enumerate() {
                follows(value, &schema["items"], root, &format!("{place}/{index}"));
            }
        }
        other => {
            let kind = match other {
                Value::Null => "null",
                Value::Bool(_) => "boolean",
                Value::String(_) => "string",
                _ => "number",
            };
            let types = schema["type"].to_string();
            let fits = types == "null" || types.contains(kind) || (kind == "number" && types.contains("integer"));
            assert!(fits, "{place}: {kind}, where the schema says {types}");
        }
    }
}
