//! A spring under a cam from speed to speed.
//!
//! | ours | held against |
//! |---|---|
//! | a run that repeats, nothing meeting | the closed form of the linear motion under the cam's harmonics |
//! | laws of lift | their values, and their slopes where pieces meet |
//! | a cam of a file | the law that it was written from |
//! | speeds that are added | harmonics times their speed |
//! | a map that was stopped, or made in parts | the same map at one go, bit by bit |

mod cams;
mod kept;
mod seats;

use std::f64::consts::TAU;

use coilsense::excitation::{EndInput, Excitation, Harmonic, Start};
use coilsense::{Channel, Motion};
use coilsense_lab::spec::Spec;
use coilsense_lab::speed::{Range, SpeedMap, answer};

const VALVE: &str = include_str!("../../../../examples/valve-spring.toml");

/// The valve spring without conditions, with tables of the speed map.
fn text(damping: &str, mount: &str, contact: &str, cam: &str) -> String {
    let (head, _) = VALVE.split_once("[[condition]]").unwrap();
    let head = head.replace("windings = 5.75\n", "model = \"chain\"\nmasses_per_winding = 1\nwindings = 5.75\n");
    let head = head.replace("[0.002, 0.01]", damping).replace("end2 = \"held\"", &format!("end2 = \"held\"\n{mount}"));
    format!("{head}\n[contact]\n{contact}\n[cam]\n{cam}\n")
}

const CAM: &str = "lift = \"10 mm\"\nangle = \"130 deg\"";

fn read(text: &str) -> Result<Spec, String> {
    read_with(text, "")
}

fn read_with(text: &str, file: &str) -> Result<Spec, String> {
    Spec::parse("valve.toml", text, &|_| Ok(file.to_owned())).map_err(|error| error.to_string())
}

fn map(text: &str, from: f64, to: f64) -> SpeedMap {
    let range = Range { from: from / 60.0, to: to / 60.0, step: 500.0 / 60.0, ratio: 0.5 };
    SpeedMap::of(read(text).unwrap(), range, &|_, _| true).unwrap()
}

#[test]
fn where_nothing_meets_a_run_is_the_closed_form_of_its_harmonics() {
    let text = text("0.01", "", "restitution = 0.0", CAM);
    let map = map(&text, 3000.0, 3000.0);
    let point = &map.points[0];
    assert!(point.touches == 0.0 && point.lifts.unwrap_or(0.0) == 0.0 && point.unsettled < 1e-3, "{point:?}");
    let (cam, spec) = (&map.cam, &map.spec);
    let samples = 4096;
    let lifts: Vec<f64> = (0..samples).map(|sample| cam.lift_at(sample as f64 / samples as f64)).collect();
    let mean = lifts.iter().sum::<f64>() / samples as f64;
    let harmonic = |number: usize| {
        let angle = |sample: usize| TAU * (number * sample % samples) as f64 / samples as f64;
        let of = |wave: fn(f64) -> f64| {
            2.0 / samples as f64
                * lifts.iter().enumerate().map(|(sample, lift)| lift * wave(angle(sample))).sum::<f64>()
        };
        let (cosine, sine) = (of(f64::cos), of(f64::sin));
        Harmonic { amplitude: cosine.hypot(sine), frequency: 25.0 * number as f64, phase: cosine.atan2(sine) }
    };
    let input = EndInput::Harmonics((1..=120).map(harmonic).collect());
    let excitation = Excitation::new(cam.length - mean, input, EndInput::Held, Start::Steady).unwrap();
    let motion = Motion::mounted(&spec.spring.spring, &spec.mount.cases[0].mount, &excitation).unwrap();
    let times: Vec<f64> = (0..8000).map(|sample| f64::from(sample) * 0.04 / 8000.0).collect();
    let signals = motion.signals(&times).unwrap();
    for (channel, found) in [(Channel::InputForce, point.input), (Channel::OutputForce, point.output)] {
        let force = signals.channel(channel).unwrap();
        let least = force.iter().copied().fold(f64::INFINITY, f64::min);
        let most = force.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // Three decays from rest leave 5 % of what rings at first.
        assert!((found[0] - least).abs() < 1.0 && (found[1] - most).abs() < 1.0, "{found:?} {least} {most}");
    }
}

#[test]
fn speeds_at_which_a_harmonic_has_the_surge_frequency_are_among_those_run() {
    let map = map(&text("0.01", "", "restitution = 0.0", CAM), 4000.0, 8000.0);
    let first = map.campbell.lines[0].frequency;
    assert!(map.campbell.crossings.len() > 4);
    for crossing in &map.campbell.crossings {
        assert!((crossing.harmonic as f64 * 0.5 * crossing.speed / first - 1.0).abs() < 1e-12);
        assert!(map.points.iter().any(|point| (point.speed - crossing.speed).abs() < 1e-9));
    }
    let mut speeds: Vec<f64> = map.points.iter().map(|point| 60.0 * point.speed).collect();
    assert!(speeds.is_sorted() && (speeds[0] - 4000.0).abs() < 1e-9 && (speeds.pop().unwrap() - 8000.0).abs() < 1e-9);
    // Slow: the static forces, k · 9 mm on the base circle and k · 19 mm at the nose.
    let slow = self::map(&text("0.01", "", "restitution = 0.0", CAM), 300.0, 300.0);
    let (k, point) = (slow.spec.spring.spring.stiffness(), &slow.points[0]);
    for force in [point.input, point.output] {
        assert!((force[0] + 0.019 * k).abs() < 2.0 && (force[1] + 0.009 * k).abs() < 2.0, "{force:?}");
    }
}

#[test]
fn a_heavier_follower_floats_at_a_lower_speed() {
    let floats_from = |mass: &str| {
        let map = map(&text("0.01", &format!("follower_mass = \"{mass}\""), "restitution = 0.0", CAM), 4000.0, 9000.0);
        let words = answer(&map).join("\n");
        assert!(words.contains("The follower floats ") && !words.contains("stays on its cam"), "{words}");
        let aloft = map.points.iter().find(|point| point.floating.unwrap().floats > 0.0);
        aloft.map(|point| 60.0 * point.speed).unwrap()
    };
    let (light, heavy) = (floats_from("80 g"), floats_from("160 g"));
    assert!(heavy < light - 500.0, "{light} {heavy}");
    let still = map(&text("0.01", "follower_mass = \"80 g\"", "restitution = 0.0", CAM), 1500.0, 2000.0);
    let words = answer(&still).join("\n");
    assert!(
        words.contains("stays on its cam at all speeds run, ")
            && words.contains(" to 2000 rpm;")
            && words.contains("Windings stay clear"),
        "{words}"
    );
    assert!(still.points.iter().all(|point| point.floating.unwrap().least_cam_force > 10.0), "{:?}", still.points);
}

#[test]
fn whether_figures_have_converged_in_the_masses_is_in_the_answer() {
    let text = text("0.002", "follower_mass = \"80 g\"", "restitution = 0.0\nends = false", CAM);
    // Off its cam a follower hits the spring: what that rings is another with more masses.
    let wild = map(&text, 8000.0, 8000.0);
    let words = answer(&wild).join("\n");
    assert!(words.contains("Not converged: with 2 masses per winding in place of 1, the largest surge is "), "{words}");
    assert!(words.contains("; 1 mass per winding"), "{words}");
    let (number, finer) = &wild.finer.runs[0];
    assert!(
        (finer.surge / wild.points[*number].surge - 1.0).abs() > 0.03,
        "{} {}",
        finer.surge,
        wild.points[*number].surge
    );
    // That is the map of a spec that asks for two.
    let fine = map(&text.replace("masses_per_winding = 1", "masses_per_winding = 2"), 8000.0, 8000.0);
    assert_eq!(fine.points[*number], *finer);
    // Far below, nothing floats or meets, and surge is that of a few modes.
    let calm = map(&text, 1500.0, 1500.0);
    let words = answer(&calm).join("\n");
    assert!(words.contains("Converged: with 2 masses per winding in place of 1, the largest surge is 4."), "{words}");
    assert_eq!((calm.finer.per_winding, &calm.finer.untried), (2, &None));
    // With seats on the follower it converges, too.
    let ends = map(&text.replace("ends = false", "ends = true"), 1500.0, 1500.0);
    assert!(answer(&ends).join("\n").contains("Converged: with 2 masses per winding in place of 1"));
    assert_eq!((ends.finer.per_winding, &ends.finer.untried), (2, &None));
    // Windings that meet their seat on a mass take no more than one: that is said, not passed over.
    let on_mass = text.replace("end2 = \"held\"", "end2 = \"mass\"\nend_mass = \"2 kg\"");
    let ends = map(&on_mass.replace("ends = false", "ends = true"), 1500.0, 1500.0);
    let words = answer(&ends).join("\n");
    assert!(
        words.contains("is not checked at every decisive speed: windings that meet their seat")
            && words.contains("set ends = false in [contact] for more")
            && ends.finer.runs.is_empty(),
        "{words}"
    );
    // Of a spec that asks for none there are as many as the first surge frequency takes; a resonance lies at it.
    let spare = text.replace("masses_per_winding = 1\n", "");
    assert_eq!(map(&spare, 1500.0, 1500.0).masses_per_winding, 2);
    // Sensors are judged elsewhere.
    assert!(
        answer(&map(
            &spare.replace("[cam]", "[[sensor]]\nname = \"cell\"\nkind = \"load-cell\"\n[cam]"),
            1500.0,
            1500.0
        ))
        .join("\n")
        .contains("speed judges no sensors; analyze does, under conditions: cell.")
    );
}

#[test]
fn what_is_no_cam_or_no_range_is_refused_in_a_line() {
    let refused = |text: &str| read(text).map(|_| ()).unwrap_err();
    for (cam, part) in [
        ("lift = \"10 mm\"", "lacks the key \"angle\""),
        ("lift = \"17 mm\"\nangle = \"130 deg\"", "at which the spring is solid"),
        ("lift = \"10 mm\"\nangle = \"400 deg\"", "below 360 deg"),
        ("lift = \"10 mm\"\nangle = \"130 deg\"\nlaw = \"sine\"", "must be"),
        ("file = \"cam.csv\"\nlift = \"10 mm\"", "lift in [cam] is no key of a cam of a file"),
        ("lift = \"10 mm\"\nangle = \"130 deg\"\nlength = \"70 mm\"", "the range in use"),
    ] {
        let message = refused(&text("0.01", "", "", cam));
        assert!(message.contains(part) && message.lines().count() == 1, "{message}");
    }
    let of = |text: &str, range: Range| {
        SpeedMap::of(read(text).unwrap(), range, &|_, _| true).map(|_| ()).unwrap_err().to_string()
    };
    let range = Range { from: 20.0, to: 100.0, step: 5.0, ratio: 0.5 };
    let good = text("0.01", "", "", CAM);
    assert!(of(&good, Range { to: 10.0, ..range }).contains("to must be from 1200 to 600000 rpm, got 600 rpm"));
    assert!(of(&good, Range { step: 0.0, ..range }).contains("step must be above 0"));
    let (without_cam, _) = good.split_once("[cam]").unwrap();
    assert!(of(without_cam, range).contains("no table [cam]"));
    assert!(of(&good.replace("[contact]\n", ""), range).contains("takes a table [contact]"));
    // Both at once, in a line.
    let neither = of(&without_cam.replace("[contact]\n", ""), range);
    let parts = ["no table [cam]", "takes a table [contact] (windings = \"hard\")", "follower_mass under [mount]"];
    assert!(parts.iter().all(|part| neither.contains(part)) && neither.lines().count() == 1, "{neither}");
    let stopped = SpeedMap::of(read(&good).unwrap(), range, &|done, _| done < 2).map(|_| ()).unwrap_err();
    assert!(stopped.to_string().contains("interrupted"));
}

#[test]
fn a_step_of_1000_rpm_finds_the_worst_surge_of_one_of_100() {
    // Without refinement, a step of 1000 rpm from 4000 on would meet no peak of a mode of ζ = 0.005: they are 0.5 % wide.
    let text = text("0.005", "", "restitution = 0.0", CAM);
    let worst = |step: f64| {
        let range = Range { from: 4000.0 / 60.0, to: 8000.0 / 60.0, step: step / 60.0, ratio: 0.5 };
        let map = SpeedMap::of(read(&text).unwrap(), range, &|_, _| true).unwrap();
        let at_steps = map
            .points
            .iter()
            .filter(|point| (60.0 * point.speed / step).fract().min(1.0 - (60.0 * point.speed / step).fract()) < 1e-6);
        let least = at_steps.map(|point| point.surge).fold(0.0, f64::max);
        let most = map.points.iter().max_by(|a, b| a.surge.total_cmp(&b.surge)).unwrap();
        (most.surge, least, most.speed, map.added[0])
    };
    let (fine, _, at, _) = worst(100.0);
    let (coarse, at_steps, there, added) = worst(1000.0);
    // Windings that meet limit the peak: between points of one bandwidth it moves by a few percent.
    assert!((coarse / fine - 1.0).abs() < 0.04, "{coarse} {fine}");
    assert!((there / at - 1.0).abs() < 0.02 && added > 10, "{there} {at} {added}");
    assert!(at_steps < 0.9 * fine, "{at_steps} {fine}");
}

#[test]
fn points_beside_a_crossing_show_the_width_of_its_peak() {
    let map = map(&text("[0.001, 0.01]", "", "restitution = 0.0", CAM), 3000.0, 4000.0);
    for (way, ratio) in [(0, 0.001), (1, 0.01)] {
        let speeds: Vec<f64> = map.of_way(way).map(|point| point.speed).collect();
        for crossing in &map.campbell.crossings {
            for share in [1.0 - ratio, 1.0, 1.0 + ratio] {
                let expected = share * crossing.speed;
                let is_within = (50.0..=4000.0 / 60.0).contains(&expected);
                let nearest = speeds.iter().map(|speed| (speed / expected - 1.0).abs()).fold(f64::INFINITY, f64::min);
                assert!(!is_within || nearest < 1.1e-4, "{way} {expected}: {nearest:e}");
            }
        }
    }
    let words = answer(&map).join("\n");
    assert!(words.contains("Besides the steps"), "{words}");
    // Slower than any harmonic that is looked at can reach the surge frequency: none is added.
    let slow = self::map(&text("0.01", "", "restitution = 0.0", CAM), 300.0, 300.0);
    assert!(slow.added == [0] && !answer(&slow).join("\n").contains("Besides the steps"));
}

#[test]
fn a_cam_of_harmonics_is_their_sum_counted_from_its_least() {
    let cam = "harmonics = [[1, \"-3 mm\"], [2, \"0.8 mm\", \"30 deg\"], [7, \"20 um\", \"-1 rad\"]]";
    let cam = read(&text("0.01", "", "", cam)).unwrap().cam.unwrap();
    let sum = |turn: f64| {
        -3e-3 * (TAU * turn).cos()
            + 0.8e-3 * (2.0 * TAU * turn + TAU / 12.0).cos()
            + 2e-5 * (7.0 * TAU * turn - 1.0).cos()
    };
    let turns: Vec<f64> = (0..20_000).map(|sample| f64::from(sample) / 20_000.0).collect();
    let least = turns.iter().map(|turn| sum(*turn)).fold(f64::INFINITY, f64::min);
    let most = turns.iter().map(|turn| sum(*turn)).fold(f64::NEG_INFINITY, f64::max);
    for turn in &turns {
        // The least of samples is off by the square of their distance.
        assert!((cam.lift_at(*turn) - (sum(*turn) - least)).abs() < 1e-9, "{turn}");
    }
    assert!((cam.lift - (most - least)).abs() < 1e-9 && cam.lift_at(cam.least_at).abs() < 1e-12);
    let refused =
        |harmonics: &str| read(&text("0.01", "", "", &format!("harmonics = {harmonics}"))).map(|_| ()).unwrap_err();
    for wrong in [
        "[]",
        "[[0, \"1 mm\"]]",
        "[[1, \"1 mm\"], [1, \"2 mm\"]]",
        "[[1.5, \"1 mm\"]]",
        "[[1, 3]]",
        "[[1, \"1 mm\", \"1 s\"]]",
    ] {
        let message = refused(wrong);
        assert!(message.contains("list of 1 to 64 lists") && message.lines().count() == 1, "{message}");
    }
    assert!(refused("[[1, \"9 mm\"]]").contains("at which the spring is solid"));
    assert!(refused("[[1, \"1 mm\"]]\nlift = \"2 mm\"").contains("no key of a cam of harmonics"));
}

#[test]
fn harmonics_of_the_force_are_those_of_the_motion_under_one_of_the_cam() {
    // One harmonic at 20 Hz, far below f1, and its answer in closed form; the steady state has no other.
    let text = text("0.01", "", "restitution = 0.0", "harmonics = [[1, \"4 mm\", \"180 deg\"]]");
    let map = map(&text, 2400.0, 2400.0);
    let (point, spec) = (&map.points[0], &map.spec);
    let input = EndInput::Harmonics(vec![Harmonic { amplitude: 4e-3, frequency: 20.0, phase: 0.0 }]);
    let excitation = Excitation::new(map.cam.length - 4e-3, input, EndInput::Held, Start::Steady).unwrap();
    let motion = Motion::mounted(&spec.spring.spring, &spec.mount.cases[0].mount, &excitation).unwrap();
    let times: Vec<f64> = (0..1000).map(|sample| f64::from(sample) * 5e-5).collect();
    let signals = motion.signals(&times).unwrap();
    let force = signals.channel(Channel::OutputForce).unwrap();
    let swing =
        force.iter().copied().fold(f64::NEG_INFINITY, f64::max) - force.iter().copied().fold(f64::INFINITY, f64::min);
    // What is left of the start from rest.
    assert!((point.harmonics[0] - 0.5 * swing).abs() < 0.02, "{} {}", point.harmonics[0], 0.5 * swing);
    assert!(point.harmonics[1..].iter().all(|amplitude| *amplitude < 0.3), "{:?}", point.harmonics);
}

#[test]
fn a_slow_cam_stresses_the_wire_as_its_static_forces_do() {
    let cam = text("0.01", "", "restitution = 0.0", CAM);
    let strong = cam
        .replace("[mount]", "endurance_shear_strength = \"300 MPa\"\nultimate_shear_strength = \"1100 MPa\"\n[mount]");
    let (plain, strong) = (map(&cam, 300.0, 300.0), map(&strong, 300.0, 300.0));
    let stress = plain.points[0].stress.unwrap();
    let geometry = &plain.spec.spring.geometry;
    let of = |stretch: f64| geometry.corrected_shear_stress(plain.spec.spring.spring.stiffness() * stretch);
    // Waves at 300 rpm are within 2 N of 551 N.
    assert!(
        (stress.largest / of(0.019) - 1.0).abs() < 5e-3 && (stress.least / of(0.009) - 1.0).abs() < 1e-2,
        "{stress:?}"
    );
    assert_eq!(stress.safety, None);
    assert!(answer(&plain).join("\n").contains("gives no strengths"));
    let factor = strong.points[0].stress.unwrap().safety.unwrap();
    let expected = 1.0 / (0.5 * (of(0.019) - of(0.009)) / 300e6 + 0.5 * (of(0.019) + of(0.009)) / 1100e6);
    assert!((factor / expected - 1.0).abs() < 1e-2, "{factor} {expected}");
    assert!(answer(&strong).join("\n").contains("a Goodman factor of"));
    let refused = |keys: &str| read(&cam.replace("[mount]", &format!("{keys}\n[mount]"))).map(|_| ()).unwrap_err();
    assert!(refused("endurance_shear_strength = \"300 MPa\"").contains("lacks the key \"ultimate_shear_strength\""));
    let swapped = refused("endurance_shear_strength = \"900 MPa\"\nultimate_shear_strength = \"800 MPa\"");
    assert!(swapped.contains("must be below ultimate_shear_strength of 800 MPa"), "{swapped}");
}

#[test]
fn windings_stay_closed_for_longer_than_none_where_they_meet_and_seats_are_pressed_until_an_end_leaves() {
    let map = map(&text("0.002", "", "restitution = 0.0", CAM), 3000.0, 8000.0);
    for point in &map.points {
        let [first, second] = point.least_push();
        assert!(first == 0.0 - point.input[1] && second == 0.0 - point.output[1]);
        assert!((0.0..=1.0).contains(&point.closed) && (point.touches > 0.0 || point.closed == 0.0), "{point:?}");
        // An end that leaves is not pulled; one that stays is pressed.
        assert!(first >= -1e-6 && second >= -1e-6, "{point:?}");
        assert!(point.lifts == Some(0.0) || first.min(second) < 1e-6, "{point:?}");
    }
    assert!(
        map.points.iter().any(|point| point.closed > 1e-3) && map.points.iter().any(|point| point.lifts > Some(0.0))
    );
}

#[test]
fn between_speeds_that_lie_far_apart_nothing_is_said_to_hold() {
    let far = map(&text("0.002", "", "restitution = 0.0", CAM), 8500.0, 10_500.0);
    let words = answer(&far).join("\n");
    assert!(far.points.iter().any(|point| point.meets()), "{words}");
    assert!(words.contains("apart, between which it is not known"), "{words}");
    assert!(!words.contains("for 0 % of a turn") && !words.contains("for 0.00 % of a turn"), "{words}");
}
