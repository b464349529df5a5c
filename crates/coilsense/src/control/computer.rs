//! A controller at work, sample by sample: difference equations, and commands on their way.
//!
//! Next door: the equations (`rational`), the loop that it closes (`over_time`).

use std::collections::VecDeque;

use super::rational::Difference;

/// The controller at work: difference equations, and commands on their way.
pub(super) struct Computer<'a> {
    back: Filter<'a>,
    forward: Filter<'a>,
    pending: VecDeque<f64>,
    gain: f64,
    reference: f64,
}

impl<'a> Computer<'a> {
    /// At rest: the equations from force and from reference to command, and by how many samples a command is late.
    pub fn new([back, forward]: [&'a Difference; 2], late: usize, gain: f64, reference: f64) -> Self {
        Self {
            back: Filter::new(back),
            forward: Filter::new(forward),
            pending: vec![0.0; late].into(),
            gain,
            reference,
        }
    }

    /// The command of this sample where it was computed of samples before.
    pub fn known(&self) -> Option<f64> {
        self.pending.front().copied()
    }

    /// The command that the force it makes at once agrees with: c = g (f − b (F + s c)), F what is felt without it.
    pub fn solved(&self, free: f64, share: f64) -> f64 {
        let wanted = self.forward.next(self.reference) - self.back.next(free);
        self.gain * wanted / (1.0 + self.gain * self.back.equation.forward[0] * share)
    }

    /// Takes the force of this sample and gives the command.
    pub fn command(&mut self, fed_back: f64) -> f64 {
        let command = self.gain * (self.forward.step(self.reference) - self.back.step(fed_back));
        self.pending.push_back(command);
        self.pending.pop_front().unwrap_or(0.0)
    }
}

/// A difference equation at work.
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

    /// What it would give for an input.
    fn next(&self, input: f64) -> f64 {
        let Difference { forward, backward } = self.equation;
        let fed: f64 = forward[1..].iter().zip(&self.inputs).map(|(b, x)| b * x).sum();
        let back: f64 = backward[1..].iter().zip(&self.outputs).map(|(a, y)| a * y).sum();
        forward[0] * input + fed - back
    }

    fn step(&mut self, input: f64) -> f64 {
        let output = self.next(input);
        for (line, value) in [(&mut self.inputs, input), (&mut self.outputs, output)] {
            line.push_front(value);
            line.pop_back();
        }
        output
    }
}
