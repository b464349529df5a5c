//! Logs of every format with bytes that are wrong, through the command as people run it: within 60 s and 2 GB each is read or refused in one
//! line, and what differs from the log as it was is told, or is the value of a row whose own bytes were changed.
//!
//! Next door: the readers themselves (`coilsense-lab/tests/recording`), fuzzers (`fuzz/`), files that are written (`disk`).
#![cfg(unix)]

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread::{available_parallelism, scope, sleep};
use std::time::{Duration, Instant};

/// What a process may take.
const LONGEST: Duration = Duration::from_secs(60);
const MOST_MEMORY_KB: u64 = 2_000_000;
/// Bytes of the longest stretch that is cut out, copied or zeroed.
const STRETCH: u64 = 64;
/// What is repaired on the way, so that damage goes as far as it can.
const REPAIRS: [&str; 5] = ["--drop-incomplete", "--sort", "--merge-repeated", "--repair-up-to", "100 %"];

/// How far a wrong byte goes in a format.
#[derive(Clone, Copy, PartialEq)]
enum Check {
    /// Its bytes are summed up: none passes.
    Summed,
    /// It is in one line of text, or parts or joins two.
    Lines,
    /// As far as the format has it.
    Any,
}

/// A log as it was written.
struct Log {
    name: String,
    bytes: Vec<u8>,
    columns: Vec<&'static str>,
    check: Check,
}

/// Columns that the formats without units want told.
fn columns(name: &str) -> Vec<&'static str> {
    match name {
        "motion-struct.mat" => vec!["time=run.time [s]", "F_o=run.F_o [N]", "L=L [H]"],
        "motion-v73.mat" => vec!["time=time [s]", "F_o=F_o [N]"],
        "motion-rows.h5" => vec!["time=log/time [s]", "F_o=log/F_o [N]"],
        _ if name.ends_with(".mat") => vec!["time=time [s]", "F_o=F_o [N]", "L=L [H]"],
        _ => Vec::new(),
    }
}

/// Every reference log, and its text in the dialects and packings that no file of them has.
fn logs() -> Vec<Log> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../coilsense-lab/tests/golden/logs");
    let mut files: Vec<PathBuf> =
        fs::read_dir(&folder).expect("the reference logs").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    let named = |path: PathBuf| {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let check = match path.extension().and_then(|ending| ending.to_str()) {
            Some("xlsx" | "ods") => Check::Summed,
            Some("csv") => Check::Lines,
            _ => Check::Any,
        };
        Log { columns: columns(&name), bytes: fs::read(&path).expect("a reference log"), name, check }
    };
    let mut logs: Vec<Log> = files.into_iter().map(named).collect();
    let text = fs::read_to_string(folder.join("motion.csv")).expect("the text");
    let mut more = |name: &str, bytes: Vec<u8>, check: Check| {
        logs.push(Log { name: name.to_owned(), bytes, columns: Vec::new(), check });
    };
    more("commas.csv", text.replace(',', ";").replace('.', ",").into_bytes(), Check::Lines);
    more("tabs.txt", text.replace(',', "\t").into_bytes(), Check::Lines);
    let wide: Vec<u8> = std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    more("wide.csv", wide, Check::Any);
    let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    gzip.write_all(text.as_bytes()).expect("in memory");
    more("motion.csv.gz", gzip.finish().expect("in memory"), Check::Summed);
    let mut zstd = zstd::Encoder::new(Vec::new(), 3).expect("in memory");
    zstd.include_checksum(true).expect("a checksum");
    zstd.write_all(text.as_bytes()).expect("in memory");
    more("motion.csv.zst", zstd.finish().expect("in memory"), Check::Summed);
    logs
}

/// Numbers by a seed (`SplitMix64`).
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) % end.max(1)
    }
}

/// Something that happens to files on their way, and whether it is one byte only.
fn mutated(good: &[u8], random: &mut Random) -> (Vec<u8>, bool) {
    let (mut bytes, size) = (good.to_vec(), good.len() as u64);
    let at = random.below(size) as usize;
    let end = (at + 1 + random.below(STRETCH) as usize).min(bytes.len());
    match random.below(8) {
        0 | 1 => bytes[at] ^= 1 << random.below(8),
        2 => bytes[at] = random.below(256) as u8,
        3 => bytes.truncate(at),
        4 => drop(bytes.drain(at..end)),
        5 => bytes[at..end].fill(0),
        6 => {
            let copied = bytes[at..end].to_vec();
            let to = random.below(size) as usize;
            bytes.splice(to..to, copied);
        }
        _ => (0..8).for_each(|_| bytes[random.below(size) as usize] = random.below(256) as u8),
    }
    let same_length = bytes.len() == good.len();
    let single = same_length && bytes.iter().zip(good).filter(|(new, old)| new != old).count() <= 1;
    (bytes, single)
}

/// What a command said.
struct Said {
    status: ExitStatus,
    output: String,
    errors: String,
}

/// Runs the command with as much memory and time as it may take.
fn run(place: &Path, arguments: &[String]) -> Said {
    let (out, err) = (place.join("stdout"), place.join("stderr"));
    let mut command = Command::new("sh");
    command.args(["-c", &format!("ulimit -v {MOST_MEMORY_KB}; exec \"$0\" \"$@\""), env!("CARGO_BIN_EXE_coilsense")]);
    command.args(arguments).current_dir(place);
    command.stdout(File::create(&out).expect("a file")).stderr(File::create(&err).expect("a file"));
    let begun = Instant::now();
    let mut child = command.spawn().expect("it starts");
    let status = loop {
        if let Some(status) = child.try_wait().expect("a child") {
            break status;
        }
        if begun.elapsed() > LONGEST {
            child.kill().expect("a child");
            panic!("{arguments:?} is still at work after {LONGEST:?}");
        }
        sleep(Duration::from_millis(1));
    };
    let read = |path| String::from_utf8(fs::read(path).expect("a file")).expect("UTF-8");
    Said { status, output: read(&out), errors: read(&err) }
}

/// One way to use a log: 0 an overview for programs, 1 import with every repair, 2 identification.
fn arguments(log: &Log, way: u64) -> Vec<String> {
    let given: &[&str] = match way {
        0 => &["import", &log.name, "--json"],
        1 => &["import", &log.name, "--out", "out.csv", "--overwrite"],
        _ => &["identify", &log.name, "--json"],
    };
    let repairs: &[&str] = if way == 1 { &REPAIRS } else { &[] };
    let columns = log.columns.iter().flat_map(|column| ["--column", column]);
    given.iter().chain(repairs).copied().chain(columns).map(str::to_owned).collect()
}

/// What an import said of its log and wrote.
fn imported(place: &Path, log: &Log, bytes: &[u8]) -> Option<(String, String)> {
    fs::write(place.join(&log.name), bytes).expect("written");
    let said = run(place, &arguments(log, 1));
    said.status.success().then(|| (said.output, fs::read_to_string(place.join("out.csv")).expect("what was written")))
}

/// Uses a log with wrong bytes, and complains of what must not be; whether it was read.
fn survives(place: &Path, log: &Log, good: Option<&(String, String)>, seed: u64) -> bool {
    let mut random = Random(seed);
    let (bytes, single) = mutated(&log.bytes, &mut random);
    let way = random.below(3);
    fs::write(place.join(&log.name), &bytes).expect("written");
    let said = run(place, &arguments(log, way));
    let told = || format!("{} with seed {seed}, way {way}: {:?}\n{}", log.name, said.status, said.errors);
    if !said.status.success() {
        assert_eq!(said.status.code(), Some(2), "{}", told());
        let one_line = said.errors.lines().count() == 1 && said.errors.starts_with("error: ");
        assert!(one_line && said.errors.contains(&log.name), "{}", told());
        return false;
    }
    if way != 1 {
        assert!(serde_json::from_str::<serde_json::Value>(&said.output).is_ok(), "{}", told());
        return true;
    }
    let new = fs::read_to_string(place.join("out.csv")).expect("what was written");
    let Some((account, rows)) = good else { return true };
    if said.output != *account || log.check == Check::Any || new == *rows {
        return true;
    }
    // Nothing is said that was not said of the log as it was.
    assert!(log.check == Check::Lines, "{}: a wrong byte passed its checksum", told());
    let (old, new): (Vec<&str>, Vec<&str>) = (rows.lines().collect(), new.lines().collect());
    let other = old.iter().zip(&new).filter(|(old, new)| old != new).count();
    assert!(!single || (old.len() == new.len() && other <= 1), "{}: {other} rows changed", told());
    true
}

/// So many logs with wrong bytes, spread over all formats.
fn damaged(count: u64) {
    let (logs, next, read) = (logs(), AtomicU64::new(0), AtomicU64::new(0));
    let begun = Instant::now();
    scope(|threads| {
        for _ in 0..available_parallelism().map_or(2, usize::from) {
            threads.spawn(|| {
                let place = tempfile::tempdir().expect("a temporary folder");
                let good: Vec<_> = logs.iter().map(|log| imported(place.path(), log, &log.bytes)).collect();
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed >= count {
                        break;
                    }
                    let which = (seed % logs.len() as u64) as usize;
                    let was_read = survives(place.path(), &logs[which], good[which].as_ref(), seed);
                    read.fetch_add(u64::from(was_read), Ordering::Relaxed);
                    fs::remove_file(place.path().join(&logs[which].name)).expect("the log");
                }
            });
        }
    });
    let (read, formats) = (read.into_inner(), logs.len());
    println!(
        "{count} damaged logs of {formats} kinds in {:.0} s: {read} read, {} refused",
        begun.elapsed().as_secs_f64(),
        count - read
    );
    // Neither does damage go unseen everywhere, nor is every log refused.
    assert!(read > count / 10 && read < count - count / 10, "{read} of {count}");
}

#[test]
fn some_hundred_damaged_logs_are_read_or_refused() {
    damaged(350);
}

#[test]
#[ignore = "takes minutes"]
fn twelve_thousand_damaged_logs_are_read_or_refused() {
    damaged(12_000);
}
