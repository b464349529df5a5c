//! What is wrong is said in one line that names file and line or key, and nothing else happens.

use super::*;

/// The message about an experiment of which one file is replaced.
fn told(name: &str, text: &str) -> String {
    let place = folder(&format!("{TOP}{GIVEN}"), &usual());
    write(place.path(), name, text);
    let message = read(&place).unwrap_err().to_string();
    assert!(message.lines().count() == 1, "{message}");
    message
}

/// The message about an `experiment.toml`.
fn described(text: &str) -> String {
    let message = told("experiment.toml", text);
    assert!(message.contains("experiment.toml"), "{message}");
    message
}

#[test]
fn a_description_that_cannot_be_is_refused_at_its_line() {
    let preload = "[[run]]\nkind = \"preload\"\nfast = \"0-fast.csv\"\n";
    let with = |more: &str| described(&format!("{TOP}{GIVEN}{more}"));
    assert!(with("").contains("no [[run]] has kind = \"preload\""));
    assert!(
        with(&format!("{preload}frequency = \"3 Hz\"\n"))
            .contains(":9: frequency in [[run]] 1 is no key of a run of kind \"preload\"")
    );
    assert!(with("[[run]]\nkind = \"shake\"\n").contains(":7: kind = \"shake\": must be one of \"calibration\""));
    assert!(with("[[run]]\nkind = \"preload\"\n").contains("[[run]] 1 lacks the key \"fast\""));
    assert!(with("[[run]]\nkind = \"calibration\"\nfast = \"x.csv\"\n").contains("lacks the key \"slow\""));
    assert!(with("[[run]]\nkind = \"harmonic\"\nfast = \"x.csv\"\n").contains("lacks the key \"frequency\""));
    assert!(with("[[run]]\nkind = \"harmonic\"\nfast = \"x.csv\"\nfrequency = \"-3 Hz\"\n").contains("above zero"));
    assert!(with("[runs]\n").contains("did you mean \"run\"?"));
    assert!(
        described(&format!("nominal_farce = \"1 N\"\n{preload}"))
            .contains(":1: unknown key \"nominal_farce\"; did you mean \"nominal_force\"?")
    );
    assert!(described(preload).contains("lacks the key \"nominal_force\""));
    assert!(
        described(&format!("{TOP}{preload}"))
            .contains("stiffness is not given, and no [[run]] has kind = \"calibration\"")
    );
    assert!(described(&TOP.replace("100 N", "100")).contains("nominal_force = \"100\": must be a force with its unit"));
    assert!(described("simulated = 1").contains("must be true or false"));
    assert!(described("][").contains("not TOML"));
    assert!(with(&format!("averaging = \"0 s\"\n{preload}")).contains("averaging"));
    let place = tempfile::tempdir().unwrap();
    assert!(read(&place).unwrap_err().to_string().contains("experiment.toml: cannot be read"));
}

#[test]
fn a_log_that_cannot_be_is_refused_with_file_and_line() {
    let head = "time [s],F_o [N],u1 [mm]\n";
    for (name, text, expected) in [
        ("2-fast.csv", format!("{head}0,1,2\n0.001,x,3\n"), "2-fast.csv:3"),
        ("2-fast.csv", format!("{head}0,1,2\n0.001,1\n"), "2-fast.csv:3"),
        ("2-fast.csv", format!("{head}0,1,2\n0,1,2\n"), "2-fast.csv:3"),
        ("2-fast.csv", format!("{head}0,1,2\n0.001,NaN,2\n"), "2-fast.csv:3"),
        ("2-fast.csv", head.to_owned(), "2-fast.csv"),
        ("2-fast.csv", String::new(), "2-fast.csv"),
        ("2-fast.csv", "time [s],u1 [mm]\n0,1\n1,1\n".to_owned(), "2-fast.csv: has no F_o"),
        ("2-fast.csv", "time [s],F_o [N]\n0,1\n1,1\n".to_owned(), "2-fast.csv: has no u1"),
        ("2-fast.csv", format!("{head}0,1,2\n0.001,1,2\n"), "2-fast.csv: must hold at least one period of 10 Hz"),
        ("3-slow.csv", "time [s],L [N]\n0,1\n".to_owned(), "3-slow.csv"),
        ("3-slow.csv", "time [s],R [Ohm]\n0,1\n".to_owned(), "3-slow.csv"),
        ("3-slow.csv", "time [s],L [H]\n0,\n".to_owned(), "3-slow.csv:2"),
    ] {
        let message = told(name, &text);
        assert!(message.contains(expected), "{text:?}: {message}");
    }
    // 1/l of L is zero, or below.
    for henry in ["-1.875e-7", "-1e-6"] {
        let message = told("3-slow.csv", &format!("L [H]\n1e-6\n{henry}\n"));
        assert!(message.contains("3-slow.csv: reading 2: ") && message.contains("beyond the pole"), "{message}");
    }
}

#[test]
fn a_calibration_run_that_tells_nothing_is_refused_by_its_name() {
    let top = format!("{TOP}\n[[run]]\nkind = \"calibration\"\nslow = \"rest.csv\"\n");
    let told = |text: &str| {
        let place = folder(&top, &usual());
        write(place.path(), "rest.csv", text);
        let message = read(&place).unwrap_err().to_string();
        assert!(message.contains("rest.csv"), "{message}");
        message
    };
    assert!(told("u1 [mm],F_o [N],L [uH]\n0,26,4\n").contains("at least 2"));
    assert!(told("u1 [mm],F_o [N],L [uH]\n0,26,4\n0,26,4\n").contains("stiffness must be above zero"));
    assert!(told("u1 [mm],F_o [N],L [uH]\n0,26,4\n1,27,4\n").contains("is the sign of force or position turned?"));
    assert!(told("u1 [mm],F_o [N]\n0,26\n1,25\n").contains("has no L"));
    assert!(told("F_o [N],L [uH]\n26,4\n25,4\n").contains("has no u1"));
}
