//! `coilsense record`: what is missing in a folder of logs is said, and only what is whole is packed, byte for byte.

mod running;

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use running::coilsense;
use tempfile::TempDir;

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Logs of the virtual rig that do not say so: the only ones that can stand for a real spring's here.
fn logs() -> TempDir {
    let place = tempfile::tempdir().unwrap();
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    fs::copy(examples.join("virtual-rig.toml"), place.path().join("spring.toml")).unwrap();
    let rig = coilsense(place.path(), &["rig", "spring.toml", "--out", "rig"]);
    assert!(rig.status.success(), "{}", text(&rig.stderr));
    for (from, to) in [("hit-1", "hits-1"), ("hit-2", "hits-2"), ("harmonic-01", "stretch")] {
        let log = fs::read_to_string(place.path().join(format!("rig/{from}-fast.csv"))).unwrap();
        let measured: Vec<&str> = log.lines().filter(|line| !line.starts_with('#')).collect();
        fs::write(place.path().join(format!("{to}.csv")), measured.join("\n") + "\n").unwrap();
    }
    place
}

const WHOLE: &str = r#"
[who]
name = "A. Person, Somewhere"
date = "2026-11-28"
licence = "CC-BY-4.0"
[spring]
spec = "spring.toml"
described = "EN 10270-1, hooks"
mount = "vice, 30 kg"
[[instrument]]
channel = "F_o"
is = "load cell"
range = "±200 N"
filter = "none"
[[log]]
file = "hits-1.csv"
kind = "hits"
length = "230 mm"
[[log]]
file = "hits-2.csv"
kind = "hits"
length = "260 mm"
[[log]]
file = "stretch.csv"
kind = "stretch"
"#;

/// What is said of a record, and the exit code.
fn said(place: &Path, file: &str, more: &[&str]) -> (String, String, Option<i32>) {
    fs::write(place.join("record.toml"), file).unwrap();
    let output = coilsense(place, &[&["record", "."], more].concat());
    (text(&output.stdout), text(&output.stderr), output.status.code())
}

#[test]
fn a_template_is_written_once_and_asks_for_all_that_it_leaves_empty() {
    let place = tempfile::tempdir().unwrap();
    let none = coilsense(place.path(), &["record", "."]);
    assert_eq!(none.status.code(), Some(2));
    assert!(
        text(&none.stderr).contains("record.toml is not there; write one to fill in with: coilsense record . --begin")
    );
    let begun = coilsense(place.path(), &["record", "mine", "--begin"]);
    assert!(begun.status.success(), "{}", text(&begun.stderr));
    let again = coilsense(place.path(), &["record", "mine", "--begin"]);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("record.toml is there already"));
    let output = coilsense(place.path(), &["record", "mine"]);
    let told = text(&output.stdout);
    assert!(output.status.success() && told.starts_with("The record cannot be sent yet: "), "{told}");
    for asked in [
        "missing   who.name: say who",
        "missing   who.date",
        "missing   who.licence: must be \"CC-BY-4.0\" or \"check only\", got \"\"",
        "missing   spring.described",
        "missing   spring.mount",
        "missing   spring.spec",
        "missing   hits-1.csv",
        "doubtful  instrument of F_o: fill in is and range and filter",
        "doubtful  silence",
        "doubtful  table",
    ] {
        assert!(told.contains(asked), "{asked}:\n{told}");
    }
    assert_eq!(coilsense(place.path(), &["record", "mine", "--check"]).status.code(), Some(3));
    let packed = coilsense(place.path(), &["record", "mine", "--out", "mine.zip"]);
    assert_eq!(packed.status.code(), Some(2));
    assert!(text(&packed.stderr).contains("mine.zip was not written: the record is not whole"));
    assert!(!place.path().join("mine.zip").exists());
    let other = coilsense(place.path(), &["record", "mine", "--out", "mine.tar"]);
    assert_eq!((other.status.code(), text(&other.stderr).as_str()), (Some(2), "error: mine.tar: must end in .zip\n"));
}

#[test]
fn a_whole_record_is_packed_byte_for_byte_with_its_digests() {
    let place = logs();
    let (told, error, code) = said(place.path(), WHOLE, &["--out", "mine.zip"]);
    assert_eq!(code, Some(0), "{told}{error}");
    assert!(told.contains("hits at 230 to 260 mm") && told.contains("f1 should be near 54"), "{told}");
    assert!(told.contains("doubtful  table: no [[log]] of this kind") && told.contains("wrote mine.zip"), "{told}");
    let mut archive = zip::ZipArchive::new(fs::File::open(place.path().join("mine.zip")).unwrap()).unwrap();
    let names: Vec<String> = archive.file_names().map(|name| name.unwrap().into_owned()).collect();
    let wanted = ["record.toml", "spring.toml", "hits-1.csv", "hits-2.csv", "stretch.csv", "check.json", "SHA256SUMS"];
    assert_eq!(names.len(), wanted.len(), "{names:?}");
    let unpacked: PathBuf = place.path().join("unpacked");
    fs::create_dir(&unpacked).unwrap();
    for name in wanted {
        let mut bytes = Vec::new();
        archive.by_name(name).unwrap().read_to_end(&mut bytes).unwrap();
        if name.ends_with(".csv") || name.ends_with(".toml") {
            assert!(bytes == fs::read(place.path().join(name)).unwrap(), "{name}");
        }
        fs::write(unpacked.join(name), bytes).unwrap();
    }
    let sums = std::process::Command::new("sha256sum")
        .args(["--check", "--quiet", "SHA256SUMS"])
        .current_dir(&unpacked)
        .output();
    // Where there is such a command.
    assert!(sums.is_ok_and(|sums| sums.status.success()) || cfg!(not(target_os = "linux")));
    fs::write(place.path().join("theirs.zip"), "somebody's own").unwrap();
    assert_eq!(said(place.path(), WHOLE, &["--out", "theirs.zip"]).2, Some(2), "it is there");
    assert_eq!(fs::read_to_string(place.path().join("theirs.zip")).unwrap(), "somebody's own");
    let (json, ..) = said(place.path(), WHOLE, &["--json"]);
    assert!(json.contains("\"whole\": true") && json.contains("\"state\": \"doubtful\""), "{json}");
}

#[test]
fn what_cannot_be_sent_is_refused_with_the_reason() {
    let place = logs();
    let simulated = fs::read_to_string(place.path().join("rig/hit-1-fast.csv")).unwrap();
    fs::write(place.path().join("simulated.csv"), simulated).unwrap();
    let slow: Vec<String> = fs::read_to_string(place.path().join("hits-1.csv"))
        .unwrap()
        .lines()
        .enumerate()
        .filter(|(row, _)| *row == 0 || row % 10 == 1)
        .map(|(_, line)| line.to_owned())
        .collect();
    fs::write(place.path().join("slow.csv"), slow.join("\n") + "\n").unwrap();
    let outside = place.path().join("../outside.csv");
    for (before, after, reason) in [
        ("file = \"hits-1.csv\"", "file = \"simulated.csv\"", "simulated.csv: is simulated ("),
        (
            "file = \"hits-1.csv\"",
            "file = \"slow.csv\"",
            "slow.csv: is sampled at 250 Hz; 1081 Hz or more show the modes above f1",
        ),
        ("file = \"hits-1.csv\"", "file = \"../outside.csv\"", "\"../outside.csv\" must be a file of this folder"),
        ("file = \"hits-1.csv\"", "file = \"/etc/hostname\"", "\"/etc/hostname\" must be a file of this folder"),
        ("file = \"hits-1.csv\"", "file = \"gone.csv\"", "gone.csv is not there"),
        (
            "file = \"stretch.csv\"\nkind = \"stretch\"",
            "file = \"spring.toml\"\nkind = \"hits\"",
            "missing   spring.toml",
        ),
        ("file = \"hits-2.csv\"", "file = \"hits-1.csv\"", "hits-1.csv: is listed twice"),
        ("licence = \"CC-BY-4.0\"", "licence = \"MIT\"", "got \"MIT\""),
        ("length = \"230 mm\"", "length = \"230\"", "length = \"230\" must be a length with its unit"),
    ] {
        assert!(WHOLE.contains(before), "{before}");
        let (told, error, code) = said(place.path(), &WHOLE.replacen(before, after, 1), &["--out", "bad.zip"]);
        assert!(told.contains(reason), "{after}: {told}{error}");
        assert_eq!(code, Some(2), "{after}");
        assert!(!place.path().join("bad.zip").exists(), "{after}");
    }
    assert!(!outside.exists());
    // One line with the place, for what is no record.toml at all.
    for (before, after, reason) in [
        ("name =", "nam =", "record.toml:3: unknown field `nam`"),
        ("kind = \"hits\"", "kind = \"hit\"", "record.toml:17: unknown variant `hit`"),
        ("[who]", "[who", "record.toml:2: "),
    ] {
        let (_, error, code) = said(place.path(), &WHOLE.replacen(before, after, 1), &[]);
        assert!(error.contains(reason) && error.lines().count() == 1, "{error}");
        assert_eq!(code, Some(2));
    }
}

#[test]
fn what_is_worth_less_is_doubtful_and_may_be_sent() {
    let place = logs();
    for (before, after, doubt) in [
        ("length = \"260 mm\"", "length = \"231 mm\"", "all hits are at 230 mm"),
        ("channel = \"F_o\"", "channel = \"F_i\"", "hits-1.csv, F_o: say with which instrument"),
        ("filter = \"none\"", "filter = \"\"", "instrument of F_o: fill in filter"),
        ("kind = \"stretch\"", "kind = \"silence\"", "doubtful  stretch: no [[log]]"),
    ] {
        let (told, _, code) = said(place.path(), &WHOLE.replacen(before, after, 1), &["--check"]);
        assert!(told.contains(doubt), "{after}: {told}");
        assert_eq!(code, Some(3), "{after}");
        assert!(told.starts_with("The record may be sent; "), "{told}");
    }
}
