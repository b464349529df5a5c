//! How near the windings of a plant are to each other.
//!
//! Next door: where its modes are (`plant`), what the windings' inductance says (`plant_coil`).

use crate::plant::{Plant, PlantState};
use crate::real::Real;

/// The distances between windings of a spring in `MODES` modes, at `GAPS` places along it: plain numbers that the host finds, in the
/// precision of the plant's steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlantWindings<T, const MODES: usize, const GAPS: usize> {
    /// The distance between the ends where all inputs are zero \[m\].
    pub mean_length: f64,
    /// Which share of that distance is between neighbouring windings of a spring that moves slowly \[1\].
    pub share: f64,
    /// At this distance windings touch \[m\], centre to centre.
    pub contact_pitch: f64,
    /// How much each distance grows per q of each mode \[1\].
    pub gaps: [[T; MODES]; GAPS],
}

impl<T: Real, const MODES: usize, const GAPS: usize> PlantWindings<T, MODES, GAPS> {
    /// The smallest distance between neighbouring windings \[m\] of a state, centre to centre; below [`Self::contact_pitch`] they would have met,
    /// and the plant, whose windings pass through one another, is no longer the spring.
    ///
    /// min_i (s·l + Σ_j g_ij q_j)
    ///
    /// Source:   geometry; a point and that one turn further, as `coilsense::Clash`.
    /// Valid:    as [`Plant`]; at samples: between two of them windings may come nearer.
    /// Accuracy: that of q; 1e-9 of the range of that distance in `f64` with all modes, 1e-4 in `f32` (`coilsense`, `tests/plant`).
    #[inline]
    pub fn closest_pitch(&self, plant: &Plant<T, MODES>, state: &PlantState<T, MODES>) -> T {
        let even = T::nearest(self.share) * (T::nearest(self.mean_length) + plant.longer(state));
        let mut least = T::LARGEST;
        for gap in &self.gaps {
            let grown = state.sum(gap);
            if grown < least {
                least = grown;
            }
        }
        even + least
    }
}
