//! Every kind of input, damping and far end, for tests that must hold for all of them.

use coilsense::excitation::{Harmonic, Sampled};
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, Start, VelocityProfile};

use crate::paper_springs::{s_a, s_t};

/// A smooth recording of about a millimetre.
pub fn recording(samples: usize, step: f64) -> EndInput {
    let times: Vec<f64> = (0..samples).map(|k| k as f64 * step).collect();
    let value = |t: &f64| 1e-3 * (13.0 * t).sin() * (171.0 * t).cos() + 2e-4 * (900.0 * t).sin();
    let values = times.iter().map(value).collect();
    EndInput::Sampled(Sampled::new(times, values).unwrap())
}

/// Every kind of input, small enough for either end and as metres.
fn inputs(spring: &Spring) -> Vec<EndInput> {
    let near = coilsense::modes::ChainModes::of(spring).frequencies()[2] / std::f64::consts::TAU;
    let harmonic = |amplitude, frequency, phase| Harmonic { amplitude, frequency, phase };
    vec![
        EndInput::Held,
        EndInput::harmonic(1e-4, near, 0.7),
        EndInput::harmonic(1e-4, 1.0001 * near, 0.7),
        EndInput::Harmonics(vec![harmonic(1e-4, 3.0, 0.1), harmonic(-2e-5, 77.0, 1.0), harmonic(1e-5, 700.0, 2.0)]),
        EndInput::Chirp { amplitude: 1e-4, from: 5.0, to: 200.0, duration: 0.61, phase: 0.4 },
        EndInput::Step { height: 5e-4, at: 0.123_45 },
        EndInput::Ramp { height: 5e-4, from: 0.1, duration: 0.018_5 },
        EndInput::HalfSine { height: 5e-4, from: 0.05, duration: 0.02 },
        recording(40, 0.013),
        recording(3000, 1.7e-4),
    ]
}

/// From none to modes that only creep.
pub fn dampings() -> [Damping; 6] {
    [
        Damping::None,
        Damping::Modal(0.005),
        Damping::Modal(1.0),
        Damping::MassProportional { rate: 3.0 },
        // The highest modes are overdamped.
        Damping::StiffnessProportional { time: 3e-4 },
        Damping::StiffnessProportional { time: 1e-6 },
    ]
}

/// What the input is as a force at end 2: the same shape, in newtons.
fn as_force(input: &EndInput, spring: &Spring) -> EndInput {
    let k = spring.stiffness();
    match input.clone() {
        EndInput::Harmonics(mut sines) => {
            sines.iter_mut().for_each(|sine| sine.amplitude *= k);
            EndInput::Harmonics(sines)
        }
        EndInput::Chirp { amplitude, from, to, duration, phase } => {
            EndInput::Chirp { amplitude: amplitude * k, from, to, duration, phase }
        }
        EndInput::Step { height, at } => EndInput::Step { height: height * k, at },
        EndInput::Ramp { height, from, duration } => EndInput::Ramp { height: height * k, from, duration },
        EndInput::HalfSine { height, from, duration } => EndInput::HalfSine { height: height * k, from, duration },
        other => other,
    }
}

/// Every input, damping and far end at least once, with starts that move.
pub fn motions() -> Vec<Motion> {
    let mut motions = Vec::new();
    for spring in [s_t(), s_a()] {
        let inputs = inputs(&spring);
        for (i, first) in inputs.iter().enumerate() {
            for (d, damping) in dampings().into_iter().enumerate() {
                let second = &inputs[(i + d) % inputs.len()];
                let (far_end, second) = match (i + d) % 3 {
                    0 => (FarEnd::Position, second.clone()),
                    1 => (FarEnd::Force, as_force(second, &spring)),
                    _ => (FarEnd::Mass(0.3), as_force(second, &spring)),
                };
                let start = match d % 3 {
                    0 => Start::Moving { velocity: 0.1, profile: VelocityProfile::Linear },
                    1 => Start::Massless,
                    _ => Start::Rest,
                };
                let excitation = Excitation::new(spring.mid_length(), first.clone(), second, start).unwrap();
                let mount = Mount::new(far_end, damping).unwrap();
                motions.push(Motion::mounted(&spring, &mount, &excitation).unwrap());
            }
        }
    }
    motions
}

/// Largest difference over the peak of what oscillates.
#[allow(dead_code, reason = "each test file uses what it needs")]
pub fn off(ours: &[f64], theirs: &[f64]) -> f64 {
    let mean = theirs.iter().sum::<f64>() / theirs.len() as f64;
    let peak = theirs.iter().fold(0.0_f64, |peak, value| peak.max((value - mean).abs()));
    let difference = ours.iter().zip(theirs).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
    // Forces of about 100 N carry 1e-14 N of rounding themselves.
    difference / peak.max(1.0)
}
