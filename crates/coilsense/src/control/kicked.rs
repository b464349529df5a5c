//! Modes of the chain from sample to sample, under a velocity source that holds its command: an ideal one kicks them at each sample, one with a lag pushes
//! them ever less from there on.
//!
//! Next door: the loop that sums them (`sampled`).

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::drive::Drive;
use super::environment::Environment;
use super::force_loop::ForceLoop;
use crate::error::Error;
use crate::modes::ChainModes;
use crate::mount::FarEnd;
use crate::signals::Channel;

/// A velocity source from sample to sample, and the modes that it drives.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Modes {
    each: Vec<Mode>,
    lag: Option<Lag>,
    step: f64,
}

/// A first-order lag in samples: what is left after one of what velocity lacks \[1\], and how much stroke a sample's step is short of \[s\].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Lag {
    left: f64,
    short: f64,
}

/// What a mode adds to the force, from kicks at samples: (p z⁻¹ + d z⁻²) / (1 − 2 r cos(φ) z⁻¹ + r² z⁻²); d is zero for kicks, but beside dashpots.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Mode {
    /// Force after one step of a unit kick's free answer, just before the next kick \[N s/m\], and what the step after has besides.
    kicked: [f64; 2],
    /// 2 r cos φ and r².
    backward: [f64; 2],
}

/// A drive's pole is this far from a mode's at least, over the square of both \[1\]: nearer ones stand for a double one, with ever fewer digits.
const APART: f64 = 1e-3;

impl Modes {
    /// The mounted chain's modes; `None` where the drive or the environment is of another kind, end 2 carries a mass behind a drive with a lag, or a
    /// critical mode is as fast as the drive.
    pub fn of(force_loop: &ForceLoop, step: f64) -> Result<Option<Self>, Error> {
        let plant = force_loop.plant();
        let &Drive::Velocity { bandwidth } = plant.drive() else { return Ok(None) };
        let far_end = match *plant.environment() {
            Environment::Held => FarEnd::Position,
            // Its modes have their damping with the mass, as a run over time on them has; behind a lag that run is of the plant's own poles.
            Environment::Impedance { mass, damping: 0.0, stiffness: 0.0 } if mass > 0.0 && bandwidth.is_none() => {
                FarEnd::Mass(mass)
            }
            Environment::Impedance { .. } => return Ok(None),
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
        let corner = bandwidth.map(|bandwidth| TAU * bandwidth);
        let each = chain.frequencies().iter().zip(ratios).zip(weights.iter().zip(participations));
        // A pull of +1 m/s at end 1 is a kick of −1 m/s of u1, which drives q_j by −c1_j (−1).
        let each = each.map(|((&frequency, ratio), (weight, drive))| {
            Mode::of([frequency, ratio], [weight * drive, weight * drive * dashpot], step, corner)
        });
        let lag = corner.map(|corner| Lag { left: (-corner * step).exp(), short: -(-corner * step).exp_m1() / corner });
        Ok(each.collect::<Option<_>>().map(|each| Self { each, lag, step }))
    }

    /// Force per command, a straight line's stiffness \[N/m\] with the modes, and stroke per command, at D = z⁻¹.
    pub fn at(&self, stiffness: f64, delay: Complex64) -> [Complex64; 2] {
        // Of each change of the command what is not there at once.
        let kick = (1.0 - delay) / (1.0 - self.lag.map_or(0.0, |lag| lag.left) * delay);
        let stroke = (self.step - self.lag.map_or(0.0, |lag| lag.short) * kick) * delay / (1.0 - delay);
        let ringing: Complex64 = self.each.iter().map(|mode| mode.at(delay)).sum();
        [stiffness * stroke + kick * ringing, stroke]
    }
}

impl Mode {
    /// Σ over the samples after a unit kick of c at D = z⁻¹.
    fn at(&self, delay: Complex64) -> Complex64 {
        let fed = self.kicked[0] + self.kicked[1] * delay;
        fed * delay / (1.0 - self.backward[0] * delay + self.backward[1] * delay * delay)
    }

    /// w q + d q̇, sampled: after a unit kick of q̇, or under the push b e^(−bt) of a drive that lags behind a unit step with the corner b \[rad/s\]; `None`
    /// where that has the mode's own pole.
    fn of([frequency, ratio]: [f64; 2], [weight, dashpot]: [f64; 2], step: f64, corner: Option<f64>) -> Option<Self> {
        let free = Free::of(frequency, ratio, step);
        let [place, speed] = match corner {
            None => [free.by_kick, free.speed_by_kick],
            Some(corner) => {
                let size = corner * corner + frequency * frequency;
                let apart = size - 2.0 * ratio * frequency * corner;
                if apart.abs() < APART * size {
                    return None;
                }
                // What goes with the drive, less what rings freely so that both begin at rest.
                let (along, left) = (corner / apart, (-corner * step).exp());
                [
                    along * (left - free.by_place + corner * free.by_kick),
                    along * (-corner * left - free.speed_by_place + corner * free.speed_by_kick),
                ]
            }
        };
        // One step further, less what the mode's own past makes of it.
        let next =
            [free.by_kick * speed - free.speed_by_kick * place, free.speed_by_place * place - free.by_place * speed];
        let kicked = [weight * place + dashpot * speed, weight * next[0] + dashpot * next[1]];
        Some(Self { kicked, backward: [free.by_place + free.speed_by_kick, free.decay] })
    }
}

/// A mode left alone for one step: q and q̇ after it, from q = 1 and from q̇ = 1 before it.
struct Free {
    by_place: f64,
    by_kick: f64,
    speed_by_place: f64,
    speed_by_kick: f64,
    /// Their determinant.
    decay: f64,
}

impl Free {
    /// From q̇ = 1, q = e^(−ζωt) sin(ω_d t)/ω_d.
    fn of(frequency: f64, ratio: f64, step: f64) -> Self {
        let product = ratio * frequency;
        let square = (1.0 - ratio) * (1.0 + ratio);
        let [by_kick, speed_by_kick, sum, decay] = if square >= 0.0 {
            let damped = frequency * square.sqrt();
            let decay = (-product * step).exp();
            let turn = damped * step;
            let by_kick = decay * if turn.abs() < 1e-8 { step } else { turn.sin() / damped };
            [by_kick, decay * turn.cos() - product * by_kick, 2.0 * decay * turn.cos(), decay * decay]
        } else {
            // Overdamped: two real poles.
            let spread = frequency * (-square).sqrt();
            let poles = [spread - product, -spread - product];
            let [slow, fast] = poles.map(|pole| (pole * step).exp());
            let rate = (poles[0] * slow - poles[1] * fast) / (2.0 * spread);
            [(slow - fast) / (2.0 * spread), rate, slow + fast, slow * fast]
        };
        let speed_by_place = -frequency * frequency * by_kick;
        Self { by_place: sum - speed_by_kick, by_kick, speed_by_place, speed_by_kick, decay }
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
    /// At rest; `None` of a drive with a lag, which does not kick.
    pub fn new(modes: &Modes) -> Option<Self> {
        let each = || modes.each.iter().map(|mode| (*mode, [0.0; 2])).collect();
        modes.lag.is_none().then(|| Self { each: each(), command: 0.0, kick: 0.0 })
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::controller::Controller;
    use super::super::matrices::STROKE;
    use super::super::plant::Plant;
    use super::super::poles::Poles;
    use super::super::stepped::{Hold, Stepped};
    use super::*;
    use crate::{Damping, paper};

    /// Sample time \[s\].
    const STEP: f64 = 8e-4;
    /// |z⁻¹|, so that what lasts can be summed.
    const INSIDE: f64 = 0.97;

    fn looped(bandwidth: Option<f64>, environment: Environment, damping: &Damping, force: Channel) -> ForceLoop {
        let plant = Plant::new(&paper::s_t(), damping.clone(), Drive::Velocity { bandwidth }, environment).unwrap();
        ForceLoop::new(plant, Controller::proportional(1.0).unwrap(), force, 0.0).unwrap()
    }

    /// Σ D^i of each output after a command of one sample, by the poles of the whole plant's matrix.
    fn by_poles(force_loop: &ForceLoop, delay: Complex64) -> Vec<Complex64> {
        let poles = Arc::new(Poles::of(force_loop.plant()).unwrap());
        let mut stepped = Stepped::new(poles, STEP, Hold::Zero);
        let (mut sums, mut power) = (vec![Complex64::ZERO; STROKE + 1], Complex64::ONE);
        for sample in 0..1500 {
            let outputs = stepped.outputs();
            sums.iter_mut().zip(outputs).for_each(|(sum, output)| *sum += output * power);
            power *= delay;
            stepped.take(if sample == 0 { 1.0 } else { 0.0 });
            stepped.advance();
        }
        sums
    }

    #[test]
    fn modes_under_a_lag_are_the_whole_plants_poles() {
        let dampings = [Damping::Modal(0.001), Damping::Modal(0.02), Damping::Modal(0.7), Damping::Modal(1.4)];
        let at_windings = [Damping::StiffnessProportional { time: 3e-5 }];
        for damping in dampings.iter().chain(&at_windings) {
            for bandwidth in [None, Some(0.1), Some(5.0), Some(54.0), Some(400.0), Some(1e4)] {
                let loops = Channel::FORCES.map(|force| looped(bandwidth, Environment::Held, damping, force));
                let modes = loops.each_ref().map(|force_loop| Modes::of(force_loop, STEP).unwrap().unwrap());
                let stiffness = loops[0].plant().spring().stiffness();
                for angle in [1e-3, 0.1, 0.6, 1.9, 3.0] {
                    let delay = Complex64::from_polar(INSIDE, -angle);
                    let theirs = by_poles(&loops[0], delay);
                    for (place, modes) in modes.iter().enumerate() {
                        let [ours, stroke] = modes.at(stiffness, delay);
                        let what = format!("{damping:?} {bandwidth:?} {angle} {:?}", Channel::FORCES[place]);
                        let off = [ours - theirs[place], stroke - theirs[STROKE]].map(|off| off.norm());
                        assert!(off[0] < 1e-8 * theirs[0].norm(), "{what}: {ours} {}", theirs[place]);
                        assert!(off[1] < 1e-9 * stroke.norm(), "{what}: {stroke} {}", theirs[STROKE]);
                    }
                }
            }
        }
    }

    #[test]
    fn a_critical_mode_as_fast_as_the_drive_is_no_sum_of_modes() {
        let frequency = ChainModes::of(&paper::s_t()).frequencies()[0] / TAU;
        let modes = |ratio: f64, bandwidth: f64| {
            let force_loop = looped(Some(bandwidth), Environment::Held, &Damping::Modal(ratio), Channel::InputForce);
            Modes::of(&force_loop, STEP).unwrap().is_some()
        };
        assert!(!modes(1.0, frequency) && !modes(1.0, 1.01 * frequency) && modes(1.0, 1.2 * frequency));
        assert!(modes(0.99, frequency) && modes(0.02, frequency));
    }
}
