//! Records of springs whose every number is known: what a bench would have recorded, from the library's own exact motion.

use std::f64::consts::TAU;

use coilsense::excitation::{EndInput, Start};
use coilsense::{Channel, Damping, Excitation, FarEnd, Motion, Mount, Signals, Spring, VelocityProfile};
use rand::{Rng, RngExt};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

/// Samples per second of every sensor.
pub const RATE: f64 = 2500.0;

/// What is known of a record.
pub struct Truth {
    pub frequency: f64,
    pub signals: Signals,
}

/// Gains of the sensors: force at end 1, at end 2, position.
pub type Gains = [f64; 3];

/// A minute at 2.5 kHz: a slow sweep of the length, then hits at random moments, noise on every sensor.
pub fn hit(spring: &Spring, ratio: f64, seed: u64, gains: Gains) -> Truth {
    let mut random = Pcg64::seed_from_u64(seed);
    let times: Vec<f64> = (0..150_000).map(|n| n as f64 / RATE).collect();
    let mount = Mount::new(FarEnd::Position, Damping::Modal(ratio)).unwrap();
    let length = spring.mid_length();
    let (low, high) = spring.operating_range();
    let sweep = EndInput::HalfSine { height: 0.4 * (high - low), from: 2.0, duration: random.random_range(12.0..18.0) };
    let slow = Excitation::harmonic(length, coilsense::End::Two, sweep, Start::Massless).unwrap();
    let base = Motion::mounted(spring, &mount, &slow).unwrap().signals(&times).unwrap();
    let mut forces = [Channel::InputForce, Channel::OutputForce].map(|channel| base.channel(channel).unwrap().to_vec());
    let hits = random.random_range(5..10);
    for _ in 0..hits {
        let first = (random.random_range(21.0..57.0) * RATE) as usize;
        let velocity = random.random_range(0.08..0.3) * if random.random::<bool>() { 1.0 } else { -1.0 };
        let profile = if random.random::<bool>() { VelocityProfile::Uniform } else { VelocityProfile::Linear };
        let start = Start::Moving { velocity, profile };
        let hit = Excitation::new(length, EndInput::Held, EndInput::Held, start).unwrap();
        let rest = &times[..times.len() - first];
        let motion = Motion::mounted(spring, &mount, &hit).unwrap().end_forces(rest).unwrap();
        let still = spring.static_force(length);
        for (force, more) in forces.iter_mut().zip([motion.input, motion.output]) {
            force[first..].iter_mut().zip(more).for_each(|(sum, value)| *sum += value - still);
        }
    }
    let nominal = spring.nominal_force();
    let mut signals = Signals::new(times).unwrap();
    let positions = [Channel::U1, Channel::U2].map(|channel| base.channel(channel).unwrap().to_vec());
    let [input, output] = forces;
    let mut add = |channel, values: Vec<f64>, gain: f64, noise: f64| {
        signals.insert(channel, noisy(values, gain, noise, &mut random)).unwrap();
    };
    add(Channel::InputForce, input, gains[0], 5e-4 * nominal);
    add(Channel::OutputForce, output, gains[1], 5e-4 * nominal);
    let [u1, u2] = positions;
    add(Channel::U1, u1, gains[2], 5e-6);
    add(Channel::U2, u2, gains[2], 5e-6);
    let frequency = coilsense::modes::ChainModes::of(spring).frequencies()[0] / TAU;
    Truth { frequency, signals }
}

/// A reading: gain and white noise.
pub fn noisy(values: Vec<f64>, gain: f64, noise: f64, random: &mut Pcg64) -> Vec<f64> {
    let mut reading = |value: f64| {
        let normal: f64 = StandardNormal.sample(random);
        value * (1.0 + gain) + noise * normal
    };
    values.into_iter().map(&mut reading).collect()
}

/// Damping ratios from 0.001 to 0.05, alike in their logarithm.
pub fn any_ratio(random: &mut impl Rng) -> f64 {
    0.001 * 50.0_f64.powf(random.random::<f64>())
}

/// A stiff short spring of few windings, unlike the paper's two.
pub fn own() -> Spring {
    Spring::new(coilsense::SpringParameters {
        rest_length: 0.06,
        windings: 12.5,
        coil_radius: 0.011,
        wire_radius: 0.0012,
        mass: 0.0305,
        stiffness: 2400.0,
        min_length: 0.065,
        max_length: 0.095,
        nominal_force: None,
        inductance_windings: None,
        sections: None,
    })
    .expect("a spring that can be")
}

/// Forty seconds of S_T, ζ 0.004, on any mount at any rate: both ends moved slowly, then five bumps of end 1, a little noise.
pub fn bumped(far_end: FarEnd, rate: f64) -> Signals {
    let spring = crate::paper_springs::s_t();
    let mut random = Pcg64::seed_from_u64(5);
    let times: Vec<f64> = (0..(40.0 * rate) as usize).map(|n| n as f64 / rate).collect();
    let mount = Mount::new(far_end, Damping::Modal(0.004)).unwrap();
    let slow = |height: f64| EndInput::HalfSine { height, from: 1.0, duration: 10.0 };
    let signals = |first: EndInput, second: EndInput, times: &[f64]| {
        let excitation = Excitation::new(0.23, first, second, Start::Massless).unwrap();
        Motion::mounted(&spring, &mount, &excitation).unwrap().signals(times).unwrap()
    };
    // Metres at a held end, newtons at any other.
    let base = signals(slow(-0.02), slow(if far_end == FarEnd::Position { 0.01 } else { 3.0 }), &times);
    let still = signals(EndInput::Held, EndInput::Held, &times);
    let bump = signals(EndInput::HalfSine { height: 2e-4, from: 0.0, duration: 0.003 }, EndInput::Held, &times);
    let starts: Vec<usize> =
        (0..5).map(|hit| ((14.0 + 5.0 * f64::from(hit) + random.random::<f64>()) * rate) as usize).collect();
    let mut sum = Signals::new(times).unwrap();
    let noises = [(Channel::U1, 5e-6), (Channel::U2, 5e-6), (Channel::InputForce, 0.02), (Channel::OutputForce, 0.02)];
    for (channel, noise) in noises {
        let of = |signals: &Signals| signals.channel(channel).unwrap().to_vec();
        let (mut values, still, bump) = (of(&base), of(&still), of(&bump));
        for &start in &starts {
            let shifted = bump.iter().zip(&still).map(|(moved, still)| moved - still);
            values[start..].iter_mut().zip(shifted).for_each(|(value, more)| *value += more);
        }
        sum.insert(channel, noisy(values, 0.0, noise, &mut random)).unwrap();
    }
    sum
}
