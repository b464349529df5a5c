//! The tables `[goal]` and `[uncertainty]`: what the force signal should achieve, and what the uncertainty budget assumes.
//!
//! Next door: the instruments (`sensor`).

use coilsense::Channel;

use super::SpecError;
use super::document::Document;
use crate::quantity::Dimension;

/// What the force signal should achieve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Goal {
    /// Largest standard uncertainty wanted \[N\]; `None` where the spec has no goal.
    pub error: Option<f64>,
    /// Up to which frequency \[Hz\]; `None` where errors of every frequency count.
    pub bandwidth: Option<f64>,
    /// The force that counts as true.
    pub force: Channel,
}

/// What the uncertainty budget assumes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UncertaintySpec {
    /// Change of temperature since the calibration \[K\], either way.
    pub temperature_change: f64,
    /// Coverage probability of the expanded uncertainty \[1\].
    pub coverage: f64,
    /// Trials of the Monte Carlo.
    pub trials: usize,
    /// Seed of the Monte Carlo and of sensor noise.
    pub seed: u64,
}

/// Assumptions where the spec says nothing.
const UNSAID: UncertaintySpec = UncertaintySpec { temperature_change: 10.0, coverage: 0.95, trials: 100_000, seed: 1 };

impl Goal {
    /// Reads it; a share is of `nominal_force` \[N\].
    pub(super) fn parse(document: &Document<'_>, nominal_force: f64) -> Result<Self, SpecError> {
        let Some(section) = document.optional_section("goal")? else {
            return Ok(Self { error: None, bandwidth: None, force: Channel::DeflectionForce });
        };
        let (dimension, value) = section.any_quantity("error", &[Dimension::Force, Dimension::Share])?;
        section.check("error", value.is_finite() && value > 0.0, value, "above zero and finite")?;
        section.check("error", value <= 1e9, value, "at most 1e9 N")?;
        let error = if dimension == Dimension::Share { value * nominal_force } else { value };
        let forces = [Channel::DeflectionForce, Channel::InputForce, Channel::OutputForce];
        let word = section.optional_word("force", &forces.map(Channel::name))?;
        let force = forces.into_iter().find(|channel| Some(channel.name()) == word).unwrap_or(forces[0]);
        Ok(Self { error: Some(error), bandwidth: section.above_zero("bandwidth", Dimension::Frequency)?, force })
    }
}

impl UncertaintySpec {
    pub(super) fn parse(document: &Document<'_>) -> Result<Self, SpecError> {
        let Some(section) = document.optional_section("uncertainty")? else {
            return Ok(UNSAID);
        };
        let coverage = section.optional_quantity("coverage", Dimension::Share)?.unwrap_or(UNSAID.coverage);
        section.check("coverage", (0.5..=0.9999).contains(&coverage), coverage, "from 50 % to 99.99 %")?;
        let trials = section.optional_whole("trials", 1000, 10_000_000)?;
        Ok(Self {
            temperature_change: section
                .optional_quantity("temperature_change", Dimension::Temperature)?
                .map(|kelvin| {
                    section.check("temperature_change", (0.0..=1000.0).contains(&kelvin), kelvin, "from 0 to 1000 K")
                })
                .transpose()?
                .unwrap_or(UNSAID.temperature_change),
            coverage,
            trials: trials.map_or(UNSAID.trials, |trials| trials as usize),
            seed: section.optional_whole("seed", 0, u64::MAX)?.unwrap_or(UNSAID.seed),
        })
    }
}
