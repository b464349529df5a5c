//! The motion of a wire's modes with end 2 as a mount has it.
//!
//! Next door: the modes (`surge`), the same of a wire of other moduli (`changed`), what a mass makes of modes (`crate::modes`).

use crate::damping::Damping;
use crate::error::{Error, check};
use crate::excitation::Excitation;
use crate::modes::ModalModel;
use crate::motion::Motion;
use crate::mount::{FarEnd, Mount};
use crate::spring::Spring;

/// How far lengths that are the same may lie apart, relative.
pub(super) const SAME: f64 = 1e-9;

/// The motion of a wire's modes about a length, its end 2 tied as the mount has it.
pub(super) fn moved(
    spring: &Spring,
    model: &ModalModel,
    length: f64,
    mount: &Mount,
    excitation: &Excitation,
) -> Result<Motion, Error> {
    let mean = excitation.mean_length();
    let same = (mean - length).abs() <= SAME * length;
    check(same, "mean_length", mean, "m", format!("that of the helix, {length} m"))?;
    // The model is a wire's between two positions: it was made as one.
    let tied = model.tied(mount.far_end(), spring.stiffness()).unwrap_or_else(|| model.clone());
    let damping = swing_first(mount.damping(), &tied);
    Motion::of_modes(spring, tied, damping, excitation)
}

/// Of a ratio for each mode of a chain with an end mass, the first is that of the mass's swing, which of a helix may be any.
fn swing_first(damping: &Damping, model: &ModalModel) -> Damping {
    let (Damping::ModalEach(ratios), FarEnd::Mass(_)) = (damping, model.far_end()) else { return damping.clone() };
    let largest = |a: &usize, b: &usize| model.end_shapes()[*a].abs().total_cmp(&model.end_shapes()[*b].abs());
    let swing = (0..model.count()).max_by(largest).unwrap_or(0);
    let mut each = vec![ratios.last().copied().unwrap_or(0.0); model.count()];
    each[swing] = ratios.first().copied().unwrap_or(0.0);
    Damping::ModalEach(each)
}
