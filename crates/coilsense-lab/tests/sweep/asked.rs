//! What is asked of a sweep afterwards: fronts and sensitivity indices whose answers are known, and a row's spec.

use std::path::Path;

use coilsense_lab::output::Output;
use coilsense_lab::pareto::{self, Question};
use coilsense_lab::report::{add_pareto, add_sensitivity, pareto_json, sensitivity_json};
use coilsense_lab::sensitivity::{self, Resampling};
use coilsense_lab::sweep::{Data, Dataset, Plan, PlanParameters, Sampling};

use super::{QUICK, numbers, of, texts, whole};

fn filled(folder: &Path, plan: &Plan) -> Dataset {
    let dataset = Dataset::create_or_open(folder, plan).unwrap();
    for chunk in dataset.missing().unwrap() {
        dataset.write(chunk, &plan.chunk_bytes(chunk, &|| true).unwrap().unwrap()).unwrap();
    }
    dataset
}

fn all(words: &[&str]) -> Vec<String> {
    words.iter().map(|word| (*word).to_owned()).collect()
}

/// Eleven stiffnesses by eleven masses, some of which are none.
fn grid() -> Plan {
    let over = ["spring.stiffness=600..900 N/m : 11", "spring.mass=-10..90 g : 11"];
    Plan::new(PlanParameters { chunk_rows: Some(17), ..of(QUICK, &over, &["f1", "mass", "stiffness"]) }).unwrap()
}

fn asked(dataset: &Dataset, minimize: &[&str], maximize: &[&str], conditions: &[&str]) -> pareto::Study {
    let question = Question::new(dataset.plan(), &all(minimize), &all(maximize), &all(conditions)).unwrap();
    pareto::Study::of(dataset, question).unwrap()
}

#[test]
fn the_fastest_of_soft_springs_are_those_of_least_mass() {
    let place = tempfile::tempdir().unwrap();
    let dataset = filled(place.path(), &grid());
    // f1 = ½ √(k/m): at each stiffness the least mass wins, and no stiffness beats another.
    let study = asked(&dataset, &["stiffness"], &["f1"], &["spring.mass > 25 g"]);
    let masses = numbers(&study.front, "spring.mass [kg]");
    assert_eq!((masses.len(), study.rows.len()), (11, 11));
    assert!(masses.iter().all(|mass| (mass - 0.03).abs() < 1e-12), "{masses:?}");
    let stiffnesses = numbers(&study.front, "spring.stiffness [N/m]");
    assert!(stiffnesses.is_sorted() && (stiffnesses[0] - 600.0).abs() < 1e-9);
    // The ends are the softest and the stiffest.
    assert_eq!(study.extremes, [0, 10]);
    // Of 121 rows those of masses −10 and 0 g are refused, those of 10 and 20 g fail the condition.
    let counts = study.counts;
    assert_eq!((counts.rows, counts.refused, counts.excluded, counts.compared), (121, 22, 22, 77));
    assert_eq!(counts.account(), "121 rows: 22 that could not be judged, 22 that fail a condition, 77 compared");
    let span = &study.spans[1];
    assert!((span.all[0] - 0.03).abs() < 1e-12 && (span.all[1] - 0.09).abs() < 1e-12 && span.front[1] < 0.031);
}

#[test]
fn designs_that_clash_or_are_refused_never_win() {
    let place = tempfile::tempdir().unwrap();
    // A wire of 12 turns that is as thick as its pitch of 16 mm touches itself; the impact needs room, too.
    let over = ["spring.wire_radius=1..9 mm : 33"];
    let plan = Plan::new(of(QUICK, &over, &["clearance", "wire_diameter"])).unwrap();
    let dataset = filled(place.path(), &plan);
    let status: Vec<String> = whole(&plan).iter().flat_map(|chunk| texts(chunk, "status")).collect();
    let bad = status.iter().filter(|status| *status != "ok").count() as u64;
    assert!(bad > 3 && bad < 30, "{status:?}");
    let study = asked(&dataset, &[], &["wire_diameter"], &[]);
    assert_eq!(study.counts.clash + study.counts.refused, bad);
    let last = status.iter().rposition(|status| status == "ok").unwrap();
    assert_eq!(study.rows, [last as u64]);
}

#[test]
fn ties_stay_together_and_come_in_the_order_of_rows() {
    let place = tempfile::tempdir().unwrap();
    let study = asked(&filled(place.path(), &grid()), &["mass"], &[], &[]);
    // Eleven stiffnesses share the least mass, 10 g.
    assert_eq!(study.rows.len(), 11);
    assert!(study.rows.is_sorted());
}

#[test]
fn the_spec_of_a_row_gives_that_row_again() {
    let over = [
        "spring.stiffness=600..900 N/m",
        "spring.windings=8..14",
        "condition.2.amplitude=0.05..0.2 %",
        "mount.damping_ratio=0..0.01",
        "sensor.laser.range=90..110 mm",
    ];
    let columns = ["F_o.rmsd", "F_i.max", "f1", "laser.combined"];
    let plan = Plan::new(PlanParameters { rows: Some(4), ..of(QUICK, &over, &columns) }).unwrap();
    let chunk = &whole(&plan)[0];
    for row in 0..4 {
        let spec = plan.spec_of(row as u64).unwrap();
        assert!(spec.starts_with(&format!("# Row {row} of a sweep: spring.stiffness = ")), "{spec}");
        // The name is a key whose value changes nothing.
        let again = Plan::new(of(&spec, &["spring.name=\"a\""], &columns)).unwrap();
        let again = &whole(&again)[0];
        for title in ["F_o.rmsd [%]", "F_i.max [%]", "f1 [Hz]", "laser.combined [%]"] {
            assert_eq!(numbers(again, title)[0], numbers(chunk, title)[row], "{title}");
        }
        assert_eq!(plan.design_of(row as u64).unwrap().spring.spring.surge_frequency(), numbers(chunk, "f1 [Hz]")[row]);
    }
    assert_eq!(plan.spec_of(4).unwrap_err().to_string(), "row 4: there are 4, counted from 0");
}

#[test]
fn rows_come_back_in_the_order_in_which_they_are_asked_for() {
    let place = tempfile::tempdir().unwrap();
    let dataset = filled(place.path(), &grid());
    let rows = [120, 3, 60, 3];
    assert_eq!(dataset.rows(&rows).unwrap().columns[0].1, Data::Whole(rows.map(|row| row as i64).to_vec()));
    assert_eq!(dataset.rows(&[121]).unwrap_err().to_string(), "row 121: there are 121, counted from 0");
    std::fs::remove_file(dataset.path(3)).unwrap();
    assert_eq!(dataset.rows(&[60]).unwrap_err().to_string(), "row 60 is not there yet");
    let study = asked(&dataset, &["mass"], &["f1"], &[]);
    assert_eq!((study.counts.planned, study.counts.rows), (121, 104));
}

/// f1 = ½ √k m^(−½), with a third variable that does nothing to it.
fn product(base_rows: u64, mass: &str) -> Plan {
    let over = ["spring.stiffness=600..900 N/m", mass, "condition.1.velocity=0.1..0.3 m/s"];
    let parameters = of(QUICK, &over, &["f1", "stiffness", "coil_diameter"]);
    let sampling = Some(Sampling::Saltelli);
    Plan::new(PlanParameters { sampling, rows: Some(base_rows), chunk_rows: Some(500), ..parameters }).unwrap()
}

#[test]
fn indices_of_a_product_are_those_of_its_factors() {
    let place = tempfile::tempdir().unwrap();
    let plan = product(512, "spring.mass=20..90 g");
    assert_eq!((plan.rows(), plan.parameters().rows), (512 * 5, Some(512)));
    let dataset = filled(place.path(), &plan);
    let study = sensitivity::Study::of(&dataset, &all(&["f1"]), Resampling::default()).unwrap();
    assert_eq!(study.variables, ["spring.stiffness", "spring.mass", "condition.1.velocity"]);
    // Means and mean squares of √k and of 1/√m over their ranges, in closed form.
    let (a, b) = (600.0_f64, 900.0_f64);
    let [k1, k2] = [2.0 / 3.0 * (b.powf(1.5) - a.powf(1.5)) / (b - a), 0.5 * (a + b)];
    let (a, b) = (0.02_f64, 0.09_f64);
    let [m1, m2] = [2.0 * (b.sqrt() - a.sqrt()) / (b - a), (b / a).ln() / (b - a)];
    let variance = k2 * m2 - (k1 * m1).powi(2);
    let [of_k, of_m] = [k2 - k1 * k1, m2 - m1 * m1];
    let first = [of_k * m1 * m1 / variance, of_m * k1 * k1 / variance, 0.0];
    let total = [of_k * m2 / variance, of_m * k2 / variance, 0.0];
    let found = study.columns[0].found.as_ref().unwrap();
    for variable in 0..3 {
        let index = &found.variables[variable];
        // 512 base rows of a scrambled Sobol sequence on a smooth function.
        assert!((index.first.value - first[variable]).abs() < 0.01, "{index:?} and {}", first[variable]);
        assert!((index.total.value - total[variable]).abs() < 0.01, "{index:?} and {}", total[variable]);
        assert!(index.total.lower <= total[variable] && total[variable] <= index.total.upper, "{index:?}");
    }
    let line = &sensitivity::answer(&study)[0];
    let expected = format!("f1 hangs on spring.mass (S_T {:.2})", found.variables[1].total.value);
    assert!(line.starts_with(&expected) && line.contains("condition.1.velocity does nothing"), "{line}");
}

#[test]
fn base_rows_with_refused_designs_are_left_out_and_told() {
    let place = tempfile::tempdir().unwrap();
    let dataset = filled(place.path(), &product(128, "spring.mass=-10..90 g"));
    let study = sensitivity::Study::of(&dataset, &[], Resampling::default()).unwrap();
    let found = study.columns[0].found.as_ref().unwrap();
    let status = dataset.read(&["status"]).unwrap();
    let Data::Texts(status) = &status[0] else { panic!() };
    let spoiled = status.chunks(5).filter(|base| base.iter().any(|status| status != "ok")).count();
    // A tenth of masses are none, and each base row has two of its own.
    assert!((18..34).contains(&spoiled), "{spoiled}");
    assert_eq!((found.base_rows, found.left_out), (128 - spoiled, spoiled));
    let lines = sensitivity::answer(&study);
    assert!(
        lines.iter().any(|line| line.contains(&format!("{spoiled} base rows are left out as wholes"))),
        "{lines:?}"
    );
    // A number that no variable moves has no indices, and says so.
    assert!(
        lines.iter().any(|line| line.starts_with("No indices of coil_diameter (it is 0.016 everywhere, ")),
        "{lines:?}"
    );
}

#[test]
fn what_cannot_be_asked_is_refused_in_one_line() {
    let place = tempfile::tempdir().unwrap();
    let dataset = filled(place.path(), &grid());
    let question = |minimize: &[&str], maximize: &[&str], conditions: &[&str]| {
        Question::new(dataset.plan(), &all(minimize), &all(maximize), &all(conditions)).unwrap_err().to_string()
    };
    let unknown = question(&["mas"], &[], &[]);
    assert!(
        unknown.starts_with("no column \"mas\"; did you mean mass? there are: row, spring.stiffness, "),
        "{unknown}"
    );
    assert_eq!(question(&["status"], &[], &[]), "column \"status\" holds no numbers");
    assert_eq!(question(&["mass"], &["mass"], &[]), "mass is asked for twice");
    assert_eq!(question(&[], &[], &[]), "a front has from 1 to 6 objectives, got 0");
    let wrong = [
        ("mass", "is not COLUMN < VALUE, with one of < <= > >= = != between them"),
        ("mass < 3 mm", "3 mm must be a number in kg, or a mass with its unit (kg, g, mg, lb, oz)"),
        ("status < ok", "status holds no numbers: compare it with = or !="),
    ];
    for (condition, message) in wrong {
        assert_eq!(question(&["mass"], &[], &[condition]), format!("{condition:?}: {message}"));
    }
    let none = Question::new(dataset.plan(), &all(&["mass"]), &[], &all(&["mass > 1"])).unwrap();
    assert_eq!(
        pareto::Study::of(&dataset, none).unwrap_err().to_string(),
        "no design is left to compare: 121 rows: 22 that could not be judged, 99 that fail a condition, 0 compared"
    );
    let of_grid = sensitivity::Study::of(&dataset, &[], Resampling::default()).unwrap_err().to_string();
    assert_eq!(of_grid, "sensitivity indices need a sweep with --sampling saltelli, this one is grid");
    let place = tempfile::tempdir().unwrap();
    let dataset = filled(place.path(), &product(8, "spring.mass=20..90 g"));
    let few = sensitivity::Study::of(&dataset, &all(&["f1"]), Resampling::default()).unwrap_err().to_string();
    assert_eq!(few, "f1: indices need at least 16 base rows whose evaluations all gave a number, got 8 of 8");
}

#[test]
fn files_hold_the_whole_front_and_both_pages_are_whole() {
    let place = tempfile::tempdir().unwrap();
    let dataset = filled(&place.path().join("sweep"), &grid());
    let study = asked(&dataset, &["stiffness", "mass"], &["f1"], &["mass < 60 g"]);
    let out = place.path().join("out");
    let mut output = Output::begin(&out).unwrap();
    add_pareto(&study, &dataset, "2026-11-22", &mut output).unwrap();
    output.commit().unwrap();
    let read = |name: &str| std::fs::read_to_string(out.join(name)).unwrap();
    let csv = read("pareto.csv");
    assert_eq!(csv.lines().count(), study.rows.len() + 1);
    assert!(csv.starts_with("row,spring.stiffness [N/m],spring.mass [kg],status,reason,f1 [Hz]"), "{csv}");
    let mut reader = csv::Reader::from_path(out.join("pareto.csv")).unwrap();
    let speeds = numbers(&study.front, "f1 [Hz]");
    for (record, speed) in reader.records().zip(speeds) {
        assert_eq!(record.unwrap()[5].parse::<f64>().unwrap(), speed);
    }
    let json: serde_json::Value = serde_json::from_str(&pareto_json(&study).unwrap()).unwrap();
    assert_eq!(json["front"].as_array().unwrap().len(), study.rows.len());
    assert_eq!(json["knee_row"], study.rows[study.knee]);
    let page = read("report.html");
    // Three pairs of objectives, drawn light and dark.
    assert!(page.matches("<svg").count() == 2 && page.contains("little stiffness, little mass, much f1"));
    assert!(!page.contains("http://") && !page.contains("https://") || page.contains("www.w3.org"));

    let dataset = filled(&place.path().join("saltelli"), &product(64, "spring.mass=20..90 g"));
    let study = sensitivity::Study::of(&dataset, &[], Resampling::default()).unwrap();
    let mut output = Output::begin(&out).unwrap();
    add_sensitivity(&study, &dataset, "2026-11-22", &mut output).unwrap();
    output.commit().unwrap();
    let json: serde_json::Value = serde_json::from_str(&sensitivity_json(&study).unwrap()).unwrap();
    assert_eq!(json["columns"][0]["variables"].as_array().unwrap().len(), 3);
    assert_eq!(read("report.html").matches("<figure>").count(), 2);
}
