//! The files of a reproduction: complete, self-contained, and readable by machines.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use coilsense_lab::output::Output;
use coilsense_lab::report::add_reproduction;
use coilsense_lab::reproduce::{PaperSprings, Protocol, reproduce};

fn written(protocols: &[Protocol]) -> tempfile::TempDir {
    let place = tempfile::tempdir().unwrap();
    let reproduction = reproduce(PaperSprings::built_in().unwrap(), protocols).unwrap();
    let mut output = Output::begin(place.path()).unwrap();
    add_reproduction(&reproduction, &mut output).unwrap();
    output.commit().unwrap();
    place
}

fn names(folder: &Path) -> BTreeSet<String> {
    let all = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    all.filter(|name| name != coilsense_lab::output::WRITTEN).collect()
}

#[test]
fn the_folder_holds_report_tables_figures_and_signals() {
    let place = written(&Protocol::ALL);
    assert_eq!(names(place.path()), ["figures", "report.html", "signals", "tables.json"].map(String::from).into());
    let figures = names(&place.path().join("figures"));
    for figure in ["figure-2", "figure-4-S_T", "figure-4-S_A"] {
        for kind in ["svg", "png"] {
            assert!(figures.contains(&format!("{figure}.{kind}")), "{figures:?}");
        }
    }
    // Five conditions a spring, three of which the protocols read differently.
    assert_eq!(names(&place.path().join("signals")).len(), 16);
}

#[test]
fn the_report_needs_nothing_from_outside() {
    let place = written(&Protocol::ALL);
    let page = fs::read_to_string(place.path().join("report.html")).unwrap();
    for word in ["src=", "href=\"http", "@import", "url(", "<script"] {
        assert!(!page.contains(word), "{word}");
    }
    assert_eq!(page.matches("<svg").count(), 6, "three figures in two themes");
    for needed in ["Table II", "Table III", "Table I and", "Errors and limits", "prefers-color-scheme"] {
        assert!(page.contains(needed), "{needed}");
    }
}

#[test]
fn the_page_marks_just_the_cells_that_differ() {
    let place = written(&Protocol::ALL);
    let reproduction = reproduce(PaperSprings::built_in().unwrap(), &Protocol::ALL).unwrap();
    let page = fs::read_to_string(place.path().join("report.html")).unwrap();
    let computed =
        || reproduction.cells.iter().flat_map(|cell| cell.computed.iter().map(move |c| (c, cell.published.percent)));
    let differing = computed().filter(|(computed, printed)| computed.differs_from(*printed)).count();
    assert_eq!(page.matches("<td class=\"off\">").count(), differing);
    assert!((40..80).contains(&differing), "{differing}");
    for (cell, _) in computed() {
        // With a true minus, and none before zero.
        let shown = format!("{:.3}", cell.percent);
        let shown = if shown == "-0.000" { "0.000".to_owned() } else { shown.replace('-', "\u{2212}") };
        assert!(page.contains(&format!(">{shown}")), "{cell:?}");
    }
    for fact in [
        "9.248",
        "54.065",
        "168.523",
        "121.60",
        "0.36 µH (13 %)",
        "64.5 g",
        "79.3 g",
        "0.32 % of F_nom",
        "0.44 % of F_nom",
    ] {
        assert!(page.contains(fact), "{fact}");
    }
}

#[test]
fn tables_json_holds_60_cells_with_their_keys() {
    for (protocols, nulls) in [(&Protocol::ALL[..], [false, false]), (&[Protocol::Text][..], [false, true])] {
        let place = written(protocols);
        let text = fs::read_to_string(place.path().join("tables.json")).unwrap();
        let cells: Vec<serde_json::Map<String, serde_json::Value>> = serde_json::from_str(&text).unwrap();
        assert_eq!(cells.len(), 60);
        for cell in &cells {
            let keys: Vec<&str> = cell.keys().map(String::as_str).collect();
            let mut expected =
                ["table", "spring", "condition", "force", "published_percent", "text_percent", "tables_percent"];
            expected.sort_unstable();
            assert_eq!(keys, expected);
            assert!(cell["published_percent"].is_number());
            assert_eq!([cell["text_percent"].is_null(), cell["tables_percent"].is_null()], nulls);
        }
    }
}

#[test]
fn signals_come_back_from_csv_to_the_bit() {
    let place = written(&[Protocol::Tables]);
    let reproduction = reproduce(PaperSprings::built_in().unwrap(), &[Protocol::Tables]).unwrap();
    for result in &reproduction.cases {
        let path = place.path().join(format!("signals/{}.csv", result.file_stem()));
        let text = fs::read_to_string(&path).expect("one file per simulation");
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("time [s],F_i [N],F_o [N],F_x [N],F_L [N]"));
        let rows: Vec<Vec<f64>> =
            lines.map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect();
        assert_eq!(rows.len(), 2501);
        assert_eq!((rows[0][0], rows[2500][0]), (0.75, 1.0));
        for (column, channel) in coilsense::Channel::FORCES.into_iter().enumerate() {
            let values = result.signals.channel(channel).unwrap();
            assert!(rows.iter().zip(values).all(|(row, value)| row[column + 1] == *value), "{path:?} {channel:?}");
        }
    }
}

#[test]
fn two_runs_write_the_same_bytes() {
    let (one, two) = (written(&Protocol::ALL), written(&Protocol::ALL));
    for file in ["report.html", "tables.json", "figures/figure-4-S_T.png", "signals/S_A-resonance-text.csv"] {
        assert!(fs::read(one.path().join(file)).unwrap() == fs::read(two.path().join(file)).unwrap(), "{file}");
    }
}
