//! Logs on the page, without a browser: the simulated one says of its spring what was put in, and a wrong choice is refused by its name.
#![cfg(feature = "workshop")]

use coilsense_web::Engine;
use coilsense_web::answer::Answer;
use coilsense_web::log::LogFile;
use serde_json::{Value, json};

const ANKLE: &str = include_str!("../../../examples/sea-ankle.toml");
const PARALLEL: &str = include_str!("../../../examples/parallel-ankle.toml");

fn meta(answer: &Answer) -> Value {
    serde_json::from_str(&answer.meta()).unwrap()
}

/// Of the first condition, with ζ = 0.005.
fn trial(spec: &str) -> String {
    let facts = meta(&Engine::new().trial_log(spec, 0, 2).unwrap());
    facts["text"].as_str().unwrap().to_owned()
}

fn identify(text: &str, second: Option<String>, asked: &Value) -> Result<Answer, String> {
    let second = second.map(|text| LogFile::of_text("second.csv", text.into_bytes()));
    Engine::new().identify(LogFile::of_text("first.csv", text.into()), second, &asked.to_string())
}

fn found(text: &str, asked: &Value) -> Value {
    let facts = meta(&identify(text, None, asked).unwrap());
    serde_json::from_str(facts["json"].as_str().unwrap()).unwrap()
}

#[test]
fn the_simulated_log_says_that_it_is_one_and_gives_the_spring_back() {
    // Table I of the paper: k [N/m], m [kg], l0 [m]. The windings are told, else a coil of 25 is 0.13 % heavier by its modes.
    for (spec, windings, stiffness, mass, rest) in
        [(ANKLE, "52", 760.0, 0.065, 0.104), (PARALLEL, "25", 9100.0, 0.08, 0.081)]
    {
        let text = trial(spec);
        assert!(text.starts_with("# Simulated data: by coilsense"), "{}", text.lines().next().unwrap());
        assert_eq!(text, trial(spec), "the same seed gives the same log");
        let found = found(&text, &json!({ "windings": windings }));
        assert_eq!(found["verdict"], "spring");
        let value = |name: &str| found[name]["value"].as_f64().unwrap();
        // Noise of 2e-4 of the force; a thousandth holds five standard deviations of each.
        assert!((value("stiffness_n_per_m") / stiffness - 1.0).abs() < 1e-3);
        assert!((value("mass_kg") / mass - 1.0).abs() < 1e-3);
        assert!((value("length_at_zero_force_m") / rest - 1.0).abs() < 1e-3);
        assert!((value("damping_ratio") / 0.005 - 1.0).abs() < 0.02);
    }
}

#[test]
fn a_spring_that_carries_a_mass_is_held_for_its_simulated_log() {
    let mut engine = Engine::new();
    engine.add_file("road-c-20mps.csv".into(), include_str!("../../../examples/road-c-20mps.csv").into());
    let facts = meta(&engine.trial_log(include_str!("../../../examples/car-suspension.toml"), 0, 0).unwrap());
    let found = found(facts["text"].as_str().unwrap(), &json!({}));
    assert_eq!(found["verdict"], "spring");
    // The evidence names the ends.
    assert!(found["evidence"].to_string().contains("both ends held"), "{:#}", found["evidence"]);
}

#[test]
fn a_spring_without_damping_gets_some_and_the_log_says_so() {
    let facts = meta(&Engine::new().trial_log(ANKLE, 0, 0).unwrap());
    assert!(facts["text"].as_str().unwrap().contains("ζ = 0.005 (the page's 0 would ring for ever)"));
    assert!(Engine::new().trial_log(ANKLE, 99, 0).unwrap_err().starts_with("condition 99"));
}

#[test]
fn a_second_device_whose_clock_is_off_is_put_on_the_first_ones() {
    let text = trial(ANKLE);
    let rows: Vec<Vec<&str>> = text.lines().skip(3).map(|line| line.split(',').collect()).collect();
    let (mut first, mut second) =
        ("time [s],F_i [N],F_o [N]\n".to_owned(), "t [s],F_o [N],u1 [mm],u2 [mm]\n".to_owned());
    for row in &rows {
        first += &format!("{},{},{}\n", row[0], row[3], row[4]);
        let later = row[0].parse::<f64>().unwrap() + 0.25;
        second += &format!("{later:.4},{},{},{}\n", row[4], row[1], row[2]);
    }
    let asked = json!({ "with-column": ["time=#1 [s]", "F_o=#2 [N]", "u1=#3 [mm]", "u2=#4 [mm]"] });
    let facts = meta(&identify(&first, Some(second.clone()), &asked).unwrap());
    // A quarter of a step of 0.5 ms.
    assert!((facts["clock"]["offset"].as_f64().unwrap() + 0.25).abs() < 0.125e-3, "{}", facts["clock"]);
    assert_eq!(facts["clock"]["found"]["channels"], json!(["F_o", "F_o"]));
    let told = serde_json::from_str::<Value>(facts["json"].as_str().unwrap()).unwrap();
    assert!((told["stiffness_n_per_m"]["value"].as_f64().unwrap() / 760.0 - 1.0).abs() < 1e-3);
    let clock = json!({ "clock": "-0.25 s" });
    assert_eq!(meta(&identify(&first, Some(second.clone()), &clock).unwrap())["clock"]["offset"], -0.25);
    let wrong = identify(&first, Some(second), &json!({ "clock": "soon" })).unwrap_err();
    assert!(wrong.starts_with("clock: must be ") && wrong.ends_with("got \"soon\""), "{wrong}");
}

#[test]
fn every_wrong_choice_is_refused_by_its_name_with_its_value_and_what_is_allowed() {
    let text = trial(ANKLE);
    for (name, value) in [
        ("windings", "0.5"),
        ("radius", "8 kg"),
        ("wire", "-1 mm"),
        ("mass", "0 g"),
        ("end2", "loose"),
        ("end-mass", "1 m"),
        ("accuracy-force", "100 %"),
        ("accuracy-position", "-1 %"),
        ("tolerance", "0 %"),
        ("prediction-tolerance", "five"),
        ("sample-rate", "1e12 Hz"),
        ("resample", "0 Hz"),
        ("fill-gaps", "1"),
        ("from", "soon"),
        ("to", "late"),
        ("delimiter", "x"),
        ("decimal", "'"),
    ] {
        let refusal = identify(&text, None, &json!({ name: value })).unwrap_err();
        assert!(refusal.starts_with(&format!("{name}: must be ")), "{refusal}");
        assert!(refusal.ends_with(&format!("got {value:?}")), "{refusal}");
    }
    for (asked, refusal) in [
        (json!({ "end2": "held", "end-mass": "1 kg" }), "end-mass: goes with"),
        (json!({ "mapping": "[columns]\nF_o = 3" }), "mapping: [columns] F_o: must be a title"),
        (json!({ "mapping": "[log]\nx" }), "mapping:2: not TOML"),
        (json!({ "preset": "x" }), "preset: "),
        // Decimal commas between commas stand in quotes; these do not.
        (json!({ "delimiter": ",", "decimal": "," }), "first.csv:4: column 1"),
    ] {
        let said = identify(&text, None, &asked).unwrap_err();
        assert!(said.starts_with(refusal), "{said}");
    }
    let calibrate = |asked: Value| {
        Engine::new().calibrate(LogFile::of_text("a.csv", text.clone().into_bytes()), &asked.to_string())
    };
    for (asked, refusal) in [
        (json!({ "preload": "1 kg" }), "preload: must be "),
        (json!({ "preload": "200 mm", "method": "all" }), "preload: goes with"),
        (json!({ "method": "guess" }), "method: must be one of two-point, all, through-preload, got"),
        (json!({ "inversion": "25-lengths" }), "length-at-zero: is needed"),
    ] {
        let said = calibrate(asked).unwrap_err();
        assert!(said.starts_with(refusal), "{said}");
    }
}

/// What a log lacks is advised in the words of the page that asks, and by no name of the command.
#[test]
fn an_error_calls_options_as_the_page_does() {
    let labels =
        json!({ "drop-incomplete": "“leave out rows”", "sort": "“put in order”", "column": "the table of columns" });
    for (text, with, without) in [
        (
            "time [s],F_o [N]\n0,1\n1,x\n",
            "“leave out rows” leaves such rows out",
            "; drop incomplete leaves such rows out",
        ),
        ("time [s],F_o [N]\n1,1\n0,2\n", "“put in order” puts the rows in order", "; sort puts the rows in order"),
        (
            "time [s],a\n0,1\n",
            "guess is wrong: F_o=\"a [N]\" in the table of columns",
            "guess is wrong: F_o=\"a [N]\" in column",
        ),
    ] {
        let said = |asked: &Value| identify(text, None, asked).unwrap_err();
        let (named, unnamed) = (said(&json!({ "labels": labels })), said(&json!({})));
        assert!(named.ends_with(with), "{named}");
        assert!(unnamed.ends_with(without) && !unnamed.contains("--"), "{unnamed}");
    }
}

#[test]
fn a_log_that_can_be_read_but_says_nothing_still_shows_its_channels() {
    let answer = identify("time [s],u1 [mm]\n0,1\n0.1,2\n0.2,3\n", None, &json!({})).unwrap();
    assert!(meta(&answer)["refusal"].as_str().unwrap().starts_with("first.csv: "), "{}", answer.meta());
    assert_eq!(answer.find("recorded u1").unwrap(), [0.001, 0.002, 0.003]);
}

/// What a first look at a log tells of its columns, in order, and which are guessed.
fn looked_at(text: &str) -> (Value, Vec<(Value, bool)>) {
    let facts = meta(&Engine::new().log_columns(LogFile::of_text("a.csv", text.into()), "{}").unwrap());
    let of = |column: &Value| (column["channel"].clone(), column["guessed"].as_bool().unwrap());
    let columns = facts["columns"].as_array().unwrap().iter().map(of).collect();
    (facts["preset"].clone(), columns)
}

#[test]
fn columns_are_taken_by_name_then_by_unit_then_by_words() {
    for (titles, meant) in [
        ("Zeit/s;Weg oben (mm);Kraft unten [N]", [("time", false), ("u1", true), ("F_o", true)]),
        ("t [s];Kraft [mm];Weg [N]", [("time", false), ("u1", true), ("F_o", true)]),
        ("time [s];F_o [N];x [mm]", [("time", false), ("F_o", false), ("u1", true)]),
        // What is measured already is not guessed a second time, and what has no unit only where nothing else is known.
        ("time [s];F_i [N];Kraft unten [N]", [("time", false), ("F_i", false), ("", false)]),
        ("time [s];Kraft [N];motor", [("time", false), ("F_o", true), ("", false)]),
        ("time [s];Kraft;Weg unten", [("time", false), ("F_o", true), ("u2", true)]),
        ("x;y;Zeit", [("", false), ("", false), ("time", true)]),
        ("time [s];Temperatur [°C];Strom [A]", [("time", false), ("", false), ("", false)]),
    ] {
        let (preset, found) = looked_at(&format!("{titles}\n0,1;1,5;2\n0,2;1,6;3\n"));
        let told = |(name, guessed): (&str, bool)| (if name.is_empty() { Value::Null } else { name.into() }, guessed);
        assert_eq!((preset, found), (Value::Null, meant.map(told).to_vec()), "{titles}");
    }
}

#[test]
fn rows_as_the_rig_of_the_measured_runs_wrote_them_are_known() {
    let row = |step: u32, inductance: f64| {
        let pairs = (0..10)
            .map(|n| format!("; {:+e}; {:+e}", 0.31 + 1e-5 * f64::from(n), inductance * (1.0 + 1e-4 * f64::from(n))));
        format!("{step}; 1.000000e+01; 5.000000e-01; {:e}{}\n", 7.0 * f64::from(step - 1), pairs.collect::<String>())
    };
    let rows = |first: u32| (0..4).map(|n| row(first + n, 5e-6 - 3e-7 * f64::from(n))).collect::<String>();
    assert_eq!(looked_at(&rows(1)).0, "lab-data");
    // As many columns, but not numbered so, or no inductances: some other table.
    assert_eq!(looked_at(&rows(7)).0, Value::Null);
    assert_eq!(looked_at(&(1..4).map(|step| row(step, 5.0)).collect::<String>()).0, Value::Null);
}

#[test]
fn a_log_whose_ends_stand_still_has_no_calibration_and_no_fault() {
    let calibrate = |text: &str| Engine::new().calibrate(LogFile::of_text("a.csv", text.into()), "{}");
    let still = "time [s],u1 [m],u2 [m],F_o [N],L [uH]\n0,0,0.23,95,3.1\n1,0,0.23,96,3.2\n2,0,0.23,97,3.3\n";
    assert_eq!(meta(&calibrate(still).unwrap()), json!({ "json": null }));
    assert!(meta(&calibrate(&still.replace("2,0,0.23", "2,0,0.22")).unwrap())["json"].is_string());
    // A single row is too few, and says so.
    let one = still.lines().take(2).collect::<Vec<_>>().join("\n");
    assert!(calibrate(&one).unwrap_err().starts_with("a.csv: "));
}
