//! A run's log of the LCR meter: means of the inductance.
//!
//! Next door: load cell and position (`fast`), from L to a length (`spring`).

use coilsense::Channel;

use super::{Curve, ExperimentError, Mean, SpringLine};
use crate::recording::{Account, Cleaning, Mapping, Points};
use crate::spec::RunSpec;

/// What a run's LCR meter says.
#[derive(Debug, Clone, PartialEq)]
pub struct Slow {
    /// L of each reading \[H\].
    pub inductances: Vec<f64>,
    /// Whether the log says that it is simulated.
    pub simulated: bool,
    /// What became of the log's rows.
    pub account: Account,
}

impl Slow {
    /// Reads the log of a run.
    pub(super) fn read(run: &RunSpec, mapping: &Mapping, cleaning: &Cleaning) -> Result<Option<Self>, ExperimentError> {
        let Some(path) = run.slow.as_deref() else { return Ok(None) };
        let log = Points::read(path, mapping, cleaning)?;
        let inductances = log.channel(Channel::Inductance)?.to_vec();
        let simulated = log.simulated().is_some();
        Ok(Some(Self { inductances, simulated, account: log.account().clone() }))
    }

    /// Mean of L \[H\].
    pub fn mean_inductance(&self) -> f64 {
        self.inductances.iter().sum::<f64>() / self.inductances.len() as f64
    }

    /// Mean of the force that each reading gives.
    pub(super) fn force(&self, run: &RunSpec, curve: &Curve, line: &SpringLine) -> Result<Mean, ExperimentError> {
        let mut lengths = Vec::with_capacity(self.inductances.len());
        for (number, &inductance) in (1..).zip(&self.inductances) {
            let path = || run.slow.as_deref().unwrap_or(std::path::Path::new(""));
            let refused = |why: String| ExperimentError::of(path(), format!("reading {number}: {why}"));
            lengths.push(curve.length(inductance).map_err(refused)?);
        }
        let forces: Vec<f64> = lengths.into_iter().map(|length| line.force(length)).collect();
        Ok(Mean::of(&forces))
    }
}
