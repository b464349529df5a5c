//! Windings that meet, from a spec's `[contact]` to the answer.
//!
//! Figures of the valve's chain of six masses: an event-driven integrator of its own and velocity impulses in small steps, which agree to a
//! thousandth (the cam's law itself, where these specs have its file).

use coilsense::Channel;
use coilsense_lab::analysis::{Analysis, AnalysisError, Case, Subject, answer, simulate};
use coilsense_lab::spec::Spec;
use coilsense_lab::study::Between;

const VALVE: &str = include_str!("../../../../examples/valve-spring.toml");
const CAM: &str = include_str!("../../../../examples/cam-6000rpm.csv");
/// A spring with an end mass.
const SUSPENSION: &str = include_str!("../../../../examples/car-suspension.toml");

/// The valve spring as six masses, with a table `[contact]` of these keys; the damping ratio takes the place of the spec's.
fn six_masses(damping: &str, contact: &str) -> String {
    let chain = "model = \"chain\"\nmasses_per_winding = 1\nwindings = 5.75\n";
    let text = VALVE.replace("windings = 5.75\n", chain).replace("[0.002, 0.01]", damping);
    format!("{text}\n[contact]\n{contact}\n")
}

fn read(text: &str) -> Result<Spec, String> {
    Spec::parse("valve.toml", text, &|_| Ok(CAM.to_owned())).map_err(|error| error.to_string())
}

fn cases(text: &str) -> Vec<Case> {
    simulate(&read(text).unwrap(), &|_, _| true).unwrap()
}

fn analysis(text: &str) -> Analysis {
    Analysis::run(read(text).unwrap(), &|_, _| true).unwrap()
}

/// Rms of F_o − F_i over the judged part.
fn apart(case: &Case) -> f64 {
    let [input, output] = [Channel::InputForce, Channel::OutputForce].map(|force| case.signals.channel(force).unwrap());
    let judged = case.judged.clone();
    let square: f64 = judged.clone().map(|sample| (output[sample] - input[sample]).powi(2)).sum();
    (square / judged.len() as f64).sqrt()
}

#[track_caller]
fn close(found: f64, expected: f64, share: f64) {
    assert!((found / expected - 1.0).abs() <= share, "{found} is not {expected}");
}

const BARE: &str = "ends = false\nlift_off = false\n";

#[test]
fn six_masses_that_meet_are_those_of_two_other_programs() {
    let each = cases(&six_masses("0.0", &format!("restitution = [0.0, 0.2, 0.5]\n{BARE}")));
    // Second condition: from 0.24 to 0.3 s.
    for (case, rms) in each[3..].iter().zip([545.5, 522.55, 502.24]) {
        let contacts = case.contacts.as_ref().unwrap();
        // The file's cam is straight between its samples: 0.7 µs.
        assert!((contacts.first.unwrap() - 0.067_901_349_8).abs() < 1.5e-6, "{:?}", contacts.first);
        assert_eq!(contacts.between(&contacts.touches[0]), Between::Windings(5));
        close(apart(case), rms, 0.01);
        assert!(contacts.meetings.iter().all(|meeting| (0.0..=1.0).contains(&meeting.closed)));
    }
    let calm = each[3].contacts.as_ref().unwrap();
    assert!((90..110).contains(&calm.touches.len()), "{}", calm.touches.len());
    close(calm.balance.lost, 3.19283, 0.01);
    assert_eq!(calm.holds_until, Some(calm.until));
    // What gives way as little as steel does, and loses as much: 568.8 N of K_c = 1e4 N k, where hard windings have 569.7.
    let soft = cases(&six_masses("0.002", &format!("windings = \"elastic\"\ndamping_ratio = 3\n{BARE}")));
    close(apart(&soft[1]), 568.8, 0.01);
}

#[test]
fn seats_matter_and_no_end_is_pulled() {
    let ends = cases(&six_masses("0.002", "restitution = 0.0\nlift_off = false\n"));
    let running = &ends[1];
    close(apart(running), 408.3, 0.01);
    let contacts = running.contacts.as_ref().unwrap();
    let at_seats = contacts.touches.iter().filter(|touch| contacts.between(touch) != Between::Windings(1));
    assert!(at_seats.count() > 50);
    let free = cases(&six_masses("0.002", "restitution = 0.0\n"));
    for force in [Channel::InputForce, Channel::OutputForce] {
        assert!(free[1].signals.channel(force).unwrap().iter().all(|force| *force < 1e-6));
    }
    assert!(!free[1].contacts.as_ref().unwrap().lifts.is_empty());
}

#[test]
fn where_nothing_meets_the_answer_is_that_without_contact() {
    let text = six_masses("0.01", "restitution = 0.0");
    let (meets, off) = (cases(&text), cases(&text.replace("restitution = 0.0", "windings = \"off\"")));
    let (first, other) = (&meets[0], &off[0]);
    assert!(first.contacts.as_ref().unwrap().first.is_none() && other.contacts.is_none());
    assert_eq!(first.signals, other.signals);
    assert_eq!(first.readings[0].force, other.readings[0].force);
}

#[test]
fn every_figure_is_told_for_the_least_and_the_most_that_windings_rebound() {
    let analysis = analysis(&six_masses("0.002", ""));
    let labels: Vec<&str> = analysis.spec.mount.cases.iter().map(|case| case.label.as_str()).collect();
    assert_eq!(labels, ["ζ = 0.002, e = 0", "ζ = 0.002, e = 0.5"]);
    let words = answer(&analysis).join("\n");
    for part in ["How windings rebound, which nobody has measured", "at e = 0 and e = 0.5", "where windings meet"] {
        assert!(words.contains(part), "{part}: {words}");
    }
    let of = |subject| analysis.warnings.iter().filter(move |warning| warning.subject == subject);
    assert_eq!(of(Subject::Clash).count(), 0);
    let told: Vec<&str> = of(Subject::Contact).map(|warning| warning.text.as_str()).collect();
    assert!(told.iter().any(|text| text.contains("windings meet from t = 0.0") && text.contains("mN s")), "{told:?}");
    // A spec that knows its restitution gets that alone, and is told so.
    let known = analysis_of_one("0.3");
    let words = answer(&known).join("\n");
    assert!(words.contains("Windings meet by e = 0.3 alone, as the spec says"), "{words}");
}

fn analysis_of_one(restitution: &str) -> Analysis {
    analysis(&six_masses("0.002", &format!("restitution = {restitution}\n")))
}

#[test]
fn what_is_lost_to_a_millionth_is_said() {
    let wild = analysis_of_one("1.0");
    let told = wild.warnings.iter().find(|warning| warning.subject == Subject::Contact).unwrap();
    assert!(told.text.contains("good in its rms and its extremes only"), "{}", told.text);
    let contacts = wild.cases[1].contacts.as_ref().unwrap();
    assert!(contacts.holds_until.unwrap() < contacts.until && contacts.holds_until > contacts.first);
}

#[test]
fn a_blow_on_a_seat_reaches_the_sensors_that_are_slower_than_it() {
    let slow =
        "\n[[sensor]]\nname = \"slow cell\"\nkind = \"load-cell\"\nend = 2\nrange = \"1 kN\"\nbandwidth = \"2 kHz\"\n";
    let fast = "\n[[sensor]]\nname = \"perfect cell\"\nkind = \"load-cell\"\nend = 2\nrange = \"1 kN\"\n";
    let keys = "restitution = 0.0\nlift_off = false\n";
    let sensors = VALVE.find("[[sensor]]").unwrap()..VALVE.find("[goal]").unwrap();
    let text = six_masses("0.002", keys);
    let text = text.replace(&VALVE[sensors], &format!("{slow}{fast}\n"));
    let each = cases(&text);
    let running = &each[1];
    let contacts = running.contacts.as_ref().unwrap();
    let impulses: f64 = contacts.seat_impulses(Between::Seat2).map(|(_, impulse)| impulse).sum();
    assert!(impulses > 0.0);
    let force = running.signals.channel(Channel::OutputForce).unwrap();
    let step = running.signals.time()[1];
    let momentum = |sensor: usize| {
        let readings = &running.readings[sensor].steady;
        readings.iter().zip(force).map(|(reading, force)| (reading - force) * step).sum::<f64>()
    };
    // Seats push, and push is negative; a slow cell has all of it, one that has no limit none.
    close(momentum(0), -impulses, 0.05);
    assert!(momentum(1).abs() < 1e-9, "{}", momentum(1));
}

#[test]
fn a_follower_floats_where_its_cam_would_have_to_pull() {
    let with = |mass: &str| {
        six_masses("0.01", "restitution = 0.0")
            .replace("end2 = \"held\"", &format!("end2 = \"held\"\nfollower_mass = \"{mass}\""))
    };
    let light = cases(&with("40 g"));
    let contacts = light[0].contacts.as_ref().unwrap();
    assert!(contacts.floats.is_empty(), "{:?}", contacts.floats);
    let heavy = analysis(&with("250 g"));
    let contacts = heavy.cases[0].contacts.as_ref().unwrap();
    assert!(!contacts.floats.is_empty() && contacts.floats.iter().all(|float| float.closing_speed >= 2e-3));
    assert!(contacts.floated() > 1e-3);
    let words = answer(&heavy).join("\n");
    assert!(words.contains("where the follower leaves its cam"), "{words}");
    let told = heavy.warnings.iter().find(|warning| warning.subject == Subject::Contact).unwrap();
    assert!(told.text.contains("the follower leaves its cam"), "{}", told.text);
    // The end of the spring goes with the follower, and lies ahead of the cam while that flies.
    let (u1, time) = (heavy.cases[0].signals.channel(Channel::U1).unwrap(), heavy.cases[0].signals.time());
    let cam = light[0].signals.channel(Channel::U1).unwrap();
    let float = contacts.floats[0];
    for sample in
        time.partition_point(|time| *time <= float.time)..time.partition_point(|time| *time < float.back.unwrap())
    {
        assert!(u1[sample] > cam[sample] - 1e-7, "{}", time[sample]);
    }
}

#[test]
fn what_cannot_meet_is_refused_in_a_line() {
    let helix = VALVE.replace("[spring]\n", "[spring]\nmodel = \"helix\"\n");
    let with = |keys: &str| format!("{VALVE}\n[contact]\n{keys}\n");
    for (text, part) in [
        (with("restitution = 1.5"), "restitution = 1.5: must be from 0 to 1"),
        (with("restitution = -0.1"), "restitution = -0.1: must be from 0 to 1"),
        (with("restitution = [0.5, 0.5]"), "0.5 is there twice"),
        (with("windings = \"soft\""), "must be"),
        (
            with("windings = \"off\"\nrestitution = 0.0"),
            "restitution in [contact] is no key of windings that are \"off\"",
        ),
        (with("stiffness = \"Hertz\""), "stiffness in [contact] is no key of windings that are \"hard\""),
        (with("windings = \"elastic\"\nstiffness = \"1 kN/m\""), "ten times a winding's own"),
        (with("windings = \"elastic\"\nstiffness = \"hertz\""), "stiffness = \"hertz\": must be"),
        (
            VALVE.replace("end2 = \"held\"", "end2 = \"held\"\nfollower_mass = \"80 g\""),
            "takes a table [contact]: without it no end leaves what it stands on",
        ),
        (
            with("windings = \"elastic\"").replace("end2 = \"held\"", "end2 = \"held\"\nfollower_mass = \"80 g\""),
            "take hard ones",
        ),
        (format!("{helix}\n[contact]\n"), "the modes of a \"helix\" know no contact"),
        (
            format!("{}\n[contact]\nends = true\n", SUSPENSION.replace("masses_per_winding = 1\n", "")),
            "takes [spring] masses_per_winding = 1",
        ),
    ] {
        let message = read(&text).map(|_| ()).expect_err(part);
        assert!(message.contains(part) && message.lines().count() == 1, "{message}");
    }
    let spec = read(&with("")).unwrap();
    let refused = spec.needs_no_contact("placement").unwrap_err().to_string();
    assert!(refused.contains("placement takes windings = \"off\""), "{refused}");
    read(&with("windings = \"off\"")).unwrap().needs_no_contact("placement").unwrap();
}

#[test]
fn a_spring_that_is_pressed_solid_says_when() {
    // 19 mm of lift from 48 mm: past its solid length of 31 mm.
    let text = six_masses("0.01", "restitution = 0.0");
    let files = |_: &str| Ok(CAM.replace("u1 [mm]", "u1 [cm]").lines().map(shrunk).collect::<Vec<_>>().join("\n"));
    let spec = Spec::parse("valve.toml", &text, &files).unwrap();
    let Err(AnalysisError::Case { place, reason }) = simulate(&spec, &|_, _| true).map(|_| ()) else {
        panic!("a spring shorter than solid was moved")
    };
    assert!(place.starts_with("valve.toml: "), "{place}");
    assert!(reason.to_string().contains("all windings lie on one another"), "{reason}");
}

/// A row of the cam with 1.9 times its lift in centimetres.
fn shrunk(row: &str) -> String {
    match row.split_once(',').map(|(time, lift)| (time, lift.parse::<f64>())) {
        Some((time, Ok(lift))) => format!("{time},{}", 0.19 * lift),
        _ => row.to_owned(),
    }
}
