//! Windings that meet, asked of the larger engine without a browser.
#![cfg(feature = "workshop")]

use coilsense_lab::analysis::simulate;
use coilsense_lab::spec::Spec;
use coilsense_web::Engine;
use serde_json::Value;

const VALVE: &str = include_str!("../../../examples/valve-spring.toml");
const CAM: &str = include_str!("../../../examples/cam-6000rpm.csv");

/// The valve spring as a mass for each winding, wound so that the cam's 8th harmonic meets its surge, with a table `[contact]` of these keys.
fn valve(contact: &str) -> String {
    let text = VALVE.replace("\"25 mm\"", "\"24.75 mm\"").replace("[mount]", "masses_per_winding = 1\n\n[mount]");
    format!("{text}\n[contact]\n{contact}\n")
}

fn engine() -> Engine {
    let mut engine = Engine::new();
    engine.add_file("cam-6000rpm.csv".into(), CAM.into());
    engine
}

#[test]
fn windings_that_meet_are_those_of_the_whole_analysis() {
    let text = valve("windings = \"hard\"");
    let spec = Spec::parse("spec", &text, &|_| Ok(CAM.to_owned())).unwrap();
    let cases = simulate(&spec, &|_, _| true).unwrap();
    let case = cases.iter().find(|case| (case.condition, case.damping) == (1, 1)).unwrap();
    let contacts = case.contacts.as_ref().unwrap();
    assert!(!contacts.touches.is_empty());
    let answer = engine().exact(&text, 1, 1).unwrap();
    for (channel, values) in case.signals.channels() {
        // The same code on the same processor.
        assert_eq!(answer.find(channel.name()).unwrap(), values, "{}", channel.name());
    }
    let meta: Value = serde_json::from_str(&answer.meta()).unwrap();
    assert_eq!(meta["contact"]["law"], "e = 0.5");
    assert_eq!(meta["contact"]["touches"], contacts.touches.len());
    let begun: Vec<f64> = contacts.touches.iter().map(|touch| touch.time).collect();
    assert_eq!(answer.find("closed from").unwrap(), begun);
    let (closed, opened) = (answer.find("closed from").unwrap(), answer.find("closed to").unwrap());
    assert!(closed.iter().zip(opened).all(|(from, to)| from <= to));
    // Seats at 0 and N, windings between.
    assert!(answer.find("closed gap").unwrap().iter().all(|gap| (0.0..=6.0).contains(gap)));
}

#[test]
fn a_preview_has_them_meet_when_the_exact_case_does() {
    let text = valve("windings = \"hard\"\nrestitution = 0");
    let (exact, preview) =
        (engine().exact(&text, 1, 0).unwrap(), engine().preview(&text, 1, 0, 0.06, 0.09, 1201).unwrap());
    let first = exact.find("closed from").unwrap()[0];
    assert!((preview.find("closed from").unwrap()[0] - first).abs() < 1e-9);
}

#[test]
fn what_knows_no_contact_refuses_it() {
    let text = valve("windings = \"hard\"");
    let refused = engine().mitigate_usual(&text, "{}").unwrap_err();
    assert!(refused.contains("[contact]: mitigate takes windings = \"off\""), "{refused}");
    let refused = engine().trial_log(&text, 0, 0).unwrap_err();
    assert!(refused.contains("[contact]: a simulated log takes windings = \"off\""), "{refused}");
    let off = engine().exact(&valve("windings = \"off\""), 1, 0).unwrap();
    assert!(off.find("closed from").is_none());
    let cam = format!("{text}\n[cam]\nlaw = \"cycloidal\"\n");
    assert!(engine().exact(&cam, 1, 0).is_err());
}
