//! One speed in one way: run until it repeats, and the last turns of it.
//!
//! Next door: all of them (the parent), the run (`coilsense::contact::Touching::driven`).

use coilsense::contact::{Course, GivenUp, Path, Touching};
use coilsense::excitation::{EndInput, Excitation, Start};
use coilsense::{Error, Motion};

use super::Range;
use crate::spec::{CamSpec, Spec};
use crate::study::GRAZES;

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
    /// How often windings, or a winding and its seat, meet in a turn of the camshaft.
    pub touches: f64,
    /// The largest closing speed \[m/s\].
    pub fastest: f64,
    /// The largest blow on a seat \[N s\].
    pub blow: f64,
    /// How often an end leaves its seat in a turn.
    pub lifts: f64,
    /// How the follower floats; `None` without one.
    pub floating: Option<Floating>,
    /// Shear stress of the wire at the least and the largest pressing end force, with Wahl's correction \[Pa\].
    pub stress: [f64; 2],
    /// By how much the extremes of the last two turns differ from those of the two before, as a share of F_nom: what repeats has settled.
    pub unsettled: f64,
    /// Turns that were run.
    pub turns: usize,
    /// Why the run ended early.
    pub given_up: Option<GivenUp>,
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
const JUDGED: usize = 4;
/// Fewest turns before them.
const FEWEST: usize = 8;
/// How many times the decay of the first mode is waited for, and how long at most \[s\].
const DECAYS: f64 = 3.0;
const LONGEST: f64 = 1.5;
/// Samples for a period of the first mode.
const SAMPLES: f64 = 60.0;

/// Runs one speed.
pub(super) fn of(spec: &Spec, cam: &CamSpec, range: &Range, speed: f64, way: usize) -> Result<SpeedPoint, Error> {
    let spring = &spec.spring.spring;
    let case = &spec.mount.cases[way];
    let contact = case.contact.as_ref().map(|way| &way.contact).ok_or(Error::MissingSignal("[contact]"))?;
    let excitation = Excitation::new(cam.length, EndInput::Held, EndInput::Held, Start::Rest)?;
    let mount = crate::study::mounted(&case.mount, spring)?;
    let motion = Motion::mounted(spring, &mount, &excitation)?;
    let turning = range.ratio * speed;
    let frequencies = motion.modes().frequencies();
    let first = frequencies.first().copied().unwrap_or(1.0);
    let ratio = mount.damping().ratios(frequencies)?.first().copied().unwrap_or(0.0);
    let wait = if ratio > 0.0 { (DECAYS / (ratio * first)).min(LONGEST) } else { LONGEST };
    let before = ((wait * turning).ceil() as usize).max(FEWEST);
    let turns = before + JUDGED;
    let until = turns as f64 / turning;
    let from = before as f64 / turning;
    let rate = SAMPLES * first / std::f64::consts::TAU;
    // A whole number of samples a turn, the same in each.
    let in_a_turn = (rate / turning).ceil().max(64.0) as usize;
    let times: Vec<f64> =
        (0..=JUDGED * in_a_turn).map(|sample| from + sample as f64 / (in_a_turn as f64 * turning)).collect();
    let course = Touching::driven(&motion, contact, path(cam, turning, turns)?, &times)?;
    Ok(judged(spec, way, speed, &course, [from, until], in_a_turn, turns))
}

/// The cam's lift over time.
fn path(cam: &CamSpec, turning: f64, turns: usize) -> Result<Path, Error> {
    let mut knots = Vec::with_capacity(turns * cam.begins.len() + 1);
    let mut pieces = Vec::with_capacity(turns * cam.begins.len());
    for turn in 0..turns {
        for (begin, powers) in cam.begins.iter().zip(&cam.pieces) {
            knots.push((turn as f64 + begin) / turning);
            pieces.push(powers.iter().enumerate().map(|(power, c)| c * turning.powi(power as i32)).collect());
        }
    }
    knots.push(turns as f64 / turning);
    Path::new(knots, pieces)
}

fn judged(
    spec: &Spec,
    way: usize,
    speed: f64,
    course: &Course,
    [from, until]: [f64; 2],
    in_a_turn: usize,
    turns: usize,
) -> SpeedPoint {
    let spring = &spec.spring.spring;
    let nominal = spring.nominal_force();
    let extremes = |forces: &[f64]| {
        forces.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], force| [low.min(*force), high.max(*force)])
    };
    let (input, output) = (extremes(&course.input), extremes(&course.output));
    let samples = course.input.len().max(1) as f64;
    let pairs = || course.input.iter().zip(&course.output);
    let apart = (pairs().map(|(input, output)| (output - input).powi(2)).sum::<f64>() / samples).sqrt();
    let still = course.end1.iter().zip(&course.end2);
    let surge = pairs().zip(still).map(|((input, output), (first, second))| {
        let still = spring.stiffness() * (second - first);
        (input - still).abs().max((output - still).abs())
    });
    let surge = surge.fold(0.0, f64::max);
    let settled = |forces: &[f64]| {
        let half = (2 * in_a_turn).min(forces.len());
        let ([a, b], [c, d]) = (extremes(&forces[..half]), extremes(&forces[forces.len() - half..]));
        (a - c).abs().max((b - d).abs())
    };
    let unsettled =
        if course.input.is_empty() { 0.0 } else { settled(&course.input).max(settled(&course.output)) / nominal };
    let each = 1.0 / JUDGED as f64;
    let is_seen = |time: f64| (from..until).contains(&time);
    let touches = || course.touches.iter().filter(|touch| is_seen(touch.time));
    let base = usize::from(!course.cam_force.is_empty());
    let last = base + spring.chain_masses();
    let at_seat = |points: [usize; 2]| points[0] == base || points[1] > last;
    let floating = (!course.cam_force.is_empty()).then(|| {
        let floats = || {
            let aloft = course.floats.iter().filter(|float| float.back.is_none() || float.closing_speed >= GRAZES);
            aloft.filter(|float| float.time < until && float.back.is_none_or(|back| back > from))
        };
        let aloft: f64 = floats().map(|float| float.back.unwrap_or(until).min(until) - float.time.max(from)).sum();
        Floating {
            least_cam_force: extremes(&course.cam_force)[0].max(0.0),
            floats: each * floats().count() as f64,
            share: aloft / (until - from),
            fastest: floats().map(|float| float.closing_speed).fold(0.0, f64::max),
        }
    });
    let pressed = |force: f64| spec.spring.corrected_shear_stress((-force).max(0.0));
    let (least, most) = (input[1].max(output[1]), input[0].min(output[0]));
    SpeedPoint {
        speed,
        way,
        input,
        output,
        apart,
        surge,
        touches: each * touches().count() as f64,
        fastest: touches().map(|touch| touch.closing_speed).fold(0.0, f64::max),
        blow: touches().filter(|touch| at_seat(touch.points)).map(|touch| touch.impulse).fold(0.0, f64::max),
        lifts: each * course.lifts.iter().filter(|lift| is_seen(lift.time)).count() as f64,
        floating,
        stress: [pressed(least), pressed(most)],
        unsettled,
        turns,
        given_up: course.given_up,
    }
}
