//! Drift from run to run against SciPy (`reference/trend.py`), and stiffness from points at rest.

use coilsense::calibrate::StiffnessFit;
use coilsense::measures::Trend;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

#[test]
fn the_exact_test_and_the_slope_are_those_of_scipy() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/trend.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let mut rows = 0;
    for record in reader.records() {
        let row: Vec<f64> =
            record.unwrap().iter().filter(|text| !text.is_empty()).map(|text| text.parse().unwrap()).collect();
        let trend = Trend::of(&row[4..]).unwrap();
        assert!(row.len() == 4 + row[0] as usize && trend.rises == row[1] as i64, "{row:?}");
        // SciPy adds counts of orders, we add shares: n additions for each of n² places.
        assert!((trend.p - row[2]).abs() <= 1e-12 * row[2], "{} for {}", trend.p, row[2]);
        assert!((trend.slope - row[3]).abs() <= 1e-14 * row[3].abs().max(1.0), "{} for {}", trend.slope, row[3]);
        rows += 1;
    }
    assert_eq!(rows, 32);
}

#[test]
fn a_single_peak_is_no_drift_and_turning_time_round_turns_the_sign() {
    let mut values = [0.1, -0.2, 0.05, 0.0, -0.1, 0.15, 0.02, -0.05, 0.08, -0.12, 0.03];
    let before = Trend::of(&values).unwrap();
    values[7] = 1e6;
    let after = Trend::of(&values).unwrap();
    assert!(after.p > 0.05 && (after.slope - before.slope).abs() < 0.02, "{after:?}");
    values.reverse();
    let turned = Trend::of(&values).unwrap();
    assert_eq!((turned.rises, turned.p), (-after.rises, after.p));
    assert!((turned.slope + after.slope).abs() < 1e-15);
}

#[test]
fn without_a_drift_one_in_twenty_is_said_to_drift_by_chance() {
    let mut generator = Pcg64::seed_from_u64(3);
    let trials = 4000;
    let said = (0..trials).filter(|_| {
        let values: Vec<f64> = (0..15).map(|_| StandardNormal.sample(&mut generator)).collect();
        Trend::of(&values).unwrap().p < 0.05
    });
    let share = said.count() as f64 / f64::from(trials);
    // S steps by 2: the largest p below 0.05 of 15 values is 0.046. The 99 % band of 4000 trials is ±0.009.
    assert!((share - 0.046).abs() < 0.009, "{share}");
}

#[test]
fn a_stiffness_is_that_of_the_line_and_its_error_that_of_the_scatter() {
    let x = [-4e-3, -2e-3, 0.0, 2e-3, 4e-3];
    let mut generator = Pcg64::seed_from_u64(9);
    let (mut stated, mut scatter, trials) = (0.0, 0.0, 5000);
    for _ in 0..trials {
        let forces = x.map(|x| {
            let noise: f64 = StandardNormal.sample(&mut generator);
            26.0 + 760.0 * x + 0.02 * noise
        });
        let fit = StiffnessFit::new(&x, &forces).unwrap();
        stated += fit.stiffness_se.unwrap().powi(2);
        scatter += (fit.stiffness - 760.0).powi(2);
    }
    // The scatter of 5000 draws is known to 1 %.
    assert!((stated / scatter - 1.0).abs() < 0.06, "{stated} {scatter}");
    let turned = StiffnessFit::new(&x, &x.map(|x| 26.0 - 760.0 * x)).unwrap_err().to_string();
    assert!(turned.starts_with("stiffness must be above zero and finite (is the sign"), "{turned}");
    assert!(StiffnessFit::new(&x[..1], &[26.0]).is_err() && StiffnessFit::new(&[0.0; 2], &[1.0, 2.0]).is_err());
}
