//! A stored calibration applied to a log: length and force, row by row, with their uncertainties.
//!
//! Next door: the calibration (`stored`), the log (`crate::recording`).

use coilsense::{Channel, Signals};

use super::median::median;
use super::{CalibrationError, StoredCalibration};
use crate::quantity::digits;

/// Length and force of a log's rows, by their inductance.
#[derive(Debug, Clone, PartialEq)]
pub struct Applied {
    /// l \[m\], shape `samples`.
    pub lengths: Vec<f64>,
    /// u(l) \[m\], shape `samples`; none where the calibration does not tell it.
    pub lengths_u: Option<Vec<f64>>,
    /// F \[N\], shape `samples`; none without a stiffness.
    pub forces: Option<Vec<f64>>,
    /// u(F) \[N\], shape `samples`.
    pub forces_u: Option<Vec<f64>>,
    /// What is to be said, a sentence each.
    pub told: Vec<String>,
}

/// By how much R falls where turns touch, and is off where clips have moved.
const RESISTANCE: f64 = 2e-3;

impl Applied {
    /// Reads every row.
    ///
    /// # Errors
    /// [`CalibrationError`] for a log without L, or with a row outside of the calibration's lengths.
    pub fn new(stored: &StoredCalibration, signals: &Signals, file: &str) -> Result<Self, CalibrationError> {
        let inductances =
            signals.channel(Channel::Inductance).map_err(|error| CalibrationError::of(file, error.to_string()))?;
        let mut readings = Vec::with_capacity(inductances.len());
        for (&inductance, &time) in inductances.iter().zip(signals.time()) {
            let Some(reading) = stored.at(inductance) else {
                let [least, most] = stored.inductances().map(|henry| digits(1e6 * henry));
                let [shortest, longest] = stored.lengths().map(|length| digits(1e3 * length));
                return Err(CalibrationError::of(
                    file,
                    format!(
                        "L must be from {least} to {most} µH, which {} tells between {shortest} and {longest} mm, got {} µH at {time} s",
                        stored.name,
                        digits(1e6 * inductance)
                    ),
                ));
            };
            readings.push(reading);
        }
        let lengths: Vec<f64> = readings.iter().map(|reading| reading.length).collect();
        let lengths_u: Option<Vec<f64>> = readings.iter().map(|reading| reading.length_u).collect();
        let by_force: Option<Vec<_>> = readings.iter().map(|&reading| stored.force_of(reading)).collect();
        let forces_u = by_force.as_ref().and_then(|forces| forces.iter().map(|(_, force_u)| *force_u).collect());
        let forces = by_force.map(|forces| forces.into_iter().map(|(force, _)| force).collect());
        let mut applied = Self { lengths, lengths_u, forces, forces_u, told: Vec::new() };
        applied.told = applied.words(stored, signals);
        Ok(applied)
    }

    fn words(&self, stored: &StoredCalibration, signals: &Signals) -> Vec<String> {
        let most = |values: &Option<Vec<f64>>| values.as_ref().map(|values| values.iter().copied().fold(0.0, f64::max));
        let span = |values: &[f64]| {
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            (least, values.iter().copied().fold(f64::NEG_INFINITY, f64::max))
        };
        let (from, to) = span(&self.lengths);
        let doubt = |found: Option<f64>, scale: f64, unit: &str| match found {
            Some(found) => format!("standard uncertainty at most {} {unit}", digits(scale * found)),
            None => "its uncertainty unknown, as the calibration does not give one".to_owned(),
        };
        let mut told = vec![format!(
            "Length by {}: {} to {} mm, {}.",
            stored.name,
            digits(1e3 * from),
            digits(1e3 * to),
            doubt(most(&self.lengths_u), 1e3, "mm")
        )];
        told.push(match &self.forces {
            Some(forces) => {
                let (from, to) = span(forces);
                format!("Force by it (F_L): {} to {} N, {}.", digits(from), digits(to), doubt(most(&self.forces_u), 1.0, "N"))
            }
            None => "No force: the calibration has no stiffness (calibrate with --stiffness and --length-at-zero-force, or with --spec).".to_owned(),
        });
        told.push(match stored.remounting {
            share if share > 0.0 => format!(
                "The uncertainty includes {} % of L for remounting the spring; --re-zero \"LENGTH, L\" removes it.",
                digits(100.0 * share)
            ),
            _ => format!("Re-zeroed: L is moved by {} nH.", digits(1e9 * stored.shift)),
        });
        told.push("Both hold for windings at rest: what ringing adds is told by coilsense analyze.".to_owned());
        if self.forces.is_some() && signals.channel(Channel::InductanceForce).is_ok() {
            told.push("The log's own F_L is replaced.".to_owned());
        }
        told.extend(resistance(stored, signals));
        told
    }
}

/// What the resistance says of turns and clips.
fn resistance(stored: &StoredCalibration, signals: &Signals) -> Vec<String> {
    let Ok(resistances) = signals.channel(Channel::Resistance) else { return Vec::new() };
    let Some(usual) = median(resistances.iter().copied()) else { return Vec::new() };
    let mut told = Vec::new();
    let low: Vec<usize> = (0..resistances.len()).filter(|&row| resistances[row] < (1.0 - RESISTANCE) * usual).collect();
    if let Some(&first) = low.first() {
        told.push(format!(
            "Turns touch in {} of {} rows, first at {} s, unless a clip moved there or the wire was colder by some 2 K: R is more than {} % below its median. Do not \
             trust length and force of these rows.",
            low.len(),
            resistances.len(),
            signals.time()[first],
            digits(100.0 * RESISTANCE)
        ));
    }
    if let Some(own) = stored.resistance {
        let off = usual / own - 1.0;
        if off.abs() > RESISTANCE {
            told.push(format!(
                "R is {} % off that of the calibration: clips or leads moved (use --re-zero), or the wire is some {} K {}.",
                digits(100.0 * off.abs()),
                digits(off.abs() / PER_KELVIN),
                if off > 0.0 { "warmer" } else { "colder" }
            ));
        }
    }
    told
}

/// Of stainless steel's resistance \[1/K\], about.
const PER_KELVIN: f64 = 1e-3;
