//! Instruments step by step (`coilsense_rt::Readout`) beside their series (`sensors::Readout`), which share no code but the low-pass's poles.

use coilsense::sensors::{Readout, ReadoutParameters};
use coilsense_rt::Real;

const STEP: f64 = 1e-3;
const SAMPLES: usize = 5000;

/// Rough, slow and kinked; begins away from zero.
fn quantity() -> Vec<f64> {
    let rough = |k: usize| ((k as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
    let of = |k: usize| {
        let t = k as f64;
        5.0 + 3.0 * (0.01 * t).sin() + if k > 1000 { 2.0 } else { 0.0 } + if k > 2000 { rough(k) } else { 0.0 }
    };
    (0..SAMPLES).map(of).collect()
}

fn by_steps<T: Real + Into<f64>, const POLES: usize>(readout: &Readout, step: f64, x: &[f64]) -> Vec<f64> {
    let steps = readout.steps(step, 3).unwrap();
    assert!(steps.slots() <= 128);
    let instrument = steps.settings::<T, POLES>().unwrap();
    let mut state = instrument.settled::<128>(T::nearest(x[0]));
    x.iter().map(|value| instrument.step(&mut state, T::nearest(*value)).into()).collect()
}

fn agree<const POLES: usize>(parameters: &ReadoutParameters, step: f64) {
    let readout = Readout::new(parameters.clone()).unwrap();
    let x = quantity();
    let times: Vec<f64> = (0..x.len()).map(|k| k as f64 * step).collect();
    let theirs = readout.ideal_series(&times, &x).unwrap();
    let largest =
        |ours: &[f64]| ours.iter().zip(&theirs).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs())) / 10.0;
    let (double, single) = (by_steps::<f64, POLES>(&readout, step, &x), by_steps::<f32, POLES>(&readout, step, &x));
    assert!(largest(&double) < 1e-12, "{parameters:?}, {step} s: {:e}", largest(&double));
    // A running sum, a delay's fraction and a low-pass of order 8 each lose some of seven digits.
    assert!(largest(&single) < 1e-5, "{parameters:?}, {step} s: {:e} in single precision", largest(&single));
}

#[test]
fn steps_are_the_series() {
    let plain = ReadoutParameters::default();
    agree::<0>(&plain, STEP);
    for step in [STEP, 0.77e-3] {
        for delay in [0.0, 1e-4, 1e-3, 2.345e-3, 0.05] {
            for averaging in [None, Some(4e-4), Some(1e-3), Some(5.5e-3), Some(0.06)] {
                for sample_rate in [None, Some(40.0), Some(333.0), Some(1000.0), Some(2500.0)] {
                    agree::<0>(&ReadoutParameters { delay, averaging, sample_rate, ..plain.clone() }, step);
                    let low = ReadoutParameters {
                        bandwidth: Some(60.0),
                        order: 3,
                        delay,
                        averaging,
                        sample_rate,
                        ..plain.clone()
                    };
                    agree::<2>(&low, step);
                }
            }
        }
    }
    for bandwidth in [0.5, 30.0, 400.0, 1e5] {
        let of = |order| ReadoutParameters { bandwidth: Some(bandwidth), order, ..plain.clone() };
        agree::<1>(&of(1), STEP);
        agree::<1>(&of(2), STEP);
        agree::<2>(&of(4), STEP);
        agree::<3>(&of(5), STEP);
        agree::<4>(&of(8), STEP);
    }
}

#[test]
fn readings_are_in_steps_and_halves_go_to_the_even_one() {
    for step in [0.5, 1e-3, 0.07, 1e-17] {
        let parameters = ReadoutParameters { resolution: Some(step), ..ReadoutParameters::default() };
        let readout = Readout::new(parameters).unwrap();
        let x: Vec<f64> = (-40..40).map(|k| 0.25 * f64::from(k)).collect();
        let times: Vec<f64> = (0..x.len()).map(|k| k as f64).collect();
        let theirs = readout.series(&times, &x, 0).unwrap();
        let ours = by_steps::<f64, 0>(&readout, 1.0, &x);
        for (ours, theirs) in ours.iter().zip(&theirs) {
            assert!((ours - theirs).abs() < 1e-14, "{step}: {ours} {theirs}");
        }
    }
}

#[test]
fn noise_is_one_number_a_sample_and_the_same_for_the_same_seed() {
    let parameters = ReadoutParameters { noise: 0.3, sample_rate: Some(100.0), ..ReadoutParameters::default() };
    let readout = Readout::new(parameters).unwrap();
    let read = by_steps::<f64, 0>(&readout, STEP, &vec![2.0; 50_000]);
    assert_eq!(read, by_steps::<f64, 0>(&readout, STEP, &vec![2.0; 50_000]));
    let held: Vec<f64> = read.chunks(10).map(|ten| ten[0]).collect();
    assert!(read.chunks(10).all(|ten| ten.iter().all(|value| *value == ten[0])));
    let mean = held.iter().sum::<f64>() / held.len() as f64;
    let rms = (held.iter().map(|value| (value - 2.0).powi(2)).sum::<f64>() / held.len() as f64).sqrt();
    // Four standard errors of 5000 numbers.
    assert!((mean - 2.0).abs() < 4.0 * 0.3 / 5000_f64.sqrt(), "{mean}");
    assert!((rms / 0.3 - 1.0).abs() < 4.0 / 10_000_f64.sqrt(), "{rms}");
}

#[test]
fn steps_that_cannot_be_are_refused() {
    let readout = |delay| Readout::new(ReadoutParameters { delay, ..ReadoutParameters::default() }).unwrap();
    for step in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        assert!(readout(0.0).steps(step, 0).unwrap_err().to_string().starts_with("step must be above zero"));
    }
    let refused = readout(10.0).steps(1e-6, 0).unwrap_err().to_string();
    assert_eq!(refused, "step must be at least 1.000e-5 s, a millionth of what it looks back, got 0.000001 s");
    let two = Readout::new(ReadoutParameters { bandwidth: Some(10.0), order: 4, ..ReadoutParameters::default() });
    assert!(two.unwrap().steps(1e-3, 0).unwrap().settings::<f64, 1>().is_err());
}
