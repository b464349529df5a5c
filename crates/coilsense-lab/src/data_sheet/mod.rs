//! What follows from a spring alone: rate, mass, stress, lengths, surge frequencies, and every mode of the coil as a helix.
//!
//! Next door: the formulas (`coilsense::{geometry, modes, helix}`), how the sheet is shown (`report`).

mod curve;
mod frequencies;
mod reach;
mod rows;

pub use curve::AtLength;
pub use frequencies::MountFrequencies;
pub use rows::Row;

use coilsense::Error;

use crate::helix::ModesAt;
use crate::quantity::digits;
use crate::spec::{Model, Spec, SpringSpec};

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
    /// Of a coil of sections, its static curve over the range in use; none of a uniform one.
    pub static_curve: Vec<AtLength>,
    /// Every mode at the shortest, the middle and the longest length; none of a spring that is no helix there, which `doubts` then says.
    pub modes_at: Vec<ModesAt>,
    /// What of these the axial model leaves out, a sentence each.
    pub beyond_axial: Vec<String>,
    /// Length with all windings touching \[m\].
    pub solid_length: f64,
    /// What does not fit together, a sentence each.
    pub doubts: Vec<String>,
}

/// From so large a departure on, stiffness or mass are not those of the wire, coil and material that the spec names.
const DOUBTFUL: f64 = 0.05;
/// What is left out of a coil of sections.
const OF_SECTIONS: &str = "a coil of sections is followed along its axis only, as a chain: as a helix it may surge some per cent lower where it has few \
                           windings, and its lateral and torsional lines are not known.";
/// Error that is asked for where a spec has no goal, as a share.
const USUAL_GOAL: f64 = 0.01;

/// What does not fit together in a spring.
fn doubts(spring: &SpringSpec) -> Vec<String> {
    let mut doubts: Vec<String> = spring.magnetisation_left_out().map(|text| text + ".").into_iter().collect();
    if spring.dead_ends.is_some() {
        return doubts;
    }
    let both = [
        ("k", spring.geometry.stiffness(), spring.spring.stiffness(), 1.0, "N/m"),
        ("m", spring.geometry.active_mass(), spring.mass, 1e3, "g"),
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
        let surge = frequencies::on_every_mount(&spring.spring, spec.mount.far_end())?;
        let mut doubts = doubts(spring);
        let coil = spring.helix(&spec.mount.ends);
        let modes_at =
            coil.as_ref().map_err(Clone::clone).and_then(|coil| coil.over_lengths(3)).unwrap_or_else(|error| {
                if spring.dead_ends.is_some() {
                    return Vec::new();
                }
                doubts
                    .push(format!("the coil cannot be followed as a helix ({error}): only its axial modes are told."));
                Vec::new()
            });
        let own = surge.iter().find(|mount| mount.is_the_specs).and_then(|mount| mount.chain_hz.first().copied());
        let goal = spec.goal.error.map_or(USUAL_GOAL, |error| error / spring.spring.nominal_force());
        let model = spring.spring.chain_frequency();
        Ok(Self {
            name: spring.name.clone(),
            material: format!("{}{assumed}", spring.material),
            groups: rows::groups(spring, solid, coil.as_ref().ok(), &modes_at)?,
            surge,
            static_curve: curve::over_lengths(spring),
            beyond_axial: match spring.model {
                // Sections are not read in a build without contact, which need not carry the words.
                _ if cfg!(feature = "contact") && spring.dead_ends.is_some() => vec![OF_SECTIONS.to_owned()],
                // All of its modes are in the answer.
                Model::Helix => reach::buckled(&modes_at).into_iter().collect(),
                Model::Coil | Model::Chain => reach::warnings(&modes_at, model, own.unwrap_or(f64::INFINITY), goal),
            },
            modes_at,
            solid_length: solid,
            doubts,
        })
    }
}
