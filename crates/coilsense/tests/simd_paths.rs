//! The vector paths give one answer: to 1e-12 of the peak across paths, byte for byte on one.
//!
//! The path is chosen once per process, so this test runs itself again with `COILSENSE_SIMD` set. That each path is *right* is the
//! other tests' business: the test command runs them once for each path.

mod paper_springs;

use std::process::Command;

use coilsense::excitation::Sampled;
use coilsense::inductance::{MaxwellSum, SelfDistance, mutual_inductances};
use coilsense::signals::sampled_window;
use coilsense::simd::{SimdPath, VARIABLE};
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, Start};
use paper_springs::{s_t, s_t_with};

/// Set in the process that only prints.
const PRINT: &str = "COILSENSE_TEST_PRINTS_ITS_VALUES";

/// Series that the paths must agree on, each judged by its own peak.
fn probe() -> Vec<Vec<f64>> {
    let mut series = inductances();
    let spring = s_t();
    let times = sampled_window(10_000.0, 0.0, 1.0).unwrap();
    let knots: Vec<f64> = times.iter().copied().step_by(3).collect();
    let recorded = knots.iter().map(|t| 1e-3 * (13.0 * t).sin() * (171.0 * t).cos()).collect();
    let inputs = [
        EndInput::Held,
        EndInput::harmonic(68e-6, spring.surge_frequency(), 0.3),
        EndInput::Step { height: 1e-3, at: 0.1 },
        EndInput::Sampled(Sampled::new(knots, recorded).unwrap()),
    ];
    let mounts = [(FarEnd::Position, Damping::None), (FarEnd::Mass(0.1), Damping::Modal(0.01))];
    for (far_end, damping) in mounts {
        let mount = Mount::new(far_end, damping).unwrap();
        for input in &inputs {
            let velocity = 0.25;
            let start = Start::Moving { velocity, profile: coilsense::VelocityProfile::Uniform };
            let excitation = Excitation::new(0.23, input.clone(), EndInput::Held, start).unwrap();
            let forces = Motion::mounted(&spring, &mount, &excitation).unwrap().end_forces(&times).unwrap();
            series.extend([forces.input, forces.output]);
        }
    }
    series
}

/// Kernel, series, gradient, Hessian, matrix and second-order form.
fn inductances() -> Vec<Vec<f64>> {
    let distances: Vec<f64> = (0..100).map(|index| 1e-7 * 1.2_f64.powi(index)).collect();
    let mut values = vec![0.0; distances.len()];
    mutual_inductances(0.008, &distances, &mut values).unwrap();
    // Each distance by itself: far rings count as much as near ones.
    let mut series: Vec<Vec<f64>> = values.into_iter().map(|value| vec![value]).collect();
    for windings in [52.0, 10.4] {
        let spring = Spring::new(s_t_with(|parameters| parameters.windings = windings)).unwrap();
        let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
        let motion = Motion::new(&spring, &Excitation::impact(0.23, 0.25).unwrap()).unwrap();
        let windings = motion.windings(&[0.0, 0.01, 0.02, 0.5]).unwrap();
        let near = coil.series_within(&windings, 1e-3).unwrap();
        series.extend([
            coil.series(&windings),
            near.samples.iter().map(|sample| sample.inductance).collect(),
            coil.gradient(windings.ends(1), windings.row(1)).unwrap(),
            coil.hessian(windings.ends(1), windings.row(1)).unwrap(),
            coil.matrix(windings.ends(1), windings.row(1)).unwrap(),
        ]);
    }
    series
}

/// The probe's values in a process of their own.
fn values_on(path: SimdPath) -> Vec<Vec<u64>> {
    let output = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "paths_agree_and_repeat_themselves", "--nocapture"])
        .env(VARIABLE, path.name())
        .env(PRINT, "1")
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    let lines = text.lines().filter_map(|line| line.strip_prefix("bits:"));
    lines.map(|line| line.split(',').map(|bits| bits.parse().unwrap()).collect()).collect()
}

#[test]
fn paths_agree_and_repeat_themselves() {
    if std::env::var_os(PRINT).is_some() {
        println!();
        for series in probe() {
            let bits: Vec<String> = series.iter().map(|value| value.to_bits().to_string()).collect();
            println!("bits:{}", bits.join(","));
        }
        return;
    }
    let scalar = values_on(SimdPath::Scalar);
    assert_eq!(scalar.len(), 126, "the probe printed all it has");
    for path in SimdPath::ALL.into_iter().filter(|path| path.is_available()) {
        let values = values_on(path);
        assert_eq!(values, values_on(path), "{} repeats itself", path.name());
        for (index, (ours, expected)) in values.iter().zip(&scalar).enumerate() {
            let number = |bits: &u64| f64::from_bits(*bits);
            let peak = expected.iter().map(number).fold(0.0_f64, |peak, value| peak.max(value.abs()));
            for (ours, expected) in ours.iter().map(number).zip(expected.iter().map(number)) {
                assert!(
                    (ours - expected).abs() <= 1e-12 * peak,
                    "series {index} on {}: {ours:e} {expected:e}",
                    path.name()
                );
            }
        }
    }
}
