//! The verdict, asked of the larger engine case by case without a browser.
#![cfg(feature = "workshop")]

use coilsense_lab::analysis::Analysis;
use coilsense_lab::report::analysis_json;
use coilsense_lab::spec::Spec;
use coilsense_web::Engine;
use coilsense_web::verdict::Judge;
use serde_json::Value;

const SUSPENSION: &str = include_str!("../../../examples/car-suspension.toml");
const ROAD: &str = include_str!("../../../examples/road-c-20mps.csv");

fn engine() -> Engine {
    let mut engine = Engine::new();
    engine.add_file("road-c-20mps.csv".into(), ROAD.into());
    engine
}

/// The verdict, and how many steps it took.
fn judged(judge: &mut Judge, text: &str) -> (Value, usize) {
    let count = judge.begin(&engine(), text).unwrap();
    let (mut done, mut steps) = (0, 0);
    while done < count {
        done = judge.step().unwrap();
        steps += 1;
    }
    let meta: Value = serde_json::from_str(&judge.conclude().unwrap().meta()).unwrap();
    (meta["json"].clone(), steps)
}

fn of_the_command(text: &str) -> Value {
    let spec = Spec::parse("spec", text, &|_| Ok(ROAD.to_owned())).unwrap();
    let analysis = Analysis::run(spec, &|_, _| true).unwrap();
    serde_json::from_str(&analysis_json(&analysis, "").unwrap()).unwrap()
}

#[test]
fn one_after_the_other_each_is_the_commands() {
    let mut judge = Judge::new();
    let slower = SUSPENSION.replacen("damping_ratio = 0.005", "damping_ratio = 0.02", 1);
    assert_ne!(slower, SUSPENSION);
    for text in [SUSPENSION, &slower, SUSPENSION] {
        assert!(judged(&mut judge, text).0 == of_the_command(text));
    }
    // Nothing changed: one step takes all that is known.
    assert_eq!(judged(&mut judge, SUSPENSION).1, 1);
}

#[test]
fn what_is_wrong_is_said_and_the_next_spec_is_judged() {
    let mut judge = Judge::new();
    let none = |found: Result<usize, String>| assert_eq!(found.err().as_deref(), Some("no spec is being judged"));
    none(judge.step());
    let wrong = judge.begin(&engine(), &SUSPENSION.replacen("mass = \"", "mass = \"-", 1)).unwrap_err();
    assert!(wrong.starts_with("spec:"), "{wrong}");
    let still = SUSPENSION.split("[[condition]]").next().unwrap();
    let error = judge.begin(&engine(), still).unwrap_err();
    assert!(error.contains("no [[condition]]"), "{error}");
    none(judge.step());
    assert!(judged(&mut judge, SUSPENSION).0 == of_the_command(SUSPENSION));
    none(judge.conclude().map(|_| 0));
}
