//! One condition under one damping: the motion, what each sensor reads, and the paper's measures.
//!
//! Next door: sensors on the spring (`coilsense::sensors`), the judgement over all cases (`verdict`).

use std::ops::Range;

use coilsense::measures::Spectrum;
use coilsense::sensors::{Instrument, Site};
use coilsense::signals::sampled_window;
use coilsense::{Channel, Clash, Deviation, Error, Signals};

use super::band::judged;
use super::frames::Frames;
use super::trial_run::needs_coil;
use crate::series::{Column, Run};
use crate::spec::{Goal, Magnetised, SensorSpec, Spec, SpringInductance};
use crate::study::{self, Coil, Contacts, EndLoads, Helices, Meets, Method, Seen, Setup, Simulation};

/// Share of F_nom by which it is judged how long a run with contact holds, where there is no goal.
const UNJUDGED: f64 = 0.01;

/// What of a case a sensor is judged by.
#[derive(Clone, Copy)]
pub(super) struct Scene<'a> {
    /// Number of the condition in the spec.
    pub condition: usize,
    /// What counts as true.
    pub signals: &'a Signals,
    /// What the sensor sees.
    pub seen: &'a Signals,
    pub judged: &'a Range<usize>,
    /// How far L of magnetic windings may be off \[H\], rms over the judged samples; nothing of others.
    pub inductance_doubt: f64,
}

/// A simulation that was run.
#[derive(Debug, Clone)]
pub struct Case {
    /// Number of its condition in the spec.
    pub condition: usize,
    /// Number of its damping in the spec.
    pub damping: usize,
    /// u1, u2, F_i, F_o, F_x, F_L, L from t = 0 on.
    pub signals: Signals,
    /// The samples that are judged.
    pub judged: Range<usize>,
    /// One per sensor.
    pub readings: Vec<Reading>,
    /// Deviation of each of the paper's forces from the true one \[N\], over the judged samples.
    pub ideal: Vec<(Channel, Deviation)>,
    /// Spectrum of each of the paper's forces \[N\], over the judged samples.
    pub spectra: Vec<(Channel, Spectrum)>,
    /// How near the windings come.
    pub clash: Clash,
    /// Shortest and longest length of the spring \[m\].
    pub lengths: (f64, f64),
    /// Where the windings are, thinned out.
    pub frames: Frames,
    /// Of a helix: what holds end 1 and end 2 feels beside the axial force.
    pub loads: Option<[EndLoads; 2]>,
    /// What windings did when they met, where they were asked to.
    pub contacts: Option<Contacts>,
    /// Of magnetic wire, how far L holds.
    pub magnetised: Option<HowMagnetised>,
    /// The signals as sensors see them.
    seen: Seen,
}

/// How far L of magnetic windings holds over the judged samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HowMagnetised {
    /// How far it may be off \[H\], rms.
    pub doubt: f64,
    /// Share of the samples in which windings are too uneven for the magnetisation of each \[1\].
    pub beyond: f64,
}

impl HowMagnetised {
    fn over(judged: &Range<usize>, found: &Magnetised) -> Self {
        let (doubts, beyond) = (&found.doubts[judged.clone()], &found.beyond[judged.clone()]);
        let mean = |sum: f64| sum / judged.len() as f64;
        Self {
            doubt: mean(doubts.iter().map(|doubt| doubt * doubt).sum()).sqrt(),
            beyond: mean(beyond.iter().filter(|beyond| **beyond).count() as f64),
        }
    }
}

/// What a sensor reads.
#[derive(Debug, Clone)]
pub struct Reading {
    /// In its native unit, from t = 0 on.
    pub native: Vec<f64>,
    /// The force that it means \[N\].
    pub force: Vec<f64>,
    /// The same without noise and resolution: oscillation through the sensor's own dynamics \[N\].
    pub steady: Vec<f64>,
    /// Deviation of `force` from the true one \[N\], over the judged samples.
    pub deviation: Deviation,
}

impl Case {
    pub(super) fn run(
        spec: &Spec,
        sensors: &[SensorSpec],
        coil: &SpringInductance,
        helices: &Helices,
        (condition, damping): (usize, usize),
    ) -> Result<Self, Error> {
        let asked = &spec.conditions[condition];
        let spring = &spec.spring.spring;
        let times = sampled_window(asked.sample_rate, 0.0, asked.duration)?;
        let mean_length = asked.excitation.mean_length();
        let way = &spec.mount.cases[damping];
        let apart = Some(spec.goal.error.unwrap_or(UNJUDGED * spring.nominal_force()));
        let setup = Setup {
            spring,
            mount: &way.mount,
            excitation: &asked.excitation,
            coil: force_of_coil(spec, sensors, coil, mean_length)?,
            positions: true,
            helix: helices.get(condition, damping).map(|helix| (helix, [1.0; 2])),
            contact: way.contact.as_ref().map(|way| Meets { contact: &way.contact, apart }),
        };
        let Simulation { motion, signals, windings, magnetised, loads, seen, contacts, .. } =
            study::simulate(&setup, &times)?;
        // Request for above.
        let windings = windings.map_or_else(|| motion.windings(&times), Ok)?;

        let judged = judged(&times, asked.window);
        let truth = &signals.channel(spec.goal.force)?[judged.clone()];
        let mut ideal = Vec::new();
        let mut spectra = Vec::new();
        for force in Channel::FORCES {
            let Ok(series) = signals.channel(force) else { continue };
            let series = &series[judged.clone()];
            ideal.push((force, Deviation::between(series, truth)?));
            spectra.push((force, Spectrum::of(&times[judged.clone()], series)?));
        }
        // What comes after the judged part concerns nobody.
        let watched = &times[..judged.end];
        let pitch = spec.spring.contact_pitch();
        let clash = match &contacts {
            Some(contacts) => Clash::met(spring, watched, &windings, pitch, contacts.first)?,
            None => Clash::seen(&motion, watched, &windings, pitch)?,
        };
        let true_force = seen.truth(&signals, &spec.goal).channel(spec.goal.force)?[judged.clone()].to_vec();
        let number = condition * spec.mount.cases.len() + damping;
        let read = |(index, sensor): (usize, &SensorSpec)| {
            let instrument = sensor.on(&Site { spring, coil, mean_length })?;
            // Each sensor in each case has noise of its own.
            let seed = spec.uncertainty.seed.wrapping_add((number * sensors.len() + index) as u64);
            Reading::of(&instrument, seen.by(&signals, sensor, &spec.goal), &true_force, &judged, seed)
        };
        Ok(Self {
            condition,
            damping,
            readings: sensors.iter().enumerate().map(read).collect::<Result<_, _>>()?,
            loads,
            ideal,
            spectra,
            clash,
            lengths: lengths(&signals)?,
            frames: Frames::of(
                &windings.turns(spring.masses_per_winding())?,
                &times,
                judged.start,
                1.0 / spring.surge_frequency(),
            ),
            magnetised: magnetised.map(|found| HowMagnetised::over(&judged, &found)),
            contacts,
            seen,
            signals,
            judged,
        })
    }

    /// Its series for a file: time, the paper's channels, then what each sensor reads, in its native unit and as the force it means.
    pub fn series<'a>(&'a self, spec: &'a Spec, sensors: &'a [SensorSpec]) -> Run<'a> {
        let (condition, damping) = (&spec.conditions[self.condition].name, &spec.mount.cases[self.damping].label);
        let mut run = Run::of(condition, damping, &self.signals);
        for (sensor, reading) in sensors.iter().zip(&self.readings) {
            let unit = sensor.quantity.unit();
            run.columns.push(Column::new(sensor.name.as_str(), unit, &reading.native));
            if sensor.quantity.estimates() {
                run.columns.push(Column::new(sensor.name.as_str(), "N", &reading.force));
            }
        }
        for (number, loads) in (1..).zip(self.loads.iter().flatten()) {
            run.columns.push(Column::new(format!("side force {number}"), "N", &loads.side_force));
            run.columns.push(Column::new(format!("couple {number}"), "N m", &loads.couple));
        }
        run
    }

    /// What of it a sensor is judged by.
    pub(super) fn scene<'a>(&'a self, sensor: &SensorSpec, goal: &Goal) -> Scene<'a> {
        let (signals, seen) = (self.seen.truth(&self.signals, goal), self.seen.by(&self.signals, sensor, goal));
        let inductance_doubt = self.magnetised.map_or(0.0, |how| how.doubt);
        Scene { condition: self.condition, signals, seen, judged: &self.judged, inductance_doubt }
    }

    /// How many numbers it holds, about.
    pub(super) fn numbers(&self) -> usize {
        // Time and channels, once more as sensors see them, three of each sensor.
        self.signals.time().len() * (2 * 8 + 3 * self.readings.len())
    }

    /// Times of the judged samples \[s\].
    pub fn judged_times(&self) -> &[f64] {
        &self.signals.time()[self.judged.clone()]
    }
}

impl Reading {
    fn of(
        instrument: &Instrument,
        signals: &Signals,
        truth: &[f64],
        judged: &Range<usize>,
        seed: u64,
    ) -> Result<Self, Error> {
        let quantity = instrument.quantity(signals)?;
        let ideal = instrument.readout().ideal_series(signals.time(), &quantity)?;
        let steady = instrument.forces(&ideal);
        let settings = instrument.readout().parameters();
        let (native, force) = if settings.noise == 0.0 && settings.resolution.is_none() {
            (ideal, steady.clone())
        } else {
            let native = instrument.readout().series(signals.time(), &quantity, seed)?;
            let force = instrument.forces(&native);
            (native, force)
        };
        let deviation = Deviation::between(&force[judged.clone()], truth)?;
        Ok(Self { native, force, steady, deviation })
    }
}

/// The coil as an inductance. Where nobody asks for it, a coil for which eq. (13) cannot be fitted, such as one of few windings, has none.
pub(super) fn force_of_coil<'a>(
    spec: &Spec,
    sensors: &[SensorSpec],
    coil: &'a SpringInductance,
    mean_length: f64,
) -> Result<Option<Coil<'a>>, Error> {
    let each: Vec<&SensorSpec> = sensors.iter().collect();
    match Coil::of(&spec.spring.spring, coil, mean_length, Method::Exact) {
        Ok(coil) => Ok(Some(coil)),
        Err(error) if needs_coil(spec, &each) => Err(error),
        Err(_) => Ok(None),
    }
}

fn lengths(signals: &Signals) -> Result<(f64, f64), Error> {
    let ends = signals.channel(Channel::U1)?.iter().zip(signals.channel(Channel::U2)?);
    let wider = |(least, most): (f64, f64), length: f64| (least.min(length), most.max(length));
    Ok(ends.map(|(u1, u2)| u2 - u1).fold((f64::INFINITY, f64::NEG_INFINITY), wider))
}
