//! Loops of a spec, for any force, damping and gain.
//!
//! Next door: what is asked of them (`judged`, `over_time`).

use std::f64::consts::TAU;

use coilsense::control::{Controller, ForceLoop, Gains, Passivity, Plant, SampledLoop};
use coilsense::{Channel, Error, Spring};

use super::allowed::Varied;
use super::reading::Reading;
use crate::spec::{ControlSpec, DampingCase, Spec};

/// The least gain that is looked at (command unit per N).
const LEAST_GAIN: f64 = 1e-12;

/// Makes loops of a spec.
#[derive(Clone, Copy)]
pub(super) struct UnitLoops<'a> {
    pub spec: &'a Spec,
    pub control: &'a ControlSpec,
    /// As [`Channel::FORCES`].
    pub readings: &'a [Reading],
}

/// Under what a loop is judged, beside its damping: a spring that is allowed, and how late a force may come to the command.
#[derive(Clone, Copy)]
pub(super) struct Under<'a> {
    /// Which of the springs.
    pub place: usize,
    pub spring: &'a Spring,
    /// \[s\]
    pub delay: f64,
}

/// A loop that is closed.
pub(super) enum Closed {
    Continuous(Box<ForceLoop>),
    Sampled(Box<SampledLoop>),
}

impl UnitLoops<'_> {
    pub fn surge(&self) -> f64 {
        self.spec.spring.spring.surge_frequency()
    }

    /// The crossover past which nothing is asked \[Hz\]: the tenth surge line, or a quarter of the sample rate.
    pub fn most(&self) -> f64 {
        let by_samples = self.control.sample_time.map_or(f64::INFINITY, |step| 0.25 / step);
        by_samples.min(10.0 * self.surge())
    }

    /// Every case of some springs in which a loop on a force is judged.
    pub fn under<'s>(&self, springs: &'s [Varied], channel: Channel) -> Vec<Under<'s>> {
        let delays = self.delays(channel);
        let each = springs.iter().enumerate().flat_map(|(place, varied)| {
            delays.iter().map(move |&delay| Under { place, spring: &varied.spring, delay })
        });
        each.collect()
    }

    /// How late a force may come to the command \[s\].
    pub fn delays(&self, channel: Channel) -> &[f64] {
        let of = |(force, _): &(Channel, &Reading)| *force == channel;
        let found = Channel::FORCES.into_iter().zip(self.readings).find(of);
        found.map_or(std::slice::from_ref(&self.control.delay), |(_, reading)| &reading.delays)
    }

    /// The loop on the spec's own spring, as late as it may be.
    pub fn force_loop(&self, damping: &DampingCase, channel: Channel, gain: f64) -> Result<ForceLoop, Error> {
        let delay = self.delays(channel).iter().copied().fold(0.0, f64::max);
        self.on(Under { place: 0, spring: &self.spec.spring.spring, delay }, damping, channel, gain)
    }

    /// The same loop in a case, on another spring than the one that it is designed for.
    pub fn on(&self, under: Under<'_>, damping: &DampingCase, channel: Channel, gain: f64) -> Result<ForceLoop, Error> {
        let spring = under.spring;
        let plant = Plant::new(spring, damping.mount.damping().clone(), self.control.drive, self.control.environment)?;
        let shape = self.control.shape;
        let controller = Controller::new(Gains {
            proportional: gain * shape.proportional,
            integral: gain * shape.integral,
            derivative: gain * shape.derivative,
            ..shape
        })?;
        let force_loop = ForceLoop::new(plant, controller, channel, under.delay)?;
        force_loop.designed_for(self.spec.spring.spring.stiffness())
    }

    pub fn sampled(&self, force_loop: &ForceLoop) -> Result<Option<SampledLoop>, Error> {
        self.control.sample_time.map(|step| SampledLoop::new(force_loop, step)).transpose()
    }

    /// The crossover of a loop with a spring without mass, its gains times a factor \[Hz\].
    pub fn crossover(force_loop: &ForceLoop, factor: f64) -> Result<f64, Error> {
        if factor == 0.0 || factor.is_infinite() {
            return Ok(factor);
        }
        Ok(force_loop.massless_crossover(factor)?.map_or(f64::INFINITY, |omega| omega / TAU))
    }

    /// A loop as it is closed: in samples where the controller is.
    pub fn closed(&self, force_loop: ForceLoop) -> Result<Closed, Error> {
        Ok(match self.sampled(&force_loop)? {
            Some(sampled) => Closed::Sampled(Box::new(sampled)),
            None => Closed::Continuous(Box::new(force_loop)),
        })
    }

    /// The proportional gain with which the loop of a spring without mass crosses 1 at so many hertz.
    pub fn gain_for(&self, damping: &DampingCase, crossover: f64) -> Result<f64, Error> {
        let size = |gain: f64| {
            let unit = self.force_loop(damping, Channel::DeflectionForce, gain)?;
            Ok::<f64, Error>(unit.massless(TAU * crossover)?.norm())
        };
        if self.control.shape.observer_bandwidth.is_none() {
            return Ok(1.0 / size(1.0)?);
        }
        // An observer adds to the loop whatever the gain: from where it alone is below 1, by bisection.
        let (mut low, mut high) = (LEAST_GAIN, 1.0 / LEAST_GAIN);
        for _ in 0..200 {
            let middle = f64::sqrt(low * high);
            if size(middle)? < 1.0 { low = middle } else { high = middle }
        }
        Ok(low)
    }

    /// Whether the observer alone carries a loop of a spring without mass above 1 there.
    pub fn is_observers(&self, damping: &DampingCase, crossover: f64) -> Result<bool, Error> {
        let alone = self.force_loop(damping, Channel::DeflectionForce, LEAST_GAIN)?;
        Ok(self.control.shape.observer_bandwidth.is_some() && alone.massless(TAU * crossover)?.norm() >= 1.0)
    }

    pub fn passivity(&self, force_loop: &ForceLoop) -> Result<Option<Passivity>, Error> {
        if force_loop.feedback() == Channel::InductanceForce {
            return Ok(None);
        }
        // A command held for one sample time is late by half of it.
        let late = force_loop.delay() + 0.5 * self.control.sample_time.unwrap_or(0.0);
        let late = ForceLoop::new(force_loop.plant().clone(), *force_loop.controller(), force_loop.feedback(), late)?;
        Passivity::of(&late.designed_for(self.spec.spring.spring.stiffness())?, self.control.passive_up_to).map(Some)
    }
}
