//! What a plant tells beside its forces: F_L by its inductance, and how near its windings are.
//!
//! Next door: the plant (the parent), how many modes these need (`order`), their numbers (`coilsense::plant`).

use coilsense::calibrate::Calibration;
use coilsense::inductance::MaxwellSum;
use coilsense::plant::{ModalCoil, ModalPlant, ModalWindings};
use minijinja::{Value, context};

use super::{PlantError, digits};
use crate::mitigation::export::Precision;
use crate::spec::{PermeabilityFound, Spec, SpringSpec};

/// The words of `also`, in the order in which outputs are told.
const WORDS: [&str; 3] = ["F_L", "closest_pitch", "readings"];

/// What is asked for beside the forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Also {
    /// L and F_L, with their bounds.
    pub inductance: bool,
    /// The smallest distance between neighbouring windings.
    pub closest_pitch: bool,
    /// What the spec's sensors read.
    pub readings: bool,
}

impl Also {
    /// Of words with commas between.
    ///
    /// # Errors
    /// What is allowed, for a word that is none of them.
    pub fn of(text: &str) -> Result<Self, String> {
        let mut also = Self::default();
        for word in text.split(',').map(str::trim) {
            match word {
                "F_L" => also.inductance = true,
                "closest_pitch" => also.closest_pitch = true,
                "readings" => also.readings = true,
                other => return Err(format!("must be of {}, with commas between, got {other:?}", WORDS.join(", "))),
            }
        }
        Ok(also)
    }
}

/// The coil of a spec and its meter, for F_L.
#[derive(Debug, Clone)]
pub(super) struct Meter {
    pub coil: MaxwellSum,
    pub calibration: Calibration,
    /// Shortest and longest distance of the ends for which F_L is asked \[m\].
    lengths: [f64; 2],
    /// What the reader must know of it.
    pub doubt: Option<String>,
}

/// How far beyond the lengths in use F_L is told, a share of the travel.
const BEYOND: f64 = 0.1;

impl Meter {
    /// Calibrated by theory over the operating range, and set to zero at a mean length \[m\].
    ///
    /// # Errors
    /// [`PlantError`] for wire that the spec says is magnetic, and for a coil whose eq. (13) cannot be fitted.
    pub fn of(spec: &Spec, mean_length: f64) -> Result<Self, PlantError> {
        let file = &spec.file;
        if spec.spring.is_magnetic() {
            let told = "[spring] relative_permeability: a plant's F_L is that of wire that is not magnetic; leave F_L out of also, or \
                        take it from coilsense simulate";
            return Err(PlantError::Spec(format!("{file}: {told}")));
        }
        let spring = &spec.spring.spring;
        let coil = spec.spring.inductance_in_air();
        let calibration = Calibration::theoretical(spring, &coil, mean_length).map_err(PlantError::science(file))?;
        let (shortest, longest) = spring.operating_range();
        let room = BEYOND * (longest - shortest);
        let used = spec.conditions.iter().map(|condition| condition.excitation.length_bounds());
        let (least, most) =
            used.fold((shortest - room, longest + room), |(least, most), (from, to)| (least.min(from), most.max(to)));
        // Windings that touch are beyond a plant.
        let touching = spec.spring.contact_pitch() * spring.inductance_windings();
        let lengths = [least.max(touching).min(mean_length), most];
        Ok(Self { coil, calibration, lengths, doubt: doubt(&spec.spring) })
    }

    /// Of a plant.
    pub fn on(&self, plant: &ModalPlant) -> Result<ModalCoil, coilsense::Error> {
        plant.coil(&self.coil, self.calibration, self.lengths)
    }
}

/// What wire of unknown permeability may do to F_L.
fn doubt(spring: &SpringSpec) -> Option<String> {
    let found = match spring.permeability_found()? {
        PermeabilityFound::Above(least) => format!("above {least}"),
        PermeabilityFound::Between(least, most) => format!("{least} to {most}"),
    };
    Some(format!(
        "F_L and L are those of wire that is not magnetic; such wire ({}) was found with a relative permeability of {found}",
        spring.material
    ))
}

/// The windings as a template has them.
pub(super) fn of_windings(windings: &ModalWindings, precision: Precision) -> Value {
    context! {
        share => digits(windings.share()),
        contact_pitch => digits(windings.contact_pitch()),
        gaps => rows(windings.gaps(), precision),
    }
}

/// The coil as a template has it.
pub(super) fn of_coil(coil: &ModalCoil, precision: Precision) -> Value {
    let rows = |table| rows(table, precision);
    let [middle, half] = coil.pitches();
    let [slopes, curvatures, remainders] = coil.by_lag();
    let calibration = coil.calibration();
    context! {
        windings => digits(coil.windings()),
        middle => digits(middle),
        half => digits(half),
        alpha => digits(calibration.alpha()),
        beta => digits(calibration.beta()),
        left => digits(coil.left()),
        shortest => digits((middle - half) * coil.windings()),
        longest => digits((middle + half) * coil.windings()),
        inductance => row(coil.inductance(), precision),
        slopes => rows(slopes),
        curvatures => rows(curvatures),
        remainders => rows(remainders),
        gaps => rows(coil.gaps()),
    }
}

fn row(values: &[f64], precision: Precision) -> Vec<String> {
    values.iter().map(|value| precision.literal(*value)).collect()
}

fn rows(table: &[Vec<f64>], precision: Precision) -> Vec<Vec<String>> {
    table.iter().map(|values| row(values, precision)).collect()
}
