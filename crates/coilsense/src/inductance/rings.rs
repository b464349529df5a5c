//! The turns of a coil of sections: coaxial rings of unequal radii.
//!
//! Next door: rings of one radius (`mutual`), the sum over all of them (`maxwell`).

use std::f64::consts::PI;
use std::sync::Arc;

use super::mutual::{MU_0, mutual_inductance};
use super::self_term::SelfDistance;
use crate::sections::Sections;
use crate::spring::Spring;

/// Rounds of the arithmetic-geometric mean after which nothing moves, also for rings a wire's radius apart.
const ROUNDS: usize = 12;

/// Mutual inductance of two coaxial circular rings \[H\].
///
/// M = μ₀π/(4 agm(A, B)) Σ_{n≥1} 2ⁿ c_n², A² = (a + b)² + h², B² = (a − b)² + h², c_1 = 2ab/(A + B), c_{n+1} = c_n²/(4 a_{n+1})
///
/// - `radii`: a and b \[m\], above zero; `distance`: h \[m\], of either sign
///
/// Source:   `[Maxwell1873]` art. 701 by the arithmetic-geometric mean (`[DLMF]` 19.8): (2 − κ²)K − 2E = K Σ 2ⁿ c_n².
/// Valid:    thin rings, direct current, no core; infinite where they coincide.
/// Accuracy: 3e-15 relative, against [`mutual_inductance`] at equal radii and against 40 digits (tests).
///
/// ```
/// use coilsense::inductance::{mutual_inductance, mutual_inductance_of_rings};
/// let equal = mutual_inductance(0.008, 0.003);
/// assert!((mutual_inductance_of_rings([0.008, 0.008], 0.003) / equal - 1.0).abs() < 1e-14);
/// ```
pub fn mutual_inductance_of_rings([first, second]: [f64; 2], distance: f64) -> f64 {
    let (far, near) = ((first + second).hypot(distance), (first - second).hypot(distance));
    let (mut arithmetic, mut geometric) = (0.5 * (far + near), (far * near).sqrt());
    let mut c = 2.0 * first * second / (far + near);
    let (mut power, mut sum) = (2.0, 0.0);
    for _ in 0..ROUNDS {
        let term = power * c * c;
        sum += term;
        if term <= 1e-17 * sum {
            break;
        }
        (arithmetic, geometric) = (0.5 * (arithmetic + geometric), (arithmetic * geometric).sqrt());
        c = c * c / (4.0 * arithmetic);
        power *= 2.0;
    }
    MU_0 * PI / (4.0 * arithmetic) * sum
}

/// Rings where the turns of a coil of sections are.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Rings {
    /// \[m\], shape `turns`.
    radii: Vec<f64>,
    /// Windings between end 1 and each turn \[1\], shape `turns`.
    windings: Vec<f64>,
    /// Mean of M(h_self) \[H\].
    own: f64,
    sections: Arc<Sections>,
    rest_length: f64,
}

impl Rings {
    /// Of a spring whose turns lie at these shares of the wire; `None` of a coil that is even.
    pub(super) fn of(spring: &Spring, places: &[f64], self_distance: SelfDistance) -> Option<Self> {
        let sections = Arc::clone(spring.shared_sections()?);
        let windings: Vec<f64> = places.iter().map(|place| place.clamp(0.0, 1.0) * sections.windings()).collect();
        let rings: Vec<[f64; 2]> = windings.iter().map(|windings| sections.radii_at(*windings)).collect();
        let own = |[coil, wire]: &[f64; 2]| mutual_inductance(*coil, self_distance.of_wire(*wire));
        let own = rings.iter().map(own).sum::<f64>() / rings.len() as f64;
        let radii = rings.iter().map(|[coil, _]| *coil).collect();
        Some(Self { radii, windings, own, sections, rest_length: spring.rest_length() })
    }

    pub(super) fn own(&self) -> f64 {
        self.own
    }

    /// Where the turns lie at rest at a length \[m\], end 1 at zero.
    pub(super) fn at_rest(&self, length: f64) -> Vec<f64> {
        let before = 0.5 * (self.rest_length - self.sections.span());
        let [force, _] = self.sections.pushes(self.rest_length - length);
        self.windings.iter().map(|windings| before + self.sections.place_at(*windings, force)).collect()
    }

    /// Σ_{i<j} M_ij \[H\].
    pub(super) fn pairs(&self, turns: &[f64]) -> f64 {
        let of = |first: usize| {
            let later = (first + 1..turns.len()).map(|second| {
                mutual_inductance_of_rings([self.radii[first], self.radii[second]], turns[second] - turns[first])
            });
            later.sum::<f64>()
        };
        (0..turns.len()).map(of).sum()
    }
}
