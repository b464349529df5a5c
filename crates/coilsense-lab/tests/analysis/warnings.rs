//! What a reader is warned of, and what not.

use coilsense_lab::analysis::{Analysis, Subject};
use coilsense_lab::spec::template;

use super::{HEEL_STRIKE, S_A, S_T, STILL, run, undamped};

fn of(analysis: &Analysis, subject: Subject) -> Vec<&str> {
    analysis.warnings.iter().filter(|warning| warning.subject == subject).map(|warning| warning.text.as_str()).collect()
}

/// Alias warnings of one sensor in S_T's heel strike.
fn alias(sensor: &str) -> Vec<String> {
    let analysis = undamped(S_T, &format!("{HEEL_STRIKE}[[sensor]]\n{sensor}\n"));
    of(&analysis, Subject::Alias).into_iter().map(str::to_owned).collect()
}

#[test]
fn a_surge_line_above_half_the_sample_rate_is_told_with_where_it_folds_to() {
    // 100 Hz: the first mode, 54.06 Hz, shows up at 45.9 Hz, and of 4kv/ω = 2.24 N between two lines of the spectrum 85 % are seen.
    let [text] = &alias("kind = \"load-cell\"\nsample_rate = \"100 Hz\"")[..] else { panic!() };
    assert!(text.contains("54 Hz with") && text.ends_with("shows up at 45.9 Hz."), "{text}");
    let amplitude: f64 = text.split(" Hz with ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((0.84 * 2.2376..1.01 * 2.2376).contains(&amplitude), "{text}");
    // Sampled at the line itself it stands still: all of it becomes a steady error, which the hold does not take away.
    let [text] = &alias("kind = \"load-cell\"\nsample_rate = \"54.057 Hz\"")[..] else { panic!() };
    assert!(text.contains("54 Hz with 1.9") && text.ends_with("shows up at 0.0 Hz."), "{text}");
    // S_T's highest mode lies at 2N√(k/m)/2π = 1790 Hz.
    assert_eq!(alias("kind = \"load-cell\"\nsample_rate = \"3.57 kHz\"").len(), 1);
    assert_eq!(alias("kind = \"load-cell\"\nsample_rate = \"3.6 kHz\"").len(), 0);
}

#[test]
fn what_carries_no_surge_or_filters_it_is_not_warned_of() {
    assert!(alias("kind = \"load-cell\"").is_empty(), "no sampling");
    assert!(alias("kind = \"load-cell\"\nsample_rate = \"500 Hz\"\nbandwidth = \"30 Hz\"\norder = 6").is_empty());
    assert!(alias("kind = \"deflection\"\nsample_rate = \"100 Hz\"").is_empty(), "held ends do not move");
    assert!(alias("kind = \"two-encoder\"\nsample_rate = \"100 Hz\"").is_empty(), "nor do encoders on them");
    assert_eq!(
        alias("kind = \"two-encoder\"\nsample_rate = \"100 Hz\"\ncompliance = \"100 um/N\"").len(),
        1,
        "a drive train yields"
    );
    // Nothing moves here, and the window is so short that the mean lies beside every line.
    let still = undamped(S_T, &format!("{STILL}[[sensor]]\nkind = \"load-cell\"\nsample_rate = \"100 Hz\"\n"));
    assert!(of(&still, Subject::Alias).is_empty());
}

#[test]
fn s_a_clashes_at_resonance_and_s_t_does_not() {
    let undamped_template = |spring: &str| {
        let text = template(Some(spring)).unwrap().replace("# damping_ratio = 0.005", "damping_ratio = 0 #");
        run(&text)
    };
    let analysis = undamped_template("S_A");
    let [clash] = of(&analysis, Subject::Clash)[..] else { panic!("{:?}", analysis.warnings) };
    // Book: theory, section 3: from t = 0.53 s on, down to 2.44 mm of a wire of 3.2 mm.
    assert!(clash.contains("resonance, ζ = 0: windings touch from t = 0.529 s on"), "{clash}");
    assert!(clash.contains("they would overlap by 0.76 mm"), "{clash}");
    assert!(of(&undamped_template("S_T"), Subject::Clash).is_empty());
}

#[test]
fn lengths_below_solid_or_out_of_the_range_in_use_are_told() {
    let swing = |length: &str, amplitude: &str| {
        format!(
            "[[condition]]\nname = \"swing\"\nkind = \"harmonic\"\nlength = \"{length}\"\nfrequency = \"5 Hz\"\namplitude = \"{amplitude}\"\n\
                 start = \"massless\"\n"
        )
    };
    let lengths = |spring: &str, condition: String| {
        let analysis = undamped(spring, &condition);
        of(&analysis, Subject::Length).into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    // S_A: 25 windings of 3.2 mm.
    let solid = lengths(S_A, swing("84 mm", "6 mm"));
    assert!(
        solid.len() == 1 && solid[0].contains("78.00 mm long at its shortest, below its solid length of 80.00 mm"),
        "{solid:?}"
    );
    let long = lengths(S_T, swing("max", "5 mm"));
    assert!(long.len() == 1 && long[0].contains("to 269.00 mm leave the range in use, 196.00–264.00 mm"), "{long:?}");
    assert!(lengths(S_T, swing("mid", "34 mm")).is_empty(), "the range itself is in use");
}

#[test]
fn a_load_cell_beyond_its_full_scale_is_told() {
    let ranges = |range: &str| {
        let analysis =
            undamped(S_T, &format!("{HEEL_STRIKE}[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\n{range}"));
        of(&analysis, Subject::Range).len()
    };
    // 95.8 N, and an impact of 1.8 N about it that the chain's last windings overshoot.
    assert_eq!((ranges("range = \"90 N\""), ranges("range = \"96 N\""), ranges("range = \"100 N\"")), (1, 1, 0));
    assert_eq!(ranges(""), 0, "F_nom, which nobody chose, is no limit of an instrument");
    // One that is chosen is one, where it is F_nom's own number, too.
    let chosen = undamped(
        S_T,
        "[[condition]]\nkind = \"impact\"\nlength = \"max\"\nvelocity = \"0.25 m/s\"\n[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\nrange = \"121.6 N\"\n[goal]\nerror = \"9 %\"\n",
    );
    assert!((chosen.sensors[0].range - chosen.spec.spring.spring.nominal_force()).abs() < 1e-9);
    assert!(chosen.verdicts[0].overload.is_some_and(|most| most > 121.6) && of(&chosen, Subject::Range).len() == 1);
}

#[test]
fn a_load_cell_beyond_its_full_scale_is_not_chosen() {
    let analysis = |ranges: [&str; 2]| {
        let cell = |(name, range): (&str, &str)| {
            format!("[[sensor]]\nkind = \"load-cell\"\nname = \"{name}\"\nrange = \"{range}\"\n")
        };
        let cells = ["near", "wide"].into_iter().zip(ranges).map(cell).collect::<String>();
        undamped(S_T, &format!("{HEEL_STRIKE}{cells}[goal]\nerror = \"3 %\"\n"))
    };
    let first = |analysis: &Analysis| coilsense_lab::analysis::answer(analysis)[0].clone();
    // Both are as uncertain, 1.45 % of F_nom: the first one of these is the first that is named.
    let both = analysis(["100 N", "200 N"]);
    assert!(first(&both).starts_with("Choose near. Both sensors meet the goal"), "{}", first(&both));
    // What exceeds 96 N cannot be read by 90 N, however small the errors would be.
    let over = analysis(["90 N", "200 N"]);
    assert!(first(&over).starts_with("Choose wide. One of 2 sensors meets the goal"), "{}", first(&over));
    let verdict = over.verdicts.iter().find(|verdict| over.sensors[verdict.sensor].name == "near").unwrap();
    assert!(verdict.overload.is_some_and(|most| (96.0..100.0).contains(&most)));
    // One that reads it, and errs as little, meets the goal.
    let [fix] = &verdict.fixes[..] else { panic!("{:?}", verdict.fixes) };
    assert!(
        fix.change == "a range of 101 N, if its errors in N stay the same" && fix.combined == verdict.combined(),
        "{fix:?}"
    );
    assert_eq!(verdict.meets_always(), Some(false));
    let answer = coilsense_lab::analysis::answer(&over).join("\n");
    assert!(answer.contains("Missed by: near (overloaded at 9"), "{answer}");
    let none = analysis(["90 N", "91 N"]);
    assert!(
        first(&none).starts_with("No sensor meets the goal") && first(&none).ends_with(", and it is overloaded."),
        "{}",
        first(&none)
    );
}

#[test]
fn what_no_spring_does_overloads_no_load_cell() {
    // The compression spring of `init` at resonance, undamped: 648 N, where it is solid at 465 N and its windings have long touched.
    let analysis = run(&template(Some("pressed")).unwrap());
    let words = coilsense_lab::analysis::answer(&analysis);
    assert!(words[0].starts_with("Choose load cell") && !words.concat().contains("overloaded at"), "{words:?}");
    assert_eq!(of(&analysis, Subject::Clash).len(), 1, "that is told");
    // Nobody chose a range; what it would have to be until windings touch is told.
    let ranges = of(&analysis, Subject::Range);
    assert!(
        ranges.len() == 2 && ranges[0].contains("of a cell of 310 N (F_nom), and it has to read up to 45"),
        "{ranges:?}"
    );
    // Perfect sensors have no range; a cell that reads little all the same is overloaded before anything touches.
    let (head, rest) = template(Some("pressed"))
        .map(|text| text.split_once("[[sensor]]").map(|(a, b)| (a.to_owned(), b.to_owned())).unwrap())
        .unwrap();
    let goal = rest.split_once("[goal]").unwrap().1;
    let perfect = run(&format!("{head}[goal]{}", goal.replacen("bandwidth", "force = \"F_o\"\nbandwidth", 1)));
    assert!(perfect.verdicts.iter().all(|verdict| verdict.overload.is_none()));
    let small = run(&template(Some("pressed"))
        .unwrap()
        .replace("bandwidth = \"1 kHz\"", "range = \"200 N\"\nbandwidth = \"1 kHz\""));
    let words = coilsense_lab::analysis::answer(&small).concat();
    assert!(words.contains("overloaded at 4") && !words.contains("648"), "{words}");
}

#[test]
fn a_drift_that_is_not_known_is_told_and_not_taken_for_none() {
    let bronze = S_T.replace("[spring]", "[spring]\nmaterial = \"CuBe2\"");
    let with = |spring: &str, sensor: &str| {
        of(&undamped(spring, &format!("{STILL}[[sensor]]\nkind = \"{sensor}\"\n")), Subject::Temperature).len()
    };
    assert_eq!((with(&bronze, "deflection"), with(&bronze, "load-cell"), with(S_T, "deflection")), (1, 0, 0));
    let known = bronze.replace("[spring]", "[spring]\nshear_modulus_temperature = \"-0.03 %/K\"");
    assert_eq!(with(&known, "deflection"), 0);
}

#[test]
fn neighbours_below_the_first_surge_of_the_specs_own_mount_are_told() {
    let neighbours = |mount: &str| {
        let analysis =
            run(&format!("{S_T}\n[mount]\n{mount}\ndamping_ratio = 0\n[uncertainty]\ntrials = 1000\n{STILL}"));
        of(&analysis, Subject::Neighbour).into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    let held = neighbours("end2 = \"held\"");
    // Hooks, that may tilt or not; its torsion, at 60.8 Hz, lies above the surge, and in the axial force it is 1.1 % of it.
    assert!(
        held[0].starts_with("lateral motion starts at 37.4 Hz at 196.0 mm (ends free to tilt; ends held: 42.1 Hz)"),
        "{held:?}"
    );
    assert!(held.len() == 2 && held[1].starts_with("the axial model holds to 1 % up to 60.7 Hz"), "{held:?}");
    let heavy = neighbours("end2 = \"mass\"\nend_mass = \"2 kg\"");
    assert!(!heavy.iter().any(|text| text.contains("motion starts")), "a heavy end swings at 3 Hz, below them all");
}

#[test]
fn an_end_that_can_only_push_is_told_where_it_would_have_to_pull() {
    // Pushed by 9100 N/m × 1 mm, then struck so that the wave takes √(km) v = 26.98 N/(m/s) off both ends in turn.
    let pushed = |ends: &str, velocity: f64, window: &str| {
        let spring =
            S_A.replace("\"82 mm\"", "\"85 mm\"").replace("\"122 mm\"", "\"99 mm\"").replace("\"81 mm\"", "\"100 mm\"");
        let spring = spring.replace("[spring]", &format!("[spring]\n{ends}"));
        let condition = format!(
            "[[condition]]\nname = \"hit\"\nkind = \"impact\"\nlength = \"max\"\nvelocity = \"{velocity} m/s\"\nduration = \"20 ms\"\n{window}"
        );
        let analysis = undamped(&spring, &condition);
        of(&analysis, Subject::Lift).into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    let seats = "end_type = \"open-ground\"";
    let [text] = &pushed(seats, 1.0, "")[..] else { panic!() };
    assert!(text.starts_with("hit, ζ = 0: ends that can only push would have to pull: end 1 from t = 0.0"), "{text}");
    assert!(text.contains("; end 2 from t = 0.0") && text.ends_with("beyond what this spring can do."), "{text}");
    // 26.98 − 9.1 N of a continuous coil; the chain's last windings overshoot the wave, at most to twice it.
    let largest: f64 = text.split("by up to ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((17.88..44.86).contains(&largest), "{text}");
    assert_eq!(pushed(seats, 0.1, "").len(), 0, "at most 5.4 N of 9.1");
    // Hooks can pull, which is the other way round: pressed as it is here, such a spring would fall off.
    for ends in ["end_type = \"hooks\"", ""] {
        let [text] = &pushed(ends, 0.1, "")[..] else { panic!("{ends}") };
        assert!(text.starts_with("hit, ζ = 0: hooks can only pull, and would have to push: end "), "{text}");
        assert!(text.contains("Give the end_type of a spring that is pressed."), "{text}");
    }
}

#[test]
fn a_sensor_that_nothing_is_told_of_is_not_taken_for_a_perfect_one_in_silence() {
    let told = |keys: &str| {
        let analysis = undamped(S_T, &format!("{STILL}\n[[sensor]]\nname = \"mine\"\n{keys}\n"));
        let words = coilsense_lab::analysis::answer(&analysis).join(" ");
        assert!(!words.contains("do not fit together"), "{words}");
        let texts = of(&analysis, Subject::Instrument);
        let of_all =
            texts.iter().filter(|text| text.contains("no noise, resolution or limit of error is given")).count();
        let of_limits = texts.iter().filter(|text| text.contains(": no limit of error (accuracy_full_scale,")).count();
        assert_eq!(of_all + of_limits, texts.len());
        // The answer says it, too: it is the least that such a sensor errs by.
        assert_eq!(words.contains("no limit of error for mine"), !texts.is_empty(), "{words}");
        (of_all, of_limits)
    };
    assert_eq!(told("class = \"two magnetic rotary encoders\""), (1, 0), "its values are of one's own drive");
    assert_eq!(told("kind = \"load-cell\""), (1, 0));
    assert_eq!(told("kind = \"load-cell\"\nnoise = \"0.1 N\""), (0, 1), "noise is gone in a mean");
    assert_eq!(told("kind = \"deflection\"\naccuracy_reading = \"0.1 %\""), (0, 0));
    assert_eq!(told("kind = \"inductance\""), (0, 0), "its calibration is doubted in any case");
}
