//! Perfect instruments: what is recorded is what the spring does.

use std::f64::consts::TAU;

use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::two_port::TwoPort;
use coilsense::{Damping, Spring};
use nalgebra::{Complex, DMatrix, DVector};

use super::{PERFECT, RATIO, ends, harmonics, log, mean, rig, spec};

/// Every sine with its second harmonic: amplitude \[m\] and frequency \[Hz\].
fn sines(frequency: f64) -> [(f64, f64); 2] {
    [(1e-3, frequency), (2e-5, 2.0 * frequency)]
}

#[test]
fn forces_differ_as_the_two_port_says() {
    let (rig, spring) = (rig(PERFECT, 1), spec(PERFECT).spring.spring);
    let port = TwoPort::chain(&spring, Damping::Modal(RATIO)).unwrap();
    assert_eq!(harmonics(&rig).count(), 13);
    for run in harmonics(&rig) {
        let log = log(&rig, &run.name);
        let (force, u1) = ends(&log);
        let off = force.iter().zip(u1).map(|(force, u1)| (force - spring.static_force(rig.length() - u1)).powi(2));
        let found = (off.sum::<f64>() / force.len() as f64).sqrt();
        // F_o − F_x of u1 = a sin ωt is a |k_t(ω) − k| high; whole periods make their squares add up.
        let each = sines(run.frequency).map(|(amplitude, frequency)| {
            0.5 * (amplitude * (port.at(TAU * frequency).unwrap().transfer() - spring.stiffness()).norm()).powi(2)
        });
        let expected = each.iter().sum::<f64>().sqrt();
        // Rounding of forces of 26 N in differences down to 1e-3 N.
        assert!((found / expected - 1.0).abs() < 1e-10, "{}: {found} and {expected}", run.name);
    }
}

/// Amplitudes of the windings \[m\] for an end 1 that swings by 1 m, by a solve of their own equations: springs 2Nk, Nk … Nk, 2Nk of
/// complex stiffness, since dashpots beside every segment are what stiffness-proportional damping means.
fn swings(spring: &Spring, omega: f64, time: f64) -> DVector<Complex<f64>> {
    let count = spring.chain_masses();
    let inner = Complex::new(1.0, omega * time) * spring.stiffness() * count as f64;
    let inertia = Complex::from(omega * omega * spring.mass() / count as f64);
    let mut matrix = DMatrix::from_element(count, count, Complex::from(0.0));
    for winding in 0..count {
        let sides = [winding == 0, winding == count - 1].map(|end| if end { 2.0 * inner } else { inner });
        matrix[(winding, winding)] = sides[0] + sides[1] - inertia;
        if winding + 1 < count {
            matrix[(winding, winding + 1)] = -inner;
            matrix[(winding + 1, winding)] = -inner;
        }
    }
    let mut drive = DVector::from_element(count, Complex::from(0.0));
    drive[0] = 2.0 * inner;
    matrix.lu().solve(&drive).unwrap()
}

#[test]
fn the_meter_reads_the_mean_over_the_windings_own_motion() {
    let time = 2e-5;
    let tables = PERFECT.replace("damping_ratio = 0.005", "stiffness_damping = \"20 us\"");
    let (rig, spring) = (rig(&tables, 3), spec(&tables).spring.spring);
    let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    for run in harmonics(&rig).filter(|run| ["harmonic-01", "harmonic-12", "harmonic-13"].contains(&run.name.as_str()))
    {
        let swings = sines(run.frequency).map(|(amplitude, f)| (amplitude, TAU * f, swings(&spring, TAU * f, time)));
        let at = |instant: f64| {
            let position = |winding: usize| {
                let still = (winding as f64 + 0.5) * rig.length() / spring.windings();
                let moved =
                    swings.iter().map(|(a, omega, swing)| a * (swing[winding] * Complex::cis(omega * instant)).im);
                still + moved.sum::<f64>()
            };
            let positions: Vec<f64> = (0..spring.chain_masses()).map(position).collect();
            coil.at_positions(&positions).unwrap()
        };
        // Another number of instants than the rig's, that begin at another phase.
        let all: Vec<f64> = (0..301).map(|index| at(0.01 + f64::from(index) / 301.0 / run.frequency)).collect();
        let still = coil.at_length(rig.length());
        let (expected, log) = (mean(&all), log(&rig, &run.name));
        for found in log.slow.values("L").unwrap() {
            // L to 1e-13 of itself; what oscillation adds to it is 1e-5 of it and more.
            assert!((found - expected).abs() < 1e-12 * expected, "{}: {found} and {expected}", run.name);
        }
        // Windings that bunch raise L: this is what biases F_L.
        assert!(expected - still > 1e-6 * still, "{}: {expected} and {still}", run.name);
    }
}

#[test]
fn surging_windings_bias_the_coils_force_low() {
    let (rig, spring) = (rig(PERFECT, 1), spec(PERFECT).spring.spring);
    let (coil, step) = (MaxwellSum::new(&spring, SelfDistance::AsPrinted), 1e-4);
    let [short, still, long] = [-step, 0.0, step].map(|more| coil.at_length(rig.length() + more));
    let (slope, bend) = ((long - short) / (2.0 * step), (long - 2.0 * still + short) / (step * step));
    let share = |more: f64| 100.0 * spring.stiffness() * more / slope / spring.nominal_force();
    let bias = |run: &coilsense_lab::rig::Run| share(mean(log(&rig, &run.name).slow.values("L").unwrap()) - still);
    let biases: Vec<f64> = harmonics(&rig).map(bias).collect();
    // Even a uniform coil's L is bent over its length, so a sine raises its mean by half of the bend times the sine's mean square: −0.0023 %
    // of F_nom. Windings lag by 0.2 % of that at 2.2 Hz; the next derivative and differences of step² add 1e-4 of it each.
    let bent = share(0.25 * bend * sines(1.0).iter().map(|(amplitude, _)| amplitude * amplitude).sum::<f64>());
    assert!((biases[0] / bent - 1.0).abs() < 3e-3, "{} and {bent}", biases[0]);
    // The rest is the surge of the windings: the mean of ½ δᵀHδ, which the direct solve of the test above holds.
    assert!(biases.iter().take(11).chain(&biases[12..]).all(|bias| (-0.0032..-0.0022).contains(bias)), "{biases:?}");
    assert!((biases[11] + 0.0157).abs() < 5e-5, "{biases:?}");
}

#[test]
fn the_calibration_gives_back_stiffness_and_inductance() {
    let (rig, spring) = (rig(PERFECT, 1), spec(PERFECT).spring.spring);
    let log = log(&rig, "calibration");
    let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    let [u1, force, inductance] = ["u1", "F_o", "L"].map(|name| log.slow.values(name).unwrap());
    // Three readings at each of eleven positions, 9 mm from first to last.
    assert_eq!(u1.len(), 33);
    assert!((u1[32] - u1[0] - 9e-3).abs() < 1e-15);
    for ((u1, force), inductance) in u1.iter().zip(force).zip(inductance) {
        let length = rig.length() - u1;
        // Means of a thousand equal numbers.
        assert!((force - spring.static_force(length)).abs() < 1e-12 * force);
        assert!((inductance - coil.at_length(length)).abs() < 1e-13 * inductance);
    }
    assert!((spring.static_force(rig.length()) - 26.0).abs() < 1e-12);
}

#[test]
fn after_a_hit_the_first_mode_decays_by_its_damping() {
    let tables = PERFECT.replace("duration = \"8.9 s\"", "duration = \"8.9 s\"\nhits = 3\nhits_per_run = 2");
    let (rig, spring) = (rig(&tables, 5), spec(&tables).spring.spring);
    let natural = coilsense::modes::ChainModes::of(&spring).frequencies()[0];
    let damped = natural * (1.0 - RATIO * RATIO).sqrt();
    for run in ["hit-1", "hit-2", "hit-3"] {
        let log = log(&rig, run);
        let (time, (force, u1)) = (log.fast.values("time").unwrap(), ends(&log));
        // Twice half a sine of 0.35 to 0.65 mm, sampled every 0.4 ms.
        let top = u1.iter().fold(0.0_f64, |top, u1| top.max(*u1));
        assert!((0.34e-3..=0.65e-3).contains(&top), "{run}: {top}");
        let last = u1.iter().rposition(|u1| *u1 != 0.0).unwrap();
        // Both hits come in the first third of their half of the run.
        let first = u1.iter().position(|u1| *u1 != 0.0).unwrap();
        assert!((0.05 * 4.45..0.31 * 4.45).contains(&time[first]) && (1.05 * 4.45..1.31 * 4.45).contains(&time[last]));
        // Amplitude of the first mode over 30 of its periods under Hann's window, which lets no other mode through.
        let amplitude = |from: usize| {
            let count = (30.0 * TAU / damped * 2500.0) as usize;
            let part = |index: usize| {
                let window = 0.5 - 0.5 * (TAU * (index as f64 + 0.5) / count as f64).cos();
                let envelope = (RATIO * natural * index as f64 / 2500.0).exp();
                Complex::cis(damped * index as f64 / 2500.0) * window * envelope * (force[from + index] - 26.0)
            };
            (0..count).map(part).sum::<Complex<f64>>().norm() / count as f64
        };
        let (early, late) = (amplitude(last + 100), amplitude(last + 100 + 2500));
        // One second later by e^(−ζω); other modes, a multiple of 30 lines away, leak 1e-5.
        assert!(((late / early).ln() / (-RATIO * natural) - 1.0).abs() < 1e-3, "{run}: {early} and {late}");
        // Loud enough for a load cell with 22 mN of noise.
        assert!(early > 0.02, "{run}: {early}");
    }
}

#[test]
fn the_spring_relaxes_with_the_logarithm_of_time() {
    let tables = PERFECT.replace("relaxation = \"0 %\"", "relaxation = \"0.1 %\"");
    let rig = rig(&tables, 1);
    let begin = |name: &str| rig.runs().iter().find(|run| run.name == name).unwrap().begin;
    for name in ["preload-first", "preload-last"] {
        let log = log(&rig, name);
        let (time, (force, _)) = (log.fast.values("time").unwrap(), ends(&log));
        for (time, force) in time.iter().zip(force) {
            let decades = ((120.0 + begin(name) + time) / 120.0).log10();
            assert!((force - 26.0 * (1.0 - 1e-3 * decades)).abs() < 1e-12, "{name} at {time} s");
        }
    }
    assert!(begin("preload-last") > begin("preload-first") + 13.0 * 8.9);
}
