//! One speed in one way: run until it repeats, and the last turns of it. Where nothing meets, what repeats is known in closed form, and the run begins with it.
//!
//! Next door: all of them (the parent), what is told of it (`judged`), the run (`coilsense::contact::Touching::driven`).

use coilsense::contact::{Course, Path, Touching};
use coilsense::excitation::{EndInput, Excitation, Harmonic, Start};
use coilsense::{Error, Motion};

use super::Range;
use super::judged::{JUDGED, SpeedPoint, Turns, judged};
use crate::spec::{CamSpec, Spec};

/// Fewest turns before them.
const FEWEST: usize = 4;
/// Harmonics of the cam that make what repeats where nothing meets, and samples for them: those of a law whose acceleration bends go with the fourth
/// power of their number, which leaves out 1e-9 of the lift.
const WAVES: usize = 200;
const WAVE_SAMPLES: usize = 2048;
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
    moved(spec, way, length, EndInput::Held, Start::Rest)
}

fn moved(spec: &Spec, way: usize, length: f64, end1: EndInput, start: Start) -> Result<Motion, Error> {
    let spring = &spec.spring.spring;
    let excitation = Excitation::new(length, end1, EndInput::Held, start)?;
    Motion::mounted(spring, &crate::study::mounted(&spec.mount.cases[way].mount, spring)?, &excitation)
}

/// The cam's mean lift and its harmonics, from where the lift is least.
pub(super) struct Waves {
    mean: f64,
    /// Frequencies in turns.
    each: Vec<Harmonic>,
}

impl Waves {
    pub fn of(cam: &CamSpec) -> Self {
        let count = WAVE_SAMPLES as f64;
        let lifts: Vec<f64> =
            (0..WAVE_SAMPLES).map(|sample| cam.lift_at(cam.least_at + sample as f64 / count)).collect();
        let harmonic = |number: usize| {
            let angle = |sample: usize| std::f64::consts::TAU * (number * sample % WAVE_SAMPLES) as f64 / count;
            let of = |wave: fn(f64) -> f64| {
                2.0 / count * lifts.iter().enumerate().map(|(sample, lift)| lift * wave(angle(sample))).sum::<f64>()
            };
            let (cosine, sine) = (of(f64::cos), of(f64::sin));
            Harmonic { amplitude: cosine.hypot(sine), frequency: number as f64, phase: cosine.atan2(sine) }
        };
        Self { mean: lifts.iter().sum::<f64>() / count, each: (1..=WAVES).map(harmonic).collect() }
    }

    /// At so many turns a second.
    fn at(&self, turning: f64) -> EndInput {
        EndInput::Harmonics(
            self.each.iter().map(|wave| Harmonic { frequency: turning * wave.frequency, ..*wave }).collect(),
        )
    }
}

/// Whether nothing met, left its seat or its cam: then the motion is linear.
fn is_clear(course: &Course) -> bool {
    course.touches.is_empty() && course.lifts.is_empty() && course.floats.is_empty() && course.given_up.is_none()
}

fn of_first(motion: &Motion) -> Result<f64, Error> {
    let ratios = motion.mount().damping().ratios(motion.modes().frequencies())?;
    Ok(ratios.first().copied().unwrap_or(0.0))
}

/// Runs one speed.
pub(super) fn of(asked: &Asked<'_>, speed: f64, way: usize) -> Result<SpeedPoint, Error> {
    let Asked { spec, cam, range, waves } = asked;
    let case = &spec.mount.cases[way];
    let contact = case.contact.as_ref().map(|way| &way.contact).ok_or(Error::MissingSignal("[contact]"))?;
    let motion = still(spec, way, cam.length)?;
    let turning = range.ratio * speed;
    let first = motion.modes().frequencies().first().copied().unwrap_or(1.0);
    let ratio = of_first(&motion)?;
    let rate = SAMPLES * first / std::f64::consts::TAU;
    // A whole number of samples a turn, the same in each.
    let in_a_turn = (rate / turning).ceil().max(64.0) as usize;
    let run = |motion: &Motion, about: f64, before: usize| {
        let (turns, from) = (before + JUDGED, before as f64 / turning);
        let time = |sample: usize| from + sample as f64 / (in_a_turn as f64 * turning);
        let times: Vec<f64> = (0..=JUDGED * in_a_turn).map(time).collect();
        let course = Touching::driven(motion, contact, path(cam, about, turning, turns)?, &times)?;
        let seen = Turns { from, until: turns as f64 / turning, in_a_turn, count: turns };
        Ok::<_, Error>((course, seen))
    };
    if ratio > 0.0 {
        // What cannot be, since windings overlap in it, is not how the run begins.
        let repeats = moved(spec, way, cam.length - waves.mean, waves.at(turning), Start::Steady);
        let found = repeats.and_then(|repeats| run(&repeats, waves.mean, 0));
        if let Some((course, seen)) = found.ok().filter(|(course, _)| is_clear(course)) {
            return Ok(judged(spec, way, speed, &course, &seen));
        }
    }
    let wait = if ratio > 0.0 { (DECAYS / (ratio * first)).min(LONGEST) } else { LONGEST };
    let (course, seen) = run(&motion, 0.0, ((wait * turning).ceil() as usize).max(FEWEST))?;
    let mut point = judged(spec, way, speed, &course, &seen);
    if is_clear(&course) {
        // What repeats would have met, or none knows what repeats: of the way there this much is left.
        let left = (-ratio * first * seen.from).exp() * point.surge / spec.spring.spring.nominal_force();
        point.unsettled = point.unsettled.max(left);
    }
    Ok(point)
}

/// What is the same at every speed.
#[derive(Clone, Copy)]
pub(super) struct Asked<'a> {
    pub spec: &'a Spec,
    pub cam: &'a CamSpec,
    pub range: &'a Range,
    pub waves: &'a Waves,
}

/// The cam's lift over time about a lift \[m\], from where it is least.
fn path(cam: &CamSpec, about: f64, turning: f64, turns: usize) -> Result<Path, Error> {
    let (begins, mut of_a_turn) = cam.begun_at_least();
    of_a_turn.iter_mut().filter_map(|powers| powers.first_mut()).for_each(|first| *first -= about);
    let mut knots = Vec::with_capacity(turns * begins.len() + 1);
    let mut pieces = Vec::with_capacity(turns * begins.len());
    let until = turns as f64 / turning;
    for turn in 0..turns {
        for (begin, powers) in begins.iter().zip(&of_a_turn) {
            let knot = (turn as f64 + begin) / turning;
            // A piece that rounding alone has left lasts no time.
            if knot >= until || knots.last().is_some_and(|last| *last >= knot) {
                continue;
            }
            knots.push(knot);
            pieces.push(powers.iter().enumerate().map(|(power, c)| c * turning.powi(power as i32)).collect());
        }
    }
    knots.push(until);
    Path::new(knots, pieces)
}
