//! Each element of a readout against its closed form, and the chain over time against the chain over frequency.

mod paper_springs;

use std::f64::consts::TAU;

use coilsense::measures::{Spectrum, alias_of};
use coilsense::sensors::{MAX_ORDER, Readout, ReadoutParameters, TwoEncoder, deflection_force};
use num_complex::Complex64;
use paper_springs::s_t;
use proptest::prelude::*;

/// An instrument with one or a few settings away from the default.
fn readout(change: impl FnOnce(&mut ReadoutParameters)) -> Readout {
    let mut parameters = ReadoutParameters::default();
    change(&mut parameters);
    Readout::new(parameters).unwrap()
}

/// Times 0, 1/rate … of so many samples.
fn uniform(rate: f64, samples: usize) -> Vec<f64> {
    (0..samples).map(|n| n as f64 / rate).collect()
}

/// Times that come in uneven steps of 0.02 to 1.98 times 1/rate.
fn uneven(rate: f64, samples: usize) -> Vec<f64> {
    (0..samples).map(|n| (n as f64 + 0.49 * (7.0 * n as f64).sin()) / rate).collect()
}

/// Complex gain of `meter` for a sine at `frequency`, from a run of 60 periods sampled at `rate`, fitted over the last 20.
fn simulated(meter: &Readout, frequency: f64, rate: f64) -> Complex64 {
    let times = uniform(rate, (60.0 * rate / frequency).round() as usize);
    let values: Vec<f64> = times.iter().map(|t| (TAU * frequency * t).sin()).collect();
    let reading = meter.ideal_series(&times, &values).unwrap();
    let from = times.len() - (20.0 * rate / frequency).round() as usize;
    let turn = |index: usize| Complex64::cis(-TAU * frequency * times[index]);
    let sum: Complex64 = (from..times.len()).map(|index| reading[index] * turn(index)).sum();
    // x = sin ωt gives Σ x e^(−iωt) = −i n/2.
    sum * Complex64::new(0.0, 2.0) / (times.len() - from) as f64
}

#[test]
fn the_low_pass_has_butterworth_s_gain() {
    for order in 1..=MAX_ORDER {
        let meter = readout(|p| (p.bandwidth, p.order) = (Some(100.0), order));
        for frequency in [1e-3, 1.0, 50.0, 99.0, 100.0, 101.0, 300.0, 1e4] {
            let gain = meter.response(frequency).norm();
            let closed = 1.0 / (1.0 + (frequency / 100.0_f64).powi(2 * order as i32)).sqrt();
            assert!((gain / closed - 1.0).abs() < 1e-14, "order {order} at {frequency} Hz: {gain}");
            // The lag, unwrapped, is the phase of the response.
            let turned = Complex64::cis(-TAU * frequency * meter.lag(frequency)) * gain;
            assert!((turned - meter.response(frequency)).norm() < 1e-14);
        }
        assert!((meter.bandwidth_3db() / 100.0 - 1.0).abs() < 1e-14);
        assert!((meter.lag(1e-6) / meter.lag(0.0) - 1.0).abs() < 1e-13);
    }
}

#[test]
fn simulated_sines_follow_the_low_pass_to_second_order() {
    for order in 1..=MAX_ORDER {
        let meter = readout(|p| (p.bandwidth, p.order) = (Some(100.0), order));
        for frequency in [20.0, 80.0, 100.0, 150.0] {
            let error = |per_period: f64| {
                let found = simulated(&meter, frequency, per_period * frequency);
                (found / meter.response(frequency) - 1.0).norm()
            };
            let (coarse, fine) = (error(100.0), error(200.0));
            // Straight lines through a sine have its amplitude times sinc²: 1 − (ωh)²/12, here 3.3e-4.
            assert!((coarse / 3.29e-4 - 1.0).abs() < 0.02, "order {order} at {frequency} Hz: {coarse}");
            assert!((coarse / fine - 4.0).abs() < 0.1, "order {order} at {frequency} Hz: {coarse} {fine}");
        }
    }
}

#[test]
fn a_ramp_comes_through_a_low_pass_of_first_and_second_order_exactly() {
    let cutoff = TAU * 30.0;
    let first = |t: f64| t - (1.0 - (-cutoff * t).exp()) / cutoff;
    let second = |t: f64| {
        let b = cutoff / 2.0_f64.sqrt();
        t - 2.0_f64.sqrt() / cutoff + (-b * t).exp() * 2.0_f64.sqrt() / cutoff * (b * t).cos()
    };
    for times in [uniform(1000.0, 400), uneven(1000.0, 400), uniform(20.0, 20)] {
        let ramp: Vec<f64> = times.iter().map(|t| t - times[0]).collect();
        let peak = ramp[ramp.len() - 1];
        for (order, closed) in [(1, &first as &dyn Fn(f64) -> f64), (2, &second)] {
            let meter = readout(|p| (p.bandwidth, p.order) = (Some(30.0), order));
            let reading = meter.ideal_series(&times, &ramp).unwrap();
            for (t, found) in ramp.iter().zip(reading) {
                assert!((found - closed(*t)).abs() < 1e-13 * peak, "order {order} at {t} s: {found}");
            }
        }
    }
}

#[test]
fn straight_lines_cut_up_further_give_the_same_reading() {
    let coarse = uneven(100.0, 60);
    let bent: Vec<f64> = (0..60).map(|n| (1.3 * f64::from(n)).sin()).collect();
    // Each interval in five uneven pieces.
    let cuts = [0.0, 0.03, 0.3, 0.31, 0.8];
    let cut = |series: &[f64]| -> Vec<f64> {
        series.windows(2).flat_map(|pair| cuts.map(|share| pair[0] + share * (pair[1] - pair[0]))).collect()
    };
    let (fine, values) = (cut(&coarse), cut(&bent));
    for order in 1..=MAX_ORDER {
        for meter in [
            readout(|p| (p.bandwidth, p.order) = (Some(30.0), order)),
            readout(|p| p.delay = 0.0123 * order as f64),
            readout(|p| p.averaging = Some(0.0123 * order as f64)),
        ] {
            let (few, many) =
                (meter.ideal_series(&coarse, &bent).unwrap(), meter.ideal_series(&fine, &values).unwrap());
            for (n, found) in many.iter().step_by(cuts.len()).enumerate() {
                // Rounding of cut values times the filter's largest share, below 1e2 for order 8.
                assert!((found - few[n]).abs() < 1e-13, "{meter:?} {n}: {found} {}", few[n]);
            }
        }
    }
}

#[test]
fn a_steady_quantity_reads_as_itself() {
    let times = uneven(100.0, 300);
    let meter = readout(|p| {
        (p.bandwidth, p.order, p.delay) = (Some(10.0), 8, 0.02);
        (p.averaging, p.sample_rate) = (Some(0.05), Some(77.0));
    });
    assert_eq!(meter.series(&times, &[0.1; 300], 1).unwrap(), [0.1; 300]);
}

#[test]
fn a_delay_is_exact() {
    let meter = readout(|p| p.delay = 0.25);
    let times = uniform(16.0, 100);
    let values: Vec<f64> = times.iter().map(|t| (3.0 * t).sin()).collect();
    let reading = meter.series(&times, &values, 1).unwrap();
    assert_eq!(reading[4..], values[..96]);
    assert_eq!(reading[..4], [0.0; 4]);
    assert_eq!(meter.lag(7.0), 0.25);
}

#[test]
fn a_window_averages_away_whole_numbers_of_periods() {
    let meter = readout(|p| p.averaging = Some(0.02));
    for harmonic in 1..=5 {
        let frequency = 50.0 * f64::from(harmonic);
        assert!(meter.response(frequency).norm() < 1e-15);
        let times = uniform(1e4, 3000);
        let values: Vec<f64> = times.iter().map(|t| 1.0 + (TAU * frequency * t + 0.3).sin()).collect();
        let reading = meter.ideal_series(&times, &values).unwrap();
        // Once the window is full; the trapezoidal rule over whole periods is exact.
        assert!(reading[200..].iter().all(|mean| (mean - 1.0).abs() < 1e-12), "{frequency} Hz");
    }
    // What straight lines hold, by hand: the mean of a triangle's flank.
    let half = readout(|p| p.averaging = Some(0.5));
    let reading = half.ideal_series(&[0.0, 1.0, 2.0], &[0.0, 2.0, 0.0]).unwrap();
    assert_eq!(reading, [0.0, 1.5, 0.5]);
}

#[test]
fn a_long_log_does_not_wear_the_mean_out() {
    let meter = readout(|p| p.averaging = Some(0.01));
    let times: Vec<f64> = uniform(1000.0, 200_000);
    let values: Vec<f64> = (0..200_000).map(|n| 1e-4 + f64::from(n % 7)).collect();
    let reading = meter.ideal_series(&times, &values).unwrap();
    for end in [100_000, 199_999] {
        let inner: f64 = values[end - 9..end].iter().sum();
        let mean = (inner + 0.5 * (values[end - 10] + values[end])) / 10.0;
        // The last digit of 200 s is 3e-14 s, 3e-12 of the window; the values range over 6.
        assert!((reading[end] - mean).abs() < 3e-12 * 6.0, "{}", reading[end] - mean);
    }
}

#[test]
fn samples_are_taken_at_their_times_and_held() {
    let meter = readout(|p| p.sample_rate = Some(10.0));
    let times = uniform(100.0, 200);
    let values: Vec<f64> = times.iter().map(|t| t * t).collect();
    let reading = meter.series(&times, &values, 1).unwrap();
    for (n, found) in reading.iter().enumerate() {
        let sample = (n / 10) as f64 / 10.0;
        assert!((found - sample * sample).abs() < 1e-14, "{n}");
    }
}

#[test]
fn sampling_folds_a_surge_line_to_its_alias() {
    let meter = readout(|p| p.sample_rate = Some(100.0));
    for frequency in [54.0, 162.0, 216.0] {
        let times = uniform(2000.0, 4000);
        let values: Vec<f64> = times.iter().map(|t| (TAU * frequency * t + 0.4).sin()).collect();
        let reading = meter.series(&times, &values, 1).unwrap();
        let shown: Vec<f64> = reading.iter().step_by(20).copied().collect();
        let spectrum = Spectrum::of(&uniform(100.0, 200), &shown).unwrap();
        let line = (alias_of(frequency, 100.0) / 0.5).round() as usize;
        assert!((spectrum.amplitudes()[line] - 1.0).abs() < 1e-10, "{frequency} Hz");
    }
}

#[test]
fn the_chain_over_time_is_the_chain_over_frequency() {
    let meter = readout(|p| {
        (p.bandwidth, p.order, p.delay) = (Some(80.0), 3, 1.234e-3);
        (p.averaging, p.sample_rate) = (Some(7e-3), Some(400.0));
    });
    for frequency in [10.0, 16.0, 25.0, 50.0] {
        let error = |rate: f64| (simulated(&meter, frequency, rate) / meter.response(frequency) - 1.0).norm();
        // The staircase is summed at its samples, which is off by half a spacing: first order, ωh/2 at most, beside (ωh)² of the rest.
        for rate in [8e3, 32e3, 128e3] {
            assert!(error(rate) < 0.6 * TAU * frequency / rate, "{frequency} Hz at {rate}: {}", error(rate));
        }
        let without = Readout::new(ReadoutParameters { sample_rate: None, ..meter.parameters().clone() }).unwrap();
        let error = |rate: f64| (simulated(&without, frequency, rate) / without.response(frequency) - 1.0).norm();
        let rate = 320.0 * frequency;
        assert!(error(rate) < (TAU * frequency / rate).powi(2), "{}", error(rate));
        assert!(error(2.0 * rate) < 0.3 * error(rate));
    }
    let edge = meter.bandwidth_3db();
    assert!((meter.response(edge).norm() * 2.0_f64.sqrt() - 1.0).abs() < 1e-13 && edge < 63.3);
    assert_eq!(readout(|p| p.delay = 1.0).bandwidth_3db(), f64::INFINITY);
}

#[test]
fn noise_is_normal_white_and_the_same_for_a_seed() {
    let (samples, rms) = (200_000, 0.3);
    let times = uniform(1000.0, samples);
    let noise = readout(|p| p.noise = rms).series(&times, &vec![0.0; samples], 42).unwrap();
    let count = samples as f64;
    let mean = noise.iter().sum::<f64>() / count;
    let variance = noise.iter().map(|v| v * v).sum::<f64>() / count;
    let fourth = noise.iter().map(|v| v.powi(4)).sum::<f64>() / count;
    // Three standard errors each: σ/√n, σ²√(2/n), σ⁴√(96/n).
    assert!(mean.abs() < 3.0 * rms / count.sqrt());
    assert!((variance / rms.powi(2) - 1.0).abs() < 3.0 * (2.0 / count).sqrt());
    assert!((fourth / rms.powi(4) - 3.0).abs() < 3.0 * (96.0 / count).sqrt());
    for apart in 1..=10 {
        let product: f64 = noise.iter().zip(&noise[apart..]).map(|(a, b)| a * b).sum();
        assert!((product / count / variance).abs() < 4.0 / count.sqrt(), "{apart}");
    }
    // Golden digits of PCG 64 and the ziggurat: another machine, or another release, has to give the same.
    for (found, golden) in noise.iter().zip(GOLDEN) {
        assert!((found - golden).abs() < 1e-14, "{found:.17} {golden}");
    }
}

#[test]
fn each_sample_has_noise_of_its_own_and_keeps_it_while_held() {
    let meter = readout(|p| (p.noise, p.sample_rate) = (1.0, Some(10.0)));
    let reading = meter.series(&uniform(100.0, 1000), &[0.0; 1000], 5).unwrap();
    assert!(reading.chunks(10).all(|held| held.iter().all(|value| *value == held[0])));
    assert!(reading.chunks(10).zip(reading.chunks(10).skip(1)).all(|(one, next)| one[0] != next[0]));
    let slow = meter.series(&uniform(10.0, 100), &[0.0; 100], 5).unwrap();
    assert!(slow.iter().zip(reading.chunks(10)).all(|(one, held)| *one == held[0]));
}

#[test]
fn rounding_has_the_variance_of_a_twelfth_and_is_odd() {
    let step = 0.01;
    let meter = readout(|p| p.resolution = Some(step));
    let times = uniform(1000.0, 100_000);
    let busy: Vec<f64> = times.iter().map(|t| (31.0 * t).sin() + 0.7 * (113.7 * t).cos()).collect();
    let reading = meter.series(&times, &busy, 1).unwrap();
    let error = |(read, value): (&f64, &f64)| (read - value).powi(2);
    let variance = reading.iter().zip(&busy).map(error).sum::<f64>() / 1e5;
    // 1e5 errors within ±q/2, of which some hundred are independent in each step crossed: 1 %.
    assert!((variance / (step * step / 12.0) - 1.0).abs() < 0.01, "{variance}");
    let mirrored: Vec<f64> = busy.iter().map(|value| -value).collect();
    let back = meter.series(&times, &mirrored, 1).unwrap();
    assert!(reading.iter().zip(&back).all(|(one, other)| *one == -*other));
    let halves = readout(|p| p.resolution = Some(1.0));
    let rounded = halves.series(&uniform(1.0, 6), &[-1.5, -0.5, 0.5, 1.5, 2.5, 1e9 - 0.3], 1).unwrap();
    assert_eq!(rounded, [-2.0, 0.0, 0.0, 2.0, 2.0, 1e9]);
}

#[test]
fn what_is_wrong_with_an_instrument_is_named() {
    let message = |change: fn(&mut ReadoutParameters)| {
        let mut parameters = ReadoutParameters::default();
        change(&mut parameters);
        Readout::new(parameters).unwrap_err().to_string()
    };
    assert_eq!(message(|p| p.order = 9), "order of the low-pass must be from 1 to 8, got 9");
    assert_eq!(message(|p| p.bandwidth = Some(-1.0)), "bandwidth must be above zero and finite, got -1 Hz");
    assert_eq!(message(|p| p.delay = -0.1), "delay must be finite and not below zero, got -0.1 s");
    assert_eq!(message(|p| p.averaging = Some(0.0)), "averaging window must be above zero and finite, got 0 s");
    assert_eq!(message(|p| p.resolution = Some(0.0)), "resolution must be above zero and finite, got 0");
    let meter = readout(|_| ());
    assert!(meter.series(&[0.0, 0.0], &[1.0, 1.0], 1).is_err());
    assert_eq!(meter.series(&[0.0, 1.0], &[1.0], 1).unwrap_err().to_string(), "values must hold 2 values, got 1");
    assert_eq!(meter.series(&[], &[], 1).unwrap(), Vec::<f64>::new());
}

#[test]
fn two_encoders_read_a_static_load_as_it_is() {
    let spring = s_t();
    for (compliance, backlash) in [(0.0, 0.0), (1e-4, 0.0), (1e-4, 5e-4), (1.0, 5e-4)] {
        for length in [0.05, 0.104, 0.23] {
            let encoders = TwoEncoder::new(&spring, compliance, backlash, length).unwrap();
            let load = spring.static_force(length);
            let elongation = encoders.elongation(&[0.3], &[0.3 + length], &[load]).unwrap();
            let force = encoders.force(&elongation)[0];
            assert!((force - load).abs() < 1e-11, "{compliance} {backlash} {length}: {force} {load}");
        }
    }
    // Without drive train they are the deflection sensor.
    let (u1, u2, f_i) = ([0.0, 0.01, 0.02], [0.2, 0.23, 0.21], [50.0, -3.0, 0.0]);
    let ideal = TwoEncoder::new(&spring, 0.0, 0.0, 0.23).unwrap();
    let force = ideal.force(&ideal.elongation(&u1, &u2, &f_i).unwrap());
    for (one, other) in force.iter().zip(deflection_force(&spring, &u1, &u2).unwrap()) {
        assert!((one - other).abs() < 1e-12);
    }
}

#[test]
fn a_change_of_side_is_read_with_the_whole_backlash() {
    let (spring, backlash) = (s_t(), 1e-3);
    let encoders = TwoEncoder::new(&spring, 1e-4, backlash, 0.23).unwrap();
    let length = |force: f64| spring.rest_length() + force / spring.stiffness();
    let loads = [0.0, 20.0, 0.0, -20.0, 0.0];
    let u2: Vec<f64> = loads.iter().map(|&load| length(load)).collect();
    let force = encoders.force(&encoders.elongation(&[0.0; 5], &u2, &loads).unwrap());
    // Where the force is zero it lies on the side it touched last; before the first contact on the side of that contact.
    let off = encoders.stiffness() * backlash;
    for (n, expected) in [0.0, 20.0, 0.0, -20.0 - off, -off].into_iter().enumerate() {
        assert!((force[n] - expected).abs() < 1e-11, "{n}: {} {expected}", force[n]);
    }
    assert!((encoders.stiffness() - 1.0 / (1.0 / 760.0 + 1e-4)).abs() < 1e-10);
    assert!(TwoEncoder::new(&spring, -1.0, 0.0, 0.2).is_err() && TwoEncoder::new(&spring, 0.0, f64::NAN, 0.2).is_err());
}

proptest! {
    /// Whatever numbers come in, the answer is an error or finite readings.
    #[test]
    fn no_input_gives_a_panic_or_a_silent_nan(
        times in prop::collection::vec(prop_oneof![prop::num::f64::ANY, -1.0..1.0], 0..20),
        values in prop::collection::vec(prop_oneof![prop::num::f64::ANY, -1e9..1e9], 20),
        a in prop::option::of(prop_oneof![prop::num::f64::ANY, 1e-9_f64..1e9]),
        b in prop::option::of(prop_oneof![prop::num::f64::ANY, 1e-9_f64..1e9]),
        c in prop::option::of(prop_oneof![prop::num::f64::ANY, 1e-9_f64..1e9]),
        d in prop::option::of(prop_oneof![prop::num::f64::ANY, 1e-9_f64..1e9]),
        delay in prop_oneof![prop::num::f64::ANY, 0.0..10.0],
        noise in prop_oneof![prop::num::f64::ANY, 0.0..10.0],
        order in 0_usize..10,
    ) {
        let parameters = ReadoutParameters { bandwidth: a, order, delay, averaging: b, sample_rate: c, noise, resolution: d };
        let Ok(meter) = Readout::new(parameters) else { return Ok(()) };
        prop_assert!(meter.bandwidth_3db() > 0.0 && meter.lag(0.0).is_finite());
        prop_assert!(meter.response(delay).norm().is_finite() || !delay.is_finite());
        let mut times = times;
        times.retain(|time| time.is_finite() && time.abs() < 1e9);
        times.sort_by(f64::total_cmp);
        times.dedup();
        let values: Vec<f64> = values.iter().take(times.len()).map(|v| if v.is_finite() { v.clamp(-1e9, 1e9) } else { 1.0 }).collect();
        let reading = meter.series(&times, &values, 1).unwrap();
        prop_assert!(reading.iter().all(|value| value.is_finite()), "{reading:?}");
    }
}

/// The first readings of seed 42 with σ = 0.3.
const GOLDEN: [f64; 5] = [
    -0.481_507_563_592_355_5,
    -0.419_597_002_161_574_7,
    0.347_968_985_918_778_1,
    0.011_488_333_486_264_431,
    0.582_572_253_940_096_5,
];
