//! Shear stress of the wire over a turn of the camshaft, and how far that is from the Goodman line.
//!
//! Next door: the stress of a force (`coilsense::geometry`), the strengths (`crate::spec`), the run (`point`).

use crate::spec::{SpringSpec, StrengthSpec};

/// Stress at the inside of the winding that is worst off, with Wahl's correction \[Pa\]; positive where the spring is pressed.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Stress {
    /// The least over the turns that are looked at.
    pub least: f64,
    /// The largest.
    pub largest: f64,
    /// How many times larger amplitude and mean may both become until they reach the Goodman line \[1\]; `None` without strengths in the spec.
    pub safety: Option<f64>,
}

impl Stress {
    /// Of the least and the largest tension of each segment of the wire \[N\]: that of the segment nearest to the Goodman line, without strengths
    /// that of the largest stress; `None` where no segment was watched.
    pub(super) fn worst(spring: &SpringSpec, strength: Option<&StrengthSpec>, tensions: &[[f64; 2]]) -> Option<Self> {
        let count = tensions.len();
        let of = |(segment, tensions): (usize, &[f64; 2])| {
            // Segments lie between masses in the middle of equal stretches of the wire.
            let place = segment as f64 / (count - 1).max(1) as f64;
            let [largest, least] = tensions.map(|tension| spring.corrected_shear_stress_at(place, -tension));
            let stress = Self { least, largest, safety: None };
            Self { safety: strength.map(|strength| stress.against(strength)), ..stress }
        };
        let each = tensions.iter().enumerate().filter(|(_, pair)| pair[0] <= pair[1]).map(of);
        let danger =
            |stress: &Self| stress.safety.map_or(stress.largest.abs().max(stress.least.abs()), |safety| 1.0 / safety);
        each.max_by(|a, b| danger(a).total_cmp(&danger(b)))
    }

    /// Half of what it goes up and down by \[Pa\].
    pub fn amplitude(&self) -> f64 {
        0.5 * (self.largest - self.least)
    }

    /// About what it does \[Pa\].
    pub fn mean(&self) -> f64 {
        0.5 * (self.largest + self.least)
    }

    /// The safety factor n against Goodman's line.
    ///
    /// 1/n = τ_a/S_e + |τ_m|/S_u
    ///
    /// Source:   Goodman's line, `[Shigley2011]` chapter 6, in shear.
    /// Valid:    endless life; Wahl's factor on both stresses, which is on the safe side for the mean.
    /// Accuracy: rounding.
    fn against(&self, strength: &StrengthSpec) -> f64 {
        1.0 / (self.amplitude() / strength.endurance + self.mean().abs() / strength.ultimate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn on_the_goodman_line_nothing_is_left() {
        let strength = StrengthSpec { endurance: 300e6, ultimate: 900e6 };
        // A point of the line: half of each strength.
        let stress = Stress { least: 300e6, largest: 600e6, safety: None };
        assert!((stress.against(&strength) - 1.0).abs() < 1e-12);
        let twice = Stress { least: 150e6, largest: 300e6, safety: None };
        assert!((twice.against(&strength) - 2.0).abs() < 1e-12);
        // Pulled as pressed.
        let pulled = Stress { least: -600e6, largest: -300e6, safety: None };
        assert!((pulled.against(&strength) - 1.0).abs() < 1e-12);
    }
}
