//! What a force does to the wire of a coil of sections.
//!
//! Next door: the same of a uniform coil (`crate::geometry`).

use std::f64::consts::PI;

use super::coil::{Section, Sections};
use super::polynomial::{at, value};

/// Places along a section at which the stress is looked at.
const PLACES: usize = 64;

/// K_W 8 F D/(π d³).
fn wahl_stress(coil: f64, wire: f64, force: f64) -> f64 {
    let index = coil / wire;
    let wahl = 1.0 + 0.75 / (index - 1.0) + 0.615 / index;
    wahl * 8.0 * force * coil / (PI * wire.powi(3))
}

impl Sections {
    /// The shear stress at the inside of a winding under a force that its wire carries \[Pa\]; `windings` lie between it and end 1.
    ///
    /// Source:   as [`Self::corrected_shear_stress`].
    /// Valid:    as there.
    /// Accuracy: rounding.
    pub fn corrected_shear_stress_at(&self, windings: f64, force: f64) -> f64 {
        let [coil, wire] = self.radii_at(windings).map(|radius| 2.0 * radius);
        wahl_stress(coil, wire, force)
    }

    /// The largest shear stress at the inside of any winding under a pressing force \[Pa\]; a winding that has closed takes no more than it had when it
    /// closed.
    ///
    /// max over the wire of K_W 8 min(F, F_closing) D/(π d³), K_W = (4C − 1)/(4C − 4) + 0.615/C
    ///
    /// - `force`: F \[N\], not below zero
    ///
    /// Source:   `[Wahl1963]`; a closed winding is not twisted any further.
    /// Valid:    round wire, index C = D/d above about 3; the press of wire on wire is left out.
    /// Accuracy: 65 places of each section: exact where gap and diameter change evenly one at a time, else some 0.1 %.
    pub fn corrected_shear_stress(&self, force: f64) -> f64 {
        let of_section = |section: &Section| {
            let (gap, compliance) = (section.gap(), section.compliance(self.shear_modulus));
            let of_place = |number: usize| {
                let place = number as f64 / PLACES as f64;
                let carried = force.min(value(&gap, place) / value(&compliance, place)).max(0.0);
                wahl_stress(at(section.coil_diameter, place), section.wire_diameter, carried)
            };
            (0..=PLACES).map(of_place).fold(0.0, f64::max)
        };
        self.sections.iter().map(of_section).fold(0.0, f64::max)
    }
}
