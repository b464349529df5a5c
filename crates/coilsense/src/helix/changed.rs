//! The motion of a helix whose wire differs by its moduli and its density only: what tolerances make of one that was found.
//!
//! Next door: the helix that was found (`surge`).

use super::mounted::moved;
use super::reaction_series::{Felt, ReactionSeries};
use super::surge::Surge;
use crate::error::{Error, above_zero};
use crate::excitation::Excitation;
use crate::modes::ModalModel;
use crate::motion::Motion;
use crate::mount::Mount;
use crate::spring::{Spring, SpringParameters};

impl Surge {
    /// The axial motion of the same helix with its moduli and its density multiplied, its shape kept: what a tolerance of stiffness and mass
    /// makes of it. All forces are multiplied by `stiffness`, all frequencies by `frequency`.
    ///
    /// Source:   similarity: E, G and the load in one proportion, ρ by `stiffness/frequency²`.
    /// Accuracy: that of a helix of such a wire to 1e-9 (`tests/helix`).
    ///
    /// # Errors
    /// [`Error::Value`] for a factor that is not above zero.
    pub fn changed(&self, stiffness: f64, frequency: f64) -> Result<ChangedSurge, Error> {
        above_zero("stiffness", stiffness, "")?;
        above_zero("frequency", frequency, "")?;
        let parameters = self.spring.parameters();
        let spring = Spring::new(SpringParameters {
            stiffness: stiffness * parameters.stiffness,
            mass: stiffness * parameters.mass / (frequency * frequency),
            ..parameters.clone()
        })?
        .with_masses_per_winding(self.spring.masses_per_winding())?;
        // The model is a wire's: it was made as one.
        let model = self.model.of_changed_wire(stiffness, frequency).unwrap_or_else(|| self.model.clone());
        let felt = self.felt().changed(stiffness, frequency);
        Ok(ChangedSurge { spring, model, felt, length: self.length })
    }
}

/// Modes of a helix whose moduli and density were multiplied.
#[derive(Debug, Clone)]
pub struct ChangedSurge {
    spring: Spring,
    model: ModalModel,
    felt: Felt,
    length: f64,
}

impl ChangedSurge {
    /// The spring with the straight line that its force follows about the helix's length, as [`Surge::spring`].
    pub fn spring(&self) -> &Spring {
        &self.spring
    }

    /// As [`Surge::motion`].
    ///
    /// # Errors
    /// As there.
    pub fn motion(&self, mount: &Mount, excitation: &Excitation) -> Result<Motion, Error> {
        moved(&self.spring, &self.model, self.length, mount, excitation)
    }

    /// As [`Surge::reactions`].
    ///
    /// # Errors
    /// As there.
    pub fn reactions(&self, motion: &Motion, times: &[f64]) -> Result<[ReactionSeries; 2], Error> {
        self.felt.reactions(&self.model, motion, times)
    }
}
