//! Observers on the exact motion of the chain.

use coilsense::excitation::{EndInput, Sampled, Start};
use coilsense::mitigation::{
    BankDesign, KalmanNoise, SampledSpring, ToleranceBox, delay_line_observer, inductance_fusion, modal_kalman,
    observer_bank, ringing_error_bound,
};
use coilsense::signals::sampled_window;
use coilsense::{Damping, Excitation, FarEnd, Motion, Mount, Spring};
use coilsense_rt::{Measured, ModalKalman};
use nalgebra::{DMatrix, DVector};

use super::{even, paper_springs, sampled, sampled_at};

const NOISE: KalmanNoise = KalmanNoise { force: 0.24, shock: 0.1, ringing: 0.5, drift: 0.1 };

/// F_i, F_o and where the ends are, sample by sample.
struct Run {
    measured: Vec<Measured<f64>>,
    output: Vec<f64>,
}

fn run(spring: &SampledSpring, excitation: &Excitation, seconds: f64) -> Run {
    let mount = Mount::new(FarEnd::Position, Damping::ModalEach(spring.ratios().to_vec())).unwrap();
    let motion = Motion::mounted(spring.spring(), &mount, excitation).unwrap();
    let times = sampled_window(spring.rate(), 0.0, seconds).unwrap();
    let forces = motion.end_forces(&times).unwrap();
    let ends = motion.ends(&times).unwrap();
    let each = forces.input.iter().zip(ends);
    Run { measured: each.map(|(force, ends)| Measured { force: *force, ends }).collect(), output: forces.output }
}

fn at_rest(spring: &Spring, length: f64) -> Measured<f64> {
    Measured { force: spring.static_force(length), ends: [0.0, length] }
}

#[test]
fn with_all_modes_and_no_gain_a_filter_is_the_exact_motion() {
    let spring = Spring::new(paper_springs::s_t_with(|p| p.windings = 4.0)).unwrap();
    let sampled = sampled_at(&spring, 0.02, 2500.0);
    let times = sampled_window(2500.0, 0.0, 0.4).unwrap();
    // Both ends wander at random, straight between samples; they start at rest where the mean is.
    let drive = |seed| {
        let mut place = 0.0;
        let mut places: Vec<f64> = even(seed, times.len())
            .iter()
            .map(|step| {
                place += 1e-4 * step;
                place
            })
            .collect();
        places[0] = 0.0;
        EndInput::Sampled(Sampled::new(times.clone(), places).unwrap())
    };
    let run = run(&sampled, &Excitation::new(0.23, drive(1), drive(2), Start::Rest).unwrap(), 0.4);
    let mut filter = modal_kalman::<4>(&sampled, &NOISE).unwrap();
    filter.bias_gain = 0.0;
    filter.modes.iter_mut().for_each(|mode| mode.gain = [0.0; 2]);
    let mut state = filter.settled(&run.measured[0]);
    let peak = run.output.iter().fold(0.0_f64, |peak, force| peak.max((force - run.output[0]).abs()));
    for (measured, output) in run.measured.iter().zip(&run.output).skip(1) {
        let estimate = filter.step(&mut state, measured);
        // Second differences of positions near 0.23 m, times f_s Z/k·…: 1e-16 · 0.23 · 2500 · 2N√(km) is 1e-12 N a sample, a thousand times.
        assert!(
            (estimate.output - output).abs() < 1e-9 * peak && (estimate.surprise).abs() < 1e-9 * peak,
            "{estimate:?} {output}"
        );
    }
    assert!(peak > 1.0, "a drive that does nothing proves nothing");
}

#[test]
fn a_filter_finds_the_far_force_of_an_impact_that_it_was_not_told_of() {
    let spring = sampled();
    let run = run(&spring, &Excitation::impact(0.23, 0.25).unwrap(), 1.0);
    let filter = modal_kalman::<3>(&spring, &KalmanNoise { ringing: 4.0, ..NOISE }).unwrap();
    let mut state = filter.settled(&at_rest(spring.spring(), 0.23));
    let errors: Vec<f64> =
        run.measured.iter().zip(&run.output).map(|(m, output)| filter.step(&mut state, m).output - output).collect();
    let rms = |errors: &[f64]| (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
    let untold = rms(&run.output.iter().map(|f| f - spring.spring().static_force(0.23)).collect::<Vec<_>>());
    // What three modes cannot hold of a square wave is Σ_{n = 5, 7, …} 8/(πn)² = 10 % of its power: a third of its rms.
    assert!(rms(&errors[250..]) < 0.5 * untold, "{} of {untold}", rms(&errors[250..]));
}

#[test]
fn waves_find_it_too_but_for_the_dispersion_of_the_windings() {
    let spring = sampled();
    let run = run(&spring, &Excitation::impact(0.23, 0.25).unwrap(), 1.0);
    let observer = delay_line_observer(&spring, 1.0).unwrap();
    let mut state = observer.settled::<32>(&at_rest(spring.spring(), 0.23));
    let pairs = run.measured.iter().zip(&run.output).map(|(m, output)| (observer.step(&mut state, m), *output));
    let pairs: Vec<(f64, f64)> = pairs.collect();
    let still = spring.spring().static_force(0.23);
    let power = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
    let error = power(&mut pairs[24..].iter().map(|(ours, truth)| ours - truth));
    let whole = power(&mut pairs[24..].iter().map(|(_, truth)| truth - still));
    // Damping that takes more of higher modes than λ says, and fronts rounded by the chain: some per cent of the power.
    assert!(error < 0.1 * whole, "{}", error / whole);
}

/// Largest |eigenvalue| of Φ(I − Kh): how long a filter remembers an error.
fn radius<const MODES: usize>(filter: &ModalKalman<f64, MODES>) -> f64 {
    let size = 2 * MODES + 1;
    let mut transition = DMatrix::identity(size, size);
    let (mut gain, mut measured) = (DVector::zeros(size), DVector::zeros(size));
    for (index, mode) in filter.modes.iter().enumerate() {
        transition.view_mut((2 * index, 2 * index), (2, 2)).copy_from(&DMatrix::from_row_slice(
            2,
            2,
            mode.turn.as_flattened(),
        ));
        (gain[2 * index], gain[2 * index + 1]) = (mode.gain[0], mode.gain[1]);
        measured[2 * index] = mode.input;
    }
    (gain[size - 1], measured[size - 1]) = (filter.bias_gain, 1.0);
    let closed = &transition * (DMatrix::identity(size, size) - gain * measured.transpose());
    closed.complex_eigenvalues().iter().map(|value| value.norm()).fold(0.0, f64::max)
}

#[test]
fn filters_forget_on_every_spring_of_the_box_even_without_damping() {
    let tolerances = ToleranceBox::new(0.1, 0.1).unwrap();
    for corner in tolerances.corners() {
        let spring = ToleranceBox::changed(&paper_springs::s_t(), corner).unwrap();
        for (ratio, ringing) in [(0.0, 0.05), (0.0, 5.0), (0.02, 0.5)] {
            let filter =
                modal_kalman::<3>(&sampled_at(&spring, ratio, 2500.0), &KalmanNoise { ringing, ..NOISE }).unwrap();
            assert!(radius(&filter) < 1.0 - 1e-5, "{corner:?}: {}", radius(&filter));
        }
    }
}

/// Rms of F_o's error over that of F_i's ringing while mode 1 of a spring without damping rings alone, once the filter has found it.
fn found<const MODES: usize>(filter: &ModalKalman<f64, MODES>, spring: &Spring) -> f64 {
    let omega = coilsense::modes::ChainModes::of(spring).frequencies()[0] / 2500.0;
    let rest = at_rest(spring, 0.23);
    let mut state = filter.settled(&rest);
    let (mut error, mut whole) = (0.0, 0.0);
    for sample in 0..30_000 {
        let wave = (omega * f64::from(sample)).cos();
        let estimate = filter.step(&mut state, &Measured { force: rest.force + wave, ends: rest.ends });
        // An odd mode pulls at end 2 the other way.
        if sample >= 20_000 {
            error += (estimate.output - (rest.force - wave)).powi(2);
            whole += wave * wave;
        }
    }
    (error / whole).sqrt()
}

#[test]
fn no_spring_of_the_box_rings_past_the_bound_and_some_come_near_it() {
    let spring = sampled();
    let noise = KalmanNoise { shock: 0.15, ringing: 2.0, ..NOISE };
    let filter = modal_kalman::<3>(&spring, &noise).unwrap();
    let tolerances = ToleranceBox::new(0.1, 0.1).unwrap();
    let bound = ringing_error_bound(&filter, &spring, &tolerances).unwrap();
    let springs = (0..=20).flat_map(|a| (0..=4).map(move |b| [f64::from(a) / 100.0 - 0.1, f64::from(b) / 20.0 - 0.1]));
    let worst = springs
        .map(|change| found(&filter, &ToleranceBox::changed(spring.spring(), change).unwrap()))
        .fold(0.0, f64::max);
    // The passport's 0.01, and as much again for springs that fall between the frequency that is worst.
    assert!(worst <= bound[0] && worst > bound[0] - 0.02, "{worst} against {bound:?}");
    // The very spring is found without an error but for what the bias takes for slow ringing.
    let narrow = ringing_error_bound(&filter, &spring, &ToleranceBox::new(1e-4, 1e-4).unwrap()).unwrap();
    assert!(narrow[0] < 0.15 * bound[0], "{narrow:?} against {bound:?}");
}

#[test]
fn each_member_of_a_bank_has_a_cell_of_the_box_in_which_it_is_less_wrong_than_one_filter_over_all_of_it() {
    let spring = sampled();
    let noise = KalmanNoise { shock: 0.15, ringing: 0.1, ..NOISE };
    let whole = ToleranceBox::new(0.1, 0.1).unwrap();
    let cell = ToleranceBox::new(0.0, 0.034).unwrap();
    let filter = modal_kalman::<5>(&spring, &noise).unwrap();
    let over_all = ringing_error_bound(&filter, &spring, &whole).unwrap();
    let in_cell = ringing_error_bound(&filter, &spring, &cell).unwrap();
    // Seven frequencies over ±10 %: cells of ±1.7 %, a sixth of the box.
    assert!(in_cell.iter().zip(&over_all).all(|(cell, all)| cell < all), "{in_cell:?} against {over_all:?}");
}

#[test]
fn a_bank_follows_a_frequency_that_no_single_filter_was_made_for() {
    let spring = sampled();
    let tolerances = ToleranceBox::new(0.1, 0.1).unwrap();
    let design =
        BankDesign { noise: KalmanNoise { ringing: 0.3, ..NOISE }, stiffnesses: 1, memory: 0.1, sharpness: 40.0 };
    let bank = observer_bank::<3, 9>(&spring, &tolerances, &design).unwrap();
    let single = modal_kalman::<3>(&spring, &design.noise).unwrap();
    assert_eq!(bank.members[4].modes, single.modes, "the middle is the nominal spring");
    let true_spring = ToleranceBox::changed(spring.spring(), [0.0, 0.1]).unwrap();
    let run = run(&sampled_at(&true_spring, 0.005, 2500.0), &Excitation::impact(0.23, 0.25).unwrap(), 1.0);
    let rest = at_rest(&true_spring, 0.23);
    let (mut of_bank, mut of_single) = (bank.settled(&rest), single.settled(&rest));
    let (mut by_bank, mut by_single) = (0.0, 0.0);
    for (measured, output) in run.measured.iter().zip(&run.output) {
        by_bank += (bank.step(&mut of_bank, measured).output - output).powi(2);
        by_single += (single.step(&mut of_single, measured).output - output).powi(2);
    }
    // No noise here: the single one slips by half a turn in ten periods, the nearest member of nine by 1 % of a turn a period.
    assert!(by_bank < 0.5 * by_single, "{by_bank} against {by_single}");
}

#[test]
fn a_bank_over_stiffnesses_follows_a_slow_motion_of_a_spring_that_is_stiffer_than_it_says() {
    let spring = sampled();
    let tolerances = ToleranceBox::new(0.1, 0.1).unwrap();
    let noise = KalmanNoise { ringing: 0.1, ..NOISE };
    let design = BankDesign { noise, stiffnesses: 3, memory: 0.1, sharpness: 40.0 };
    let of_both = observer_bank::<3, 9>(&spring, &tolerances, &design).unwrap();
    let of_frequency = observer_bank::<3, 9>(&spring, &tolerances, &BankDesign { stiffnesses: 1, ..design }).unwrap();
    assert_eq!(of_both.members[4].modes, of_frequency.members[4].modes, "both hold the nominal spring in their middle");
    let true_spring = ToleranceBox::changed(spring.spring(), [0.1, 0.1]).unwrap();
    let drive = EndInput::harmonic(0.005, 1.5, 0.0);
    let excitation = Excitation::new(0.23, drive, EndInput::Held, Start::Rest).unwrap();
    let run = run(&sampled_at(&true_spring, 0.005, 2500.0), &excitation, 2.0);
    let rest = at_rest(&true_spring, 0.23);
    let (mut both, mut one) = (of_both.settled(&rest), of_frequency.settled(&rest));
    let (mut by_both, mut by_one) = (0.0, 0.0);
    for (measured, output) in run.measured.iter().zip(&run.output) {
        by_both += (of_both.step(&mut both, measured).output - output).powi(2);
        by_one += (of_frequency.step(&mut one, measured).output - output).powi(2);
    }
    // k off by 10 % of 3.8 N at 1.5 Hz is what a slow bias lags behind; a member of the right k has nothing to lag behind.
    assert!(by_both < 0.5 * by_one, "{by_both} against {by_one}");
}

#[test]
fn fusion_takes_the_offset_of_a_load_cell_away_and_keeps_its_speed() {
    let fusion = inductance_fusion(1.0, 25.0, 0.02, 2500.0).unwrap();
    let mut state = fusion.settled::<64>(100.0, 100.0);
    let mut last = (0.0, 0.0);
    for sample in 0..25_000 {
        let force =
            |late: f64| 96.0 + 3.0 * (std::f64::consts::TAU * 10.0 * ((f64::from(sample) - late) / 2500.0)).sin();
        let slow = (sample % 100 == 0).then(|| force(50.0));
        last = (fusion.step(&mut state, force(0.0) + 4.0, slow), force(0.0));
    }
    // The slow force is as late as is said, so the bias settles on 4 N exactly: 0.78^250 is 1e-27.
    assert!((last.0 - last.1).abs() < 1e-10, "{last:?}");
}
