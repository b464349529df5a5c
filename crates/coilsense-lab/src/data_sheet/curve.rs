//! The static curve of a coil of sections: force, rate, closed windings and first surge frequency over lengths.
//!
//! Next door: the closed forms (`coilsense::sections`), single numbers (`rows`).

use std::f64::consts::TAU;

use coilsense::sections::Sections;

use crate::spec::SpringSpec;

/// The spring at rest at one length.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct AtLength {
    /// \[m\]
    pub length_m: f64,
    /// Tension positive \[N\].
    pub force_n: f64,
    /// How the force grows with the length \[N/m\].
    pub stiffness_n_per_m: f64,
    /// Active windings that are closed \[1\].
    pub closed_windings: f64,
    /// First surge frequency with both ends held: closed windings have fallen out of the spring \[Hz\].
    pub first_surge_hz: Option<f64>,
    /// Whether a section begins to close here, or has closed.
    pub is_knee: bool,
}

/// Lengths that are looked at besides knees.
const LENGTHS: usize = 9;

/// Over the range in use, from the longest length on, knees among them; none of a coil that is uniform.
pub(super) fn over_lengths(spec: &SpringSpec) -> Vec<AtLength> {
    let Some(sections) = spec.spring.sections() else { return Vec::new() };
    let (shortest, longest) = spec.spring.operating_range();
    let step = (longest - shortest) / (LENGTHS - 1) as f64;
    let mut lengths: Vec<(f64, bool)> = (0..LENGTHS).map(|index| (longest - step * index as f64, false)).collect();
    let knees = knees(spec, sections).into_iter().map(|(_, length)| length);
    let inside = knees.filter(|length| *length > shortest && *length < longest);
    for knee in inside {
        lengths.retain(|(length, _)| (length - knee).abs() > 0.2 * step);
        lengths.push((knee, true));
    }
    lengths.sort_by(|a, b| b.0.total_cmp(&a.0));
    lengths.into_iter().map(|(length, is_knee)| AtLength { is_knee, ..at(spec, sections, length) }).collect()
}

/// Pressing forces \[N\] and lengths \[m\] at which a section begins to close, or has closed.
pub(super) fn knees(spec: &SpringSpec, sections: &Sections) -> Vec<(f64, f64)> {
    let spring = &spec.spring;
    let stiffer = spring.stiffness() / sections.stiffness();
    let length = |force: f64| spring.rest_length() - sections.compression(force).unwrap_or(0.0);
    sections.knees().into_iter().map(|force| (stiffer * force, length(force))).collect()
}

fn at(spec: &SpringSpec, sections: &Sections, length: f64) -> AtLength {
    let spring = &spec.spring;
    let [pressed, _] = sections.pushes(spring.rest_length() - length);
    // Of the sections as they are drawn; the spec's spring has their stiffness and mass.
    let first = sections.first_frequency_at(pressed);
    AtLength {
        length_m: length,
        force_n: spring.static_force(length),
        stiffness_n_per_m: spring.rate_at(length),
        closed_windings: sections.closed_at(pressed),
        first_surge_hz: first.map(|angular| angular / TAU),
        is_knee: false,
    }
}
