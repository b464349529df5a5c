//! The spring over frequency: two ends, two forces, exact for the chain and for the wave, with damping.
//!
//! Conventions: time factor e^(jωt); U1, U2 displacements about the mean, F_i, F_o forces about theirs, tension-positive;
//! positions grow from end 1 to end 2. No mode is left out: undamped, mass-proportional, stiffness-proportional and hysteretic
//! springs have closed forms, modal ratios the full sum over modes.
//!
//! ```
//! # let spring = coilsense::paper::s_t();
//! use coilsense::Damping;
//! use coilsense::two_port::{Load, TwoPort};
//!
//! let ends = TwoPort::chain(&spring, Damping::Modal(0.005))?.at(std::f64::consts::TAU * 10.0)?;
//! // A foot of 1 kg on end 2: at 10 Hz it feels 11 % more force than is measured at end 1.
//! assert!((ends.transmittance(&Load::mass(1.0)?).re - 1.115).abs() < 1e-3);
//! # Ok::<(), coilsense::Error>(())
//! ```
//!
//! Next door: the motion over time (`motion`), the modes (`modes`).

mod cascade;
mod load;
mod loaded;
mod modal;
mod phase;
mod propagation;
mod response;
mod transmission;
mod trigonometry;

use num_complex::Complex64;

pub use cascade::Cascade;
pub use load::Load;
pub use response::{DynamicStiffness, Matrix};
pub use transmission::Transmission;

use crate::damping::Damping;
use crate::error::{Error, check, number_of};
use crate::spring::Spring;
use modal::Mode;
use phase::{Loss, Phase, moderate};
use propagation::{Inertia, Propagation};

/// A spring with its damping, ready for any frequency.
///
/// Undamped, both ends follow from one phase z = ωτ (chain: sin(θ/2) = z/2N; wave: Nθ = z):
/// p = k_d − k_t = −2Nk tan(θ/2) tan(Nθ/2), q = k_d + k_t = 2Nk tan(θ/2) cot(Nθ/2).
/// Written as p = −m ω² μ(z), q = 2K − m ω² ν(z), the damped spring keeps these two functions:
///
/// | damping | K | z² | why |
/// |---|---|---|---|
/// | none | k | ω²τ² | |
/// | mass-proportional α | k | (ω² − jαω) τ² | ω_j² − ω² + jαω = ω_j² − z²/τ² |
/// | stiffness-proportional β | k | ω²τ² / (1 + jωβ) | the dashpots' 1 + jωβ over ω_j² (1 + jωβ) − ω² is 1 / (ω_j² − z²/τ²) |
/// | hysteretic η | k (1 + jη) | ω²τ² / (1 + jη) | k is complex everywhere; at ω = 0, where a force is real, K = k |
/// | modal ζ_j | k | none | μ, ν are sums over modes |
///
/// since q_j = ω² c_j (U1 + σ_j U2) / (ω_j² − ω² + 2j ζ_j ω_j ω) makes μ, ν the sums of (2N/n_j) / (… τ²) over odd and even j.
#[derive(Debug, Clone, PartialEq)]
pub struct TwoPort {
    stiffness: f64,
    mass: f64,
    transit_time: f64,
    law: Law,
}

/// What the ends obey.
#[derive(Debug, Clone, PartialEq)]
enum Law {
    /// N masses, in closed form.
    Chain(usize, Loss),
    /// The continuous coil, in closed form.
    Wave(Loss),
    /// All modes of the chain.
    ChainModes(Vec<Mode>),
    /// Ratios of the first modes of the continuous coil, the last for all that follow.
    WaveModes(Vec<f64>),
}

/// Largest |ωτ| taken: beyond it rounding of ωτ alone is 1e-4 rad.
const LARGEST_PHASE: f64 = 1e12;

impl TwoPort {
    /// The paper's chain of N masses.
    ///
    /// # Errors
    /// [`Error::Value`] where a number of the damping is not finite, below zero or above 1e12; [`Error::Count`] where modal ratios are
    /// not exactly one for each mass.
    pub fn chain(spring: &Spring, damping: Damping) -> Result<Self, Error> {
        spring.check_uniform("its two-port")?;
        let masses = spring.chain_masses();
        let damping = moderate(damping)?;
        if let Some(loss) = Loss::of(&damping) {
            return Ok(Self::new(spring, Law::Chain(masses, loss)));
        }
        let frequencies = modal::chain_frequencies(masses);
        let ratios = damping.ratios(&frequencies)?;
        let modes = frequencies.into_iter().zip(ratios);
        let modes = modes.map(|(frequency, ratio)| Mode { frequency, ratio }).collect();
        Ok(Self::new(spring, Law::ChainModes(modes)))
    }

    /// The continuous coil, N → ∞.
    ///
    /// Of modal ratios one by one, the modes past the last take the last one's.
    ///
    /// # Errors
    /// [`Error::Value`] as [`Self::chain`]; [`Error::Count`] where modal ratios are an empty series.
    pub fn wave(spring: &Spring, damping: Damping) -> Result<Self, Error> {
        spring.check_uniform("its two-port")?;
        let damping = moderate(damping)?;
        let law = match (Loss::of(&damping), damping) {
            (Some(loss), _) => Law::Wave(loss),
            (None, Damping::ModalEach(ratios)) if ratios.is_empty() => return Err(no_ratios()),
            (None, Damping::ModalEach(ratios)) => Law::WaveModes(ratios),
            (None, other) => Law::WaveModes(other.ratios(&[spring.transit_time().recip()])?),
        };
        Ok(Self::new(spring, law))
    }

    fn new(spring: &Spring, law: Law) -> Self {
        Self { stiffness: spring.stiffness(), mass: spring.mass(), transit_time: spring.transit_time(), law }
    }

    /// The two-port at one angular frequency.
    ///
    /// - `angular_frequency`: ω \[rad/s\], of either sign (−ω gives the conjugate), zero included
    ///
    /// Source:   the table of [`TwoPort`].
    /// Valid:    |ωτ| ≤ 1e12. Cost: a few dozen functions; with modal ratios of a chain N terms.
    /// Accuracy: see [`DynamicStiffness`]; against 25-digit direct solves of the windings' equations.
    ///
    /// # Errors
    /// [`Error::Value`] where ω is not finite or above 1e12/τ.
    pub fn at(&self, angular_frequency: f64) -> Result<DynamicStiffness, Error> {
        let phase = angular_frequency.abs() * self.transit_time;
        // The text is made only where it is needed: this is asked at every frequency.
        if phase.is_nan() || phase > LARGEST_PHASE {
            let allowed = format!("finite and at most {} in size", LARGEST_PHASE / self.transit_time);
            check(false, "angular_frequency", angular_frequency, "rad/s", allowed)?;
        }
        let found = self.ahead(angular_frequency.abs(), phase);
        Ok(if angular_frequency < 0.0 { found.conjugate() } else { found })
    }

    /// As [`Self::at`], ω ≥ 0.
    fn ahead(&self, omega: f64, phase: f64) -> DynamicStiffness {
        let complex = |loss: &Loss| loss.at(omega, phase, self.transit_time);
        match &self.law {
            Law::Chain(masses, loss) => {
                let at = complex(loss);
                self.closed(phase, at, propagation::chain(*masses, at.phase))
            }
            Law::Wave(loss) => {
                let at = complex(loss);
                self.closed(phase, at, propagation::wave(at.phase))
            }
            Law::ChainModes(modes) => self.summed(phase, self.stiffness.into(), modal::chain(modes, phase)),
            Law::WaveModes(ratios) => self.summed(phase, self.stiffness.into(), modal::wave(ratios, phase)),
        }
    }

    /// From μ, ν alone: k_t = K + m ω² (μ − ν)/2.
    fn summed(&self, phase: f64, rest: Complex64, inertia: Inertia) -> DynamicStiffness {
        let massive = self.stiffness * phase * phase;
        DynamicStiffness {
            rest,
            mass: self.mass,
            massive,
            inertia,
            transfer: rest + 0.5 * massive * (inertia.together - inertia.apart),
        }
    }

    /// From a closed form, k_t by propagation where that is better.
    fn closed(&self, phase: f64, at: Phase, found: Propagation) -> DynamicStiffness {
        let rest = at.rest * self.stiffness;
        let summed = self.summed(phase, rest, found.inertia);
        match found.transfer {
            None => summed,
            Some(transfer) if !transfer.is_finite() => DynamicStiffness { transfer, ..summed },
            Some(transfer) => {
                DynamicStiffness { transfer: rest * (at.direct + (1.0 - at.direct) * transfer), ..summed }
            }
        }
    }
}

fn no_ratios() -> Error {
    number_of("damping_ratios", 0, "at least 1")
}
