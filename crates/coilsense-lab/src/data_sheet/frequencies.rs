//! Surge frequencies of the axial model on every mount.
//!
//! Next door: single numbers of the data sheet (`rows`), all modes of the helix (`modes`).

use std::f64::consts::TAU;

use coilsense::modes::{ModalModel, continuous_frequencies, third_rule_error};
use coilsense::{Error, FarEnd, Spring};

/// Surge frequencies on a mount.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct MountFrequencies {
    /// The mount in words.
    pub mount: String,
    /// Whether it is the spec's own.
    pub is_the_specs: bool,
    /// The first modes of the chain \[Hz\].
    pub chain_hz: Vec<f64>,
    /// The same of the continuous coil \[Hz\].
    pub continuous_hz: Vec<f64>,
    /// By how many percent √(k/(M + m/3)) lies above the continuous first mode; where an end is free to move.
    pub third_rule_error_percent: Option<f64>,
}

/// How many modes are told.
const MODES: usize = 3;

/// Held, free, and with end masses: the spec's own, or as heavy as the spring and three times that.
pub(super) fn on_every_mount(spring: &Spring, own: FarEnd) -> Result<Vec<MountFrequencies>, Error> {
    let mass = spring.mass();
    let mut mounts =
        vec![("both ends held".to_owned(), FarEnd::Position), ("end 2 free (under a force)".to_owned(), FarEnd::Force)];
    match own {
        FarEnd::Mass(end_mass) => mounts.push((format!("end mass of {end_mass} kg"), own)),
        _ => {
            mounts.push(("end mass as heavy as the spring".to_owned(), FarEnd::Mass(mass)));
            mounts.push(("end mass three times the spring".to_owned(), FarEnd::Mass(3.0 * mass)));
        }
    }
    mounts.into_iter().map(|(words, far_end)| of_mount(spring, words, far_end, far_end == own)).collect()
}

fn of_mount(spring: &Spring, mount: String, far_end: FarEnd, is_the_specs: bool) -> Result<MountFrequencies, Error> {
    let chain = ModalModel::chain(spring, far_end);
    let third_rule_error_percent = match far_end {
        _ if spring.sections().is_some() => None,
        FarEnd::Position => None,
        FarEnd::Force => Some(100.0 * third_rule_error(spring, 0.0)?),
        FarEnd::Mass(end_mass) => Some(100.0 * third_rule_error(spring, end_mass)?),
    };
    Ok(MountFrequencies {
        mount,
        is_the_specs,
        chain_hz: chain.frequencies().iter().take(MODES).map(|angular| angular / TAU).collect(),
        continuous_hz: continuous(spring, far_end)?.into_iter().map(|angular| angular / TAU).collect(),
        third_rule_error_percent,
    })
}

/// Masses for a winding of a chain that stands for a continuous coil of sections: 1e-4 of its third frequency.
const FINE: usize = 32;

/// Of the continuous coil \[rad/s\].
fn continuous(spring: &Spring, far_end: FarEnd) -> Result<Vec<f64>, Error> {
    if spring.sections().is_none() {
        return continuous_frequencies(spring, far_end, MODES);
    }
    let fine = spring.clone().with_masses_per_winding(FINE)?;
    Ok(ModalModel::chain(&fine, far_end).frequencies().iter().take(MODES).copied().collect())
}
