//! The loop as a computer closes it: a force every h seconds, a command held in between.
//!
//! Next door: the continuous loop (`force_loop`), the same run over time (`over_time`).

use std::f64::consts::{PI, TAU};

use num_complex::Complex64;

use super::drive::Drive;
use super::environment::Environment;
use super::estimator::Estimator;
use super::force_loop::ForceLoop;
use super::kicked::{Kicked, Modes};
use super::margins::Margins;
use super::plant::Response;
use super::rational::{Difference, Rational};
use super::trace::Trace;
use crate::error::{Error, above_zero, called, check};
use crate::signals::Channel;

/// Half an angle per sample up to which a law is taken by its own s \[rad\].
const SLOW: f64 = 0.5;

/// A loop in samples.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledLoop {
    pub(super) continuous: ForceLoop,
    pub(super) step: f64,
    pub(super) late: usize,
    /// From force to command, and from reference to command.
    pub(super) control: Difference,
    pub(super) forward: Difference,
    /// The same two as they are continuous.
    laws: [Rational; 2],
    modes: Option<Modes>,
    pub(super) estimator: Option<Estimator>,
}

/// Sampling copies on each side that the sum over them keeps, at least and at most, and past how many times what bends the response.
const COPIES: [f64; 2] = [10.0, 40.0];
const PAST: f64 = 4.0;

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
        let laws = [continuous.feedback_law(), continuous.controller.forward()];
        let [control, forward] = [0, 1].map(|law| laws[law].tustin(step));
        let modes = Modes::of(continuous, step)?;
        Ok(Self {
            continuous: continuous.clone(),
            step,
            late: steps.round() as usize,
            control,
            forward,
            laws,
            modes,
            estimator: None,
        })
    }

    /// The same with what an estimator makes of F_i and the ends' positions fed back in place of F_i. A drive's position is measured with F_i.
    ///
    /// # Errors
    /// [`Error::MissingSignal`] unless F_i is fed back and end 2 held.
    pub fn behind(self, estimator: Estimator) -> Result<Self, Error> {
        if self.continuous.feedback() != Channel::InputForce {
            return Err(Error::MissingSignal(Channel::InputForce.name()));
        }
        if *self.continuous.plant().environment() != Environment::Held {
            return Err(Error::MissingSignal(Channel::U2.name()));
        }
        Ok(Self { estimator: Some(estimator), ..self })
    }

    /// Loop response at one angular frequency below π/h \[rad/s\].
    ///
    /// F(z)/c(z) = h z⁻¹/(1 − z⁻¹) k + (1 − z⁻¹) Σ_j (a mode kicked by each change of velocity), z = e^(jωh), for an ideal velocity source with
    /// end 2 held or carrying a mass, and the like with a push e^(−bt) in place of each kick where the source has a lag 1/(1 + s/b): no
    /// approximation. Otherwise (1/h) Σ_m P(j(ω + 2πm/h)) (1 − z⁻¹)/(j(ω + 2πm/h)) over 21 to 81 copies and, past twice the chain's cut-off, the
    /// power of frequency with which the rest falls. A force that jumps with the command (dashpots at an end that
    /// an ideal velocity source moves) is measured before it does.
    ///
    /// Source:   definition of the z-transform; `[Oppenheim2010]` for the sum over copies.
    /// Valid:    small motions. With a mass on end 2 damping is that of the mounted modes ([`crate::Damping`]).
    /// Accuracy: exact but for rounding, 1e-12; the sum over copies finds limits of stability to 1e-6 (test).
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not above zero and at most π/h.
    pub fn at(&self, angular_frequency: f64) -> Result<Complex64, Error> {
        let nyquist = PI / self.step;
        // The text is made only where it is needed: this is asked at every frequency.
        if !(angular_frequency > 0.0 && angular_frequency <= nyquist) {
            check(false, "angular_frequency", angular_frequency, "rad/s", format!("above zero and at most {nyquist}"))?;
        }
        let delay = Complex64::from_polar(1.0, -angular_frequency * self.step);
        let [force, stroke] = match &self.modes {
            Some(modes) => {
                let plant = self.continuous.plant();
                let held = *plant.environment() == Environment::Held;
                modes.at(if held { plant.spring().stiffness() } else { 0.0 }, delay)
            }
            None => self.by_copies(angular_frequency, delay)?,
        };
        let force = match &self.estimator {
            None => force,
            Some(estimator) => {
                let [by_force, by_stroke] = estimator.response(delay);
                by_force * force + by_stroke * stroke
            }
        };
        Ok(force * self.law(angular_frequency))
    }

    /// From what is fed back to the command.
    fn law(&self, angular_frequency: f64) -> Complex64 {
        self.by_tustin(&self.laws[0], &self.control, angular_frequency)
    }

    /// A law of the controller in samples, with its delay: where ω is small beside the rate by Tustin's s itself, since the poles of a slow law lie at
    /// z = 1 together, where its polynomials in z cancel.
    fn by_tustin(&self, law: &Rational, difference: &Difference, angular_frequency: f64) -> Complex64 {
        let delay = Complex64::from_polar(1.0, -angular_frequency * self.step);
        let half = 0.5 * angular_frequency * self.step;
        let response =
            if half < SLOW { law.at(Complex64::new(0.0, 2.0 / self.step * half.tan())) } else { difference.at(delay) };
        response * delay.powu(self.late as u32)
    }

    /// What is fed back per command, sample by sample \[N per command\], from the loop's `response` at that angular frequency \[rad/s\]: the same at
    /// every gain.
    pub fn read(&self, angular_frequency: f64, response: Complex64) -> Complex64 {
        response / self.law(angular_frequency)
    }

    /// What the plant does at an angular frequency \[rad/s\] per newton of the sampled reference with the loop closed: from its own `response` per
    /// command there, which [`Plant::at`](super::Plant::at) gives, and from what is [`read`](Self::read).
    ///
    /// F/r = P(jω) (1 − z⁻¹)/(jωh) z^(−late) C_r(z)/(1 + L(z)), z = e^(jωh): of the command's steps the part at ω. Above half the rate it is what a
    /// reference that is seen at its alias excites there; the response of samples has a period of 2π/h and is conjugate about half of it.
    ///
    /// Source:   definition of the z-transform and of the hold; `[Franklin1998]`.
    /// Valid:    as [`Self::at`].
    /// Accuracy: summed over copies it is the run over time's own response to 2e-3, where the sum ends (test).
    pub fn closed(&self, angular_frequency: f64, response: &Response, read: Complex64) -> Response {
        let delay = Complex64::from_polar(1.0, -angular_frequency * self.step);
        let held = (1.0 - delay) / Complex64::new(0.0, angular_frequency * self.step);
        let reference = self.by_tustin(&self.laws[1], &self.forward, angular_frequency);
        response.times(held * reference / (1.0 + read * self.law(angular_frequency)))
    }

    /// The loop that is closed in samples.
    pub fn continuous(&self) -> &ForceLoop {
        &self.continuous
    }

    /// From sample to sample \[s\].
    pub fn step(&self) -> f64 {
        self.step
    }

    /// F and y over the command, in samples.
    fn by_copies(&self, angular_frequency: f64, delay: Complex64) -> Result<[Complex64; 2], Error> {
        let rate = TAU / self.step;
        let plant = self.continuous.plant();
        let jump = plant.jump(self.continuous.feedback());
        let one = |copy: i32| {
            let frequency = angular_frequency + rate * f64::from(copy);
            let ahead = plant.at(frequency.abs())?;
            let both = [ahead.of(self.continuous.feedback())? - jump, ahead.stroke];
            let found = if frequency < 0.0 { both.map(|value| value.conj()) } else { both };
            Ok::<_, Error>(found.map(|value| value / Complex64::new(0.0, frequency)))
        };
        let mut sum = [Complex64::ZERO; 2];
        let mut edges = [[[Complex64::ZERO; 2]; 2]; 2];
        let copies = self.copies();
        for copy in -copies..=copies {
            let terms = one(copy)?;
            sum = [sum[0] + terms[0], sum[1] + terms[1]];
            if copy.abs() >= copies - 1 {
                edges[usize::from(copy > 0)][usize::from(copy.abs() == copies)] = terms;
            }
        }
        for (side, [inner, outer]) in edges.into_iter().enumerate() {
            let at = |copies: f64| (if side == 1 { angular_frequency } else { -angular_frequency }) + rate * copies;
            let frequencies = [-1.0, 0.0, 0.5].map(|further| at(f64::from(copies) + further));
            for (sum, ends) in sum.iter_mut().zip(inner.into_iter().zip(outer)) {
                *sum += self.rest(ends, frequencies);
            }
        }
        let [force, stroke] = sum.map(|sum| sum * (1.0 - delay) / self.step);
        // What jumps with the command is measured just before it does.
        Ok([force + jump * delay, stroke])
    }

    /// How many copies: up to where the response is a power of frequency, past the chain's cut-off and the corners of the drive.
    fn copies(&self) -> i32 {
        let spring = self.continuous.plant().spring();
        let chain = 2.0 * spring.chain_masses() as f64;
        let cut_off = chain / spring.transit_time();
        let corner = match *self.continuous.plant().drive() {
            Drive::Velocity { bandwidth } => TAU * bandwidth.unwrap_or(0.0),
            Drive::Force { mass, friction, bandwidth } => {
                let bends = (friction / mass).max((chain * spring.stiffness() / mass).sqrt());
                bends.max(TAU * bandwidth.unwrap_or(0.0))
            }
        };
        (PAST * cut_off.max(corner) * self.step / TAU + 6.0).clamp(COPIES[0], COPIES[1]).ceil() as i32
    }

    /// What copies past the last two add up to: beyond the chain's cut-off a term falls with a whole power of frequency.
    fn rest(&self, (inner, outer): (Complex64, Complex64), [before, last, from]: [f64; 3]) -> Complex64 {
        let spring = self.continuous.plant().spring();
        let cut_off = 2.0 * spring.chain_masses() as f64 / spring.transit_time();
        if before < 2.0 * cut_off || outer.norm() == 0.0 {
            return Complex64::ZERO;
        }
        let power = ((inner.norm() / outer.norm()).ln() / (last / before).ln()).round().max(2.0);
        // Σ ω_m^−p over every step of 2π/h is the integral from half a step on.
        outer * from * (last / from).powf(power) * self.step / (TAU * (power - 1.0))
    }

    /// Modes at work where F_x is not k times the drive's stroke.
    pub(super) fn kicked(&self) -> Option<Kicked> {
        let plant = self.continuous.plant();
        let follows =
            self.continuous.feedback() == Channel::DeflectionForce && *plant.environment() != Environment::Held;
        self.modes.as_ref().filter(|_| follows).and_then(Kicked::new)
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
        let trace = self.trace()?;
        Margins::of(&trace, trace.points().last().copied(), |frequency| self.at(frequency))
    }
}
