//! Criterion benches of the kernels: `cargo bench --bench kernels`. Ratios count; figures move by a third between runs.

#[path = "../tests/paper_springs/mod.rs"]
mod paper_springs;

use std::hint::black_box;

use coilsense::calibrate::{CalibrationPoints, Permeability, SteelDoubts, SteelFit};
use coilsense::contact::{Contact, Touching};
use coilsense::geometry::{EndType, Geometry, Material, MaterialParameters};
use coilsense::helix::{Ends, Hand, Helix, Modes, Rod, StiffnessAt, Surge, Turning};
use coilsense::inductance::theories::Coil;
use coilsense::inductance::{Leads, MaxwellSum, SelfDistance, SteelCoil, SteelWindings, mutual_inductances};
use coilsense::signals::sampled_window;
use coilsense::{EndInput, Excitation, Motion, Mount, Start};
use criterion::{Criterion, criterion_group, criterion_main};

fn motion(criterion: &mut Criterion) {
    let spring = paper_springs::s_t();
    let times = sampled_window(10_000.0, 0.0, 1.0).expect("a valid window");
    let impact = Excitation::impact(0.23, 0.25).expect("valid");
    let input = EndInput::harmonic(68e-6, spring.surge_frequency(), 0.0);
    let resonance = Excitation::new(0.23, input, EndInput::Held, Start::Rest).expect("valid");
    for (name, excitation) in [("impact", &impact), ("resonance", &resonance)] {
        criterion.bench_function(&format!("end forces, {name}, 10 001 times"), |bencher| {
            bencher.iter(|| Motion::new(&spring, excitation).and_then(|motion| motion.end_forces(black_box(&times))));
        });
    }
    let motion = Motion::new(&spring, &impact).expect("valid");
    criterion.bench_function("windings, impact, 10 001 times", |bencher| {
        bencher.iter(|| motion.windings(black_box(&times)));
    });
}

fn inductance(criterion: &mut Criterion) {
    let spring = paper_springs::s_t();
    let motion = Motion::new(&spring, &Excitation::impact(0.23, 0.25).expect("valid")).expect("valid");
    let windings = motion.windings(&sampled_window(10_000.0, 0.9, 1.0).expect("valid")).expect("valid");
    let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    criterion
        .bench_function("L of 52 windings, 1001 samples", |bencher| bencher.iter(|| coil.series(black_box(&windings))));
    // Of magnetic wire: what it costs beside the same turns of air, and a fit of ten points with all of its doubts.
    let long = motion.windings(&sampled_window(10_000.0, 0.0, 0.9999).expect("valid")).expect("valid");
    let air = MaxwellSum::new(&spring, SelfDistance::GeometricMean);
    criterion.bench_function("L of 52 windings, 10 000 samples", |bencher| {
        bencher.iter(|| air.series(black_box(&long)));
    });
    let steel = SteelWindings::about(52, spring.coil_radius(), spring.wire_radius(), 2.5, 0.23 / 52.0).expect("valid");
    criterion.bench_function("L of 52 windings of magnetic wire, 10 000 samples", |bencher| {
        bencher.iter(|| steel.series(black_box(&long)));
    });
    // S1 of the measured runs.
    let s1 = Coil::new(41.904, 8.47e-3, 1.41e-3).expect("valid");
    let lengths: Vec<f64> = (0..10).map(|point| 0.124 + 0.0059 * f64::from(point)).collect();
    let coil = || SteelCoil::new(&s1, 0.11817, Leads::Open, [0.1229, 0.180]).expect("valid");
    let wire = coil().of(2.08).expect("valid");
    let inductances: Vec<f64> = lengths.iter().map(|length| wire.inductance(*length) - 1e-7).collect();
    let points = CalibrationPoints::new(&lengths, &inductances).expect("valid");
    criterion.bench_function("a coil of magnetic wire fitted to ten points", |bencher| {
        bencher.iter(|| SteelFit::new(&coil(), black_box(&points), Permeability::Fitted, &SteelDoubts::default()));
    });
    let distances: Vec<f64> = (0..10_000).map(|k| 1e-4 * f64::from(k + 1)).collect();
    let mut out = vec![0.0; distances.len()];
    criterion.bench_function("M at 10 000 distances", |bencher| {
        bencher.iter(|| mutual_inductances(0.008, black_box(&distances), &mut out));
    });
}

fn helix(criterion: &mut Criterion) {
    let spring = paper_springs::s_t();
    let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0)).expect("valid");
    let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel).expect("valid");
    let rod = Rod::of_spring(&spring, &geometry, StiffnessAt::Range, Hand::Right).expect("valid");
    let modes =
        |length: f64| Helix::new(&rod, length, Turning::Held).and_then(|state| Modes::new(&state, Ends::clamped()));
    let mid = modes(0.23).expect("valid");
    criterion.bench_function("helix of 52 windings, modes below 100 Hz counted", |bencher| {
        bencher.iter(|| mid.count_below(black_box(100.0)));
    });
    criterion.bench_function("helix of 52 windings, ten frequencies", |bencher| {
        bencher.iter(|| modes(black_box(0.23)).and_then(|modes| modes.frequencies(10)));
    });
    criterion.bench_function("helix of 52 windings, ten modes with their shapes", |bencher| {
        bencher.iter(|| mid.lowest(black_box(10)));
    });
    criterion.bench_function("helix of 52 windings, ten frequencies at 50 lengths", |bencher| {
        let lengths: Vec<f64> = (0..50).map(|step| 0.196 + 0.068 / 49.0 * f64::from(step)).collect();
        bencher.iter(|| lengths.iter().map(|length| modes(*length)?.frequencies(10)).collect::<Result<Vec<_>, _>>());
    });
    let state = Helix::new(&rod, 0.23, Turning::Held).expect("valid");
    let surge = || Surge::new(&spring, &geometry, black_box(&state), Ends::clamped());
    criterion.bench_function("helix of 52 windings, all modes to 20 f1 for a motion", |bencher| bencher.iter(surge));
    let (surge, impact) = (surge().expect("valid"), Excitation::impact(0.23, 0.25).expect("valid"));
    let motion = surge.motion(&Mount::default(), &impact).expect("valid");
    let times = sampled_window(10_000.0, 0.0, 1.0).expect("a valid window");
    criterion.bench_function("helix of 52 windings, end forces, impact, 10 001 times", |bencher| {
        bencher.iter(|| motion.end_forces(black_box(&times)));
    });
    criterion.bench_function("helix of 52 windings, all reactions, impact, 10 001 times", |bencher| {
        bencher.iter(|| surge.reactions(&motion, black_box(&times)));
    });
}

fn contact(criterion: &mut Criterion) {
    let spring = paper_springs::s_a();
    let times = sampled_window(10_000.0, 0.0, 1.0).expect("a valid window");
    for (name, amplitude) in [("touches from 0.53 s on", 40e-6), ("stays clear", 1e-6)] {
        let input = EndInput::harmonic(amplitude, spring.surge_frequency(), -std::f64::consts::FRAC_PI_2);
        let excitation = Excitation::new(0.102, input, EndInput::Held, Start::Massless).expect("valid");
        let motion = Motion::new(&spring, &excitation).expect("valid");
        criterion.bench_function(&format!("S_A for 1 s, {name}: end forces, 10 001 times"), |bencher| {
            bencher.iter(|| motion.signals(black_box(&times)));
        });
        criterion.bench_function(&format!("S_A for 1 s, {name}: with contact, two runs"), |bencher| {
            bencher.iter(|| Touching::of(&motion, &Contact::default(), black_box(&times), false));
        });
    }
}

criterion_group!(benches, motion, inductance, helix, contact);
criterion_main!(benches);
