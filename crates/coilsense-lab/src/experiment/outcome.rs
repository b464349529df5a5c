//! An experiment processed.
//!
//! Next door: its description (`crate::spec::ExperimentSpec`), what it says (`findings`, `answer`).

use std::path::Path;

use coilsense::Channel;
use rayon::prelude::*;

use super::spring::AtRest;
use super::{Curve, ExperimentError, Fast, Mean, Slow, SpringLine};
use crate::recording::{Account, Cleaning, Mapping};
use crate::spec::{ExperimentSpec, RunKind, RunSpec};

/// What an experiment's logs say.
#[derive(Debug, Clone, PartialEq)]
pub struct Experiment {
    /// Its description.
    pub spec: ExperimentSpec,
    /// Stiffness and offset.
    pub line: SpringLine,
    /// From inductance to length; none where nothing tells it, and then there is no F_L.
    pub curve: Option<Curve>,
    /// Preloads and sines, as they were recorded.
    pub runs: Vec<Run>,
    /// F̄_x of the first preload \[N\], against which all means are taken.
    pub reference: f64,
    /// Runs of hits, which play no part here.
    pub hits: usize,
    /// Whether description or a log says that it is simulated.
    pub simulated: bool,
    /// What became of the rows of those logs in which something was cleaned, as they are listed.
    pub cleaned: Vec<Account>,
}

/// A preload or a sine.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Its description.
    pub spec: RunSpec,
    /// Load cell and position.
    pub fast: Fast,
    /// Mean of F_L; none without readings or a curve.
    pub inductance: Option<Mean>,
    /// Readings of the LCR meter.
    pub readings: usize,
}

impl Run {
    /// The mean of one of the forces.
    pub fn mean(&self, force: Channel) -> Option<Mean> {
        match force {
            Channel::OutputForce => Some(self.fast.output),
            Channel::DeflectionForce => Some(self.fast.deflection),
            Channel::InductanceForce => self.inductance,
            _ => None,
        }
    }
}

/// A run's logs.
type Logs = (RunSpec, Fast, Option<Slow>);

impl Experiment {
    /// Reads the logs of an experiment and works them off.
    ///
    /// - `cleaning`: what may be cleaned in each of them; a window of time has no meaning for logs of many clocks, and is not looked at
    ///
    /// # Errors
    /// [`ExperimentError`] that names file, row and column; and a sine that does not move at the frequency that its run states.
    pub fn new(spec: ExperimentSpec, cleaning: &Cleaning) -> Result<Self, ExperimentError> {
        let cleaning = &Cleaning { from: None, to: None, ..*cleaning };
        let mapping =
            |path: &Option<_>| path.as_deref().map_or(Ok(Mapping::default()), |path: &Path| Mapping::read(path));
        let (fast, slow) = (mapping(&spec.fast_mapping)?, mapping(&spec.slow_mapping)?);
        let at_rest = AtRest::read(&spec, &slow, cleaning)?;
        let line = SpringLine::of(&spec, &at_rest)?;
        let wanted = |run: &&RunSpec| matches!(run.kind, RunKind::Preload | RunKind::Harmonic);
        let described: Vec<&RunSpec> = spec.runs.iter().filter(wanted).collect();
        let read = |run: &&RunSpec| -> Result<Option<Logs>, ExperimentError> {
            let slow = Slow::read(run, &slow, cleaning)?;
            Ok(Fast::read(run, &fast, &line, cleaning)?.map(|fast| ((*run).clone(), fast, slow)))
        };
        let logs: Vec<Option<Logs>> = described.par_iter().map(read).collect::<Result<_, _>>()?;
        let logs: Vec<Logs> = logs.into_iter().flatten().collect();
        let curve = Curve::of(&spec, &line, &at_rest, preload(&logs, &line))?;
        let simulated = spec.simulated
            || at_rest.simulated
            || logs.iter().any(|(_, fast, slow)| fast.simulated || slow.as_ref().is_some_and(|slow| slow.simulated));
        let of_runs =
            logs.iter().flat_map(|(_, fast, slow)| [Some(&fast.account), slow.as_ref().map(|slow| &slow.account)]);
        let accounts = at_rest.accounts.iter().chain(of_runs.flatten());
        let cleaned = accounts.filter(|account| account.cleaning().is_some()).cloned().collect();
        let runs = logs.into_iter().map(|(run, fast, slow)| {
            let force = slow.as_ref().zip(curve.as_ref()).map(|(slow, curve)| slow.force(&run, curve, &line));
            let readings = slow.map_or(0, |slow| slow.inductances.len());
            Ok(Run { spec: run, fast, inductance: force.transpose()?, readings })
        });
        let runs: Vec<Run> = runs.collect::<Result<_, ExperimentError>>()?;
        let first = runs.iter().find(|run| run.spec.kind == RunKind::Preload);
        let reference = first.map_or(0.0, |run| run.fast.deflection.mean);
        let hits = spec.runs.iter().filter(|run| run.kind == RunKind::Hit).count();
        let experiment = Self { line, curve, runs, reference, hits, simulated, cleaned, spec };
        experiment.check_frequencies()?;
        Ok(experiment)
    }

    /// Reads `experiment.toml` of a folder, and works it off.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn read(folder: &Path, cleaning: &Cleaning) -> Result<Self, ExperimentError> {
        Self::new(ExperimentSpec::read(&folder.join("experiment.toml"))?, cleaning)
    }

    /// Runs with a sine, as they were recorded.
    pub fn harmonics(&self) -> impl Iterator<Item = (usize, &Run)> {
        self.runs.iter().enumerate().filter(|(_, run)| run.spec.kind == RunKind::Harmonic)
    }

    /// A mean of a run less the preload's by deflection \[N\].
    pub fn difference(&self, run: &Run, force: Channel) -> Option<f64> {
        run.mean(force).map(|mean| mean.mean - self.reference)
    }

    /// A force as a share of F_nom, in percent.
    pub fn percent(&self, newton: f64) -> f64 {
        100.0 * newton / self.spec.nominal_force
    }
}

/// Length and inductance of the first preload that has both.
fn preload(logs: &[Logs], line: &SpringLine) -> Option<(f64, f64)> {
    logs.iter().find_map(|(run, fast, slow)| {
        let slow = slow.as_ref().filter(|_| run.kind == RunKind::Preload)?;
        // By its force where the log has no position: the same line turned round.
        let by_force = line.length_at_zero_force + fast.deflection.mean / line.stiffness;
        let length = fast.displacement.map_or(by_force, |displacement| line.length(displacement));
        Some((length, slow.mean_inductance()))
    })
}
