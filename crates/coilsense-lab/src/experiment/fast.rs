//! A run's log of load cell and position.
//!
//! Next door: the LCR meter's (`slow`), means (`mean`).

use coilsense::measures::Sinusoid;
use coilsense::{Channel, Deviation};

use super::spring::displacements;
use super::{ExperimentError, Mean, SpringLine};
use crate::recording::{Account, Cleaning, Mapping, Recording};
use crate::spec::RunSpec;

/// What a run's load cell and position sensor say.
#[derive(Debug, Clone, PartialEq)]
pub struct Fast {
    /// F_o − F_x over all whole periods.
    pub deviation: Deviation,
    /// √(RMSD² − mean²): what swings about the mean \[N\].
    pub oscillation: f64,
    /// Mean of F_o.
    pub output: Mean,
    /// Mean of F_x.
    pub deflection: Mean,
    /// Mean displacement \[m\]; none where the log has F_x itself.
    pub displacement: Option<f64>,
    /// The line that a sine's F_x mostly is; none at rest, without a clear line, or on an uneven clock.
    pub moves: Option<Sinusoid>,
    /// Samples a second, on the mean \[Hz\].
    pub sample_rate: f64,
    /// How long the log is \[s\].
    pub duration: f64,
    /// Samples behind the last whole period, which are left out.
    pub left_out: usize,
    /// The first half second, as it was recorded.
    pub excerpt: Excerpt,
    /// Whether the log says that it is simulated.
    pub simulated: bool,
    /// What became of the log's rows.
    pub account: Account,
}

/// A piece of the raw forces.
#[derive(Debug, Clone, PartialEq)]
pub struct Excerpt {
    /// From the first sample on \[s\].
    pub time: Vec<f64>,
    /// F_o \[N\].
    pub output: Vec<f64>,
    /// F_x \[N\].
    pub deflection: Vec<f64>,
}

/// How long an excerpt is \[s\].
const EXCERPT: f64 = 0.5;
/// Least length of a block \[s\]: longer than any ringing that passes from one to the next matters.
const BLOCK: f64 = 0.4;

impl Fast {
    /// Reads the log of a run.
    pub(super) fn read(
        run: &RunSpec,
        mapping: &Mapping,
        line: &SpringLine,
        cleaning: &Cleaning,
    ) -> Result<Option<Self>, ExperimentError> {
        let Some(path) = run.fast.as_deref() else { return Ok(None) };
        let log = Recording::read(path, mapping, cleaning)?;
        let time = log.signals().time();
        let output = log.channel(Channel::OutputForce)?;
        let moved = match log.channel(Channel::DeflectionForce) {
            Ok(_) => None,
            Err(_) => Some(displacements(|channel| log.channel(channel))?),
        };
        let deflection: Vec<f64> = match &moved {
            Some(moved) => moved.iter().map(|displacement| line.force(line.length(*displacement))).collect(),
            None => log.channel(Channel::DeflectionForce)?.to_vec(),
        };
        let kept = whole_periods(time, run.frequency).ok_or_else(|| {
            let message =
                format!("must hold at least one period of {} Hz, which is {} s", run.frequency, 1.0 / run.frequency);
            ExperimentError::of(path, message)
        })?;
        let block = if run.frequency > 0.0 { (BLOCK * run.frequency).ceil() / run.frequency } else { BLOCK };
        let part = |values: &[f64]| Mean::in_blocks(&time[..kept], &values[..kept], block);
        let deviation = Deviation::between(&output[..kept], &deflection[..kept]);
        let deviation = deviation.map_err(|error| ExperimentError::of(path, error))?;
        let moves = if run.frequency > 0.0 { Sinusoid::of(time, &deflection).ok().flatten() } else { None };
        let (steps, span) = ((time.len() - 1) as f64, time[time.len() - 1] - time[0]);
        let shown = time.partition_point(|t| *t <= time[0] + EXCERPT);
        Ok(Some(Self {
            deviation,
            oscillation: (deviation.rmsd * deviation.rmsd - deviation.mean * deviation.mean).max(0.0).sqrt(),
            output: part(output),
            deflection: part(&deflection),
            displacement: moved.map(|moved| moved[..kept].iter().sum::<f64>() / kept as f64),
            moves,
            sample_rate: steps / span,
            duration: span * (1.0 + 1.0 / steps),
            left_out: time.len() - kept,
            excerpt: Excerpt {
                time: time[..shown].iter().map(|t| t - time[0]).collect(),
                output: output[..shown].to_vec(),
                deflection: deflection[..shown].to_vec(),
            },
            simulated: log.simulated().is_some(),
            account: log.account().clone(),
        }))
    }
}

/// How many samples lie in whole periods from the first on; all where there is no frequency, none where not one is whole.
fn whole_periods(time: &[f64], frequency: f64) -> Option<usize> {
    let (first, last) = (time.first()?, time.last()?);
    if frequency == 0.0 {
        return Some(time.len());
    }
    // The last sample stands for a step of its own.
    let step = (last - first) / (time.len() - 1).max(1) as f64;
    let periods = ((last - first + step) * frequency + 1e-6).floor();
    let end = first + periods / frequency - 0.5 * step;
    (periods >= 1.0).then(|| time.partition_point(|t| *t < end).max(1))
}

#[cfg(test)]
mod tests {
    use super::whole_periods;

    #[test]
    fn a_record_is_cut_behind_its_last_whole_period() {
        let time: Vec<f64> = (0..1000).map(|index| 5.0 + 1e-3 * f64::from(index)).collect();
        assert_eq!(whole_periods(&time, 0.0), Some(1000));
        assert_eq!(whole_periods(&time, 10.0), Some(1000)); // 10 periods of 100 samples
        assert_eq!(whole_periods(&time, 3.0), Some(1000)); // 3 periods of 333.3 samples
        assert_eq!(whole_periods(&time, 1.5), Some(667)); // one of 666.7
        assert_eq!(whole_periods(&time, 0.9), None);
        assert_eq!(whole_periods(&time[..1], 10.0), None);
    }
}
