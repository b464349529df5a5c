//! What a step costs on this machine: a notch, a mean, a window, Kalman filters, the spring itself; `cargo bench -p coilsense --bench steps`.
//!
//! Next door: instructions on a robot's processor (`cargo xtask test`, part no_std).

use coilsense::calibrate::Calibration;
use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::mitigation::{
    BankDesign, KalmanNoise, SampledSpring, ToleranceBox, modal_kalman, observer_bank, surge_mean, surge_notches,
};
use coilsense::plant::{ModalPlant, Order};
use coilsense::{Damping, Mount, Spring};
use coilsense_rt::{Cascade, Measured, Window};
use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};

/// Steps of one measurement, so that a clock's own cost does not show.
const STEPS: u64 = 10_000;

/// S_T at 2.5 kHz, ζ = 0.005.
fn sampled() -> SampledSpring {
    let spring = Spring::new(coilsense::paper::S_T);
    SampledSpring::new(&spring.unwrap(), &Damping::Modal(0.005), 2500.0).unwrap()
}

fn measured() -> Vec<Measured<f64>> {
    let at = |sample: u64| {
        let time = sample as f64 / 2500.0;
        Measured { force: 96.0 + (340.0 * time).sin(), ends: [0.005 * (9.4 * time).sin(), 0.23] }
    };
    (0..STEPS).map(at).collect()
}

fn bench<S: Clone>(
    criterion: &mut Criterion,
    name: &str,
    state: S,
    mut step: impl FnMut(&mut S, &Measured<f64>) -> f64,
) {
    let samples = measured();
    let mut group = criterion.benchmark_group("step");
    group.throughput(Throughput::Elements(STEPS));
    group.bench_function(name, |bencher| {
        let run = |mut state: S| samples.iter().map(|sample| step(&mut state, sample)).sum::<f64>();
        bencher.iter_batched(|| state.clone(), run, BatchSize::SmallInput);
    });
}

fn steps(criterion: &mut Criterion) {
    let spring = sampled();
    let start = measured()[0];
    let notch: Cascade<f64, 1> = Cascade { sections: surge_notches(&spring, 1, 2.0).unwrap().try_into().unwrap() };
    bench(criterion, "notch", notch.settled(96.0), |state, sample| notch.step(state, sample.force));
    let mean = surge_mean(&spring);
    bench(criterion, "mean over 2τ", mean.settled::<48>(96.0), |state, sample| mean.step(state, sample.force));
    let window = Window { taps: [1.0 / 96.0; 96] };
    bench(criterion, "window of 96 taps", window.settled(96.0), |state, sample| window.step(state, sample.force));
    let noise = KalmanNoise { force: 0.24, shock: 0.15, ringing: 0.1, drift: 0.5 };
    let kalman = modal_kalman::<3>(&spring, &noise).unwrap();
    bench(criterion, "Kalman, 3 modes", kalman.settled(&start), |state, sample| kalman.step(state, sample).output);
    let design = BankDesign { noise, stiffnesses: 3, memory: 0.1, sharpness: 30.0 };
    let bank = observer_bank::<5, 21>(&spring, &ToleranceBox::new(0.1, 0.1).unwrap(), &design).unwrap();
    bench(criterion, "bank of 21, 5 modes", bank.settled(&start), |state, sample| bank.step(state, sample).output);
    let mount = Mount::new(coilsense::FarEnd::Position, Damping::Modal(0.005)).unwrap();
    let plant = |order| ModalPlant::new(&coilsense::paper::s_t(), &mount, 0.23, order).unwrap();
    let all = plant(Order::All).settings::<52>().unwrap().plant::<f64>(4e-4).unwrap();
    bench(criterion, "plant, 52 modes", all.settled([0.0; 2]), |state, sample| {
        let out = all.step(state, [sample.ends[0], 0.0]);
        out.input + out.output
    });
    let spring = coilsense::paper::s_t();
    let sum = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    let calibration = Calibration::theoretical(&spring, &sum, 0.23).unwrap();
    let coil = plant(Order::All).coil(&sum, calibration, [0.19, 0.27]).unwrap();
    let coil = coil.settings::<f64, 52, 51, 13>().unwrap();
    bench(criterion, "plant, 52 modes and F_L", all.settled([0.0; 2]), |state, sample| {
        all.step(state, [sample.ends[0], 0.0]);
        coil.reading(&all, state).force
    });
    let near = plant(Order::All).windings(2e-3).unwrap().settings::<f64, 52, 51>().unwrap();
    bench(criterion, "plant, 52 modes and closest pitch", all.settled([0.0; 2]), |state, sample| {
        all.step(state, [sample.ends[0], 0.0]);
        near.closest_pitch(&all, state)
    });
    let few = plant(Order::Modes(6)).settings::<8>().unwrap().plant::<f64>(4e-4).unwrap();
    bench(criterion, "plant, 8 modes", few.settled([0.0; 2]), |state, sample| {
        few.step(state, [sample.ends[0], 0.0]).output
    });
}

criterion_group!(benches, steps);
criterion_main!(benches);
