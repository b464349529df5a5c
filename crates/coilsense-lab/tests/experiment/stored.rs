//! A calibration that was stored, in place of the curve of the calibration run.

use std::path::PathBuf;

use coilsense_lab::experiment::{Findings, answer};

use super::{ALPHA, BETA, TOP, folder, read, usual, write};

const WITH_FILE: &str = "stiffness = \"760 N/m\"\nlength_at_zero = \"138 mm\"\ncalibration = \"calibration.toml\"\n";

/// The made-up curve as a table over lengths \[mm\].
fn table([from, to]: [f64; 2]) -> String {
    let row = |index: i32| {
        let length = 1e-3 * (from + (to - from) * f64::from(index) / 48.0);
        format!("[{:e}, {length}, 1e-4],", (1.0 / length - BETA) / ALPHA)
    };
    let rows: String = (0..49).map(row).collect();
    format!("schema = \"coilsense/stored-calibration/1\"\nrelation = \"steel\"\nremounting = 0\nrows = [{rows}]\n")
}

#[test]
fn forces_by_a_stored_table_are_those_of_the_curve_that_it_holds() {
    let given = folder(&format!("{TOP}{}", super::GIVEN), &usual());
    let place = folder(&format!("{TOP}{WITH_FILE}"), &usual());
    write(place.path(), "calibration.toml", &table([130.0, 146.0]));
    let (by_curve, by_file) = (read(&given).unwrap(), read(&place).unwrap());
    for (curve, file) in by_curve.runs.iter().zip(&by_file.runs) {
        let of = |run: &coilsense_lab::experiment::Run| run.inductance.unwrap().mean;
        assert!((of(curve) - of(file)).abs() < 1e-6, "{} and {}", of(curve), of(file));
    }
    let told = answer(&by_file, &Findings::of(&by_file)).join(" ");
    assert!(told.contains("calibration.toml, standard uncertainty of length 0.100 mm"), "{told}");
}

#[test]
fn a_table_that_is_not_there_too_short_or_not_the_only_one_is_refused_by_name() {
    let place = folder(&format!("{TOP}{WITH_FILE}"), &usual());
    let refused = || read(&place).unwrap_err().to_string();
    let file: PathBuf = place.path().join("calibration.toml");
    assert!(refused().starts_with(&format!("{}: ", file.display())), "{}", refused());
    write(place.path(), "calibration.toml", "rows = 3");
    assert!(
        refused().contains("calibration.toml: ") && refused().contains("is no stored calibration"),
        "{}",
        refused()
    );
    write(place.path(), "calibration.toml", &table([140.0, 146.0]));
    assert!(refused().contains("0-slow.csv") && refused().contains("reading 1: "), "{}", refused());
    assert!(refused().contains("must be from"), "{}", refused());
    let both = folder(&format!("{TOP}{WITH_FILE}inverse_length = {{ alpha = 1.6e6, beta = 0.3 }}\n"), &usual());
    let error = read(&both).unwrap_err().to_string();
    assert!(error.contains("give one"), "{error}");
}
