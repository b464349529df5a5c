//! The spring as an inductance: Maxwell's sum, and what its wire adds where the spec says that it is magnetic.
//!
//! Next door: a spring simulated (`crate::study`), the science (`coilsense::inductance`), what that leaves uncertain (`crate::analysis`).

use coilsense::Error;
use coilsense::inductance::{BoundedInductance, MaxwellSum, OverLength, SteelTurns, SteelWindings};
use coilsense::motion::Windings;

use super::PermeabilityFound;
use super::SpringSpec;

/// A relative permeability so far above 1 changes L.
pub(super) const MAGNETIC: f64 = 0.01;
/// Resistivity of stainless spring wire \[Ω m\], as four measured springs have it (7.2e-7 to 8.1e-7).
pub(crate) const STAINLESS: f64 = 7.5e-7;

/// The windings of a spec's spring as an inductance.
#[derive(Debug, Clone)]
pub enum SpringInductance {
    /// Of wire that is not magnetic, or of which nobody says that it is.
    Air(MaxwellSum),
    /// Of magnetic wire.
    Magnetic(Box<SteelWindings>),
}

/// L of magnetic wire over a series, and how far it may be off.
#[derive(Debug, Clone)]
pub struct Magnetised {
    /// L \[H\], shape `samples`.
    pub inductances: Vec<f64>,
    /// How far it may be off, either way \[H\], shape `samples`.
    pub doubts: Vec<f64>,
    /// Whether windings are so uneven that L takes magnetisation as that of even ones; shape `samples`.
    pub beyond: Vec<bool>,
}

impl SpringInductance {
    /// Of a spec's spring whose windings move, at lengths about its operating range.
    ///
    /// # Errors
    /// [`Error::Value`] for turns of magnetic wire that cannot be solved.
    pub fn of(spring: &SpringSpec) -> Result<Self, Error> {
        Ok(match spring.magnetic_turns()? {
            Some(turns) if cfg!(feature = "steel") => Self::Magnetic(Box::new(SteelWindings::of(turns)?)),
            _ => Self::Air(spring.inductance_in_air()),
        })
    }

    /// Maxwell's sum, by itself.
    pub fn in_air(&self) -> &MaxwellSum {
        match self {
            Self::Air(sum) => sum,
            Self::Magnetic(turns) => turns.at_rest().in_air(),
        }
    }

    /// The windings, where they are magnetic.
    pub fn steel(&self) -> Option<&SteelWindings> {
        match self {
            Self::Magnetic(turns) if cfg!(feature = "steel") => Some(turns),
            Self::Air(_) | Self::Magnetic(_) => None,
        }
    }

    /// L \[H\] of every sample, shape `samples`.
    pub fn series(&self, windings: &Windings) -> Vec<f64> {
        match self {
            Self::Magnetic(turns) if cfg!(feature = "steel") => Magnetised::of(turns, windings).inductances,
            Self::Air(_) | Self::Magnetic(_) => self.in_air().series(windings),
        }
    }
}

impl OverLength for SpringInductance {
    fn at_length(&self, length: f64) -> f64 {
        match self {
            Self::Magnetic(turns) if cfg!(feature = "steel") => turns.at_length(length),
            Self::Air(_) | Self::Magnetic(_) => self.in_air().at_length(length),
        }
    }

    fn at_lengths(&self, lengths: &[f64]) -> Vec<f64> {
        match self {
            Self::Magnetic(turns) if cfg!(feature = "steel") => turns.at_lengths(lengths),
            Self::Air(_) | Self::Magnetic(_) => self.in_air().at_lengths(lengths),
        }
    }
}

impl Magnetised {
    /// Of every sample of a motion.
    pub fn of(turns: &SteelWindings, windings: &Windings) -> Self {
        let series = turns.series(windings);
        let beyond: Vec<bool> = series.iter().map(|sample| sample.bound.is_infinite()).collect();
        let even = |sample: usize| {
            let [first, last] = windings.ends(sample);
            turns.at_length(last - first)
        };
        // Of windings too uneven to be followed: no more than all that uneven spacing does to the sum.
        let doubt = |(sample, found): (usize, &BoundedInductance)| match beyond[sample] {
            true => (found.inductance - even(sample)).abs(),
            false => found.bound,
        };
        let doubts = series.iter().enumerate().map(doubt).collect();
        Self { inductances: series.iter().map(|sample| sample.inductance).collect(), doubts, beyond }
    }
}

impl SpringSpec {
    /// Maxwell's sum over its windings, their wire not magnetic.
    pub fn inductance_in_air(&self) -> MaxwellSum {
        MaxwellSum::new(&self.spring, self.self_distance)
    }

    /// L over length, the windings at rest.
    ///
    /// # Errors
    /// As [`SpringInductance::of`].
    pub fn inductance_at_rest(&self) -> Result<Box<dyn OverLength>, Error> {
        Ok(match self.magnetic_turns()? {
            Some(turns) if cfg!(feature = "steel") => Box::new(turns),
            _ => Box::new(self.inductance_in_air()),
        })
    }

    /// Whether the spec says that its wire is magnetic.
    pub fn is_magnetic(&self) -> bool {
        self.told_permeability().is_some()
    }

    /// What is known of the permeability of such wire, where the spec names it and does not tell its own.
    pub fn permeability_found(&self) -> Option<PermeabilityFound> {
        // What is never told need not be loaded.
        if cfg!(feature = "steel") { self.found_of_wire } else { None }
    }

    fn told_permeability(&self) -> Option<f64> {
        self.geometry.material().relative_permeability().filter(|relative| *relative > 1.0 + MAGNETIC)
    }

    /// Why L and F_L are those of wire that is not magnetic though the spec says that it is; `None` where they are not, or it does not.
    pub fn magnetisation_left_out(&self) -> Option<String> {
        let permeability = self.told_permeability()?;
        let why = match cfg!(feature = "steel") {
            true => SteelTurns::covers(&self.inductance_in_air(), permeability).err()?.to_string(),
            false => "this build has no theory of it".to_owned(),
        };
        Some(format!(
            "relative_permeability = {permeability} is left out of L and F_L, which are those of non-magnetic wire ({why}); L of magnetic wire is larger"
        ))
    }

    /// Its windings at rest where the spec says that their wire is magnetic and the theory covers it.
    fn magnetic_turns(&self) -> Result<Option<SteelTurns>, Error> {
        // What is never made need not be loaded.
        if !cfg!(feature = "steel") {
            return Ok(None);
        }
        let Some(permeability) = self.told_permeability().filter(|_| self.magnetisation_left_out().is_none()) else {
            return Ok(None);
        };
        let (shortest, longest) = self.spring.operating_range();
        let wire = self.spring.wire_radius();
        SteelTurns::over(&self.inductance_in_air(), wire, permeability, [shortest, longest]).map(Some)
    }
}
