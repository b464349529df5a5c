//! The loop as a computer closes it: a force every h seconds, a command held in between.
//!
//! Next door: the continuous loop (`force_loop`), the same run over time (`simulate`).

use std::f64::consts::{PI, TAU};

use num_complex::Complex64;

use super::drive::Drive;
use super::environment::Environment;
use super::force_loop::ForceLoop;
use super::margins::Margins;
use super::rational::Difference;
use super::trace::Trace;
use crate::error::{Error, above_zero, check};
use crate::modes::ChainModes;
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
}

/// What a mode adds to the force, from kicks at samples: w p z⁻¹ / (1 − 2 r cos(φ) z⁻¹ + r² z⁻²).
#[derive(Debug, Clone, Copy, PartialEq)]
struct Mode {
    /// Force after one step of a unit kick's free answer \[N s/m\].
    kicked: f64,
    /// 2 r cos φ and r².
    backward: [f64; 2],
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
        above_zero("sample time", step, "s")?;
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
        check(whole, "loop delay", continuous.delay, "s", format!("a whole number of sample times of {step} s"))?;
        let control = continuous.controller.feedback(continuous.plant().drive(), spring.stiffness()).tustin(step);
        let forward = continuous.controller.forward().tustin(step);
        let modes = modes(continuous, step)?;
        Ok(Self { continuous: continuous.clone(), step, late: steps.round() as usize, control, forward, modes })
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
        check(holds, "angular frequency", angular_frequency, "rad/s", format!("above zero and at most {nyquist}"))?;
        let delay = Complex64::from_polar(1.0, -angular_frequency * self.step);
        let force = match &self.modes {
            Some(modes) => self.by_modes(modes, delay),
            None => self.by_copies(angular_frequency, delay)?,
        };
        Ok(force * self.control.at(delay) * delay.powu(self.late as u32))
    }

    fn by_modes(&self, modes: &[Mode], delay: Complex64) -> Complex64 {
        let held = *self.continuous.plant().environment() == Environment::Held;
        let stiffness = if held { self.continuous.plant().spring().stiffness() } else { 0.0 };
        let straight = stiffness * self.step * delay / (1.0 - delay);
        let ringing: Complex64 = modes
            .iter()
            .map(|mode| mode.kicked * delay / (1.0 - mode.backward[0] * delay + mode.backward[1] * delay * delay))
            .sum();
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

/// The mounted chain's modes as they answer kicks at samples; `None` where the drive or the environment is of another kind.
fn modes(force_loop: &ForceLoop, step: f64) -> Result<Option<Vec<Mode>>, Error> {
    let plant = force_loop.plant();
    let far_end = match (plant.drive(), plant.environment()) {
        (Drive::Velocity { bandwidth: None }, Environment::Held) => FarEnd::Position,
        (Drive::Velocity { bandwidth: None }, Environment::Impedance { mass, damping, stiffness })
            if *mass > 0.0 && *damping == 0.0 && *stiffness == 0.0 =>
        {
            FarEnd::Mass(*mass)
        }
        _ => return Ok(None),
    };
    let spring = plant.spring();
    let chain = ChainModes::mounted(spring, far_end);
    let by_segment = 2.0 * chain.masses() as f64 * spring.stiffness();
    let weights: Vec<f64> = match force_loop.feedback() {
        Channel::InputForce => chain.input_weights().iter().map(|weight| by_segment * weight).collect(),
        Channel::OutputForce => chain.output_weights().iter().map(|weight| by_segment * weight).collect(),
        Channel::DeflectionForce => chain.end_shapes().iter().map(|shape| spring.stiffness() * shape).collect(),
        Channel::InductanceForce if far_end == FarEnd::Position => plant.coil_weights().to_vec(),
        _ => return Ok(None),
    };
    let ratios = plant.damping().ratios(chain.frequencies())?;
    let [participations, _] = chain.participations();
    let each = chain.frequencies().iter().zip(ratios).zip(weights.iter().zip(participations));
    // A pull of +1 m/s at end 1 is a kick of −1 m/s of u1, which drives q_j by −c1_j (−1).
    Ok(Some(
        each.map(|((&frequency, ratio), (weight, drive))| Mode::of(frequency, ratio, weight * drive, step)).collect(),
    ))
}

impl Mode {
    /// q after a unit kick of its rate, times `weight`: e^(−ζωt) sin(ω_d t)/ω_d, sampled.
    fn of(frequency: f64, ratio: f64, weight: f64, step: f64) -> Self {
        let product = ratio * frequency;
        let square = (1.0 - ratio) * (1.0 + ratio);
        if square >= 0.0 {
            let damped = frequency * square.sqrt();
            let decay = (-product * step).exp();
            let turn = damped * step;
            let answer = if turn.abs() < 1e-8 { step } else { turn.sin() / damped };
            return Self { kicked: weight * decay * answer, backward: [2.0 * decay * turn.cos(), decay * decay] };
        }
        // Overdamped: two real poles.
        let spread = frequency * (-square).sqrt();
        let [slow, fast] = [(spread - product) * step, (-spread - product) * step].map(f64::exp);
        Self { kicked: weight * (slow - fast) / (2.0 * spread), backward: [slow + fast, slow * fast] }
    }
}
