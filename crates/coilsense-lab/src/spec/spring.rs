//! The table `[spring]`: a spring by the values of the paper's Table I.
//!
//! Next door: reading keys (`section`), what the values must be (`coilsense::Spring`).

use std::path::Path;

use coilsense::{Error, Spring, SpringParameters};

use super::section::Document;
use super::{SpecError, located};
use crate::quantity::Dimension;

/// A spring and what people call it.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedSpring {
    /// Its name.
    pub name: String,
    /// The spring.
    pub spring: Spring,
}

/// Keys of `[spring]`.
const KEYS: [&str; 11] = [
    "name",
    "rest_length",
    "windings",
    "coil_radius",
    "wire_radius",
    "mass",
    "stiffness",
    "min_length",
    "max_length",
    "nominal_force",
    "inductance_windings",
];

impl NamedSpring {
    /// Reads a spring from the text of a spec; `file` names it in errors.
    ///
    /// # Errors
    /// [`SpecError`], one line with file, line, key, value, unit and what is allowed.
    pub fn parse(file: &str, text: &str) -> Result<Self, SpecError> {
        let document = Document::parse(file, text)?;
        let section = document.section("spring", &["spring"])?;
        section.allow(&KEYS)?;
        let length = |key| section.quantity(key, Dimension::Length);
        let parameters = SpringParameters {
            rest_length: length("rest_length")?,
            windings: section.number("windings")?,
            coil_radius: length("coil_radius")?,
            wire_radius: length("wire_radius")?,
            mass: section.quantity("mass", Dimension::Mass)?,
            stiffness: section.quantity("stiffness", Dimension::Stiffness)?,
            min_length: length("min_length")?,
            max_length: length("max_length")?,
            nominal_force: section.optional_quantity("nominal_force", Dimension::Force)?,
            inductance_windings: section.optional_number("inductance_windings")?,
        };
        let name = section.text("name")?;
        let spring = Spring::new(parameters).map_err(|error| match &error {
            Error::Value { quantity, .. } => section.refuse(&quantity.replace(' ', "_"), &error),
            _ => located(file, text, 0, &error),
        })?;
        Ok(Self { name, spring })
    }

    /// Reads a spring from a file.
    ///
    /// # Errors
    /// [`SpecError`] as [`Self::parse`], or where the file cannot be read.
    pub fn read(path: &Path) -> Result<Self, SpecError> {
        let file = path.display().to_string();
        let text =
            std::fs::read_to_string(path).map_err(|error| SpecError(format!("{file}: cannot be read: {error}")))?;
        Self::parse(&file, &text)
    }
}
