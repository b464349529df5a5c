//! `coilsense pareto`: the front of a real sweep is the one that comparing each design with each gives.

use std::collections::BTreeMap;
use std::fs;

use parquet::record::Field;

use super::{Place, names, number, rows, text};

/// 400 designs of which some are refused; masses in steps of 1 g, so that there are ties.
const SWEEP: [&str; 14] = [
    "sweep",
    "spec.toml",
    "--over",
    "spring.mass=0, 4, 5, 6, 7, 8, 9, 10, 11, 12 g",
    "--over",
    "spring.stiffness=normal(760 N/m, 10 %)",
    "--over",
    "spring.wire_radius=0.8..1.2 mm",
    "--rows",
    "400",
    "--columns",
    "mass,f1,F_o.rmsd,stress",
    "--out",
    "sweep",
];

const ASKED: [&str; 10] = [
    "pareto",
    "sweep",
    "--minimize",
    "F_o.rmsd",
    "--minimize",
    "mass",
    "--maximize",
    "f1",
    "--where",
    "stress < 400 MPa",
];

/// Rows that no other row beats, by the definition: each compared with each.
fn beaten_by_none(rows: &[BTreeMap<String, Field>]) -> Vec<u64> {
    let compared = rows.iter().filter(|row| row["status"] == Field::Str("ok".to_owned()));
    let compared = compared.filter(|row| number(row, "stress [Pa]") < 400e6);
    let cost = |row: &BTreeMap<String, Field>| {
        (number(row, "row") as u64, [number(row, "F_o.rmsd [%]"), number(row, "mass [kg]"), -number(row, "f1 [Hz]")])
    };
    let costs: Vec<_> = compared.map(cost).collect();
    let beats = |a: &[f64; 3], b: &[f64; 3]| a != b && a.iter().zip(b).all(|(a, b)| a <= b);
    let free = costs.iter().filter(|(_, cost)| !costs.iter().any(|(_, other)| beats(other, cost)));
    free.map(|(row, _)| *row).collect()
}

#[test]
fn the_front_is_what_no_design_beats_one_by_one() {
    let place = Place::new();
    place.printed(&SWEEP);
    let expected = beaten_by_none(&rows(&place.path("sweep")));
    let printed = place.printed(&[&ASKED[..], &["--out", "front", "--date", "2026-11-22"]].concat());
    // More than a corner and less than all: a front that is worth finding.
    assert!((8..200).contains(&expected.len()), "{expected:?}");
    assert!(printed.contains("files in front; open front/report.html"), "{printed}");
    assert!(printed.contains(&format!("{} of ", expected.len())), "{printed}");

    let mut reader = csv(&place, "front/pareto.csv");
    let titles: Vec<String> = reader.remove(0);
    let at = |title: &str| titles.iter().position(|own| own == title).expect("a column");
    let mut found: Vec<u64> = reader.iter().map(|cells| cells[at("row")].parse().expect("a row")).collect();
    let errors: Vec<f64> = reader.iter().map(|cells| cells[at("F_o.rmsd [%]")].parse().expect("a number")).collect();
    assert!(errors.is_sorted(), "the best in the first objective comes first");
    let json = place.json("front/results.json");
    let of_json = json["front"].as_array().expect("a list").iter().map(|design| design["row"].as_u64().expect("a row"));
    assert_eq!(of_json.collect::<Vec<_>>(), found);
    found.sort_unstable();
    assert_eq!(found, expected);
    assert_eq!(names(&place.path("front")), EXPECTED_FILES);
    // The report carries the date that it was given, and the knee that the JSON names.
    let page = fs::read_to_string(place.path("front/report.html")).expect("read");
    assert!(page.contains("2026-11-22") && expected.contains(&json["knee_row"].as_u64().expect("a row")));
}

/// What a front of three objectives leaves in its folder.
const EXPECTED_FILES: [&str; 6] =
    ["front.png", "front.svg", "pareto.csv", "pareto.parquet", "report.html", "results.json"];

/// Cells of a file without quotes, its titles first.
fn csv(place: &Place, name: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(place.path(name)).expect("read");
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn parquet_csv_and_json_hold_the_same_numbers_as_the_sweep() {
    let place = Place::new();
    place.printed(&SWEEP);
    let json = place.printed(&[&ASKED[..], &["--out", "front", "--json"]].concat());
    assert_eq!(json, fs::read_to_string(place.path("front/results.json")).expect("read"), "the JSON and nothing else");
    let (all, front) = (rows(&place.path("sweep")), rows(&place.path("front")));
    let mut lines = csv(&place, "front/pareto.csv");
    let titles = lines.remove(0);
    assert_eq!(lines.len(), front.len());
    for (cells, design) in lines.iter().zip(&front) {
        let row = number(design, "row") as usize;
        assert_eq!(design, &all[row]);
        for (title, cell) in titles.iter().zip(cells).filter(|(title, _)| title.contains('[')) {
            assert_eq!(cell.parse::<f64>().expect("a number"), number(design, title), "{title} of row {row}");
        }
    }
}

#[test]
fn the_knees_spec_is_the_design_of_its_row() {
    let place = Place::new();
    place.printed(&SWEEP);
    let printed = place.printed(&[&ASKED[..], &["--out", "front", "--spec-row", "knee", "--spec-row", "7"]].concat());
    let knee = place.json("front/results.json")["knee_row"].as_u64().expect("a row");
    let spec = format!("front/row-{knee}.toml");
    assert!(printed.contains(&format!("coilsense analyze {spec}\ncoilsense analyze front/row-7.toml")), "{printed}");
    let written = fs::read_to_string(place.path(&spec)).expect("read");
    assert!(written.contains("# As the drawing has it."), "{written}");
    // The row again, from its spec alone.
    let again =
        ["sweep", &spec, "--over", "spring.name=\"a\"", "--columns", "mass,f1,F_o.rmsd,stress", "--out", "again"];
    place.printed(&again);
    let (all, again) = (rows(&place.path("sweep")), rows(&place.path("again")));
    for title in ["mass [kg]", "f1 [Hz]", "F_o.rmsd [%]", "stress [Pa]"] {
        assert_eq!(number(&again[0], title), number(&all[knee as usize], title), "{title}");
    }
}

#[test]
fn what_cannot_be_asked_is_one_line_and_leaves_no_folder() {
    let place = Place::new();
    place.printed(&SWEEP);
    let refused = |options: &[&str]| place.refusal(&[&["pareto", "sweep", "--out", "front"], options].concat());
    assert!(refused(&[]).contains("say what is wanted: --minimize COLUMN or --maximize COLUMN"));
    assert!(refused(&["--minimize", "mas"]).contains("no column \"mas\"; did you mean mass?"));
    assert!(refused(&["--minimize", "status"]).contains("column \"status\" holds no numbers"));
    assert!(refused(&["--minimize", "f1", "--maximize", "f1"]).contains("f1 is asked for twice"));
    let unit = refused(&["--minimize", "mass", "--where", "mass < 3 mm"]);
    assert!(unit.contains("3 mm must be a number in kg, or a mass with its unit (kg, g, mg, lb, oz)"), "{unit}");
    let none = refused(&["--minimize", "mass", "--where", "mass > 1 kg"]);
    assert!(
        none.contains("no design is left to compare: 400 rows: 40 that could not be judged, 360 that fail a condition"),
        "{none}"
    );
    // Refused after the front has been found: still nothing of it is written.
    let row = refused(&["--minimize", "mass", "--spec-row", "400"]);
    assert!(row.contains("row 400: there are 400, counted from 0"), "{row}");
    let word = refused(&["--minimize", "mass", "--spec-row", "best"]);
    assert!(word.contains("--spec-row best: must be a row's number, counted from 0, or knee"), "{word}");
    assert!(!place.path("front").exists(), "{:?}", names(&place.path("front")));
    assert!(place.refusal(&["pareto", "nowhere", "--minimize", "mass"]).contains("nowhere"));
    assert!(place.refusal(&["pareto", "spec.toml", "--minimize", "mass"]).contains("spec.toml"));
    // Options without their folder are the parser's business, which explains itself in more lines.
    let without = place.run(&["pareto", "sweep", "--minimize", "mass", "--spec-row", "knee"]);
    assert_eq!(without.status.code(), Some(2));
    assert!(text(&without.stderr).contains("--out <DIR>"), "{}", text(&without.stderr));
}

#[test]
fn files_that_are_not_the_commands_own_stay() {
    let place = Place::new();
    place.printed(&SWEEP);
    fs::create_dir(place.path("front")).expect("made");
    fs::write(place.path("front/notes.txt"), "mine").expect("written");
    let asked = [&ASKED[..], &["--out", "front"]].concat();
    place.printed(&asked);
    let first = fs::read(place.path("front/pareto.parquet")).expect("read");
    place.printed(&asked);
    assert_eq!(fs::read(place.path("front/pareto.parquet")).expect("read"), first, "asked again, answered the same");
    assert_eq!(fs::read_to_string(place.path("front/notes.txt")).expect("read"), "mine");
    // Readers of the folder would take the answer's files for rows.
    for (inside, apart) in
        [("sweep", false), ("sweep/front", false), ("./sweep/../sweep", false), ("sweep/_front", true)]
    {
        let within: Vec<&str> = asked.iter().map(|word| if *word == "front" { inside } else { word }).collect();
        let before = names(&place.path("sweep"));
        match apart {
            true => drop(place.printed(&within)),
            false => {
                let message = place.refusal(&within);
                assert!(
                    message.contains("lies in the sweep's folder") && message.contains("sweep/_asked"),
                    "{message}"
                );
                assert_eq!(names(&place.path("sweep")), before);
            }
        }
    }
    fs::remove_file(place.path("sweep/_manifest.json")).expect("removed");
    assert!(place.refusal(&asked).contains("sweep"));
}
