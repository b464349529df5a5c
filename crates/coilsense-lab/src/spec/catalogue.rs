//! The tables of materials and of sensor classes that come with the program, each value with its source.
//!
//! Next door: the files themselves (`data/materials.toml`, `data/sensors.toml`), what a spec makes of them (`spring`, `sensor`).

use std::borrow::Cow;
use std::sync::LazyLock;

use coilsense::geometry::MaterialParameters;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::SpecError;
use super::measurand::KINDS;
use crate::quantity::Dimension;

/// The material of a spec that names none.
pub const USUAL_MATERIAL: &str = "steel EN 10270-1";

#[cfg(feature = "reference")]
const MATERIALS: &str = include_str!("../../data/materials.toml");
#[cfg(feature = "reference")]
pub(super) const SENSORS: &str = include_str!("../../data/sensors.toml");
// Without their notes and sources.
#[cfg(not(feature = "reference"))]
const MATERIALS: &str = include_str!(concat!(env!("OUT_DIR"), "/materials.toml"));
#[cfg(not(feature = "reference"))]
pub(super) const SENSORS: &str = include_str!(concat!(env!("OUT_DIR"), "/sensors.toml"));
/// What every row says, where its values are from at the end.
const MATERIAL_KEYS: [&str; 5] = ["name", "shear_modulus", "youngs_modulus", "density", "source"];
const SENSOR_KEYS: [&str; 3] = ["class", "kind", "source"];

/// The keys that must be there: in a build that tells no sources, all but the last.
fn kept<'k>(keys: &'k [&'k str]) -> &'k [&'k str] {
    &keys[..keys.len() - usize::from(!cfg!(feature = "reference"))]
}

/// A material or a class of sensors: its keys and their values, as the table writes them.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    values: Vec<(String, String)>,
}

impl Row {
    /// The value of a key, where the table has it.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.values.iter().find(|(known, _)| known == key).map(|(_, value)| value.as_str())
    }

    /// Keys and values in the order of their keys, without what a table says of itself: its `note`, `derived` and `source`.
    pub fn values(&self) -> impl Iterator<Item = (&str, &str)> {
        let said = |key: &str| matches!(key, "note" | "derived" | "source");
        self.values.iter().filter(move |(key, _)| !said(key)).map(|(key, value)| (key.as_str(), value.as_str()))
    }

    /// The value of a key that every row has.
    pub(super) fn needed(&self, key: &str) -> &str {
        self.get(key).unwrap_or_default()
    }
}

fn damaged(file: &str, message: impl std::fmt::Display) -> SpecError {
    SpecError(format!("{file} of this program is damaged: {message}"))
}

/// The tables `[[name]]` of a file, each of which must have the keys `needed`.
fn rows(file: &str, text: &str, name: &str, needed: &[&str]) -> Result<Vec<Row>, SpecError> {
    let document = DeTable::parse(text).map_err(|error| damaged(file, error.message()))?;
    let tables = document.get_ref().get(name).and_then(|tables| tables.get_ref().as_array());
    let row = |table: &Spanned<DeValue<'_>>| {
        let table = table.get_ref().as_table().ok_or_else(|| damaged(file, format!("{name} must be tables")))?;
        let value = |(key, value): (&Spanned<Cow<'_, str>>, &Spanned<DeValue<'_>>)| {
            let written = text.get(value.span()).unwrap_or_default();
            (key.get_ref().to_string(), value.get_ref().as_str().unwrap_or(written).to_owned())
        };
        let row = Row { values: table.iter().map(value).collect() };
        match needed.iter().find(|key| row.get(key).is_none()) {
            Some(key) => Err(damaged(file, format!("a {name} lacks {key}"))),
            None => Ok(row),
        }
    };
    tables.ok_or_else(|| damaged(file, format!("no {name}")))?.iter().map(row).collect()
}

/// The table of materials, parsed once: a sweep reads a million specs.
///
/// # Errors
/// [`SpecError`] where the program's own file is damaged.
pub fn material_rows() -> Result<&'static [Row], SpecError> {
    static ALL: LazyLock<Result<Vec<Row>, SpecError>> =
        LazyLock::new(|| rows("data/materials.toml", MATERIALS, "material", kept(&MATERIAL_KEYS)));
    ALL.as_deref().map_err(Clone::clone)
}

/// The catalogue of sensor classes.
///
/// # Errors
/// [`SpecError`] where the program's own file is damaged.
pub fn sensor_rows() -> Result<Vec<Row>, SpecError> {
    rows("data/sensors.toml", SENSORS, "sensor", kept(&SENSOR_KEYS))
}

/// The values of a material; the error says which there are.
pub(super) fn material(name: &str) -> Result<MaterialParameters, String> {
    let all = material_rows().map_err(|error| error.to_string())?;
    let Some(found) = all.iter().find(|material| material.needed("name") == name) else {
        let names: Vec<&str> = all.iter().map(|material| material.needed("name")).collect();
        let mut wrong = format!("no material of that name; there are {}", names.join(", "));
        if cfg!(feature = "reference") {
            wrong.push_str(" (music wire is steel EN 10270-1)");
        }
        return Err(wrong);
    };
    let fault = |text: &str| damaged("data/materials.toml", format!("{name}: {text:?}")).to_string();
    let quantity = |key: &str, dimension: Dimension| {
        let text = found.needed(key);
        dimension.parse(text).ok_or_else(|| fault(text))
    };
    let optional = |key: &str, dimension| found.get(key).map(|_| quantity(key, dimension)).transpose();
    let permeability = found.get("relative_permeability");
    Ok(MaterialParameters {
        shear_modulus: quantity("shear_modulus", Dimension::Modulus)?,
        youngs_modulus: quantity("youngs_modulus", Dimension::Modulus)?,
        density: quantity("density", Dimension::Density)?,
        shear_modulus_temperature: optional("shear_modulus_temperature", Dimension::PerKelvin)?,
        expansion: optional("expansion", Dimension::PerKelvin)?,
        resistivity: optional("resistivity", Dimension::Resistivity)?,
        relative_permeability: permeability.map(|text| text.parse().map_err(|_| fault(text))).transpose()?,
    })
}

/// What is known of the permeability of wire of a material whose own is not told.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PermeabilityFound {
    /// Springs of it were found between these two \[1\].
    Between(f64, f64),
    /// It is above this, where the theory of magnetic wire ends \[1\].
    Above(f64),
}

impl PermeabilityFound {
    /// Of a material of the table.
    ///
    /// # Errors
    /// What there is in its place in a damaged table.
    pub(super) fn of(name: &str) -> Result<Option<Self>, String> {
        let all = material_rows().map_err(|error| error.to_string())?;
        let row = all.iter().find(|material| material.needed("name") == name);
        let Some(text) = row.and_then(|row| row.get("permeability_found")) else { return Ok(None) };
        let number = |text: &str| text.trim().parse::<f64>().ok();
        let found = match (text.split_once(" to "), text.strip_prefix("above ")) {
            (Some((least, most)), _) => number(least).zip(number(most)).map(|(least, most)| Self::Between(least, most)),
            (None, Some(least)) => number(least).map(Self::Above),
            (None, None) => None,
        };
        found.map(Some).ok_or_else(|| damaged("data/materials.toml", format!("{name}: {text:?}")).to_string())
    }
}

/// All materials of the table with their values, in its order.
///
/// # Errors
/// [`SpecError`] where the program's own file is damaged.
pub fn named_materials() -> Result<Vec<(&'static str, MaterialParameters)>, SpecError> {
    let values = |row: &'static Row| {
        let name = row.needed("name");
        Ok((name, material(name).map_err(SpecError)?))
    };
    material_rows()?.iter().map(values).collect()
}

/// The kind of a class, by its word in a spec.
pub(super) fn kind_of(name: &str) -> Option<&'static str> {
    let all = sensor_rows().ok()?;
    let class = all.iter().find(|row| row.needed("class") == name)?;
    KINDS.into_iter().find(|kind| *kind == class.needed("kind"))
}

/// The material table, as people read it.
///
/// # Errors
/// [`SpecError`] where the program's own file is damaged.
pub fn materials() -> Result<String, SpecError> {
    let mut text = String::new();
    for material in material_rows()? {
        text.push_str(&format!("{}\n", material.needed("name")));
        let values = [
            ("shear modulus", "shear_modulus"),
            ("Young's modulus", "youngs_modulus"),
            ("density", "density"),
            ("(dG/dT)/G", "shear_modulus_temperature"),
            ("expansion", "expansion"),
            ("resistivity", "resistivity"),
        ];
        for (quantity, key) in values {
            text.push_str(&format!("  {quantity:16} {}\n", material.get(key).unwrap_or("not known here")));
        }
        if let Some(permeability) = material.get("relative_permeability") {
            text.push_str(&format!("  {:16} {permeability}\n", "permeability"));
        }
        if let Some(found) = material.get("permeability_found") {
            text.push_str(&format!(
                "  {:16} {found}, see the note; L is computed for 1 unless relative_permeability is told\n",
                "permeability"
            ));
        }
        if let Some(note) = material.get("note") {
            text.push_str(&format!("  note: {note}\n"));
        }
        text.push_str(&format!("  source: {}\n\n", material.needed("source")));
    }
    Ok(text)
}

/// The sensor catalogue, as a spec may take it over.
///
/// # Errors
/// [`SpecError`] where the program's own file is damaged.
pub fn classes() -> Result<String, SpecError> {
    sensor_rows()?;
    Ok(SENSORS.to_owned())
}
