//! Where a coil's turns are over a motion, without the windings in between.
//!
//! Next door: the windings (`windings`), what the turns do to each other (`crate::inductance`).

use super::Motion;
use super::placing::Placing;
use crate::error::Error;

impl Motion {
    /// Calls `visit` with all samples, in blocks: their numbers, and how far each turn is from where uniform turns between the ends would be
    /// \[m\], shape `turns × WIDTH`, in which columns behind the last sample mean nothing.
    ///
    /// - `times`: t \[s\], shape `samples`; `places`: of the turns along the coil, 0 at end 1 and 1 at end 2, mirror images of each other
    /// - `carriers`: two nodes of the chain (end 1, masses 1…N, end 2) that carry each turn, with their weights
    ///
    /// # Errors
    /// As [`Self::windings`].
    pub(crate) fn for_each_turns(
        &self,
        times: &[f64],
        places: &[f64],
        carriers: &[[(usize, f64); 2]],
        mut visit: impl FnMut(&[usize], &[f64]),
    ) -> Result<(), Error> {
        let masses = self.placeable()?;
        let ends = self.modes.end_shapes();
        let of_node = |mode: usize, node: usize| match node {
            0 => 0.0,
            node if node > masses => ends[mode],
            node => self.modes.shape_at(mode + 1, node),
        };
        let shape = |mode: usize, turn: usize| {
            let carried = carriers[turn].iter().filter(|(_, weight)| *weight != 0.0);
            carried.map(|&(node, weight)| weight * of_node(mode, node)).sum::<f64>() - places[turn] * ends[mode]
        };
        let mut placing = Placing::new(places.len(), self.modes.count(), self.modes.is_mirrored(), shape);
        self.for_each_block(times, |block| visit(block.samples, placing.displace(&block)))
    }

    /// u2 − u1 \[m\] at each time, shape `samples`.
    ///
    /// # Errors
    /// As [`Self::ends`].
    pub(crate) fn lengths(&self, times: &[f64]) -> Result<Vec<f64>, Error> {
        let [first, mut second] = self.end_positions(times)?;
        second.iter_mut().zip(&first).for_each(|(u2, u1)| *u2 -= u1);
        Ok(second)
    }
}
