//! Against golden files of independent tools; each file's first line names tool and digits, `reference/README.md` tells how to make them.
//!
//! | ours | theirs |
//! |---|---|
//! | `inductance::elliptic::complete_k`, `complete_e` | mpmath, 40 digits |
//! | `inductance::mutual_inductance` | eqs. 8 and 9 in mpmath, 40 digits |
//! | `MaxwellSum` | eqs. 8–11 in mpmath, 40 digits |
//! | `Calibration::theoretical` | constrained least squares in mpmath, 40 digits |
//! | `Motion::end_forces`, `::windings` | matrix exponential of chain and inputs in Arb, 40 digits, no modes |

mod paper_springs;

use std::collections::BTreeMap;

use coilsense::inductance::{MU_0, MaxwellSum, SelfDistance, elliptic, mutual_inductance};
use coilsense::{Calibration, EndInput, Excitation, Motion, Spring, Start, VelocityProfile};

/// Rows of a golden file by column name without its unit. A missing file fails.
fn golden(name: &str) -> Vec<BTreeMap<String, String>> {
    let path = format!("{}/tests/golden/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(&path).expect(&path);
    let bare = |header: &str| header.split(" [").next().unwrap_or_default().to_owned();
    let headers: Vec<String> = reader.headers().expect(&path).iter().map(bare).collect();
    let rows: Vec<BTreeMap<String, String>> = reader
        .records()
        .map(|record| headers.iter().cloned().zip(record.expect(&path).iter().map(str::to_owned)).collect())
        .collect();
    assert!(!rows.is_empty(), "{path} is empty");
    rows
}

fn number(row: &BTreeMap<String, String>, column: &str) -> f64 {
    let text = row.get(column).unwrap_or_else(|| panic!("no column {column}"));
    text.parse().unwrap_or_else(|_| panic!("{column}: {text}"))
}

fn spring(name: &str) -> Spring {
    match name {
        "S_T" => paper_springs::s_t(),
        "S_A" => paper_springs::s_a(),
        other => panic!("unknown spring {other}"),
    }
}

fn relative(ours: f64, theirs: f64) -> f64 {
    (ours / theirs - 1.0).abs()
}

#[test]
fn elliptic_integrals_hold_to_the_last_bits() {
    for row in golden("elliptic") {
        let modulus = number(&row, "kc");
        let (k, e) = (elliptic::complete_k(modulus), elliptic::complete_e(modulus));
        assert!(relative(k, number(&row, "K")) < 5e-16, "K({modulus:e}) = {k}");
        assert!(relative(e, number(&row, "E")) < 3e-15, "E({modulus:e}) = {e}");
    }
}

#[test]
fn mutual_inductance_holds_from_touching_to_far_rings() {
    let mut worst: f64 = 0.0;
    for row in golden("mutual_inductance") {
        let ratio = number(&row, "h/r");
        let ours = mutual_inductance(1.0, ratio) / MU_0;
        worst = worst.max(relative(ours, number(&row, "M/(mu0 r)")));
    }
    assert!(worst < 2e-15, "{worst:e}");
}

#[test]
fn mutual_inductance_keeps_its_limits() {
    // Near: ln(8r/h) − 2, next term (h/r)² ln; far: (π/2)(r/h)³, next term (r/h)².
    let near = mutual_inductance(0.01, 1e-9) / (MU_0 * 0.01);
    assert!(relative(near, (8.0 * 0.01_f64 / 1e-9).ln() - 2.0) < 1e-12);
    let far = mutual_inductance(0.01, 1e3) / (MU_0 * 0.01);
    assert!(relative(far, 0.5 * std::f64::consts::PI * 1e-15) < 1e-9);
}

#[test]
fn maxwells_sum_holds_for_uniform_and_displaced_windings() {
    let mut positions: BTreeMap<(String, String), Vec<f64>> = BTreeMap::new();
    for row in golden("maxwell_sum_positions") {
        let key = (row["spring"].clone(), row["configuration"].clone());
        positions.entry(key).or_default().push(number(&row, "x_i"));
    }
    for row in golden("maxwell_sum") {
        let key = (row["spring"].clone(), row["configuration"].clone());
        let turns = &positions[&key];
        for (distance, column) in [
            (SelfDistance::AsPrinted, "L with h_11 = rho e^(-1/4)/2"),
            (SelfDistance::GeometricMean, "L with h_11 = rho e^(-1/4)"),
        ] {
            let coil = MaxwellSum::new(&spring(&key.0), distance);
            let theirs = number(&row, column);
            assert!(relative(coil.at_positions(turns).unwrap(), theirs) < 2e-15, "{key:?}");
            if key.1.starts_with("uniform") {
                let ours = coil.at_length(number(&row, "l"));
                assert!(relative(ours, theirs) < 2e-15, "{key:?}");
            }
        }
    }
}

#[test]
fn the_calibration_holds() {
    for row in golden("calibration") {
        let spring = spring(&row["spring"]);
        let distance = match row["self distance"].as_str() {
            "as printed" => SelfDistance::AsPrinted,
            "geometric mean" => SelfDistance::GeometricMean,
            other => panic!("unknown self distance {other}"),
        };
        let coil = MaxwellSum::new(&spring, distance);
        let fit = Calibration::theoretical(&spring, &coil, number(&row, "preload length")).unwrap();
        // L to 2e-15, of which differences of a tenth are taken.
        assert!(relative(fit.alpha(), number(&row, "alpha")) < 1e-12, "{row:?}");
        assert!(relative(fit.beta(), number(&row, "beta")) < 1e-11, "{row:?}");
    }
}

/// The excitation of a row of `modal_sum_cases.csv`.
fn excitation(row: &BTreeMap<String, String>) -> Excitation {
    let input = |end: &str| {
        let value = |name: &str| number(row, &format!("{end} {name}"));
        match value("amplitude") {
            0.0 => EndInput::Held,
            amplitude => EndInput::harmonic(amplitude, value("frequency"), value("phase")),
        }
    };
    let (uniform, slope) = (number(row, "start velocity uniform"), number(row, "start velocity slope"));
    let length = number(row, "u2 mean");
    assert_eq!(number(row, "u1 mean"), 0.0);
    let start = match (row["start"].as_str(), uniform, slope) {
        ("uniform" | "rest", 0.0, 0.0) => Start::Rest,
        ("massless", 0.0, 0.0) => Start::Massless,
        ("uniform", velocity, 0.0) => Start::Moving { velocity, profile: VelocityProfile::Uniform },
        ("uniform", 0.0, velocity) => Start::Moving { velocity, profile: VelocityProfile::Linear },
        ("given", 0.0, 0.0) => given_start(length),
        other => panic!("unknown start {other:?}"),
    };
    Excitation::new(length, input("u1"), input("u2"), start).unwrap()
}

/// The start of `modal_sum_start.csv`, about uniform windings.
fn given_start(length: f64) -> Start {
    let rows = golden("modal_sum_start");
    let count = rows.len() as f64;
    let positions =
        rows.iter().map(|row| (number(row, "winding i") - 0.5) * length / count + number(row, "displacement"));
    Start::Windings {
        positions: positions.collect(),
        velocities: rows.iter().map(|row| number(row, "velocity")).collect(),
    }
}

#[test]
fn the_motion_holds_to_1e_12_of_the_peak_over_a_second() {
    let rows = golden("modal_sum");
    let cases = golden("modal_sum_cases");
    assert!(cases.len() >= 15, "{}", cases.len());
    for case in &cases {
        let spring = spring(&case["spring"]);
        let motion = Motion::new(&spring, &excitation(case)).unwrap();
        let of_case = |row: &&BTreeMap<String, String>| row["spring"] == case["spring"] && row["case"] == case["case"];
        let rows: Vec<_> = rows.iter().filter(of_case).collect();
        assert!(rows.len() >= 30, "{case:?}");
        let times: Vec<f64> = rows.iter().map(|row| number(row, "time")).collect();
        let (forces, windings) = (motion.end_forces(&times).unwrap(), motion.windings(&times).unwrap());
        let n = windings.count();
        // Forces are judged by the peak of what oscillates, F − F_x, not by the preload.
        let ours = |sample: usize| {
            let row = windings.row(sample);
            [forces.input[sample], forces.output[sample], row[0], row[n / 2 - 1], row[n - 1]]
        };
        for (index, column) in ["F_i", "F_o", "x_1", "x_mid", "x_N"].into_iter().enumerate() {
            let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
            for (sample, row) in rows.iter().enumerate() {
                let theirs = number(row, column);
                let [u1, u2] = motion.ends(&[times[sample]]).unwrap()[0];
                let static_part = if index < 2 { spring.static_force(u2 - u1) } else { 0.0 };
                peak = peak.max((theirs - static_part).abs());
                worst = worst.max((ours(sample)[index] - theirs).abs());
            }
            assert!(worst < 1e-12 * peak, "{} {} {column}: {:e}", case["spring"], case["case"], worst / peak);
        }
    }
}
