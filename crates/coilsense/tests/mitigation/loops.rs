//! Force loops closed on an estimate of the load-end force: stable over the tolerance box where the force itself allows it, and not beyond.

use coilsense::mitigation::{BankDesign, KalmanNoise, ToleranceBox, modal_kalman, observer_bank};
use coilsense::motion::Live;
use coilsense::{Damping, FarEnd, Mount, Spring};
use coilsense_rt::Measured;

use super::{paper_springs, sampled};

const RATE: f64 = 2500.0;
const RATIO: f64 = 0.005;
const NOISE: KalmanNoise = KalmanNoise { force: 0.24, shock: 0.15, ringing: 0.1, drift: 0.1 };

/// Integral control of the force that `estimate` makes: u̇1 = (ω_c/k)(F̂ − F_ref), end 2 held, an ideal velocity source.
///
/// Rms ringing of F_o late over early: below 1 it dies away.
fn growth(spring: &Spring, crossover: f64, mut estimate: impl FnMut(&Measured<f64>, f64) -> f64) -> f64 {
    let mount = Mount::new(FarEnd::Position, Damping::Modal(RATIO)).unwrap();
    let mut live = Live::new(spring, &mount, 0.23, 1.0 / RATE).unwrap();
    let reference = spring.static_force(0.23) + 5.0;
    let (mut place, mut wave) = (0.0, [0.0; 2]);
    let samples = (10.0 * RATE) as usize;
    for sample in 0..samples {
        let forces = live.advance([place, 0.0]).unwrap();
        let ends = [place, 0.23];
        let force = estimate(&Measured { force: forces.input, ends }, forces.output);
        // Early: the second to fourth second, after the reference has been followed at first; late: the last two.
        let ringing = forces.output - spring.static_force(0.23 - place);
        match sample as f64 / RATE {
            time if (2.0..4.0).contains(&time) => wave[0] += ringing * ringing,
            time if time >= 8.0 => wave[1] += ringing * ringing,
            _ => {}
        }
        place += crossover / spring.stiffness() / RATE * (force - reference);
    }
    (wave[1] / wave[0]).sqrt()
}

/// ζω₁ of a spring: up to there the load-end force may be integrated.
fn limit(spring: &Spring) -> f64 {
    RATIO * coilsense::modes::ChainModes::of(spring).frequencies()[0]
}

#[test]
fn a_loop_on_the_estimate_is_stable_over_the_box_at_half_the_limit_of_the_force_itself() {
    let sampled = sampled();
    let tolerances = ToleranceBox::new(0.1, 0.1).unwrap();
    let agile = KalmanNoise { ringing: 2.0, drift: 0.5, ..NOISE };
    let filter = modal_kalman::<3>(&sampled, &agile).unwrap();
    let design = BankDesign { noise: NOISE, stiffnesses: 3, memory: 0.1, sharpness: 30.0 };
    let bank = observer_bank::<3, 15>(&sampled, &tolerances, &design).unwrap();
    for corner in tolerances.corners() {
        let spring = ToleranceBox::changed(&paper_springs::s_t(), corner).unwrap();
        let rest = Measured { force: spring.static_force(0.23), ends: [0.0, 0.23] };
        let crossover = 0.5 * limit(&spring);
        let (mut of_filter, mut of_bank) = (filter.settled(&rest), bank.settled(&rest));
        let by_filter = growth(&spring, crossover, |measured, _| filter.step(&mut of_filter, measured).output);
        let by_bank = growth(&spring, crossover, |measured, _| bank.step(&mut of_bank, measured).output);
        // What is left of ζω₁ = 1.7/s is half: e^(−0.85 · 6) = 0.006 from the third second to the ninth; a quarter of that rate would be 0.3.
        assert!(by_filter < 0.3 && by_bank < 0.3, "{corner:?}: {by_filter}, {by_bank}");
    }
}

#[test]
fn beyond_the_limit_a_true_estimate_is_as_unstable_as_the_force() {
    let sampled = sampled();
    let spring = paper_springs::s_t();
    let filter = modal_kalman::<3>(&sampled, &NOISE).unwrap();
    let rest = Measured { force: spring.static_force(0.23), ends: [0.0, 0.23] };
    let mut state = filter.settled(&rest);
    let crossover = 2.0 * limit(&spring);
    let by_force = growth(&spring, crossover, |_, output| output);
    let by_estimate = growth(&spring, crossover, |measured, _| filter.step(&mut state, measured).output);
    let by_input = growth(&spring, crossover, |measured, _| measured.force);
    // Growth at ω_c − ζω₁ = 1.7/s over six seconds is e^10; the motor-side force has no such limit.
    assert!(by_force > 100.0 && by_estimate > 100.0, "{by_force}, {by_estimate}");
    assert!(by_input < 0.1, "{by_input}");
}
