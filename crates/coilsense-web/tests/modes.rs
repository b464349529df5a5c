//! Modes on the page, without a browser: the data sheet's at its lengths, and one of them as the wire moves.

use coilsense_lab::spec::Spec;
use coilsense_web::Engine;
use coilsense_web::answer::Answer;
use serde_json::Value;

const ANKLE: &str = include_str!("../../../examples/sea-ankle.toml");

fn meta(answer: &Answer) -> Value {
    serde_json::from_str(&answer.meta()).unwrap()
}

#[test]
fn lines_over_length_are_those_of_every_mode_there() {
    let found = meta(&Engine::new().modes(ANKLE, 49).unwrap());
    let spec = Spec::parse("spec", ANKLE, &|_| Err("no files".to_owned())).unwrap();
    let coil = spec.spring.helix(&spec.mount.ends).unwrap();
    // The shortest, the longest, and between lengths at which kinds were looked at.
    for at in [0, 3, 12, 21, 39, 48] {
        let there = coil.at(found["lines"]["lengths_m"][at].as_f64().unwrap()).unwrap();
        for (way, told) in found["lines"]["ways"].as_array().unwrap().iter().zip(there.ways()) {
            assert_eq!(way["ends"], told.ends);
            let curves = way["curves"].as_array().unwrap();
            let top = found["lines"]["top_hz"].as_f64().unwrap();
            for (index, mode) in told.modes.iter().enumerate().filter(|(_, mode)| mode.frequency_hz < top) {
                let is = |curve: &&Value| curve["number"] == index + 1 && curve["kind"] == mode.kind;
                let hertz = curves.iter().find(is).unwrap()["frequency_hz"][at].as_f64().unwrap();
                assert!((hertz / mode.frequency_hz - 1.0).abs() < 1e-9, "{at} {index}");
            }
        }
    }
    // Two sines; the impact and both end stops drive every frequency.
    let names = |key: &str| found[key].as_array().unwrap().len();
    assert_eq!((names("driven"), names("broad")), (2, 3));
    assert!((found["driven"][1]["frequency_hz"].as_f64().unwrap() - 54.1).abs() < 0.1);
    assert_eq!(found["isChain"], ANKLE.contains("model = \"chain\""));
}

#[test]
fn a_mode_moves_the_wire_between_ends_that_are_held() {
    let engine = Engine::new();
    for number in 1..=4 {
        let mut answer = engine.mode_shape(ANKLE, 0.23, false, number, 12).unwrap();
        let facts = meta(&answer);
        let (found, told) = (&facts["mode"], &facts["at"]["modes"][number - 1]);
        assert_eq!(found, told);
        let positions = answer.take_positions();
        // Twelve points for each of 52 windings, and the last.
        assert_eq!(positions.len(), 6 * (12 * 52 + 1));
        let points: Vec<&[f32]> = positions.chunks(6).collect();
        let moved = |point: &[f32]| point[3].hypot(point[4]).hypot(point[5]);
        // Both ends are held, and of the points that are left out one may be the farthest.
        assert!(moved(points[0]) < 1e-6 && moved(points[624]) < 1e-6);
        let most = points.iter().map(|point| moved(point)).fold(0.0, f32::max);
        assert!(most <= 1.0 + 1e-6 && most > 0.95, "{most}");
        let span = points[624][2] - points[0][2];
        assert!((span - 0.23).abs() < 2e-3, "{span}");
        // A spring alike at both ends feels alike there.
        let side = |end: usize| facts["ends"][end]["side_force_n_per_n"].as_f64().unwrap();
        assert!((side(0) / side(1) - 1.0).abs() < 1e-3);
    }
}

#[test]
fn what_is_no_helix_or_no_mode_is_refused_in_words() {
    let engine = Engine::new();
    for (length, number, points) in [(0.23, 0, 12), (0.23, 101, 12), (0.23, 1, 0), (0.23, 1, 65), (f64::NAN, 1, 12), (9.0, 1, 12)] {
        let refused = engine.mode_shape(ANKLE, length, false, number, points).unwrap_err();
        assert!(refused.contains("must be"), "{refused}");
    }
    assert!(engine.modes(ANKLE, 1).is_err() && engine.modes(ANKLE, 201).is_err());
    let begun = std::time::Instant::now();
    engine.modes(ANKLE, 49).unwrap();
    println!("{:?}", begun.elapsed());
}
