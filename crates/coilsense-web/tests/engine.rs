//! What the page asks of the engine, asked here without a browser.

use coilsense_lab::analysis::simulate;
use coilsense_lab::spec::Spec;
use coilsense_web::Engine;
use coilsense_web::answer::Answer;
use serde_json::Value;

const ANKLE: &str = include_str!("../../../examples/sea-ankle.toml");
const VALVE: &str = include_str!("../../../examples/valve-spring.toml");
const CAM: &str = include_str!("../../../examples/cam-6000rpm.csv");

fn meta(answer: &Answer) -> Value {
    serde_json::from_str(&answer.meta()).unwrap()
}

#[test]
fn an_exact_case_is_the_one_of_the_whole_analysis_noise_included() {
    let spec = Spec::parse("spec", ANKLE, &|_| Err("no files".to_owned())).unwrap();
    let cases = simulate(&spec, &|_, _| true).unwrap();
    let dampings = spec.mount.cases.len();
    for (condition, damping) in [(0, 0), (2, 1), (4, 3)] {
        let answer = Engine::new().exact(ANKLE, condition, damping).unwrap();
        let case = &cases[condition * dampings + damping];
        for (channel, values) in case.signals.channels() {
            // The same code on the same processor.
            assert_eq!(answer.find(channel.name()).unwrap(), values, "{}", channel.name());
        }
        for (number, reading) in case.readings.iter().enumerate() {
            assert_eq!(answer.find(&format!("reading {number}")).unwrap(), reading.force);
        }
        // JSON's reader may be off in the last digit.
        let rmsd = meta(&answer)["forces"]["F_o"]["rmsd"].as_f64().unwrap();
        assert!((rmsd / case.ideal[1].1.rmsd - 1.0).abs() < 1e-15);
    }
}

#[test]
fn a_preview_is_the_exact_curve_at_its_times() {
    let engine = Engine::new();
    let (mut exact, mut preview) =
        (engine.exact(ANKLE, 0, 0).unwrap(), engine.preview(ANKLE, 0, 0, 0.0, 0.1, 1001).unwrap());
    for name in ["F_i", "F_o", "F_x", "u1", "u2"] {
        let worst = (exact.find(name).unwrap().iter().zip(preview.find(name).unwrap())).map(|(a, b)| (a - b).abs());
        // Times that are the same but for rounding, at the rate of the highest mode: 1e-16 s × 1e4 rad/s × some newtons.
        assert!(worst.fold(0.0, f64::max) < 1e-9, "{name}");
    }
    let off = (exact.find("F_L").unwrap().iter().zip(preview.find("F_L").unwrap())).map(|(a, b)| (a - b).abs());
    // L to second order is good to 1e-7 here, and 0.1 % of L is 0.15 % of F_nom, 0.2 N.
    assert!(off.fold(0.0, f64::max) < 1e-4);
    let columns = meta(&preview)["spring"]["masses"].as_u64().unwrap() as usize + 2;
    let positions = preview.take_positions();
    assert_eq!(positions.len(), 1001 * columns);
    // End 2 is held, and single precision keeps seven digits.
    assert!((f64::from(positions[columns - 1]) - 0.23).abs() < 1e-8);
    assert!(exact.take(0).len() == 10_001 && exact.take(0).is_empty() && exact.take(999).is_empty());
}

#[test]
fn the_csv_is_what_simulate_writes() {
    let text = String::from_utf8(Engine::new().csv(ANKLE, 1, 0).unwrap()).unwrap();
    assert!(text.starts_with("time [s],u1 [m],u2 [m],F_i [N],F_o [N],F_x [N],F_L [N],L [H],"), "{}", &text[..80]);
    assert_eq!(text.lines().count(), 10_002);
}

#[test]
fn a_refusal_says_line_key_and_what_is_allowed() {
    let engine = Engine::new();
    let refusal = |text: &str| engine.preview(text, 0, 0, 0.0, 0.1, 100).unwrap_err();
    let wrong = refusal(&ANKLE.replace("\"65 g\"", "\"65 m\""));
    assert!(wrong.starts_with("spec:19: mass = \"65 m\": must be a mass with its unit"), "{wrong}");
    assert!(refusal("x =").starts_with("spec:1:"), "{}", refusal("x ="));
    assert!(refusal(VALVE).contains("cam-6000rpm.csv is not on this page"), "{}", refusal(VALVE));
    for (condition, damping) in [(5, 0), (0, 4), (usize::MAX, usize::MAX)] {
        assert!(engine.preview(ANKLE, condition, damping, 0.0, 0.1, 100).is_err());
        assert!(engine.exact(ANKLE, condition, damping).is_err());
    }
    for (from, to, samples) in [(0.0, f64::NAN, 100), (0.5, 0.1, 100), (0.0, 0.1, 1), (0.0, 0.1, 2001), (7.0, 8.0, 100)]
    {
        assert!(engine.preview(ANKLE, 0, 0, from, to, samples).is_err(), "{from} {to} {samples}");
    }
}

#[test]
fn a_recorded_motion_comes_from_a_file_that_was_given() {
    let mut engine = Engine::new();
    engine.add_file("cam-6000rpm.csv".to_owned(), CAM.to_owned());
    let answer = engine.preview(VALVE, 0, 1, 0.0, 0.04, 400).unwrap();
    let lift = answer.find("u1").unwrap().iter().fold(0.0_f64, |most, u1| most.max(*u1));
    // Ten millimetres of lift.
    assert!((lift - 0.01).abs() < 1e-4, "{lift}");
}

#[test]
fn the_paper_has_sixty_cells_and_its_figures() {
    let answer = Engine::new().paper().unwrap();
    let cells = meta(&answer)["cells"].as_array().unwrap().clone();
    assert_eq!(cells.len(), 60);
    let off: Vec<&Value> =
        cells.iter().filter(|cell| cell["table"] == "II" && cell["computed"]["tables"]["differs"] == true).collect();
    assert!(off.is_empty(), "{off:?}");
    for name in ["figure 2 chain", "S_T heel strike F_i", "S_A resonance F_L"] {
        assert!(answer.find(name).is_some_and(|values| values.len() > 500), "{name}");
    }
}
