//! The table `[spring]`: a spring by the values of the paper's Table I, or by wire, coil and material.
//!
//! Next door: reading keys (`section`), the material table (`catalogue`), what the values must be (`coilsense::{Spring, geometry}`).

use std::path::Path;

use coilsense::geometry::{EndType, Geometry, GeometryParameters, Material};
use coilsense::inductance::SelfDistance;
use coilsense::{Spring, SpringParameters};

use super::document::Document;
use super::keys::springs;
use super::material::material;
use super::section::Section;
use super::tolerance::Tolerances;
use super::{SpecError, plain, read_text};
use crate::quantity::Dimension;

/// A spring and what people say of it.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringSpec {
    /// Its name.
    pub name: String,
    /// The spring, its rest length shifted by the initial tension: l0 − F_0/k.
    pub spring: Spring,
    /// Wire, coil, ends and material; stiffness and mass by its formulas are not those of `spring` where that is given by values.
    pub geometry: Geometry,
    /// What the wire is made of.
    pub material: String,
    /// Whether the spec says so, or it is assumed.
    pub material_is_given: bool,
    /// Whether stiffness and mass come from wire and coil.
    pub by_geometry: bool,
    /// Length without force as the spec gives it, of an extension spring closed \[m\].
    pub closed_length: f64,
    /// F_0 \[N\].
    pub initial_tension: f64,
    /// Which self term the inductance takes.
    pub self_distance: SelfDistance,
    /// How far real springs are from all this.
    pub tolerances: Tolerances,
    /// Masses of the chain for each winding, where the spec says so; `spring` has as many, else one.
    pub masses_per_winding: Option<usize>,
}

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
    /// How far the stiffness may be off, either way, as a share \[1\].
    pub fn stiffness_tolerance(&self) -> f64 {
        self.tolerances.of_stiffness()
    }

    /// How far the rest length may be off, either way \[m\].
    pub fn rest_length_tolerance(&self) -> f64 {
        self.tolerances.rest_length
    }

    /// Reads a spring from the text of a spec, whose other tables are left alone; `file` names it in errors.
    ///
    /// # Errors
    /// [`SpecError`], one line with file, line, key, value, unit and what is allowed.
    pub fn parse(file: &str, text: &str) -> Result<Self, SpecError> {
        Self::of(&Document::parse(file, text)?.section("spring")?)
    }

    /// Reads a spring from a file.
    ///
    /// # Errors
    /// [`SpecError`] as [`Self::parse`], or where the file cannot be read.
    pub fn read(path: &Path) -> Result<Self, SpecError> {
        Self::parse(&path.display().to_string(), &read_text(path)?)
    }

    /// Length with all windings touching \[m\], as [`Geometry::solid_length`] has it: with initial tension the closed length.
    pub fn solid_length(&self) -> f64 {
        if self.initial_tension > 0.0 { self.closed_length } else { self.geometry.solid_length() }
    }

    /// Distance of points one turn apart at which windings touch \[m\]: l_s over the model's windings, since their pitch is the length over
    /// their number, dead end windings included.
    pub fn contact_pitch(&self) -> f64 {
        self.solid_length() / self.spring.whole_windings() as f64
    }

    /// Gap from wire to wire between neighbouring windings \[m\] where neighbours of the chain are `pitch` apart \[m\]; below zero where
    /// wires would overlap.
    ///
    /// g = (p − l_s/M) M/N, of M masses: (l − l_s)/N where all are equally far apart, as the data sheet has it.
    pub fn gap(&self, pitch: f64) -> f64 {
        (pitch - self.contact_pitch()) * self.spring.whole_windings() as f64 / self.spring.windings()
    }

    /// Distance of neighbouring active windings from centre to centre \[m\] where neighbours of the chain are `pitch` apart \[m\]: they touch
    /// at the wire's diameter.
    pub fn winding_pitch(&self, pitch: f64) -> f64 {
        self.spring.wire_diameter() + self.gap(pitch)
    }

    /// Reads the table `[spring]`.
    pub(super) fn of(section: &Section<'_>) -> Result<Self, SpecError> {
        let kind = springs::way(|key| section.has(key));
        let by_geometry = kind == springs::BY_GEOMETRY;
        let whose = match by_geometry {
            true => "a spring by geometry (which wire_diameter or coil_diameter makes it)",
            false => "a spring by values (without wire_diameter and coil_diameter)",
        };
        section.only_of(kind, whose)?;
        let closed_length = section.quantity("rest_length", Dimension::Length)?;
        let (material, material_is_given) =
            (material(section)?, section.has("material") || section.has("shear_modulus"));
        let initial_tension = section.not_negative("initial_tension", Dimension::Force)?.unwrap_or(0.0);
        let (spring, geometry) = match by_geometry {
            true => Self::wound(section, material.1, closed_length, initial_tension)?,
            false => Self::valued(section, material.1, closed_length, initial_tension)?,
        };
        let name = section.text("name")?;
        let masses = section.optional_whole("masses_per_winding", 1, MOST_MASSES_PER_WINDING)?;
        let masses_per_winding = masses.map(|masses| masses as usize);
        let self_distance = match section.optional_word("self_distance", &["as-printed", "geometric-mean"])? {
            Some("geometric-mean") => SelfDistance::GeometricMean,
            _ => SelfDistance::AsPrinted,
        };
        let spec = Self {
            name,
            geometry,
            material: material.0,
            material_is_given,
            by_geometry,
            closed_length,
            initial_tension,
            self_distance,
            tolerances: Tolerances::parse(section, by_geometry, closed_length)?,
            masses_per_winding,
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
        let geometry = Geometry::of_spring(&closed, end_type, material);
        Ok((spring, geometry.map_err(|error| section.refuse_science(&error, &RADII))?))
    }
}

/// What both ways to describe a spring share; the rest is to be filled in.
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
    })
}

/// Rounding of lengths as they are written.
const ROUNDING: f64 = 1e-9;

/// A length as messages have it, to a tenth of a micrometre.
fn millimetres(length: f64) -> String {
    format!("{} mm", plain((1e7 * length).round() / 1e4))
}

fn end_type(section: &Section<'_>) -> Result<EndType, SpecError> {
    let word = section.optional_word("end_type", &ENDS.map(|(word, _)| word))?;
    Ok(ENDS.into_iter().find(|(end, _)| Some(*end) == word).map_or(EndType::Hooks, |(_, end_type)| end_type))
}
