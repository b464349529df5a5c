//! How fast a loop may be so that neither end rings: the closed loop's peaks of both end forces.
//!
//! Next door: stability and sensitivity (`judged`), what is made of it (`super`).

use std::f64::consts::TAU;

use coilsense::control::ForceLoop;
use coilsense::{Channel, Error};

use super::loops::UnitLoops;
use crate::spec::DampingCase;

/// Most that an end force may exceed its static answer to the reference \[1\].
///
/// A sensitivity S of at most 2 leaves the force that is fed back at most three times the reference, since T = 1 − S; the force at the other
/// end is granted no more.
pub const MOST_PEAK: f64 = 3.0;

/// A force on a free mass does not last: below this share of the reference there is no static answer \[1\].
const LEAST_STATIC: f64 = 0.1;
/// Surge lines up to which a loop is watched.
const LINES: f64 = 4.0;
/// How the gain goes down until nothing rings, how far (beyond a slow drive's bandwidth the crossover goes with its root), and how often the
/// last step is halved: to 0.1 % of it.
const STEP: f64 = 0.8;
const LEAST: f64 = 1e-7;
const HALVINGS: usize = 8;

/// The largest closed-loop answer of an end force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// F_i or F_o.
    pub force: Channel,
    /// |F/reference| \[1\].
    pub size: f64,
    /// Where \[Hz\].
    pub at: f64,
    /// The same size over the static one \[1\]; over the reference where the load yields and no force lasts.
    pub over_static: f64,
}

/// Peaks of F_i and F_o at some angular frequencies \[rad/s\], the lowest of which counts as static: |T_fed · F/F_fed|.
pub(super) fn peaks(force_loop: &ForceLoop, frequencies: &[f64]) -> Result<[Peak; 2], Error> {
    let none = |force| Peak { force, size: 0.0, at: 0.0, over_static: 0.0 };
    let mut peaks = [Channel::InputForce, Channel::OutputForce].map(none);
    let mut still = [0.0; 2];
    for (index, &omega) in frequencies.iter().enumerate() {
        let plant = force_loop.plant().at(omega)?;
        let tracked = force_loop.tracking(omega)? / plant.of(force_loop.feedback())?;
        for (peak, still) in peaks.iter_mut().zip(&mut still) {
            let size = (tracked * plant.of(peak.force)?).norm();
            if index == 0 {
                *still = if size < LEAST_STATIC { 1.0 } else { size };
            }
            if size > peak.size {
                *peak = Peak { size, at: omega / TAU, over_static: size / *still, ..*peak };
            }
        }
    }
    Ok(peaks)
}

/// Frequencies at which a loop is watched \[rad/s\]: those of its trace up to the fourth surge line. They are the same at every gain.
pub(super) fn watched(force_loop: &ForceLoop) -> Result<Vec<f64>, Error> {
    let up_to = LINES * TAU * force_loop.plant().spring().surge_frequency();
    let trace = force_loop.trace()?;
    Ok(trace.points().iter().map(|point| point.angular_frequency).take_while(|omega| *omega <= up_to).collect())
}

/// How fast the loop on a force may be.
pub(super) struct Calm {
    /// The largest crossover in the range at which both ends stay within [`MOST_PEAK`] at every damping \[Hz\]; zero without one.
    pub crossover: f64,
    /// What rings at the fastest, where they do not stay within it there.
    pub rings: Option<Peak>,
}

/// Lowers the gain of a loop within a range of crossovers \[Hz\], from the fastest on, until neither end rings.
pub(super) fn calm(
    unit: &UnitLoops<'_>,
    dampings: &[DampingCase],
    channel: Channel,
    [slowest, most]: [f64; 2],
) -> Result<Calm, Error> {
    if most <= slowest {
        return Ok(Calm { crossover: 0.0, rings: None });
    }
    let fastest = unit.gain_for(&dampings[0], most)?;
    let frequencies = dampings.iter().map(|damping| watched(&unit.force_loop(damping, channel, fastest)?));
    let frequencies = frequencies.collect::<Result<Vec<_>, _>>()?;
    let loudest = |share: f64| {
        let mut loudest: Option<Peak> = None;
        for (damping, frequencies) in dampings.iter().zip(&frequencies) {
            for peak in peaks(&unit.force_loop(damping, channel, share * fastest)?, frequencies)? {
                loudest = loudest.filter(|other| other.over_static >= peak.over_static).or(Some(peak));
            }
        }
        Ok::<Option<Peak>, Error>(loudest.filter(|peak| peak.over_static > MOST_PEAK))
    };
    let least = if slowest > 0.0 { unit.gain_for(&dampings[0], slowest)? / fastest } else { LEAST };
    let Some(rings) = loudest(1.0)? else { return Ok(Calm { crossover: most, rings: None }) };
    let (mut low, mut high) = (STEP, 1.0);
    while loudest(low)?.is_some() {
        (low, high) = (STEP * low, low);
        if low < least {
            return Ok(Calm { crossover: 0.0, rings: Some(rings) });
        }
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if loudest(middle)?.is_some() { high = middle } else { low = middle }
    }
    // A loop that is never above 1 has no crossover.
    let crossover = unit.force_loop(&dampings[0], channel, low * fastest)?.massless_crossover(1.0)?;
    Ok(Calm { crossover: crossover.map_or(0.0, |omega| omega / TAU), rings: Some(rings) })
}
