//! Logs that look like a spring's and are none, and springs that look like others: behind a load cell, with a sign turned, under a wrong hint.
//!
//! The lines are made here, from eigenvalues of their own chains or of nothing at all; next door: what else rings (`strangers`).

use std::f64::consts::TAU;

use coilsense::identify::{Answer, Identification, Settings};
use coilsense::{Channel, Signals};
use nalgebra::{DMatrix, SymmetricEigen};
use rand::RngExt;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

use crate::records::{RATE, noisy};

/// f1 \[Hz\], k \[N/m\], m \[kg\] of S_T with both ends held, and masses of the chains below.
pub(crate) const STIFFNESS: f64 = 760.0;
const MASS: f64 = 0.065;
const MASSES: usize = 100;

fn first() -> f64 {
    let quarter = std::f64::consts::FRAC_PI_2 / MASSES as f64;
    2.0 * MASSES as f64 * (STIFFNESS / MASS).sqrt() * quarter.sin() / TAU
}

/// One line: f \[Hz\], ζ, and what it pulls at F_i and F_o per unit of a hit, by hit.
pub(crate) struct Ringing {
    pub(crate) frequency: f64,
    pub(crate) ratio: f64,
    pub(crate) input: f64,
    pub(crate) output: f64,
    pub(crate) by_hit: Vec<f64>,
}

/// Twenty seconds of lines after five hits, on a slow pull of 1 mm at end 1 against k, 20 N of preload, 0.01 N of noise.
pub(crate) fn record(lines: &[Ringing], stiffness: f64, random: &mut Pcg64) -> Signals {
    record_in(lines, stiffness, 0.01, random)
}

/// The same in another noise \[N\].
pub(crate) fn record_in(lines: &[Ringing], stiffness: f64, noise: f64, random: &mut Pcg64) -> Signals {
    let times: Vec<f64> = (0..50_000).map(|n| n as f64 / RATE).collect();
    let slow = |t: f64| 1e-3 * (TAU * 0.3 * t).sin();
    let mut forces = [(); 2].map(|()| times.iter().map(|t| 20.0 - stiffness * slow(*t)).collect::<Vec<f64>>());
    for hit in 0..5 {
        let start = 0.8 + 3.8 * hit as f64 + 0.5 * random.random::<f64>();
        for line in lines {
            let angular = TAU * line.frequency;
            let from = (start * RATE).ceil() as usize;
            let lasting = (12.0 / (line.ratio * angular) * RATE) as usize;
            for n in from..(from + lasting).min(times.len()) {
                let since = times[n] - start;
                let swing = line.by_hit[hit] * (-line.ratio * angular * since).exp() * (angular * since).sin();
                forces[0][n] += line.input * swing;
                forces[1][n] += line.output * swing;
            }
        }
    }
    let mut signals = Signals::new(times.clone()).unwrap();
    let [input, output] = forces;
    signals.insert(Channel::InputForce, noisy(input, 0.0, noise, random)).unwrap();
    signals.insert(Channel::OutputForce, noisy(output, 0.0, noise, random)).unwrap();
    let motion = times.iter().map(|t| slow(*t)).collect();
    signals.insert(Channel::U1, noisy(motion, 0.0, 1e-6, random)).unwrap();
    signals
}

/// Without one force.
pub(crate) fn without(signals: &Signals, gone: Channel) -> Signals {
    let mut rest = Signals::new(signals.time().to_vec()).unwrap();
    for channel in [Channel::InputForce, Channel::OutputForce, Channel::U1] {
        if channel != gone {
            rest.insert(channel, signals.channel(channel).unwrap().to_vec()).unwrap();
        }
    }
    rest
}

/// The modes of S_T's chain between end 1 and a load cell of stiffness \[N/m\] and mass \[kg\] that stands on the ground, struck at one place.
pub(crate) fn behind_cell(cell: Option<(f64, f64)>, ratio: impl Fn(f64) -> f64, random: &mut Pcg64) -> Vec<Ringing> {
    let count = MASSES + usize::from(cell.is_some());
    let (link, half) = (MASSES as f64 * STIFFNESS, 2.0 * MASSES as f64 * STIFFNESS);
    let mut masses = vec![MASS / MASSES as f64; MASSES];
    let mut matrix = DMatrix::<f64>::zeros(count, count);
    for n in 1..MASSES {
        matrix[(n, n)] += link;
        matrix[(n - 1, n - 1)] += link;
        matrix[(n, n - 1)] -= link;
        matrix[(n - 1, n)] -= link;
    }
    matrix[(0, 0)] += half;
    matrix[(MASSES - 1, MASSES - 1)] += half;
    if let Some((stiffness, mass)) = cell {
        masses.push(mass);
        matrix[(MASSES, MASSES)] += half + stiffness;
        matrix[(MASSES, MASSES - 1)] -= half;
        matrix[(MASSES - 1, MASSES)] -= half;
    }
    let root: Vec<f64> = masses.iter().map(|mass| mass.sqrt()).collect();
    let scaled = DMatrix::from_fn(count, count, |row, column| matrix[(row, column)] / (root[row] * root[column]));
    let modes = SymmetricEigen::new(scaled);
    let struck = random.random_range(5..MASSES - 5);
    let sizes: Vec<f64> = (0..5).map(|_| random.random_range(0.4..1.0)).collect();
    (0..count)
        .filter_map(|mode| {
            let angular = modes.eigenvalues[mode].max(0.0).sqrt();
            let frequency = angular / TAU;
            let shape = |node: usize| modes.eigenvectors[(node, mode)] / root[node];
            // A blow of 15 mN s that lasts a millisecond.
            let soft = (-0.5 * (angular * 4e-4_f64).powi(2)).exp();
            let gain = 0.015 * soft * shape(struck) / angular;
            let output = cell.map_or(-half * shape(MASSES - 1), |(stiffness, _)| -stiffness * shape(MASSES));
            (frequency < 0.4 * RATE).then(|| Ringing {
                frequency,
                ratio: ratio(frequency),
                input: gain * half * shape(0),
                output: gain * output,
                by_hit: sizes.clone(),
            })
        })
        .collect()
}

pub(crate) fn of(signals: &Signals) -> Identification {
    Identification::of(signals, &Settings::default()).unwrap()
}

/// Whether an answer claims a spring whose f1 is more than 1 % off.
fn wrong(found: &Identification) -> bool {
    let off = found.first_frequency.map_or(f64::INFINITY, |one| (one.value / first() - 1.0).abs());
    found.verdict.answer == Answer::Spring && off > 0.01
}

#[test]
fn a_load_cell_that_resonates_does_not_move_the_springs_first_mode() {
    let (mut found_both, mut troubles) = (0, Vec::new());
    for seed in 0..16 {
        let mut random = Pcg64::seed_from_u64(seed);
        let stiffness = 2e5 * 30.0_f64.powf(random.random::<f64>());
        let mass = 0.05 * 12.0_f64.powf(random.random::<f64>());
        let viscous = seed % 2 == 1;
        let ratio = move |frequency: f64| if viscous { 0.003 * first() / frequency + 2e-4 } else { 0.003 };
        let lines = behind_cell(Some((stiffness, mass)), ratio, &mut random);
        let signals = record(&lines, STIFFNESS, &mut random);
        let both = of(&signals);
        found_both += usize::from(both.verdict.answer == Answer::Spring && !wrong(&both));
        let one = of(&without(&signals, Channel::InputForce));
        for (found, forces) in [(&both, "both forces"), (&one, "F_o")] {
            if wrong(found) || found.verdict.answer == Answer::NotTheSpring {
                let first = found.first_frequency.map(|one| one.value);
                troubles.push(format!(
                    "cell {stiffness:.0} N/m, {mass:.3} kg, {forces}: {first:?} Hz, {:?}",
                    found.verdict
                ));
            }
        }
    }
    assert!(troubles.is_empty(), "{}", troubles.join("\n"));
    assert!(found_both >= 12, "{found_both} of 16 are found with both forces");
}

#[test]
fn a_turned_sign_is_found_and_turned_when_asked() {
    let mut random = Pcg64::seed_from_u64(5);
    let lines = behind_cell(None, |_| 0.003, &mut random);
    let right = record(&lines, STIFFNESS, &mut random);
    assert!(of(&right).turned.is_none() && !of(&right).opposed, "nothing is turned there");
    for channel in [Channel::InputForce, Channel::OutputForce] {
        let mut signals = right.clone();
        signals.insert(channel, right.channel(channel).unwrap().iter().map(|x| -x).collect()).unwrap();
        let found = of(&signals);
        assert_eq!(found.turned, Some(channel), "{:?}", found.verdict);
        assert!(!wrong(&found), "{:?}", found.verdict);
        assert!(found.verdict.evidence.iter().any(|line| line.contains(channel.name()) && line.contains("turned")));
        let turned = Identification::of(&signals, &Settings { turned: Some(channel), ..Settings::default() }).unwrap();
        assert!(turned.turned.is_none());
        assert_eq!(turned.verdict.answer, Answer::Spring, "{:?}", turned.verdict);
        assert!((turned.first_frequency.unwrap().value / first() - 1.0).abs() < 1e-4);
        assert!((turned.stiffness.unwrap().value() / STIFFNESS - 1.0).abs() < 0.01);
    }
    // Both forces turned: the stiffness says so, and does not speak of too little motion.
    let mut both = right.clone();
    for channel in [Channel::InputForce, Channel::OutputForce] {
        both.insert(channel, right.channel(channel).unwrap().iter().map(|x| -x).collect()).unwrap();
    }
    let found = of(&both);
    assert!(found.stiffness.as_ref().unwrap_err().contains("turned"), "{:?}", found.stiffness);
    assert_eq!(found.turned, Some(Channel::U1));
}

/// Lines that each cell hears as it likes.
fn unrelated(count: usize, random: &mut Pcg64) -> Vec<Ringing> {
    (0..count)
        .map(|_| Ringing {
            frequency: 20.0 * 45.0_f64.powf(random.random::<f64>()),
            ratio: 5e-4 * 20.0_f64.powf(random.random::<f64>()),
            input: random.random_range(-1.0..1.0),
            output: random.random_range(-1.0..1.0),
            by_hit: (0..5).map(|_| random.random_range(-1.0..1.0)).collect(),
        })
        .collect()
}

#[test]
fn lines_that_have_nothing_in_common_are_no_spring() {
    for count in [3, 5, 9, 15] {
        for seed in 0..12 {
            let mut random = Pcg64::seed_from_u64(100 * count + seed);
            let lines = unrelated(count as usize, &mut random);
            let signals = record(&lines, STIFFNESS, &mut random);
            for signals in [without(&signals, Channel::InputForce), signals] {
                let found = of(&signals);
                assert_ne!(found.verdict.answer, Answer::Spring, "{count} lines, seed {seed}: {:?}", found.verdict);
            }
        }
    }
}

#[test]
fn multiples_of_one_motion_are_no_spring() {
    for seed in 0..8 {
        let mut random = Pcg64::seed_from_u64(500 + seed);
        let frequency = random.random_range(35.0..110.0);
        let ratio = 5e-4 * 20.0_f64.powf(random.random::<f64>());
        let sizes: Vec<f64> = (0..5).map(|_| random.random_range(0.4..1.0)).collect();
        // r + a r² + b r³ of one decaying motion, in phase on both cells.
        let lines: Vec<Ringing> = [(1.0, 1.0), (2.0, 0.03), (3.0, 0.02)]
            .map(|(n, size)| Ringing {
                frequency: n * frequency,
                ratio,
                input: size,
                output: 0.8 * size,
                by_hit: sizes.iter().map(|own: &f64| own.powf(n)).collect(),
            })
            .into();
        let found = of(&record(&lines, STIFFNESS, &mut random));
        assert_ne!(found.verdict.answer, Answer::Spring, "seed {seed}, {frequency} Hz: {:?}", found.verdict);
    }
    // Exact multiples of 83 Hz, each with a decay of its own, at one cell.
    let mut random = Pcg64::seed_from_u64(83);
    let lines: Vec<Ringing> = (1..=9)
        .map(|n| Ringing {
            frequency: 83.0 * f64::from(n),
            ratio: 0.002,
            input: 1.0 / f64::from(n),
            output: 1.0 / f64::from(n),
            by_hit: vec![1.0; 5],
        })
        .collect();
    let signals = without(&record(&lines, STIFFNESS, &mut random), Channel::InputForce);
    for windings in [None, Some(8.0), Some(12.0), Some(20.0), Some(30.0)] {
        let found = Identification::of(&signals, &Settings { windings, ..Settings::default() }).unwrap();
        assert_ne!(found.verdict.answer, Answer::Spring, "N {windings:?}: {:?}", found.verdict);
    }
}

#[test]
fn a_beam_is_no_spring() {
    for seed in 0..8 {
        let mut random = Pcg64::seed_from_u64(900 + seed);
        let first = random.random_range(12.0..24.0);
        let lines: Vec<Ringing> = [1.0, 6.267, 17.547, 34.386]
            .map(|ratio| Ringing {
                frequency: first * ratio,
                ratio: 0.003,
                input: random.random_range(-1.0..1.0),
                output: random.random_range(-1.0..1.0),
                by_hit: (0..5).map(|_| random.random_range(0.4..1.0)).collect(),
            })
            .into();
        let found = of(&record(&lines, STIFFNESS, &mut random));
        assert_ne!(found.verdict.answer, Answer::Spring, "seed {seed}: {:?}", found.verdict);
    }
}

#[test]
fn windings_that_the_lines_contradict_are_left_out_and_that_is_said() {
    let spring = coilsense::Spring::new(coilsense::SpringParameters {
        windings: 15.0,
        ..crate::paper_springs::s_t().parameters().clone()
    })
    .unwrap();
    let truth = crate::records::hit(&spring, 0.004, 3, [0.0; 3]);
    let found = Identification::of(&truth.signals, &Settings { windings: Some(52.0), ..Settings::default() }).unwrap();
    let off = found.first_frequency.unwrap().value / truth.frequency - 1.0;
    assert!(off.abs() < 1e-3, "f1 is {off:e} off");
    assert!(
        found.verdict.evidence.iter().any(|line| line.contains("contradict") && line.contains("52")),
        "{:?}",
        found.verdict
    );
    assert!((found.mass.unwrap().value / 0.065 - 1.0).abs() < 0.02, "{:?}", found.mass);
}

#[test]
fn a_coil_that_is_continuous_has_its_own_mass_whatever_windings_are_said() {
    // As good as continuous: where the lines contradict what was said, no chain's factor stays in the mass.
    let spring = coilsense::Spring::new(coilsense::SpringParameters {
        windings: 400.0,
        ..crate::paper_springs::s_t().parameters().clone()
    })
    .unwrap();
    let truth = crate::records::hit(&spring, 0.004, 3, [0.0; 3]);
    for said in [5.35, 8.0] {
        let settings = Settings { windings: Some(said), ..Settings::default() };
        let found = Identification::of(&truth.signals, &settings).unwrap();
        assert!(found.windings_left_out, "{said}: {:?}", found.verdict);
        let mass = found.mass.unwrap();
        assert!((mass.value / 0.065 - 1.0).abs() < 2e-3, "{said}: {mass:?}, {:?}", found.fitted_windings);
    }
}

#[test]
fn the_way_and_the_mass_of_a_coil_of_few_windings_are_right_whether_they_are_told_or_fitted() {
    // A chain of ten has its first line 0.41 % below that of a continuous coil: taken for one, its mass was 0.83 % too large.
    let spring = coilsense::Spring::new(coilsense::SpringParameters {
        windings: 10.0,
        ..crate::paper_springs::s_t().parameters().clone()
    })
    .unwrap();
    let truth = crate::records::hit(&spring, 0.004, 5, [0.0; 3]);
    for windings in [None, Some(10.0)] {
        let found = Identification::of(&truth.signals, &Settings { windings, ..Settings::default() }).unwrap();
        let (time, mass) = (found.transit_time.unwrap(), found.mass.unwrap());
        let off = time.value / spring.transit_time() - 1.0;
        assert!(off.abs() < 2e-4, "{windings:?}: τ is {off:e} off, {:?}", found.fitted_windings);
        assert!((time.value - spring.transit_time()).abs() < 2.0 * time.expanded, "{windings:?}: {time:?}");
        assert!((mass.value / 0.065 - 1.0).abs() < 2e-3, "{windings:?}: {mass:?}");
    }
}
