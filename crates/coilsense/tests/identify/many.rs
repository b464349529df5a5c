//! Many records of three springs: errors, coverage of the intervals, verdicts.

use std::sync::atomic::{AtomicU64, Ordering};

use coilsense::Spring;
use coilsense::identify::{Answer, Identification, Settings};
use rand::RngExt;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

use crate::paper_springs::{s_a, s_t};
use crate::records::{any_ratio, hit, own};

/// What one record gave.
struct Outcome {
    answer: Answer,
    /// |f1 − true| over max(0.1 Hz, 0.1 ζ f1).
    frequency: f64,
    /// |ζ/true − 1| and |k/true − 1|.
    ratio: f64,
    stiffness: f64,
    /// Whether the intervals of f1, ζ and k hold the true values.
    holds: [bool; 3],
}

fn spring_of(seed: u64) -> Spring {
    match seed % 3 {
        0 => s_t(),
        1 => s_a(),
        _ => own(),
    }
}

fn outcome(seed: u64, accuracy: f64) -> Outcome {
    let mut random = Pcg64::seed_from_u64(1000 + seed);
    let ratio = any_ratio(&mut random);
    let mut gain = || accuracy * (2.0 * random.random::<f64>() - 1.0);
    let gains = [gain(), gain(), gain()];
    let spring = spring_of(seed);
    let truth = hit(&spring, ratio, seed, gains);
    let settings = Settings { accuracy_force: accuracy, accuracy_position: accuracy, ..Settings::default() };
    let found = Identification::of(&truth.signals, &settings).expect("a record with hits is identified");
    let first = found.first_frequency.expect("a hit spring has a first mode");
    let damping = found.ratio.expect("a hit spring has a damping ratio");
    let stiffness = found.stiffness.expect("a swept spring has a stiffness").stiffness;
    Outcome {
        answer: found.verdict.answer,
        frequency: (first.value - truth.frequency).abs() / f64::max(0.1, 0.1 * ratio * truth.frequency),
        ratio: (damping.value / ratio - 1.0).abs(),
        stiffness: (stiffness.value / spring.stiffness() - 1.0).abs(),
        holds: [first.holds(truth.frequency), damping.holds(ratio), stiffness.holds(spring.stiffness())],
    }
}

/// Outcomes of seeds from zero on, in no order: each of two threads takes the next, since some take several times as long as others.
fn outcomes(count: u64, accuracy: f64) -> Vec<Outcome> {
    let next = AtomicU64::new(0);
    let some = || {
        let seeds = std::iter::from_fn(|| Some(next.fetch_add(1, Ordering::Relaxed)).filter(|seed| *seed < count));
        seeds.map(|seed| outcome(seed, accuracy)).collect::<Vec<_>>()
    };
    std::thread::scope(|scope| {
        let other = scope.spawn(some);
        let mut all = some();
        all.extend(other.join().expect("the other thread runs through"));
        all
    })
}

/// Half the width of the 99 % band of a share of 95 % in `count` trials, by the normal distribution.
fn band(count: usize) -> f64 {
    2.576 * (0.95 * 0.05 / count as f64).sqrt()
}

fn check(all: &[Outcome], accuracy: f64) {
    let count = all.len();
    let share = |index: usize| all.iter().filter(|one| one.holds[index]).count() as f64 / count as f64;
    let worst = |of: fn(&Outcome) -> f64| all.iter().map(of).fold(0.0, f64::max);
    let springs = all.iter().filter(|one| one.answer == Answer::Spring).count();
    println!(
        "{count} records: spring {springs}, worst f1 {:.2} of its tolerance, ζ {:.1} %, k {:.3} %, coverage f1 {:.3}, ζ {:.3}, k {:.3}",
        worst(|one| one.frequency),
        100.0 * worst(|one| one.ratio),
        100.0 * worst(|one| one.stiffness),
        share(0),
        share(1),
        share(2)
    );
    assert!(all.iter().all(|one| one.answer != Answer::NotTheSpring), "a true spring is never called something else");
    assert!(springs as f64 >= 0.95 * count as f64, "{springs} of {count} are recognised");
    assert!(worst(|one| one.frequency) <= 1.0, "f1 within max(0.1 Hz, 0.1 ζ f1)");
    assert!(worst(|one| one.ratio) <= 0.15, "ζ within 15 %");
    for (index, quantity) in [(0, "f1"), (1, "ζ")] {
        let share = share(index);
        assert!(
            (share - 0.95).abs() <= band(count),
            "the 95 % intervals of {quantity} hold {share} of the true values"
        );
    }
    if accuracy == 0.0 {
        assert!(worst(|one| one.stiffness) <= 0.002, "k within 0.2 %");
        assert!((share(2) - 0.95).abs() <= band(count), "the 95 % intervals of k hold {} of the true values", share(2));
    } else {
        // Rectangular errors have no tails: their intervals hold more than they say.
        assert!(
            share(2) >= 0.95 - band(count),
            "with gain errors the intervals of k hold {} of the true values",
            share(2)
        );
    }
}

#[test]
fn hits_give_back_frequency_damping_and_stiffness_within_their_intervals() {
    check(&outcomes(120, 0.0), 0.0);
}

#[test]
#[ignore = "two to twelve minutes; run with `cargo test -p coilsense --test identify -- --ignored --nocapture`"]
fn six_hundred_records_keep_every_promise() {
    check(&outcomes(600, 0.0), 0.0);
    check(&outcomes(600, 0.01), 0.01);
}
