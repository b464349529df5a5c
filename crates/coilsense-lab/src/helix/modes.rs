//! The modes over the lengths in use, and where each shows.
//!
//! Next door: the helix they are of (`coilsense::helix`), their lines against length (`lines`), one of them as it moves (`shape`).

use coilsense::helix::{Helix, Kind, Mode, Modes, Rod};
use coilsense::{End, Error};

use super::held::Held;

/// The modes at one length.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ModesAt {
    /// The spring's length \[m\].
    pub length_m: f64,
    /// With the ends as they are held; where that lies between two ways, the tightest.
    #[serde(flatten)]
    pub held: UnderEnds,
    /// The same with the loosest ends that the spec allows; null where there is one way only.
    pub loosest: Option<UnderEnds>,
}

/// The modes with the ends held in one way.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct UnderEnds {
    /// How the ends are held.
    pub ends: String,
    /// Whether the spring has left its axis before it gets to this length: what is told then is of a spring that a guide keeps straight.
    pub buckles: bool,
    /// The static force of the helix \[N\], tension positive.
    pub force_n: f64,
    /// The slope of that force over the length \[N/m\].
    pub stiffness_n_per_m: f64,
    /// The first surge: of the modes near that of a bar of this stiffness and mass, the one with the strongest axial line \[Hz\].
    pub first_surge_hz: f64,
    /// The lowest modes, lowest first: at least ten, and the first axial and torsional ones among them.
    pub modes: Vec<ModeLine>,
}

/// A mode and where it shows.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ModeLine {
    /// Its frequency \[Hz\].
    pub frequency_hz: f64,
    /// `axial`, `torsional`, `lateral`, or `mixed` where none has three fifths of the energy.
    pub kind: &'static str,
    /// Strength of its line in the axial force at one end when the other moves along the axis \[1\]; 1 is a mode of a bar.
    pub axial_strength: f64,
    /// The same as a load cell reads it that is out of line by the spec's misalignment \[1\].
    pub read_strength: f64,
    /// Side force at end 2 per newton of axial force in the mode \[N/N\]; null where it has no axial force.
    pub side_force_n_per_n: Option<f64>,
    /// Couple at end 2 per newton of axial force in the mode, all of it \[m\]; null where it has no axial force.
    pub couple_m: Option<f64>,
    /// The part of it about the spring's axis, with its sign \[m\]; null where it has no axial force.
    pub axis_couple_m: Option<f64>,
}

/// Fewest modes that are told.
const FEWEST: usize = 10;
/// Most modes that are looked at for the first axial and torsional one.
const MOST: usize = 42;
/// Modes below this share of a bar's do not swing: the spring has left its axis.
const STANDING: f64 = 1e-3;
/// A force below this share of the couple's or the side force's is none.
const NO_FORCE: f64 = 1e-9;

/// A coil with its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Coil {
    /// The wire.
    pub rod: Rod,
    /// What the spring is longer than its active windings span \[m\].
    pub dead_length: f64,
    /// Shortest and longest length in use \[m\].
    pub range: (f64, f64),
    /// How the ends are held; where that lies between two ways, the tightest, then the loosest.
    pub ways: (Held, Option<Held>),
    /// Angle between the spring's axis and that of a load cell \[rad\].
    pub misalignment: f64,
}

impl Coil {
    /// Its modes at lengths evenly spread over those in use, both ends of the range among them; shape `count`, at least two.
    ///
    /// # Errors
    /// Those of [`Helix::new`]: a spring that is no helix at one of the lengths.
    pub fn over_lengths(&self, count: usize) -> Result<Vec<ModesAt>, Error> {
        self.lengths(count).into_iter().map(|length| self.at(length)).collect()
    }

    /// Lengths evenly spread over those in use \[m\].
    pub(super) fn lengths(&self, count: usize) -> Vec<f64> {
        let (shortest, longest) = self.range;
        let last = count.max(2) - 1;
        let length = |index: usize| (shortest * (last - index) as f64 + longest * index as f64) / last as f64;
        (0..=last).map(length).collect()
    }

    /// First surge frequency at a length, of all ways in which its ends may be held: lowest and highest \[Hz\].
    ///
    /// # Errors
    /// As [`Self::over_lengths`].
    pub fn first_surge(&self, length: f64) -> Result<(f64, f64), Error> {
        let of = |way: &Held| {
            let helix = Helix::new(&self.rod, length - self.dead_length, way.turning())?;
            Modes::new(&helix, way.ends())?.first_surge()
        };
        let tightest = of(&self.ways.0)?;
        let loosest = self.ways.1.as_ref().map_or(Ok(tightest), of)?;
        Ok((tightest.min(loosest), tightest.max(loosest)))
    }

    /// The same of all lengths in use.
    ///
    /// # Errors
    /// As [`Self::over_lengths`].
    pub fn first_surges(&self) -> Result<(f64, f64), Error> {
        let (shortest, longest) = self.range;
        let mut band = (f64::INFINITY, 0.0_f64);
        for length in [shortest, 0.5 * (shortest + longest), longest] {
            let (low, high) = self.first_surge(length)?;
            band = (band.0.min(low), band.1.max(high));
        }
        Ok(band)
    }

    /// Its modes at one length \[m\], whether in use or not.
    ///
    /// # Errors
    /// As [`Self::over_lengths`].
    pub fn at(&self, length: f64) -> Result<ModesAt, Error> {
        let under = |way: &Held| self.under(length, way).map(|(under, ..)| under);
        let (tightest, loosest) = &self.ways;
        Ok(ModesAt { length_m: length, held: under(tightest)?, loosest: loosest.as_ref().map(under).transpose()? })
    }

    /// What is told of one way of the ends, and what it is told of.
    pub(super) fn under(&self, length: f64, way: &Held) -> Result<(UnderEnds, Modes, Vec<Mode>), Error> {
        let helix = Helix::new(&self.rod, length - self.dead_length, way.turning())?;
        let modes = Modes::new(&helix, way.ends())?;
        let found = told(&modes)?;
        let under = UnderEnds {
            ends: way.words(),
            first_surge_hz: modes.first_surge()?,
            buckles: is_standing(&modes, &self.rod, way)?,
            force_n: helix.force(),
            stiffness_n_per_m: helix.stiffness(),
            modes: found.iter().map(|mode| line(mode, self.misalignment)).collect(),
        };
        Ok((under, modes, found))
    }
}

/// The modes that are told.
fn told(modes: &Modes) -> Result<Vec<Mode>, Error> {
    let mut count = FEWEST + 2;
    loop {
        let found = modes.lowest(count)?;
        let has = |kind: Kind| found.iter().any(|mode| mode.kind() == kind);
        if count >= MOST || found.len() >= FEWEST && has(Kind::Axial) && has(Kind::Torsional) {
            return Ok(found);
        }
        count += FEWEST;
    }
}

/// Whether the spring has left its axis.
pub(super) fn is_standing(modes: &Modes, rod: &Rod, way: &Held) -> Result<bool, Error> {
    // A coil that is free to turn at both ends has a motion without frequency too, which is no buckling.
    Ok(modes.count_below(STANDING * rod_frequency(rod))? > usize::from(way.spins()))
}

/// First frequency of a bar of the stiffness and mass of the flat coil \[Hz\].
fn rod_frequency(rod: &Rod) -> f64 {
    0.5 * (rod.flat_stiffness() / rod.mass()).sqrt()
}

pub(super) fn line(mode: &Mode, misalignment: f64) -> ModeLine {
    let reaction = mode.reaction(End::Two);
    let (force, couple) = (reaction.force(), reaction.couple());
    let axial = force[2].norm();
    let side = force[0].norm().hypot(force[1].norm());
    let all_couple = couple.iter().map(|part| part.norm_sqr()).sum::<f64>().sqrt();
    let has_force = axial > NO_FORCE * side;
    let strength = mode.line_strength();
    // A cell that is tilted in the plane of the side force reads the most of it.
    let tilted = misalignment.cos() + misalignment.sin() * side / axial;
    ModeLine {
        frequency_hz: mode.frequency(),
        kind: kind_name(mode.kind()),
        axial_strength: strength,
        read_strength: if has_force { strength * tilted } else { strength },
        side_force_n_per_n: has_force.then(|| side / axial),
        couple_m: has_force.then(|| all_couple / axial),
        axis_couple_m: has_force.then(|| reaction.axis_couple()),
    }
}

/// The word for a kind.
pub(super) fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Axial => "axial",
        Kind::Torsional => "torsional",
        Kind::Lateral => "lateral",
        Kind::Mixed => "mixed",
    }
}

impl ModesAt {
    /// The ways in which the ends may be.
    pub fn ways(&self) -> impl Iterator<Item = &UnderEnds> {
        std::iter::once(&self.held).chain(&self.loosest)
    }
}

impl UnderEnds {
    /// The first mode of a kind.
    pub fn first(&self, kind: &str) -> Option<&ModeLine> {
        self.modes.iter().find(|mode| mode.kind == kind)
    }
}
