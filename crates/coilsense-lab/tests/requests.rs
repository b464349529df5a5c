//! One table a verb: what may be asked stands under the same names at every door, and what comes out has one form.
//!
//! With `COILSENSE_WRITE_DOCS=1` the schemas and the page of options are written in place of being compared.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use coilsense_lab::mitigation::OPTIONS;
use coilsense_lab::recording::request::{CLEANING, LAYOUT, SECOND, WINDOW};
use coilsense_lab::report::verbs::{self, VERBS};
use coilsense_lab::report::{options_markdown, schemas};
use coilsense_lab::request::{Door, Given, IfAbsent, Row, Takes, Value as Taken};
use coilsense_lab::{calibration, identification};
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

/// A Python function of the stub: its arguments and their defaults.
fn signature(function: &str) -> Vec<(String, String)> {
    let stub = text("python/coilsense/_coilsense.pyi");
    let arguments = between(&stub, &format!("def {function}("), ") ->").replace('\n', " ");
    // A comma between brackets parts no arguments.
    let mut depth = 0;
    let mut each = vec![String::new()];
    for sign in arguments.chars() {
        depth += i32::from(sign == '[') - i32::from(sign == ']');
        match sign {
            ',' if depth == 0 => each.push(String::new()),
            _ => each.last_mut().unwrap().push(sign),
        }
    }
    let parts = each.iter().filter_map(|argument| argument.split_once(':'));
    parts
        .map(|(name, rest)| {
            let default = rest.rsplit_once('=').map_or("", |(_, default)| default.trim());
            (name.trim().to_owned(), default.to_owned())
        })
        .filter(|(name, _)| name != "self")
        .collect()
}

/// Python's function of a verb, the tables that it takes, and arguments that are no options: what is worked on, and what only Python has.
fn python() -> Vec<(&'static str, Vec<Row>, &'static [&'static str])> {
    let log = || [&LAYOUT[..], &CLEANING, &WINDOW, &SECOND].concat();
    let of_verb = |name: &str| VERBS.iter().find(|verb| verb.name == name).unwrap().rows().copied().collect();
    vec![
        ("open_log", log(), &[]),
        ("experiment", of_verb("experiment"), &[]),
        ("identify", identification::request::OPTIONS.to_vec(), &["record"]),
        // Logs of other layouts come as recordings.
        ("calibrate", calibration::request::OPTIONS.to_vec(), &["points", "preset", "columns", "units"]),
        ("mitigate", of_verb("mitigate"), &[]),
        ("placement", of_verb("placement"), &[]),
        ("plant", of_verb("export"), &[]),
        ("pareto", of_verb("pareto"), &[]),
        ("sensitivity", of_verb("sensitivity"), &[]),
        ("rig", of_verb("rig"), &[]),
    ]
}

#[test]
fn python_takes_the_options_of_the_tables_and_no_other() {
    for (function, rows, more) in python() {
        let arguments = signature(function);
        let takes = |name: &str| arguments.iter().any(|(argument, _)| argument == name);
        for row in &rows {
            match row.elsewhere(Door::Python) {
                None => assert!(takes(row.name), "{function}: no {}", row.name),
                // An argument of that name may be what is worked on.
                Some(_) => {
                    let is_free = !takes(row.name) || more.contains(&row.name);
                    assert!(is_free, "{function}: {} is said to be elsewhere", row.name);
                }
            }
        }
        for (name, _) in &arguments {
            let known = rows.iter().any(|row| match row.elsewhere(Door::Python) {
                None => row.name == name,
                Some(what) => what == name,
            });
            assert!(known || more.contains(&name.as_str()), "{function}: {name} is in no table");
        }
    }
}

#[test]
fn what_holds_without_an_option_is_the_same_in_python() {
    for (function, rows, _) in python() {
        for (name, default) in signature(function) {
            let here = |row: &&Row| row.name == name && row.elsewhere(Door::Python).is_none();
            let Some(row) = rows.iter().find(here) else { continue };
            let default_value = row.default_value();
            match default.as_str() {
                // Python leaves it to the table, or to who reads the spec.
                "None" | "..." => (),
                // Where files go is always said in Python.
                "" => assert!(row.if_absent == IfAbsent::Refused || name == "out", "{function}: {name}"),
                "False" => assert!(matches!(row.takes, Takes::Flag), "{function}: {name}"),
                number => {
                    let value: f64 = number.parse().unwrap_or_else(|_| panic!("{function}: {name}={number}"));
                    let same = match default_value {
                        Some(Taken::Number(default)) => default == value,
                        Some(Taken::Count(default)) => default as f64 == value,
                        _ => false,
                    };
                    assert!(same, "{function}: {name}={number}");
                }
            }
        }
    }
}

/// Names of the options in a text of the page.
fn names(text: &str) -> BTreeSet<String> {
    text.split("name: '").skip(1).filter_map(|rest| rest.split('\'').next()).map(str::to_owned).collect()
}

/// What the page calls the options of tables.
fn on_the_page<'a>(rows: impl IntoIterator<Item = &'a Row>) -> BTreeSet<String> {
    let here = rows.into_iter().filter(|row| row.elsewhere(Door::Page).is_none());
    here.map(Row::flag).collect()
}

#[test]
fn the_pages_forms_have_every_option_and_no_other() {
    let form = text("web/src/mitigate/form.ts");
    let found = names(between(&form, "const OPTIONS: readonly Option[] = [", "\n];"));
    assert_eq!(found, on_the_page(&OPTIONS));
    let choices = text("web/src/mitigate/choices.ts");
    for flag in &found {
        assert!(choices.contains(&format!("'{flag}'")), "choices.ts: {flag}");
    }
    let tables =
        [&LAYOUT[..], &CLEANING, &WINDOW, &SECOND, &identification::request::OPTIONS, &calibration::request::OPTIONS];
    let mut expected = on_the_page(tables.concat().iter());
    // The known layout and the spring of the page's own tab are choices there.
    expected.extend(["layout".to_owned(), "spring".to_owned()]);
    assert_eq!(names(&text("web/src/log/options.ts")), expected);
}

#[test]
fn the_words_that_the_page_offers_are_those_of_the_tables() {
    let form = text("web/src/log/options.ts");
    let tables = [&LAYOUT[..], &identification::request::OPTIONS, &calibration::request::OPTIONS].concat();
    for row in tables.iter().filter(|row| row.elsewhere(Door::Page).is_none()) {
        let Takes::Word(words) = row.takes else { continue };
        let option = between(&form, &format!("name: '{}'", row.flag()), "\n        ],");
        for word in words {
            assert!(option.contains(&format!("['{word}', ")), "{}: {word}", row.name);
        }
        // One more is for nothing said.
        assert_eq!(option.matches("          [").count(), words.len() + 1, "{}", row.name);
    }
}

#[test]
fn what_holds_without_an_option_is_what_the_page_shows_in_its_field() {
    let form = text("web/src/log/options.ts");
    let tables = [&SECOND[..], &identification::request::OPTIONS].concat();
    for row in tables.iter().filter(|row| row.elsewhere(Door::Page).is_none()) {
        let IfAbsent::Value(default) = row.if_absent else { continue };
        let option = between(&form, &format!("name: '{}'", row.flag()), "}");
        assert!(option.contains(&format!("example: '{default}'")), "{}: {default}", row.name);
    }
}

#[test]
fn rows_can_be_read_and_name_options_of_their_verb() {
    for verb in &VERBS {
        let mut names = BTreeSet::new();
        for row in verb.rows() {
            let name = format!("{} {}", verb.name, row.name);
            assert!(names.insert(row.name), "{name} is there twice");
            assert_eq!(matches!(row.if_absent, IfAbsent::Value(_)), row.default_value().is_some(), "{name}");
            assert!(
                !row.meaning.is_empty() && !row.meaning.ends_with('.') && row.help().lines().count() == 1,
                "{name}"
            );
            for other in row.conflicts.iter().chain(row.requires) {
                assert!(verb.rows().any(|row| row.name == *other), "{name}: there is no {other}");
            }
        }
    }
    assert_eq!(calibration::request::METHOD.default_value(), None);
    let usual = coilsense::identify::Settings::default();
    assert_eq!(identification::request::settings(&Given::default(), None), Ok(usual));
    let resampling = coilsense_lab::sensitivity::Resampling::default();
    assert_eq!(Given::default().count(&verbs::RESAMPLES), Some(resampling.resamples as u64));
    assert_eq!(Given::default().count(&verbs::DRAWS_SEED), Some(resampling.seed));
}

#[test]
fn numbers_in_si_units_meet_the_bounds_of_the_tables() {
    use coilsense_lab::recording::request::{FILL_GAPS, FROM, RESAMPLE, SAMPLE_RATE};
    for (row, value, reason) in [
        (&SAMPLE_RATE, -1.0, "must be from 1e-9 to 1e9 Hz, got -1 Hz"),
        (&RESAMPLE, f64::INFINITY, "must be finite, got inf Hz"),
        (&FILL_GAPS, 0.0, "must be above zero, got 0 s"),
        (&FROM, f64::NAN, "must be finite, got NaN s"),
        (&identification::request::WINDINGS, 0.5, "must be from 1 to 1000000, got 0.5"),
        (&identification::request::TOLERANCE, 0.0, "must be above 0 and below 1, got 0"),
        (&identification::request::ACCURACY_FORCE, 1.0, "must be from 0 to below 1, got 1"),
        (&calibration::request::STIFFNESS, -760.0, "must be above zero, got -760 N/m"),
    ] {
        assert_eq!(row.checked(value).unwrap_err().reason, reason, "{}", row.name);
    }
}

#[test]
fn the_reference_in_the_book_is_made_of_the_tables() {
    let file = root().join("book/src/reference/options.md");
    let page = options_markdown();
    if std::env::var_os("COILSENSE_WRITE_DOCS").is_some() {
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(&file, &page).unwrap();
    }
    let kept = std::fs::read_to_string(&file).unwrap_or_default();
    assert!(kept == page, "book/src/reference/options.md: COILSENSE_WRITE_DOCS=1 writes it anew");
    assert!(text("book/src/SUMMARY.md").contains("reference/options.md"));
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
