//! The modes of a coil of sections, found numerically.
//!
//! Next door: its masses and springs (`crate::sections`), their spectrum (`crate::bidiagonal`).

use super::{ModalModel, ModalParameters};
use crate::bidiagonal::chain_spectrum;
use crate::mount::FarEnd;
use crate::sections::{Lumps, Sections};
use crate::spring::Spring;

impl ModalModel {
    /// Of a chain of any masses and springs: `masses` m_i \[kg\], shape `N`; `stiffnesses` k_j \[N/m\], shape `N + 1`. All are trusted.
    pub(crate) fn of_lumps(masses: &[f64], stiffnesses: &[f64], far_end: FarEnd) -> ModalParameters {
        let whole: f64 = stiffnesses.iter().map(|stiffness| 1.0 / stiffness).sum();
        let mut soft = 0.0;
        let places = stiffnesses[..masses.len()].iter().map(|stiffness| {
            soft += 1.0 / stiffness;
            soft / whole
        });
        let places = places.collect();
        let (mut moved, mut springs) = (masses.to_vec(), stiffnesses.to_vec());
        match far_end {
            FarEnd::Position => {}
            FarEnd::Force => springs[masses.len()] = 0.0,
            FarEnd::Mass(mass) => {
                moved.push(mass);
                springs.push(0.0);
            }
        }
        let spectrum = chain_spectrum(&moved, &springs);
        let rows = || spectrum.shapes.chunks_exact(moved.len());
        let end_shapes = match far_end {
            FarEnd::Position => vec![0.0; moved.len()],
            // Under a force the last segment goes along unstrained.
            FarEnd::Force | FarEnd::Mass(_) => rows().map(|row| row[moved.len() - 1]).collect(),
        };
        ModalParameters {
            far_end,
            masses: masses.to_vec(),
            places,
            end_segments: [stiffnesses[0], stiffnesses[masses.len()]],
            shapes: rows().flat_map(|row| row[..masses.len()].iter().copied()).collect(),
            frequencies: spectrum.frequencies.clone(),
            end_shapes,
        }
    }

    pub(super) fn of_sections(spring: &Spring, sections: &Sections, far_end: FarEnd) -> Self {
        let [stiffer, heavier] = spring.scales(sections);
        let Lumps { masses, stiffnesses, windings } = sections.lumps(spring.masses_per_winding());
        let masses: Vec<f64> = masses.iter().map(|mass| heavier * mass).collect();
        let stiffnesses: Vec<f64> = stiffnesses.iter().map(|stiffness| stiffer * stiffness).collect();
        let parameters = Self::of_lumps(&masses, &stiffnesses, far_end);
        let rest = spring.rest_length();
        // Half of what the spring is longer than its coil at either end.
        let before = 0.5 * (rest - sections.span());
        let place = |(share, windings): (&f64, &f64)| before + sections.place_at(*windings, 0.0) - share * rest;
        let offsets = parameters.places.iter().zip(&windings[1..]).map(place).collect();
        // Of sections that were checked, masses and springs are above zero, and places ascend.
        let mut model = Self::trusted(spring.stiffness(), parameters);
        model.offsets = offsets;
        model
    }
}
