//! `--json`: every command has it, and prints what its JSON Schema in `schemas/` says.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::{Value, json};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn coilsense(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
    command.args(arguments).current_dir(folder).output().expect("the command starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// What a command prints, one JSON document and nothing else.
fn printed(folder: &Path, arguments: &str) -> Value {
    let words: Vec<&str> = arguments.split(' ').chain(["--json"]).collect();
    let output = coilsense(folder, &words);
    assert!(output.status.success(), "{arguments}: {}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{arguments}: {error}"))
}

/// The schema of that name, closed: in what is printed here no key is unknown.
fn schema(name: &str) -> Value {
    let file = root().join(format!("schemas/{name}.json"));
    let text = std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let mut schema = serde_json::from_str(&text).expect("JSON");
    close(&mut schema);
    schema
}

fn close(schema: &mut Value) {
    match schema {
        Value::Object(object) => {
            object.values_mut().for_each(close);
            if object.contains_key("properties") && !object.contains_key("additionalProperties") {
                object.insert("unevaluatedProperties".to_owned(), json!(false));
            }
        }
        Value::Array(values) => values.iter_mut().for_each(close),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// Keys in snake case; where a suffix is a unit, the value is a number.
fn named_well(value: &Value, place: &str) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                // Channels and columns of a sweep are called by their own names.
                let own = place.ends_with("/forces") || place.ends_with("/means") || place.contains("/front/");
                let snake = key.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
                assert!(own || snake, "{place}/{key}");
                let unit = ["_n", "_s", "_hz", "_rad", "_m", "_h"].iter().any(|suffix| key.ends_with(suffix));
                assert!(own || !unit || !value.is_string(), "{place}/{key} has a unit and is a text");
                named_well(value, &format!("{place}/{key}"));
            }
        }
        Value::Array(values) => {
            values.iter().enumerate().for_each(|(index, value)| named_well(value, &format!("{place}/{index}")));
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

fn follows(value: &Value, name: &str, command: &str) {
    let schema = schema(name);
    let validator = jsonschema::validator_for(&schema).expect("a JSON Schema");
    let faults: Vec<String> =
        validator.iter_errors(value).map(|fault| format!("{}: {fault}", fault.instance_path())).collect();
    assert!(faults.is_empty(), "{command}: {}", faults.join("\n"));
    named_well(value, name);
    // The check is one: a key that is not known, and one that is not there, are found.
    let mut unknown = value.clone();
    unknown["of no schema"] = json!(1);
    // A data sheet's numbers are keys of their own, which only have to be numbers.
    let mut texts = value.clone();
    texts["of no schema"] = json!("text");
    assert!(!validator.is_valid(&texts) && (name == "data-sheet" || !validator.is_valid(&unknown)), "{command}");
    let mut headless = value.clone();
    headless.as_object_mut().expect("an object").remove("version");
    assert!(!validator.is_valid(&headless), "{command}");
}

/// What a TOML file holds, as a JSON value.
fn toml(text: &str) -> Value {
    serde_json::to_value(text.parse::<toml::Table>().expect("TOML")).expect("a value")
}

#[test]
fn specs_and_experiments_are_what_their_schemas_say() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let of = |name: &str| jsonschema::validator_for(&schema(name)).expect("a JSON Schema");
    let spec = of("spec");
    let examples = std::fs::read_dir(root().join("examples")).expect("examples").flatten().map(|entry| entry.path());
    let examples = examples.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let mut texts: Vec<String> = examples.map(|path| std::fs::read_to_string(path).expect("an example")).collect();
    texts.extend(
        ["init", "init --from S_T", "init --from S_A"]
            .map(|words| text(&coilsense(place.path(), &words.split(' ').collect::<Vec<_>>()).stdout)),
    );
    assert!(texts.len() > 6);
    for text in &texts {
        let value = toml(&format!("spec_version = 1\n{text}"));
        let faults: Vec<String> =
            spec.iter_errors(&value).map(|fault| format!("{}: {fault}", fault.instance_path())).collect();
        assert!(faults.is_empty(), "{}\n{text}", faults.join("\n"));
    }
    // What the reader refuses of keys and types, the schema refuses too.
    for (before, after) in [("stiffness", "stifness"), ("\"760 N/m\"", "760"), ("kind = \"impact\"", "kind = \"kick\"")]
    {
        let broken = texts[texts.len() - 2].replacen(before, after, 1);
        assert!(!spec.is_valid(&toml(&broken)), "{after}");
        std::fs::write(place.path().join("broken.toml"), &broken).expect("written");
        assert!(!coilsense(place.path(), &["spring", "broken.toml"]).status.success(), "{after}");
    }
    std::fs::write(place.path().join("late.toml"), format!("spec_version = 2\n{}", texts[0])).expect("written");
    let refusal = text(&coilsense(place.path(), &["spring", "late.toml"]).stderr);
    assert_eq!(refusal, "error: late.toml:1: spec_version = 2: must be 1, the only one that is read here\n");
    std::fs::copy(root().join("examples/virtual-rig.toml"), place.path().join("rig.toml")).expect("the example");
    assert!(coilsense(place.path(), &["rig", "rig.toml", "--out", "bench"]).status.success());
    let bench = std::fs::read_to_string(place.path().join("bench/experiment.toml")).expect("experiment.toml");
    let faults: Vec<String> = of("experiment-file").iter_errors(&toml(&bench)).map(|fault| fault.to_string()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_command_has_it() {
    let help = text(&coilsense(Path::new("."), &["help"]).stdout);
    let commands = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names: Vec<&str> = commands
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
        // What a shell and `man` read is no JSON.
        .filter(|name| !["help", "app", "completions", "man"].contains(name))
        .collect();
    assert!(names.len() > 10, "{names:?}");
    for name in names {
        let help = text(&coilsense(Path::new("."), &[name, "--help"]).stdout);
        assert!(help.contains("--json"), "{name}");
    }
}

#[test]
fn what_is_printed_is_what_the_schemas_say() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let folder = place.path();
    let example =
        |name: &str| std::fs::copy(root().join("examples").join(name), folder.join(name)).expect("the example");
    example("virtual-rig.toml");
    example("sea-ankle.toml");
    example("valve-train.toml");
    let points = "l [mm],L [uH]\n196,3.9\n210,3.6\n230,3.35\n250,3.1\n264,2.95\n";
    std::fs::write(folder.join("points.csv"), points).expect("written");
    let sweep = "sweep spec.toml --over spring.stiffness=600..900N/m --rows 64 --seed 1 --sampling";
    assert!(coilsense(folder, &["record", "mine", "--begin"]).status.success());
    let commands = [
        ("record", "record mine"),
        ("init", "init --from S_T"),
        ("init", "init --from S_T --out spec.toml"),
        ("data-sheet", "spring spec.toml"),
        ("simulation", "simulate spec.toml --out run.csv"),
        ("rig", "rig virtual-rig.toml --out bench"),
        ("experiment", "experiment bench"),
        ("import", "import bench/hit-1-fast.csv --out again.csv"),
        ("identification", "identify bench/hit-1-fast.csv"),
        ("calibration", "calibrate points.csv --column u2=l --length-at-zero 1mm"),
        ("analysis", "analyze spec.toml"),
        ("analysis", "analyze sea-ankle.toml"),
        ("mitigation", "mitigate spec.toml --seeds 1"),
        ("export", "export virtual-rig.toml --as c --out plant.h"),
        ("export", "export virtual-rig.toml --as state-space --error 1% --bandwidth 100Hz --step 1ms --out plant.json"),
        ("export", "export virtual-rig.toml --as fmu --out plant.fmu"),
        ("speed", "speed valve-train.toml --from 900rpm --to 1000rpm --step 100rpm"),
        ("placement", "placement sea-ankle.toml"),
        ("sweep-summary", &format!("{sweep} sobol --out designs")),
        ("pareto", "pareto designs --minimize F_o.rmsd --maximize stiffness"),
        ("sweep-summary", &format!("{sweep} saltelli --out salt")),
        ("sensitivity", "sensitivity salt"),
        ("reproduction", "reproduce --protocol text --out paper"),
    ];
    for (schema, command) in commands {
        follows(&printed(folder, command), schema, command);
    }
    let matrices = std::fs::read_to_string(folder.join("plant.json")).expect("plant.json");
    follows(&serde_json::from_str(&matrices).expect("JSON"), "state-space", "plant.json");
    // What a file holds is what is printed.
    let kept = std::fs::read_to_string(folder.join("out/analysis/results.json")).expect("results.json");
    let date = text(kept.lines().find(|line| line.contains("\"date\"")).expect("its date").as_bytes());
    assert!(date.contains("\"20"), "{date}");
}
