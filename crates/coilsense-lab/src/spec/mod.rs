//! TOML specs: the one input model of command, sweeps and page.
//!
//! A spec names a spring, its mount, conditions of use, sensors and a goal; [`Spec`] holds all of it checked, in SI, in the science's types.
//! Next door: the units in its strings (`quantity`), what is computed from it (`analysis`).
//!
//! [`Spec`]: crate::spec::Spec

mod beside;
mod cam;
mod catalogue;
mod condition;
mod contact;
mod control;
mod document;
mod draft;
mod drive;
mod ends;
mod experiment;
mod former;
mod goal;
mod heading;
mod inductance;
mod keys;
mod material;
mod measurand;
mod mount;
mod on_coil;
mod recorded;
mod recordings;
mod replaced;
mod rig;
mod run;
#[cfg(feature = "reference")]
mod schema;
mod section;
mod sections;
mod sensor;
mod setting;
mod size;
mod spline;
mod spring;
mod spring_table;
mod strength;
mod synonyms;
mod template;
mod tolerance;
mod value;

pub use beside::{Beside, Side};
pub use cam::{CamSpec, Rows as CamRows};
pub use catalogue::{
    PermeabilityFound, Row, USUAL_MATERIAL, classes, material_rows, materials, named_materials, sensor_rows,
};
pub use coilsense::sensors::Quantity;
pub use condition::{ConditionSpec, KINDS as CONDITION_KINDS};
pub use contact::ContactCase;
pub(crate) use contact::why_not as why_no_contact;
pub use control::ControlSpec;
pub use document::SPEC_VERSION;
pub use ends::EndsSpec;
pub use experiment::ExperimentSpec;
pub use goal::{Goal, UncertaintySpec};
pub(crate) use inductance::STAINLESS;
pub use inductance::{Magnetised, SpringInductance};
pub use keys::{EXPERIMENT_TABLES, Key, TABLES, Table};
#[cfg(feature = "reference")]
pub use keys::{experiment_markdown, markdown};
pub use measurand::KINDS as SENSOR_KINDS;
pub use mount::{BAND, DampingCase, MountSpec};
pub use rig::RigSpec;
pub use run::{RunKind, RunSpec};
#[cfg(feature = "reference")]
pub use schema::{experiment_file_schema, spec_schema};
pub use sections::DeadEnds;
pub use sensor::SensorSpec;
pub use spring::{Model, SpringSpec};
pub use strength::StrengthSpec;
pub use template::template;
pub(crate) use tolerance::DIMENSIONS as TOLERANCE_DIMENSIONS;
pub use tolerance::{Departure, Tolerances};

use std::fmt::Display;
use std::io::Read;
use std::path::Path;
use std::sync::Arc;

pub(crate) use draft::{Core, Draft, Place};
pub(crate) use keys::Domain;
pub use recordings::Recordings;
pub(crate) use replaced::replaced;

/// Reads the text of a file that a spec names, by the name it has there; the error says why it cannot be.
pub type Files<'a> = dyn Fn(&str) -> Result<String, String> + 'a;

/// A spec: a spring, or several between the same ends, how it is mounted, what is done to it, what watches it, and what that should achieve.
#[derive(Debug, Clone, PartialEq)]
pub struct Spec {
    /// The file's name, as messages call it.
    pub file: String,
    /// Its text.
    pub text: String,
    /// The spring.
    pub spring: SpringSpec,
    /// What end 2 is tied to, under each damping.
    pub mount: MountSpec,
    /// The conditions of use; may be empty.
    pub conditions: Vec<ConditionSpec>,
    /// The sensors; may be empty.
    pub sensors: Vec<SensorSpec>,
    /// The goal.
    pub goal: Goal,
    /// What the uncertainty budget assumes.
    pub uncertainty: UncertaintySpec,
    /// The virtual rig: the paper's, where the spec says nothing.
    pub rig: RigSpec,
    /// The force loop, where there is one.
    pub control: Option<ControlSpec>,
    /// What the wire bears in fatigue, where the spec says it.
    pub strength: Option<StrengthSpec>,
    /// Springs between the same ends, each as it undergoes what is done to the first.
    pub beside: Vec<Beside>,
    /// What moves end 1 in `coilsense speed`, where the spec has a cam.
    pub cam: Option<CamSpec>,
    /// What the file calls as it was called before, a sentence each.
    pub notes: Vec<String>,
}

impl Spec {
    /// Reads a spec from its text; `file` names it in errors, `files` reads those that it names.
    ///
    /// # Errors
    /// [`SpecError`], one line with file, line, key, value and what is allowed.
    pub fn parse(file: &str, text: &str, files: &Files<'_>) -> Result<Self, SpecError> {
        Draft::parse(file, text)?.spec(files)
    }

    /// The same for who reads one spec after another: a recorded file is parsed once, whichever spec names it first.
    ///
    /// # Errors
    /// As [`Self::parse`].
    pub fn parse_sharing(
        file: &str,
        text: &str,
        files: &Files<'_>,
        recordings: &Arc<Recordings>,
    ) -> Result<Self, SpecError> {
        Draft::parse(file, text)?.sharing(recordings).spec(files)
    }

    /// Reads a spec from a file; files that it names are looked for beside it.
    ///
    /// # Errors
    /// [`SpecError`] as [`Self::parse`], or where the file cannot be read.
    pub fn read(path: &Path) -> Result<Self, SpecError> {
        Self::parse(&path.display().to_string(), &read_text(path)?, &files_beside(path))
    }

    /// All springs, the first first.
    pub fn springs(&self) -> impl Iterator<Item = &SpringSpec> {
        [&self.spring].into_iter().chain(self.beside.iter().map(|beside| &beside.spring))
    }

    /// The spec of each of its springs by itself, with which way that acts; the first comes first.
    pub fn each(&self) -> Vec<(Side, Self)> {
        let first = Self { beside: Vec::new(), ..self.clone() };
        let other = |it: &Beside| {
            let (spring, mount, conditions) = (it.spring.clone(), it.mount.clone(), it.conditions.clone());
            (it.side, Self { spring, mount, conditions, ..first.clone() })
        };
        let others: Vec<_> = self.beside.iter().map(other).collect();
        [(Side::Same, first)].into_iter().chain(others).collect()
    }

    /// Refuses several springs, for what is computed of one only: `what` it is, in a word or two.
    ///
    /// # Errors
    /// [`SpecError`] with what takes them.
    pub fn needs_one_spring(&self, what: &str) -> Result<(), SpecError> {
        // A build that reads one spring need not carry the words.
        let Some(second) = self.beside.first().filter(|_| cfg!(feature = "several-springs")) else { return Ok(()) };
        let why = "takes one spring; several between the same ends are for simulate and sweep";
        Err(SpecError(format!("{}: [[spring]] {:?}: {what} {why}", self.file, second.spring.name)))
    }

    /// Refuses windings that meet, for what is computed without contact only: `what` it is, in a word or two.
    ///
    /// # Errors
    /// [`SpecError`] with what takes them.
    pub fn needs_no_contact(&self, what: &str) -> Result<(), SpecError> {
        self.mount.needs_no_contact(&self.file, what)
    }

    /// Refuses the model that is a helix, and several springs, for what is computed on one chain only: `what` it is, in a word or two.
    ///
    /// # Errors
    /// [`SpecError`] with what takes the helix.
    pub fn needs_chain(&self, what: &str) -> Result<(), SpecError> {
        self.needs_one_spring(what)?;
        self.spring.needs_chain(&self.file, what)
    }
}

/// Reads files that lie beside a spec.
pub(crate) fn files_beside(spec: &Path) -> impl Fn(&str) -> Result<String, String> + use<> {
    let beside = spec.parent().unwrap_or(Path::new("")).to_owned();
    move |name: &str| {
        let path = beside.join(name);
        bounded(&path, MOST_RECORDED).map_err(|error| format!("{} cannot be read: {error}", path.display()))
    }
}

/// Most bytes of a spec, which a person writes, and of a recorded file: an hour at 10 kHz.
const MOST_WRITTEN: u64 = 1 << 20;
const MOST_RECORDED: u64 = 1 << 30;

/// The text of a spec file, or why it cannot be had.
pub(crate) fn read_text(path: &Path) -> Result<String, SpecError> {
    bounded(path, MOST_WRITTEN).map_err(|error| SpecError(format!("{}: cannot be read: {error}", path.display())))
}

/// The text of a file of at most so many bytes: a wrong name may be that of a disk image, or of a device that never ends.
pub(crate) fn bounded(path: &Path, most: u64) -> Result<String, String> {
    let mut text = String::new();
    let file = crate::input::open(path).map_err(|error| error.to_string())?;
    let read = file.take(most + 1).read_to_string(&mut text).map_err(|error| error.to_string())?;
    if read as u64 > most { Err(format!("it is larger than {} MiB", most >> 20)) } else { Ok(text) }
}

/// A name as part of a file's: lower case letters, digits and hyphens.
fn stem(name: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() || c == '.' || c == '_' { c } else { '-' };
    name.to_lowercase().chars().map(plain).collect()
}

/// Why a spec cannot be used, in one line that names file, line, key, value and what is allowed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct SpecError(String);

impl SpecError {
    /// A value that is fine by itself but not for the use at hand: `file: key = value: must be allowed`.
    pub(crate) fn unsuitable(file: &Path, key: &str, value: impl Display, allowed: impl Display) -> Self {
        Self(format!("{}: {key} = {value}: must be {allowed}", file.display()))
    }

    /// The same with one more thing that is allowed.
    fn or_also(self, allowed: &str) -> Self {
        Self(format!("{}, or {allowed}", self.0))
    }
}

/// A number as part of a name: its digits, or with an exponent where they would be many.
fn plain(value: f64) -> String {
    if value == 0.0 || (1e-6..1e7).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}

/// `file:line: text`.
fn located(file: &str, text: &str, offset: usize, message: impl Display) -> SpecError {
    let line = 1 + text.as_bytes().iter().take(offset).filter(|&&byte| byte == b'\n').count();
    SpecError(format!("{file}:{line}: {message}"))
}
