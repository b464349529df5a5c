//! One force fed back at one damping: its limits, and the loop as it is set.
//!
//! Next door: all of them together (`super`).

use std::f64::consts::TAU;

use coilsense::control::{ForceLoop, Margins, Passivity};
use coilsense::{Channel, Error};

use super::calm::{self, Peak};
use super::loops::UnitLoops;
use crate::spec::DampingCase;

/// One force fed back at one damping.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The proportional gain up to which the loop is stable (command unit per N); infinite without a limit.
    pub limit: f64,
    /// The crossover that the loop would have at that gain with a spring without mass \[Hz\].
    pub stable_crossover: f64,
    /// The same for a sensitivity of at most 2; zero where it is larger at every gain.
    pub robust_crossover: f64,
    /// From which crossover on the sensitivity is at most 2 \[Hz\]; zero where it is in the slowest loop, too.
    pub robust_from: f64,
    /// Where the loop oscillates at its limit \[Hz\]; zero without one.
    pub oscillates_at: f64,
    /// The loop as it is set.
    pub margins: Margins,
    /// Largest answers of F_i and F_o as it is set; `None` where it is unstable.
    pub peaks: Option<[Peak; 2]>,
    /// The rendered impedance as it is set; `None` for F_L.
    pub passivity: Option<Passivity>,
}

impl Assessment {
    /// Its limits, from a loop with the proportional gain `shape`.
    pub(super) fn of(unit: &UnitLoops<'_>, damping: &DampingCase, channel: Channel, shape: f64) -> Result<Self, Error> {
        let force_loop = unit.force_loop(damping, channel, shape)?;
        let margins = margins(unit, &force_loop)?;
        let crossover = |factor: f64| match factor {
            0.0 => Ok(0.0),
            factor if factor.is_infinite() => Ok(f64::INFINITY),
            factor => Ok(force_loop.massless_crossover(factor)?.map_or(f64::INFINITY, |omega| omega / TAU)),
        };
        Ok(Self {
            limit: shape * margins.gain_limit,
            stable_crossover: crossover(margins.gain_limit)?,
            robust_crossover: crossover(margins.robust_gain)?,
            robust_from: crossover(margins.robust_from)?,
            oscillates_at: margins.critical_frequency / TAU,
            margins,
            peaks: None,
            passivity: None,
        })
    }

    /// The loop as it is set: its proportional gain.
    pub(super) fn set(
        &mut self,
        unit: &UnitLoops<'_>,
        damping: &DampingCase,
        channel: Channel,
        gain: f64,
    ) -> Result<(), Error> {
        let force_loop = unit.force_loop(damping, channel, gain)?;
        self.margins = margins(unit, &force_loop)?;
        self.peaks = match self.margins.stable {
            true => Some(calm::peaks(&force_loop, &calm::watched(&force_loop)?)?),
            false => None,
        };
        self.passivity = unit.passivity(&force_loop)?;
        Ok(())
    }
}

fn margins(unit: &UnitLoops<'_>, force_loop: &ForceLoop) -> Result<Margins, Error> {
    match unit.sampled(force_loop)? {
        Some(sampled) => sampled.margins(),
        None => force_loop.margins(),
    }
}
