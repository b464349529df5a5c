//! Every filter's frequency response, taken from its answer to an impulse, equals its formula.
//!
//! Next door: observers (`observers`), single precision and long runs (`rounding`).

use coilsense_rt::{Biquad, Boxcar, Cascade, Comb, Delay, DoubleBoxcar, Fusion, Impulse, Shaper, Window};
use num_complex::Complex64;

/// Of the peak: some thousand terms of one rounding each, those of the answer and those of its transform.
const TOLERANCE: f64 = 1e-12;

fn z_inverse(omega: f64) -> Complex64 {
    Complex64::cis(-omega)
}

/// Σ h_n z⁻ⁿ of the answer to a unit impulse.
fn measured(mut step: impl FnMut(f64) -> f64, samples: usize) -> Vec<(f64, Complex64)> {
    let answer: Vec<f64> = (0..samples).map(|n| step(if n == 0 { 1.0 } else { 0.0 })).collect();
    let frequencies = (0..=40).map(|i| 0.003 + std::f64::consts::PI * f64::from(i) / 40.3);
    frequencies
        .map(|omega| {
            let terms = answer.iter().enumerate();
            (omega, terms.map(|(n, value)| value * Complex64::cis(-omega * n as f64)).sum())
        })
        .collect()
}

fn assert_equal(response: &[(f64, Complex64)], formula: impl Fn(Complex64) -> Complex64) {
    let peak = response.iter().map(|(_, value)| value.norm()).fold(0.0, f64::max);
    assert!(peak > 0.1, "a filter that lets nothing through proves nothing");
    for (omega, value) in response {
        let expected = formula(z_inverse(*omega));
        assert!((value - expected).norm() < TOLERANCE * peak.max(1.0), "{omega}: {value} against {expected}");
    }
}

fn biquad(section: &Biquad<f64>, z: Complex64) -> Complex64 {
    (section.b0 + section.b1 * z + section.b2 * z * z) / (1.0 + section.a1 * z + section.a2 * z * z)
}

fn delay(delay: &Delay<f64>, z: Complex64) -> Complex64 {
    (1.0 - delay.fraction) * z.powi(delay.whole as i32) + delay.fraction * z.powi(delay.whole as i32 + 1)
}

fn boxcar(mean: &Boxcar<f64>, z: Complex64) -> Complex64 {
    let whole: Complex64 = (0..mean.whole as i32).map(|i| z.powi(i)).sum();
    mean.scale * (whole + mean.fraction * z.powi(mean.whole as i32))
}

fn mean_over(length: f64) -> Boxcar<f64> {
    Boxcar { whole: length as usize, fraction: length.fract(), scale: 1.0 / length }
}

#[test]
fn a_cascade_is_the_product_of_its_sections() {
    let sections = [
        Biquad { b0: 0.2, b1: 0.3, b2: 0.1, a1: -0.9, a2: 0.5 },
        Biquad { b0: 0.95, b1: -1.7, b2: 0.95, a1: -1.7, a2: 0.9 },
        Biquad { b0: 1.0, b1: 0.0, b2: 0.0, a1: 0.4, a2: 0.0 },
    ];
    let cascade = Cascade { sections };
    let mut state = cascade.settled(0.0);
    let response = measured(|x| cascade.step(&mut state, x), 2000);
    assert_equal(&response, |z| sections.iter().map(|section| biquad(section, z)).product());
}

#[test]
fn a_mean_over_whole_or_broken_samples_is_its_sum() {
    for length in [1.0, 7.0, 46.240_331, 46.999] {
        let mean = mean_over(length);
        let mut state = mean.settled::<64>(0.0);
        let response = measured(|x| mean.step(&mut state, x), 200);
        assert_equal(&response, |z| boxcar(&mean, z));
    }
}

#[test]
fn two_means_multiply() {
    let double = DoubleBoxcar { first: mean_over(46.24), second: mean_over(17.5) };
    let mut state = double.settled::<64>(0.0);
    let response = measured(|x| double.step(&mut state, x), 200);
    assert_equal(&response, |z| boxcar(&double.first, z) * boxcar(&double.second, z));
}

#[test]
fn a_comb_has_a_pole_inside_of_every_zero_but_that_at_rest() {
    for (length, radius) in [(46.240_331, 0.99_f64), (9.0, 0.9), (1.5, 0.5), (20.25, 0.0)] {
        let feedback = radius.powf(length);
        let scale = (1.0 - feedback) / (length * (1.0 - radius));
        let comb = Comb { period: Boxcar { scale, ..mean_over(length) }, radius, feedback };
        let mut state = comb.settled::<64>(0.0);
        let response = measured(|x| comb.step(&mut state, x), 5000);
        let shift = Delay { whole: length as usize, fraction: length.fract() };
        assert_equal(&response, |z| {
            let back = delay(&shift, z);
            scale * (1.0 - back) / (1.0 - z) * (1.0 - radius * z) / (1.0 - feedback * back)
        });
    }
}

#[test]
fn a_window_is_its_taps() {
    let window = Window { taps: std::array::from_fn::<f64, 37, _>(|i| (0.3 * i as f64).cos() / 5.0) };
    let mut state = window.settled(0.0);
    let response = measured(|x| window.step(&mut state, x), 100);
    assert_equal(&response, |z| window.taps.iter().enumerate().map(|(i, tap)| tap * z.powi(i as i32)).sum());
}

#[test]
fn a_shaper_is_its_impulses() {
    let impulse = |amplitude, whole, fraction| Impulse { amplitude, delay: Delay { whole, fraction } };
    let shaper = Shaper { impulses: [impulse(0.25, 0, 0.0), impulse(0.5, 23, 0.12), impulse(0.25, 46, 0.24)] };
    let mut state = shaper.settled::<64>(0.0);
    let response = measured(|x| shaper.step(&mut state, x), 100);
    assert_equal(&response, |z| shaper.impulses.iter().map(|i| i.amplitude * delay(&i.delay, z)).sum());
}

#[test]
fn fusion_takes_rest_from_the_slow_force_and_motion_from_the_fast() {
    let fusion = Fusion { gain: 0.02, lateness: Delay { whole: 12, fraction: 0.5 } };
    let blend = |z: Complex64| fusion.gain / (1.0 - (1.0 - fusion.gain) * z);
    let mut state = fusion.settled::<16>(0.0, 0.0);
    let fast = measured(|x| fusion.step(&mut state, x, Some(0.0)), 3000);
    assert_equal(&fast, |z| 1.0 - blend(z) * delay(&fusion.lateness, z));
    let mut state = fusion.settled::<16>(0.0, 0.0);
    let slow = measured(|x| fusion.step(&mut state, 0.0, Some(x)), 3000);
    assert_equal(&slow, blend);
}

#[test]
fn without_a_new_slow_force_the_bias_stays() {
    let fusion = Fusion { gain: 0.5, lateness: Delay { whole: 0, fraction: 0.0 } };
    let mut state = fusion.settled::<2>(1.0, 5.0);
    // An offset of exactly 4 N, added to whatever comes.
    for force in [1.0, -3.0, 100.0] {
        assert_eq!(fusion.step(&mut state, force, None), force + 4.0);
    }
}
