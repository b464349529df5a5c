//! What follows from a spring alone: rate, mass, stress, lengths, surge frequencies, and the neighbours that the axial model leaves out.
//!
//! Next door: the formulas (`coilsense::{geometry, modes, neighbours}`), how the sheet is shown (`report`).

mod frequencies;
mod rows;

pub use frequencies::{MountFrequencies, Neighbour};
pub use rows::Row;

use coilsense::Error;

use crate::quantity::digits;
use crate::spec::{Spec, SpringSpec};

/// The data sheet of a spec's spring.
#[derive(Debug, Clone, PartialEq)]
pub struct DataSheet {
    /// The spring's name.
    pub name: String,
    /// What its wire is made of, and whether that is assumed.
    pub material: String,
    /// Single numbers, under headings.
    pub groups: Vec<(&'static str, Vec<Row>)>,
    /// Surge frequencies on every mount.
    pub surge: Vec<MountFrequencies>,
    /// What else the spring can do than surge.
    pub neighbours: Vec<Neighbour>,
    /// Length with all windings touching \[m\].
    pub solid_length: f64,
    /// What does not fit together, a sentence each.
    pub doubts: Vec<String>,
}

/// From so large a departure on, stiffness or mass are not those of the wire, coil and material that the spec names.
const DOUBTFUL: f64 = 0.05;

/// What does not fit together in a spring.
fn doubts(spring: &SpringSpec) -> Vec<String> {
    let mut doubts = Vec::new();
    let both = [
        ("k", spring.geometry.stiffness(), spring.spring.stiffness(), 1.0, "N/m"),
        ("m", spring.geometry.active_mass(), spring.spring.mass(), 1e3, "g"),
    ];
    for (letter, wound, given, scale, unit) in both {
        let departure = wound / given - 1.0;
        if departure.abs() > DOUBTFUL {
            doubts.push(format!(
                "wire, coil and {} would give {letter} = {} {unit}, {:+.0} % from the {} {unit} given: another material, or another coil?",
                spring.material,
                digits(scale * wound),
                100.0 * departure,
                digits(scale * given)
            ));
        }
    }
    doubts
}

impl DataSheet {
    /// Of a spec's spring on its mount.
    ///
    /// # Errors
    /// What the science says of a spring beyond its formulas.
    pub fn of(spec: &Spec) -> Result<Self, Error> {
        let spring = &spec.spring;
        let assumed = if spring.material_is_given { "" } else { " (assumed)" };
        let solid = spring.solid_length();
        Ok(Self {
            name: spring.name.clone(),
            material: format!("{}{assumed}", spring.material),
            groups: rows::groups(spring, solid)?,
            surge: frequencies::on_every_mount(&spring.spring, spec.mount.far_end())?,
            neighbours: frequencies::neighbours(spring)?,
            solid_length: solid,
            doubts: doubts(spring),
        })
    }

    /// A sentence for each kind of neighbour that lies below the first surge on the spec's own mount.
    pub fn neighbour_warnings(&self) -> Vec<String> {
        let Some(own) = self.surge.iter().find(|mount| mount.is_the_specs) else { return Vec::new() };
        let first = own.chain_hz.first().copied().unwrap_or(f64::INFINITY);
        let mut sentences = Vec::new();
        for name in ["torsional", "lateral"] {
            let of_name = self.neighbours.iter().filter(|neighbour| neighbour.name == name);
            let lowest = of_name.filter_map(|n| Some((n.frequency_hz?, &n.place))).min_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((frequency, place)) = lowest.filter(|(frequency, _)| *frequency < first) {
                sentences.push(format!(
                    "{name} motion starts at about {frequency:.0} Hz {place}, below the first axial mode of {first:.1} Hz: the axial \
                     model leaves it out (an estimate)."
                ));
            }
        }
        let buckled: Vec<&str> =
            self.neighbours.iter().filter(|n| n.frequency_hz.is_none()).map(|n| n.place.as_str()).collect();
        if !buckled.is_empty() {
            sentences.push(format!(
                "the spring may buckle {} where its ends can tilt (flat seats and guides prevent it); the axial model leaves that out.",
                buckled.join(" and ")
            ));
        }
        sentences
    }
}
