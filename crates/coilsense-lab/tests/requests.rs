//! One table a verb: what may be asked stands under the same names at every door, and what comes out has one form.
//!
//! With `COILSENSE_WRITE_DOCS=1` the schemas are written in place of being compared.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use coilsense_lab::mitigation::OPTIONS;
use coilsense_lab::report::schemas;
use coilsense_lab::request::IfAbsent;
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

#[test]
fn the_schemas_in_the_repository_are_those_of_the_code() {
    let folder = root().join("schemas");
    let written = schemas();
    if std::env::var_os("COILSENSE_WRITE_DOCS").is_some() {
        std::fs::create_dir_all(&folder).unwrap();
        for (name, schema) in &written {
            std::fs::write(folder.join(format!("{name}.json")), pretty(schema)).unwrap();
        }
    }
    for (name, schema) in &written {
        let kept = std::fs::read_to_string(folder.join(format!("{name}.json"))).unwrap_or_default();
        assert!(kept == pretty(schema), "schemas/{name}.json: COILSENSE_WRITE_DOCS=1 writes it anew");
    }
    let files = std::fs::read_dir(&folder).unwrap().count();
    assert_eq!(files, written.len(), "schemas/ holds a file that the code does not know");
}

fn pretty(schema: &Value) -> String {
    serde_json::to_string_pretty(schema).unwrap() + "\n"
}
