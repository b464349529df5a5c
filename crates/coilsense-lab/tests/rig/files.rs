//! The files, and what is refused.

use coilsense_lab::output::Output;
use coilsense_lab::rig::{Rig, RigError};
use coilsense_lab::spec::Spec;

use super::{PAPER, PERFECT, S_T, log, rig, spec};

const QUICK: &str = "\n[mount]\ndamping_ratio = 0.005\n[rig]\nduration = \"2 s\"\nreadings = 3\nfrequencies = 2\nhits = 1\nhits_per_run = 1\ncalibration_positions = 3\n";

/// Every file of a rig and its text, by name.
fn files(tables: &str, seed: u64) -> Vec<(String, String)> {
    let place = tempfile::tempdir().unwrap();
    let mut output = Output::begin(place.path()).unwrap();
    rig(tables, seed).write(&mut output, &|_, _| true).unwrap();
    output.commit().unwrap();
    let entries = std::fs::read_dir(place.path()).unwrap().map(|entry| entry.unwrap());
    let mut files: Vec<(String, String)> = entries
        .filter(|entry| entry.file_name() != coilsense_lab::output::WRITTEN)
        .map(|entry| (entry.file_name().into_string().unwrap(), std::fs::read_to_string(entry.path()).unwrap()))
        .collect();
    files.sort();
    files
}

#[test]
fn every_file_says_that_it_is_simulated_and_is_in_the_list() {
    let files = files(QUICK, 9);
    // Calibration, preload, two sines, preload, one run of hits: two files each, and the list.
    assert_eq!(files.len(), 13);
    let mark = format!("# simulated by coilsense {} rig, seed 9, spring S_T, ζ = 0.005\n", env!("CARGO_PKG_VERSION"));
    for (name, text) in &files {
        assert!(text.starts_with(&mark), "{name}: {text:.100}");
    }
    let list: toml::Table = files.iter().find(|(name, _)| name == "experiment.toml").unwrap().1.parse().unwrap();
    assert_eq!(list["simulated"].as_bool(), Some(true));
    assert_eq!((list["nominal_force"].as_str(), list["averaging"].as_str()), (Some("121.6 N"), Some("445 ms")));
    assert_eq!(list["length_at_zero_force"].as_str(), Some("104 mm"));
    let mut listed = vec!["experiment.toml".to_owned()];
    let mut kinds = Vec::new();
    for run in list["run"].as_array().unwrap() {
        listed.extend(["fast", "slow"].map(|key| run[key].as_str().unwrap().to_owned()));
        kinds.push(run["kind"].as_str().unwrap());
    }
    listed.sort();
    assert_eq!(listed, files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>());
    assert_eq!(kinds, ["calibration", "preload", "harmonic", "harmonic", "preload", "hit"]);
    let second = &list["run"][3];
    assert_eq!((second["frequency"].as_str(), second["amplitude"].as_str()), (Some("4.49438202247 Hz"), Some("1 mm")));
}

#[test]
fn numbers_have_the_digits_of_their_devices() {
    let files = files(QUICK, 1);
    let text = |name: &str| &files.iter().find(|(file, _)| file == name).unwrap().1;
    let rows = |name: &str| text(name).lines().filter(|line| !line.starts_with('#')).collect::<Vec<_>>();
    let fast = rows("harmonic-01-fast.csv");
    assert_eq!((fast.len(), fast[0]), (5001, "time [s],F_o [N],u1 [mm]"));
    assert!(fast[2].starts_with("0.0004,"));
    let slow = rows("harmonic-01-slow.csv");
    assert_eq!((slow.len(), slow[0]), (4, "time [s],L [uH]"));
    assert_eq!(rows("calibration-slow.csv")[0], "time [s],u1 [mm],F_o [N],L [uH]");
    let decimals =
        |row: &str| row.split(',').map(|field| field.split('.').nth(1).map_or(0, str::len)).collect::<Vec<_>>();
    assert_eq!((decimals(fast[1]), decimals(slow[1])), (vec![4, 4, 4], vec![6, 5]));
}

#[test]
fn the_same_seed_writes_the_same_bytes() {
    assert_eq!(files(QUICK, 3), files(QUICK, 3));
    let [one, other] = [3, 4].map(|seed| files(QUICK, seed));
    assert!(one.iter().zip(&other).all(|(one, other)| one.0 == other.0 && one.1 != other.1));
}

#[test]
fn a_stop_leaves_nothing() {
    let place = tempfile::tempdir().unwrap();
    let mut output = Output::begin(&place.path().join("out")).unwrap();
    let error = rig(QUICK, 1).write(&mut output, &|done, _| done < 2).unwrap_err();
    assert!(matches!(error, RigError::Interrupted), "{error}");
    drop(output);
    assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 0);
}

/// What the first run that cannot be says, or the rig itself.
fn refusal(tables: &str) -> String {
    let rig = match Rig::new(&spec(tables), 1) {
        Ok(rig) => rig,
        Err(error) => return error.to_string(),
    };
    (0..rig.runs().len()).find_map(|run| rig.log(run).err()).map_or_else(String::new, |error| error.to_string())
}

#[test]
fn what_a_rig_cannot_do_is_said() {
    for (tables, expected) in [
        ("".into(), "test.toml: [mount] damping_ratio must be one value for a rig, such as 0.005, got none"),
        (
            "[mount]\ndamping_ratio = [0.0, 0.01]".into(),
            "[mount] damping_ratio must be one value for a rig, such as 0.005, got 2",
        ),
        ("[mount]\nend2 = \"force\"\ndamping_ratio = 0.01".into(), "[mount] end2 must be \"held\" for a rig"),
        (
            format!("{PAPER}readings = 100"),
            "[rig] readings = 100: must be at most 89, since the LCR meter takes 0.445 s",
        ),
        (format!("{PAPER}sample_rate = \"100 Hz\""), "[rig] sample_rate = 100 Hz: must be above 107.8"),
        (
            format!("{PAPER}sample_rate = \"1 MHz\""),
            "[rig] 38872881 samples in calibration, 838872881 in all: must be at most 4000000 and 200000000",
        ),
        (
            format!("{PAPER}hits_per_run = 7\nhit_duration = \"600 ms\""),
            "[rig] hit_duration = 0.6 s: must be at most 0.571428571429 s",
        ),
        (format!("{QUICK}amplitude = \"7 mm\""), "u1 reaches 7.0"),
        (
            format!("{QUICK}amplitude = \"4.9 mm\"\npreload = \"3 N\"\ncalibration_travel = \"1 mm\""),
            "[rig] amplitude = 4.9 mm closes the coil in harmonic-01: windings come within 1.98",
        ),
        (format!("{QUICK}preload = \"2 N\""), "[rig] calibration_travel = 9 mm closes the coil in calibration: "),
        (format!("{QUICK}preload = \"109 N\""), "F_o reaches 112.4"),
        (
            format!("{QUICK}hit_height = \"4 mm\"\npreload = \"5 N\"\ncalibration_travel = \"1 mm\""),
            "[rig] hit_height = 4 mm closes the coil in hit-1",
        ),
    ] {
        let refusal = refusal(&tables);
        assert!(refusal.contains(expected), "{refusal:?} instead of {expected:?}");
        assert_eq!(refusal.lines().count(), 1);
    }
}

#[test]
fn what_is_called_as_before_is_read_with_a_note() {
    let before = QUICK.replace("hits_per_run", "taps_per_run").replace("hits = ", "taps = ");
    let rigs = [rig(QUICK, 1), rig(&before, 1)];
    assert_eq!(rigs[0].runs(), rigs[1].runs());
    assert!(rigs[0].warnings().is_empty());
    let note = |before: &str, now: &str| {
        format!("[rig] {before} is called {now} now; the next release no longer reads {before}")
    };
    assert_eq!(rigs[1].warnings(), [note("taps", "hits"), note("taps_per_run", "hits_per_run")]);
    // Under both names it would not be clear which holds.
    let both = Spec::parse("S.toml", &format!("{S_T}{}", QUICK.replace("hits = 1", "hits = 1\ntaps = 2")), &|_| {
        Err(String::new())
    });
    assert!(both.unwrap_err().to_string().contains("unknown key \"taps\" in [rig]"));
}

#[test]
fn magnetic_wire_is_measured_as_such_or_warned_of() {
    let of = |wire: &str| {
        let told = S_T.replacen("[spring]", &format!("[spring]\n{wire}"), 1);
        let sensor = "kind = \"inductance\"";
        let text = format!("{told}{PERFECT}").replace(sensor, &format!("{sensor}\ncalibration_form = \"1 %\""));
        let spec = Spec::parse("test.toml", &text, &|name| Err(format!("{name}: no files here"))).unwrap();
        let rig = Rig::new(&spec, 1).unwrap();
        let readings = log(&rig, "calibration").slow.values("L").unwrap().to_vec();
        (readings, rig.warnings().to_vec())
    };
    let (air, steel, carbon) = (of(""), of("relative_permeability = 2.5"), of("relative_permeability = 60"));
    assert!(air.1.is_empty() && steel.1.is_empty());
    for (air, steel) in air.0.iter().zip(&steel.0) {
        assert!((1.05..1.2).contains(&(steel / air)), "{steel} and {air}");
    }
    assert_eq!(air.0, carbon.0);
    assert!(carbon.1.len() == 1 && carbon.1[0].starts_with("relative_permeability = 60 is left out"), "{:?}", carbon.1);
}

#[test]
fn an_undamped_spring_is_warned_of() {
    let tables = QUICK.replace("0.005", "0");
    let warnings = rig(&tables, 1).warnings().to_vec();
    assert!(
        warnings.len() == 1 && warnings[0].starts_with("without damping a resonance never settles"),
        "{warnings:?}"
    );
    assert!(rig(PERFECT, 1).warnings().is_empty());
    assert!(rig(&format!("{PAPER}distortion = \"0 %\""), 1).warnings()[0].starts_with("without distortion"));
}

#[test]
fn settings_of_any_size_are_refused_or_run() {
    let units = [
        ("preload", "N"),
        ("sample_rate", "Hz"),
        ("duration", "s"),
        ("pause", "s"),
        ("amplitude", "m"),
        ("calibration_travel", "m"),
        ("settling", "s"),
        ("hit_height", "m"),
        ("hit_duration", "s"),
    ];
    let sized = units.iter().flat_map(|(key, unit)| {
        ["1e-9", "1e-6", "1e-3", "1", "1e3", "1e6", "1e9"].map(|value| format!("{key} = \"{value} {unit}\"\n"))
    });
    let counted =
        ["readings = 1", "frequencies = 200", "hits = 1000", "hits_per_run = 7", "calibration_positions = 1000"]
            .map(|key| format!("{key}\n"));
    let dynamics = [
        "bandwidth = \"1e-9 Hz\"",
        "bandwidth = \"1e9 Hz\"",
        "delay = \"1e9 s\"",
        "sample_rate = \"1e-9 Hz\"",
        "averaging = \"1e9 s\"",
    ];
    let watched = dynamics.map(|key| format!("[[sensor]]\nkind = \"load-cell\"\nrange = \"110 N\"\n{key}\n"));
    let metered = ["averaging = \"1e-9 s\"", "averaging = \"1e9 s\""]
        .map(|key| format!("[[sensor]]\nkind = \"inductance\"\n{key}\n"));
    for tables in sized.chain(counted).chain(watched).chain(metered) {
        let mut text = String::from("[mount]\ndamping_ratio = 0.01\n[rig]\n");
        for usual in ["duration = \"2 s\"\n", "readings = 3\n"] {
            if !tables.contains(&usual[..8]) {
                text.push_str(usual);
            }
        }
        let Ok(rig) = Rig::new(&spec(&format!("{text}{tables}")), 1) else { continue };
        for run in [0, 2, rig.runs().len() - 1] {
            match rig.log(run) {
                Ok(log) => {
                    for column in log.fast.columns.iter().chain(&log.slow.columns) {
                        assert!(column.values.iter().all(|value| value.is_finite()), "{tables} {}", column.name);
                    }
                }
                Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{tables}"),
            }
        }
    }
}
