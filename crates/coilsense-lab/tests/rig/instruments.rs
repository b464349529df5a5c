//! Instruments with their errors: noise, steps, gains, dynamics, seeds.

use std::f64::consts::TAU;

use super::{PAPER, PERFECT, ends, harmonics, log, mean, rig, spread};

/// The paper's instruments for 4 s.
fn short() -> String {
    format!("{PAPER}duration = \"4 s\"\nreadings = 5\n")
}

#[test]
fn a_load_cell_at_rest_shows_its_noise_and_steps() {
    let rig = rig(PAPER, 11);
    let log = log(&rig, "preload-first");
    let (force, u1) = ends(&log);
    assert_eq!((force.len(), log.slow.rows()), (100_000, 59));
    for (name, values, noise, step) in [("F_o", force, 0.022, 220.0 / 65536.0), ("u1", u1, 2e-6, 10e-3 / 4096.0)] {
        let step = if name == "u1" { 2.4e-6 } else { step };
        // A step adds q²/12. A standard deviation of 1e5 samples is known to 0.22 %: four of these; relaxation adds less.
        let expected = (noise * noise + step * step / 12.0_f64).sqrt();
        assert!((spread(values) / expected - 1.0).abs() < 0.009, "{name}: {} and {expected}", spread(values));
        for value in values.iter().take(1000) {
            let steps = value / step;
            assert!((steps - steps.round()).abs() < 1e-6, "{name}: {value}");
        }
    }
    let inductance = log.slow.values("L").unwrap();
    // 59 readings know a standard deviation to 9 %: four of these.
    assert!((spread(inductance) / 0.5e-9 - 1.0).abs() < 0.37, "{}", spread(inductance));
}

#[test]
fn gains_and_offsets_stay_inside_the_limits_of_error_and_differ_from_specimen_to_specimen() {
    let tables = PERFECT
        .replace("range = \"110 N\"", "range = \"110 N\"\naccuracy_reading = \"1 %\"\naccuracy_full_scale = \"2 N\"");
    let mut found = Vec::new();
    for seed in 0..40 {
        let log = log(&rig(&tables, seed), "calibration");
        let (force, u1) = (log.slow.values("F_o").unwrap(), log.slow.values("u1").unwrap());
        let stiffness = (force[0] - force[32]) / (u1[32] - u1[0]);
        let gain = stiffness / 760.0 - 1.0;
        let offset = mean(force) - 26.0 * (1.0 + gain);
        // Rounding of a ratio.
        assert!(gain.abs() < 0.01 + 1e-12 && offset.abs() < 2.0 + 1e-12, "{seed}: {gain} {offset}");
        found.push((gain, offset));
    }
    // A uniform distribution of half-width a has a spread of a/√3; 40 draws know it to 10 %: four of these.
    for (values, limit) in
        [(found.iter().map(|f| f.0).collect::<Vec<_>>(), 0.01), (found.iter().map(|f| f.1).collect(), 2.0)]
    {
        assert!((spread(&values) * 3_f64.sqrt() / limit - 1.0).abs() < 0.4, "{}", spread(&values));
    }
}

#[test]
fn a_filtering_load_cell_is_steady_from_its_first_sample() {
    let filtered =
        PERFECT.replace("range = \"110 N\"", "range = \"110 N\"\nbandwidth = \"100 Hz\"\norder = 1\ndelay = \"3 ms\"");
    let [plain, filtered] = [PERFECT, &filtered].map(|tables| log(&rig(tables, 4), "harmonic-10"));
    let frequency = 10.0 / 0.445;
    // Its amplitude over the first window and over a late one: 1/√(1 + (f/100 Hz)²) of the plain one.
    let line = |log: &super::Log, from: usize| {
        let force = &ends(log).0[from..from + 2225];
        let angle = |index: usize| TAU * frequency * (from + index) as f64 / 2500.0;
        let part = |turn: fn(f64) -> f64| force.iter().enumerate().map(|(i, f)| f * turn(angle(i))).sum::<f64>();
        (part(f64::sin).hypot(part(f64::cos)), part(f64::cos).atan2(part(f64::sin)))
    };
    let expected = 1.0 / (1.0 + (frequency / 100.0_f64).powi(2)).sqrt();
    for from in [0, 15_000] {
        let ((before, phase), (after, later)) = (line(&plain, from), line(&filtered, from));
        // Motion is taken as straight over 50 µs: (ωh)²/8 = 6e-6.
        assert!((after / before / expected - 1.0).abs() < 2e-5, "{from}: {} and {expected}", after / before);
        let lag = (phase - later).rem_euclid(TAU);
        let wanted = (frequency / 100.0_f64).atan() + TAU * frequency * 3e-3;
        assert!((lag - wanted).abs() < 2e-5, "{from}: {lag} and {wanted}");
    }
}

#[test]
fn a_seed_is_a_rig_and_each_run_has_randomness_of_its_own() {
    let tables = short();
    let [first, again, other] = [7, 7, 8].map(|seed| rig(&tables, seed));
    for run in ["calibration", "harmonic-12", "hit-1"] {
        assert_eq!(log(&first, run), log(&again, run));
        assert_ne!(log(&first, run), log(&other, run));
    }
    let [one, two] = ["preload-first", "preload-last"].map(|run| log(&first, run));
    let (one, two) = (ends(&one).0, ends(&two).0);
    let (a, b) = (mean(one), mean(two));
    let together: f64 = one.iter().zip(two).map(|(one, two)| (one - a) * (two - b)).sum();
    // 1e4 pairs of independent numbers: a correlation of 0.01, four of these.
    assert!((together / one.len() as f64 / spread(one) / spread(two)).abs() < 0.04);
    let phases: Vec<f64> = harmonics(&first).map(|run| ends(&log(&first, &run.name)).1[0]).collect();
    assert!(spread(&phases) > 3e-4, "the records begin at one phase: {phases:?}");
}
