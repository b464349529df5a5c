//! Tests: recordings processed in blocks and sines that turn from step to step, beside the march that follows every kick and finds a sine's
//! push by quadrature.
//!
//! Next door: what is tested (`recorded`, `kicked_blocks`, `sines`, `stream`); the three ways on every mount (`tests/engine.rs`).

use std::f64::consts::TAU;

use super::forces::EndForces;
use super::{Motion, step_of};
use crate::excitation::{End, EndInput, Excitation, Sampled, Start, VelocityProfile};
use crate::spring::{Spring, SpringParameters};
use crate::{Damping, FarEnd, Mount};

/// S_T of the paper with any number of windings.
fn s_t(windings: f64) -> Spring {
    Spring::new(SpringParameters { windings, ..crate::paper::S_T }).unwrap()
}

/// A start that makes every mode ring.
const MOVING: Start = Start::Moving { velocity: 0.1, profile: VelocityProfile::Linear };

/// Every far end beside dampings from none to modes that only creep; at the last the highest modes are overdamped.
fn mounts() -> Vec<Mount> {
    let dampings = [Damping::None, Damping::Modal(0.005), Damping::StiffnessProportional { time: 3e-4 }];
    let far_ends = [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.1)];
    let each = far_ends.into_iter().flat_map(|far_end| dampings.iter().map(move |damping| (far_end, damping.clone())));
    each.map(|(far_end, damping)| Mount::new(far_end, damping).unwrap()).collect()
}

fn moved(spring: &Spring, mount: &Mount, [first, second]: [EndInput; 2], start: Start) -> Motion {
    let excitation = Excitation::new(0.23, first, second, start).unwrap();
    Motion::mounted(spring, mount, &excitation).unwrap()
}

/// Equidistant times.
fn times(first: f64, step: f64, count: usize) -> Vec<f64> {
    (0..count).map(|k| first + k as f64 * step).collect()
}

/// Points of one grid of 0.1 ms, equal to the bit in every series: with dashpots a kick makes a force jump, and a march counts it by the last
/// digit of its time.
fn points(first: usize, stride: usize, count: usize) -> Vec<f64> {
    (0..count).map(|k| (first + k * stride) as f64 * 1e-4).collect()
}

/// A smooth series of about a millimetre.
fn series(times: Vec<f64>) -> Sampled {
    let value = |t: &f64| 1e-3 * (13.0 * t).sin() * (171.0 * t).cos() + 2e-4 * (900.0 * t).sin();
    let values = times.iter().map(value).collect();
    Sampled::new(times, values).unwrap()
}

fn recording(first: f64, step: f64, count: usize) -> EndInput {
    EndInput::Sampled(series(times(first, step, count)))
}

/// As a force \[N\] instead of a length.
fn in_newtons(input: EndInput, spring: &Spring) -> EndInput {
    let EndInput::Sampled(sampled) = input else {
        return input;
    };
    let values = sampled.values().iter().map(|value| value * spring.stiffness()).collect();
    EndInput::Sampled(Sampled::new(sampled.times().to_vec(), values).unwrap())
}

impl EndForces {
    /// One sample in so many.
    fn every(self, stride: usize) -> Self {
        let thinned = |values: Vec<f64>| values.into_iter().step_by(stride).collect();
        Self { input: thinned(self.input), output: thinned(self.output) }
    }
}

/// Both forces from time to time: every kick at its own moment, every sine by quadrature.
fn by_march(motion: &Motion, times: &[f64]) -> EndForces {
    let mut march = motion.march(step_of(times));
    let forces = times.iter().map(|&time| {
        march.advance_to(time);
        let [surge, slow] = [motion.surge_forces(march.sums()), motion.slow_forces_under(motion.inputs(), time)];
        [surge[0] + slow[0], surge[1] + slow[1]]
    });
    let (input, output) = forces.map(<(f64, f64)>::from).unzip();
    EndForces { input, output }
}

fn by_stream(motion: &Motion, step: f64, count: usize) -> EndForces {
    let samples = motion.stream(step).unwrap().take(count);
    let (input, output) = samples.map(|sample| (sample.input, sample.output)).unzip();
    EndForces { input, output }
}

/// Largest difference at either end over the larger peak of what oscillates: where one end hardly feels the other, its force is what is left
/// of modes that pull as much as at the other.
fn off(ours: &EndForces, theirs: &EndForces) -> f64 {
    let mut worst = 0.0_f64;
    // Forces of about 100 N carry 1e-14 N of rounding themselves.
    let mut peak = 1.0_f64;
    for (ours, theirs) in [(&ours.input, &theirs.input), (&ours.output, &theirs.output)] {
        assert_eq!(ours.len(), theirs.len());
        let mean = theirs.iter().sum::<f64>() / theirs.len() as f64;
        peak = theirs.iter().fold(peak, |peak, value| peak.max((value - mean).abs()));
        for (a, b) in ours.iter().zip(theirs) {
            // A number that is none is as far off as can be.
            worst = worst.max(if (a - b).is_nan() { f64::INFINITY } else { (a - b).abs() });
        }
    }
    worst / peak
}

/// What the last digit of a time means at the rate of the fastest mode, or 1e-12 where that is more: no way of evaluating knows better.
fn tolerance(motion: &Motion, until: f64) -> f64 {
    let modes = motion.modes.frequencies().iter().zip(&motion.ratios);
    let fastest = modes.fold(0.0_f64, |most, (natural, ratio)| most.max(natural * f64::max(1.0, 2.0 * ratio)));
    f64::max(1e-12, 2.0 * f64::EPSILON * until * fastest)
}

fn assert_in_blocks(motion: &Motion, times: &[f64], what: &str) {
    let ours = motion.under_recordings(times).unwrap_or_else(|| panic!("{what}: not processed in blocks"));
    let (off, allowed) = (off(&ours, &by_march(motion, times)), tolerance(motion, times[times.len() - 1]));
    assert!(off < allowed, "{what}: {off:e} of {allowed:e}: {:?}", motion.mount());
    assert_eq!(motion.end_forces(times).unwrap(), ours, "{what}: the quick way is the one taken");
}

fn assert_from_time_to_time(motion: &Motion, times: &[f64], what: &str) {
    assert_eq!(motion.under_recordings(times), None, "{what}");
    assert!(off(&motion.end_forces(times).unwrap(), &by_march(motion, times)) < tolerance(motion, 1.0), "{what}");
}

#[test]
fn a_recording_in_blocks_is_what_every_kick_by_itself_gives() {
    let spring = s_t(52.0);
    for mount in mounts() {
        let second = |input: EndInput| match mount.far_end() {
            FarEnd::Position => input,
            _ => in_newtons(input, &spring),
        };
        let at = |first, stride, count| EndInput::Sampled(series(points(first, stride, count)));
        for (what, inputs, times) in [
            ("sample by sample", [at(0, 1, 3000), EndInput::Held], points(0, 1, 3000)),
            ("both ends", [at(0, 1, 900), second(at(0, 2, 700))], points(0, 1, 1000)),
            ("at end 2", [EndInput::Held, second(at(0, 1, 400))], points(0, 1, 300)),
            ("a window", [at(0, 1, 3000), EndInput::Held], points(1500, 1, 999)),
            ("finer times", [at(0, 10, 100), EndInput::Held], points(0, 1, 1500)),
            ("coarser times", [at(0, 1, 3000), EndInput::Held], points(7, 4, 700)),
            ("much coarser times", [at(0, 1, 9000), EndInput::Held], points(0, 150, 60)),
            ("a late begin", [at(200, 1, 500), EndInput::Held], points(0, 1, 1500)),
            ("over before", [at(0, 1, 500), EndInput::Held], points(1000, 1, 300)),
            ("not yet begun", [at(1000, 1, 500), EndInput::Held], points(0, 1, 300)),
            ("up to the first sample", [at(1000, 1, 500), EndInput::Held], points(969, 1, 32)),
        ] {
            assert_in_blocks(&moved(&spring, &mount, inputs, MOVING), &times, what);
        }
    }
}

#[test]
fn what_else_drives_the_spring_is_added() {
    let spring = s_t(52.0);
    for other in [
        EndInput::harmonic(1e-4, 77.0, 0.3),
        EndInput::Step { height: 5e-4, at: 0.012_34 },
        EndInput::Ramp { height: 5e-4, from: 0.01, duration: 0.018 },
        EndInput::HalfSine { height: 5e-4, from: 0.05, duration: 0.02 },
        recording(0.0, 0.013, 40),
    ] {
        for mount in mounts() {
            let motion = moved(&spring, &mount, [recording(0.0, 1e-4, 1200), other.clone()], Start::Massless);
            assert_in_blocks(&motion, &times(0.0, 1e-4, 1200), &format!("{other:?}"));
        }
    }
}

#[test]
fn a_recording_off_the_grid_is_followed_from_time_to_time() {
    let spring = s_t(52.0);
    let even = times(0.0, 1e-4, 1000);
    let mut uneven = even.clone();
    uneven[500] += 3e-5;
    let before_zero = times(-0.01, 1e-4, 1000);
    let chirp = EndInput::Chirp { amplitude: 1e-4, from: 5.0, to: 50.0, duration: 0.05, phase: 0.4 };
    let free = Mount::default();
    let held = || EndInput::Held;
    let of = |samples: Vec<f64>, second: EndInput, mount: &Mount| {
        moved(&spring, mount, [EndInput::Sampled(series(samples)), second], Start::Rest)
    };
    assert_from_time_to_time(&of(uneven.clone(), held(), &free), &even, "uneven samples");
    assert_from_time_to_time(&of(times(0.0, 1.7e-4, 600), held(), &free), &even, "samples between the points");
    assert_from_time_to_time(&of(times(3e-5, 1e-4, 1000), held(), &free), &even, "a shifted grid");
    assert_from_time_to_time(&of(before_zero, held(), &free), &even, "a begin before t = 0");
    assert_from_time_to_time(&of(even.clone(), chirp, &free), &even, "a chirp at the other end");
    assert_from_time_to_time(&of(even.clone(), held(), &free), &uneven, "uneven times");
    assert_from_time_to_time(&of(even.clone(), held(), &free), &even[..31], "few times");
    assert_from_time_to_time(&of(even.clone(), held(), &free), &times(0.0, 0.1, 32), "hardly a sample to a point");
    // Its two exponentials have no difference to divide by.
    let critical = Mount::new(FarEnd::Position, Damping::Modal(1.0)).unwrap();
    assert_from_time_to_time(&of(even.clone(), held(), &critical), &even, "a critical mode");
}

#[test]
fn recordings_without_motion_pull_as_a_held_end_does() {
    let spring = s_t(52.0);
    let times = times(0.0, 1e-4, 400);
    let still = |count: usize| {
        let samples = (0..count).map(|k| k as f64 * 1e-4).collect();
        EndInput::Sampled(Sampled::new(samples, vec![1e-3; count]).unwrap())
    };
    // One sample, two equal ones, more than the closed solution takes, more than there are times.
    for count in [1, 2, 64, 65, 100, 4000] {
        let motion = moved(&spring, &Mount::default(), [still(count), EndInput::Held], Start::Massless);
        let force = spring.static_force(0.23 - 1e-3);
        let forces = motion.end_forces(&times).unwrap();
        assert!(forces.input.iter().chain(&forces.output).all(|one| (one - force).abs() < 1e-12), "{count}");
        assert_eq!(motion.under_recordings(&times).is_some(), count >= 32, "{count}");
    }
}

/// The sum over every kick so far, each mode's sine taken at its own time: no step before it matters.
fn by_kicks(motion: &Motion, time: f64) -> [f64; 2] {
    let mut forces = motion.slow_forces_under(motion.inputs(), time);
    let kicks = motion.excitation.input(End::One).kicks();
    for (mode, natural) in motion.modes.frequencies().iter().enumerate() {
        let (q, rate) = (motion.start.coordinates[mode], motion.start.rates[mode]);
        let past = kicks.iter().filter(|kick| kick.time <= time);
        let kicked: f64 = past.map(|kick| kick.velocity * (natural * (time - kick.time)).sin()).sum();
        let free = q * (natural * time).cos() + rate * (natural * time).sin() / natural;
        let coordinate = free - motion.modes.participations()[0][mode] * kicked / natural;
        for (force, weights) in forces.iter_mut().zip(motion.modes.weights()) {
            *force += motion.force_scale() * weights[mode] * coordinate;
        }
    }
    forces
}

#[test]
fn a_million_samples_do_not_drift() {
    // Eight windings: 1e6 kicks on each of eight modes, summed one by one at three times.
    let spring = s_t(8.0);
    let (step, count) = (1e-4, 1_000_001);
    let motion = moved(&spring, &Mount::default(), [recording(0.0, step, count), EndInput::Held], Start::Rest);
    let forces = motion.under_recordings(&times(0.0, step, count)).unwrap();
    let peak = forces.input.iter().fold(0.0_f64, |peak, force| peak.max((force - forces.input[0]).abs()));
    for sample in [10_000, 500_017, 1_000_000] {
        let time = sample as f64 * step;
        let expected = by_kicks(&motion, time);
        for (ours, expected) in [forces.input[sample], forces.output[sample]].into_iter().zip(expected) {
            let (off, allowed) = ((ours - expected).abs() / peak, tolerance(&motion, time));
            assert!(off < allowed, "{sample}: {off:e} of {allowed:e}");
        }
    }
}

/// Frequencies \[Hz\] from far below the modes to far above what steps of 0.1 ms can show, some of them on a mode.
fn frequencies(motion: &Motion) -> Vec<f64> {
    let mode = |number: usize| motion.modes.frequencies()[number - 1] / TAU;
    let last = motion.modes.count();
    let mut all = vec![1e-6, 0.01, 20.0, 2500.0, 12_345.0, 98_765.0];
    all.extend([mode(1), mode(3), 1.0001 * mode(3), 0.97 * mode(20), 0.989 * mode(20), mode(last), 0.98 * mode(last)]);
    all
}

#[test]
fn a_stream_of_sines_is_what_their_quadrature_gives() {
    let (step, count) = (1e-4, 200);
    let spring = s_t(52.0);
    for mount in mounts() {
        let held = moved(&spring, &mount, [EndInput::Held, EndInput::Held], Start::Rest);
        for hertz in frequencies(&held) {
            // A force of 1 N at an end without a position, or a tenth of a millimetre.
            let second = if mount.far_end() == FarEnd::Position { 1e-4 } else { 1.0 };
            for inputs in [
                [EndInput::harmonic(1e-4, hertz, 0.7), EndInput::Held],
                [EndInput::harmonic(-2e-5, 33.0, 0.1), EndInput::harmonic(second, hertz, 2.0)],
            ] {
                let motion = moved(&spring, &mount, inputs, MOVING);
                assert!(motion.march_and_sines(step).1.is_some());
                let (ours, times) = (by_stream(&motion, step, count), times(0.0, step, count));
                // The angle of a sine has a last digit too.
                let allowed = tolerance(&motion, 0.02).max(4.0 * f64::EPSILON * 0.02 * TAU * hertz);
                let off_closed = off(&ours, &motion.end_forces(&times).unwrap());
                assert!(off_closed < allowed, "{hertz} Hz: {off_closed:e} of {allowed:e}: {mount:?}");
                // Quadrature shares no formula with either. It adds up a Ω² and may be off by what a quarter of the step changes; and the last
                // digit of the line's speed, which start and sine take from each other, is some of the slowest modes' whichever way is gone.
                let finer = by_march(&motion, &self::times(0.0, 0.25 * step, 4 * count)).every(4);
                let (off_quadrature, own) = (off(&ours, &finer), off(&by_march(&motion, &times), &finer));
                let speed = TAU * hertz * f64::max(1e-4, if second < 1.0 { 0.0 } else { 1.0 / spring.stiffness() });
                let digit = f64::EPSILON * motion.force_scale() * speed / motion.modes.frequencies()[0];
                let allowed = allowed.max(4.0 * own).max(16.0 * digit);
                assert!(off_quadrature < allowed, "{hertz} Hz: {off_quadrature:e} of {allowed:e}: {mount:?}");
            }
        }
    }
}

#[test]
fn sines_beside_any_other_input_are_what_their_quadrature_gives() {
    let (step, count) = (1e-4, 1500);
    let spring = s_t(52.0);
    for other in [
        EndInput::Chirp { amplitude: 1e-4, from: 5.0, to: 200.0, duration: 0.061, phase: 0.4 },
        EndInput::Step { height: 5e-4, at: 0.012_345 },
        EndInput::Ramp { height: 5e-4, from: 0.01, duration: 0.018_5 },
        EndInput::HalfSine { height: 5e-4, from: 0.05, duration: 0.02 },
        recording(0.0, 1.7e-4, 600),
    ] {
        for mount in mounts() {
            let motion = moved(&spring, &mount, [EndInput::harmonic(1e-4, 60.0, 0.7), other.clone()], MOVING);
            for motion in [motion.truncated(7).unwrap(), motion] {
                let (ours, theirs) = (by_stream(&motion, step, count), by_march(&motion, &times(0.0, step, count)));
                let (off, allowed) = (off(&ours, &theirs), tolerance(&motion, 0.15));
                assert!(off < allowed, "{other:?}: {off:e} of {allowed:e}: {mount:?}");
            }
        }
    }
}

#[test]
fn only_sines_that_go_on_turn_with_the_steps() {
    let spring = s_t(52.0);
    let sine = || EndInput::harmonic(1e-4, 60.0, 0.7);
    let turns = |first: EndInput, damping: Damping| {
        let mount = Mount::new(FarEnd::Position, damping).unwrap();
        moved(&spring, &mount, [first, EndInput::Held], Start::Rest).march_and_sines(1e-4).1.is_some()
    };
    assert!(turns(sine(), Damping::None) && turns(sine(), Damping::Modal(0.99)) && turns(sine(), Damping::Modal(3.0)));
    // These end, or have no phase that turns evenly; and a critical mode has no closed answer.
    assert!(!turns(EndInput::HalfSine { height: 1e-4, from: 0.0, duration: 0.1 }, Damping::None));
    let chirp = EndInput::Chirp { amplitude: 1e-4, from: 60.0, to: 60.0, duration: 0.1, phase: 0.0 };
    assert!(!turns(chirp, Damping::None) && !turns(EndInput::Held, Damping::None));
    assert!(!turns(EndInput::Harmonics(Vec::new()), Damping::None) && !turns(sine(), Damping::Modal(1.0)));
    let zero = Excitation::new(0.23, EndInput::harmonic(1e-4, 0.0, 0.7), EndInput::Held, Start::Rest);
    assert_eq!(zero.unwrap_err().to_string(), "frequency must be above zero and finite, got 0 Hz");
}

#[test]
fn a_sine_on_a_mode_grows_as_its_secular_answer_says() {
    // One mass between two half springs: ω² = 4k/m, c = 1/2 at rest on the line, and q̈ + ω² q = a ω² sin(ωt)/2.
    let spring = s_t(1.0);
    let natural = 2.0 * (spring.stiffness() / spring.mass()).sqrt();
    let (step, count, a) = (1e-3, 1_000_001, 1e-6);
    let motion =
        moved(&spring, &Mount::default(), [EndInput::harmonic(a, natural / TAU, 0.0), EndInput::Held], Start::Rest);
    let stream = motion.stream(step).unwrap();
    let mut worst = 0.0_f64;
    for sample in stream.step_by(9973).take(count / 9973) {
        let angle = natural * sample.time;
        // At rest the mass stands still while the line's middle sets out at aω/2.
        let q = 0.25 * a * (angle.sin() - angle * angle.cos()) - 0.5 * a * angle.sin();
        let u1 = a * angle.sin();
        let force = spring.static_force(0.23) - spring.stiffness() * u1 + 2.0 * spring.stiffness() * q;
        worst = worst.max((sample.input - force).abs() / (0.5 * spring.stiffness() * a * angle.max(1.0)));
    }
    // 2e5 rad in doubles: 3e-11 in the angle of either side, and what a step's rounding adds up to.
    assert!(worst < 1e-10, "{worst:e}");
}

#[test]
fn a_steady_sine_is_steady_after_a_million_steps() {
    let spring = s_t(52.0);
    let (step, count) = (1e-4, 1_000_001);
    for (hertz, damping) in [(20.0, Damping::None), (1200.0, Damping::None), (17.2, Damping::Modal(0.005))] {
        let mount = Mount::new(FarEnd::Position, damping).unwrap();
        let inputs = [EndInput::harmonic(1e-4, hertz, 0.7), EndInput::Held];
        let motion = moved(&spring, &mount, inputs, Start::Steady);
        let samples: Vec<_> = motion.stream(step).unwrap().step_by(99_991).take(11).collect();
        assert!(count > 10 * 99_991);
        let peak = samples.iter().fold(0.0_f64, |peak, one| peak.max((one.input - spring.static_force(0.23)).abs()));
        for sample in samples {
            let alone = motion.end_forces(&[sample.time]).unwrap();
            for (ours, alone) in [(sample.input, alone.input[0]), (sample.output, alone.output[0])] {
                // Of 7.5e5 rad the last digit is 1e-10, and what rings freely beside a sine is turned by a rounding of ωh at each step; the
                // preload of 96 N brings some 1e-14 N.
                let allowed = f64::max(2e-12, 8.0 * f64::EPSILON * TAU * hertz * sample.time);
                assert!(
                    (ours - alone).abs() < allowed * peak.max(1.0),
                    "{hertz} Hz at {} s: {:e}",
                    sample.time,
                    ours - alone
                );
            }
        }
    }
}
