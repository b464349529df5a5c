//! Inertia, work and energy of the helix over time.
//!
//! Next door: its forces (`motion`).

use std::f64::consts::TAU;

use coilsense::{End, EndInput, Excitation, Mount, Start};

use crate::motion::{cases, first_axial, surge_of};

#[test]
fn energy_stays_once_the_ends_are_held() {
    for (name, case, length, ends) in cases() {
        let surge = surge_of(&case, length, ends);
        let period = 1.0 / first_axial(&surge);
        let push = EndInput::HalfSine { height: 1e-3, from: 0.1 * period, duration: 0.3 * period };
        let excitation = Excitation::new(length, push, EndInput::Held, Start::Rest).unwrap();
        let motion = surge.motion(&Mount::default(), &excitation).unwrap();
        let [rest, after] = [0.0, 0.41 * period].map(|time| motion.energy(time).unwrap());
        for share in [0.5, 1.0, 3.7, 20.0, 100.0] {
            // Of what the push gave: 1.5e-13, rounding of the whole with the strain of the mean length.
            let off = (motion.energy(share * period).unwrap() - after).abs() / (after - rest);
            assert!(off < 1e-11, "{name}: {off:e}");
        }
    }
}

#[test]
fn the_work_of_both_ends_is_the_change_of_energy() {
    for (name, case, length, ends) in cases() {
        let surge = surge_of(&case, length, ends);
        let f1 = first_axial(&surge);
        let inputs = [EndInput::harmonic(1e-3, 0.4 * f1, 0.2), EndInput::harmonic(7e-4, 0.71 * f1, 1.1)];
        let [first, second] = inputs.clone();
        let motion =
            surge.motion(&Mount::default(), &Excitation::new(length, first, second, Start::Massless).unwrap()).unwrap();
        let (until, steps) = (2.3 / f1, 8000);
        let step = until / f64::from(steps);
        let times: Vec<f64> = (0..=steps).map(|sample| f64::from(sample) * step).collect();
        let forces = motion.end_forces(&times).unwrap();
        // Simpson's rule; the fastest mode has 170 steps per turn.
        let work: f64 = times
            .iter()
            .enumerate()
            .map(|(at, time)| {
                let power =
                    forces.output[at] * inputs[1].velocity(*time) - forces.input[at] * inputs[0].velocity(*time);
                let weight = if at == 0 || at == times.len() - 1 { 1.0 } else { [2.0, 4.0][at % 2] };
                weight * power * step / 3.0
            })
            .sum();
        let change = motion.energy(until).unwrap() - motion.energy(0.0).unwrap();
        // Without what a spring without mass would store: that alone is up to forty times as much.
        let slow = |time: f64| {
            let force = motion.deflection_forces(&[time]).unwrap()[0];
            0.5 * force * force / surge.spring().stiffness()
        };
        let of_motion = change - (slow(until) - slow(0.0));
        let off = (work - change).abs() / of_motion.abs();
        // 2.1e-12.
        assert!(off < 1e-10, "{name}: {work} {change}");
    }
}

#[test]
fn windings_share_the_inertia_that_the_ends_feel() {
    // What carries a mode along when both ends move alike is its mean axial motion, whatever found either.
    for (name, case, length, ends) in cases() {
        let surge = surge_of(&case, length, ends);
        let n = surge.model().masses();
        let each = surge.helix().rod().mass() / n as f64;
        for (index, mode) in surge.modes().iter().enumerate() {
            let rigid: f64 = [End::One, End::Two].map(|end| mode.reaction(end).force()[2].re).iter().sum::<f64>()
                / (TAU * mode.frequency()).powi(2);
            let shares: f64 = (1..=n).map(|winding| each * surge.model().shape(index + 1, winding).unwrap()).sum();
            // Of √m, the most that a mode can carry: 4e-7 of S_T, 3e-5 of the valve spring: means over
            // points of the wire, whose sideways modes swing along the axis within each winding.
            let mass = surge.helix().rod().mass();
            let off = (rigid - shares).abs() / mass.sqrt();
            assert!(off < 1e-4, "{name}, {index}: {off:e}");
            // Modal mass 1 kg, but for the share of the wire's own rotation: (d/4R)², up to 3.7 % where short windings bend.
            let squares: Vec<f64> = mode.shape().iter().map(|w| w.iter().map(|value| value * value).sum()).collect();
            let pieces = squares.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
            let modal = mass * mode.largest().powi(2) * pieces.sum::<f64>() / (squares.len() - 1) as f64;
            assert!(modal < 1.0 && modal > 0.95, "{name}, {index}: {modal}");
        }
    }
}
