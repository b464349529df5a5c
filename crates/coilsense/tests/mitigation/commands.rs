//! Shaped commands on the exact motion of the chain: what rings after a step of 5 mm.

use coilsense::excitation::{EndInput, Sampled, Start};
use coilsense::mitigation::{SampledSpring, surge_mean, zero_vibration, zero_vibration_derivative};
use coilsense::signals::sampled_window;
use coilsense::{Excitation, Motion};

use super::{paper_springs, sampled_at};

/// Whole samples per surge period, so that shapers are judged and not the line between samples.
fn sampled() -> SampledSpring {
    let spring = paper_springs::s_t();
    let first = coilsense::modes::ChainModes::of(&spring).frequencies()[0] / std::f64::consts::TAU;
    sampled_at(&spring, 0.0, 200.0 * first)
}

/// The largest departure of F_i from the static force, from 0.1 s to 0.3 s after a shaped step of 5 mm.
fn residual(spring: &SampledSpring, mut shaped: impl FnMut(f64) -> f64) -> f64 {
    let times = sampled_window(spring.rate(), 0.0, 0.3).unwrap();
    let places: Vec<f64> = times.iter().map(|time| shaped(if *time > 0.01 { 0.005 } else { 0.0 })).collect();
    let drive = EndInput::Sampled(Sampled::new(times.clone(), places).unwrap());
    let excitation = Excitation::new(0.23, drive, EndInput::Held, Start::Rest).unwrap();
    let forces = Motion::new(spring.spring(), &excitation).unwrap().end_forces(&times).unwrap().input;
    let still = spring.spring().static_force(0.225);
    let after = forces.iter().zip(&times).filter(|(_, time)| **time > 0.1);
    after.map(|(force, _)| (force - still).abs()).fold(0.0, f64::max)
}

#[test]
fn a_ramp_over_a_surge_period_spares_every_mode_and_impulses_their_own() {
    let spring = sampled();
    let plain = residual(&spring, |x| x);
    let (zv, zvd, ramp) = (zero_vibration(&spring), zero_vibration_derivative(&spring), surge_mean(&spring));
    let (mut a, mut b, mut c) = (zv.settled::<256>(0.0), zvd.settled::<256>(0.0), ramp.settled::<256>(0.0));
    let zv = residual(&spring, |x| zv.step(&mut a, x));
    let zvd = residual(&spring, |x| zvd.step(&mut b, x));
    let ramp = residual(&spring, |x| ramp.step(&mut c, x));
    // Odd modes are gone, even ones are not: more than a third and less than all of it is left, by either shaper.
    assert!((0.3..0.95).contains(&(zv / plain)), "{zv} N of {plain} N");
    assert!((0.3..0.95).contains(&(zvd / plain)), "{zvd} N of {plain} N");
    // Chain modes lie below n·f1 the more the higher (2.5 % at n = 13): some per cent of their share.
    assert!(ramp < 0.05 * plain, "{ramp} N of {plain} N");
}

#[test]
fn mode_one_is_at_rest_after_two_impulses() {
    let spring = sampled();
    let zv = zero_vibration(&spring);
    // Half a period is 100 samples: at the mode's frequency both impulses cancel.
    let response = zv.impulses.iter().fold((0.0, 0.0), |(re, im), impulse| {
        let angle = std::f64::consts::PI * (impulse.delay.whole as f64 + impulse.delay.fraction) / 100.0;
        (re + impulse.amplitude * angle.cos(), im - impulse.amplitude * angle.sin())
    });
    // The delay is π f_s/ω, a few roundings from 100.
    assert!(f64::hypot(response.0, response.1) < 1e-12, "{response:?}");
}

#[test]
fn three_impulses_forgive_a_frequency_that_is_off() {
    let spring = sampled();
    let left = |impulses: &[coilsense_rt::Impulse<f64>]| {
        let angle = |late: f64| std::f64::consts::PI * late / 100.0 * 1.1;
        let sums = impulses.iter().fold((0.0, 0.0), |(re, im), i| {
            let phase = angle(i.delay.whole as f64 + i.delay.fraction);
            (re + i.amplitude * phase.cos(), im - i.amplitude * phase.sin())
        });
        f64::hypot(sums.0, sums.1)
    };
    let (two, three) = (left(&zero_vibration(&spring).impulses), left(&zero_vibration_derivative(&spring).impulses));
    // cos(π/2 · 1.1) and its square.
    assert!((two - 0.156_4).abs() < 1e-3 && (three - 0.024_5).abs() < 1e-3, "{two}, {three}");
}
