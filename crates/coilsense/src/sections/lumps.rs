//! A coil of sections as masses and springs, and how it rings when windings are closed.
//!
//! Next door: its static curve (`coil`), the modes of any chain (`crate::bidiagonal`).

use super::coil::{Section, Sections};
use super::polynomial::integral;
use crate::bidiagonal::first_frequency;

/// Masses in the middle of equal stretches of the wire, and the springs between them.
pub(crate) struct Lumps {
    /// m_i \[kg\], shape `N`.
    pub masses: Vec<f64>,
    /// k_j \[N/m\], shape `N + 1`: from end 1 to the first mass, between masses, and to end 2.
    pub stiffnesses: Vec<f64>,
    /// How many windings lie between end 1 and each point \[1\], shape `N + 2`, both ends among them.
    pub windings: Vec<f64>,
}

/// Masses for a winding by which the first frequency is found, and in all: 1e-6 of it at 500.
const FINE: f64 = 64.0;
const FEWEST: f64 = 512.0;
const MOST: f64 = 4096.0;
/// A stretch of which no more than this share \[1\] is open has closed.
const CLOSED: f64 = 1e-12;

impl Sections {
    /// As many masses for each winding, whole windings as a spring counts them.
    pub(crate) fn lumps(&self, masses_per_winding: usize) -> Lumps {
        let whole = (self.windings().round() as usize).max(1);
        self.lumps_in_all(whole * masses_per_winding)
    }

    fn lumps_in_all(&self, lumps: usize) -> Lumps {
        let all = self.windings();
        let width = all / lumps as f64;
        let masses = (0..lumps).map(|lump| self.mass_between(lump as f64 * width, (lump + 1) as f64 * width)).collect();
        let mut windings: Vec<f64> = (0..lumps).map(|lump| (lump as f64 + 0.5) * width).collect();
        windings.insert(0, 0.0);
        windings.push(all);
        let stiffnesses = windings.windows(2).map(|pair| 1.0 / self.compliance_between(pair[0], pair[1])).collect();
        Lumps { masses, stiffnesses, windings }
    }

    /// How far the stretch between two numbers of windings can be pressed from its unloaded length until it is closed \[m\].
    pub(crate) fn gap_between(&self, from: f64, to: f64) -> f64 {
        self.between(from, to, |section, from, to| integral(&section.gap(), from, to)).max(0.0)
    }

    /// Distance from end 1 to a place along the wire under a force \[m\], of the coil at rest: `windings` lie between them.
    ///
    /// ∫ (p − min(F c, g)) dn
    ///
    /// - `windings`: \[1\], from 0 to all of them; `force`: F \[N\] with which it is pressed, below zero where it is pulled
    ///
    /// Source:   as [`Self::compression`].
    /// Valid:    as there; pulled, every winding is open.
    /// Accuracy: rounding.
    pub fn place_at(&self, windings: f64, force: f64) -> f64 {
        self.between(0.0, windings, |section, from, to| {
            let unloaded = integral(&section.pitch_over_place(), from, to);
            unloaded - section.pressed_between(force, self.shear_modulus, [from, to]) / section.windings
        })
    }

    /// How many windings are closed under a force \[1\].
    pub fn closed_at(&self, force: f64) -> f64 {
        let closed = |section: &Section| {
            let open = section.open_parts(force, self.shear_modulus);
            section.windings * (1.0 - open.iter().map(|[from, to]| to - from).sum::<f64>())
        };
        self.sections.iter().map(closed).sum()
    }

    /// First surge frequency with both ends held and all windings open \[rad/s\].
    pub fn first_frequency(&self) -> f64 {
        self.first
    }

    /// The same under a force that closes windings \[rad/s\], which then fall out of the spring; `None` where all have.
    ///
    /// - `force`: F \[N\] with which it is pressed
    ///
    /// Source:   a chain of some hundred masses, those of closed stretches rigid, by Sturm's count.
    /// Valid:    motions so small that nothing else closes and nothing opens.
    /// Accuracy: 1e-5 (test: the closed form of a uniform part).
    pub fn first_frequency_at(&self, force: f64) -> Option<f64> {
        let lumps = (FINE * self.windings()).clamp(FEWEST, MOST) as usize;
        let Lumps { masses, windings, .. } = self.lumps_in_all(lumps);
        let opens: Vec<_> = self.sections.iter().map(|section| section.open_parts(force, self.shear_modulus)).collect();
        let (mut free, mut springs): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        // What is rigid with end 1 so far has no mass that counts.
        let mut carried = 0.0;
        for (segment, pair) in windings.windows(2).enumerate() {
            let whole = self.compliance_between(pair[0], pair[1]);
            let open = self.open_compliance_between(pair[0], pair[1], &opens);
            if open > CLOSED * whole {
                if !springs.is_empty() {
                    free.push(carried);
                }
                springs.push(1.0 / open);
                carried = 0.0;
            }
            carried += masses.get(segment).copied().unwrap_or(0.0);
        }
        if free.is_empty() { None } else { Some(first_frequency(&free, &springs)) }
    }

    fn open_compliance_between(&self, from: f64, to: f64, opens: &[Vec<[f64; 2]>]) -> f64 {
        let mut begin = 0.0;
        let mut sum = 0.0;
        for (section, open) in self.sections.iter().zip(opens) {
            let end = begin + section.windings;
            let place = |winding: f64| ((winding - begin) / section.windings).clamp(0.0, 1.0);
            let compliance = section.compliance(self.shear_modulus);
            if to > begin && from < end {
                for [low, high] in open {
                    let (low, high) = (low.max(place(from)), high.min(place(to)));
                    if high > low {
                        sum += section.windings * integral(&compliance, low, high);
                    }
                }
            }
            begin = end;
        }
        sum
    }
}
