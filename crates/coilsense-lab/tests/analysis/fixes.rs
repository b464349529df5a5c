//! What is said to fix a sensor does: the change written into the spec, and the spec run again.

use coilsense_lab::analysis::Analysis;

use super::{HEEL_STRIKE, S_A, S_T, STILL, close, run, verdict};

/// Keys of a sensor, of the spring and of the uncertainty that a change sets, by the words of the change.
fn keys(change: &str) -> Vec<(&'static str, &'static str, String)> {
    let quoted = |text: &str| format!("\"{text}\"");
    let after = |words: &str| change.strip_prefix(words).map(|rest| quoted(rest.split(" of ").next().unwrap_or(rest)));
    let one = |table, key, value| vec![(table, key, value)];
    if let Some(window) = after("a mean over one surge period, ").or(after("an averaging window of ")) {
        one("sensor", "averaging", window)
    } else if let Some(cutoff) = after("a low-pass at half the surge frequency, ") {
        vec![("sensor", "bandwidth", cutoff), ("sensor", "order", "2".to_owned())]
    } else if let Some(bandwidth) = after("a bandwidth of ") {
        one("sensor", "bandwidth", bandwidth)
    } else if let Some(rate) = after("a sample rate of ") {
        one("sensor", "sample_rate", rate)
    } else if change == "no dead time" {
        one("sensor", "delay", quoted("0 s"))
    } else if let Some(end) = change.strip_prefix("its place at end ") {
        one("sensor", "end", end.to_owned())
    } else if change == "a drive train without backlash" {
        one("sensor", "backlash", quoted("0 m"))
    } else if change == "encoders on the spring's own ends" {
        vec![("sensor", "backlash", quoted("0 m")), ("sensor", "compliance", quoted("0 m/N"))]
    } else if let Some(share) = after("an accuracy of ") {
        one("sensor", if change.ends_with("reading") { "accuracy_reading" } else { "accuracy_full_scale" }, share)
    } else if let Some(share) = after("a gain calibrated to ") {
        one("sensor", "calibration_uncertainty", share)
    } else if let Some(share) = after("noise of ") {
        one("sensor", "noise", share)
    } else if let Some(share) = after("a resolution of ") {
        one("sensor", "resolution", share)
    } else if let Some(share) = after("a calibration that fits within ") {
        one("sensor", "calibration_form", share)
    } else if let Some(kelvin) = after("a temperature within ±") {
        one("uncertainty", "temperature_change", kelvin)
    } else if let Some(share) = after("a stiffness known within ±") {
        one("spring", "stiffness_tolerance", share)
    } else if let Some(length) = after("a rest length known within ±") {
        one("spring", "rest_length_tolerance", length)
    } else {
        panic!("what would {change:?} be in a spec?")
    }
}

/// A spec in parts: keys of its spring, uncertainty and only sensor, and the rest.
#[derive(Clone)]
struct Parts {
    spring: Vec<(&'static str, String)>,
    uncertainty: Vec<(&'static str, String)>,
    sensor: Vec<(&'static str, String)>,
    base: &'static str,
    rest: String,
}

impl Parts {
    fn run(&self) -> Analysis {
        let written =
            |keys: &[(&str, String)]| keys.iter().map(|(key, value)| format!("{key} = {value}\n")).collect::<String>();
        run(&format!(
            "{}\n{}[uncertainty]\ntrials = 1000\n{}[[sensor]]\nname = \"s\"\n{}{}",
            self.base,
            written(&self.spring),
            written(&self.uncertainty),
            written(&self.sensor),
            self.rest
        ))
    }

    fn with(&self, change: &str) -> Self {
        let mut parts = self.clone();
        for (table, key, value) in keys(change) {
            let of_table = match table {
                "sensor" => &mut parts.sensor,
                "spring" => &mut parts.spring,
                _ => &mut parts.uncertainty,
            };
            of_table.retain(|(other, _)| *other != key);
            of_table.push((key, value));
        }
        parts
    }
}

/// Specs whose sensor misses the goal, and the change that is expected among those that help.
fn missing_the_goal() -> Vec<(&'static str, Parts)> {
    let swing =
        "[[condition]]\nkind = \"harmonic\"\nfrequency = \"4 Hz\"\namplitude = \"10 %\"\nstart = \"massless\"\n";
    // From a pull to a push, so that the play is crossed.
    let slack = "[[condition]]\nkind = \"harmonic\"\nlength = \"105 mm\"\nfrequency = \"4 Hz\"\namplitude = \"10 mm\"\nstart = \"massless\"\n";
    let goal = |error: &str, more: &str| format!("[goal]\nerror = \"{error}\"\n{more}");
    let spec = |base, sensor: &[(&'static str, &str)], rest: String| Parts {
        spring: Vec::new(),
        uncertainty: Vec::new(),
        sensor: sensor.iter().map(|(key, value)| (*key, format!("\"{value}\""))).collect(),
        base,
        rest: format!("[mount]\ndamping_ratio = 0\n{rest}"),
    };
    let cell = ("kind", "load-cell");
    let laser = ("kind", "deflection");
    let tolerance = |key, value: &str| Parts {
        spring: vec![(key, format!("\"{value}\""))],
        ..spec(S_A, &[laser], format!("{STILL}{}", goal("1 %", "")))
    };
    let hot = Parts {
        uncertainty: vec![("temperature_change", "\"80 K\"".to_owned())],
        ..spec(S_T, &[laser], format!("{STILL}{}", goal("1 %", "")))
    };
    vec![
        ("a mean over", spec(S_T, &[cell], format!("{HEEL_STRIKE}{}", goal("0.5 %", "")))),
        ("a mean over", spec(S_A, &[cell], format!("{HEEL_STRIKE}{}", goal("0.5 %", "")))),
        (
            "a low-pass at half",
            spec(S_T, &[cell], format!("{HEEL_STRIKE}{}", goal("0.001 %", "bandwidth = \"26 Hz\"\n"))),
        ),
        (
            "its place at end 2",
            spec(S_T, &[cell, ("end", "1")], format!("{HEEL_STRIKE}{}", goal("0.5 %", "force = \"F_o\"\n"))),
        ),
        ("an accuracy of", spec(S_T, &[cell, ("accuracy_full_scale", "3 %")], format!("{STILL}{}", goal("1 %", "")))),
        ("an accuracy of", spec(S_A, &[laser, ("accuracy_reading", "6 %")], format!("{STILL}{}", goal("1 %", "")))),
        (
            "a gain calibrated",
            spec(S_T, &[cell, ("calibration_uncertainty", "2 %")], format!("{STILL}{}", goal("1 %", ""))),
        ),
        ("noise of", spec(S_T, &[laser, ("noise", "2 mm")], format!("{STILL}{}", goal("1 %", "")))),
        ("a resolution of", spec(S_T, &[laser, ("resolution", "10 mm")], format!("{STILL}{}", goal("1 %", "")))),
        (
            "a calibration that fits",
            spec(S_T, &[("kind", "inductance"), ("calibration_form", "4 %")], format!("{STILL}{}", goal("1 %", ""))),
        ),
        ("a temperature within", hot),
        ("a stiffness known", tolerance("stiffness_tolerance", "5 %")),
        ("a rest length known", tolerance("rest_length_tolerance", "2 mm")),
        ("no dead time", spec(S_T, &[laser, ("delay", "50 ms")], format!("{swing}{}", goal("1 %", "")))),
        ("a sample rate of", spec(S_T, &[laser, ("sample_rate", "16.5 Hz")], format!("{swing}{}", goal("1 %", "")))),
        ("an averaging window of", spec(S_T, &[laser, ("averaging", "100 ms")], format!("{swing}{}", goal("1 %", "")))),
        ("a bandwidth of", spec(S_T, &[laser, ("bandwidth", "10 Hz")], format!("{swing}{}", goal("1 %", "")))),
        (
            "a drive train without",
            spec(S_T, &[("kind", "two-encoder"), ("backlash", "4 mm")], format!("{slack}{}", goal("1 %", ""))),
        ),
        (
            "encoders on",
            spec(
                S_A,
                &[("kind", "two-encoder"), ("compliance", "100 um/N")],
                format!("{HEEL_STRIKE}{}", goal("0.5 %", "")),
            ),
        ),
    ]
}

#[test]
fn a_fix_written_into_the_spec_meets_the_goal() {
    let mut missing = Vec::new();
    for (expected, mut parts) in missing_the_goal() {
        // An end is a whole number, not a text.
        parts.sensor.iter_mut().filter(|(key, _)| *key == "end").for_each(|(_, value)| *value = value.replace('"', ""));
        let analysis = parts.run();
        let before = verdict(&analysis, "s");
        if before.meets_always() != Some(false) || !before.fixes.iter().any(|fix| fix.change.starts_with(expected)) {
            missing.push(format!("{expected}: {:?} {} {:?}", before.meets_always(), before.combined(), before.fixes));
            continue;
        }
        assert!(before.fixes.is_sorted_by(|a, b| a.lag <= b.lag), "{:?}", before.fixes);
        for fix in &before.fixes {
            let fixed = parts.with(&fix.change).run();
            let after = verdict(&fixed, "s");
            assert_eq!(after.meets_always(), Some(true), "{}: {} N", fix.change, after.combined());
            // The same change by another door: what is named is what was tried.
            close(after.combined(), fix.combined, 1e-9);
            close(after.lag, fix.lag, 1e-9);
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn nothing_is_promised_where_nothing_helps() {
    // Two lines of the budget, each above the goal by itself: no single change can do.
    let text = format!(
        "{S_T}\n[mount]\ndamping_ratio = 0\n{STILL}[[sensor]]\nkind = \"load-cell\"\nname = \"s\"\naccuracy_full_scale = \"4 %\"\n\
         calibration_uncertainty = \"4 %\"\n[goal]\nerror = \"1 %\"\n"
    );
    let analysis = run(&text);
    let verdict = verdict(&analysis, "s");
    assert_eq!(verdict.meets_always(), Some(false));
    assert!(verdict.fixes.is_empty(), "{:?}", verdict.fixes);
}
