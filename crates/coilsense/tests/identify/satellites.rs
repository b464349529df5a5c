//! Lines of a coil that are no axial modes: its torsion, and sideways motion; and lines that only look like them.
//!
//! Next door: what looks like a spring (`lookalikes`), whose records these are.

use std::f64::consts::TAU;

use coilsense::identify::{Answer, Identification, Line, Meaning, ModeSeries};
use coilsense::{Channel, FarEnd, Signals};
use rand::RngExt;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

use crate::lookalikes::{Ringing, STIFFNESS, behind_cell, of, record_in, without};
use crate::records::bumped;

/// Noise \[N\] beside axial lines of 0.3 to 1 N: lines of 0.2 % of them are heard.
const NOISE: f64 = 2e-4;
/// √(E/2G) of steel.
const TORSION: f64 = 1.124;

/// Five hits of a random size each.
fn sizes(random: &mut Pcg64) -> Vec<f64> {
    (0..5).map(|_| random.random_range(0.4..1.0)).collect()
}

/// A line of `size` \[N\] at F_i, ±1 of that at F_o.
fn line(frequency: f64, size: f64, sign: f64, by_hit: &[f64]) -> Ringing {
    Ringing { frequency, ratio: 0.003, input: size, output: sign * size, by_hit: by_hit.to_vec() }
}

/// f1 \[Hz\] and five to nine axial modes of a coil of 60 windings between held ends, about 1 N at j = 1.
fn coil(random: &mut Pcg64) -> (f64, Vec<Ringing>) {
    let first = 20.0 * 6.0_f64.powf(random.random::<f64>());
    let by_hit = sizes(random);
    let quarter = std::f64::consts::FRAC_PI_2 / 60.0;
    let modes = (1..=random.random_range(5..10)).map(|j| {
        let size = random.random_range(0.3..1.0) / f64::from(j);
        let sign = if j % 2 == 1 { -1.0 } else { 1.0 };
        line(first * (f64::from(j) * quarter).sin() / quarter.sin(), size, sign, &by_hit)
    });
    (first, modes.collect())
}

/// One torsional line per axial mode, of 0.3 to 5 % of it.
fn torsion(axial: &[Ringing], random: &mut Pcg64) -> Vec<Ringing> {
    let share = 0.003 * (0.05_f64 / 0.003).powf(random.random::<f64>());
    axial
        .iter()
        .map(|mode| line(TORSION * mode.frequency, share * mode.input, mode.output.signum(), &mode.by_hit))
        .collect()
}

/// A pair of 0.2 % at 0.81 f1, 0.01 to 4 % apart.
fn lateral(first: f64, axial: &[Ringing], random: &mut Pcg64) -> Vec<Ringing> {
    let apart = 1e-4 * 400.0_f64.powf(random.random::<f64>());
    [1.0, 1.0 + apart]
        .map(|by| {
            line(0.81 * first * by, 0.002 * axial[0].input, if random.random() { 1.0 } else { -1.0 }, &sizes(random))
        })
        .into()
}

fn torsional(found: &Identification) -> Vec<&Line> {
    found.lines.iter().filter(|line| matches!(line.meaning, Meaning::Torsional { .. })).collect()
}

fn lateral_lines(found: &Identification) -> Vec<&Line> {
    found.lines.iter().filter(|line| line.meaning == Meaning::Lateral).collect()
}

/// The modes of a coil with more lines, at both ends and at F_o alone.
fn heard(mut lines: Vec<Ringing>, more: Vec<Ringing>, random: &mut Pcg64) -> [Identification; 2] {
    lines.extend(more);
    let both = record_in(&lines, STIFFNESS, NOISE, random);
    [of(&without(&both, Channel::InputForce)), of(&both)]
}

#[test]
fn a_line_as_strong_as_the_mode_beside_it_is_another_springs_and_no_torsion() {
    for seed in 0..4 {
        let mut random = Pcg64::seed_from_u64(200 + seed);
        let (_, axial) = coil(&mut random);
        let inner = sizes(&mut random);
        let nested =
            axial.iter().map(|mode| line(TORSION * mode.frequency, 0.9 * mode.input, mode.output.signum(), &inner));
        let nested = nested.collect();
        for found in heard(axial, nested, &mut random) {
            assert!(torsional(&found).is_empty(), "seed {seed}: {:?}", found.verdict);
        }
        // One line alone, too.
        let (first, axial) = coil(&mut random);
        let other = vec![line(TORSION * first, axial[0].input, 1.0, &inner)];
        for found in heard(axial, other, &mut random) {
            assert!(torsional(&found).is_empty(), "seed {seed}: {:?}", found.verdict);
        }
    }
}

#[test]
fn hum_beside_the_first_mode_does_not_decay_and_is_no_torsion() {
    let mut heard = 0;
    for seed in 0..4 {
        let mut random = Pcg64::seed_from_u64(300 + seed);
        let (first, axial) = coil(&mut random);
        let record = record_in(&axial, STIFFNESS, NOISE, &mut random);
        let mut signals = Signals::new(record.time().to_vec()).unwrap();
        for channel in [Channel::InputForce, Channel::OutputForce] {
            let hum = |t: &f64| 0.02 * axial[0].input * (TAU * 1.12 * first * t).sin();
            let values = record.channel(channel).unwrap().iter().zip(record.time()).map(|(x, t)| x + hum(t));
            signals.insert(channel, values.collect()).unwrap();
        }
        for signals in [without_position(&signals, Channel::InputForce), signals] {
            let found = of(&signals);
            assert!(torsional(&found).is_empty(), "seed {seed}: {:?}", found.verdict);
            assert!((found.first_frequency.unwrap().value / first - 1.0).abs() < 1e-3);
            for line in found.lines.iter().filter(|line| (line.frequency.value / (1.12 * first) - 1.0).abs() < 1e-3) {
                assert!(line.reason.starts_with("steady"), "seed {seed}: {line:?}");
                heard += 1;
            }
        }
    }
    assert!(heard >= 4, "{heard}");
}

/// One force alone.
fn without_position(signals: &Signals, gone: Channel) -> Signals {
    let mut rest = Signals::new(signals.time().to_vec()).unwrap();
    for channel in [Channel::InputForce, Channel::OutputForce] {
        if channel != gone {
            rest.insert(channel, signals.channel(channel).unwrap().to_vec()).unwrap();
        }
    }
    rest
}

#[test]
fn quarter_waves_of_torsion_are_named_together_and_one_alone_is_not() {
    for seed in 0..4 {
        let mut random = Pcg64::seed_from_u64(400 + seed);
        let (first, axial) = coil(&mut random);
        let size = 0.01 * axial[0].input;
        let quarter = |over: f64, by_hit: &[f64]| line(over * first, size, 1.0, by_hit);
        let by_hit = axial[0].by_hit.clone();
        for (overs, named) in [(vec![0.5614], 0), (vec![1.6846], 0), (vec![0.5614, 1.6846], 2)] {
            let more = overs.iter().map(|over| quarter(*over, &by_hit)).collect();
            let own =
                axial.iter().map(|mode| line(mode.frequency, mode.input, mode.output.signum(), &by_hit)).collect();
            for found in heard(own, more, &mut random) {
                assert_eq!(found.verdict.answer, Answer::Spring);
                assert_eq!(torsional(&found).len(), named, "seed {seed}, {overs:?}: {:?}", found.verdict);
                let said = found.verdict.evidence.iter().any(|line| line.contains("torsion with an end that turns"));
                assert_eq!(said, named == 2, "{:?}", found.verdict.evidence);
            }
        }
    }
}

#[test]
fn modes_keep_their_names_where_the_end_carries_a_mass_or_is_free() {
    // m/M at which mode 2 of the loaded coil lies at 1.124 f1 of the held one, and mode 3 at 2.25 f1.
    for over in [TORSION, 2.25] {
        let beta = std::f64::consts::PI * over;
        let mass_ratio = beta * beta.tan();
        for seed in 0..3 {
            let mut random = Pcg64::seed_from_u64(500 + seed);
            let first = random.random_range(25.0..70.0);
            let by_hit = sizes(&mut random);
            let lines: Vec<Ringing> = (1..9)
                .map(|j| {
                    let own = ModeSeries::EndMass { mass_ratio }.multiple(j, f64::INFINITY);
                    // The wall pulls by 1/cos β of the mass's inertia force.
                    let input = random.random_range(0.3..1.0) / j as f64;
                    Ringing {
                        output: -input * (std::f64::consts::PI * own).cos(),
                        ..line(own * first, input, 1.0, &by_hit)
                    }
                })
                .collect();
            let count = lines.len();
            for found in heard(lines, Vec::new(), &mut random) {
                assert!(
                    torsional(&found).is_empty() && lateral_lines(&found).is_empty(),
                    "{over}: {:?}",
                    found.verdict
                );
                let modes = found.lines.iter().filter(|line| line.mode().is_some()).count();
                assert!(found.verdict.answer != Answer::Spring || modes == count, "{over}, seed {seed}: {modes} modes");
            }
        }
    }
    for far_end in [FarEnd::Force, FarEnd::Mass(0.05), FarEnd::Mass(0.5)] {
        let found = of(&bumped(far_end, 2500.0));
        assert_eq!(found.verdict.answer, Answer::Spring);
        assert!(torsional(&found).is_empty() && lateral_lines(&found).is_empty(), "{far_end:?}: {:?}", found.verdict);
    }
}

/// So many coils, each alone and behind a load cell.
fn nothing_is_named(coils: u64) {
    for seed in 0..coils {
        let mut random = Pcg64::seed_from_u64(600 + seed);
        let (_, axial) = coil(&mut random);
        let alone = heard(axial, Vec::new(), &mut random);
        let cell = (2e5 * 30.0_f64.powf(random.random::<f64>()), 0.05 * 12.0_f64.powf(random.random::<f64>()));
        let behind = behind_cell(Some(cell), |_| 0.003, &mut random);
        let of_cell = heard(behind, Vec::new(), &mut random);
        for found in alone.iter().chain(&of_cell) {
            assert!(torsional(found).is_empty() && lateral_lines(found).is_empty(), "seed {seed}: {:?}", found.verdict);
        }
    }
}

#[test]
fn a_coil_alone_or_behind_a_cell_has_no_satellites() {
    nothing_is_named(5);
}

#[test]
#[ignore = "twice as many; `cargo xtask test --long` runs it"]
fn ten_coils_alone_or_behind_a_cell_have_no_satellites() {
    nothing_is_named(10);
}

#[test]
fn nothing_is_named_beside_lines_that_are_no_spring() {
    for seed in 0..6 {
        let mut random = Pcg64::seed_from_u64(700 + seed);
        // Two lines, and a third of 1 % at 1.124 times the lower.
        let frequency = random.random_range(30.0..90.0);
        let by_hit = sizes(&mut random);
        let lines = vec![line(frequency, 1.0, 0.7, &by_hit), line(3.7 * frequency, 0.5, 0.2, &sizes(&mut random))];
        let more = vec![line(TORSION * frequency, 0.01, 0.7, &by_hit)];
        for found in heard(lines, more, &mut random) {
            assert_ne!(found.verdict.answer, Answer::Spring, "seed {seed}");
            assert!(
                torsional(&found).is_empty() && lateral_lines(&found).is_empty(),
                "seed {seed}: {:?}",
                found.verdict
            );
        }
    }
}

#[test]
fn a_single_line_that_fits_nothing_stays_unnamed() {
    for seed in 0..4 {
        let mut random = Pcg64::seed_from_u64(800 + seed);
        let (first, axial) = coil(&mut random);
        let size = 0.05 * axial[0].input;
        let more = vec![line(1.37 * first, size, 1.0, &sizes(&mut random))];
        for found in heard(axial, more, &mut random) {
            assert!(
                torsional(&found).is_empty() && lateral_lines(&found).is_empty(),
                "seed {seed}: {:?}",
                found.verdict
            );
        }
    }
}

/// How the lines of logs with torsion, 0.3 to 5 % of each mode up to `most` \[1\], and a lateral pair are named.
#[derive(Default, Debug)]
struct Count {
    logs: usize,
    springs: usize,
    /// The line at 1.124 f1 is named, the modes are, and f1 is right.
    named: usize,
    /// Pairs 1 % apart and more, and how many of these are named.
    wide: usize,
    pairs: usize,
}

fn with_satellites(seeds: std::ops::Range<u64>) -> Count {
    let mut count = Count::default();
    for seed in seeds {
        let mut random = Pcg64::seed_from_u64(seed);
        let (first, axial) = coil(&mut random);
        let modes: Vec<f64> = axial.iter().map(|mode| mode.frequency).collect();
        let mut more = torsion(&axial, &mut random);
        let pair = lateral(first, &axial, &mut random);
        let places = [pair[0].frequency, pair[1].frequency];
        more.extend(pair);
        for found in heard(axial, more, &mut random) {
            let near = |line: &Line, place: f64| (line.frequency.value / place - 1.0).abs() < 1e-3;
            let off = found.first_frequency.map_or(1.0, |own| (own.value / first - 1.0).abs());
            let right = |(n, place): (usize, &f64)| {
                found.lines.iter().any(|line| near(line, *place) && line.meaning == Meaning::Mode(n + 1))
            };
            let own = torsional(&found);
            let misnamed = own.iter().any(|line| modes.iter().any(|place| near(line, *place)))
                || lateral_lines(&found).iter().any(|line| !places.iter().any(|place| near(line, *place)));
            let first_named = own.iter().any(|line| {
                near(line, TORSION * first)
                    && line.meaning == Meaning::Torsional { mode: Some(1) }
                    && line.reason.starts_with("torsional: 1.124 f1 with ")
            });
            assert!(off < 0.01, "seed {seed}: f1 is {off} off, {:?}", found.verdict);
            assert!(!misnamed, "seed {seed}: {:?}", found.verdict);
            assert_eq!(found.mode_series, Some(ModeSeries::HeldHeld), "seed {seed}: {:?}", found.verdict);
            assert!(!found.verdict.evidence.iter().any(|line| line.contains("second coil")), "{:?}", found.verdict);
            count.logs += 1;
            count.springs += usize::from(found.verdict.answer == Answer::Spring);
            count.named += usize::from(first_named && modes.iter().enumerate().all(right));
            let wide = places[1] > 1.01 * places[0];
            count.wide += usize::from(wide);
            count.pairs += usize::from(wide && lateral_lines(&found).len() == 2);
        }
    }
    count
}

/// So many coils with torsion beside their modes, on two threads.
fn torsion_is_named(coils: u64) {
    let other = std::thread::spawn(move || with_satellites(coils / 2..coils));
    for count in [with_satellites(0..coils / 2), other.join().unwrap()] {
        println!("{count:?}");
        assert_eq!(count.springs, count.logs, "satellites do not count against the verdict");
        assert!(10 * count.named >= 9 * count.logs, "{count:?}"); // 77 of 80 when written
        // A line is 0.6 % wide: nearer pairs of 0.2 % of a mode are one line to a fit.
        assert!(10 * count.pairs >= 8 * count.wide, "{count:?}");
    }
}

#[test]
fn torsion_beside_the_modes_is_named_and_leaves_f1_alone() {
    torsion_is_named(20);
}

#[test]
#[ignore = "twice as many; `cargo xtask test --long` runs it"]
fn torsion_beside_the_modes_of_forty_coils_is_named() {
    torsion_is_named(40);
}

#[test]
fn loud_torsion_makes_no_end_mass_and_no_second_coil() {
    for seed in 0..8 {
        let mut random = Pcg64::seed_from_u64(900 + seed);
        let (first, axial) = coil(&mut random);
        let share = random.random_range(0.05..0.095);
        let line_of =
            |mode: &Ringing| line(TORSION * mode.frequency, share * mode.input, mode.output.signum(), &mode.by_hit);
        let more: Vec<Ringing> = axial.iter().map(line_of).collect();
        for found in heard(axial, more, &mut random) {
            assert_eq!(found.verdict.answer, Answer::Spring, "seed {seed}: {:?}", found.verdict);
            assert_eq!(found.mode_series, Some(ModeSeries::HeldHeld), "seed {seed}: {:?}", found.verdict);
            assert!((found.first_frequency.unwrap().value / first - 1.0).abs() < 1e-3, "seed {seed}");
            assert!(torsional(&found).len() > 2, "seed {seed}: {:?}", found.verdict);
            assert!(!found.verdict.evidence.iter().any(|line| line.contains("second coil")), "{:?}", found.verdict);
        }
    }
}

#[test]
fn a_pair_beside_the_series_is_lateral_and_said() {
    let mut random = Pcg64::seed_from_u64(9);
    let (first, axial) = coil(&mut random);
    let by_hit = sizes(&mut random);
    let size = 0.002 * axial[0].input;
    let more = vec![line(0.81 * first, size, 1.0, &by_hit), line(0.826 * first, size, -1.0, &sizes(&mut random))];
    for found in heard(axial, more, &mut random) {
        let own = lateral_lines(&found);
        assert_eq!(own.len(), 2, "{:?}", found.verdict);
        assert!(own.iter().all(|line| line.reason.starts_with("lateral (pair): ")), "{own:?}");
        assert!(
            found
                .verdict
                .evidence
                .iter()
                .any(|line| line.contains("sideways") && line.contains("not in the axial series"))
        );
    }
}
