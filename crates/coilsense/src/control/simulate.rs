//! The sampled loop over time, on the exact engine.
//!
//! Next door: when it should go unstable (`sampled`), the engine (`crate::motion::Live`).

use std::collections::VecDeque;

use super::rational::Difference;
use super::sampled::{SampledLoop, far_end};
use crate::error::{Error, called, check};
use crate::motion::{ForceSample, Live};
use crate::mount::{FarEnd, Mount};
use crate::signals::Channel;

/// Most samples of a run.
const MOST_SAMPLES: usize = 10_000_000;

/// A run: what was measured and commanded at each sample.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Run {
    /// t \[s\].
    pub time: Vec<f64>,
    /// The force that is fed back, less its mean \[N\].
    pub fed_back: Vec<f64>,
    /// F_i less its mean \[N\].
    pub input: Vec<f64>,
    /// F_o less its mean \[N\].
    pub output: Vec<f64>,
    /// The command (m/s of a velocity source).
    pub command: Vec<f64>,
}

/// A difference equation at work.
#[derive(Debug, Clone)]
struct Filter<'a> {
    equation: &'a Difference,
    inputs: VecDeque<f64>,
    outputs: VecDeque<f64>,
}

impl<'a> Filter<'a> {
    fn new(equation: &'a Difference) -> Self {
        let past = equation.backward.len() - 1;
        Self { equation, inputs: vec![0.0; past].into(), outputs: vec![0.0; past].into() }
    }

    fn step(&mut self, input: f64) -> f64 {
        let Difference { forward, backward } = self.equation;
        let fed: f64 = forward[1..].iter().zip(&self.inputs).map(|(b, x)| b * x).sum();
        let back: f64 = backward[1..].iter().zip(&self.outputs).map(|(a, y)| a * y).sum();
        let output = forward[0] * input + fed - back;
        for (line, value) in [(&mut self.inputs, input), (&mut self.outputs, output)] {
            line.push_front(value);
            line.pop_back();
        }
        output
    }
}

/// Runs the sampled loop from rest against a step of the reference, on the exact modal engine.
///
/// - `gain`: factor on all gains \[1\]; `reference`: the force wanted, less its mean \[N\]; `samples`: how many
///
/// The command of sample n, computed of the forces up to n and held for one step, moves end 1 in a straight line.
///
/// # Errors
/// [`Error::Value`] for a drive that is not an ideal velocity source, an environment other than held or a mass, F_L as feedback (which needs
/// every winding), or numbers that are not finite. A loop that runs away ends its run where a force passes 1e9 N.
pub fn simulate(sampled: &SampledLoop, gain: f64, reference: f64, samples: usize) -> Result<Run, Error> {
    let plant = sampled.continuous.plant();
    check(samples <= MOST_SAMPLES, "samples", samples as f64, "", format!("at most {MOST_SAMPLES}"))?;
    check(gain.is_finite() && gain >= 0.0, called("gain", "gain factor"), gain, "", "finite and not below zero")?;
    check(reference.is_finite(), "reference", reference, "N", "finite")?;
    let far_end = far_end(sampled)?;
    let mount = Mount::new(far_end, plant.damping().clone())?;
    let mut spring = Live::new(plant.spring(), &mount, plant.spring().mid_length(), sampled.step)?;
    let feedback = sampled.continuous.feedback();
    let (mut back, mut forward) = (Filter::new(&sampled.control), Filter::new(&sampled.forward));
    let mut pending: VecDeque<f64> = vec![0.0; sampled.late].into();
    let mean = if far_end == FarEnd::Position { plant.spring().static_force(plant.spring().mid_length()) } else { 0.0 };
    let (mut run, mut stroke) = (Run::default(), 0.0);
    let mut force = ForceSample { time: 0.0, input: mean, output: mean };
    let length = plant.spring().mid_length();
    let mut estimate = sampled.estimator.as_ref().map(|estimator| estimator.running(mean, length));
    for sample in 0..samples {
        let fed_back = match (&mut estimate, feedback) {
            (Some(estimate), _) => estimate.step(force.input, [-stroke, length]) - mean,
            (None, Channel::InputForce) => force.input - mean,
            (None, Channel::OutputForce) => force.output - mean,
            (None, _) => plant.spring().stiffness() * stroke,
        };
        pending.push_back(gain * (forward.step(reference) - back.step(fed_back)));
        let command = pending.pop_front().unwrap_or(0.0);
        run.time.push(sample as f64 * sampled.step);
        run.fed_back.push(fed_back);
        run.input.push(force.input - mean);
        run.output.push(force.output - mean);
        run.command.push(command);
        stroke += command * sampled.step;
        if stroke.abs().max(fed_back.abs()) > 1e8 {
            break;
        }
        force = spring.advance([-stroke, 0.0])?;
    }
    Ok(run)
}
