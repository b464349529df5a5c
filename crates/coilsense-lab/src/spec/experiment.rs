//! `experiment.toml`: which logs an experiment has, and what is known of its spring.
//!
//! Next door: its runs (`run`), its keys (`keys`), reading the logs and working them off (`crate::experiment`).

use std::path::{Path, PathBuf};

use toml::de::DeValue;

use super::document::Document;
use super::{RunKind, RunSpec, SpecError, read_text};
use crate::quantity::Dimension;

/// An experiment as its file describes it, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct ExperimentSpec {
    /// The file, as messages call it.
    pub file: String,
    /// What people call the experiment.
    pub name: Option<String>,
    /// Whether the file says that no rig made the logs.
    pub simulated: bool,
    /// F_nom \[N\].
    pub nominal_force: f64,
    /// l0 \[m\].
    pub length_at_zero_force: f64,
    /// Over which the LCR meter averages \[s\].
    pub averaging: Option<f64>,
    /// k \[N/m\].
    pub stiffness: Option<f64>,
    /// Length of the coil where positions read zero \[m\].
    pub length_at_zero: Option<f64>,
    /// α \[1/(H m)\] and β \[1/m\].
    pub inverse_length: Option<(f64, f64)>,
    /// The file of a stored calibration, in place of that.
    pub calibration: Option<PathBuf>,
    /// Mapping file of the fast logs.
    pub fast_mapping: Option<PathBuf>,
    /// Mapping file of the slow logs.
    pub slow_mapping: Option<PathBuf>,
    /// The runs, as they were recorded.
    pub runs: Vec<RunSpec>,
    /// What the file calls as it was called before, a sentence each.
    pub notes: Vec<String>,
}

/// Most runs of an experiment.
const MOST_RUNS: usize = 200;

impl ExperimentSpec {
    /// Reads the file of an experiment; the logs that it names are looked for beside it.
    ///
    /// # Errors
    /// [`SpecError`], one line with file, line, key, value and what is allowed.
    pub fn read(path: &Path) -> Result<Self, SpecError> {
        let beside = path.parent().unwrap_or(Path::new("")).to_owned();
        Self::parse(&path.display().to_string(), &read_text(path)?, &beside)
    }

    /// Reads it from its text; `file` names it in errors, `beside` is the folder of the logs.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn parse(file: &str, text: &str, beside: &Path) -> Result<Self, SpecError> {
        let document = Document::experiment(file, text)?;
        let root = document.root();
        let positive = |key, dimension| root.above_zero(key, dimension);
        let inverse_length = match document.optional_section("inverse_length")? {
            None => None,
            Some(section) => {
                let (alpha, beta) = (section.number("alpha")?, section.number("beta")?);
                section.check("alpha", alpha.is_finite() && alpha != 0.0, alpha, "finite and not zero")?;
                Some((alpha, section.check("beta", beta.is_finite(), beta, "finite")?))
            }
        };
        let sections = document.sections("run")?;
        let runs = sections.iter().enumerate().map(|(index, section)| RunSpec::of(section, index, beside));
        let path =
            |key| -> Result<Option<PathBuf>, SpecError> { Ok(root.optional_text(key)?.map(|name| beside.join(name))) };
        let spec = Self {
            file: file.to_owned(),
            name: root.optional_text("name")?,
            simulated: root.read("simulated", boolean, || "true or false".to_owned())?.unwrap_or(false),
            nominal_force: root.positive("nominal_force", Dimension::Force)?,
            length_at_zero_force: root.positive("length_at_zero_force", Dimension::Length)?,
            averaging: positive("averaging", Dimension::Time)?,
            stiffness: positive("stiffness", Dimension::Stiffness)?,
            length_at_zero: positive("length_at_zero", Dimension::Length)?,
            inverse_length,
            calibration: path("calibration")?,
            fast_mapping: path("fast_mapping")?,
            slow_mapping: path("slow_mapping")?,
            runs: runs.collect::<Result<_, _>>()?,
            notes: document.notes().to_vec(),
        };
        spec.check()?;
        Ok(spec)
    }

    /// Whether what the runs do not tell is given.
    fn check(&self) -> Result<(), SpecError> {
        let refuse = |message: String| Err(SpecError(format!("{}: {message}", self.file)));
        if self.runs.len() > MOST_RUNS {
            return refuse(format!("at most {MOST_RUNS} tables [[run]] are allowed, got {}", self.runs.len()));
        }
        if !self.has(RunKind::Preload) {
            return refuse("no [[run]] has kind = \"preload\", against which all others are compared".to_owned());
        }
        if self.calibration.is_some() && self.inverse_length.is_some() {
            return refuse(
                "calibration and [inverse_length] both say what length an inductance is; give one".to_owned(),
            );
        }
        if self.has(RunKind::Calibration) {
            return Ok(());
        }
        let missing = [("stiffness", self.stiffness), ("length_at_zero", self.length_at_zero)];
        match missing.into_iter().find(|(_, value)| value.is_none()) {
            Some((key, _)) => {
                refuse(format!("{key} is not given, and no [[run]] has kind = \"calibration\" to take it from"))
            }
            None => Ok(()),
        }
    }

    /// Whether there is a run of a kind.
    pub fn has(&self, kind: RunKind) -> bool {
        self.runs.iter().any(|run| run.kind == kind)
    }
}

fn boolean(value: &DeValue<'_>) -> Option<bool> {
    value.as_bool()
}
