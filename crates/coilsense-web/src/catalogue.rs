//! What a spec may name: materials of wire and classes of sensors, with their values as the tables write them.
//!
//! Next door: the tables (`coilsense_lab::spec`).

use coilsense_lab::spec::{self, Row};
use serde_json::{Map, Value, json};

use crate::json;

/// Both tables as JSON: `{ "usual": NAME, "materials": [{ "name", … }], "sensors": [{ "class", "kind", … }] }`.
///
/// # Errors
/// One line where the program's own files are damaged.
pub fn text() -> Result<String, String> {
    let materials = spec::material_rows().map_err(|error| error.to_string())?;
    let sensors = spec::sensor_rows().map_err(|error| error.to_string())?;
    let all = |rows: &[Row]| rows.iter().map(row).collect::<Vec<_>>();
    Ok(json::text(&json!({
        "usual": spec::USUAL_MATERIAL,
        "materials": all(materials),
        "sensors": all(&sensors),
    })))
}

fn row(row: &Row) -> Value {
    row.values().map(|(key, value)| (key.to_owned(), Value::from(value))).collect::<Map<_, _>>().into()
}
