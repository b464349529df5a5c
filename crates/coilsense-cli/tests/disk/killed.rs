//! Runs that are killed at any time: what is on disk is what was there or what came, whole, and the next run leaves nothing of them.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::{Duration, Instant};

use super::Place;

/// Many files that come together, their contents by the speed of the hits.
fn spec(speed: &str) -> String {
    let (spring, condition) = super::SPEC.split_once("[[condition]]").expect("a condition");
    let hit = |number: usize| {
        let named = condition.replace("\"strike\"", &format!("\"strike {number}\""));
        format!("[[condition]]{}", named.replace("0.25 m/s", speed).replace("10 ms", "60 ms"))
    };
    spring.to_owned() + &(0..12).map(hit).collect::<String>()
}

/// What `out` holds, but for what is hidden.
fn whole(place: &Place) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = super::files(&place.path("out"));
    files
        .retain(|file, _| !file.components().any(|part| part.as_os_str().to_string_lossy().starts_with(".coilsense-")));
    files
}

fn left(place: &Place) -> Vec<PathBuf> {
    let entries = ["", "out"].map(|folder| fs::read_dir(place.path(folder)).expect("a folder"));
    let paths = entries.into_iter().flatten().map(|entry| entry.expect("an entry").path());
    paths
        .filter(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(".coilsense-")))
        .collect()
}

const RUN: [&str; 2] = ["simulate slow.toml --out out/run.csv", "simulate fast.toml --out out/run.csv"];

fn kill(times: u32) {
    let place = Place::new();
    for (name, speed) in [("slow.toml", "0.1 m/s"), ("fast.toml", "0.2 m/s")] {
        fs::write(place.path(name), spec(speed)).unwrap();
    }
    let begun = Instant::now();
    place.done(RUN[0]);
    let takes = begun.elapsed();
    let slow = whole(&place);
    place.done(RUN[1]);
    let fast = whole(&place);
    assert!(slow.len() == 12 && slow.keys().eq(fast.keys()) && slow.values().zip(fast.values()).all(|(a, b)| a != b));
    // Of these nobody but their owner may make anything; a run that would is refused after it has cleared up.
    fs::write(place.path("out/mine.csv"), "mine").unwrap();
    let clear_up = || place.refusal("simulate slow.toml --one-file --out out/mine.csv");
    let mut state = 1_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1_u64 << 31) as f64
    };
    let mut ends = BTreeMap::new();
    for number in 0..times {
        let run = RUN[number as usize % 2];
        let mut child =
            place.command(run).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the command starts");
        std::thread::sleep(takes.mul_f64(1.1 * random()) + Duration::from_millis(1));
        let signal = if number % 4 < 2 { "-KILL" } else { "-TERM" };
        let id = child.id().to_string();
        let _ = std::process::Command::new("kill").args([signal, &id]).stderr(Stdio::null()).status();
        let status = child.wait().expect("a child");
        let mut now = whole(&place);
        assert_eq!(now.remove(&place.path("out/mine.csv")).as_deref(), Some(b"mine".as_slice()));
        for (file, bytes) in &now {
            let is_whole = slow[file] == *bytes || fast[file] == *bytes;
            assert!(is_whole, "{number}: {} is torn", file.display());
        }
        assert!(now.keys().eq(slow.keys()), "{number}: a file is missing");
        if signal == "-TERM" {
            assert_eq!(left(&place), [] as [PathBuf; 0], "{number}: TERM cleans up by itself");
            assert!(status.success() || status.code() == Some(143) || status.code().is_none(), "{status}");
        }
        clear_up();
        let mut now = whole(&place);
        now.remove(&place.path("out/mine.csv"));
        assert!(now == slow || now == fast, "{number}: old and new are mixed");
        assert_eq!(left(&place), [] as [PathBuf; 0], "{number}");
        *ends.entry(status.success()).or_insert(0) += 1;
    }
    assert!(ends.get(&false).is_some_and(|killed| killed * 4 > times), "{ends:?}");
}

#[test]
fn forty_kills_leave_old_or_new() {
    kill(40);
}

#[test]
#[ignore = "takes a minute; `cargo xtask test --only long` runs it"]
fn a_hundred_and_twenty_kills_leave_old_or_new() {
    kill(120);
}
