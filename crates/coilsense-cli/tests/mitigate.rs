//! `coilsense mitigate` as a person meets it.

use std::path::Path;
use std::process::{Command, Output};

const SPEC: &str = r#"
[spring]
name = "S_T"
model = "chain"
rest_length = "104 mm"
windings = 52
coil_radius = "8 mm"
wire_radius = "1 mm"
mass = "65 g"
stiffness = "760 N/m"
min_length = "196 mm"
max_length = "264 mm"

[mount]
end2 = "held"
damping_ratio = 0.01

[[condition]]
name = "heel strike"
kind = "impact"
length = "mid"
velocity = "0.25 m/s"
duration = "0.5 s"
"#;

fn mitigate(folder: &Path, arguments: &[&str]) -> Output {
    std::fs::write(folder.join("my.toml"), SPEC).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
    command.args(["mitigate", "my.toml"]).args(arguments).current_dir(folder);
    command.output().unwrap()
}

#[test]
fn a_spec_gets_advice_and_files_to_paste() {
    let folder = tempfile::tempdir().unwrap();
    let done = mitigate(folder.path(), &["--seeds", "1", "--rate", "1 kHz", "--noise", "0.2 N", "--out", "out"]);
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(text.starts_with("Best filter of F_i: ") && text.contains("10 files in out"), "{text}");
    for file in ["results.json", "trade-off.svg", "trade-off.png", "force_filter.h", "force_estimator.rs"] {
        assert!(folder.path().join("out").join(file).is_file(), "{file}");
    }
}

#[test]
fn the_page_holds_the_advice_first_and_needs_no_network() {
    let folder = tempfile::tempdir().unwrap();
    let asked = ["--seeds", "1", "--rate", "1 kHz", "--noise", "0.2 N", "--date", "2026-11-22", "--out", "out"];
    let done = mitigate(folder.path(), &asked);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let text = String::from_utf8(done.stdout).unwrap();
    let page = std::fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    let (advised, ranking) = (page.find(r#"class="answer""#).unwrap(), page.find(r#"id="ranking""#).unwrap());
    for line in text.lines().take(2) {
        // Advice is the same in both; the page escapes what HTML would read as its own, and has true minus signs.
        let printed = line.replace('<', "&lt;").replace('/', "&#x2f;").replace(" -", " \u{2212}");
        let place = page.find(&printed).unwrap_or_else(|| panic!("{line}"));
        assert!(advised < place && place < ranking, "{line}");
    }
    for part in
        ["on 2026-11-22", r#"id="trade-off""#, r#"id="time""#, "force_filter_settle(&amp;state", "[[condition]]"]
    {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("src=\"http") && !page.contains("href=\"http") && !page.contains("<script"));
}

#[test]
fn bad_input_is_one_line_and_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, told) in [
        (
            ["--rate", "100 Hz"],
            "my.toml: sampling rate must be above twice the first surge frequency of 54.065 Hz, got 100 Hz",
        ),
        (["--bandwidth", "0 Hz"], "invalid value '0 Hz' for '--bandwidth <FREQUENCY>': must be above zero"),
        (["--bandwidth", "60 Hz"], "bandwidth must be above zero and below the first surge frequency, got 60 Hz"),
        (["--mass-tolerance", "100 %"], "'--mass-tolerance <SHARE>': must be from 0 % to below 100 %"),
        (["--noise", "0.2"], "must be a force with its unit"),
        (["--noise", "-0.2 N"], "invalid value '-0.2 N' for '--noise <FORCE>': must be above zero"),
        (["--seeds", "0"], "'--seeds <COUNT>': must be from 1 to 1000"),
    ] {
        let done = mitigate(folder.path(), &[&arguments[..], &["--out", "out"]].concat());
        let text = String::from_utf8(done.stderr).unwrap();
        assert!(done.status.code() == Some(2) && text.contains(told), "{text}");
        assert!(!folder.path().join("out").exists());
    }
    let empty = mitigate(folder.path(), &["--mass-tolerance", "0 %", "--stiffness-tolerance", "0 %"]);
    assert!(String::from_utf8(empty.stderr).unwrap().contains("the box is empty"));
}

#[test]
fn a_rate_that_would_take_for_ever_is_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let done = mitigate(folder.path(), &["--rate", "10 MHz", "--out", "out"]);
    assert_eq!(done.status.code(), Some(2));
    let text = String::from_utf8(done.stderr).unwrap();
    assert!(text.contains("rate must be at most 4000000 Hz") && text.trim_end().lines().count() == 1, "{text}");
    assert!(!folder.path().join("out").exists());
}

/// S_T, u1 moving by 1 mm, ringing four times; from where u1 reads zero the coil is 230 mm long. `gain` of the load cell, `more` columns.
fn log(folder: &Path, gain: f64, broken: bool) {
    let row = |index: u32| {
        let time = f64::from(index) / 500.0;
        let u1 = 1e-3 * (1.9 * time).sin();
        let since = time % 2.5;
        let force = gain * (760.0 * (0.126 - u1) + 1.7 * (-3.4 * since).exp() * (339.7 * since).sin());
        let force = if broken && index == 700 { "NaN".to_owned() } else { force.to_string() };
        format!("{time},{},{force}\n", 1e3 * u1)
    };
    let text = "t,u1 [mm],LC [N]\n".to_owned() + &(0..5000).map(row).collect::<String>();
    std::fs::write(folder.join("run.csv"), text).unwrap();
}

#[test]
fn a_log_of_f_i_alone_is_judged_and_every_advice_is_an_option_that_there_is() {
    let folder = tempfile::tempdir().unwrap();
    log(folder.path(), 1.0, true);
    let mut arguments = vec!["--log", "run.csv", "--out", "out"];
    // What each error names is given next, until it is done.
    for (told, more) in [
        ("--column", ["--column", "F_i=LC [N]"]),
        ("--column time=", ["--column", "time=t [s]"]),
        ("run.csv:702", ["--drop-incomplete", "--sort"]),
        ("--resample", ["--resample", "500 Hz"]),
        ("", ["--fill-gaps", "5 ms"]),
    ] {
        let done = mitigate(folder.path(), &arguments);
        let text = String::from_utf8(done.stderr).unwrap();
        println!("{text}");
        if told.is_empty() && done.status.success() {
            break;
        }
        assert!(done.status.code() == Some(2) && text.trim_end().lines().count() == 1, "{text}");
        assert!(text.contains(told) || told.is_empty(), "{told}: {text}");
        assert!(!folder.path().join("out").exists());
        arguments.extend(more);
    }
    let done = mitigate(folder.path(), &arguments);
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(text.contains("The coil is 230.0") && text.contains("estimators of F_o cannot be"), "{text}");
    assert!(folder.path().join("out/trade-off.svg").is_file() && !folder.path().join("out/force_estimator.h").exists());
}

#[test]
fn a_gain_that_is_off_is_said_and_another_spring_refused() {
    let folder = tempfile::tempdir().unwrap();
    let columns = ["--log", "run.csv", "--column", "time=t [s]", "--column", "F_i=LC [N]"];
    log(folder.path(), 0.95, false);
    let text = String::from_utf8(mitigate(folder.path(), &columns).stdout).unwrap();
    assert!(text.contains("k from the log 72") && text.contains("take the log's"), "{text}");
    for (gain, told) in [(3.0, "3.00 times the spec's 760.0 N/m"), (-1.0, "the sign of F_i, u1 or u2 is turned")] {
        log(folder.path(), gain, false);
        let done = mitigate(folder.path(), &columns);
        let text = String::from_utf8(done.stderr).unwrap();
        assert!(done.status.code() == Some(2) && text.contains(told) && text.trim_end().lines().count() == 1, "{text}");
    }
    log(folder.path(), 1.0, false);
    let far = mitigate(folder.path(), &[&columns[..], &["--length-at-zero", "250 mm"]].concat());
    assert!(String::from_utf8(far.stdout).unwrap().contains("Warning: The coil is 250.000 mm long"));
    let free = mitigate(folder.path(), &[&columns[..], &["--end2", "free"]].concat());
    assert!(String::from_utf8(free.stderr).unwrap().contains("--end2 held says so"));
    let without = mitigate(folder.path(), &["--length-at-zero", "250 mm"]);
    assert!(String::from_utf8(without.stderr).unwrap().contains("--log"));
}
