//! The inductance in a loop: what windings out of line add to the force by it, mode by mode.
//!
//! Next door: the other forces (`plant`), inductance as such (`crate::inductance`).

use num_complex::Complex64;

use crate::damping::Damping;
use crate::error::Error;
use crate::inductance::{MaxwellSum, SelfDistance};
use crate::modes::ChainModes;
use crate::motion::Windings;
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

/// The force by the inductance of windings where they are: L of all turns, the length at which uniform turns have it, k times its change.
///
/// With a calibration that is right at every length, so that what is left is what windings out of line do.
///
/// Source:   `[Weijde2017]` eqs. 8–11; the curve L(l) inverted by secants.
/// Valid:    windings that do not touch.
/// Accuracy: 1e-12 of F_nom; small motions agree with [`Coil::surge`] (test).
#[derive(Debug, Clone)]
pub(super) struct Reading {
    coil: MaxwellSum,
    modes: ChainModes,
    stiffness: f64,
    length: f64,
    /// 2ρ \[m\], and how many masses further the next turn is.
    wire: f64,
    by_turn: usize,
}

/// Secants until the length is found: each gains half as many digits again.
const SECANTS: usize = 12;

impl Reading {
    /// Of a spring at the middle of its operating range.
    pub fn of(spring: &Spring) -> Self {
        Self {
            coil: MaxwellSum::new(spring, SelfDistance::AsPrinted),
            modes: ChainModes::of(spring),
            stiffness: spring.stiffness(),
            length: spring.mid_length(),
            wire: 2.0 * spring.wire_radius(),
            by_turn: spring.masses_per_winding(),
        }
    }

    /// The force less that of the mean length \[N\], of ends that moved by u1 and u2 and modes at q_j \[m\]; `None` where turns touch.
    pub fn force(&self, [first, second]: [f64; 2], modes: &[f64]) -> Result<Option<f64>, Error> {
        let masses = self.modes.masses();
        let [near, far] = [first, self.length + second];
        let place = |winding: usize| {
            let share = (winding as f64 - 0.5) / masses as f64;
            let shapes = modes.iter().enumerate().map(|(mode, q)| q * self.modes.shape_at(mode + 1, winding));
            near + share * (far - near) + shapes.sum::<f64>()
        };
        let places: Vec<f64> = (1..=masses).map(place).collect();
        let later = places.iter().skip(self.by_turn);
        if places.iter().zip(later).any(|(turn, next)| next - turn <= self.wire) {
            return Ok(None);
        }
        let inductance = self.coil.series(&Windings::new(vec![[near, far]], places)?)[0];
        Ok(self.length_of(inductance, far - near).map(|length| self.stiffness * (length - self.length)))
    }

    /// The length at which uniform turns have an inductance \[m\], found from one near it.
    fn length_of(&self, inductance: f64, near: f64) -> Option<f64> {
        let off = |length: f64| self.coil.at_length(length) - inductance;
        let (mut before, mut now) = (near * (1.0 + 1e-4), near);
        let (mut off_before, mut off_now) = (off(before), off(now));
        for _ in 0..SECANTS {
            if off_now == off_before {
                break;
            }
            let next = now - off_now * (now - before) / (off_now - off_before);
            if next.is_nan() || next <= 0.0 {
                return None;
            }
            (before, off_before) = (now, off_now);
            (now, off_now) = (next, off(next));
            if (now - before).abs() <= 1e-15 * now {
                break;
            }
        }
        Some(now)
    }
}
