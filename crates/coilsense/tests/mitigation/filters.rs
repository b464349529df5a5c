//! Filters of forces: where they null, how wide, how they stand rounding; the fitted window against its neighbours.

use coilsense::mitigation::{
    Coefficients, Rounding, ToleranceBox, WindowDesign, double_mean, low_pass, notch, surge_comb, surge_mean,
    surge_notches, surge_window,
};
use coilsense::signals::sampled_window;
use coilsense::{Damping, Excitation, FarEnd, Motion, Mount, Spring};
use coilsense_rt::{Cascade, Window};
use num_complex::Complex64;

use super::{even, paper_springs, sampled};

const RATE: f64 = 2500.0;
const FIRST: f64 = 54.065_389_6;

/// |H| at `frequency` from the answer to an impulse.
fn gain(mut step: impl FnMut(f64) -> f64, frequency: f64) -> f64 {
    let omega = std::f64::consts::TAU * frequency / RATE;
    let answer = (0..20_000).map(|n| step(if n == 0 { 1.0 } else { 0.0 }) * Complex64::cis(-omega * f64::from(n)));
    answer.sum::<Complex64>().norm()
}

#[test]
fn a_notch_is_as_wide_as_its_quality_says() {
    let section = notch(FIRST, 2.0, RATE).unwrap();
    let filter = Cascade { sections: [section] };
    let at = |frequency| {
        let mut state = filter.settled(0.0);
        gain(|x| filter.step(&mut state, x), frequency)
    };
    // A zero on the circle: rounding of 20 000 terms.
    assert!(at(FIRST) < 1e-11);
    // Edges f such that (tan(πf/f_s) − t0²/tan(πf/f_s)) = ± its width, found by their product: tan a · tan b = t0².
    let (center, half) = ((std::f64::consts::PI * FIRST / RATE).tan(), std::f64::consts::PI * FIRST / 2.0 / RATE);
    let tangent = half.tan() * (1.0 + center * center) * 0.5;
    let edge = (tangent + (tangent * tangent + center * center).sqrt()).atan() * RATE / std::f64::consts::PI;
    assert!((at(edge) - 0.5_f64.sqrt()).abs() < 1e-3, "{} at {edge}", at(edge));
}

#[test]
fn a_set_of_notches_a_mean_and_a_comb_null_every_surge_frequency() {
    let spring = sampled();
    let first = spring.spring().surge_frequency();
    let notches: [_; 5] = surge_notches(&spring, 5, 3.0).unwrap().try_into().unwrap();
    let (set, mean, comb) = (Cascade { sections: notches }, surge_mean(&spring), surge_comb(&spring, 5.0).unwrap());
    for n in 1..=5 {
        let frequency = f64::from(n) * first;
        let (mut a, mut b, mut c) = (set.settled(0.0), mean.settled::<64>(0.0), comb.settled::<64>(0.0));
        assert!(gain(|x| set.step(&mut a, x), frequency) < 1e-10);
        // 2τ is 46.24 samples: the straight line between samples is off by (ωT)²/8 · 4φ(1−φ), and a mean divides by its zero's own slope.
        let off = (std::f64::consts::TAU * frequency / RATE).powi(2) / 8.0;
        assert!(gain(|x| mean.step(&mut b, x), frequency) < off);
        // A comb's pole holds its gain up: 1 − ρᴸ = 0.25 is what divides the same error.
        assert!(gain(|x| comb.step(&mut c, x), frequency) < 4.0 * off, "n = {n}");
    }
}

#[test]
fn a_comb_is_as_wide_as_it_is_asked_to_be_and_leaves_the_middle_between_notches() {
    let spring = sampled();
    let first = spring.spring().surge_frequency();
    for width in [2.0, 5.0, 13.0] {
        let comb = surge_comb(&spring, width).unwrap();
        let at = |frequency| {
            let mut state = comb.settled::<64>(0.0);
            gain(|x| comb.step(&mut state, x), frequency)
        };
        let edges = (at(first - 0.525 * width), at(first - 0.475 * width));
        let half_power = 0.5_f64.sqrt();
        // The passport's 5 % of the width; the neighbouring zero left out at 0 Hz tilts the notch.
        assert!(edges.0 > 0.9 * half_power && edges.1 < 1.1 * half_power, "{width}: {edges:?}");
        assert!(at(1.5 * first) > 0.95);
    }
}

#[test]
fn means_spread_apart_are_small_over_a_band_where_one_mean_is_not() {
    let spring = sampled();
    let (mean, double) = (surge_mean(&spring), double_mean(&spring, 0.07).unwrap());
    for factor in [0.9, 1.0, 1.1] {
        let frequency = factor * spring.spring().surge_frequency();
        let (mut a, mut b) = (mean.settled::<64>(0.0), double.settled::<64>(0.0));
        let (single, twice) = (gain(|x| mean.step(&mut a, x), frequency), gain(|x| double.step(&mut b, x), frequency));
        // Near its zero a mean's gain is Δf/f1: 0.1; two of them at ±7 % give 0.17 · 0.03 at the edge and 0.07² in the middle.
        assert!(twice < 0.01, "{factor}: {twice}");
        assert!(single > 0.08 || factor == 1.0);
    }
}

#[test]
fn rounding_is_told_and_a_filter_that_it_makes_unstable_is_refused() {
    let sections = low_pass(2, 27.0, RATE).unwrap();
    let changes: Vec<f64> = [
        Rounding::Double,
        Rounding::Fixed { fraction_bits: 30 },
        Rounding::Single,
        Rounding::Fixed { fraction_bits: 14 },
    ]
    .map(|rounding| Coefficients::checked(&sections, rounding).unwrap().response_change)
    .to_vec();
    assert_eq!(changes[0], 0.0);
    // 2⁻³¹, 2⁻²⁵ and 2⁻¹⁵ of error each, divided by (1 + a1 + a2) = 4.4e-3 at rest.
    assert!(changes[1] < 1e-6 && changes[2] < 4e-5 && changes[3] > 1e-4, "{changes:?}");
    assert!(changes.windows(2).all(|pair| pair[0] < pair[1]), "{changes:?}");
    let told = Coefficients::checked(&low_pass(1, 0.01, RATE).unwrap(), Rounding::Fixed { fraction_bits: 14 });
    assert!(told.unwrap_err().to_string().starts_with("pole radius of section 1 as stored must be below 1, got 1"));
}

const DESIGN: WindowDesign =
    WindowDesign { impact: 0.25, interval: 2.0, bandwidth: 1.5, motion: 0.0, noise: 0.24, tolerances: None };

/// The mean square that a window leaves of an impact's ringing and of noise, run as a controller runs it.
fn left<const N: usize>(spring: &Spring, window: &Window<f64, N>) -> f64 {
    let mount = Mount::new(FarEnd::Position, Damping::Modal(0.005)).unwrap();
    let motion = Motion::mounted(spring, &mount, &Excitation::impact(0.23, 0.25).unwrap()).unwrap();
    let forces = motion.end_forces(&sampled_window(RATE, 0.0, 2.0).unwrap()).unwrap().input;
    let still = spring.static_force(0.23);
    let mut state = window.settled(still);
    let sum: f64 = forces.iter().map(|force| (window.step(&mut state, *force) - still).powi(2)).sum();
    sum / forces.len() as f64 + 0.24 * 0.24 * window.taps.iter().map(|tap| tap * tap).sum::<f64>()
}

#[test]
fn no_window_near_the_fitted_one_leaves_less_of_impact_and_noise() {
    let spring = sampled();
    let best = surge_window::<93>(&spring, &DESIGN).unwrap();
    let least = left(spring.spring(), &best);
    for seed in 0..20 {
        let mut other = best;
        let mut change = even(seed, 93);
        let mean = change.iter().sum::<f64>() / 93.0;
        change.iter_mut().for_each(|value| *value -= mean);
        other.taps.iter_mut().zip(&change).for_each(|(tap, value)| *tap += 1e-3 * value);
        // The window's sums leave the last 92 samples' overlap out: 1e-5 of the mean square at a ringing that has decayed.
        assert!(left(spring.spring(), &other) > least * (1.0 - 1e-4), "seed {seed}");
    }
    let mut mean = Window { taps: [0.0; 93] };
    mean.taps[..46].fill(1.0 / 46.0);
    assert!(least < 0.9 * left(spring.spring(), &mean), "a fitted window must beat the mean over a surge period");
}

#[test]
fn a_window_fitted_over_the_box_is_better_at_its_corners() {
    let spring = sampled();
    let box_of = ToleranceBox::new(0.1, 0.1).unwrap();
    let narrow = surge_window::<93>(&spring, &DESIGN).unwrap();
    let wide = surge_window::<93>(&spring, &WindowDesign { tolerances: Some(box_of), ..DESIGN }).unwrap();
    let mean = |window: &Window<f64, 93>| {
        let corners = box_of.corners();
        let each = corners.iter().map(|c| left(&ToleranceBox::changed(&paper_springs::s_t(), *c).unwrap(), window));
        each.sum::<f64>() / corners.len() as f64
    };
    assert!(mean(&wide) < mean(&narrow));
}

#[test]
fn a_force_that_moves_is_followed_as_fast_as_it_moves() {
    let spring = sampled();
    let moving = WindowDesign { motion: 2.7, ..DESIGN };
    let window = surge_window::<93>(&spring, &moving).unwrap();
    let omega = std::f64::consts::TAU * 1.5 / RATE;
    let response: Complex64 =
        window.taps.iter().enumerate().map(|(n, tap)| *tap * Complex64::cis(-omega * n as f64)).sum();
    // 2.7 N rms of motion weigh a hundred times more than the 0.03 N of noise that slopes let through.
    assert!((response - 1.0).norm() < 0.02, "{response}");
    assert!((window.taps.iter().sum::<f64>() - 1.0).abs() < 1e-9);
}
