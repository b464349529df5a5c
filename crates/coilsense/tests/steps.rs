//! Steps against what they are the limit of: ramps and recorded edges of some nanoseconds, centred on them.
//!
//! A ramp of duration d answers with the mean of the answers to steps within it: centred, it differs by (ωd)²/24 at a mode of angular
//! frequency ω. The other way, a ramp of a millimetre in d moves so fast (1e5 m/s) that rounding takes 1e-16/ωd of it at the slowest mode. With S_T's
//! wire in twenty windings, 100 to 4300 rad/s, both are below 1e-9 at 15 ns. All times of ramps are binary fractions, so that each lasts what it
//! says: a begin at 4 ms rounded to its last digit is out by 1e-10 of that.

mod paper_springs;

use coilsense::excitation::Sampled;
use coilsense::motion::Live;
use coilsense::{Damping, End, EndInput, Excitation, FarEnd, Motion, Mount, Spring, Start, VelocityProfile};
use paper_springs::{s_t, s_t_with};

/// When steps happen: 2^-8 s.
const AT: f64 = 1.0 / 256.0;

/// How long ramps last: 2^-26 s.
const LASTS: f64 = 1.0 / 67_108_864.0;

/// How long recorded edges last: 2^-29 s.
const EDGE: f64 = LASTS / 8.0;

const FAR_ENDS: [FarEnd; 4] = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.02), FarEnd::Mass(0.05)];

/// S_T's wire in a number of windings.
fn wound(windings: f64) -> Spring {
    Spring::new(s_t_with(|parameters| parameters.windings = windings)).unwrap()
}

/// Every kind of damping, from none to overdamped, for a number of modes.
fn dampings(modes: usize) -> Vec<Damping> {
    let each = (0..modes).map(|mode| 2.0 * mode as f64 / modes as f64).collect();
    let mut dampings: Vec<Damping> =
        [0.001, 0.005, 0.02, 0.05, 0.3, 0.999, 1.0, 1.001, 1.5].map(Damping::Modal).to_vec();
    dampings.extend([
        Damping::None,
        Damping::ModalEach(each),
        Damping::MassProportional { rate: 40.0 },
        Damping::MassProportional { rate: 1000.0 },
        Damping::StiffnessProportional { time: 4e-5 },
        Damping::StiffnessProportional { time: 8e-4 },
    ]);
    dampings
}

fn mounts(spring: &Spring) -> Vec<Mount> {
    let each = FAR_ENDS.into_iter().flat_map(|far_end| {
        let modes = coilsense::modes::ChainModes::mounted(spring, far_end).count();
        dampings(modes).into_iter().map(move |damping| Mount::new(far_end, damping).unwrap())
    });
    each.collect()
}

/// A millimetre, or the force that makes one.
fn height(spring: &Spring, mount: &Mount, end: End) -> f64 {
    if end == End::Two && mount.far_end() != FarEnd::Position { 1e-3 * spring.stiffness() } else { 1e-3 }
}

/// The force after a step of a spring without mass \[N\].
fn settled(spring: &Spring, mount: &Mount, end: End) -> f64 {
    let height = height(spring, mount, end);
    let change = match (end, mount.far_end()) {
        (End::One, FarEnd::Position) => -height * spring.stiffness(),
        (End::One, _) => 0.0,
        (End::Two, FarEnd::Position) => height * spring.stiffness(),
        (End::Two, _) => height,
    };
    spring.static_force(spring.mid_length()) + change
}

/// How far a step of the closed solution may be off a ramp. Where a mode's roots are within a tenth of each other, a ramp of 1e5 m/s costs the
/// solution two digits more; that a step does not suffer is seen where it is compared with the march.
fn allowed(mount: &Mount) -> f64 {
    match mount.damping() {
        Damping::Modal(ratio) if (ratio - 1.0).abs() < 0.01 && *ratio != 1.0 => 1e-7,
        _ => 1e-9,
    }
}

fn step(height: f64) -> EndInput {
    EndInput::Step { height, at: AT }
}

fn ramp(height: f64) -> EndInput {
    EndInput::Ramp { height, from: AT - 0.5 * LASTS, duration: LASTS }
}

/// A recorded edge about a time.
fn edge(height: f64, middle: f64) -> EndInput {
    let times = vec![middle - 0.5 * EDGE, middle + 0.5 * EDGE];
    EndInput::Sampled(Sampled::new(times, vec![0.0, height]).unwrap())
}

fn moved(spring: &Spring, mount: &Mount, end: End, [input, other]: [EndInput; 2]) -> Motion {
    let [first, second] = if end == End::One { [input, other] } else { [other, input] };
    let excitation = Excitation::new(spring.mid_length(), first, second, Start::Rest).unwrap();
    Motion::mounted(spring, mount, &excitation).unwrap()
}

/// Equidistant times after the step, off all grids.
fn times() -> Vec<f64> {
    (0..200).map(|k| AT + 1.3e-4 + f64::from(k) * 2.1e-4).collect()
}

/// F_i, F_o and u2.
fn seen(motion: &Motion, times: &[f64]) -> [Vec<f64>; 3] {
    let forces = motion.end_forces(times).unwrap();
    [forces.input, forces.output, motion.ends(times).unwrap().into_iter().map(|[_, u2]| u2).collect()]
}

fn range(series: &[f64]) -> f64 {
    let fold = |start: f64, of: fn(f64, f64) -> f64| series.iter().copied().fold(start, of);
    fold(f64::NEG_INFINITY, f64::max) - fold(f64::INFINITY, f64::min)
}

fn worst(ours: &[f64], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    ours.iter().zip(theirs).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()))
}

/// Largest difference over the peak: of both forces over the most that either is off `settled`, where a spring without mass would be; of u2
/// over a millimetre.
fn off(ours: &[Vec<f64>; 3], theirs: &[Vec<f64>; 3], settled: f64) -> f64 {
    let dynamic = theirs[..2].iter().flatten().map(|force| (force - settled).abs());
    let peak = dynamic.fold(0.0_f64, f64::max);
    let forces = worst(&ours[0], &theirs[0]).max(worst(&ours[1], &theirs[1])) / peak;
    forces.max(worst(&ours[2], &theirs[2]) / 1e-3)
}

/// Largest of some, shown with `--nocapture`.
#[derive(Default)]
struct Largest(f64);

impl Largest {
    fn below(&mut self, deviation: f64, allowed: f64, what: &dyn std::fmt::Debug) {
        assert!(deviation < allowed, "{deviation:e}: {what:?}");
        self.0 = self.0.max(deviation);
    }
}

#[test]
fn a_step_is_a_short_ramp_and_a_recorded_edge_on_every_mount() {
    let spring = wound(20.0);
    let (mut of_ramps, mut of_edges) = (Largest::default(), Largest::default());
    let times = times();
    let scattered: Vec<f64> = times.iter().rev().step_by(11).copied().collect();
    for mount in mounts(&spring) {
        for end in [End::One, End::Two] {
            let (height, settled) = (height(&spring, &mount, end), settled(&spring, &mount, end));
            let of = |input| moved(&spring, &mount, end, [input, EndInput::Held]);
            let (stepped, ramped, recorded) = (of(step(height)), of(ramp(height)), of(edge(height, AT)));
            for times in [&times, &scattered] {
                let theirs = seen(&ramped, times);
                of_ramps.below(off(&seen(&stepped, times), &theirs, settled), allowed(&mount), &(&mount, end));
                // Eight times as fast, so that rounding takes eight times as much.
                let recorded = off(&seen(&stepped, times), &seen(&recorded, times), settled);
                of_edges.below(recorded, 4.0 * allowed(&mount), &(&mount, end));
            }
        }
    }
    println!("largest deviation from ramps {:e}, from edges {:e}", of_ramps.0, of_edges.0);
}

#[test]
fn windings_and_their_velocities_after_a_step_are_those_after_a_ramp() {
    let spring = wound(20.0);
    let highest = 2.0 * spring.chain_masses() as f64 / spring.transit_time();
    let (mut places, mut speeds) = (Largest::default(), Largest::default());
    let times = times();
    for mount in mounts(&spring) {
        let of = |input| moved(&spring, &mount, End::One, [input, EndInput::Held]);
        let (stepped, ramped) = (of(step(1e-3)), of(ramp(1e-3)));
        let [ours, theirs] = [&stepped, &ramped].map(|motion| motion.windings(&times).unwrap());
        for sample in 0..times.len() {
            places.below(worst(ours.row(sample), theirs.row(sample)) / 1e-3, allowed(&mount), &mount);
        }
        let [ours, theirs] = [&stepped, &ramped].map(|motion| motion.velocities(times[3]).unwrap());
        // What a millimetre is at the highest mode.
        speeds.below(worst(&ours, &theirs) / (1e-3 * highest), 1e-9, &mount);
    }
    println!("largest deviation of positions {:e}, of velocities {:e}", places.0, speeds.0);
}

#[test]
fn a_step_is_a_short_ramp_where_the_motion_is_followed_step_by_step() {
    let spring = wound(20.0);
    let mut largest = Largest::default();
    let times = times();
    // Neither has a closed solution: a chirp, and a recording with more corners than are worth solving.
    let knots: Vec<f64> = (0..90).map(|k| f64::from(k) * 5e-4).collect();
    let values: Vec<f64> = knots.iter().map(|t| (900.0 * t).sin()).collect();
    let recording = |scale: f64| {
        let values = values.iter().map(|value| 1e-4 * scale * value).collect();
        EndInput::Sampled(Sampled::new(knots.clone(), values).unwrap())
    };
    let chirp =
        |scale: f64| EndInput::Chirp { amplitude: 1e-4 * scale, from: 20.0, to: 90.0, duration: 0.03, phase: 0.2 };
    for mount in mounts(&spring) {
        for end in [End::One, End::Two] {
            let (height, settled) = (height(&spring, &mount, end), settled(&spring, &mount, end));
            let other = if end == End::One { End::Two } else { End::One };
            let scale = self::height(&spring, &mount, other) / 1e-3;
            for other in [chirp(scale), recording(scale)] {
                let of = |input| moved(&spring, &mount, end, [input, other.clone()]);
                let (ours, theirs) = (of(step(height)), of(ramp(height)));
                largest.below(off(&seen(&ours, &times), &seen(&theirs, &times), settled), 1e-9, &(&mount, end, &other));
            }
        }
    }
    println!("largest deviation {:e}", largest.0);
}

#[test]
fn a_streamed_and_a_truncated_step_are_the_motions_own() {
    let spring = wound(20.0);
    let (mut streams, mut truncations, mut ramps) = (Largest::default(), Largest::default(), Largest::default());
    // The step falls on sample 64.
    let interval = AT / 64.0;
    let times: Vec<f64> = (0..600).map(|k| f64::from(k) * interval).collect();
    for mount in mounts(&spring) {
        for end in [End::One, End::Two] {
            let (height, settled) = (height(&spring, &mount, end), settled(&spring, &mount, end));
            let of = |input| moved(&spring, &mount, end, [input, EndInput::Held]);
            let motion = of(step(height));
            let theirs = seen(&motion, &times);
            let streamed = |motion: &Motion| {
                let samples = motion.stream(interval).unwrap().take(times.len());
                let (input, output) = samples.map(|sample| (sample.input, sample.output)).unzip();
                [input, output, theirs[2].clone()]
            };
            let ours = streamed(&motion);
            streams.below(off(&ours, &theirs, settled), 1e-11, &(&mount, end));
            let all = motion.truncated(motion.modes().count()).unwrap();
            truncations.below(off(&seen(&all, &times), &theirs, settled), 1e-13, &(&mount, end));
            let ramped = streamed(&of(ramp(height)));
            // Two samples after the ramp.
            let after = |series: &[Vec<f64>; 3]| series.each_ref().map(|series| series[66..].to_vec());
            ramps.below(off(&after(&ours), &after(&ramped), settled), 1e-9, &(&mount, end));
        }
    }
    println!(
        "largest deviation of streams {:e}, of truncations {:e}, from ramps {:e}",
        streams.0, truncations.0, ramps.0
    );
}

#[test]
fn live_inputs_that_jump_are_a_step() {
    // Four windings: slow enough for an edge of one sample of 60 ns to be a step to 1e-9, and few enough for 40 000 samples.
    let spring = wound(4.0);
    let interval = AT / 65_536.0;
    let mut largest = Largest::default();
    for mount in mounts(&spring) {
        for end in [End::One, End::Two] {
            let (height, settled) = (height(&spring, &mount, end), settled(&spring, &mount, end));
            let at = 99.5 * interval;
            let motion = moved(&spring, &mount, end, [EndInput::Step { height, at }, EndInput::Held]);
            let mut live = Live::new(&spring, &mount, spring.mid_length(), interval).unwrap();
            let (mut ours, mut times) = ([vec![], vec![], vec![]], vec![]);
            for sample in 1..40_000 {
                let mut inputs = [0.0; 2];
                inputs[end as usize] = if sample < 100 { 0.0 } else { height };
                let force = live.advance(inputs).unwrap();
                if sample % 800 == 0 {
                    times.push(f64::from(sample) * interval);
                    ours[0].push(force.input);
                    ours[1].push(force.output);
                }
            }
            let mut theirs = seen(&motion, &times);
            ours[2] = std::mem::take(&mut theirs[2]);
            theirs[2] = ours[2].clone();
            largest.below(off(&ours, &theirs, settled), 1e-9, &(&mount, end));
        }
    }
    println!("largest deviation {:e}", largest.0);
}

#[test]
fn a_step_at_zero_comes_after_the_start() {
    let spring = wound(20.0);
    let (mut of_ramps, mut of_sums, times) = (Largest::default(), Largest::default(), times());
    let later: Vec<f64> = times.iter().map(|t| t + 0.5 * LASTS).collect();
    let n = spring.chain_masses();
    let positions = (0..n).map(|i| spring.mid_length() * (i as f64 + 0.6) / n as f64).collect();
    let velocities = (0..n).map(|i| 0.1 * (i as f64).sin()).collect();
    let starts = [
        Start::Moving { velocity: 0.1, profile: VelocityProfile::Uniform },
        Start::Moving { velocity: -0.1, profile: VelocityProfile::Linear },
        Start::Windings { positions, velocities },
    ];
    for mount in mounts(&spring) {
        for end in [End::One, End::Two] {
            let (height, settled) = (height(&spring, &mount, end), settled(&spring, &mount, end));
            let of = |input: EndInput, start: &Start, times: &[f64]| {
                let [first, second] = if end == End::One { [input, EndInput::Held] } else { [EndInput::Held, input] };
                let excitation = Excitation::new(spring.mid_length(), first, second, start.clone()).unwrap();
                seen(&Motion::mounted(&spring, &mount, &excitation).unwrap(), times)
            };
            let step = EndInput::Step { height, at: 0.0 };
            let from_rest = of(step.clone(), &Start::Rest, &times);
            // At rest until then, a ramp from t = 0 on is the same, later by half of what it lasts.
            let ramp = of(EndInput::Ramp { height, from: 0.0, duration: LASTS }, &Start::Rest, &later);
            of_ramps.below(off(&from_rest, &ramp, settled), allowed(&mount), &(&mount, end));
            // What moves at the start adds what it would do with the ends held.
            let at_rest = of(EndInput::Held, &Start::Rest, &times);
            for start in &starts {
                let (ours, held) = (of(step.clone(), start, &times), of(EndInput::Held, start, &times));
                let sum = [0, 1, 2].map(|series| {
                    let each = from_rest[series].iter().zip(&at_rest[series]).zip(&held[series]);
                    each.map(|((step, rest), held)| held + step - rest).collect()
                });
                of_sums.below(off(&ours, &sum, settled), 1e-11, &(&mount, end, start));
            }
        }
    }
    println!("largest deviation from ramps {:e}, from sums {:e}", of_ramps.0, of_sums.0);
}

#[test]
fn a_massless_start_has_followed_a_step_at_zero() {
    let spring = s_t();
    for mount in mounts(&spring) {
        let first = EndInput::Step { height: 1e-3, at: 0.0 };
        let excitation = Excitation::new(0.23, first, EndInput::Held, Start::Massless).unwrap();
        let forces = Motion::mounted(&spring, &mount, &excitation).unwrap().end_forces(&times()).unwrap();
        assert!(range(&forces.input) < 1e-12 && range(&forces.output) < 1e-12, "{mount:?}");
    }
}

#[test]
fn bounds_hold_after_a_step_however_it_is_damped() {
    let spring = s_t();
    // From the step on, and again and again: the most happens at once.
    let mut times: Vec<f64> = (0..400).map(|k| AT + 2e-6 * f64::from(k)).collect();
    times.extend((0..400).map(|k| AT + 8e-4 + 1e-4 * f64::from(k)));
    let creeping = FAR_ENDS.map(|far_end| Mount::new(far_end, Damping::Modal(30.0)).unwrap());
    for mount in mounts(&spring).into_iter().chain(creeping) {
        for end in [End::One, End::Two] {
            let height = height(&spring, &mount, end);
            let motion = moved(&spring, &mount, end, [step(height), EndInput::Held]);
            let full = motion.end_forces(&times).unwrap();
            for modes in [1, 7, 40] {
                let kept = motion.truncated(modes).unwrap();
                let (forces, bound) = (kept.end_forces(&times).unwrap(), kept.truncation_bound());
                let missing = [worst(&forces.input, &full.input), worst(&forces.output, &full.output)];
                for (missing, bound) in missing.into_iter().zip(bound) {
                    assert!(missing <= bound + 1e-9, "{missing} {bound} {modes} {mount:?} {end:?}");
                }
            }
            let closest = coilsense::Clash::of(&motion, &times).unwrap().smallest_pitch;
            let least = motion.least_pitch(1.0);
            assert!(least <= closest + 1e-12, "{least} {closest} {mount:?} {end:?}");
        }
    }
}
