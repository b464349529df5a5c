//! A spring and what people say of it: its model, its tolerances, the coil as a helix.
//!
//! Next door: reading it from the table `[spring]` (`spring_table`), what the values must be (`coilsense::{Spring, geometry}`).

use std::path::Path;

use coilsense::geometry::Geometry;
use coilsense::helix::{Hand, Rod, StiffnessAt};
use coilsense::inductance::SelfDistance;
use coilsense::{Error, Spring, SpringParameters};

use super::catalogue::PermeabilityFound;
use super::document::Document;
use super::ends::EndsSpec;
use super::sections::DeadEnds;
use super::tolerance::Tolerances;
use super::{SpecError, read_text};
use crate::helix::Coil;

/// A spring and what people say of it.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringSpec {
    /// Its name.
    pub name: String,
    /// The spring as its axial model has it, its rest length shifted by the initial tension: l0 − F_0/k. Its mass is that with which a
    /// uniform bar has the first surge frequency of the coil, see [`Model::Coil`]; the real one is [`Self::mass`].
    pub spring: Spring,
    /// How its axial motion is modelled.
    pub model: Model,
    /// m of the active windings \[kg\].
    pub mass: f64,
    /// Lowest and highest first surge frequency that the coil as a helix has in use \[Hz\]; `None` until that is looked at, and where it is none.
    pub first_frequencies: Option<(f64, f64)>,
    /// Wire, coil, ends and material; stiffness and mass by its formulas are not those of `spring` where that is given by values.
    pub geometry: Geometry,
    /// What the wire is made of.
    pub material: String,
    /// Whether the spec says so, or it is assumed.
    pub material_is_given: bool,
    /// What is known of the permeability of such wire, where the spec names it and does not tell its own.
    pub(super) found_of_wire: Option<PermeabilityFound>,
    /// Whether stiffness and mass come from wire and coil.
    pub by_geometry: bool,
    /// Of a coil of sections, the closed windings at its ends.
    pub dead_ends: Option<DeadEnds>,
    /// Length without force as the spec gives it, of an extension spring closed \[m\].
    pub closed_length: f64,
    /// F_0 \[N\].
    pub initial_tension: f64,
    /// Which self term the inductance takes.
    pub self_distance: SelfDistance,
    /// How far real springs are from all this.
    pub tolerances: Tolerances,
    /// Masses of the chain for each winding, where the spec says so; `spring` has as many, else the fewest that its model takes: one, and of
    /// the coil thirty in all.
    pub masses_per_winding: Option<usize>,
    /// What the stiffness says of the wire.
    pub stiffness_at: StiffnessAt,
    /// The sense in which it is wound.
    pub hand: Hand,
}

/// What stands for the coil in its motion along the axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Model {
    /// The paper's chain of masses, with the mass and the stiffness of the spring as they are.
    Chain,
    /// That chain, with a mass that gives it the first surge frequency of the coil as a helix.
    #[default]
    Coil,
    /// All modes of the coil as a helix, about the mean length of a condition; where a chain is needed besides, that of [`Model::Coil`].
    Helix,
}

/// Rounding of lengths as they are written.
pub(super) const ROUNDING: f64 = 1e-9;
/// A chain of so many masses has the first frequency of a bar to 5e-4, π²/24 over their square.
const MASSES_OF_A_COIL: usize = 30;

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
        Self::of(&Document::parse(file, text)?.only_spring()?)
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
        if let (Some(sections), Some(dead)) = (self.spring.sections(), self.dead_ends) {
            return sections.place_at(sections.windings(), sections.solid_force()) + dead.length;
        }
        if self.initial_tension > 0.0 { self.closed_length } else { self.geometry.solid_length() }
    }

    /// The largest shear stress of the wire under a pressing or pulling force \[Pa\], with Wahl's factor; of sections where it is largest.
    pub fn corrected_shear_stress(&self, force: f64) -> f64 {
        match self.spring.sections() {
            Some(sections) => sections.corrected_shear_stress(force.abs()),
            None => self.geometry.corrected_shear_stress(force),
        }
    }

    /// The shear stress of the wire under a force that it carries at a place, 0 at end 1 and 1 at end 2 \[Pa\], with Wahl's factor; its sign is the force's.
    pub fn corrected_shear_stress_at(&self, place: f64, force: f64) -> f64 {
        match self.spring.sections() {
            Some(sections) => sections.corrected_shear_stress_at(place * sections.windings(), force),
            None => self.geometry.corrected_shear_stress(force),
        }
    }

    /// Length \[m\] at which the first windings close at rest, where that lies in the range in use: of a coil of sections.
    pub fn closes_in_use(&self) -> Option<f64> {
        let sections = self.spring.sections()?;
        let length = self.spring.rest_length() - sections.compression(sections.first_closing()).ok()?;
        let (shortest, _) = self.spring.operating_range();
        (shortest < length * (1.0 - ROUNDING)).then_some(length)
    }

    /// Distance of points one turn apart at which windings touch \[m\]: l_s over the model's windings, since their pitch is the length over
    /// their number, dead end windings included.
    pub fn contact_pitch(&self) -> f64 {
        self.solid_length() / self.spring.whole_windings() as f64
    }

    /// Its wire as a rod, E and G brought to its stiffness and the density to its mass.
    ///
    /// # Errors
    /// As [`Rod::of_spring`].
    pub fn rod(&self) -> Result<Rod, Error> {
        Rod::of_spring(&self.of_mass(self.mass)?, &self.geometry, self.stiffness_at, self.hand)
    }

    /// The spring with the mass that the spec says, whatever its model makes of it, and one mass for each winding unless it says more.
    pub fn as_given(&self) -> Spring {
        let masses = self.masses_per_winding.unwrap_or(1);
        // Its mass was let through when the spec was read.
        let given = self.of_mass(self.mass).and_then(|spring| spring.with_masses_per_winding(masses));
        given.unwrap_or_else(|_| self.spring.clone())
    }

    /// The coil as a helix, its ends held in these ways.
    ///
    /// # Errors
    /// As [`Self::rod`].
    pub fn helix(&self, ends: &EndsSpec) -> Result<Coil, Error> {
        Ok(Coil {
            rod: self.rod()?,
            dead_length: -self.geometry.active_span(0.0),
            range: self.spring.operating_range(),
            ways: ends.ways(),
            misalignment: ends.misalignment,
        })
    }

    /// Between which first surge frequencies the coil may lie \[Hz\]: as a helix in use; of the paper's chain, or where that is not looked
    /// up, also where chain and bar leave it.
    pub fn first_frequency_band(&self) -> (f64, f64) {
        let (low, high) = self.spring.first_frequency_band();
        match (self.first_frequencies, self.model) {
            (Some(helix), Model::Coil | Model::Helix) => helix,
            (Some(helix), Model::Chain) => (helix.0.min(low), helix.1.max(high)),
            (None, _) => (low, high),
        }
    }

    /// How far the model leaves the first surge frequency open, either way, as a share \[1\].
    pub fn open_frequency(&self) -> f64 {
        let (low, high) = self.first_frequency_band();
        let of_model = self.spring.chain_frequency();
        (low / of_model).ln().abs().max((high / of_model).ln().abs())
    }

    /// Takes over the first surge frequency of the coil as a helix, at mid range and with its ends held in these ways, where its model
    /// asks for that. Of a spring that is no helix nothing changes; the data sheet says so.
    pub(super) fn follow_helix(&mut self, ends: &EndsSpec) {
        if self.model == Model::Chain {
            return;
        }
        let first = self.helix(ends).and_then(|coil| coil.first_surge(self.spring.mid_length()));
        let Ok((low, high)) = first else { return };
        let least = MASSES_OF_A_COIL.div_ceil(self.spring.whole_windings());
        let masses = self.masses_per_winding.unwrap_or(least);
        let coil = self.of_mass(self.spring.stiffness() / (low + high).powi(2));
        if let Ok(spring) = coil.and_then(|spring| spring.with_masses_per_winding(masses)) {
            self.spring = spring;
        }
    }

    /// As [`super::Spec::needs_chain`]; `file` is the spec's.
    pub(crate) fn needs_chain(&self, file: &str, what: &str) -> Result<(), SpecError> {
        // A build without contact reads no sections.
        if cfg!(feature = "contact") && self.dead_ends.is_some() {
            let takes = "a uniform coil; one of sections is for spring, simulate, analyze, sweep and speed";
            return Err(SpecError(format!("{file}: [[spring.section]]: {what} takes {takes}")));
        }
        self.needs_axial(file, what)
    }

    /// Refuses the helix alone: what moves along the axis only takes a coil of sections, too.
    pub(crate) fn needs_axial(&self, file: &str, what: &str) -> Result<(), SpecError> {
        if self.model != Model::Helix {
            return Ok(());
        }
        let takes = "\"coil\" or \"chain\"; \"helix\" is for simulate, analyze and spring";
        Err(SpecError(format!("{file}: [spring] model = \"helix\": {what} takes {takes}")))
    }

    /// What is wrong with lengths between these \[m\]: below the solid length, or out of the range in use.
    pub fn out_of_use(&self, shortest: f64, longest: f64) -> Option<String> {
        let ((min, max), solid) = (self.spring.operating_range(), self.solid_length());
        // A micrometre is rounding of a length as it is written.
        let slack = 1e-6;
        if shortest < solid - slack {
            return Some(format!(
                "the spring is {:.2} mm long at its shortest, below its solid length of {:.2} mm.",
                1e3 * shortest,
                1e3 * solid
            ));
        }
        (shortest < min - slack || longest > max + slack).then(|| {
            format!(
                "lengths from {:.2} to {:.2} mm leave the range in use, {:.2}–{:.2} mm.",
                1e3 * shortest,
                1e3 * longest,
                1e3 * min,
                1e3 * max
            )
        })
    }

    /// Looks up between which first surge frequencies the coil as a helix lies in use.
    pub fn look_up_surges(&mut self, ends: &EndsSpec) {
        self.first_frequencies = self.helix(ends).and_then(|coil| coil.first_surges()).ok();
    }

    /// The spring with another mass.
    fn of_mass(&self, mass: f64) -> Result<Spring, Error> {
        let parameters = SpringParameters { mass, ..self.spring.parameters().clone() };
        Spring::new(parameters)?.with_masses_per_winding(self.spring.masses_per_winding())
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
}
