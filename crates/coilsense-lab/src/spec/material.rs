//! What a spring's wire is made of: a named material, with a spec's own values in place of the table's.
//!
//! Next door: the table of materials (`catalogue`), the rest of a spring (`spring`).

use coilsense::geometry::{Material, MaterialParameters};

use super::catalogue::PermeabilityFound;
use super::section::Section;
use super::{SpecError, catalogue};
use crate::quantity::Dimension;

/// What a wire is made of.
pub(super) struct Wire {
    /// What to call it.
    pub label: String,
    /// Its values.
    pub material: Material,
    /// What is known of the permeability of such wire, where the spec names it and does not tell its own.
    pub permeability_found: Option<PermeabilityFound>,
}

/// The named material with what the table says in place of its values; and what to call it.
pub(super) fn material(section: &Section<'_>) -> Result<Wire, SpecError> {
    let name = section.optional_text("material")?.unwrap_or_else(|| catalogue::USUAL_MATERIAL.to_owned());
    let name_in_table = name.clone();
    let named = catalogue::material(&name).map_err(|message| section.refuse("material", message))?;
    let keys = [
        "shear_modulus",
        "youngs_modulus",
        "density",
        "shear_modulus_temperature",
        "resistivity",
        "relative_permeability",
    ];
    let own: Vec<&str> = keys.into_iter().filter(|key| section.has(key)).collect();
    let quantity = |key, dimension| section.optional_quantity(key, dimension);
    let parameters = MaterialParameters {
        shear_modulus: quantity("shear_modulus", Dimension::Modulus)?.unwrap_or(named.shear_modulus),
        youngs_modulus: quantity("youngs_modulus", Dimension::Modulus)?.unwrap_or(named.youngs_modulus),
        density: quantity("density", Dimension::Density)?.unwrap_or(named.density),
        shear_modulus_temperature: quantity("shear_modulus_temperature", Dimension::PerKelvin)?
            .or(named.shear_modulus_temperature),
        resistivity: quantity("resistivity", Dimension::Resistivity)?.or(named.resistivity),
        relative_permeability: section.optional_number("relative_permeability")?.or(named.relative_permeability),
        ..named
    };
    let material = Material::new(parameters).map_err(|error| section.refuse_science(&error, &[]))?;
    let label =
        if own.is_empty() { name } else { format!("{name}, with its own {}", own.join(", ").replace('_', " ")) };
    let is_untold = cfg!(feature = "steel") && section.has("material") && material.relative_permeability().is_none();
    let permeability_found = match is_untold {
        true => PermeabilityFound::of(&name_in_table).map_err(|message| section.refuse("material", message))?,
        false => None,
    };
    Ok(Wire { label, material, permeability_found })
}
