//! The spring as an experiment sees it: stiffness and offset, and the curve from inductance to length.
//!
//! Next door: the fits (`coilsense::calibrate`), the logs (`crate::recording`).

use std::path::Path;

use coilsense::Channel;
use coilsense::calibrate::{Calibration, CalibrationPoints, FitMethod, InverseLengthFit, StiffnessFit};

use super::ExperimentError;
use crate::recording::{Account, Cleaning, Mapping, Points};
use crate::spec::{ExperimentSpec, RunKind};
use crate::stored::StoredCalibration;

/// From position to length and force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpringLine {
    /// k \[N/m\].
    pub stiffness: f64,
    /// l0 \[m\].
    pub length_at_zero_force: f64,
    /// Length of the coil where positions read zero \[m\].
    pub length_at_zero: f64,
    /// The fit to the calibration run, where there is one.
    pub fit: Option<StiffnessFit>,
}

/// From inductance to length.
#[derive(Debug, Clone, PartialEq)]
pub enum Curve {
    /// 1/l = αL + β.
    InverseLength {
        /// α and β.
        calibration: Calibration,
        /// How it was found, where it was not given.
        fit: Option<Box<InverseLengthFit>>,
        /// The preload that it goes through: l \[m\] and L \[H\].
        through: Option<(f64, f64)>,
    },
    /// The table of a file.
    Stored(StoredCalibration),
}

/// All positions at rest of the calibration runs.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct AtRest {
    /// How much longer the spring is than where positions read zero \[m\].
    pub displacements: Vec<f64>,
    /// F_o \[N\].
    pub forces: Vec<f64>,
    /// L \[H\]; empty where the logs have none.
    pub inductances: Vec<f64>,
    /// What a log says of being simulated.
    pub simulated: bool,
    /// What became of the logs' rows.
    pub accounts: Vec<Account>,
}

/// u2 − u1 of what a log has, row by row \[m\].
pub(super) fn displacements<'a, E>(channel: impl Fn(Channel) -> Result<&'a [f64], E>) -> Result<Vec<f64>, E> {
    match (channel(Channel::U1), channel(Channel::U2)) {
        (Ok(u1), Ok(u2)) => Ok(u2.iter().zip(u1).map(|(u2, u1)| u2 - u1).collect()),
        (Err(_), Ok(u2)) => Ok(u2.to_vec()),
        (u1, Err(_)) => Ok(u1?.iter().map(|u1| -u1).collect()),
    }
}

impl AtRest {
    /// Reads the calibration runs of an experiment.
    pub(super) fn read(spec: &ExperimentSpec, mapping: &Mapping, cleaning: &Cleaning) -> Result<Self, ExperimentError> {
        let mut all = Self::default();
        let runs = spec.runs.iter().filter(|run| run.kind == RunKind::Calibration);
        let mut without = None;
        for path in runs.filter_map(|run| run.slow.as_deref()) {
            let log = Points::read(path, mapping, cleaning)?;
            all.displacements.extend(displacements(|channel| log.channel(channel))?);
            all.forces.extend(log.channel(Channel::OutputForce)?);
            match log.channel(Channel::Inductance) {
                Ok(henries) => all.inductances.extend(henries),
                Err(error) => without = Some(error),
            }
            all.simulated |= log.simulated().is_some();
            all.accounts.push(log.account().clone());
        }
        // The curve is taken from all of the positions, or given.
        match without.filter(|_| {
            spec.inverse_length.is_none()
                && spec.calibration.is_none()
                && spec.runs.iter().any(|run| run.kind != RunKind::Calibration && run.slow.is_some())
        }) {
            Some(error) => Err(error.into()),
            None => Ok(all),
        }
    }
}

impl SpringLine {
    /// What is given, and the rest from the calibration runs.
    pub(super) fn of(spec: &ExperimentSpec, at_rest: &AtRest) -> Result<Self, ExperimentError> {
        let fit = match at_rest.forces.is_empty() {
            true => None,
            false => Some(StiffnessFit::new(&at_rest.displacements, &at_rest.forces).map_err(refuse(spec))?),
        };
        let l0 = spec.length_at_zero_force;
        let missing =
            |key: &str| ExperimentError::of(Path::new(&spec.file), format!("{key} is neither given nor measured"));
        let stiffness = spec.stiffness.or(fit.map(|fit| fit.stiffness)).ok_or_else(|| missing("stiffness"))?;
        // The line goes through the middle of the measured points with the stiffness in use.
        let count = at_rest.forces.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let measured = fit.map(|_| l0 + mean(&at_rest.forces) / stiffness - mean(&at_rest.displacements));
        let length_at_zero = spec.length_at_zero.or(measured).ok_or_else(|| missing("length_at_zero"))?;
        Ok(Self { stiffness, length_at_zero_force: l0, length_at_zero, fit })
    }

    /// l \[m\] of a displacement \[m\].
    pub fn length(&self, displacement: f64) -> f64 {
        self.length_at_zero + displacement
    }

    /// F \[N\] of a length \[m\].
    pub fn force(&self, length: f64) -> f64 {
        self.stiffness * (length - self.length_at_zero_force)
    }
}

impl Curve {
    /// The curve that is given, or one fitted to the calibration runs through the preload (l_p \[m\], L_p \[H\]), where that has an
    /// inductance; none where nothing tells it.
    pub(super) fn of(
        spec: &ExperimentSpec,
        line: &SpringLine,
        at_rest: &AtRest,
        preload: Option<(f64, f64)>,
    ) -> Result<Option<Self>, ExperimentError> {
        if let Some(path) = &spec.calibration {
            let stored = StoredCalibration::read(path);
            return Ok(Some(Self::Stored(stored.map_err(|error| ExperimentError::of(path, error.message))?)));
        }
        if let Some((alpha, beta)) = spec.inverse_length {
            let calibration = Calibration::new(alpha, beta).map_err(refuse(spec))?;
            return Ok(Some(Self::InverseLength { calibration, fit: None, through: None }));
        }
        if at_rest.inductances.is_empty() {
            return Ok(None);
        }
        let lengths: Vec<f64> = at_rest.displacements.iter().map(|displacement| line.length(*displacement)).collect();
        let points = CalibrationPoints::new(&lengths, &at_rest.inductances).map_err(refuse(spec))?;
        let method = match preload {
            Some((length, inductance)) => FitMethod::Through { length, inductance },
            None => FitMethod::AllPoints,
        };
        let fit = InverseLengthFit::new(&points, method).map_err(refuse(spec))?;
        let calibration = fit.calibration();
        Ok(Some(Self::InverseLength { calibration, fit: Some(Box::new(fit)), through: preload }))
    }

    /// l \[m\] of an inductance \[H\], or what is allowed.
    pub(super) fn length(&self, inductance: f64) -> Result<f64, String> {
        match self {
            Self::InverseLength { calibration, .. } => {
                let length = calibration.length(inductance);
                let holds = length > 0.0 && length.is_finite();
                holds.then_some(length).ok_or_else(|| format!("{inductance} H lies beyond the pole of 1/l = αL + β"))
            }
            Self::Stored(stored) => stored.at(inductance).map(|reading| reading.length).ok_or_else(|| {
                let [least, most] = stored.inductances();
                format!("{inductance} H: must be from {least} to {most} H, which {} tells", stored.name)
            }),
        }
    }
}

/// A refusal of the science about what the calibration runs hold.
fn refuse(spec: &ExperimentSpec) -> impl Fn(coilsense::Error) -> ExperimentError + '_ {
    let logs = spec.runs.iter().filter(|run| run.kind == RunKind::Calibration).find_map(|run| run.slow.clone());
    move |error| ExperimentError::of(logs.as_deref().unwrap_or(Path::new(&spec.file)), error)
}
