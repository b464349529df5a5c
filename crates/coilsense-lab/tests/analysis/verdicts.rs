//! Ranking, the goal under each damping, and the words of the answer.

use coilsense_lab::analysis::{Check, answer};
use coilsense_lab::spec::template;

use super::{HEEL_STRIKE, S_T, STILL, run, undamped, verdict};

#[test]
fn sensors_are_ranked_by_their_worst_case_and_the_first_of_equal_cases_is_named() {
    let analysis = run(&template(Some("S_T")).unwrap());
    let combined: Vec<f64> = analysis.verdicts.iter().map(|verdict| verdict.combined()).collect();
    assert!(combined.is_sorted(), "{combined:?}");
    for verdict in &analysis.verdicts {
        let largest = verdict.assessments.iter().map(|a| a.combined).fold(0.0, f64::max);
        assert_eq!(verdict.combined(), largest);
        assert_eq!(verdict.assessments.iter().position(|a| a.combined == largest), Some(verdict.worst));
    }
    // A laser looks at the ends only: damping changes nothing for it, and blaming the last would mislead.
    let laser = verdict(&analysis, "laser");
    assert_eq!(analysis.spec.mount.cases[analysis.cases[laser.worst].damping].label, "ζ = 0");
}

#[test]
fn without_a_damping_the_goal_is_judged_for_four_and_the_papers_is_marked() {
    // Up to 200 Hz the surge counts: undamped it is 1.3 % of F_nom, at ζ = 0.02 it is gone by 0.75 s.
    let goal = "[goal]\nerror = \"1 %\"\nbandwidth = \"200 Hz\"\n";
    let analysis = run(&format!("{S_T}\n{HEEL_STRIKE}[[sensor]]\nkind = \"load-cell\"\n{goal}"));
    let labels: Vec<&str> = analysis.spec.mount.cases.iter().map(|case| case.label.as_str()).collect();
    assert_eq!(labels, ["ζ = 0", "ζ = 0.001", "ζ = 0.005", "ζ = 0.02"]);
    assert!(analysis.spec.mount.is_band);
    let verdict = &analysis.verdicts[0];
    assert_eq!((verdict.meets.as_slice(), verdict.meets_always()), (&[false, true, true, true][..], Some(false)));
    let words = answer(&analysis).join("\n");
    assert!(words.contains("ζ = 0 (the paper's case) to 0.02"), "{words}");
    assert!(words.contains("load-cell meets it at ζ = 0.001, ζ = 0.005, ζ = 0.02 only"), "{words}");
}

const CELL: &str = "[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\naccuracy_full_scale = \"1 %\"\n";
const LASER: &str = "[[sensor]]\nkind = \"deflection\"\nname = \"laser\"\naccuracy_full_scale = \"0.1 %\"\n";
/// One of which no limit of error is told.
const UNTOLD: &str = "[[sensor]]\nkind = \"deflection\"\nname = \"fine laser\"\nresolution = \"1 um\"\n";
const SLOW: &str = "[[sensor]]\nkind = \"deflection\"\nname = \"slow\"\naveraging = \"100 ms\"\n";

/// The answer's first lines for some sensors and a goal.
fn words(sensors: &str, goal: &str) -> Vec<String> {
    answer(&undamped(S_T, &format!("{STILL}{sensors}{goal}")))
}

#[test]
fn the_answer_reads_well_for_any_number_of_sensors() {
    let goal = "[goal]\nerror = \"1 %\"\nbandwidth = \"20 Hz\"\n";
    let strict = "[goal]\nerror = \"0.1 %\"\nbandwidth = \"20 Hz\"\n";
    let first = |sensors: &str, goal: &str| words(sensors, goal).remove(0);
    assert!(first(CELL, goal).starts_with(
        "Choose cell. It meets the goal of 1.22 N (1 % of F_nom) up to 20 Hz. Standard uncertainty of cell: at most "
    ));
    assert!(first(&format!("{CELL}{LASER}"), goal).contains("Choose laser. Both sensors meet"));
    assert!(first(&format!("{CELL}{LASER}{SLOW}"), goal).contains("2 of 3 sensors meet"));
    assert!(first(&format!("{CELL}{SLOW}"), goal).contains("Choose cell. One of 2 sensors meets"));
    assert!(first(CELL, strict).starts_with("cell does not meet the goal of 0.122 N"));
    assert!(first(&format!("{CELL}{SLOW}"), strict).starts_with("No sensor meets the goal"));
    assert!(first(CELL, "").starts_with("cell, with a standard uncertainty of at most 0.702 N"));
    assert!(first(&format!("{CELL}{LASER}"), "").starts_with("Least uncertain is laser, with a standard uncertainty"));
    // Without sensors: the paper's four, without limits of their own.
    assert!(first("", goal).contains("Choose perfect load cell, end 1. All 4 sensors meet"), "{}", first("", goal));
    for lines in [words(CELL, goal), words("", ""), words(&format!("{CELL}{SLOW}"), strict)] {
        assert!(lines.len() <= 8 && lines.iter().all(|line| !line.is_empty()), "{lines:?}");
    }
}

#[test]
fn what_may_err_by_more_than_is_told_comes_after_what_cannot() {
    let check = |sensors: &str, goal: &str| Check::of(&undamped(S_T, &format!("{STILL}{sensors}{goal}")));
    let goal = "[goal]\nerror = \"1 %\"\n";
    // The cell has 0.702 N, the laser 1e-3 N: of what nobody knows.
    let lines = words(&format!("{UNTOLD}{CELL}"), goal);
    assert!(lines[0].starts_with("Choose cell. Both sensors meet the goal"), "{lines:?}");
    assert_eq!(
        lines[1],
        "The spec gives no limit of error for fine laser: what is said of it is a lower bound of its uncertainty; sensors with one are preferred."
    );
    assert_eq!(check(&format!("{UNTOLD}{CELL}"), goal), Check::Met("cell".to_owned()));
    // Where it alone meets the goal it is chosen, in doubt; and where it misses by the least that it errs by, that is all there is to say.
    let strict = "[goal]\nerror = \"0.3 %\"\n";
    let lines = words(&format!("{CELL}{UNTOLD}"), strict);
    assert!(lines[0].starts_with("Choose fine laser. One of 2 sensors meets the goal"), "{lines:?}");
    assert!(lines[2].starts_with("The spec gives no limit of error for fine laser"), "{lines:?}");
    assert!(
        matches!(check(&format!("{CELL}{UNTOLD}"), strict), Check::Undecided(why) if why.contains("no limit of error for fine laser"))
    );
    let lines = words(&format!("{CELL}{UNTOLD}"), "[goal]\nerror = \"1e-5 %\"\n");
    assert!(lines[0].contains("nearest is fine laser") && !lines.concat().contains("gives no limit"), "{lines:?}");
    // Held against nothing, and alone.
    assert!(words(&format!("{UNTOLD}{CELL}"), "")[0].starts_with("Least uncertain is cell, with"));
    assert!(words(UNTOLD, "")[1].ends_with("is a lower bound of its uncertainty."), "{:?}", words(UNTOLD, ""));
    // Perfect sensors, of a spec that has none, are what they are called.
    assert!(!words("", goal).concat().contains("gives no limit"));
    assert_eq!(check("", goal), Check::Met("perfect load cell, end 1".to_owned()));
}

#[test]
fn sensors_that_are_as_certain_are_named_beside_the_first() {
    let cell = |name: &str, share: f64| {
        format!("[[sensor]]\nkind = \"load-cell\"\nname = \"{name}\"\naccuracy_full_scale = \"{share} %\"\n")
    };
    let first = |sensors: &str| words(sensors, "[goal]\nerror = \"1 %\"\n").remove(0);
    let (one, near, far) = (cell("one", 1.0), cell("near", 1.04), cell("far", 1.07));
    let all = first(&format!("{far}{near}{one}"));
    assert!(
        all.starts_with("Choose one. All 3 sensors meet") && all.contains("; near has about as much (0.730 N)."),
        "{all}"
    );
    let also = first(&format!("{}{near}{one}", cell("nearer", 1.02)));
    assert!(also.contains("; nearer and near have about as much (up to 0.730 N)."), "{also}");
    assert!(!first(&format!("{far}{one}")).contains("as much"), "7 % apart");
    assert!(!first(&one).contains("as much"));
    // One of which no limit is told may err by more; one that misses the goal is no choice.
    let least = UNTOLD.replace("1 um", "3 mm");
    let both = format!("{}{least}", cell("one", 1.0));
    assert!(!first(&both).contains("as much"), "{}", first(&both));
    let edge = words(&format!("{one}{near}"), "[goal]\nerror = \"0.585 %\"\n").remove(0);
    assert!(edge.contains("One of 2 sensors meets") && !edge.contains("as much"), "{edge}");
}

#[test]
fn who_misses_is_told_why() {
    let strict = "[goal]\nerror = \"0.1 %\"\nbandwidth = \"20 Hz\"\n";
    let lines = words(&format!("{CELL}{SLOW}"), strict);
    assert!(
        lines[1]
            .contains("cell (0.702 N in impact, mostly sensor: accuracy of full scale; 10 % of the springs meet it)"),
        "{lines:?}"
    );
    let loose = "[goal]\nerror = \"1 %\"\nbandwidth = \"20 Hz\"\n";
    let lines = words(&format!("{CELL}{SLOW}"), loose);
    assert!(lines[1].contains("slow (reaches 4.43 Hz only)"), "{lines:?}");
    // A gauge that is always 20 ms late on a ramp is off by its mean, 0.456 N, and by 0.024 N since the coil's force bends.
    let ramp = "[[condition]]\nkind = \"ramp\"\namplitude = \"-30 mm\"\nrise_time = \"1 s\"\nduration = \"1 s\"\nwindow = [\"0.5 s\", \"1 s\"]\n";
    let late = "[[sensor]]\nkind = \"deflection\"\nname = \"late\"\ndelay = \"20 ms\"\n";
    let lines = answer(&undamped(S_T, &format!("{ramp}{late}{strict}")));
    assert!(lines[1].contains("mostly a mean error of −0.480 N;"), "{lines:?}");
}

#[test]
fn what_a_sensor_owes_to_its_own_lag_is_not_laid_on_the_spring() {
    let strict = "[goal]\nerror = \"0.1 %\"\n";
    let why = |frequency: &str, sensor: &str, goal: &str| {
        let moved = format!(
            "[[condition]]\nkind = \"harmonic\"\nfrequency = \"{frequency}\"\namplitude = \"2 mm\"\nstart = \"massless\"\nduration = \"1 s\"\n"
        );
        answer(&undamped(S_T, &format!("{moved}[[sensor]]\nname = \"it\"\n{sensor}{goal}")))[1].clone()
    };
    let late = "kind = \"deflection\"\ndelay = \"20 ms\"\n";
    let slow = "kind = \"deflection\"\naveraging = \"20 ms\"\n";
    let filtered = "kind = \"deflection\"\nbandwidth = \"10 Hz\"\n";
    for sensor in [late, slow, filtered] {
        assert!(why("4 Hz", sensor, strict).contains("mostly its own lag"), "{}", why("4 Hz", sensor, strict));
    }
    // A load cell beside a spring that rings; one that is hardly late; a length for the force at an end; and one that is late beside more ringing.
    let of_end = "[goal]\nerror = \"0.1 %\"\nforce = \"F_o\"\n";
    let cell = "kind = \"load-cell\"\nend = 2\n";
    for (sensor, goal) in [
        (cell.to_owned(), strict),
        (format!("{cell}delay = \"0.1 ms\"\n"), strict),
        ("kind = \"deflection\"\n".to_owned(), of_end),
        ("kind = \"deflection\"\ndelay = \"0.1 ms\"\n".to_owned(), of_end),
    ] {
        let words = why("50 Hz", &sensor, goal);
        assert!(words.contains("mostly oscillation"), "{sensor}: {words}");
    }
}
