//! The JSON Schema of a spec and of an `experiment.toml`, by which editors complete keys and mark those that are unknown.
//!
//! Next door: the keys themselves and what each takes (`keys`), the schemas of what comes out (`crate::report`).

use serde_json::{Map, Value, json};

use super::keys::{Domain, EXPERIMENT_TABLES, Key, TABLES, Table};
use super::{CONDITION_KINDS, SENSOR_KINDS, SPEC_VERSION};

const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The schema of a spec. It knows every table, key and kind of value; which keys belong together, and what units are taken, the reader says.
pub fn spec_schema() -> Value {
    let (inner, outer): (Vec<&Table>, Vec<&Table>) = TABLES.into_iter().partition(|table| table.name.contains('.'));
    let mut properties: Map<String, Value> =
        outer.iter().map(|table| (table.name.to_owned(), several(table))).collect();
    for table in inner {
        if let Some((parent, key)) = table.name.split_once('.') {
            properties[parent]["properties"][key] = several(table);
        }
    }
    // One, or several between the same ends.
    let spring = properties["spring"].take();
    properties["spring"] = json!({ "oneOf": [spring, { "type": "array", "minItems": 1, "items": spring }] });
    let version = json!({ "const": SPEC_VERSION, "description": "The version of this form; may be left out." });
    properties.insert("spec_version".to_owned(), version);
    json!({
        "$schema": DIALECT,
        "title": "Spec",
        "description": "A spring, or several between the same ends, how it is mounted, what is done to it, which sensors watch it, and what they should achieve.",
        "type": "object",
        "properties": properties,
        "required": ["spring"],
        "additionalProperties": false,
    })
}

/// The schema of an `experiment.toml`.
pub fn experiment_file_schema() -> Value {
    let [root, tables @ ..] = EXPERIMENT_TABLES;
    let mut schema = one(root);
    schema["$schema"] = json!(DIALECT);
    schema["title"] = json!("Experiment");
    for table in tables {
        schema["properties"][table.name] = several(table);
    }
    schema
}

/// A table, or an array of them.
fn several(table: &Table) -> Value {
    if table.repeats { json!({ "type": "array", "items": one(table) }) } else { one(table) }
}

fn one(table: &Table) -> Value {
    let properties: Map<String, Value> =
        table.keys.iter().map(|key| (key.name.to_owned(), value(table, key))).collect();
    // A key that belongs to some kinds only is needed by these alone.
    let needed = table.keys.iter().filter(|key| key.default.is_none() && key.kinds.is_empty() && key.name == "kind");
    json!({
        "type": "object",
        "description": table.meaning,
        "properties": properties,
        "required": needed.map(|key| key.name).collect::<Vec<_>>(),
        "additionalProperties": false,
    })
}

fn value(table: &Table, key: &Key) -> Value {
    let kinds = if key.kinds.is_empty() { String::new() } else { format!(" Of {} only.", key.kinds.join(", ")) };
    let default = key.default.map_or(String::new(), |default| format!(" Default: {default}."));
    let mut schema = json!({
        "type": types(table, key),
        "description": format!("{}.{default}{kinds}", key.meaning),
    });
    if let Ok(example) = format!("x = {}", key.example).parse::<toml::Table>() {
        schema["examples"] = json!([example["x"]]);
    }
    match (table.name, key.name) {
        ("condition", "kind") => schema["enum"] = json!(CONDITION_KINDS),
        ("sensor", "kind") => schema["enum"] = json!(SENSOR_KINDS),
        _ => {}
    }
    schema
}

/// The types of TOML that the reader takes.
fn types(table: &Table, key: &Key) -> Value {
    match table.domain(key) {
        Domain::Text => json!("string"),
        Domain::List => json!("array"),
        // A range of frequencies is a list of two.
        Domain::Quantity(_) => json!(["string", "array"]),
        Domain::Number if matches!(key.example, "true" | "false") => json!("boolean"),
        Domain::Number => json!(["number", "array"]),
    }
}
