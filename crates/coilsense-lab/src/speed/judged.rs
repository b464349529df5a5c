//! What the last turns of a run tell.
//!
//! Next door: the run (`point`), the stress (`fatigue`).

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use coilsense::Spring;
use coilsense::contact::{Course, GivenUp, Touch};

use super::Stress;
use crate::spec::Spec;
use crate::study::GRAZES;

/// Harmonics of the camshaft that are told of F_o.
pub const HARMONICS: usize = 40;

/// What a spring does at one speed.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
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
    /// Amplitudes of F_o at the camshaft's frequency and its multiples, up to [`HARMONICS`] \[N\]; empty where not a turn could be followed.
    pub harmonics: Vec<f64>,
    /// How often windings, or a winding and its seat, meet in a turn of the camshaft.
    pub touches: f64,
    /// For how long of a turn the two points that touch longest do \[1\].
    pub closed: f64,
    /// The largest closing speed \[m/s\].
    pub fastest: f64,
    /// The largest blow on a seat \[N s\]; `None` where end turns have no seats to meet.
    pub blow: Option<f64>,
    /// How often an end leaves its seat in a turn; `None` where ends stay where they are.
    pub lifts: Option<f64>,
    /// How the follower floats; `None` without one.
    pub floating: Option<Floating>,
    /// Shear stress where the wire is worst off; `None` where nothing could be followed.
    pub stress: Option<Stress>,
    /// By how much the extremes of the last two turns differ from those of the two before, as a share of F_nom: what repeats has settled. Of a run from rest in
    /// which nothing has met at least what is left of its way to what repeats, e^(−ζ ω_1 t) of the surge.
    pub unsettled: f64,
    /// Turns that were run.
    pub turns: usize,
    /// Why the run ended early.
    #[serde(with = "super::kept::given_up")]
    pub given_up: Option<GivenUp>,
}

impl SpeedPoint {
    /// Whether the follower floats.
    pub fn is_aloft(&self) -> bool {
        self.floating.is_some_and(|floating| floating.floats > 0.0)
    }

    /// Whether windings meet, or a winding and its seat.
    pub fn meets(&self) -> bool {
        self.touches > 0.0
    }

    /// The least push on seat 1 and seat 2 \[N\]: at zero an end is about to leave its seat.
    pub fn least_push(&self) -> [f64; 2] {
        // A sum with zero has no sign of zero.
        [self.input[1], self.output[1]].map(|force| 0.0 - force)
    }
}

/// A follower off its cam.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
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
/// The turns that are looked at.
pub(super) struct Turns {
    /// From when to when \[s\].
    pub from: f64,
    pub until: f64,
    /// Samples in each.
    pub in_a_turn: usize,
    /// All that were run.
    pub count: usize,
}

impl Turns {
    /// How much of them lies between two times \[1\].
    fn share(&self, from: f64, until: f64) -> f64 {
        (until.min(self.until) - from.max(self.from)).max(0.0) / (self.until - self.from)
    }

    /// How often a turn something happens that happened so often in all.
    fn each(count: usize) -> f64 {
        count as f64 / JUDGED as f64
    }
}

pub(super) fn judged(spec: &Spec, way: usize, speed: f64, course: &Course, turns: &Turns) -> SpeedPoint {
    let spring = &spec.spring.spring;
    let (input, output) = (extremes(&course.input), extremes(&course.output));
    let pairs = || course.input.iter().zip(&course.output);
    let samples = course.input.len().max(1) as f64;
    let is_seen = |time: f64| (turns.from..turns.until).contains(&time);
    let touches = || course.touches.iter().filter(|touch| is_seen(touch.time));
    let base = usize::from(!course.cam_force.is_empty());
    let last = base + spring.chain_masses();
    let at_seat = |points: [usize; 2]| points[0] == base || points[1] > last;
    let blows = || touches().filter(|touch| at_seat(touch.points)).map(|touch| touch.impulse);
    let contact = spec.mount.cases[way].contact.as_ref().map(|way| &way.contact);
    SpeedPoint {
        speed,
        way,
        input,
        output,
        apart: (pairs().map(|(input, output)| (output - input).powi(2)).sum::<f64>() / samples).sqrt(),
        surge: surge(course, spring),
        harmonics: harmonics(&course.output, turns.in_a_turn),
        touches: Turns::each(touches().count()),
        closed: closed(&course.touches, turns),
        fastest: touches().map(|touch| touch.closing_speed).fold(0.0, f64::max),
        blow: contact.is_some_and(|contact| contact.ends()).then(|| blows().fold(0.0, f64::max)),
        lifts: contact
            .is_some_and(|contact| contact.lifts())
            .then(|| Turns::each(course.lifts.iter().filter(|lift| is_seen(lift.time)).count())),
        floating: (!course.cam_force.is_empty()).then(|| floating(course, turns)),
        stress: Stress::worst(&spec.spring, spec.strength.as_ref(), &course.tensions),
        unsettled: unsettled(course, turns.in_a_turn) / spring.nominal_force(),
        turns: turns.count,
        given_up: course.given_up,
    }
}

fn extremes(forces: &[f64]) -> [f64; 2] {
    forces.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], force| [low.min(*force), high.max(*force)])
}

/// The largest |F − F_x| of both ends.
fn surge(course: &Course, spring: &Spring) -> f64 {
    let stretches = course.end1.iter().zip(&course.end2).map(|(first, second)| second - first);
    let forces = course.input.iter().zip(&course.output).zip(stretches);
    let apart = |((input, output), stretch): ((&f64, &f64), f64)| {
        let still = spring.static_force(spring.rest_length() + stretch);
        (input - still).abs().max((output - still).abs())
    };
    forces.map(apart).fold(0.0, f64::max)
}

/// By how much the extremes of the first two turns differ from those of the last two \[N\].
fn unsettled(course: &Course, in_a_turn: usize) -> f64 {
    let of = |forces: &[f64]| {
        let half = (2 * in_a_turn).min(forces.len());
        let ([a, b], [c, d]) = (extremes(&forces[..half]), extremes(&forces[forces.len() - half..]));
        (a - c).abs().max((b - d).abs())
    };
    if course.input.is_empty() { 0.0 } else { of(&course.input).max(of(&course.output)) }
}

/// The largest share of the turns during which one and the same pair of points touches.
fn closed(touches: &[Touch], turns: &Turns) -> f64 {
    let mut shares: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for touch in touches {
        *shares.entry(touch.points).or_default() += turns.share(touch.time, touch.parted.unwrap_or(turns.until));
    }
    shares.into_values().fold(0.0, f64::max)
}

fn floating(course: &Course, turns: &Turns) -> Floating {
    let floats = || {
        let aloft = course.floats.iter().filter(|float| float.back.is_none() || float.closing_speed >= GRAZES);
        aloft.filter(|float| float.time < turns.until && float.back.is_none_or(|back| back > turns.from))
    };
    Floating {
        least_cam_force: extremes(&course.cam_force)[0].max(0.0),
        floats: Turns::each(floats().count()),
        share: floats()
            .map(|float| turns.share(float.time, float.back.unwrap_or(turns.until)))
            .fold(0.0, |sum, share| sum + share),
        fastest: floats().map(|float| float.closing_speed).fold(0.0, f64::max),
    }
}

/// Amplitudes of the harmonics of a turn, over the whole turns that there are: those of their mean.
fn harmonics(forces: &[f64], in_a_turn: usize) -> Vec<f64> {
    let whole = forces.chunks_exact(in_a_turn);
    let count = whole.len();
    if count == 0 {
        return Vec::new();
    }
    let mut mean = vec![0.0; in_a_turn];
    for turn in whole {
        mean.iter_mut().zip(turn).for_each(|(mean, force)| *mean += force / count as f64);
    }
    let wave: Vec<(f64, f64)> =
        (0..in_a_turn).map(|sample| (TAU * sample as f64 / in_a_turn as f64).sin_cos()).collect();
    let of = |harmonic: usize| {
        let (mut sine, mut cosine) = (0.0, 0.0);
        for (sample, force) in mean.iter().enumerate() {
            let (sin, cos) = wave[harmonic * sample % in_a_turn];
            (sine, cosine) = (sine + force * sin, cosine + force * cos);
        }
        2.0 / in_a_turn as f64 * cosine.hypot(sine)
    };
    // Above half the samples of a turn there is nothing.
    (1..=HARMONICS.min(in_a_turn / 2)).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_of_the_third_harmonic_is_found_there_and_nowhere_else() {
        let samples = 150;
        let forces: Vec<f64> = (0..=4 * samples)
            .map(|sample| -5.0 + 2.0 * (TAU * 3.0 * sample as f64 / samples as f64 + 0.3).sin())
            .collect();
        let found = harmonics(&forces, samples);
        assert_eq!(found.len(), HARMONICS);
        for (index, amplitude) in found.iter().enumerate() {
            let expected = if index == 2 { 2.0 } else { 0.0 };
            // Rounding of a sum of 150.
            assert!((amplitude - expected).abs() < 1e-12, "{index}: {amplitude}");
        }
        assert!(harmonics(&forces[..100], samples).is_empty());
    }

    #[test]
    fn what_is_closed_over_the_begin_counts_from_there() {
        let turns = Turns { from: 1.0, until: 5.0, in_a_turn: 64, count: 12 };
        let touch = |points, time, parted| Touch {
            points,
            time,
            closing_speed: 1.0,
            parted,
            impulse: 0.0,
            pressed: 0.0,
            peak: 0.0,
            lost: 0.0,
        };
        let touches = [touch([1, 2], 0.0, Some(2.0)), touch([1, 2], 4.5, None), touch([2, 3], 2.0, Some(3.0))];
        assert!((closed(&touches, &turns) - 0.375).abs() < 1e-12);
    }
}
