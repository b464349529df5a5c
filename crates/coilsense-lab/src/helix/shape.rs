//! One mode as it moves, and what its ends feel.
//!
//! Next door: all modes over the lengths in use (`modes`).

use coilsense::helix::Mode;
use coilsense::{End, Error};

use super::modes::{Coil, ModeLine, UnderEnds, line};

/// A mode at one length with the ends held in one way.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeShape {
    /// Its frequency, its kind and where it shows.
    pub line: ModeLine,
    /// All modes there with the ends held in that way.
    pub under: UnderEnds,
    /// Reactions at end 1 and at end 2.
    pub ends: [EndReaction; 2],
    /// Where points of the wire's centre rest, from end 1 to end 2 \[m\]: z along the axis.
    pub wire: Vec<[f64; 3]>,
    /// How far each of these moves along x, y, z; the farthest of the wire by 1.
    pub moved: Vec<[f64; 3]>,
}

/// What a mode does to what holds one end, per newton of axial force there; null where it has no axial force.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct EndReaction {
    /// Side force \[N/N\].
    pub side_force_n_per_n: Option<f64>,
    /// Couple that tilts the holding \[m\].
    pub tilting_couple_m: Option<f64>,
    /// Couple about the spring's axis, with its sign \[m\].
    pub axis_couple_m: Option<f64>,
}

/// An axial force below this share of the side force is none.
const NO_FORCE: f64 = 1e-9;

impl Coil {
    /// A mode at a length \[m\], by its number from 1 among those that swing, of which `points` a winding are kept, or all where there are fewer.
    ///
    /// - `loosest`: with the ends as loose as they may be, where that lies between two ways
    ///
    /// # Errors
    /// As [`Coil::over_lengths`], and a number beyond those of modes that are found.
    pub fn shape(&self, length: f64, loosest: bool, number: usize, points: usize) -> Result<ModeShape, Error> {
        let way = self.ways.1.as_ref().filter(|_| loosest).unwrap_or(&self.ways.0);
        let (under, modes, mut found) = self.under(length, way)?;
        if number > found.len() {
            found = modes.lowest(number + MOST_STANDING)?;
        }
        let mode = found.get(number.wrapping_sub(1)).ok_or_else(|| Error::Value {
            field: Some("number"),
            quantity: "number".into(),
            value: number as f64,
            unit: "",
            allowed: "that of a mode that swings, from 1".into(),
        })?;
        let kept = kept(mode.wire().len(), self.rod.parameters().windings, points);
        let of = |all: &[[f64; 3]]| kept.iter().map(|at| all[*at]).collect();
        Ok(ModeShape {
            line: line(mode, self.misalignment),
            under,
            ends: [End::One, End::Two].map(|end| reaction(mode, end)),
            wire: of(mode.wire()),
            moved: of(mode.shape()),
        })
    }
}

/// Modes that do not swing come first and are counted; more than these are not so at once.
const MOST_STANDING: usize = 12;

/// Numbers of points that are kept of so many, the first and the last among them.
fn kept(all: usize, windings: f64, points: usize) -> Vec<usize> {
    let last = all.saturating_sub(1);
    let count = ((windings * points as f64).ceil() as usize).clamp(1, last.max(1));
    (0..=count).map(|index| (index * last + count / 2) / count).collect()
}

fn reaction(mode: &Mode, end: End) -> EndReaction {
    let reaction = mode.reaction(end);
    let [x, y, z] = reaction.force().map(|part| part.norm());
    let per_newton = |value: f64| (z > NO_FORCE * x.hypot(y)).then_some(value);
    EndReaction {
        side_force_n_per_n: per_newton(reaction.side_force()),
        tilting_couple_m: per_newton(reaction.tilting_couple()),
        axis_couple_m: per_newton(reaction.axis_couple()),
    }
}
