//! Against `tests/golden/two_port.csv`.

use coilsense::Damping;
use coilsense::two_port::TwoPort;
use num_complex::Complex64;

use super::paper_springs::s_a;
use super::{EACH, answers, distance, with_windings};

/// Two-port, ω, expected answers and whether k_t is a sum over modes, for each golden row. A missing file fails.
fn golden() -> Vec<(String, TwoPort, f64, Vec<Complex64>, bool)> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/two_port.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let rows = reader.records().map(|record| {
        let row: Vec<String> = record.unwrap().iter().map(str::to_owned).collect();
        let number = |at: usize| row[at].parse::<f64>().unwrap();
        let (windings, value) = (number(1) as usize, number(3));
        let masses = if windings == 0 { EACH.len() } else { windings };
        let damping = match row[2].as_str() {
            "none" => Damping::None,
            "modal" => Damping::Modal(value),
            "each" => Damping::ModalEach((0..masses).map(|j| EACH[j % 6]).collect()),
            "mass" => Damping::MassProportional { rate: value },
            "stiffness" => Damping::StiffnessProportional { time: value },
            "hysteretic" => Damping::Hysteretic { loss_factor: value },
            other => panic!("unknown damping {other}"),
        };
        let summed = matches!(damping, Damping::Modal(_) | Damping::ModalEach(_));
        let spring = if row[0] == "S_A" { s_a() } else { with_windings(masses) };
        let two_port = if windings == 0 { TwoPort::wave(&spring, damping) } else { TwoPort::chain(&spring, damping) };
        let expected = (5..row.len()).step_by(2);
        let expected = expected.map(|at| Complex64::new(number(at), number(at + 1))).collect();
        (row[..5].join(" "), two_port.unwrap(), number(4), expected, summed)
    });
    rows.collect()
}

#[test]
fn every_answer_holds_against_direct_solves() {
    let (mut worst, mut rows): (f64, usize) = (0.0, 0);
    for (name, two_port, omega, expected, summed) in golden() {
        let ours = answers(&two_port.at(omega).unwrap());
        // What one part in 1e7 of ω does, per part: near a pole or zero the last bit of ω and τ counts that much.
        let beside = answers(&two_port.at(omega * (1.0 + 1e-7)).unwrap());
        for (column, (ours, theirs)) in ours.iter().zip(&expected).enumerate() {
            let condition = distance(beside[column], *theirs) * 1e7;
            // A sum over modes gives k_t relative to k_d, and so everything that is proportional to k_t.
            let dies_out =
                if summed && column != 0 && column != 2 { (expected[0] / expected[1]).norm().max(1.0) } else { 1.0 };
            let error = distance(*ours, *theirs) / (condition + 30.0 + dies_out);
            worst = worst.max(error);
            // Measured 1.2e-15 of these, a few roundings.
            assert!(error < 2e-15, "{name}, column {column}: {ours} {theirs}, {error:e}");
        }
        rows += 1;
    }
    println!("{rows} rows, worst {worst:e}");
    assert_eq!(rows, 432);
}
