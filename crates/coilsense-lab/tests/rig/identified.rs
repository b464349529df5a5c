//! What is identified from the rig's hits is what was put in.

use coilsense::identify::{Answer, Identification, Settings};
use coilsense::{Channel, Signals};

use super::{PAPER, ends, log, rig, spec};

/// What the record of a run says.
fn identified(rig: &coilsense_lab::rig::Rig, name: &str) -> Identification {
    let log = log(rig, name);
    let mut signals = Signals::new(log.fast.values("time").unwrap().to_vec()).unwrap();
    let (force, u1) = ends(&log);
    signals.insert(Channel::OutputForce, force.to_vec()).unwrap();
    signals.insert(Channel::U1, u1.to_vec()).unwrap();
    Identification::of(&signals, &Settings::default()).unwrap()
}

#[test]
fn hits_show_the_spring_and_its_damping() {
    let mut weak = 0;
    for damping in [0.001, 0.005, 0.02, 0.05] {
        let tables = PAPER.replace("0.005", &damping.to_string());
        let spring = spec(&tables).spring.spring;
        let modes = coilsense::modes::ChainModes::of(&spring);
        let places: Vec<f64> = modes.frequencies().iter().map(|omega| omega / std::f64::consts::TAU).collect();
        let first = places[0];
        for run in ["hit-1", "hit-2"] {
            let found = identified(&rig(&tables, 1), run);
            let (frequency, ratio) = (found.first_frequency.unwrap().value, found.ratio.unwrap().value);
            assert_eq!(found.verdict.answer, Answer::Spring, "{:?}", found.verdict);
            // What identification promises.
            assert!((frequency - first).abs() < (0.1 * damping * first).max(0.1), "{damping} {run}: {frequency} Hz");
            assert!((ratio / damping - 1.0).abs() < 0.15, "{damping} {run}: {ratio}");
            // Of a mode that is too weak for its decay to be heard nobody says that it is steady.
            let is_mode = |at: f64| places.iter().any(|place| (at / place - 1.0).abs() < 1e-3);
            for line in found.lines.iter().filter(|line| !line.decays && is_mode(line.frequency.value)) {
                assert!(line.reason.starts_with("no decay is heard, yet mode"), "{line:?}");
                weak += 1;
            }
        }
    }
    assert!(weak > 0);
}
