//! A virtual rig: the experiment of the paper's section IV, as the files that a real one would write.
//!
//! ```text
//! Spec + seed ─► Rig ─► Run by run: Course (what moves) ─► Devices (what they read) ─► Log ─► CSV files, experiment.toml
//! ```
//!
//! Next door: what a spec says of it (`spec::RigSpec`), the science of what moves (`coilsense`), who reads the files (`experiment`).

mod checks;
mod clearance;
mod course;
mod description;
mod devices;
mod log;
mod meter;
mod plan;
mod sheet;
mod write;

pub use log::Log;
pub use plan::{Kind, Run};
pub use sheet::{Column, Sheet};

use coilsense::relaxation::Relaxation;
use coilsense::{Error, Mount, Spring};
use rand_pcg::Pcg64;

use crate::output::OutputError;
use crate::spec::{RigSpec, Spec, SpecError, SpringInductance};
use devices::Devices;

/// A rig with a spring in it, ready to run.
#[derive(Debug, Clone)]
pub struct Rig {
    settings: RigSpec,
    /// The spec's file and the spring's name, as messages and headers call them.
    file: String,
    spring_name: String,
    damping: String,
    spring: Spring,
    /// Neighbouring windings touch at this pitch \[m\].
    contact_pitch: f64,
    mount: Mount,
    coil: SpringInductance,
    relaxation: Relaxation,
    /// Length under the preload \[m\].
    length: f64,
    seed: u64,
    devices: Devices,
    runs: Vec<Run>,
    warnings: Vec<String>,
}

/// Why a rig cannot run.
#[derive(Debug, thiserror::Error)]
pub enum RigError {
    /// The spec asks for what cannot be.
    #[error("{file}: {message}")]
    Refused {
        /// The spec.
        file: String,
        /// Which key or quantity, its value, and what is allowed.
        message: String,
    },
    /// The science takes something not as it is.
    #[error("{file}: {place}: {reason}")]
    Science {
        /// The spec.
        file: String,
        /// Which part of the rig.
        place: String,
        /// What is wrong.
        reason: Box<Error>,
    },
    /// The spec's model is none for this.
    #[error(transparent)]
    Model(#[from] SpecError),
    /// The files cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Somebody stopped it.
    #[error("interrupted; nothing was written")]
    Interrupted,
}

impl Rig {
    /// The rig that a spec describes. The same seed gives the same numbers.
    ///
    /// # Errors
    /// [`RigError`] for a mount that is not held or has not one damping, and for settings that do not fit spring, instruments or each other.
    pub fn new(spec: &Spec, seed: u64) -> Result<Self, RigError> {
        spec.needs_chain("a rig")?;
        spec.needs_no_contact("a rig")?;
        let damping = checks::damping(spec)?;
        let (settings, spring) = (spec.rig.clone(), spec.spring.spring.clone());
        let science = |place: &str| {
            let (file, place) = (spec.file.clone(), place.to_owned());
            move |reason| RigError::Science { file, place, reason: Box::new(reason) }
        };
        let length = spring.rest_length() + settings.preload / spring.stiffness();
        let mut rig = Self {
            file: spec.file.clone(),
            spring_name: spec.spring.name.clone(),
            damping: damping.label.clone(),
            contact_pitch: spec.spring.contact_pitch(),
            mount: damping.mount.clone(),
            coil: SpringInductance::of(&spec.spring).map_err(science("[spring]"))?,
            relaxation: Relaxation::new(settings.relaxation, settings.settling).map_err(science("[rig] relaxation"))?,
            length,
            seed,
            devices: Devices::new(&settings, &mut stream(seed, 0)).map_err(science("instruments of the rig"))?,
            runs: plan::of(&settings),
            warnings: Vec::new(),
            settings,
            spring,
        };
        rig.check()?;
        let left_out = spec.spring.magnetisation_left_out().into_iter().collect();
        rig.warnings = [spec.notes.clone(), rig.doubts(), left_out].concat();
        Ok(rig)
    }

    /// What is run, in the order in which it is recorded.
    pub fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// Length under the preload \[m\], at which u1 is zero.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// What a reader must know before using the files.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    fn refused(&self, message: impl Into<String>) -> RigError {
        RigError::Refused { file: self.file.clone(), message: message.into() }
    }

    fn science(&self, place: &str) -> impl FnOnce(Error) -> RigError + use<> {
        let (file, place) = (self.file.clone(), place.to_owned());
        move |reason| RigError::Science { file, place, reason: Box::new(reason) }
    }

    /// The randomness of a run, by its number in [`Self::runs`].
    fn randomness(&self, run: usize) -> Pcg64 {
        stream(self.seed, run as u64 + 1)
    }
}

/// One of the independent streams of random numbers of a seed: the instruments' is 0, then come the runs'.
fn stream(seed: u64, number: u64) -> Pcg64 {
    Pcg64::new(u128::from(seed), u128::from(number))
}
