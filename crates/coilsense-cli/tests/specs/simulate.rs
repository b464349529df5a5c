//! `coilsense simulate`: the same series in every format, or nothing at all.

use std::fs::{self, File};
use std::path::Path;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use serde_json::Value;

use super::{QUICK, done, names, path, place, refused};

const COLUMNS: &str = "time [s],u1 [m],u2 [m],F_i [N],F_o [N],F_x [N],F_L [N],L [H],load cell [N],laser [m],laser [N],inductance [H],\
                       inductance [N]";

/// Header and rows of a CSV file.
fn csv(file: &Path) -> (String, Vec<Vec<String>>) {
    let text = fs::read_to_string(file).unwrap();
    let mut lines = text.lines().map(str::to_owned);
    let header = lines.next().unwrap();
    (header, lines.map(|line| line.split(',').map(str::to_owned).collect()).collect())
}

#[test]
fn several_runs_make_a_csv_each() {
    let (place, spec) = place(QUICK);
    let out = place.path().join("deep/out.csv");
    let said = done(&["simulate", path(&spec), "--out", path(&out)]);
    assert!(said.starts_with("804 samples of 4 runs in 4 files in "), "{said}");
    let stems = ["heel-strike-zeta-0.01", "heel-strike-zeta-0", "shake-zeta-0.01", "shake-zeta-0"];
    assert_eq!(names(&place.path().join("deep")), stems.map(|stem| format!("out-{stem}.csv")));
    assert_eq!(names(place.path()), ["deep", "spec.toml"]);
    let (header, rows) = csv(&place.path().join("deep/out-shake-zeta-0.csv"));
    assert_eq!(header, COLUMNS);
    assert_eq!(rows.len(), 201);
    assert!(rows.iter().flatten().all(|field| field.parse::<f64>().is_ok_and(f64::is_finite)));
    assert_eq!((rows[0][0].as_str(), rows[200][0].as_str()), ("0", "0.02"));
}

#[test]
fn windings_that_would_pass_through_one_another_are_told_of() {
    let hit = "\n[mount]\nend2 = \"held\"\ndamping_ratio = 0.01\n[[condition]]\nkind = \"impact\"\nlength = \"230 mm\"\n\
               duration = \"0.05 s\"\nsample_rate = \"10 kHz\"\nvelocity = ";
    let warned = |velocity: &str| {
        let (place, spec) = place(&format!("{hit}\"{velocity}\"\n"));
        let out = place.path().join("out.csv");
        let output = super::coilsense(&["simulate", path(&spec), "--out", path(&out)]);
        assert!(output.status.success(), "{output:?}");
        let said = String::from_utf8(output.stderr).unwrap();
        let json: Value =
            serde_json::from_str(&done(&["simulate", path(&spec), "--out", path(&out), "--overwrite", "--json"]))
                .unwrap();
        let touch = |text: &str| text.contains("windings touch from t = ");
        let warnings = json["warnings"].as_array().unwrap().iter().map(|warning| warning.as_str().unwrap());
        (said.lines().filter(|line| touch(line)).count(), warnings.filter(|warning| touch(warning)).count())
    };
    assert_eq!(warned("25 m/s"), (1, 1), "the hand formula has 13.6 m/s");
    assert_eq!(warned("1 m/s"), (0, 0));
}

#[test]
fn a_single_run_makes_a_single_csv_of_numbers() {
    let (place, spec) = place(&QUICK.replace("[0, 0.01]", "0").replace(
        "name = \"shake\"\nkind = \"harmonic\"\nfrequency = \"0.5 f1\"\namplitude = \"1 %\"",
        "kind = \"end-stop\"\nat = \"max\"",
    ));
    let spec_text = fs::read_to_string(&spec).unwrap();
    // One condition is enough.
    let one = spec_text.find("\n[[condition]]\nkind").unwrap();
    let after = spec_text[one + 2..].find("\n[[sensor]]").unwrap() + one + 2;
    fs::write(&spec, format!("{}{}", &spec_text[..one], &spec_text[after..])).unwrap();
    let out = place.path().join("out.csv");
    done(&["simulate", path(&spec), "--out", path(&out)]);
    assert_eq!(csv(&out).0, COLUMNS);
    assert_eq!(names(place.path()), ["out.csv", "spec.toml"]);
}

#[test]
fn one_file_and_parquet_hold_the_same_numbers_to_the_last_bit() {
    let (place, spec) = place(QUICK);
    let (table, binary) = (place.path().join("all.csv"), place.path().join("all.parquet"));
    done(&["simulate", path(&spec), "--out", path(&table), "--one-file"]);
    done(&["simulate", path(&spec), "--out", path(&binary)]);
    let (header, rows) = csv(&table);
    assert_eq!(header, format!("condition,damping,{COLUMNS}"));
    assert_eq!(rows.len(), 804);
    let reader = SerializedFileReader::new(File::open(&binary).unwrap()).unwrap();
    assert_eq!(reader.num_row_groups(), 4, "one for each run");
    let mut count = 0;
    for (row, expected) in reader.get_row_iter(None).unwrap().zip(&rows) {
        let row = row.unwrap();
        let titles: Vec<&str> = row.get_column_iter().map(|(title, _)| title.as_str()).collect();
        assert_eq!(titles.join(","), header);
        for ((_, field), expected) in row.get_column_iter().zip(expected) {
            match field {
                Field::Double(value) => assert_eq!(value.to_bits(), expected.parse::<f64>().unwrap().to_bits()),
                Field::Str(value) => assert_eq!(value, expected),
                other => panic!("{other:?}"),
            }
        }
        count += 1;
    }
    assert_eq!(count, rows.len());
}

#[test]
fn json_holds_every_column_under_a_key_of_its_own() {
    let (place, spec) = place(QUICK);
    let (out, table) = (place.path().join("out.json"), place.path().join("out.csv"));
    done(&["simulate", path(&spec), "--out", path(&out)]);
    done(&["simulate", path(&spec), "--out", path(&table), "--one-file"]);
    let json: Value = serde_json::from_str(&fs::read_to_string(&out).unwrap()).unwrap();
    assert_eq!(json["schema"], "coilsense/signals/1");
    let runs = json["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 4);
    assert_eq!((&runs[1]["condition"], &runs[1]["damping"]), (&"heel strike".into(), &"ζ = 0.01".into()));
    let keys = [
        "time_s",
        "u1_m",
        "u2_m",
        "f_i_n",
        "f_o_n",
        "f_x_n",
        "f_l_n",
        "l_h",
        "load_cell_n",
        "laser_m",
        "laser_n",
        "inductance_h",
        "inductance_n",
    ];
    let (_, rows) = csv(&table);
    for (number, run) in runs.iter().enumerate() {
        let columns = run["columns"].as_object().unwrap();
        assert_eq!(columns.len(), keys.len());
        for (place, key) in keys.iter().enumerate() {
            let last = columns[*key].as_array().unwrap()[200].as_f64().unwrap();
            let expected: f64 = rows[201 * number + 200][place + 2].parse().unwrap();
            // The test's own parser of JSON takes the last bit lightly; what is written is exact.
            assert!((last - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{key}: {last} and {expected}");
        }
    }
}

#[test]
fn what_cannot_be_written_leaves_nothing_behind() {
    let (place, spec) = place(QUICK);
    let file = place.path().join("file");
    fs::write(&file, "mine").unwrap();
    fs::create_dir(place.path().join("out.parquet")).unwrap();
    let inside = |name: &str| place.path().join(name);
    for (out, words) in [
        (inside("out.txt"), "must end in one of csv, json, parquet"),
        (inside("out"), "must end in one of csv, json, parquet"),
        (inside("out.CSV"), "must end in one of csv, json, parquet"),
        (inside("file/out.csv"), "file: is a file, a folder is needed"),
        (inside("out.parquet"), "out.parquet: is a folder, a file must take its place"),
        ("/proc/out.csv".into(), "/proc: cannot be written"),
        ("/".into(), "is no name of a file"),
    ] {
        let message = refused(&["simulate", path(&spec), "--out", path(&out)]);
        assert!(message.contains(words), "{words} in {message}");
    }
    assert_eq!(names(place.path()), ["file", "out.parquet", "spec.toml"]);
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
}

#[test]
fn a_spec_that_cannot_be_simulated_leaves_nothing_behind() {
    let (place, spec) = place("");
    let out = place.path().join("new/out.csv");
    let message = refused(&["simulate", path(&spec), "--out", path(&out)]);
    assert!(message.contains("no [[condition]] says what is done to the spring"), "{message}");
    fs::write(&spec, fs::read_to_string(&spec).unwrap().replace("65 g", "65 mm")).unwrap();
    let message = refused(&["simulate", path(&spec), "--out", path(&out)]);
    assert!(message.contains("spec.toml:10: mass = \"65 mm\": must be a mass"), "{message}");
    assert_eq!(names(place.path()), ["spec.toml"]);
}
