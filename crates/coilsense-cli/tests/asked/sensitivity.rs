//! `coilsense sensitivity`: indices of a sweep beside those of its law in closed form.
//!
//! F_nom = k (l_max − l_0): a sum of lengths, which a third variable multiplies. So S_1 and S_T of all three are known, and differ.

use std::fs;

use super::{Place, names, number, rows, text};

/// 1024 base rows of k, l_max, l_0 and the velocity, which does nothing to F_nom.
const SWEEP: [&str; 18] = [
    "sweep",
    "spec.toml",
    "--over",
    "spring.stiffness=400..1200 N/m",
    "--over",
    "spring.max_length=50..70 mm",
    "--over",
    "spring.rest_length=28..32 mm",
    "--over",
    "condition.strike.velocity=0.01..0.02 m/s",
    "--sampling",
    "saltelli",
    "--rows",
    "1024",
    "--columns",
    "nominal_force,stiffness,coil_diameter",
    "--out",
    "sweep",
];

const KEYS: [&str; 4] = ["spring.stiffness", "spring.max_length", "spring.rest_length", "condition.strike.velocity"];

/// S_1 and S_T of k (a − b) for independent uniform k, a, b, and of what it does not hang on.
fn closed_form() -> ([f64; 4], [f64; 4]) {
    let [k, a, b] = [[400.0_f64, 1200.0], [0.05, 0.07], [0.028, 0.032]];
    let mean = |[from, to]: [f64; 2]| 0.5 * (from + to);
    let variance = |[from, to]: [f64; 2]| (to - from).powi(2) / 12.0;
    let (travel, of_travel) = (mean(a) - mean(b), variance(a) + variance(b));
    let (k2, travel2) = (mean(k).powi(2) + variance(k), travel.powi(2) + of_travel);
    let all = k2 * travel2 - (mean(k) * travel).powi(2);
    let first = [variance(k) * travel.powi(2), mean(k).powi(2) * variance(a), mean(k).powi(2) * variance(b), 0.0];
    let total = [variance(k) * travel2, k2 * variance(a), k2 * variance(b), 0.0];
    (first.map(|part| part / all), total.map(|part| part / all))
}

#[test]
fn indices_of_a_product_of_sums_are_those_of_its_closed_form() {
    let place = Place::new();
    place.printed(&SWEEP);
    let printed =
        place.printed(&["sensitivity", "sweep", "--of", "nominal_force", "--out", "asked", "--date", "2026-11-22"]);
    assert!(printed.contains("2 files in asked; open asked/report.html"), "{printed}");
    assert_eq!(names(&place.path("asked")), ["report.html", "results.json"]);
    let json = place.json("asked/results.json");
    let found = &json["columns"][0];
    assert_eq!((&found["column"], &found["base_rows"]), (&"nominal_force [N]".into(), &1024.into()));
    let (first, total) = closed_form();
    // Together they move more than each alone: what the law says, and what makes S_T another number than S_1.
    assert!(first.iter().sum::<f64>() < 0.99 && total.iter().sum::<f64>() > 1.005);
    for (place, key) in KEYS.iter().enumerate() {
        let own = &found["variables"][place];
        assert_eq!(own["key"], *key);
        let value = |order: &str, part: &str| own[order][part].as_f64().expect("a number");
        // 1024 base rows of a scrambled Sobol sequence on a smooth function: better than 0.01.
        for (order, exact) in [("first_order", first[place]), ("total", total[place])] {
            let found = value(order, "value");
            assert!((found - exact).abs() < 0.01, "{key}: {order} {found}, not {exact}");
            assert!(value(order, "lower") <= found && found <= value(order, "upper"));
        }
    }
    let total = found["variables"][0]["total"]["value"].as_f64().expect("a number");
    assert!(printed.contains(&format!("nominal_force hangs on spring.stiffness (S_T {total:.2})")), "{printed}");
    assert!(fs::read_to_string(place.path("asked/report.html")).expect("read").contains("2026-11-22"));
}

/// Mean and variance are those of the rows that any reader of Parquet finds: of A and of B, the first and last of each base row.
#[test]
fn mean_and_variance_are_those_of_the_base_rows() {
    let place = Place::new();
    place.printed(&SWEEP);
    let json = place.printed(&["sensitivity", "sweep", "--of", "nominal_force [N]", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON and nothing else");
    let rows = rows(&place.path("sweep"));
    assert_eq!(rows.len(), 1024 * 6);
    let ends = rows.chunks(6).flat_map(|base| [&base[0], &base[5]]);
    let values: Vec<f64> = ends.map(|row| number(row, "nominal_force [N]")).collect();
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64;
    let found = |name: &str| json["columns"][0][name].as_f64().expect("a number");
    // Rounding of 2048 terms; the variance of a sample may count one less.
    assert!((found("mean") / mean - 1.0).abs() < 1e-12, "{} and {mean}", found("mean"));
    assert!((found("variance") / variance - 1.0).abs() < 1e-3, "{} and {variance}", found("variance"));
    assert_eq!(json["rows"]["there"], 1024 * 6);
}

#[test]
fn without_a_question_every_column_is_answered_or_says_why_not() {
    let place = Place::new();
    place.printed(&SWEEP);
    let printed = place.printed(&["sensitivity", "sweep", "--resamples", "50"]);
    assert!(printed.contains("stiffness hangs on spring.stiffness (S_T 1.00"), "{printed}");
    assert!(printed.contains("No indices of coil_diameter (it is 0.016 everywhere"), "{printed}");
    assert_eq!(names(place.folder.path()), ["spec.toml", "sweep"], "without --out nothing is written");
}

#[test]
fn what_cannot_be_asked_is_one_line_and_leaves_no_folder() {
    let place = Place::new();
    place.printed(&SWEEP);
    let refused = |options: &[&str]| place.refusal(&[&["sensitivity", "sweep", "--out", "asked"], options].concat());
    assert!(refused(&["--of", "F_o.rmsd"]).contains("no column \"F_o.rmsd\""));
    let constant = refused(&["--of", "coil_diameter"]);
    assert!(constant.contains("coil_diameter: ") && constant.contains("0.016 everywhere"), "{constant}");
    let resamples = refused(&["--of", "nominal_force", "--resamples", "3"]);
    assert!(resamples.contains("an interval needs 20 resamples or more"), "{resamples}");
    assert!(place.refusal(&["sensitivity", "nowhere"]).contains("nowhere"));
    assert!(!place.path("asked").exists());
    let word = place.run(&["sensitivity", "sweep", "--resamples", "many"]);
    assert_eq!(word.status.code(), Some(2), "{}", text(&word.stderr));
    // Rows that were laid out otherwise have no indices.
    place.printed(&["sweep", "spec.toml", "--over", "spring.mass=4..12 g : 3", "--columns", "f1", "--out", "grid"]);
    let grid = place.refusal(&["sensitivity", "grid", "--out", "asked"]);
    assert!(grid.contains("sensitivity indices need a sweep with --sampling saltelli, this one is grid"), "{grid}");
    assert!(!place.path("asked").exists());
}
