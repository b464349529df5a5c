//! Observers against exact motions: square waves of an impact, single modes in closed form, a bias, a bank that finds its spring.
//!
//! Next door: the same on the whole chain, with designed gains (`coilsense`'s tests of its mitigation).

use coilsense_rt::{Bank, Delay, DelayLineObserver, KalmanState, Measured, ModalKalman, Mode};

const REST: f64 = 0.104;
const STIFFNESS: f64 = 760.0;
/// S_T at rest, 230 mm long.
const AT_REST: Measured<f64> = Measured { force: STIFFNESS * (0.23 - REST), ends: [0.0, 0.23] };

/// A spring whose wave takes `transit` samples at 2.5 kHz.
fn waves(gain: f64, transit: f64) -> DelayLineObserver<f64> {
    DelayLineObserver {
        stiffness: STIFFNESS,
        rest_length: REST,
        impedance: STIFFNESS * transit / 2500.0,
        rate: 2500.0,
        transit: Delay { whole: transit as usize, fraction: transit.fract() },
        gain,
        loss: 0.0,
    }
}

/// F_i less the static force after an impact at 1 m/s of a continuous coil, in units of Z: +1 for one transit, then −1, and so on.
fn square(sample: usize, transit: usize) -> f64 {
    if (sample / transit) % 2 == 0 { 1.0 } else { -1.0 }
}

#[test]
fn the_square_wave_of_an_impact_arrives_at_the_other_end_mirrored() {
    let observer = waves(1.0, 23.0);
    let ends = [0.0, 0.23];
    let still = STIFFNESS * (0.23 - REST);
    let mut state = observer.settled::<32>(&AT_REST);
    for sample in 0..400 {
        let wave = 0.25 * observer.impedance * square(sample, 23);
        let output = observer.step(&mut state, &Measured { force: still + wave, ends });
        if sample >= 23 {
            // d'Alembert: what end 1 feels as +Z v end 2 feels as −Z v at once; only rounding is left.
            assert!((output - (still - wave)).abs() < 1e-11, "sample {sample}: {output}");
        }
    }
}

#[test]
fn waves_run_as_a_simulation_with_no_gain_and_keep_what_they_carry() {
    // A velocity of end 1 that lasts one transit: a wave of −Z v, seen at end 2 doubled, and reflected for ever.
    let observer = waves(0.0, 23.0);
    let mut state = observer.settled::<32>(&AT_REST);
    let still = STIFFNESS * (0.23 - REST);
    let speed = 0.1;
    let mut outputs = Vec::new();
    for sample in 1..=23 * 7 {
        let place = speed * (sample.min(23) as f64) / 2500.0;
        let measured = Measured { force: 0.0, ends: [place, 0.23] };
        outputs.push(observer.step(&mut state, &measured) - still);
    }
    for (index, output) in outputs.iter().enumerate() {
        // Sample `index + 1` of the drive; a wave sent in samples 1…23 arrives 23 later, again after two transits more.
        let arrived = (index / 23) % 2 == 1;
        // Free of drive after the first transit, end 2 sees −2 Z v while the wave is there, and nothing in between.
        let expected = if arrived { -2.0 * observer.impedance * speed } else { 0.0 };
        assert!((output - expected).abs() < 1e-10, "sample {index}: {output} against {expected}");
    }
}

#[test]
fn a_low_gain_averages_noise_of_the_motor_side_and_still_finds_the_impact() {
    let observer = waves(0.2, 23.0);
    let ends = [0.0, 0.23];
    let still = STIFFNESS * (0.23 - REST);
    let mut state = observer.settled::<32>(&AT_REST);
    let mut error = 0.0;
    for sample in 0..3000 {
        let wave = 0.25 * observer.impedance * square(sample, 23);
        let output = observer.step(&mut state, &Measured { force: still + wave, ends });
        error = (output - (still - wave)).abs();
    }
    // What is not yet known decays by 0.8 every round trip of 46 samples: 0.8^65 = 5e-7 of 1.75 N.
    assert!(error < 2e-6, "{error}");
}

const OMEGA: f64 = 340.0;
const STEP: f64 = 1.0 / 2500.0;

/// One mode of a spring, undamped; participations 0.6 and −0.3.
fn one_mode(gain: [f64; 2], bias_gain: f64) -> ModalKalman<f64, 1> {
    let (sine, cosine) = (OMEGA * STEP).sin_cos();
    let mode = Mode {
        turn: [[cosine, sine], [-sine, cosine]],
        kick: [-0.6 / OMEGA, 0.3 / OMEGA],
        input: 900.0,
        output: -900.0,
        gain,
    };
    ModalKalman { stiffness: STIFFNESS, rest_length: REST, rate: 2500.0, bias_gain, modes: [mode] }
}

#[test]
fn without_gains_a_mode_answers_a_ramp_as_an_oscillator_does() {
    let filter = one_mode([0.0; 2], 0.0);
    let mut state = filter.settled(&AT_REST);
    let speed = 0.05;
    for sample in 1..2000 {
        let time = sample as f64 * STEP;
        let ends = [speed * time, 0.23];
        let estimate = filter.step(&mut state, &Measured { force: 0.0, ends });
        let still = STIFFNESS * (ends[1] - ends[0] - REST);
        // q̈ + ω² q = −c1 ü1 with a jump of u̇1 by v at t = 0: q = −c1 v sin(ωt)/ω.
        let ringing = -0.6 * speed * (OMEGA * time).sin() / OMEGA;
        // Differences of positions 1e-17 off, times 2500 twice over, kick the mode some thousand times.
        assert!((estimate.input - still - 900.0 * ringing).abs() < 1e-9, "sample {sample}");
        assert!((estimate.output - still + 900.0 * ringing).abs() < 1e-9, "sample {sample}");
    }
}

/// F_i of the spring ringing freely with `amplitude` \[m\] about the static force, the load cell off by `offset` \[N\].
fn ringing(sample: usize, amplitude: f64, offset: f64) -> f64 {
    STIFFNESS * (0.23 - REST) + offset + 900.0 * amplitude * (OMEGA * (sample + 1) as f64 * STEP).cos()
}

#[test]
fn an_offset_goes_into_the_bias_and_a_ringing_into_the_mode() {
    let filter = one_mode([2e-4, 1e-4], 0.05);
    let ends = [0.0, 0.23];
    let mut state = filter.settled(&AT_REST);
    let mut last = None;
    for sample in 0..2000 {
        let estimate = filter.step(&mut state, &Measured { force: ringing(sample, 0.002, 3.0), ends });
        let wave = 900.0 * 0.002 * (OMEGA * (sample + 1) as f64 * STEP).cos();
        last = Some((estimate, STIFFNESS * (0.23 - REST) + 3.0 - wave));
    }
    let (estimate, truth) = last.unwrap();
    // Decay of the slowest pole (about 0.95 a sample) over 2000 samples is beyond rounding.
    assert!((estimate.output - truth).abs() < 1e-9, "{estimate:?} against {truth}");
    assert!(estimate.surprise.abs() < 1e-9);
}

#[test]
fn what_the_stiffness_does_not_explain_at_rest_is_bias_from_the_beginning() {
    let filter = one_mode([2e-4, 1e-4], 0.05);
    let measured = Measured { force: 1.1 * AT_REST.force, ends: AT_REST.ends };
    let mut state = filter.settled(&measured);
    let observer = DelayLineObserver { loss: 0.1, ..waves(0.2, 23.0) };
    let mut of_waves = observer.settled::<32>(&measured);
    for _ in 0..100 {
        // Sums of four numbers near 100.
        assert!((filter.step(&mut state, &measured).output - measured.force).abs() < 1e-12);
        assert!((observer.step(&mut of_waves, &measured) - measured.force).abs() < 1e-10);
    }
}

#[test]
fn a_bank_believes_the_member_whose_spring_it_is() {
    let mut off = one_mode([2e-5, 1e-5], 0.005);
    let (sine, cosine) = (0.9 * OMEGA * STEP).sin_cos();
    off.modes[0].turn = [[cosine, sine], [-sine, cosine]];
    let bank = Bank { members: [off, one_mode([2e-5, 1e-5], 0.005)], forgetting: 0.01, sharpness: 100.0 };
    let ends = [0.0, 0.23];
    let mut state = bank.settled(&AT_REST);
    let mut alone: KalmanState<f64, 1> = bank.members[1].settled(&AT_REST);
    let mut difference = 0.0;
    for sample in 0..4000 {
        let measured = Measured { force: ringing(sample, 0.002, 0.0), ends };
        let ours = bank.step(&mut state, &measured);
        difference = (ours.output - bank.members[1].step(&mut alone, &measured).output).abs();
    }
    // The other is surprised by 0.1 N² or more, so its weight is below e^−10 of an output that differs by some newtons.
    assert!(difference < 1e-3, "{difference}");
}

#[test]
fn members_that_are_all_one_filter_give_what_it_gives() {
    let member = one_mode([2e-4, 1e-4], 0.05);
    let bank = Bank { members: [member; 3], forgetting: 0.1, sharpness: 10.0 };
    let ends = [0.0, 0.23];
    let (mut state, mut alone) = (bank.settled(&AT_REST), member.settled(&AT_REST));
    for sample in 0..200 {
        let measured = Measured { force: ringing(sample, 0.002, 1.0), ends };
        let (ours, single) = (bank.step(&mut state, &measured), member.step(&mut alone, &measured));
        // A mean of three equal forces near 100 N: a few roundings.
        assert!((ours.output - single.output).abs() < 1e-12 && (ours.input - single.input).abs() < 1e-12);
    }
}
