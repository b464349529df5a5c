//! The loop as a computer closes it: a force every h seconds, a command held in between.
//!
//! Next door: the continuous loop (`force_loop`), the same run over time (`simulate`).

use std::f64::consts::{PI, TAU};

use num_complex::Complex64;

use super::drive::Drive;
use super::environment::Environment;
use super::estimator::Estimator;
use super::force_loop::ForceLoop;
use super::kicked::{Mode, modes};
use super::margins::Margins;
use super::rational::Difference;
use super::trace::Trace;
use crate::error::{Error, above_zero, called, check};
use crate::mount::FarEnd;
use crate::signals::Channel;

/// A loop in samples.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledLoop {
    pub(super) continuous: ForceLoop,
    pub(super) step: f64,
    pub(super) late: usize,
    /// From force to command, and from reference to command.
    pub(super) control: Difference,
    pub(super) forward: Difference,
    modes: Option<Vec<Mode>>,
    pub(super) estimator: Option<Estimator>,
}

/// Sampling copies on each side that the sum over them keeps.
const COPIES: i32 = 40;

impl SampledLoop {
    /// The loop at steps of h \[s\]: the controller by Tustin's rule, its command held, the loop's delay as whole steps.
    ///
    /// # Errors
    /// [`Error::Value`] for a step that is not above zero, a delay that is no whole number of steps (to 1e-6 of one), or a step that leaves no
    /// room for the first surge line below half its rate.
    pub fn new(continuous: &ForceLoop, step: f64) -> Result<Self, Error> {
        above_zero(called("step", "sample time"), step, "s")?;
        let spring = continuous.plant().spring();
        let nyquist = 0.5 / step;
        let surge = spring.surge_frequency();
        check(
            nyquist > surge,
            "half the sample rate",
            nyquist,
            "Hz",
            format!("above the surge frequency of {surge} Hz"),
        )?;
        let steps = continuous.delay / step;
        let whole = (steps - steps.round()).abs() <= 1e-6 && steps <= 1e4;
        check(
            whole,
            called("delay", "loop delay"),
            continuous.delay,
            "s",
            format!("a whole number of sample times of {step} s"),
        )?;
        let control = continuous.controller.feedback(continuous.plant().drive(), spring.stiffness()).tustin(step);
        let forward = continuous.controller.forward().tustin(step);
        let modes = modes(continuous, step)?;
        Ok(Self {
            continuous: continuous.clone(),
            step,
            late: steps.round() as usize,
            control,
            forward,
            modes,
            estimator: None,
        })
    }

    /// The same with what an estimator makes of F_i and the ends' positions fed back in place of F_i.
    ///
    /// # Errors
    /// [`Error::MissingSignal`] unless F_i is fed back and end 2 held; [`Error::Value`] for a drive that is no ideal velocity source, whose
    /// position is not known from sample to sample.
    pub fn behind(self, estimator: Estimator) -> Result<Self, Error> {
        if self.continuous.feedback() != Channel::InputForce {
            return Err(Error::MissingSignal(Channel::InputForce.name()));
        }
        if far_end(&self)? != FarEnd::Position {
            return Err(Error::MissingSignal(Channel::U2.name()));
        }
        Ok(Self { estimator: Some(estimator), ..self })
    }

    /// Loop response at one angular frequency below π/h \[rad/s\].
    ///
    /// F(z)/c(z) = h z⁻¹/(1 − z⁻¹) k + (1 − z⁻¹) Σ_j (a mode kicked by each change of velocity), z = e^(jωh), for an ideal velocity source with
    /// end 2 held or carrying a mass: no approximation. Otherwise (1/h) Σ_m P(j(ω + 2πm/h)) (1 − z⁻¹)/(j(ω + 2πm/h)) over 81 copies.
    ///
    /// Source:   definition of the z-transform; `[Oppenheim2010]` for the sum over copies.
    /// Valid:    small motions. With a mass on end 2 damping is that of the mounted modes ([`crate::Damping`]).
    /// Accuracy: exact but for rounding, 1e-12; the sum over copies drops terms of 1e-3 of the response at π/h for F_i of a velocity source,
    /// far less for the others.
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not above zero and at most π/h.
    pub fn at(&self, angular_frequency: f64) -> Result<Complex64, Error> {
        let nyquist = PI / self.step;
        let holds = angular_frequency > 0.0 && angular_frequency <= nyquist;
        check(holds, "angular_frequency", angular_frequency, "rad/s", format!("above zero and at most {nyquist}"))?;
        let delay = Complex64::from_polar(1.0, -angular_frequency * self.step);
        let force = match &self.modes {
            Some(modes) => self.by_modes(modes, delay),
            None => self.by_copies(angular_frequency, delay)?,
        };
        let force = match &self.estimator {
            None => force,
            Some(estimator) => {
                let [by_force, by_stroke] = estimator.response(delay);
                by_force * force + by_stroke * self.step * delay / (1.0 - delay)
            }
        };
        Ok(force * self.control.at(delay) * delay.powu(self.late as u32))
    }

    fn by_modes(&self, modes: &[Mode], delay: Complex64) -> Complex64 {
        let held = *self.continuous.plant().environment() == Environment::Held;
        let stiffness = if held { self.continuous.plant().spring().stiffness() } else { 0.0 };
        let straight = stiffness * self.step * delay / (1.0 - delay);
        let ringing: Complex64 = modes.iter().map(|mode| mode.at(delay)).sum();
        straight + (1.0 - delay) * ringing
    }

    fn by_copies(&self, angular_frequency: f64, delay: Complex64) -> Result<Complex64, Error> {
        let mut sum = Complex64::ZERO;
        for copy in -COPIES..=COPIES {
            let frequency = angular_frequency + TAU * f64::from(copy) / self.step;
            let ahead = self.continuous.plant().at(frequency.abs())?.of(self.continuous.feedback())?;
            let plant = if frequency < 0.0 { ahead.conj() } else { ahead };
            sum += plant / Complex64::new(0.0, frequency);
        }
        Ok(sum * (1.0 - delay) / self.step)
    }

    /// The response as finely as it turns, up to π/h.
    ///
    /// # Errors
    /// As [`ForceLoop::trace`].
    pub fn trace(&self) -> Result<Trace, Error> {
        self.continuous.plant().check_damped()?;
        let (from, _) = self.continuous.range();
        let nyquist = PI / self.step;
        // Lines above half the rate are folded.
        let folded = self.continuous.known().into_iter().map(|line| {
            let within = line.rem_euclid(2.0 * nyquist);
            within.min(2.0 * nyquist - within)
        });
        Trace::of(|frequency| self.at(frequency), from, nyquist, folded)
    }

    /// How far the sampled loop is from unstable.
    ///
    /// # Errors
    /// As [`Self::trace`].
    pub fn margins(&self) -> Result<Margins, Error> {
        Margins::of(&self.trace()?, |frequency| self.at(frequency))
    }
}

/// What end 2 of a loop that can be run is tied to.
pub(super) fn far_end(sampled: &SampledLoop) -> Result<FarEnd, Error> {
    let plant = sampled.continuous.plant();
    let bandwidth = match plant.drive() {
        Drive::Velocity { bandwidth } => bandwidth.unwrap_or(f64::INFINITY),
        Drive::Force { bandwidth, .. } => bandwidth.unwrap_or(0.0),
    };
    let only = "that of an ideal velocity source for a run over time";
    check(bandwidth.is_infinite(), called("bandwidth", "drive bandwidth"), bandwidth, "Hz", only)?;
    let far_end = match *plant.environment() {
        Environment::Held => FarEnd::Position,
        Environment::Impedance { mass, damping, stiffness } => {
            check(damping == 0.0, called("damping", "load damping"), damping, "N s/m", "zero for a run over time")?;
            check(
                stiffness == 0.0,
                called("stiffness", "load stiffness"),
                stiffness,
                "N/m",
                "zero for a run over time",
            )?;
            FarEnd::Mass(mass)
        }
    };
    let feedback = sampled.continuous.feedback();
    let simple = [Channel::InputForce, Channel::OutputForce].contains(&feedback)
        || (feedback == Channel::DeflectionForce && far_end == FarEnd::Position);
    if simple { Ok(far_end) } else { Err(Error::MissingSignal(feedback.name())) }
}
