//! How fast a loop may be so that neither end rings on any spring: the closed loop's peaks of both end forces.
//!
//! Next door: stability and sensitivity (`judged`), what is made of it (`super`).

use std::f64::consts::TAU;
use std::sync::Arc;

use coilsense::control::{Point, Response};
use coilsense::{Channel, Error};
use num_complex::Complex64;

use super::allowed::Varied;
use super::loops::{Closed, Under, UnitLoops};
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

/// What a plant does per command at an angular frequency at which its loops are watched: the same at every gain.
pub(super) struct Watched {
    /// \[rad/s\]
    omega: f64,
    plant: Response,
    /// What is fed back per command, in samples.
    read: Complex64,
}

impl Watched {
    fn closed(&self, looped: &Closed) -> Result<Response, Error> {
        match looped {
            Closed::Continuous(force_loop) => force_loop.closed(self.omega, &self.plant),
            Closed::Sampled(sampled) => Ok(sampled.closed(self.omega, &self.plant, self.read)),
        }
    }
}

/// F_o over the reference there.
pub(super) fn tracked(looped: &Closed, watched: &Watched) -> Result<Point, Error> {
    Ok(Point { angular_frequency: watched.omega, response: watched.closed(looped)?.output })
}

/// Peaks of F_i and F_o where a loop is watched, the lowest frequency of which counts as static.
pub(super) fn peaks(looped: &Closed, watched: &[Watched]) -> Result<[Peak; 2], Error> {
    let none = |force| Peak { force, size: 0.0, at: 0.0, over_static: 0.0 };
    let mut peaks = [Channel::InputForce, Channel::OutputForce].map(none);
    let mut still = [0.0; 2];
    for (index, watched) in watched.iter().enumerate() {
        let (omega, closed) = (watched.omega, watched.closed(looped)?);
        for (peak, still) in peaks.iter_mut().zip(&mut still) {
            let size = closed.of(peak.force)?.norm();
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

/// Of each force the larger answer over its static one.
pub(super) fn larger(a: [Peak; 2], b: [Peak; 2]) -> [Peak; 2] {
    [0, 1].map(|end| if b[end].over_static > a[end].over_static { b[end] } else { a[end] })
}

/// A loop is watched at the frequencies of its trace up to the fourth surge line. A trace in samples ends at half the rate: beyond, where its hold
/// still excites the coil, at all that are seen there.
pub(super) fn watched(looped: &Closed) -> Result<Vec<Watched>, Error> {
    let (force_loop, points) = match looped {
        Closed::Continuous(force_loop) => (&**force_loop, force_loop.trace()?),
        Closed::Sampled(sampled) => (sampled.continuous(), sampled.trace()?),
    };
    let (plant, points) = (force_loop.plant(), points.points());
    let up_to = LINES * TAU * plant.spring().surge_frequency();
    let at = |omega: f64, read: Complex64| Ok::<_, Error>(Watched { omega, plant: plant.at(omega)?, read });
    let Closed::Sampled(sampled) = looped else {
        let frequencies = points.iter().map(|point| point.angular_frequency).take_while(|omega| *omega <= up_to);
        return frequencies.map(|omega| at(omega, Complex64::ZERO)).collect();
    };
    let rate = TAU / sampled.step();
    let mut watched = Vec::new();
    for point in points {
        let (seen, read) = (point.angular_frequency, sampled.read(point.angular_frequency, point.response));
        let each = (0..).map(|copy| rate * f64::from(copy)).take_while(|whole| *whole <= up_to + rate);
        let both = each.flat_map(|whole| [(whole + seen, read), (whole - seen, read.conj())]);
        let within = both.filter(|(omega, _)| *omega > 0.0 && *omega <= up_to);
        watched.extend(within.map(|(omega, read)| at(omega, read)).collect::<Result<Vec<_>, Error>>()?);
    }
    watched.sort_by(|a, b| a.omega.total_cmp(&b.omega));
    Ok(watched)
}

/// How fast the loop on a force may be.
pub(super) struct Calm {
    /// The largest crossover in the range at which both ends stay within [`MOST_PEAK`] at every damping \[Hz\]; zero without one.
    pub crossover: f64,
    /// What rings at the fastest, where they do not stay within it there.
    pub rings: Option<Peak>,
}

/// Lowers the gain of a loop within a range of crossovers \[Hz\], from the fastest on, until neither end rings on any of the springs.
pub(super) fn calm<'a>(
    unit: &UnitLoops<'_>,
    dampings: &'a [DampingCase],
    springs: &'a [Varied],
    channel: Channel,
    [slowest, most]: [f64; 2],
) -> Result<Calm, Error> {
    if most <= slowest {
        return Ok(Calm { crossover: 0.0, rings: None });
    }
    let fastest = unit.gain_for(&dampings[0], most)?;
    let each = unit.under(springs, channel);
    let mut cases = Vec::new();
    for damping in dampings {
        let mut seen: Option<(usize, Arc<Vec<Watched>>)> = None;
        // Of each spring the latest reading first, whose loop turns most: what is watched of the plant serves the others.
        for under in each.iter().rev() {
            let same = seen.as_ref().filter(|(place, _)| *place == under.place).map(|(_, watched)| Arc::clone(watched));
            let watched = match same {
                Some(watched) => watched,
                None => Arc::new(watched(&unit.closed(unit.on(*under, damping, channel, fastest)?)?)?),
            };
            seen = Some((under.place, Arc::clone(&watched)));
            cases.push((damping, *under, watched));
        }
    }
    let loudest = |share: f64, (damping, under, watched): &(&'a DampingCase, Under<'a>, Arc<Vec<Watched>>)| {
        let peaks = peaks(&unit.closed(unit.on(*under, damping, channel, share * fastest)?)?, watched)?;
        Ok::<Peak, Error>(if peaks[1].over_static > peaks[0].over_static { peaks[1] } else { peaks[0] })
    };
    let mut rings: Option<Peak> = None;
    for case in &cases {
        let peak = loudest(1.0, case)?;
        rings = rings.filter(|other| other.over_static >= peak.over_static).or(Some(peak));
    }
    let Some(rings) = rings.filter(|peak| peak.over_static > MOST_PEAK) else {
        return Ok(Calm { crossover: most, rings: None });
    };
    let mut is_quiet = |share: f64| {
        for place in 0..cases.len() {
            if loudest(share, &cases[place])?.over_static > MOST_PEAK {
                // What rings at one gain is the first to be asked at the next.
                cases.swap(0, place);
                return Ok(false);
            }
        }
        Ok::<bool, Error>(true)
    };
    let least = if slowest > 0.0 { unit.gain_for(&dampings[0], slowest)? / fastest } else { LEAST };
    let (mut low, mut high) = (STEP.max(least), 1.0);
    while !is_quiet(low)? {
        if low <= least {
            return Ok(Calm { crossover: 0.0, rings: Some(rings) });
        }
        (low, high) = ((STEP * low).max(least), low);
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if is_quiet(middle)? { low = middle } else { high = middle }
    }
    // A loop that is never above 1 has no crossover.
    let crossover = unit.force_loop(&dampings[0], channel, low * fastest)?.massless_crossover(1.0)?;
    Ok(Calm { crossover: crossover.map_or(0.0, |omega| omega / TAU), rings: Some(rings) })
}
