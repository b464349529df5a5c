//! Modes of the chain from sample to sample: under an ideal velocity source that holds its command they only meet kicks.
//!
//! Next door: the loop that sums them (`sampled`).

use num_complex::Complex64;

use super::drive::Drive;
use super::environment::Environment;
use super::force_loop::ForceLoop;
use crate::error::Error;
use crate::modes::ChainModes;
use crate::mount::FarEnd;
use crate::signals::Channel;

/// What a mode adds to the force, from kicks at samples: (p z⁻¹ + d z⁻²) / (1 − 2 r cos(φ) z⁻¹ + r² z⁻²), d beside dashpots only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mode {
    /// Force after one step of a unit kick's free answer, just before the next kick \[N s/m\], and what the step after has besides.
    kicked: [f64; 2],
    /// 2 r cos φ and r².
    backward: [f64; 2],
}

/// The mounted chain's modes as they answer kicks at samples; `None` where the drive or the environment is of another kind.
pub(super) fn modes(force_loop: &ForceLoop, step: f64) -> Result<Option<Vec<Mode>>, Error> {
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
    let at_an_end = [Channel::InputForce, Channel::OutputForce].contains(&force_loop.feedback());
    let dashpot = if at_an_end { plant.damping().dashpot_time() } else { 0.0 };
    let [participations, _] = chain.participations();
    let each = chain.frequencies().iter().zip(ratios).zip(weights.iter().zip(participations));
    // A pull of +1 m/s at end 1 is a kick of −1 m/s of u1, which drives q_j by −c1_j (−1).
    Ok(Some(
        each.map(|((&frequency, ratio), (weight, drive))| {
            Mode::of([frequency, ratio], [weight * drive, weight * drive * dashpot], step)
        })
        .collect(),
    ))
}

impl Mode {
    /// Σ over the samples after a unit kick of c at D = z⁻¹.
    pub fn at(&self, delay: Complex64) -> Complex64 {
        let fed = self.kicked[0] + self.kicked[1] * delay;
        fed * delay / (1.0 - self.backward[0] * delay + self.backward[1] * delay * delay)
    }

    /// w q + d q̇ after a unit kick of q̇, sampled: q = e^(−ζωt) sin(ω_d t)/ω_d.
    fn of([frequency, ratio]: [f64; 2], [weight, dashpot]: [f64; 2], step: f64) -> Self {
        let product = ratio * frequency;
        let square = (1.0 - ratio) * (1.0 + ratio);
        let [answer, rate, sum, decay] = if square >= 0.0 {
            let damped = frequency * square.sqrt();
            let decay = (-product * step).exp();
            let turn = damped * step;
            let answer = decay * if turn.abs() < 1e-8 { step } else { turn.sin() / damped };
            [answer, decay * turn.cos() - product * answer, 2.0 * decay * turn.cos(), decay * decay]
        } else {
            // Overdamped: two real poles.
            let spread = frequency * (-square).sqrt();
            let poles = [spread - product, -spread - product];
            let [slow, fast] = poles.map(|pole| (pole * step).exp());
            let rate = (poles[0] * slow - poles[1] * fast) / (2.0 * spread);
            [(slow - fast) / (2.0 * spread), rate, slow + fast, slow * fast]
        };
        // q̇ begins at one, of which the sample before the kick knows nothing.
        Self { kicked: [weight * answer + dashpot * rate, -dashpot * decay], backward: [sum, decay] }
    }
}

/// Modes at work, sample by sample: the force of windings and of an end that moves, less that of a straight line.
#[derive(Debug, Clone)]
pub(super) struct Kicked {
    each: Vec<(Mode, [f64; 2])>,
    command: f64,
    kick: f64,
}

impl Kicked {
    /// At rest.
    pub fn new(modes: &[Mode]) -> Self {
        Self { each: modes.iter().map(|mode| (*mode, [0.0; 2])).collect(), command: 0.0, kick: 0.0 }
    }

    /// The force at this sample \[N\].
    pub fn force(&self) -> f64 {
        self.each.iter().map(|(_, [now, _])| now).sum()
    }

    /// Goes on by a step at a velocity \[m/s\].
    pub fn advance(&mut self, command: f64) {
        let kick = command - self.command;
        for (mode, [now, before]) in &mut self.each {
            let kicked = mode.kicked[0] * kick + mode.kicked[1] * self.kick;
            let next = kicked + mode.backward[0] * *now - mode.backward[1] * *before;
            (*before, *now) = (*now, next);
        }
        (self.command, self.kick) = (command, kick);
    }
}
