//! One speed in one way: run until it repeats, and the last turns of it.
//!
//! Next door: all of them (the parent), what is told of it (`judged`), the run (`coilsense::contact::Touching::driven`).

use coilsense::contact::{GivenUp, Path, Touching};
use coilsense::excitation::{EndInput, Excitation, Start};
use coilsense::{Error, Motion};

use super::judged::{Turns, judged};
use super::{Range, Stress};
use crate::spec::{CamSpec, Spec};

/// What a spring does at one speed.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedPoint {
    /// Of the engine \[Hz\].
    pub speed: f64,
    /// Number of the damping and rebound in the spec.
    pub way: usize,
    /// Least and largest F_i \[N\], tension positive.
    pub input: [f64; 2],
    /// The same of F_o.
    pub output: [f64; 2],
    /// Rms of F_o − F_i, by which load cells at both ends differ \[N\].
    pub apart: f64,
    /// The largest |F − F_x| of both ends: how far surge carries an end force from the static one \[N\].
    pub surge: f64,
    /// Amplitudes of F_o at the camshaft's frequency and its multiples, up to [`super::HARMONICS`] \[N\]; empty where not a turn could be followed.
    pub harmonics: Vec<f64>,
    /// How often windings, or a winding and its seat, meet in a turn of the camshaft.
    pub touches: f64,
    /// For how long of a turn the two points that touch longest do \[1\].
    pub closed: f64,
    /// The largest closing speed \[m/s\].
    pub fastest: f64,
    /// The largest blow on a seat \[N s\].
    pub blow: f64,
    /// How often an end leaves its seat in a turn.
    pub lifts: f64,
    /// How the follower floats; `None` without one.
    pub floating: Option<Floating>,
    /// Shear stress where the wire is worst off; `None` where nothing could be followed.
    pub stress: Option<Stress>,
    /// By how much the extremes of the last two turns differ from those of the two before, as a share of F_nom: what repeats has settled.
    pub unsettled: f64,
    /// Turns that were run.
    pub turns: usize,
    /// Why the run ended early.
    pub given_up: Option<GivenUp>,
}

impl SpeedPoint {
    /// The least push on seat 1 and seat 2 \[N\]: at zero an end is about to leave its seat.
    pub fn least_push(&self) -> [f64; 2] {
        // A sum with zero has no sign of zero.
        [self.input[1], self.output[1]].map(|force| 0.0 - force)
    }
}

/// A follower off its cam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Floating {
    /// The least force of the cam on it \[N\]; zero where it floats.
    pub least_cam_force: f64,
    /// How often in a turn.
    pub floats: f64,
    /// For how long of a turn \[1\].
    pub share: f64,
    /// How fast it comes down at most \[m/s\].
    pub fastest: f64,
}

/// Turns that are looked at, at the end.
pub(super) const JUDGED: usize = 4;
/// Fewest turns before them.
const FEWEST: usize = 8;
/// How many times the decay of the first mode is waited for, and how long at most \[s\].
const DECAYS: f64 = 3.0;
const LONGEST: f64 = 1.5;
/// Samples for a period of the first mode.
const SAMPLES: f64 = 60.0;

/// Damping ratio of the first mode in a way \[1\].
pub(super) fn first_ratio(spec: &Spec, way: usize) -> Result<f64, Error> {
    let motion = still(spec, way, spec.spring.spring.operating_range().1)?;
    of_first(&motion)
}

fn still(spec: &Spec, way: usize, length: f64) -> Result<Motion, Error> {
    let spring = &spec.spring.spring;
    let excitation = Excitation::new(length, EndInput::Held, EndInput::Held, Start::Rest)?;
    Motion::mounted(spring, &crate::study::mounted(&spec.mount.cases[way].mount, spring)?, &excitation)
}

fn of_first(motion: &Motion) -> Result<f64, Error> {
    let ratios = motion.mount().damping().ratios(motion.modes().frequencies())?;
    Ok(ratios.first().copied().unwrap_or(0.0))
}

/// Runs one speed.
pub(super) fn of(spec: &Spec, cam: &CamSpec, range: &Range, speed: f64, way: usize) -> Result<SpeedPoint, Error> {
    let case = &spec.mount.cases[way];
    let contact = case.contact.as_ref().map(|way| &way.contact).ok_or(Error::MissingSignal("[contact]"))?;
    let motion = still(spec, way, cam.length)?;
    let turning = range.ratio * speed;
    let first = motion.modes().frequencies().first().copied().unwrap_or(1.0);
    let ratio = of_first(&motion)?;
    let wait = if ratio > 0.0 { (DECAYS / (ratio * first)).min(LONGEST) } else { LONGEST };
    let before = ((wait * turning).ceil() as usize).max(FEWEST);
    let turns = before + JUDGED;
    let rate = SAMPLES * first / std::f64::consts::TAU;
    // A whole number of samples a turn, the same in each.
    let in_a_turn = (rate / turning).ceil().max(64.0) as usize;
    let from = before as f64 / turning;
    let times: Vec<f64> =
        (0..=JUDGED * in_a_turn).map(|sample| from + sample as f64 / (in_a_turn as f64 * turning)).collect();
    let course = Touching::driven(&motion, contact, path(cam, turning, turns)?, &times)?;
    let seen = Turns { from, until: turns as f64 / turning, in_a_turn, count: turns };
    Ok(judged(spec, way, speed, &course, &seen))
}

/// The cam's lift over time, from where it is least.
fn path(cam: &CamSpec, turning: f64, turns: usize) -> Result<Path, Error> {
    let (begins, of_a_turn) = cam.from_least();
    let mut knots = Vec::with_capacity(turns * begins.len() + 1);
    let mut pieces = Vec::with_capacity(turns * begins.len());
    for turn in 0..turns {
        for (begin, powers) in begins.iter().zip(&of_a_turn) {
            knots.push((turn as f64 + begin) / turning);
            pieces.push(powers.iter().enumerate().map(|(power, c)| c * turning.powi(power as i32)).collect());
        }
    }
    knots.push(turns as f64 / turning);
    Path::new(knots, pieces)
}
