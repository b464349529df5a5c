//! The inductance in a loop: what windings out of line add to the force by it, mode by mode.
//!
//! Next door: the other forces (`plant`), inductance as such (`crate::inductance`).

use num_complex::Complex64;

use crate::damping::Damping;
use crate::error::Error;
use crate::inductance::{MaxwellSum, SelfDistance};
use crate::modes::ChainModes;
use crate::spring::Spring;

/// What windings out of line do to the inductance's force, mode by mode.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Coil {
    /// ω_j \[rad/s\].
    pub frequencies: Vec<f64>,
    /// ζ_j.
    pub ratios: Vec<f64>,
    /// c1_j, c2_j.
    participations: [Vec<f64>; 2],
    /// Force by the inductance per modal coordinate \[N/m\].
    pub weights: Vec<f64>,
}

impl Coil {
    /// Of a spring at the middle of its operating range.
    pub fn of(spring: &Spring, damping: &Damping) -> Result<Self, Error> {
        let modes = ChainModes::of(spring);
        let (masses, length) = (modes.masses(), spring.mid_length());
        let places: Vec<f64> = (1..=masses).map(|winding| (winding as f64 - 0.5) / masses as f64).collect();
        let uniform: Vec<f64> = places.iter().map(|place| place * length).collect();
        let gradient = MaxwellSum::new(spring, SelfDistance::AsPrinted).gradient([0.0, length], &uniform)?;
        // dL/dl of a uniform stretch: what a calibration divides by.
        let stretch: f64 = gradient[1..=masses].iter().zip(&places).map(|(slope, place)| slope * place).sum();
        let by_length = stretch + gradient[masses + 1];
        let weight = |mode: usize| {
            let shape = (1..=masses).map(|winding| gradient[winding] * modes.shape_at(mode, winding));
            spring.stiffness() * shape.sum::<f64>() / by_length
        };
        let ratios = damping.ratios(modes.frequencies())?;
        let [first, second] = modes.participations();
        Ok(Self {
            weights: (1..=modes.count()).map(weight).collect(),
            participations: [first.to_vec(), second.to_vec()],
            frequencies: modes.frequencies().to_vec(),
            ratios,
        })
    }

    /// Force by windings out of line over U1 \[N/m\], end 2 following by `follow`: Σ w_j q_j/U1, q_j = −s² (c1 + c2 R)/(s² + 2ζωs + ω²).
    pub fn surge(&self, s: Complex64, follow: Complex64) -> Complex64 {
        let [first, second] = &self.participations;
        let each = self.frequencies.iter().zip(&self.ratios).zip(first.iter().zip(second)).zip(&self.weights);
        each.map(|(((frequency, ratio), (c1, c2)), weight)| {
            let resonance = s * s + 2.0 * ratio * frequency * s + frequency * frequency;
            -weight * s * s * (c1 + c2 * follow) / resonance
        })
        .sum()
    }
}
