//! The one form of all that coilsense says to machines: a head, then a verb's outcome; SI units, as the suffixes of the keys say.
//!
//! Next door: the outcome of each verb (`*/json.rs`), which command prints it (`coilsense-cli`).

use serde::Serialize;
#[cfg(feature = "reference")]
use serde_json::Value;

/// What a verb has found, as machines read it.
pub trait Outcome: Serialize {
    /// Name and number of its form; the number rises where a key changes its meaning or goes.
    const SCHEMA: &'static str;
}

/// An outcome under its head.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct Headed<T> {
    /// Name and number of this form.
    schema: &'static str,
    /// The version of coilsense that wrote it.
    version: &'static str,
    #[serde(flatten)]
    outcome: T,
}

impl<T: Outcome> Headed<T> {
    /// With its head.
    pub fn of(outcome: T) -> Self {
        Self { schema: T::SCHEMA, version: env!("CARGO_PKG_VERSION"), outcome }
    }
}

/// An outcome as JSON, its keys in the order of the schema.
///
/// # Errors
/// What `serde_json` says.
pub fn to_json<T: Outcome>(outcome: T) -> Result<String, serde_json::Error> {
    Ok(serde_json::to_string_pretty(&Headed::of(outcome))? + "\n")
}

/// Name of the file of a verb's JSON Schema without its ending, and the schema.
#[cfg(feature = "reference")]
pub(super) fn schema_of<T: Outcome + schemars::JsonSchema>() -> (&'static str, Value) {
    let mut schema = schemars::schema_for!(Headed<T>).to_value();
    let own = schemars::schema_for!(T).to_value();
    for key in ["title", "description"] {
        schema[key] = own[key].clone();
    }
    schema["properties"]["schema"]["const"] = Value::from(T::SCHEMA);
    (T::SCHEMA.split('/').nth(1).unwrap_or_default(), schema)
}
