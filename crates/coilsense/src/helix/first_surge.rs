//! The first surge of a helix, without looking for all that lies below it.
//!
//! Next door: all modes (`modes`), one with its shape (`mode`).

use super::mode::Mode;
use super::modes::{Modes, beyond};
use crate::error::Error;

/// Where the first surge is looked for, in frequencies of the bar; the second lies at about twice.
const NEAR: (f64, f64) = (0.6, 1.4);
/// Most modes that are looked at there.
const MOST_NEAR: usize = 20;
impl Modes {
    /// First surge frequency \[Hz\]: of the modes near that of a bar, that with the strongest axial line.
    ///
    /// Where axial and other motion mix, two lines share the surge, and this is the stronger one. A coil so slender that more than
    /// twenty modes lie that near is taken for the bar, ½ √(k/m).
    ///
    /// Source:   [`Mode::line_strength`], over 0.6 to 1.4 times ½ √(k/m) with the helix's own slope k.
    /// Valid:    as [`Modes`].
    /// Accuracy: of a slender coil 0.2 %, else that of the modes.
    ///
    /// # Errors
    /// [`Error::Value`] where no piece is short enough for these modes.
    pub fn first_surge(&self) -> Result<f64, Error> {
        let Some(near) = self.roots_between(NEAR.0 * self.bar_frequency, NEAR.1 * self.bar_frequency, MOST_NEAR) else {
            return Ok(self.bar_frequency);
        };
        let chain = self.fine(near.last().map_or(0.0, |(_, root)| *root));
        let shaped = near.into_iter().map(|(index, root)| self.shaped(&chain, root, index));
        let modes: Vec<Mode> =
            shaped.collect::<Option<_>>().ok_or_else(|| beyond("first_surge", self.bar_frequency, "Hz"))?;
        let strongest = modes.iter().max_by(|a, b| a.line_strength().total_cmp(&b.line_strength()));
        Ok(strongest.map_or(self.bar_frequency, Mode::frequency))
    }
}
