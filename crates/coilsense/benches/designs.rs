//! Designs a second, as a sweep judges them: `cargo bench -p coilsense --bench designs`. Figures move by a third between runs, and
//! by more where others use the machine.
//!
//! A design is a spring like S_T (N = 52) in the paper's five conditions, 10 kHz, judged from 0.75 to 1 s; everything is found anew for each.

#[path = "../tests/paper_springs/mod.rs"]
mod paper_springs;

use std::hint::black_box;
use std::time::{Duration, Instant};

use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::signals::sampled_window;
use coilsense::{
    Calibration, Clash, Deviation, EndInput, Error, Excitation, InductanceSensor, Motion, Spring, Start,
    VelocityProfile,
};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

/// What is asked of L: a bound of 1e-6, or the exact sum.
const BOUNDED: f64 = 1e-6;
const EXACT: f64 = 0.0;

/// The number-th of many springs like S_T.
fn spring(number: usize) -> Result<Spring, Error> {
    let share = (number % 97) as f64 / 97.0;
    Spring::new(paper_springs::s_t_with(|parameters| {
        parameters.mass *= 0.9 + 0.2 * share;
        parameters.stiffness *= 1.1 - 0.2 * share;
    }))
}

/// The paper's five, as its tables have them; resonance with a share of its amplitude.
fn conditions(spring: &Spring, resonance: f64) -> Result<[Excitation; 5], Error> {
    let (shortest, longest) = spring.operating_range();
    let (range, middle, surge) = (longest - shortest, spring.mid_length(), spring.surge_frequency());
    let cosine = |amplitude: f64, frequency: f64| {
        let input = EndInput::harmonic(amplitude * range, frequency, -std::f64::consts::FRAC_PI_2);
        Excitation::new(middle, input, EndInput::Held, Start::Massless)
    };
    Ok([
        Excitation::impact(middle, 0.25)?,
        Excitation::end_stop(longest, range, VelocityProfile::Linear)?,
        Excitation::end_stop(shortest, -range, VelocityProfile::Uniform)?,
        cosine(0.01, 0.5 * surge)?,
        cosine(0.001 * resonance, surge)?,
    ])
}

/// A design judged: the sum of its RMSDs, and how many samples of L took the exact sum. `tolerance`: of L; none without F_L.
fn judge(number: usize, tolerance: Option<f64>, resonance: f64) -> Result<(f64, usize), Error> {
    let spring = spring(number)?;
    let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    let (mut sum, mut exact) = (0.0, 0);
    for excitation in conditions(&spring, resonance)? {
        let motion = Motion::new(&spring, &excitation)?;
        assert!(Clash::excluded(&motion, 1.0, spring.wire_diameter()), "S_T's windings stay clear");
        let times = sampled_window(10_000.0, 0.75, 1.0)?;
        let (forces, reference) = (motion.end_forces(&times)?, motion.deflection_forces(&times)?);
        for force in [&forces.input, &forces.output] {
            sum += Deviation::between(force, &reference)?.rmsd;
        }
        if let Some(tolerance) = tolerance {
            let series = coil.along(&motion, &times, tolerance)?;
            exact += series.exact;
            let inductance: Vec<f64> = series.samples.iter().map(|sample| sample.inductance).collect();
            let calibration = Calibration::theoretical(&spring, &coil, excitation.mean_length())?;
            let force = InductanceSensor::new(&spring, calibration).force(&inductance);
            sum += Deviation::between(&force, &reference)?.rmsd;
        }
    }
    Ok((sum, exact))
}

/// Designs a second on so many threads for a second each.
fn rate(threads: usize, tolerance: Option<f64>) -> f64 {
    let begun = Instant::now();
    let work = |first: usize| {
        (first..)
            .step_by(threads)
            .take_while(|number| {
                black_box(judge(*number, tolerance, 1.0)).is_ok() && begun.elapsed() < Duration::from_secs(1)
            })
            .count()
    };
    let judged: usize = std::thread::scope(|scope| {
        let running: Vec<_> = (0..threads).map(|first| scope.spawn(move || work(first))).collect();
        running.into_iter().map(|thread| thread.join().unwrap_or(0)).sum()
    });
    judged as f64 / begun.elapsed().as_secs_f64()
}

fn designs(criterion: &mut Criterion) {
    let rows = [
        ("F_i, F_o against F_x", None, 1.0),
        ("and F_L within 1e-6, a tenth of the resonance", Some(BOUNDED), 0.1),
        ("and F_L within 1e-6", Some(BOUNDED), 1.0),
        ("and F_L by the exact sum", Some(EXACT), 1.0),
    ];
    let mut group = criterion.benchmark_group("design");
    group.throughput(Throughput::Elements(1)).sample_size(20);
    for (name, tolerance, resonance) in rows {
        let mut number = 0;
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                number += 1;
                judge(number, tolerance, resonance)
            });
        });
        let (_, exact) = judge(0, tolerance, resonance).expect("a valid design");
        println!("design/{name}: {exact} of 12505 samples of L by the exact sum");
    }
    group.finish();
    // The best of several: others may use the machine.
    let best = |threads| (0..5).map(|_| rate(threads, Some(BOUNDED))).fold(0.0, f64::max);
    let [one, two] = [best(1), best(2)];
    println!(
        "design/and F_L within 1e-6: {one:.0} designs/s on one thread, {two:.0} on two, {:.2} times as many",
        two / one
    );
}

criterion_group!(benches, designs);
criterion_main!(benches);
