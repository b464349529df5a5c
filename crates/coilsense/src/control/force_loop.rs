//! The loop: plant, controller, the force that is fed back, and the delay on the way.
//!
//! Next door: stability and margins (`margins`), the same loop in samples (`sampled`), the impedance that it renders (`rendered`).

use num_complex::Complex64;

use super::controller::Controller;
use super::drive::Drive;
use super::margins::Margins;
use super::plant::{Plant, Response};
use super::rational::Rational;
use super::trace::Trace;
use crate::error::{Error, above_zero, called, check, from_zero};
use crate::signals::Channel;

/// A force loop.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceLoop {
    pub(super) plant: Plant,
    pub(super) controller: Controller,
    pub(super) feedback: Channel,
    pub(super) delay: f64,
    /// The spring's stiffness as whoever designed the loop knows it \[N/m\].
    designed_for: f64,
}

impl ForceLoop {
    /// Closes a loop around a plant.
    ///
    /// - `feedback`: the force that is fed back; `delay`: from force to command \[s\]
    ///
    /// # Errors
    /// [`Error::MissingSignal`] where `feedback` is no force; [`Error::Value`] for a delay below zero.
    pub fn new(plant: Plant, controller: Controller, feedback: Channel, delay: f64) -> Result<Self, Error> {
        if !Channel::FORCES.contains(&feedback) {
            return Err(Error::MissingSignal(feedback.name()));
        }
        from_zero(called("delay", "loop delay"), delay, "s")?;
        let designed_for = plant.spring().stiffness();
        Ok(Self { plant, controller, feedback, delay, designed_for })
    }

    /// The same loop where its designer takes the spring to be of another stiffness than it is \[N/m\].
    ///
    /// Deflection and inductance are read as forces by that stiffness, F_read = k_designed/k F, and an observer expects it; load cells do not
    /// know it. What the loop tells of forces stays what they are.
    ///
    /// # Errors
    /// [`Error::Value`] unless it is above zero.
    pub fn designed_for(self, stiffness: f64) -> Result<Self, Error> {
        above_zero(called("stiffness", "designed stiffness"), stiffness, "N/m")?;
        Ok(Self { designed_for: stiffness, ..self })
    }

    /// What is read over what is \[1\].
    fn reads(&self) -> f64 {
        match self.feedback {
            Channel::DeflectionForce | Channel::InductanceForce => self.designed_for / self.plant.spring().stiffness(),
            _ => 1.0,
        }
    }

    /// From the force that is fed back to the command, but for delay and the sign of negative feedback.
    pub(super) fn feedback_law(&self) -> Rational {
        self.controller.feedback(self.plant.drive(), self.designed_for).times(self.reads())
    }

    /// The plant.
    pub fn plant(&self) -> &Plant {
        &self.plant
    }

    /// The controller.
    pub fn controller(&self) -> &Controller {
        &self.controller
    }

    /// The force that is fed back.
    pub fn feedback(&self) -> Channel {
        self.feedback
    }

    /// From force to command \[s\].
    pub fn delay(&self) -> f64 {
        self.delay
    }

    /// Loop response L(jω) \[1\]: C e^(−jωT) F/c, the sign of negative feedback left out.
    ///
    /// - `angular_frequency`: ω \[rad/s\], above zero
    ///
    /// Source:   [`Plant::at`] and the controller's own formula.
    /// Valid:    small motions, windings that never touch.
    /// Accuracy: that of [`Plant::at`].
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not above zero and finite.
    pub fn at(&self, angular_frequency: f64) -> Result<Complex64, Error> {
        Ok(self.carried(angular_frequency, self.plant.at(angular_frequency)?.of(self.feedback)?))
    }

    /// The same with a spring without mass.
    ///
    /// # Errors
    /// As [`Self::at`].
    pub fn massless(&self, angular_frequency: f64) -> Result<Complex64, Error> {
        Ok(self.carried(angular_frequency, self.plant.massless(angular_frequency)?))
    }

    fn carried(&self, angular_frequency: f64, plant: Complex64) -> Complex64 {
        let s = Complex64::new(0.0, angular_frequency);
        plant * self.control(s)
    }

    /// C e^(−sT), of a force that is read by another stiffness times that.
    pub(super) fn control(&self, s: Complex64) -> Complex64 {
        self.feedback_law().at(s) * (-s * self.delay).exp()
    }

    /// L(jω) as finely as it turns, from 1e-4 of the first surge frequency to past the chain's cut-off.
    ///
    /// # Errors
    /// [`Error::Value`] where a mode is not damped, or the response turns too quickly to be followed: a delay of very many surge periods.
    pub fn trace(&self) -> Result<Trace, Error> {
        self.plant.check_damped()?;
        let (from, to) = self.range();
        Trace::of(|frequency| self.at(frequency), from, to, self.known())
    }

    /// The band that a trace covers \[rad/s\].
    pub(super) fn range(&self) -> (f64, f64) {
        let spring = self.plant.spring();
        let surge = std::f64::consts::PI / spring.transit_time();
        let slowest = match self.plant.drive() {
            Drive::Velocity { .. } => surge,
            Drive::Force { mass, .. } => surge.min((spring.stiffness() / mass).sqrt()),
        };
        (1e-4 * slowest, 2.6 * spring.chain_masses() as f64 / spring.transit_time())
    }

    /// Frequencies that a trace must not miss: each surge line with its flanks.
    pub(super) fn known(&self) -> Vec<f64> {
        let flanks = [-8.0, -2.0, -0.5, 0.0, 0.5, 2.0, 8.0];
        self.plant.lines().flat_map(|(line, width)| flanks.map(|flank| line + flank * width)).collect()
    }

    /// How far the loop is from unstable.
    ///
    /// # Errors
    /// As [`Self::trace`].
    pub fn margins(&self) -> Result<Margins, Error> {
        Margins::of(&self.trace()?, None, |frequency| self.at(frequency))
    }

    /// Force over reference \[1\] of the closed loop, for the force that is fed back: (C + feed-forward) P / (1 + L).
    ///
    /// # Errors
    /// As [`Self::at`].
    pub fn tracking(&self, angular_frequency: f64) -> Result<Complex64, Error> {
        self.closed(angular_frequency, &self.plant.at(angular_frequency)?)?.of(self.feedback)
    }

    /// What the plant does per newton of the reference with the loop closed, from its `response` per command at that angular frequency \[rad/s\], which
    /// [`Plant::at`] gives and which is the same at every gain.
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not above zero.
    pub fn closed(&self, angular_frequency: f64, response: &Response) -> Result<Response, Error> {
        check(angular_frequency > 0.0, "angular_frequency", angular_frequency, "rad/s", "above zero and finite")?;
        let forward = self.controller.forward().at(Complex64::new(0.0, angular_frequency));
        let command = forward / (1.0 + self.carried(angular_frequency, response.of(self.feedback)?));
        Ok(response.times(command))
    }

    /// Crossover of the loop with a spring without mass at a gain factor \[rad/s\]: what the loop would be if nothing rang; `None` where
    /// |L| never falls through 1.
    ///
    /// # Errors
    /// As [`Self::trace`].
    pub fn massless_crossover(&self, gain: f64) -> Result<Option<f64>, Error> {
        let (from, to) = self.range();
        let trace = Trace::of(|frequency| self.massless(frequency), 1e-4 * from, to, [])?;
        Ok(trace.falls_through(1.0 / gain).last().map(|point| point.angular_frequency))
    }
}
