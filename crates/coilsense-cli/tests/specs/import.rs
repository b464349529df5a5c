//! `coilsense import`: a log of any layout to SI units on one rising clock, or one line that says what is in the way.

use std::fs;

use super::{done, names, path, refused};

const LOG: &str = "Zeit;LC;Weg\n[s];[N];[mm]\n0,0;1,5;10\n0,1;1,6;11\n0,2;1,7;12\n";
const TOLD: [&str; 4] = ["--column", "time=Zeit", "--column", "F_o=LC"];

/// Runs `import` in a folder of its own on a log of this text; what was said, without the folder, and what is there.
fn imported(text: &str, options: &[&str], ending: &str, succeeds: bool) -> (String, Vec<String>, Vec<u8>) {
    let place = tempfile::tempdir().unwrap();
    let (log, out) = (place.path().join("run.csv"), place.path().join(format!("out.{ending}")));
    fs::write(&log, text).unwrap();
    let mut arguments = vec!["import", path(&log), "--out", path(&out)];
    arguments.extend(options);
    let said = if succeeds { done(&arguments) } else { refused(&arguments) };
    let folder = format!("{}/", place.path().display());
    (said.replace(&folder, ""), names(place.path()), fs::read(&out).unwrap_or_default())
}

#[test]
fn a_log_of_another_country_comes_out_in_si_units_with_its_account() {
    let (said, _, csv) = imported(LOG, &TOLD, "csv", true);
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(
        lines[..7],
        [
            "run.csv: text, columns separated by \";\", decimal comma, header in line 1",
            "  time from column 1 \"Zeit\"",
            "  F_o  from column 2 \"LC\"",
            "  not taken: column 3 \"Weg\"",
            "  3 rows read, none left out, 3 kept",
            "  sampled at 10 Hz",
            "  from 0 s to 0.2 s",
        ]
    );
    assert!(lines[7].starts_with("wrote out.csv in "));
    assert_eq!(String::from_utf8(csv).unwrap(), "time [s],F_o [N]\n0,1.5\n0.1,1.6\n0.2,1.7\n");
}

#[test]
fn every_format_can_be_written_and_parquet_read_again() {
    for ending in ["csv", "json", "parquet"] {
        let (_, names, bytes) = imported(LOG, &TOLD, ending, true);
        assert_eq!(names, [format!("out.{ending}").as_str(), "run.csv"]);
        assert!(!bytes.is_empty());
    }
    let place = tempfile::tempdir().unwrap();
    let [log, middle, last] = ["a.csv", "b.parquet", "c.csv"].map(|name| place.path().join(name));
    fs::write(&log, "# simulated: seed 1\ntime [s],F_o [N]\n0,1.5\n0.1,0.1\n").unwrap();
    done(&["import", path(&log), "--out", path(&middle)]);
    done(&["import", path(&middle), "--out", path(&last)]);
    assert_eq!(fs::read_to_string(&last).unwrap(), "# simulated: seed 1\ntime [s],F_o [N]\n0,1.5\n0.1,0.1\n");
}

#[test]
fn what_is_wrong_leaves_nothing_on_disk() {
    let (said, names, _) = imported(&LOG.replace("0,1;1,6", "0,1;oops"), &TOLD, "csv", false);
    assert_eq!(
        said,
        "error: run.csv:4: column 2 \"LC\": \"oops\" is not a number; --drop-incomplete leaves such rows out\n"
    );
    assert_eq!(names, ["run.csv"]);
    let (said, names, _) = imported(LOG, &TOLD, "xlsx", false);
    assert!(said.ends_with("out.xlsx: must end in one of csv, json, parquet\n"), "{said}");
    assert_eq!(names, ["run.csv"]);
    let broken = LOG.replace("0,1;1,6", "0,1;oops");
    let dropped = [&TOLD[..], &["--drop-incomplete"]].concat();
    let (said, ..) = imported(&broken, &dropped, "csv", true);
    assert!(
        said.contains("3 rows read, 1 left out, 2 kept\n    1 with a cell that is not a number, the first in line 4"),
        "{said}"
    );
}

#[test]
fn options_that_make_no_sense_are_refused() {
    for (option, value, words) in [
        ("--fill-gaps", "10", "must be a time with its unit"),
        ("--fill-gaps", "0 s", "must be above zero"),
        ("--fill-gaps", "-1 ms", "must be above zero"),
        ("--resample", "-1 Hz", "must be from 1e-9 to 1e9 Hz"),
        ("--resample", "2.5", "must be a frequency with its unit"),
        ("--preset", "rig", "no preset of that name; there are: lab-data"),
        ("--column", "LC", "must be NAME="),
        ("--mapping", "none.toml", "none.toml: cannot be read"),
    ] {
        let place = tempfile::tempdir().unwrap();
        let (log, out) = (place.path().join("run.csv"), place.path().join("out.csv"));
        fs::write(&log, LOG).unwrap();
        let output = super::coilsense(&["import", path(&log), "--out", path(&out), option, value]);
        let said = super::text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(words), "{option} {value}: {said}");
        assert_eq!(names(place.path()), ["run.csv"]);
    }
}

#[test]
fn a_second_device_is_put_on_the_first_ones_clock() {
    let place = tempfile::tempdir().unwrap();
    let [first, second, out] = ["a.csv", "b.csv", "out.csv"].map(|name| place.path().join(name));
    let motion = |time: f64| {
        (21.0 * time).sin() * (-(time - 1.0).powi(2)).exp() + (9.0 * time).cos() * (-(time - 3.0).powi(2)).exp()
    };
    let rows = |ahead: f64, tail: &str| -> String {
        (0..1000).map(|n| 0.005 * f64::from(n)).map(|t| format!("{t},{}{tail}\n", motion(t - ahead))).collect()
    };
    fs::write(&first, format!("time [s],F_o [N]\n{}", rows(0.0, ""))).unwrap();
    fs::write(&second, format!("time [s],F_x [N],L [uH]\n{}", rows(0.35, ",3.3"))).unwrap();
    let arguments = ["import", path(&first), "--out", path(&out), "--with", path(&second), "--clock", "F_o=F_x"];
    let said = done(&arguments);
    assert!(said.contains("its clock is off by -0.35") && said.contains("by its F_x against F_o"), "{said}");
    assert!(fs::read_to_string(&out).unwrap().starts_with("time [s],F_o [N],F_x [N],L [H]\n0,"));
    let said = refused(&arguments[..6]);
    assert!(said.contains("no channel is in both; name two that saw the same motion, as in --clock F_o=F_x"), "{said}");
}
