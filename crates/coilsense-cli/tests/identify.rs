//! `coilsense identify` as a person meets it: a log in, a verdict in the first line, a spec that `analyze` reads; bad logs in one line.

mod running;

use std::fmt::Write;
use std::path::{Path, PathBuf};

use coilsense::{Damping, Excitation, FarEnd, Motion, Mount};
use running::coilsense;

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// S_T at 1 kHz for 20 s: a slow triangle of the length, then five hits; noise of a rough kind, by a multiplicative generator.
fn log(folder: &Path) -> PathBuf {
    let spring = coilsense::paper::s_t();
    let mount = Mount::new(FarEnd::Position, Damping::Modal(0.01)).expect("damping is valid");
    let impact = Excitation::impact(0.23, 0.2).expect("the impact is valid");
    let times: Vec<f64> = (0..20_000).map(|n| f64::from(n) / 1000.0).collect();
    let ringing =
        Motion::mounted(&spring, &mount, &impact).and_then(|motion| motion.end_forces(&times)).expect("it moves");
    let still = spring.static_force(0.23);
    let mut state = 1_u64;
    let mut noise = |size: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        size * ((state >> 33) as f64 / (1_u64 << 30) as f64 - 1.0)
    };
    let mut log = String::from("# a bench\nt [s];LC 1 [N];LC 2 [N];motor [mm];joint [mm]\n");
    for (n, t) in times.iter().enumerate() {
        let slow = 0.03 * (1.0 - (t.min(8.0) / 4.0 - 1.0).abs());
        let since = |hit: usize| n.checked_sub(9000 + 2000 * hit);
        let of = |force: &[f64]| (0..5).filter_map(since).map(|after| force[after] - still).sum::<f64>();
        let force = spring.static_force(0.23 + slow);
        let (input, output) = (force + of(&ringing.input) + noise(0.05), force + of(&ringing.output) + noise(0.05));
        let (motor, joint) = (noise(0.005), 230.0 + 1e3 * slow + noise(0.005));
        let _ = writeln!(log, "{t:.3};{input:.4};{output:.4};{motor:.5};{joint:.5}");
    }
    let path = folder.join("bench.csv");
    std::fs::write(&path, log).expect("the log is written");
    path
}

const COLUMNS: [&str; 8] =
    ["--column", "F_i=LC 1 [N]", "--column", "F_o=LC 2 [N]", "--column", "u1=motor [mm]", "--column", "u2=joint [mm]"];

#[test]
fn a_tapped_spring_becomes_a_verdict_a_report_and_a_spec_that_analyze_reads() {
    let folder = tempfile::tempdir().expect("a folder");
    log(folder.path());
    let mut arguments = vec!["identify", "bench.csv", "--column", "time=t [s]"];
    arguments.extend(COLUMNS);
    let more = [
        "--windings",
        "52",
        "--radius",
        "8 mm",
        "--wire",
        "2 mm",
        "--spec-out",
        "found.toml",
        "--out",
        "report",
        "--date",
        "2026-11-22",
    ];
    arguments.extend(more);
    let output = coilsense(folder.path(), &arguments);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(text(&output.stdout).starts_with("spring: "), "{}", text(&output.stdout));
    let page = std::fs::read_to_string(folder.path().join("report/report.html")).expect("the page is there");
    assert!(
        page.contains("What rings in bench.csv") && page.contains("2026-11-22") && page.matches("<figure").count() == 4
    );
    let results = std::fs::read_to_string(folder.path().join("report/results.json")).expect("the results are there");
    let results: serde_json::Value = serde_json::from_str(&results).expect("they are JSON");
    assert_eq!(results["verdict"], "spring");
    // Noise of 0.03 N on ringing of 1.8 N: 1e-3 of f1 and 1 % of ζ leave room.
    let near = |key: &str, truth: f64, off: f64| {
        let value = results[key]["value"].as_f64().expect(key);
        assert!((value / truth - 1.0).abs() < off, "{key}: {value} for {truth}");
    };
    near("first_frequency_hz", 54.0573, 1e-3);
    near("damping_ratio", 0.01, 0.03);
    near("stiffness_n_per_m", 760.0, 1e-3);
    near("mass_kg", 0.065, 3e-3);
    near("length_at_zero_force_m", 0.104, 1e-3);
    let analysis = coilsense(folder.path(), &["analyze", "found.toml", "--out", "analysis"]);
    assert!(analysis.status.success(), "{}", text(&analysis.stderr));
}

#[test]
fn json_goes_to_the_terminal_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    log(folder.path());
    let mut arguments = vec!["identify", "bench.csv", "--json", "--column", "time=t [s]"];
    arguments.extend(COLUMNS);
    let output = coilsense(folder.path(), &arguments);
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    assert_eq!(value["schema"], "coilsense/identification/2");
    assert_eq!(value["hits_s"].as_array().map(Vec::len), Some(5));
}

#[test]
fn bad_logs_and_settings_give_one_line_and_leave_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let logs: [(&str, &str, &str); 5] = [
        ("short.csv", "time [s],F_o [N]\n0,1\n0.1,2\n0.2,3\n", "at least 64 values, got 3"),
        ("nan.csv", "time [s],F_o [N]\n0,1\n0.1,nan\n0.2,3\n", "nan.csv"),
        ("empty.csv", "", "empty.csv"),
        ("header.csv", "time [s],F_o [N]\n", "header.csv"),
        ("forceless.csv", "time [s],u1 [m]\n0,1\n0.1,2\n0.2,3\n", "forceless.csv"),
    ];
    for (name, content, said) in logs {
        std::fs::write(folder.path().join(name), content).expect("the log is written");
        let output = coilsense(folder.path(), &["identify", name, "--out", "report"]);
        let error = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name}: {error}");
        assert!(error.starts_with("error: ") && error.contains(said) && error.lines().count() == 1, "{name}: {error}");
        assert!(!folder.path().join("report").exists(), "{name} leaves nothing");
    }
    let output = coilsense(folder.path(), &["identify", "short.csv", "--spec-out", "found.toml"]);
    assert!(text(&output.stderr).contains("--windings"), "{}", text(&output.stderr));
    for wrong in [["--tolerance", "0 %"], ["--mass", "65"], ["--accuracy-force", "200 %"]] {
        assert_eq!(coilsense(folder.path(), &["identify", "short.csv", wrong[0], wrong[1]]).status.code(), Some(2));
    }
}

#[test]
fn constant_logs_are_undecided_without_a_panic() {
    let folder = tempfile::tempdir().expect("a folder");
    for value in ["0", "5", "-1e-3"] {
        let rows: String = (0..500).map(|n| format!("{},{value},{value},{value}\n", f64::from(n) / 100.0)).collect();
        std::fs::write(folder.path().join("constant.csv"), format!("time [s],F_i [N],F_o [N],u2 [m]\n{rows}"))
            .expect("the log is written");
        let output = coilsense(folder.path(), &["identify", "constant.csv", "--out", "report"]);
        assert!(output.status.success(), "{value}: {}", text(&output.stderr));
        assert!(text(&output.stdout).starts_with("undecided: nothing rings"), "{}", text(&output.stdout));
    }
}

#[test]
fn what_may_be_folded_is_not_told_as_the_springs_first_mode() {
    // Modes 1 to 3 of 96.8 Hz, folded: two of them fit a series without its first mode, and "if it is the spring" told its f1 with a narrow interval.
    for rate in [140.0, 180.0, 200.0] {
        let mut log = "time [s],F_i [N]\n".to_owned();
        for n in 0..3000_u32 {
            let time = f64::from(n) / rate;
            let since = time % 2.0;
            let ring = |(mode, size): (f64, f64)| {
                let angular = std::f64::consts::TAU * 96.825 * mode;
                size * (-0.005 * angular * since).exp() * (angular * since).sin()
            };
            let noise = 0.05 * (f64::from(n) * 12.9898).sin();
            let rings: f64 = [(1.0, 6.3), (2.0, 8.4), (3.0, 7.3)].map(ring).iter().sum();
            log += &format!("{time},{}\n", -100.0 + rings + noise);
        }
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("coarse.csv"), log).unwrap();
        let run = |arguments: &[&str]| {
            let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_coilsense"));
            command.current_dir(folder.path()).args(["identify", "coarse.csv"]).args(arguments).output().unwrap().stdout
        };
        let told: serde_json::Value = serde_json::from_slice(&run(&["--json"])).unwrap();
        // A series is found, and is another one by far.
        let first = told["first_frequency_hz"]["value"].as_f64().unwrap();
        assert!(told["verdict"] == "undecided" && (first / 96.825 - 1.0).abs() > 0.5, "{rate}: {first}");
        let said = String::from_utf8(run(&[])).unwrap();
        let numbers = ["f1 =", "ζ", "mass kτ²", "of its amplitude"];
        let head = said.split("\n\n").next().unwrap();
        assert!(numbers.iter().all(|number| !head.contains(number)), "{rate}: {said}");
    }
}
