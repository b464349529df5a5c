//! The tables of materials and of sensor classes that come with the program, each value with its source.
//!
//! Next door: the files themselves (`data/materials.toml`, `data/sensors.toml`), what a spec makes of them (`spring`, `sensor`).

use std::sync::LazyLock;

use coilsense::geometry::MaterialParameters;
use serde::Deserialize;

use super::SpecError;
use super::document::Document;
use super::measurand::{KINDS, Quantity};
use super::sensor::SensorSpec;
use crate::quantity::Dimension;

/// The material of a spec that names none.
pub(super) const USUAL_MATERIAL: &str = "steel EN 10270-1";

const MATERIALS: &str = include_str!("../../../../data/materials.toml");
const SENSORS: &str = include_str!("../../../../data/sensors.toml");

#[derive(Deserialize)]
struct Materials {
    material: Vec<NamedMaterial>,
}

/// A material as its table has it: quantities with their units.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct NamedMaterial {
    name: String,
    note: Option<String>,
    shear_modulus: String,
    youngs_modulus: String,
    density: String,
    shear_modulus_temperature: Option<String>,
    expansion: Option<String>,
    resistivity: Option<String>,
    relative_permeability: Option<f64>,
    source: String,
}

#[derive(Deserialize)]
struct Classes {
    sensor: Vec<NamedClass>,
}

/// What a person wants to read of a sensor class; its values are read as those of a spec are.
#[derive(Deserialize)]
struct NamedClass {
    class: String,
    kind: String,
}

fn damaged(file: &str, message: impl std::fmt::Display) -> SpecError {
    SpecError(format!("{file} of this program is damaged: {message}"))
}

/// The table of materials, parsed once: a sweep reads a million specs.
fn all_materials() -> Result<&'static [NamedMaterial], SpecError> {
    static ALL: LazyLock<Result<Vec<NamedMaterial>, SpecError>> = LazyLock::new(|| {
        let parsed: Result<Materials, _> = toml::from_str(MATERIALS);
        parsed.map(|materials| materials.material).map_err(|error| damaged("data/materials.toml", error.message()))
    });
    ALL.as_deref().map_err(Clone::clone)
}

fn all_classes() -> Result<Vec<NamedClass>, SpecError> {
    let parsed: Result<Classes, _> = toml::from_str(SENSORS);
    parsed.map(|classes| classes.sensor).map_err(|error| damaged("data/sensors.toml", error.message()))
}

/// The values of a material; the error says which there are.
pub(super) fn material(name: &str) -> Result<MaterialParameters, String> {
    let all = all_materials().map_err(|error| error.to_string())?;
    let Some(found) = all.iter().find(|material| material.name == name) else {
        let names: Vec<&str> = all.iter().map(|material| material.name.as_str()).collect();
        return Err(format!("no material of that name; there are {}", names.join(", ")));
    };
    let quantity = |text: &str, dimension: Dimension| {
        dimension.parse(text).ok_or_else(|| damaged("data/materials.toml", format!("{name}: {text:?}")).to_string())
    };
    let optional = |text: &Option<String>, dimension| text.as_deref().map(|text| quantity(text, dimension)).transpose();
    Ok(MaterialParameters {
        shear_modulus: quantity(&found.shear_modulus, Dimension::Modulus)?,
        youngs_modulus: quantity(&found.youngs_modulus, Dimension::Modulus)?,
        density: quantity(&found.density, Dimension::Density)?,
        shear_modulus_temperature: optional(&found.shear_modulus_temperature, Dimension::PerKelvin)?,
        expansion: optional(&found.expansion, Dimension::PerKelvin)?,
        resistivity: optional(&found.resistivity, Dimension::Resistivity)?,
        relative_permeability: found.relative_permeability,
    })
}

/// The kind of a class, by its word in a spec.
pub(super) fn kind_of(name: &str) -> Option<&'static str> {
    let all = all_classes().ok()?;
    let class = all.iter().find(|class| class.class == name)?;
    KINDS.into_iter().find(|kind| *kind == class.kind)
}

/// A sensor of a class; the error says which there are of its kind.
pub(super) fn class(name: &str, quantity: Quantity, range: f64) -> Result<SensorSpec, String> {
    let text = |error: SpecError| error.to_string();
    let all = all_classes().map_err(text)?;
    let kind = quantity.kind();
    let Some(place) = all.iter().position(|class| class.class == name && class.kind == kind) else {
        let names: Vec<String> =
            all.iter().filter(|class| class.kind == kind).map(|class| format!("\"{}\"", class.class)).collect();
        return Err(format!("no class of that name for kind \"{kind}\"; there are {}", names.join(", ")));
    };
    let document = Document::catalogue("data/sensors.toml", SENSORS).map_err(text)?;
    let sections = document.sections("sensor").map_err(text)?;
    let section = sections.get(place).ok_or("data/sensors.toml of this program is damaged")?;
    SensorSpec::perfect(name, quantity, range).with_keys(section).map_err(text)
}

/// The material table, as people read it.
///
/// # Errors
/// [`SpecError`] where the program's own file is damaged.
pub fn materials() -> Result<String, SpecError> {
    let mut text = String::new();
    for material in all_materials()? {
        text.push_str(&format!("{}\n", material.name));
        let values = [
            ("shear modulus", Some(&material.shear_modulus)),
            ("Young's modulus", Some(&material.youngs_modulus)),
            ("density", Some(&material.density)),
            ("(dG/dT)/G", material.shear_modulus_temperature.as_ref()),
            ("expansion", material.expansion.as_ref()),
            ("resistivity", material.resistivity.as_ref()),
        ];
        for (quantity, value) in values {
            text.push_str(&format!("  {quantity:16} {}\n", value.map_or("not known here", String::as_str)));
        }
        if let Some(permeability) = material.relative_permeability {
            text.push_str(&format!("  {:16} {permeability}\n", "permeability"));
        }
        if let Some(note) = &material.note {
            text.push_str(&format!("  note: {note}\n"));
        }
        text.push_str(&format!("  source: {}\n\n", material.source));
    }
    Ok(text)
}

/// The sensor catalogue, as a spec may take it over.
///
/// # Errors
/// [`SpecError`] where the program's own file is damaged.
pub fn classes() -> Result<String, SpecError> {
    all_classes()?;
    Ok(SENSORS.to_owned())
}
