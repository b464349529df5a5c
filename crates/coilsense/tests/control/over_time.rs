//! Runs over time: every drive, load, force and estimator, beside the exponential of the masses' equations and beside the limit over frequency.

use std::f64::consts::TAU;

use coilsense::control::{
    Controller, Drive, Environment, Estimator, ForceLoop, Gains, OverTime, Plant, Run, SampledLoop, simulate,
};
use coilsense::mitigation::{KalmanNoise, SampledSpring, modal_kalman, notch};
use coilsense::{Channel, Damping, Spring};
use coilsense_rt::Cascade;

use crate::paper_springs::{s_t, s_t_with};

/// Rows of a golden file. A missing file fails.
fn golden(name: &str) -> Vec<csv::StringRecord> {
    let path = format!("{}/tests/golden/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(&path).expect(&path);
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect(&path)).collect();
    assert!(!rows.is_empty(), "{path} is empty");
    rows
}

/// A loop of `reference/force_loops.py`, on S_T with twelve windings.
struct Case {
    name: String,
    force_loop: ForceLoop,
    /// Zero of a continuous one.
    step: f64,
    notches: bool,
    limit: f64,
}

fn twelve() -> Spring {
    Spring::new(s_t_with(|parameters| parameters.windings = 12.0)).unwrap()
}

impl Case {
    fn of(row: &csv::StringRecord) -> Self {
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        let some = |column: usize| Some(number(column)).filter(|value| *value > 0.0);
        let drive = match &row[1] {
            "force" => Drive::Force { mass: number(8), friction: number(9), bandwidth: some(10) },
            _ => Drive::Velocity { bandwidth: some(10) },
        };
        let environment = match number(11) {
            0.0 => Environment::Held,
            _ => Environment::Impedance { mass: number(12), damping: number(13), stiffness: number(14) },
        };
        let gains = Gains {
            proportional: number(3),
            integral: number(4),
            derivative: number(5),
            derivative_bandwidth: some(6),
            observer_bandwidth: some(7),
            feed_forward: 0.0,
        };
        let force = Channel::FORCES.into_iter().find(|force| force.name() == &row[2]).unwrap();
        let plant = Plant::new(&twelve(), Damping::Modal(number(18)), drive, environment).unwrap();
        let force_loop = ForceLoop::new(plant, Controller::new(gains).unwrap(), force, number(16)).unwrap();
        Self { name: row[0].to_owned(), force_loop, step: number(15), notches: number(17) > 0.0, limit: number(19) }
    }

    fn all() -> Vec<Self> {
        golden("force_loops_cases").iter().map(Self::of).collect()
    }

    fn sampled(&self) -> SampledLoop {
        let sampled = SampledLoop::new(&self.force_loop, self.step).unwrap();
        if self.notches { sampled.behind(notches(self.step)).unwrap() } else { sampled }
    }
}

/// Notches at 54, 108 and 162 Hz.
fn notches(step: f64) -> Estimator {
    Estimator::Cascade(Cascade { sections: [54.0, 108.0, 162.0].map(|hertz| notch(hertz, 2.0, 1.0 / step).unwrap()) })
}

/// Rows t, F_i, F_o, fed back, command of a case.
fn instants(name: &str) -> Vec<[f64; 5]> {
    let rows = golden("force_loops").into_iter().filter(|row| &row[0] == name);
    let found: Vec<[f64; 5]> = rows.map(|row| std::array::from_fn(|index| row[index + 1].parse().unwrap())).collect();
    assert_eq!(found.len(), 40, "{name}");
    found
}

/// A run's series at a time, by a cubic through the four nearest samples.
fn at(run: &Run, time: f64) -> [f64; 4] {
    let step = run.time[1] - run.time[0];
    let from = (((time - run.time[0]) / step - 1.0).round().max(0.0) as usize).min(run.time.len() - 4);
    let share = |index: usize| {
        let others = (from..from + 4).filter(|other| *other != index);
        others.map(|other| (time - run.time[other]) / (run.time[index] - run.time[other])).product::<f64>()
    };
    [&run.input, &run.output, &run.fed_back, &run.command]
        .map(|series| (from..from + 4).map(|index| share(index) * series[index]).sum())
}

/// Largest difference of the first so many forces from the golden instants, over the largest of them; and of commands.
fn beside(run: &Run, name: &str, forces: usize) -> [f64; 2] {
    let rows = instants(name);
    let peak = |columns: std::ops::Range<usize>| {
        rows.iter().flat_map(|row| row[columns.clone()].to_vec()).fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    let (force, command) = (peak(1..4), peak(4..5));
    let mut worst = [0.0_f64; 2];
    for row in &rows {
        let ours = at(run, row[0]);
        for index in 0..forces {
            worst[0] = worst[0].max((ours[index] - row[index + 1]).abs() / force);
        }
        worst[1] = worst[1].max((ours[3] - row[4]).abs() / command);
    }
    worst
}

#[test]
fn sampled_runs_are_the_exponential_of_the_masses_equations() {
    let mut cases = 0;
    for case in Case::all().into_iter().filter(|case| case.step > 0.0) {
        let run = OverTime::sampled(&case.sampled()).unwrap().run(1.0, 1.0, 1200).unwrap();
        // The file has the force before the notches.
        let [force, command] = beside(&run, &case.name, if case.notches { 2 } else { 3 });
        println!("{}: forces {force:.1e}, command {command:.1e} of their peaks", case.name);
        // Double precision on both sides over 1200 steps. A controller of fifth order as one difference equation has three poles near z = 1,
        // of which its coefficients keep half the digits.
        let close = if case.force_loop.controller().gains().observer_bandwidth.is_some() { 1e-6 } else { 1e-9 };
        assert!(force < close && command < close, "{}: {force:e} {command:e}", case.name);
        cases += 1;
    }
    assert_eq!(cases, 10);
}

#[test]
fn continuous_runs_come_to_the_masses_equations_with_the_square_of_the_step() {
    let mut cases = 0;
    for case in Case::all().into_iter().filter(|case| case.step == 0.0) {
        let error = |most: f64| {
            let over_time = OverTime::continuous_within(&case.force_loop, most).unwrap();
            assert!(over_time.step() <= most);
            let samples = (0.62 / over_time.step()) as usize;
            beside(&over_time.run(1.0, 1.0, samples).unwrap(), &case.name, 3)[0]
        };
        let errors = [6e-5, 3e-5, 1.5e-5].map(error);
        let order = (errors[1] / errors[2]).log2();
        println!("{}: forces {:.1e} of their peak at 15 µs, order {order:.2}", case.name, errors[2]);
        assert!(errors[2] < 1e-4, "{}: {errors:?}", case.name);
        assert!((order - 2.0).abs() < 0.3, "{}: order {order}", case.name);
        cases += 1;
    }
    assert_eq!(cases, 3);
}

/// Whether a run at 0.5 % below a limit settles and at 0.5 % above it grows, at the frequency at which it should.
fn holds(over_time: &OverTime, limit: f64, frequency: f64, seconds: f64) -> [Option<f64>; 2] {
    let samples = (seconds / over_time.step()) as usize;
    [0.995, 1.005].map(|share| over_time.run(share * limit, 1.0, samples).unwrap().growth(frequency))
}

fn assert_limit(over_time: &OverTime, limit: f64, frequency: f64, seconds: f64, what: &str) {
    let growth = holds(over_time, limit, frequency, seconds);
    println!("{what}: limit {limit:.5} at {:.1} Hz, growth {growth:.3?}", frequency / TAU);
    let [below, above] = growth.map(|growth| growth.unwrap_or_else(|| panic!("{what}: the run is too short")));
    assert!(below < 1.0 && above > 1.0, "{what}: limit {limit} at {} Hz, growth {growth:?}", frequency / TAU);
}

#[test]
fn limits_over_frequency_are_those_of_the_closed_loops_matrix_and_hold_over_time() {
    for case in Case::all().into_iter().filter(|case| case.limit.is_finite()) {
        let (margins, over_time) = if case.step > 0.0 {
            let sampled = case.sampled();
            (sampled.margins().unwrap(), OverTime::sampled(&sampled).unwrap())
        } else {
            (case.force_loop.margins().unwrap(), OverTime::continuous(&case.force_loop).unwrap())
        };
        let off = margins.gain_limit / case.limit - 1.0;
        println!("{}: limit over frequency {off:.1e} off", case.name);
        // What copies of the spectrum leave that are not summed one by one, 1e-7 measured; the continuous loop has none.
        let close = if case.step > 0.0 { 1e-6 } else { 1e-9 };
        assert!(off.abs() < close, "{}: {} {}", case.name, margins.gain_limit, case.limit);
        assert_limit(&over_time, case.limit, margins.critical_frequency, 24.0, &case.name);
    }
}

const STEP: f64 = 4e-4;

fn force_loop(drive: Drive, environment: Environment, force: Channel, delay: f64) -> ForceLoop {
    let plant = Plant::new(&twelve(), Damping::Modal(0.01), drive, environment).unwrap();
    let gains = match drive {
        Drive::Velocity { .. } => Gains { proportional: 1.0 / 760.0, ..Gains::default() },
        Drive::Force { .. } => Gains { proportional: 0.1, integral: 1.0, ..Gains::default() },
    };
    ForceLoop::new(plant, Controller::new(gains).unwrap(), force, delay).unwrap()
}

#[test]
fn every_drive_and_sensor_loses_stability_over_time_where_predicted() {
    let drives = [
        Drive::IDEAL_VELOCITY,
        Drive::Velocity { bandwidth: Some(60.0) },
        // Faster than the sample rate: all but ideal.
        Drive::Velocity { bandwidth: Some(1e5) },
        Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None },
        Drive::Force { mass: 0.5, friction: 3.0, bandwidth: Some(250.0) },
    ];
    let mass = |mass| Environment::Impedance { mass, damping: 0.0, stiffness: 0.0 };
    let environments =
        [Environment::Held, mass(0.8), Environment::Impedance { mass: 0.3, damping: 4.0, stiffness: 300.0 }];
    let mut found = 0;
    for (drive, environment) in drives.into_iter().flat_map(|drive| environments.map(|meets| (drive, meets))) {
        for force in Channel::FORCES {
            let what = format!("{drive:?} {environment:?} {force:?}");
            let sampled = SampledLoop::new(&force_loop(drive, environment, force, STEP), STEP).unwrap();
            let margins = sampled.margins().unwrap();
            if margins.gain_limit > 0.0 && margins.gain_limit.is_finite() {
                let over_time = OverTime::sampled(&sampled).unwrap();
                assert_limit(&over_time, margins.gain_limit, margins.critical_frequency, 40.0, &what);
                found += 1;
            } else {
                println!("{what}: limit {}", margins.gain_limit);
            }
        }
    }
    assert!(found >= 45, "{found} of 60 with a limit");
}

#[test]
fn dashpots_at_the_ends_are_felt_over_time_as_over_frequency() {
    let damping = || Damping::StiffnessProportional { time: 1e-4 };
    let meets = |mass, damping| Environment::Impedance { mass, damping, stiffness: 0.0 };
    let mut jumps = 0;
    for drive in [Drive::IDEAL_VELOCITY, Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None }] {
        for environment in [Environment::Held, meets(0.8, 0.0), meets(0.8, 5.0), meets(0.0, 5.0)] {
            for force in Channel::FORCES {
                let plant = Plant::new(&twelve(), damping(), drive, environment).unwrap();
                let like = force_loop(drive, environment, force, STEP);
                let looped = ForceLoop::new(plant, *like.controller(), force, STEP).unwrap();
                let sampled = SampledLoop::new(&looped, STEP).unwrap();
                let margins = sampled.margins().unwrap();
                if margins.gain_limit.is_finite() && margins.gain_limit > 0.0 {
                    let over_time = OverTime::sampled(&sampled).unwrap();
                    let what = format!("{drive:?} {environment:?} {force:?}, dashpots");
                    assert_limit(&over_time, margins.gain_limit, margins.critical_frequency, 40.0, &what);
                    jumps += usize::from(drive == Drive::IDEAL_VELOCITY && force == Channel::InputForce);
                }
            }
        }
    }
    assert_eq!(jumps, 4);
}

#[test]
fn continuous_loops_lose_stability_over_time_where_predicted() {
    let drives = [
        Drive::Velocity { bandwidth: Some(60.0) },
        Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None },
        Drive::Force { mass: 1.0, friction: 20.0, bandwidth: Some(250.0) },
    ];
    let mut found = 0;
    for (drive, delay) in drives.into_iter().flat_map(|drive| [0.0, 1e-3].map(|delay| (drive, delay))) {
        for force in Channel::FORCES {
            let continuous = force_loop(drive, Environment::Held, force, delay);
            let margins = continuous.margins().unwrap();
            if margins.gain_limit.is_finite() && margins.gain_limit > 0.0 {
                let over_time = OverTime::continuous(&continuous).unwrap();
                let what = format!("{drive:?} {force:?}, {delay} s late");
                assert_limit(&over_time, margins.gain_limit, margins.critical_frequency, 40.0, &what);
                found += 1;
            }
        }
    }
    assert!(found >= 16, "{found} of 24 with a limit");
}

#[test]
fn estimators_run_on_every_drive_and_lose_stability_where_predicted() {
    let spring = SampledSpring::new(&twelve(), &Damping::Modal(0.01), 1.0 / STEP).unwrap();
    let noise = KalmanNoise { force: 0.24, shock: 0.15, ringing: 2.0, drift: 0.5 };
    let kalman = Estimator::Kalman(Box::new(modal_kalman(&spring, &noise).unwrap()));
    for drive in [
        Drive::Velocity { bandwidth: Some(60.0) },
        Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None },
        Drive::Force { mass: 1.0, friction: 20.0, bandwidth: Some(250.0) },
    ] {
        for (name, estimator) in [("notches", notches(STEP)), ("Kalman", kalman.clone())] {
            let plain =
                SampledLoop::new(&force_loop(drive, Environment::Held, Channel::InputForce, STEP), STEP).unwrap();
            let sampled = plain.behind(estimator).unwrap();
            let margins = sampled.margins().unwrap();
            let over_time = OverTime::sampled(&sampled).unwrap();
            let what = format!("{drive:?} behind {name}");
            assert_limit(&over_time, margins.gain_limit, margins.critical_frequency, 40.0, &what);
        }
    }
}

#[test]
fn an_estimator_is_refused_where_end_2_moves() {
    let mass = Environment::Impedance { mass: 1.0, damping: 0.0, stiffness: 0.0 };
    let motor = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None };
    let sampled = SampledLoop::new(&force_loop(motor, mass, Channel::InputForce, 0.0), STEP).unwrap();
    assert_eq!(sampled.behind(notches(STEP)).unwrap_err().to_string(), "signal u2 is missing");
}

#[test]
fn an_unstable_loop_says_when_it_ran_away_and_leaves_no_number_that_looks_settled() {
    for force in Channel::FORCES {
        let motor = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: Some(300.0) };
        let sampled = SampledLoop::new(&force_loop(motor, Environment::Held, force, STEP), STEP).unwrap();
        let limit = sampled.margins().unwrap().gain_limit;
        let run = simulate(&sampled, 20.0 * limit, 1.0, 200_000).unwrap();
        let away = run.ran_away_at.expect("it runs away");
        assert_eq!(run.time.len(), (away / STEP).round() as usize, "{force:?}: it ends there");
        assert!(run.output.iter().chain(&run.command).all(|value| value.is_finite()), "{force:?}");
        assert_eq!(run.growth(TAU * 54.0), Some(f64::INFINITY));
        // As it should, far below its limit.
        let run = simulate(&sampled, 0.2 * limit, 1.0, 20_000).unwrap();
        assert_eq!((run.ran_away_at, run.time.len()), (None, 20_000));
        assert!((run.fed_back[19_999] - 1.0).abs() < 0.02, "{force:?}: {}", run.fed_back[19_999]);
    }
}

#[test]
fn a_run_that_is_too_short_does_not_say_whether_it_grows() {
    let motor = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None };
    let sampled = SampledLoop::new(&force_loop(motor, Environment::Held, Channel::InputForce, STEP), STEP).unwrap();
    // Eight periods of 54 Hz in a quarter take 0.6 s in all.
    let run = |seconds: f64| simulate(&sampled, 1.0, 1.0, (seconds / STEP) as usize).unwrap().growth(TAU * 54.0);
    assert_eq!(run(0.5), None);
    assert!(run(0.7).is_some());
    assert_eq!(Run::default().growth(TAU * 54.0), None);
    // Nothing rings where nothing is asked for.
    assert_eq!(simulate(&sampled, 1.0, 0.0, 10_000).unwrap().growth(TAU * 54.0), None);
}

fn on_coil(drive: Drive, spring: &Spring) -> SampledLoop {
    let plant = Plant::new(spring, Damping::Modal(0.01), drive, Environment::Held).unwrap();
    let gains = Gains { proportional: 3.0 / 760.0, ..Gains::default() };
    let controller = Controller::new(gains).unwrap();
    SampledLoop::new(&ForceLoop::new(plant, controller, Channel::InductanceForce, STEP).unwrap(), STEP).unwrap()
}

#[test]
fn the_whole_inductance_comes_to_its_straight_line_with_the_size_of_the_motion() {
    let over_time = OverTime::sampled(&on_coil(Drive::IDEAL_VELOCITY, &s_t())).unwrap();
    let coil = over_time.clone().with_coil().unwrap();
    let apart = |reference: f64| {
        let [line, whole] = [&over_time, &coil].map(|over_time| over_time.run(1.0, reference, 1500).unwrap());
        let pairs = line.fed_back.iter().zip(&whole.fed_back);
        pairs.map(|(line, whole)| (line - whole).abs()).fold(0.0, f64::max) / reference
    };
    let [small, large] = [0.05, 0.5].map(apart);
    println!("F_L off its straight line by {small:.2e} of a step of 0.05 N, {large:.2e} of one of 0.5 N");
    // Of second order in the windings' motion: ten times the step, ten times the share.
    assert!((large / small / 10.0 - 1.0).abs() < 0.1, "{small:e} {large:e}");
    assert!(large < 1e-2);
}

#[test]
fn windings_that_touch_end_the_run_with_that_said() {
    let coil = OverTime::sampled(&on_coil(Drive::IDEAL_VELOCITY, &s_t())).unwrap().with_coil().unwrap();
    let run = coil.run(1.0, -130.0, 20_000).unwrap();
    let touched = run.touched_at.expect("a reference below the force of a solid coil");
    assert!(run.time.len() < 20_000 && touched > 0.0 && run.ran_away_at.is_none());
    assert_eq!(run.growth(TAU * 54.0), None);
}

#[test]
fn the_whole_inductance_is_of_f_l_alone() {
    let motor = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None };
    let of =
        |force| OverTime::sampled(&SampledLoop::new(&force_loop(motor, Environment::Held, force, 0.0), STEP).unwrap());
    assert_eq!(of(Channel::DeflectionForce).unwrap().with_coil().unwrap_err().to_string(), "signal F_L is missing");
    let continuous =
        OverTime::continuous(&force_loop(motor, Environment::Held, Channel::InductanceForce, 0.0)).unwrap();
    let text = continuous.with_coil().unwrap_err().to_string();
    assert!(text.starts_with("loop delay must be above zero where a continuous loop reads F_L"), "{text}");
}

#[test]
fn numbers_that_no_run_has_are_refused_by_name() {
    let motor = Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None };
    let looped = force_loop(motor, Environment::Held, Channel::InputForce, 1e-3);
    let within = |most: f64| OverTime::continuous_within(&looped, most).map(|_| ()).unwrap_err().to_string();
    assert!(within(0.0).starts_with("largest step must be above zero"), "{}", within(0.0));
    assert!(within(1e-8 / 1.5).starts_with("loop delay must be at most"), "{}", within(1e-8 / 1.5));
    let over_time = OverTime::continuous(&looped).unwrap();
    for (gain, reference, samples, expected) in [
        (f64::NAN, 1.0, 10, "gain factor must be finite and not below zero"),
        (-1.0, 1.0, 10, "gain factor must be finite and not below zero"),
        (1.0, f64::INFINITY, 10, "reference must be finite"),
        (1.0, 1.0, 20_000_000, "samples must be at most 10000000"),
    ] {
        let text = over_time.run(gain, reference, samples).unwrap_err().to_string();
        assert!(text.starts_with(expected), "{text}");
    }
    assert_eq!(over_time.run(1.0, 1.0, 0).unwrap(), Run::default());
}
