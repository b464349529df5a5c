//! Modes on the page, without a browser: the data sheet's at its lengths, and one of them as the wire moves.

use coilsense_lab::spec::Spec;
use coilsense_web::Engine;
use coilsense_web::answer::Answer;
use serde_json::Value;

const CAR: &str = include_str!("../../../examples/car-suspension.toml");
const ROAD: &str = include_str!("../../../examples/road-c-20mps.csv");
const ANKLE: &str = include_str!("../../../examples/sea-ankle.toml");

fn meta(answer: &Answer) -> Value {
    serde_json::from_str(&answer.meta()).unwrap()
}

/// The first band of a kind.
fn band<'a>(answer: &'a Answer, name: &str) -> &'a [f64] {
    let found = (0..20).find_map(|order| answer.find(&format!("{name} {order}")));
    found.unwrap()
}

#[test]
fn lines_over_length_are_those_of_every_mode_there() {
    let answer = Engine::new().modes(ANKLE, 49).unwrap();
    let found = meta(&answer);
    let spec = Spec::parse("spec", ANKLE, &|_| Err("no files".to_owned())).unwrap();
    let coil = spec.spring.helix(&spec.mount.ends).unwrap();
    // The shortest, the longest, and between lengths at which kinds were looked at.
    for at in [0, 3, 12, 21, 39, 48] {
        let there = coil.at(answer.find("length").unwrap()[at]).unwrap();
        for (way, told) in there.ways().enumerate() {
            assert_eq!(found["ends"][way], told.ends);
            assert_eq!(answer.find(&format!("buckles {way}")).unwrap()[at], 0.0);
            let top = found["top"].as_f64().unwrap();
            for (index, mode) in told.modes.iter().enumerate().filter(|(_, mode)| mode.frequency_hz < top) {
                let curve = answer.find(&format!("curve {way} {} {}", index + 1, mode.kind)).unwrap();
                assert!((curve[at] / mode.frequency_hz - 1.0).abs() < 1e-9, "{at} {index}");
            }
        }
        // Of the first lateral pair, from the loosest ends to the tightest.
        let first = |way: &coilsense_lab::helix::UnderEnds| way.first("lateral").unwrap().frequency_hz;
        let (lower, upper) = (band(&answer, "lower lateral")[at], band(&answer, "upper lateral")[at]);
        let edges = [lower / first(there.loosest.as_ref().unwrap()), upper / first(&there.held)];
        assert!(edges.iter().all(|edge| (edge - 1.0).abs() < 1e-9), "{edges:?}");
    }
    // Two sines; the impact and both end stops drive every frequency.
    assert_eq!(found["broad"], serde_json::json!([true, true, true, false, false]));
    assert_eq!((&found["driven"][0][0], &found["driven"][1][0]), (&3.into(), &4.into()));
    assert!((found["driven"][1][1].as_f64().unwrap() - 54.1).abs() < 0.1);
    assert_eq!(found["isChain"], ANKLE.contains("model = \"chain\""));
}

#[test]
fn a_mode_moves_the_wire_between_ends_that_are_held() {
    let engine = Engine::new();
    for number in 1..=4 {
        let mut answer = engine.mode_shape(ANKLE, 0.23, false, number, 12).unwrap();
        let facts = meta(&answer);
        let (found, told) = (&facts["mode"], &facts["under"]["modes"][number - 1]);
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
    for (length, number, points) in
        [(0.23, 0, 12), (0.23, 101, 12), (0.23, 1, 0), (0.23, 1, 65), (f64::NAN, 1, 12), (9.0, 1, 12)]
    {
        let refused = engine.mode_shape(ANKLE, length, false, number, points).unwrap_err();
        assert!(refused.contains("must be"), "{refused}");
    }
    assert!(engine.modes(ANKLE, 1).is_err() && engine.modes(ANKLE, 201).is_err());
    // Three windings of 8 mm are 183 mm of wire, shorter than the spring is to be.
    let short = ANKLE.replace("windings = 52", "windings = 3");
    let refused = engine.modes(&short, 9).unwrap_err();
    assert!(refused.starts_with("span must be above zero and below"), "{refused}");
    assert_eq!(engine.mode_shape(&short, 0.264, false, 1, 12).unwrap_err(), refused);
}

#[test]
fn lines_end_where_the_spring_buckles() {
    let mut engine = Engine::new();
    engine.add_file("road-c-20mps.csv".to_owned(), ROAD.to_owned());
    let loose = CAR.replace("[mount]", "[mount]\nends_tilt = \"between\"");
    let answer = engine.modes(&loose, 9).unwrap();
    let has_buckled = answer.find("buckles 1").unwrap();
    // Free to tilt it leaves its axis when it is compressed far enough; held it does not.
    assert_eq!((has_buckled[0], has_buckled[8]), (1.0, 0.0));
    assert_eq!(answer.find("buckles 0").unwrap(), [0.0; 9]);
    let names = answer.names();
    for name in names.iter().filter(|name| name.starts_with("curve 1") || name.starts_with("lower")) {
        let values = answer.find(name).unwrap();
        let is_there = values.iter().zip(has_buckled).all(|(value, buckled)| value.is_nan() || *buckled == 0.0);
        assert!(is_there, "{name}: {values:?}");
    }
}
