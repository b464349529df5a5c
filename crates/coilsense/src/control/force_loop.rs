//! The loop: plant, controller, the force that is fed back, and the delay on the way.
//!
//! Next door: stability and margins (`margins`), the same loop in samples (`sampled`), the impedance that it renders (`rendered`).

use num_complex::Complex64;

use super::controller::Controller;
use super::drive::Drive;
use super::margins::Margins;
use super::plant::Plant;
use super::trace::Trace;
use crate::error::{Error, called, from_zero};
use crate::signals::Channel;

/// A force loop.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceLoop {
    pub(super) plant: Plant,
    pub(super) controller: Controller,
    pub(super) feedback: Channel,
    pub(super) delay: f64,
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
        Ok(Self { plant, controller, feedback, delay })
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

    /// C e^(−sT).
    pub(super) fn control(&self, s: Complex64) -> Complex64 {
        let stiffness = self.plant.spring().stiffness();
        self.controller.feedback_at(self.plant.drive(), stiffness, s) * (-s * self.delay).exp()
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
        Margins::of(&self.trace()?, |frequency| self.at(frequency))
    }

    /// Force over reference \[1\] of the closed loop, for the force that is fed back: (C + feed-forward) P / (1 + L).
    ///
    /// # Errors
    /// As [`Self::at`].
    pub fn tracking(&self, angular_frequency: f64) -> Result<Complex64, Error> {
        let plant = self.plant.at(angular_frequency)?.of(self.feedback)?;
        let s = Complex64::new(0.0, angular_frequency);
        let forward = self.controller.forward().at(s);
        Ok(forward * plant / (1.0 + self.carried(angular_frequency, plant)))
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
