//! One and the same log, written in every way that instruments have.

use coilsense::Channel;
use coilsense_lab::recording::{COLUMN_KEYS, Cleaning, LOG_KEYS, Mapping, Points, keys_markdown};

use super::fixtures::{mapping, read, read_with};

/// Time 0, 0.1, 0.2 s and F_o 1.5, −2500, 1e-3 N: read to the last bit, since a number of a decimal text has one nearest double.
#[track_caller]
fn is_the_log(text: impl AsRef<[u8]>, columns: &[&str]) {
    let recording = read_with(text, &mapping(columns), &Cleaning::default()).unwrap();
    assert_eq!(recording.signals().time(), [0.0, 0.1, 0.2]);
    assert_eq!(recording.channel(Channel::OutputForce).unwrap(), [1.5, -2500.0, 1e-3]);
    assert_eq!((recording.account().read, recording.account().rows, recording.account().left_out()), (3, 3, 0));
}

#[test]
fn every_delimiter_and_decimal_sign_is_found_out() {
    is_the_log("time [s],F_o [N]\n0,1.5\n0.1,-2500\n0.2,1e-3\n", &[]);
    is_the_log("time [s];F_o [N]\n0;1.5\n0.1;-2.5e3\n0.2;1E-3\n", &[]);
    is_the_log("time [s];F_o [N]\n0,0;1,5\n0,1;-2500,0\n0,2;0,001\n", &[]);
    is_the_log("time [s]\tF_o [N]\n0\t+1.5\n0.1\t-2500\n0.2\t0.001\n", &[]);
    is_the_log("time [s]\tF_o [N]\n0\t1,5\n0,1\t-2500\n0,2\t0,001\n", &[]);
    is_the_log("time [s] | F_o [N]\n 0 | 1.5\n 0.1 | -2500\n 0.2 | 0.001\n", &[]);
    is_the_log("time [s]  F_o [N]\n  0    1.5\n  0.1  -2500\n  0.2  0.001\n", &[]);
    is_the_log("time [s], F_o [N]\n0, 1.5\n0.1, -2500\n0.2, 0.001\n", &[]);
}

#[test]
fn units_stand_in_titles_below_them_or_in_the_mapping() {
    is_the_log("time (ms),F_o (kN)\n0,0.0015\n100,-2.5\n200,1e-6\n", &[]);
    is_the_log("time/ms,F_o/mN\n0,1500\n100,-2500000\n200,1\n", &[]);
    is_the_log("time,F_o\ns,N\n0,1.5\n0.1,-2500\n0.2,1e-3\n", &[]);
    is_the_log("time;F_o\n[ms];[kN]\n0;0,0015\n100;-2,5\n200;0,000001\n", &[]);
    is_the_log("clock,LC\n0,1.5\n0.1,-2500\n0.2,1e-3\n", &["time=clock [s]", "F_o=LC [N]"]);
    is_the_log("0,9,1.5\n0.1,9,-2500\n0.2,9,1e-3\n", &["time=#1 [s]", "F_o=#3 [N]"]);
}

#[test]
fn marks_comments_quotes_and_blank_lines_do_no_harm() {
    is_the_log("\u{feff}time [s],F_o [N]\r\n0,1.5\r\n\r\n0.1,-2500\r\n0.2,1e-3", &[]);
    is_the_log("\"time [s]\",\"F_o [N]\",\"note, if any\"\n\"0\",\"1.5\",\"a,b\"\n0.1,-2500,\n0.2,1e-3,c\n", &[]);
    is_the_log("# rig 2\n% of today\n// by hand\ntime [s],F_o [N]\n0,1.5\n# a pause\n0.1,-2500\n0.2,1e-3\n", &[]);
    is_the_log("Measured on Monday; by hand\nRate: 10\ntime [s];F_o [N];\n0;1.5;\n0.1;-2500;\n0.2;1e-3;\n", &[]);
    is_the_log("# time [s], F_o [N]\n0 1.5\n0.1 -2500\n0.2 1e-3\n", &[]);
    is_the_log(b"time [s],F_o [N],L\xe4nge [\xb5m]\n0,1.5,1\n0.1,-2500,1\n0.2,1e-3,1\n", &[]);
}

#[test]
fn dates_and_times_of_day_are_seconds() {
    let text = "Zeit,F_o [N]\n23:59:59.9,1\n00:00:00.1,2\n";
    let message = read_with(text, &mapping(&["time=Zeit"]), &Cleaning::default()).unwrap_err();
    assert!(message.starts_with("run.csv:3: time goes back"), "{message}");
    let text = "Zeit,F_o [N]\n2026-11-21 23:59:59.9,1\n2026-11-22 00:00:00.1,2\n";
    let recording = read_with(text, &mapping(&["time=Zeit"]), &Cleaning::default()).unwrap();
    // Whole days count from the first, so that the last bits of a second are kept: 86 400.1 has 1.5e-11 of them.
    let time = recording.signals().time();
    assert!((time[1] - time[0] - 0.2).abs() < 3e-11, "{time:?}");
}

#[test]
fn a_log_without_a_time_column_has_the_clock_of_its_sample_rate() {
    let mut rated = mapping(&["F_o=#2 [N]"]);
    rated.format.sample_rate = Some(2500.0);
    let recording = read_with("7;1\n8;2\n9;3\n", &rated, &Cleaning::default()).unwrap();
    assert_eq!(recording.signals().time(), [0.0, 1.0 / 2500.0, 2.0 / 2500.0]);
    assert_eq!(recording.sample_rate().unwrap(), 2500.0);
}

#[test]
fn a_mapping_file_says_all_of_it() {
    let text = "! by the rig\n9;9;9\n1,0;0,5;3,0\n2,0;1,5;5,0\n";
    let mapping = Mapping::parse(
        "map.toml",
        r##"
        [log]
        delimiter = ";"
        decimal = ","
        header = false
        comment = "!"
        skip = 1
        sample_rate = "1 kHz"
        [columns]
        F_o = { column = "#1", gain = "12.5 N", factor = -1, offset = "2 N" }
        L = { columns = ["#2", "#3"], unit = "uH" }
        "##,
    )
    .unwrap();
    let recording = read_with(text, &mapping, &Cleaning::default()).unwrap();
    assert_eq!(recording.channel(Channel::OutputForce).unwrap(), [-10.5, -23.0]);
    assert_eq!(recording.channel(Channel::Inductance).unwrap(), [1.75e-6, 3.25e-6]);
    assert_eq!(recording.signals().time(), [0.0, 0.001]);
    assert_eq!((recording.account().read, recording.account().left_out(), recording.account().rows), (3, 1, 2));
}

#[test]
fn a_calibration_needs_no_clock() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("steps.csv");
    let pairs = |l: f64| (0..10).map(|i| format!("; 0.5; {}", l + f64::from(i))).collect::<String>();
    let text: String = (0..3).map(|row| format!("{row}; 10; 0.5; {}{}\n", 5 * row, pairs(f64::from(row)))).collect();
    std::fs::write(&path, text).unwrap();
    let points = Points::read(&path, &Mapping::preset("lab-data").unwrap(), &Cleaning::default()).unwrap();
    // The first row is left out; the mean of l, l + 1 … l + 9 is l + 4.5.
    assert_eq!(points.channel(Channel::U2).unwrap(), [0.005, 0.010]);
    assert_eq!(points.channel(Channel::Inductance).unwrap(), [5.5, 6.5]);
    assert_eq!((points.account().read, points.account().left_out(), points.lines()), (3, 1, &[2, 3][..]));
}

#[test]
fn a_log_says_itself_that_it_is_simulated() {
    let log = |head: &str| read(format!("{head}time [s],F_o [N]\n0,1\n1,2\n")).unwrap();
    assert_eq!(log("# simulated by coilsense, seed 7\n").simulated(), Some("simulated by coilsense, seed 7"));
    assert_eq!(log("# measured, not simulated\n").simulated(), None);
}

#[test]
fn the_reference_of_a_mappings_keys_is_up_to_date() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/guide/logs.md");
    let written = std::fs::read_to_string(path).unwrap();
    let (before, rest) = written.split_once("<!-- keys -->\n").expect("its beginning");
    let (_, after) = rest.split_once("<!-- end of keys -->").expect("its end");
    let expected = format!("{before}<!-- keys -->\n{}<!-- end of keys -->{after}", keys_markdown());
    if std::env::var_os("COILSENSE_WRITE_DOCS").is_some() {
        std::fs::write(path, &expected).expect("book/src/guide/logs.md can be written");
    }
    let refresh = "COILSENSE_WRITE_DOCS=1 cargo test -p coilsense-lab --test recording";
    assert!(
        std::fs::read_to_string(path).unwrap() == expected,
        "book/src/guide/logs.md is not what the reader says; refresh it: {refresh}"
    );
}

#[test]
fn every_key_of_a_mapping_is_read_and_its_example_taken() {
    for key in LOG_KEYS {
        let text = format!("[log]\n{} = {}\n", key.name, key.example);
        // A decimal comma cannot be told together with a delimiter that is one, but alone it can.
        assert_ne!(Mapping::parse("map.toml", &text).expect(key.name), Mapping::default(), "{}", key.name);
    }
    for key in COLUMN_KEYS {
        let column = if key.name.starts_with("column") || key.name == "constant" { "" } else { "column = \"LC\", " };
        let entry = |value: &str| format!("[columns]\nF_o = {{ {column}{} = {value} }}\n", key.name);
        Mapping::parse("map.toml", &entry(key.example)).expect(key.name);
        let message = Mapping::parse("map.toml", &entry("true")).expect_err(key.name).to_string();
        assert!(message.contains(&format!("{} = true: must be ", key.name)), "{message}");
    }
}

#[test]
fn a_first_row_that_is_too_short_is_no_remark() {
    let told = mapping(&["time=#1 [s]", "F_o=#2 [N]"]);
    let text = "0\n1,2\n2,3\n";
    let message = read_with(text, &told, &Cleaning::default()).unwrap_err();
    assert!(message.starts_with("run.csv:1: it has 1 column"), "{message}");
    let recording = read_with(text, &told, &Cleaning { drop_incomplete: true, ..Cleaning::default() }).unwrap();
    assert_eq!((recording.account().read, recording.account().left_out()), (3, 1));
}
