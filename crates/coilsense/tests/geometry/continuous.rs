//! The continuous coil on every mount, and the rule of thumb beside it.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use coilsense::modes::{ChainModes, continuous_frequencies, third_rule_error, third_rule_frequency};
use coilsense::{FarEnd, Spring};

use crate::paper_springs::{s_t, s_t_with};
use crate::relative;

#[test]
fn roots_with_an_end_mass_hold_to_the_last_bits() {
    let path = format!("{}/tests/golden/continuous_modes.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(&path).expect(&path);
    // τ = 1 s, so that frequencies are β.
    let spring = Spring::new(s_t_with(|p| (p.mass, p.stiffness) = (1.0, 1.0))).unwrap();
    let mut rows = 0;
    for record in reader.records() {
        let record = record.expect(&path);
        let number = |column: usize| record[column].parse::<f64>().expect(&path);
        let (ratio, mode, beta) = (number(0), number(1) as usize, number(2));
        let ours = continuous_frequencies(&spring, FarEnd::Mass(1.0 / ratio), mode).unwrap()[mode - 1];
        // 1/ratio and back rounds twice, each half of it in β; the sum of base and x once.
        assert!(relative(ours, beta) < 1e-15, "m/M {ratio:e} mode {mode}: {ours} {beta}");
        rows += 1;
    }
    assert!(rows > 100, "{path} is short");
}

#[test]
fn end_masses_lie_between_a_free_and_a_held_end() {
    let spring = s_t();
    let tau = spring.transit_time();
    let free = continuous_frequencies(&spring, FarEnd::Force, 3).unwrap();
    let held = continuous_frequencies(&spring, FarEnd::Position, 3).unwrap();
    // Book: theory, section 1: 27.03, 81.10, 135.16 Hz, and eq. (3): 54.065 Hz; half of the last digit.
    for (omega, hertz) in free.iter().zip([27.03, 81.10, 135.16]) {
        assert!((omega / TAU - hertz).abs() < 0.005);
    }
    assert!((held[0] / TAU - 54.065).abs() < 0.0005);
    // A mass of nothing leaves the end free: β falls short of (j−½)π by β M/m.
    let light = continuous_frequencies(&spring, FarEnd::Mass(1e-9), 3).unwrap();
    // A wall of a mass holds it: mode j + 1 lies above jπ by (m/M)/jπ, and the first is the mass on a spring.
    let heavy = continuous_frequencies(&spring, FarEnd::Mass(1e6), 4).unwrap();
    for mode in 0..3 {
        assert!(relative(light[mode] * (1.0 + 1e-9 / 0.065), free[mode]) < 1e-14);
        let shift = 0.065e-6 / ((mode + 1) as f64 * PI).powi(2);
        assert!(relative(heavy[mode + 1], held[mode] * (1.0 + shift)) < 1e-14);
    }
    // β² = r − r²/3, r = m/M.
    assert!(relative(heavy[0] * tau, (0.065e-6_f64).sqrt() * (1.0 - 0.065e-6 / 6.0)) < 1e-14);
    for mass in [1e-3, 0.065, 10.0] {
        let between = continuous_frequencies(&spring, FarEnd::Mass(mass), 3).unwrap();
        for mode in 0..3 {
            assert!(between[mode] < free[mode]);
            assert!(mode == 0 || between[mode] > held[mode - 1]);
        }
    }
}

#[test]
fn a_third_of_the_mass_is_a_good_rule_for_heavy_ends_only() {
    let spring = s_t();
    let m = spring.mass();
    // Book: theory, section 4: +0.1 % at m/M = ⅓, +10.3 % at M = 0; half of the last digit.
    assert!((third_rule_error(&spring, 3.0 * m).unwrap() - 0.001).abs() < 0.0005);
    assert!((third_rule_error(&spring, 0.0).unwrap() - 0.103).abs() < 0.0005);
    // Without a mass: √3 against π/2.
    assert!((third_rule_error(&spring, 0.0).unwrap() - (3_f64.sqrt() / FRAC_PI_2 - 1.0)).abs() < 1e-15);
    // With a heavy one (m/M)²/90; the next term is smaller by the order of m/M.
    for ratio in [1e-2, 1e-3] {
        let error = third_rule_error(&spring, m / ratio).unwrap();
        assert!(relative(error, ratio * ratio / 90.0) < ratio, "{error}");
    }
    let rule = third_rule_frequency(&spring, m).unwrap();
    let truth = continuous_frequencies(&spring, FarEnd::Mass(m), 1).unwrap()[0];
    assert!((rule / truth - 1.0 - third_rule_error(&spring, m).unwrap()).abs() < 1e-15);
}

#[test]
fn the_chain_becomes_the_continuous_coil_as_one_over_n_squared() {
    for far_end in [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.02), FarEnd::Mass(0.065), FarEnd::Mass(1.0)] {
        let misses: Vec<f64> = [52.0, 104.0, 208.0]
            .iter()
            .map(|&windings| {
                let spring = Spring::new(s_t_with(|p| p.windings = windings)).unwrap();
                let chain = ChainModes::mounted(&spring, far_end).frequencies()[0];
                chain / continuous_frequencies(&spring, far_end, 1).unwrap()[0] - 1.0
            })
            .collect();
        // At N = 52 θ²/24 = 3.8e-5 for θ = β/N at β = π/2, and 1.5e-4 with both ends held (book: theory, section 1).
        let most = if far_end == FarEnd::Position { 1.6e-4 } else { 4e-5 };
        assert!(misses[0].abs() < most, "{far_end:?} {misses:?}");
        if matches!(far_end, FarEnd::Mass(_)) {
            assert!(misses[0].abs() < 3e-5, "{far_end:?} {misses:?}");
        }
        for pair in misses.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            // The next term is smaller by θ².
            assert!((order - 2.0).abs() < 0.01, "{far_end:?} order {order}");
        }
    }
}

#[test]
fn what_cannot_be_counted_is_refused() {
    let spring = s_t();
    for count in [0, 1_000_001, usize::MAX] {
        let error = continuous_frequencies(&spring, FarEnd::Position, count).unwrap_err().to_string();
        assert!(error.starts_with("count must be from 1 to 1000000"), "{error}");
    }
    assert!(continuous_frequencies(&spring, FarEnd::Mass(0.0), 1).is_err());
    assert!(third_rule_error(&spring, -1.0).is_err());
}
