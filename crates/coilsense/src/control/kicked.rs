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

/// What a mode adds to the force, from kicks at samples: w p z⁻¹ / (1 − 2 r cos(φ) z⁻¹ + r² z⁻²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mode {
    /// Force after one step of a unit kick's free answer \[N s/m\].
    kicked: f64,
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
    let [participations, _] = chain.participations();
    let each = chain.frequencies().iter().zip(ratios).zip(weights.iter().zip(participations));
    // A pull of +1 m/s at end 1 is a kick of −1 m/s of u1, which drives q_j by −c1_j (−1).
    Ok(Some(
        each.map(|((&frequency, ratio), (weight, drive))| Mode::of(frequency, ratio, weight * drive, step)).collect(),
    ))
}

impl Mode {
    /// Σ over the samples after a unit kick of c at D = z⁻¹.
    pub fn at(&self, delay: Complex64) -> Complex64 {
        self.kicked * delay / (1.0 - self.backward[0] * delay + self.backward[1] * delay * delay)
    }

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
