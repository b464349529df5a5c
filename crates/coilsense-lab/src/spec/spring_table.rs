//! Reading the table `[spring]`: a spring by the values of the paper's Table I, by wire, coil and material, or by sections.
//!
//! Next door: what it is read into (`spring`), reading keys (`section`), the material table (`catalogue`), what the values must be
//! (`coilsense::{Spring, geometry}`).

use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material};
use coilsense::helix::{Hand, StiffnessAt};
use coilsense::inductance::SelfDistance;
use coilsense::{Spring, SpringParameters};

use super::keys::springs;
use super::material::{Wire, material};
use super::section::Section;
use super::sections::{DeadEnds, Use};
use super::spring::{Model, ROUNDING, SpringSpec};
use super::tolerance::Tolerances;
use super::{SpecError, plain};
use crate::quantity::Dimension;

/// Most masses for a winding that a spec may ask for.
const MOST_MASSES_PER_WINDING: u64 = 64;
/// Words for how the wire ends.
const ENDS: [(&str, EndType); 5] = [
    ("hooks", EndType::Hooks),
    ("open", EndType::Open),
    ("open-ground", EndType::OpenGround),
    ("closed", EndType::Closed),
    ("closed-ground", EndType::ClosedGround),
];

/// Parameters of the science and the keys that set them, where these are called otherwise: of a spring by geometry.
const DIAMETERS: [(&str, &str); 3] =
    [("active_windings", "windings"), ("coil_radius", "coil_diameter"), ("wire_radius", "wire_diameter")];

/// The same of a spring by values.
const RADII: [(&str, &str); 3] =
    [("active_windings", "windings"), ("coil_diameter", "coil_radius"), ("wire_diameter", "wire_radius")];

impl SpringSpec {
    /// Reads the table `[spring]`.
    pub(super) fn of(section: &Section<'_>) -> Result<Self, SpecError> {
        let kind = springs::way(|key| section.has(key));
        let whose = match kind {
            springs::BY_GEOMETRY => "a spring by geometry (which wire_diameter or coil_diameter makes it)",
            springs::BY_SECTIONS => "a spring by sections (which [[spring.section]] makes it)",
            _ => "a spring by values (without wire_diameter and coil_diameter)",
        };
        section.only_of(kind, whose)?;
        let by_geometry = kind == springs::BY_GEOMETRY;
        let Wire { label, material, permeability_found } = material(section)?;
        let initial_tension = section.not_negative("initial_tension", Dimension::Force)?.unwrap_or(0.0);
        let Described { spring, geometry, closed_length, dead_ends } =
            Described::of(section, kind, material, initial_tension)?;
        let masses = section.optional_whole("masses_per_winding", 1, MOST_MASSES_PER_WINDING)?;
        let masses_per_winding = masses.map(|masses| masses as usize);
        let spec = Self {
            name: section.text("name")?,
            geometry,
            material: label,
            material_is_given: section.has("material") || section.has("shear_modulus"),
            found_of_wire: permeability_found,
            by_geometry,
            closed_length,
            initial_tension,
            self_distance: self_distance(section)?,
            tolerances: Tolerances::parse(section, by_geometry, closed_length)?,
            masses_per_winding,
            stiffness_at: stiffness_at(section, by_geometry)?,
            model: model(section, dead_ends.is_some())?,
            dead_ends,
            mass: spring.mass(),
            first_frequencies: None,
            hand: hand(section)?,
            spring: spring
                .with_masses_per_winding(masses_per_winding.unwrap_or(1))
                .map_err(|error| section.refuse_science(&error, &[]))?,
        };
        spec.check_range(section)?;
        Ok(spec)
    }

    /// The spring can be used over the range: windings have room, and ends that only push are not pulled.
    fn check_range(&self, section: &Section<'_>) -> Result<(), SpecError> {
        let (shortest, longest) = self.spring.operating_range();
        let (solid, rest) = (self.solid_length(), self.closed_length);
        let touching = format!("at least the solid length of {}, at which all windings touch", millimetres(solid));
        section.check("min_length", shortest >= solid * (1.0 - ROUNDING), shortest, &touching)?;
        let end_type = self.geometry.parameters().end_type;
        let reaches = end_type.is_extension() || longest <= rest * (1.0 + ROUNDING);
        let word = ENDS.iter().find(|(_, known)| *known == end_type).map_or("", |(word, _)| word);
        let pulled =
            format!("at most the rest_length of {}: ends that are \"{word}\" cannot be pulled", millimetres(rest));
        section.check("max_length", reaches, longest, &pulled).map(|_| ())
    }
}

/// A spring as one of the ways to describe it has it.
struct Described {
    spring: Spring,
    geometry: Geometry,
    /// Length without force as the spec gives it \[m\].
    closed_length: f64,
    dead_ends: Option<DeadEnds>,
}

impl Described {
    fn of(section: &Section<'_>, kind: &str, material: Material, initial_tension: f64) -> Result<Self, SpecError> {
        if kind == springs::BY_SECTIONS {
            let (end_type, parameters) = (end_type(section)?, in_use(section)?);
            let (spring, geometry, dead) = DeadEnds::parse(Use { section, material, end_type, parameters })?;
            return Ok(Self { closed_length: spring.rest_length(), spring, geometry, dead_ends: Some(dead) });
        }
        let closed_length = section.quantity("rest_length", Dimension::Length)?;
        let (spring, geometry) = match kind {
            springs::BY_GEOMETRY => Self::wound(section, material, closed_length, initial_tension)?,
            _ => Self::valued(section, material, closed_length, initial_tension)?,
        };
        Ok(Self { spring, geometry, closed_length, dead_ends: None })
    }

    /// By wire, coil and material.
    fn wound(
        section: &Section<'_>,
        material: Material,
        rest_length: f64,
        initial_tension: f64,
    ) -> Result<(Spring, Geometry), SpecError> {
        let parameters = GeometryParameters {
            wire_diameter: section.quantity("wire_diameter", Dimension::Length)?,
            coil_diameter: section.quantity("coil_diameter", Dimension::Length)?,
            active_windings: section.number("windings")?,
            total_windings: section.optional_number("total_windings")?,
            end_type: end_type(section)?,
            material,
            rest_length,
            initial_tension,
        };
        let geometry = Geometry::new(parameters).map_err(|error| section.refuse_science(&error, &DIAMETERS))?;
        let spring = SpringParameters {
            rest_length: geometry.effective_rest_length(),
            windings: parameters.active_windings,
            coil_radius: 0.5 * parameters.coil_diameter,
            wire_radius: 0.5 * parameters.wire_diameter,
            mass: geometry.active_mass(),
            stiffness: geometry.stiffness(),
            ..in_use(section)?
        };
        Ok((Spring::new(spring).map_err(|error| section.refuse_science(&error, &DIAMETERS))?, geometry))
    }

    /// By the values of Table I.
    fn valued(
        section: &Section<'_>,
        material: Material,
        rest_length: f64,
        initial_tension: f64,
    ) -> Result<(Spring, Geometry), SpecError> {
        let values = SpringParameters {
            rest_length,
            windings: section.number("windings")?,
            coil_radius: section.quantity("coil_radius", Dimension::Length)?,
            wire_radius: section.quantity("wire_radius", Dimension::Length)?,
            mass: section.quantity("mass", Dimension::Mass)?,
            stiffness: section.quantity("stiffness", Dimension::Stiffness)?,
            ..in_use(section)?
        };
        let refuse = |error: coilsense::Error| section.refuse_science(&error, &[]);
        let closed = Spring::new(values.clone()).map_err(refuse)?;
        let shifted = rest_length - initial_tension / closed.stiffness();
        let most = format!("below {:.6} N, stiffness times rest length", closed.stiffness() * rest_length);
        section.check("initial_tension", shifted > 0.0, initial_tension, &most)?;
        let end_type = end_type(section)?;
        let opens = end_type.is_extension() || initial_tension == 0.0;
        section.check("initial_tension", opens, initial_tension, "zero for a compression spring")?;
        let spring = Spring::new(SpringParameters { rest_length: shifted, ..values }).map_err(refuse)?;
        let total_windings = section.optional_number("total_windings")?;
        let geometry = Geometry::of_spring(&closed, end_type, material).and_then(|geometry| match total_windings {
            Some(_) => Geometry::new(GeometryParameters { total_windings, ..*geometry.parameters() }),
            None => Ok(geometry),
        });
        Ok((spring, geometry.map_err(|error| section.refuse_science(&error, &RADII))?))
    }
}

/// What all ways to describe a spring share; the rest is to be filled in.
fn in_use(section: &Section<'_>) -> Result<SpringParameters, SpecError> {
    Ok(SpringParameters {
        rest_length: 0.0,
        windings: 0.0,
        coil_radius: 0.0,
        wire_radius: 0.0,
        mass: 0.0,
        stiffness: 0.0,
        min_length: section.quantity("min_length", Dimension::Length)?,
        max_length: section.quantity("max_length", Dimension::Length)?,
        nominal_force: section.optional_quantity("nominal_force", Dimension::Force)?,
        inductance_windings: section.optional_number("inductance_windings")?,
        sections: None,
    })
}

/// A length as messages have it, to a tenth of a micrometre.
pub(super) fn millimetres(length: f64) -> String {
    format!("{} mm", plain((1e7 * length).round() / 1e4))
}

/// What stands for the coil.
fn model(section: &Section<'_>, has_dead_ends: bool) -> Result<Model, SpecError> {
    Ok(match section.optional_word("model", &["coil", "chain", "helix"])? {
        Some("chain") => Model::Chain,
        Some("helix") => Model::Helix,
        // No helix of changing pitch is known here.
        _ if has_dead_ends => Model::Chain,
        _ => Model::Coil,
    })
}

/// Which self term the inductance takes.
fn self_distance(section: &Section<'_>) -> Result<SelfDistance, SpecError> {
    Ok(match section.optional_word("self_distance", &["as-printed", "geometric-mean"])? {
        Some("geometric-mean") => SelfDistance::GeometricMean,
        _ => SelfDistance::AsPrinted,
    })
}

/// The sense in which it is wound.
fn hand(section: &Section<'_>) -> Result<Hand, SpecError> {
    Ok(match section.optional_word("hand", &["right", "left"])? {
        Some("left") => Hand::Left,
        _ => Hand::Right,
    })
}

/// What a stiffness is: of a spring by values the slope in use, as one measures it; of one by geometry that of the formula of a flat coil.
fn stiffness_at(section: &Section<'_>, by_geometry: bool) -> Result<StiffnessAt, SpecError> {
    Ok(match section.optional_word("stiffness_at", &["range", "flat"])? {
        Some("range") => StiffnessAt::Range,
        Some(_) => StiffnessAt::Flat,
        None if by_geometry => StiffnessAt::Flat,
        None => StiffnessAt::Range,
    })
}

fn end_type(section: &Section<'_>) -> Result<EndType, SpecError> {
    let word = section.optional_word("end_type", &ENDS.map(|(word, _)| word))?;
    Ok(ENDS.into_iter().find(|(end, _)| Some(*end) == word).map_or(EndType::Hooks, |(_, end_type)| end_type))
}
