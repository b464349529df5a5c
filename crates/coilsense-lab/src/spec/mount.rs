//! The table `[mount]`: what end 2 is tied to, and the dampings for which results are given.
//!
//! Next door: what they mean (`coilsense::{Mount, Damping}`).

use coilsense::modes::ChainModes;
use coilsense::{Damping, FarEnd, Mount, Spring};

use super::SpecError;
use super::section::{Document, Section};
use crate::quantity::Dimension;

/// Damping ratios for which results are given where a spec says nothing: none is the paper's case, and no measured range is known.
pub const BAND: [f64; 4] = [0.0, 0.001, 0.005, 0.02];

/// What end 2 is tied to, under each damping for which results are wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct MountSpec {
    /// One mount for each damping.
    pub cases: Vec<DampingCase>,
    /// Whether the spec said nothing of damping, so that the cases are [`BAND`].
    pub is_band: bool,
}

/// A mount under one damping.
#[derive(Debug, Clone, PartialEq)]
pub struct DampingCase {
    /// `ζ = 0.005`, or what else damps.
    pub label: String,
    /// The same for file names: `zeta-0.005`.
    pub stem: String,
    /// ζ where it is the same in every mode.
    pub ratio: Option<f64>,
    /// The mount.
    pub mount: Mount,
}

impl MountSpec {
    /// What end 2 is tied to.
    pub fn far_end(&self) -> FarEnd {
        self.cases.first().map_or(FarEnd::Position, |case| case.mount.far_end())
    }

    pub(super) fn parse(document: &Document<'_>, spring: &Spring) -> Result<Self, SpecError> {
        let Some(section) = document.optional_section("mount")? else {
            let cases = BAND.map(|ratio| DampingCase::modal(FarEnd::Position, ratio, Damping::Modal(ratio)));
            return Ok(Self { cases: cases.into_iter().flatten().collect(), is_band: true });
        };
        let far_end = far_end(&section)?;
        let keys = ["damping_ratio", "mass_damping", "stiffness_damping"];
        let given: Vec<&str> = keys.into_iter().filter(|key| section.has(key)).collect();
        if let [first, second, ..] = given.as_slice() {
            return Err(section.refuse(second, format!("only one kind of damping can be given, and {first} is")));
        }
        let one = |case: Result<DampingCase, coilsense::Error>, key: &str| {
            let case = case.map_err(|error| section.refuse(key, error))?;
            Ok(Self { cases: vec![case], is_band: false })
        };
        if let Some(rate) = section.not_negative("mass_damping", Dimension::Rate)? {
            let label = format!("α = {rate} 1/s");
            let damping = Damping::MassProportional { rate };
            return one(DampingCase::of(label, format!("alpha-{rate}"), far_end, damping), "mass_damping");
        }
        if let Some(time) = section.not_negative("stiffness_damping", Dimension::Time)? {
            let label = format!("β = {} µs", 1e6 * time);
            let damping = Damping::StiffnessProportional { time };
            return one(DampingCase::of(label, format!("beta-{time}"), far_end, damping), "stiffness_damping");
        }
        let given = section.optional_numbers("damping_ratio")?;
        let is_band = given.is_none();
        let cases = given.unwrap_or(BAND.to_vec()).into_iter().map(|ratio| modal(&section, spring, far_end, ratio));
        Ok(Self { cases: cases.collect::<Result<_, _>>()?, is_band })
    }
}

/// The highest damping ratio taken: a coil that hardly moves.
const HIGHEST_RATIO: f64 = 10.0;

/// Damping by ratios: the same in every mode, but for the swing of an end mass where that is given.
fn modal(section: &Section<'_>, spring: &Spring, far_end: FarEnd, ratio: f64) -> Result<DampingCase, SpecError> {
    let allowed = |ratio: f64| (0.0..=HIGHEST_RATIO).contains(&ratio);
    section.check("damping_ratio", allowed(ratio), ratio, "from 0 to 10")?;
    let damping = match section.optional_number("first_mode_damping_ratio")? {
        None => Damping::Modal(ratio),
        Some(first) => {
            section.check("first_mode_damping_ratio", allowed(first), first, "from 0 to 10")?;
            let mut ratios = vec![ratio; ChainModes::mounted(spring, far_end).count()];
            ratios[0] = first;
            Damping::ModalEach(ratios)
        }
    };
    DampingCase::modal(far_end, ratio, damping).map_err(|error| section.refuse("damping_ratio", error))
}

impl DampingCase {
    fn modal(far_end: FarEnd, ratio: f64, damping: Damping) -> Result<Self, coilsense::Error> {
        let case = Self::of(format!("ζ = {ratio}"), format!("zeta-{ratio}"), far_end, damping)?;
        Ok(Self { ratio: Some(ratio), ..case })
    }

    fn of(label: String, stem: String, far_end: FarEnd, damping: Damping) -> Result<Self, coilsense::Error> {
        Ok(Self { label, stem, ratio: None, mount: Mount::new(far_end, damping)? })
    }
}

fn far_end(section: &Section<'_>) -> Result<FarEnd, SpecError> {
    let word = section.optional_word("end2", &["held", "force", "mass"])?.unwrap_or("held");
    section.only_of(word, &format!("an end 2 that is \"{word}\""))?;
    Ok(match word {
        "force" => FarEnd::Force,
        "mass" => {
            section.quantity("end_mass", Dimension::Mass)?;
            let mass = section.above_zero("end_mass", Dimension::Mass)?.unwrap_or_default();
            // Here, so that the error stands at its key.
            Mount::new(FarEnd::Mass(mass), Damping::None).map_err(|error| section.refuse("end_mass", error))?;
            FarEnd::Mass(mass)
        }
        _ => FarEnd::Position,
    })
}
