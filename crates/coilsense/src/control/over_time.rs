//! A loop over time: every drive, load, force and estimator, in samples or continuous.
//!
//! Next door: when it should go unstable (`sampled`, `force_loop`), its controller (`computer`), what
//! steps it (`stepped`, `crate::motion::Live`), what it leaves (`run`).

use std::f64::consts::TAU;
use std::sync::Arc;

use super::coil::Reading;
use super::computer::Computer;
use super::drive::Drive;
use super::environment::Environment;
use super::estimator::Estimator;
use super::force_loop::ForceLoop;
use super::kicked::Kicked;
use super::matrices::{OUTPUTS, STROKE};
use super::plant::Plant;
use super::poles::Poles;
use super::rational::Difference;
use super::run::{Record, Run, Sample};
use super::sampled::SampledLoop;
use super::stepped::{Hold, Stepped};
use crate::error::{Error, above_zero, called, check};
use crate::motion::Live;
use crate::mount::{FarEnd, Mount};
use crate::signals::Channel;

/// Most samples of a run.
const MOST_SAMPLES: usize = 10_000_000;
/// Steps of a continuous loop in a period of the chain's cut-off frequency, and in its delay.
const STEPS: f64 = 8.0;

/// A loop that is ready to be run.
///
/// In samples: the command of sample n, computed of the forces up to n, is held for one step. The continuous loop is stepped with a command
/// that goes straight from step to step and may feel its own step, off by the second order of h with no delay added; the reference rises
/// over one step, and times count from its middle.
///
/// | drive and load | stepped by |
/// |---|---|
/// | ideal velocity source, end 2 held or carrying a mass, in samples, not on F_L | [`Live`], without error |
/// | all others | the poles of drive, spring and load, without error for what the command does |
///
/// Source:   `[Franklin1998]` sections 6.1 to 6.3.
/// Valid:    small motions, windings that never touch; F_L in a straight line about the mean length unless [`Self::with_coil`] is asked.
/// Accuracy: trajectories in samples 1e-9 of the peak beside the exponential of the masses' equations, continuous ones 1e-7 at steps of 15 µs
/// (`reference/force_loops.py`, tests); limits of stability 0.5 % and better beside those over frequency (tests).
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::control::{Controller, Drive, Environment, ForceLoop, Gains, OverTime, Plant, SampledLoop};
/// use coilsense::{Channel, Damping};
///
/// let motor = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: Some(300.0) };
/// let plant = Plant::new(&spring, Damping::Modal(0.01), motor, Environment::Held)?;
/// let gains = Gains { proportional: 0.5, integral: 5.0, ..Gains::default() };
/// let force_loop = ForceLoop::new(plant, Controller::new(gains)?, Channel::InductanceForce, 5e-4)?;
/// let run = OverTime::sampled(&SampledLoop::new(&force_loop, 5e-4)?)?.run(1.0, 1.0, 8000)?;
/// assert!((run.output[7999] - 1.0).abs() < 1e-3); // after four seconds F_o is where it should be
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct OverTime {
    plant: Plant,
    feedback: Channel,
    control: Difference,
    forward: Difference,
    late: usize,
    step: f64,
    estimator: Option<Estimator>,
    engine: Engine,
    reading: Option<Box<Reading>>,
}

/// What moves the spring.
#[derive(Debug, Clone)]
enum Engine {
    /// The motion of the mounted spring, and F_x where end 2 moves.
    Exact(FarEnd, Option<Kicked>),
    /// Poles of drive, spring and load.
    Poles(Box<Stepped>),
}

impl OverTime {
    /// A loop in samples.
    ///
    /// # Errors
    /// [`Error::Value`] for a drive or load that takes poles, of a spring with more than 200 winding masses.
    pub fn sampled(sampled: &SampledLoop) -> Result<Self, Error> {
        Self::sampled_beside(sampled, None)
    }

    /// The same, with what another loop found of the same plant: another force fed back, or another gain.
    ///
    /// # Errors
    /// As [`Self::sampled`].
    pub fn sampled_beside(sampled: &SampledLoop, other: Option<&Self>) -> Result<Self, Error> {
        let plant = sampled.continuous.plant().clone();
        let feedback = sampled.continuous.feedback();
        let engine = match exact_far_end(&plant, feedback) {
            Some(far_end) => Engine::Exact(far_end, sampled.kicked()),
            None => Engine::Poles(Box::new(Stepped::new(poles(&plant, other)?, sampled.step, Hold::Zero))),
        };
        Ok(Self {
            plant,
            feedback,
            control: sampled.control.clone(),
            forward: sampled.forward.clone(),
            late: sampled.late,
            step: sampled.step,
            estimator: sampled.estimator.clone(),
            engine,
            reading: None,
        })
    }

    /// The continuous loop, at steps that are short beside its delay and the fastest motion of the chain.
    ///
    /// # Errors
    /// As [`Self::sampled`]; [`Error::Value`] for a delay of more than 10⁵ such steps.
    pub fn continuous(force_loop: &ForceLoop) -> Result<Self, Error> {
        Self::continuous_beside(force_loop, None)
    }

    /// The same, with what another loop found of the same plant.
    ///
    /// # Errors
    /// As [`Self::continuous`].
    pub fn continuous_beside(force_loop: &ForceLoop, other: Option<&Self>) -> Result<Self, Error> {
        let plant = force_loop.plant();
        let cut_off = plant.spring().chain_masses() as f64 / (0.5 * TAU * plant.spring().transit_time());
        let finest = 1.0 / (STEPS * cut_off);
        Self::continuous_at(force_loop, finest, other)
    }

    /// The same at steps of at most `most` \[s\]; a delay is a whole number of them, and takes eight at least.
    ///
    /// # Errors
    /// As [`Self::continuous`]; [`Error::Value`] for steps that are not above zero.
    pub fn continuous_within(force_loop: &ForceLoop, most: f64) -> Result<Self, Error> {
        Self::continuous_at(force_loop, most, None)
    }

    fn continuous_at(force_loop: &ForceLoop, most: f64, other: Option<&Self>) -> Result<Self, Error> {
        above_zero(called("most", "largest step"), most, "s")?;
        let plant = force_loop.plant().clone();
        let late = if force_loop.delay > 0.0 { (force_loop.delay / most).ceil().max(STEPS) } else { 0.0 };
        let allowed = format!("at most {} s, 100 000 steps of {most} s", 1e5 * most);
        check(late <= 1e5, called("delay", "loop delay"), force_loop.delay, "s", allowed)?;
        let step = if late > 0.0 { force_loop.delay / late } else { most };
        let controller = force_loop.controller();
        let stepped = Stepped::new(poles(&plant, other)?, step, Hold::First);
        Ok(Self {
            feedback: force_loop.feedback(),
            control: force_loop.feedback_law().tustin(step),
            forward: controller.forward().tustin(step),
            late: late as usize,
            step,
            estimator: None,
            engine: Engine::Poles(Box::new(stepped)),
            reading: None,
            plant,
        })
    }

    /// The same with F_L read off the inductance of all windings where they are, by the coil's own curve, in place of a straight line.
    ///
    /// # Errors
    /// [`Error::MissingSignal`] where F_L is not fed back; [`Error::Value`] for a continuous loop without a delay, whose command would ask for
    /// a reading of its own moment.
    pub fn with_coil(mut self) -> Result<Self, Error> {
        if self.feedback != Channel::InductanceForce {
            return Err(Error::MissingSignal(Channel::InductanceForce.name()));
        }
        let at_once = matches!(&self.engine, Engine::Poles(stepped) if stepped.at_once()[STROKE] != 0.0);
        let allowed = "above zero where a continuous loop reads F_L off the windings";
        check(!at_once || self.late > 0, called("delay", "loop delay"), 0.0, "s", allowed)?;
        self.reading = Some(Box::new(Reading::of(self.plant.spring())));
        Ok(self)
    }

    /// From step to step \[s\].
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Runs the loop from rest against a step of the reference.
    ///
    /// - `gain`: factor on all gains \[1\]; `reference`: the force wanted, less its mean \[N\]; `samples`: how many
    ///
    /// # Errors
    /// [`Error::Value`] for numbers that are not finite, a gain below zero, or more than 10⁷ samples. A loop that runs away ends its run where
    /// a force passes 1e8 N ([`Run::ran_away_at`]), one that reads F_L off its windings where these touch ([`Run::touched_at`]).
    pub fn run(&self, gain: f64, reference: f64, samples: usize) -> Result<Run, Error> {
        check(samples <= MOST_SAMPLES, "samples", samples as f64, "", format!("at most {MOST_SAMPLES}"))?;
        check(gain.is_finite() && gain >= 0.0, called("gain", "gain factor"), gain, "", "finite and not below zero")?;
        check(reference.is_finite(), "reference", reference, "N", "finite")?;
        // The reference of a continuous loop rises over one step: times count from its middle.
        let continuous = matches!(&self.engine, Engine::Poles(stepped) if stepped.hold() == Hold::First);
        let mut record = Record::new(if continuous { 0.5 * self.step } else { 0.0 }, self.step, samples);
        match &self.engine {
            Engine::Exact(far_end, kicked) => self.on_live(*far_end, kicked.clone(), gain, reference, &mut record)?,
            Engine::Poles(stepped) => self.on_poles((**stepped).clone(), gain, reference, &mut record)?,
        }
        Ok(record.run)
    }

    /// Force at rest at the mean length \[N\], which a mass at end 2 is held against.
    fn mean(&self) -> f64 {
        let spring = self.plant.spring();
        spring.static_force(spring.mid_length())
    }

    fn on_live(
        &self,
        far_end: FarEnd,
        mut kicked: Option<Kicked>,
        gain: f64,
        reference: f64,
        record: &mut Record,
    ) -> Result<(), Error> {
        let (spring, mean) = (self.plant.spring(), self.mean());
        let (length, k) = (spring.mid_length(), spring.stiffness());
        let mount = Mount::new(far_end, self.plant.damping().clone())?;
        let mut live = Live::new(spring, &mount, length, self.step)?;
        let mut estimate = self.estimator.as_ref().map(|estimator| estimator.running(mean, length));
        let mut computer = Computer::new([&self.control, &self.forward], self.late, gain, reference);
        let (mut stroke, mut forces) = (0.0, [0.0; 2]);
        while record.goes_on() {
            let deflection = kicked.as_ref().map_or(k * stroke, Kicked::force);
            let fed_back = match (&mut estimate, self.feedback) {
                (Some(estimate), _) => estimate.step(forces[0] + mean, [-stroke, length]) - mean,
                (None, Channel::InputForce) => forces[0],
                (None, Channel::OutputForce) => forces[1],
                (None, _) => deflection,
            };
            let command = computer.command(fed_back);
            record.add(Sample { fed_back, input: forces[0], output: forces[1], command, stroke });
            stroke += command * self.step;
            if !record.goes_on() {
                break;
            }
            let next = live.advance([-stroke, 0.0])?;
            forces = [next.input - mean, next.output - mean];
            if let Some(kicked) = &mut kicked {
                kicked.advance(command);
            }
        }
        Ok(())
    }

    fn on_poles(&self, mut stepped: Stepped, gain: f64, reference: f64, record: &mut Record) -> Result<(), Error> {
        let (mean, length) = (self.mean(), self.plant.spring().mid_length());
        let fed = output_of(self.feedback)?;
        let at_once = stepped.at_once();
        let mut estimate = self.estimator.as_ref().map(|estimator| estimator.running(mean, length));
        let mut computer = Computer::new([&self.control, &self.forward], self.late, gain, reference);
        while record.goes_on() {
            let mut outputs = stepped.outputs();
            let felt = |outputs: &mut [f64; OUTPUTS], command: f64| {
                outputs.iter_mut().zip(at_once).for_each(|(output, share)| *output += share * command);
            };
            // A continuous loop without delay feels its command at once; with one it is known.
            let known =
                computer.known().or_else(|| (at_once[fed] != 0.0).then(|| computer.solved(outputs[fed], at_once[fed])));
            if let Some(command) = known {
                felt(&mut outputs, command);
            }
            let mut fed_back = match &mut estimate {
                Some(estimate) => estimate.step(outputs[0] + mean, [-outputs[STROKE], length]) - mean,
                None => outputs[fed],
            };
            if let Some(reading) = &self.reading {
                // u2 = (F_x/k) + u1.
                let end = outputs[2] / self.plant.spring().stiffness() - outputs[STROKE];
                match reading.force([-outputs[STROKE], end], &stepped.modes())? {
                    Some(force) => fed_back = force,
                    None => {
                        record.touched();
                        break;
                    }
                }
            }
            let command = computer.command(fed_back);
            if known.is_none() {
                felt(&mut outputs, command);
            }
            let [input, output, .., stroke] = outputs;
            record.add(Sample { fed_back, input, output, command, stroke });
            stepped.take(command);
            stepped.advance();
        }
        Ok(())
    }
}

/// The poles of a plant, those that another loop on it has found already.
fn poles(plant: &Plant, other: Option<&OverTime>) -> Result<Arc<Poles>, Error> {
    match other {
        Some(OverTime { plant: same, engine: Engine::Poles(stepped), .. }) if same == plant => {
            Ok(stepped.poles().clone())
        }
        _ => Poles::of(plant).map(Arc::new),
    }
}

/// Where a force stands among a plant's outputs.
fn output_of(channel: Channel) -> Result<usize, Error> {
    Channel::FORCES.iter().position(|force| *force == channel).ok_or(Error::MissingSignal(channel.name()))
}

/// What end 2 is tied to where the mounted spring's own motion runs the loop: an ideal velocity source, end 2 held or a mass, not F_L.
fn exact_far_end(plant: &Plant, feedback: Channel) -> Option<FarEnd> {
    if *plant.drive() != Drive::IDEAL_VELOCITY || feedback == Channel::InductanceForce {
        return None;
    }
    match *plant.environment() {
        Environment::Held => Some(FarEnd::Position),
        Environment::Impedance { mass, damping: 0.0, stiffness: 0.0 } if mass > 0.0 => Some(FarEnd::Mass(mass)),
        Environment::Impedance { .. } => None,
    }
}

/// Runs a loop in samples once: [`OverTime::sampled`] and [`OverTime::run`].
///
/// # Errors
/// Those of both.
pub fn simulate(sampled: &SampledLoop, gain: f64, reference: f64, samples: usize) -> Result<Run, Error> {
    OverTime::sampled(sampled)?.run(gain, reference, samples)
}
