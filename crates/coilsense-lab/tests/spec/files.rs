//! Specs on disk: what cannot be read at all.

use std::fs;
use std::path::Path;

use coilsense_lab::spec::Spec;

use super::fixtures::{BY_GEOMETRY, BY_VALUES};

fn refusal(path: &Path) -> String {
    let message = Spec::read(path).expect_err("a refusal").to_string();
    assert!(!message.contains('\n'), "more than one line: {message}");
    message
}

#[test]
fn what_is_no_text_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let file = |name: &str, bytes: &[u8]| {
        let path = place.path().join(name);
        fs::write(&path, bytes).unwrap();
        path
    };
    let latin = file("latin.toml", b"[spring]\nname = \"Gr\xf6\xdfe\"\n");
    let empty = file("empty.toml", b"");
    let huge = file("huge.toml", &vec![b'#'; (1 << 20) + 1]);
    for (path, what) in [
        (latin, ": cannot be read: stream did not contain valid UTF-8"),
        (empty, ": the table [spring] is missing"),
        (huge, ": cannot be read: it is larger than 1 MiB"),
        (place.path().to_owned(), ": cannot be read: Is a directory (os error 21)"),
        (place.path().join("none.toml"), ": cannot be read: No such file or directory (os error 2)"),
        ("/dev/zero".into(), ": cannot be read: it is larger than 1 MiB"),
    ] {
        assert_eq!(refusal(&path), format!("{}{what}", path.display()));
    }
}

#[test]
fn windows_line_ends_and_a_byte_order_mark_are_read() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("spec.toml");
    fs::write(&path, format!("\u{feff}{}", BY_VALUES.replace('\n', "\r\n"))).unwrap();
    assert_eq!(Spec::read(&path).unwrap().spring.name, "S_T");
    let wrong = BY_VALUES.replace("65 g", "65 mm").replace('\n', "\r\n");
    fs::write(&path, wrong).unwrap();
    let expected = format!("{}:7: mass = \"65 mm\": must be a mass with its unit (kg, g, mg, lb, oz)", path.display());
    assert_eq!(refusal(&path), expected);
}

#[test]
fn a_recording_is_looked_for_beside_the_spec() {
    let place = tempfile::tempdir().unwrap();
    let (spec, road) = (place.path().join("spec.toml"), place.path().join("road.csv"));
    fs::write(&spec, BY_GEOMETRY.replace("duration = \"0.3 s\"\n", "")).unwrap();
    let expected = format!(
        "{}:18: file = \"road.csv\": {} cannot be read: No such file or directory (os error 2)",
        spec.display(),
        road.display()
    );
    assert_eq!(refusal(&spec), expected);
    fs::write(&road, "\u{feff}# measured by hand\r\ntime [ms], u1 [mm], F_2 [kN]\r\n0,0,0\r\n250,1.5,-0.1\r\n")
        .unwrap();
    let read = Spec::read(&spec).unwrap();
    assert_eq!(read.conditions[0].duration, 0.25);
    fs::write(&road, b"time [s],u1 [mm]\n0,\xff\n").unwrap();
    assert!(refusal(&spec).ends_with("road.csv cannot be read: stream did not contain valid UTF-8"));
}

#[test]
fn a_recording_is_played_faster_in_less_time_with_the_same_turns_judged() {
    let of = |keys: &str| {
        let recorded = format!("kind = \"recorded\"\nfile = \"holds time [s],u1 [mm];0,0;0.1,2;0.3,0\"\n{keys}");
        let text = BY_VALUES.replace("kind = \"harmonic\"\nfrequency = \"0.5 f1\"\namplitude = \"1 %\"", &recorded);
        let spec = super::fixtures::read(&text).unwrap();
        spec.conditions.into_iter().find(|condition| condition.kind == "recorded").unwrap()
    };
    let motion = |condition: &coilsense_lab::spec::ConditionSpec| match condition.excitation.input(coilsense::End::One)
    {
        coilsense::EndInput::Sampled(sampled) => (sampled.times().to_vec(), sampled.values().to_vec()),
        other => panic!("{other:?}"),
    };
    let plain = of("");
    assert_eq!((plain.duration, plain.window), (0.3, (0.0, 0.3)));
    assert_eq!(of("playback_speed = \"100 %\"\n").excitation, plain.excitation);
    // 0.3 / 1.2 × 1.2 is less than 0.3: the window ends with the file at every speed.
    let fast = of("playback_speed = \"120 %\"\nwindow = [\"0.1 s\", \"0.3 s\"]\n");
    assert_eq!((fast.duration, fast.window), (0.3 / 1.2, (0.1 / 1.2, 0.3 / 1.2)));
    assert_eq!(motion(&fast), (vec![0.0, 0.1 / 1.2, 0.3 / 1.2], vec![0.0, 0.002, 0.0]));
    assert_eq!(fast.remarks, ["played at 120 % of the file's speed"]);
    // Slower, and for a part of the file's own time.
    let slow = of("playback_speed = \"50 %\"\nduration = \"0.2 s\"\n");
    assert_eq!((slow.duration, slow.window), (0.4, (0.0, 0.4)));
}

#[test]
fn ends_that_move_together_or_apart_do_not_meet() {
    let moved = |keys: &str| {
        let text = BY_VALUES.replace("kind = \"harmonic\"\nfrequency = \"0.5 f1\"\namplitude = \"1 %\"", keys);
        super::fixtures::read(&text)
    };
    // Both ends go the same way; end 1 moves away from end 2; end 2 away from end 1.
    moved("kind = \"recorded\"\nfile = \"holds time [s],u1 [m],u2 [m];0,0,0;1,1,1.01\"").unwrap();
    moved("kind = \"step\"\namplitude = \"-300 mm\"").unwrap();
    moved("kind = \"step\"\nend = 2\namplitude = \"300 mm\"").unwrap();
    let message = moved("kind = \"step\"\nend = 2\namplitude = \"-300 mm\"").unwrap_err();
    assert!(message.contains("the ends meet"), "{message}");
    let message = moved("kind = \"recorded\"\nfile = \"holds time [s],u1 [m],u2 [m];0,0,0;1,1,0.7\"").unwrap_err();
    assert!(message.contains("leaves -70.000 mm"), "{message}");
}
