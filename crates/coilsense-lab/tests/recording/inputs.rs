//! What a log is read from: plain files, pipes, compressed files, other encodings. Whatever it is, the rows are the same, and none is lost in silence.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping, Recording, Table};

use super::fixtures::{mapping, read_with};

/// A log of so many rows, of 0.1 ms each.
fn log(rows: usize) -> String {
    let rows = (0..rows).map(|row| format!("{},{}\n", row as f64 * 1e-4, (row as f64 * 0.37).sin()));
    std::iter::once("time [s],F_o [N]\n".to_owned()).chain(rows).collect()
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    packed.write_all(bytes).unwrap();
    packed.finish().unwrap()
}

fn zstd(bytes: &[u8]) -> Vec<u8> {
    zstd::encode_all(bytes, 3).unwrap()
}

fn read(bytes: impl AsRef<[u8]>) -> Result<Recording, String> {
    read_with(bytes, &Mapping::default(), &Cleaning::default())
}

fn golden(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/logs").join(name)
}

/// Packs bytes.
type Pack = fn(&[u8]) -> Vec<u8>;

/// Compressors, with the word for each; those that this build has.
fn packers() -> Vec<(&'static str, Pack)> {
    let all: [(bool, &str, Pack); 2] = [(cfg!(feature = "gzip"), "gzip", gzip), (cfg!(feature = "zstd"), "zstd", zstd)];
    all.into_iter().filter(|(there, ..)| *there).map(|(_, name, packer)| (name, packer)).collect()
}

#[test]
fn a_compressed_log_is_the_log() {
    let text = log(20_000);
    let plain = read(&text).unwrap();
    for (name, packer) in packers() {
        let packed = packer(text.as_bytes());
        let (first, second) = text.as_bytes().split_at(123_456);
        // As several members or frames, too: `cat a.gz b.gz`, bgzip, pzstd.
        for bytes in [packed, [packer(first), packer(second), packer(b"")].concat()] {
            let found = read(bytes).unwrap();
            assert_eq!(found.signals(), plain.signals(), "{name}");
            let told = format!("text, columns separated by \",\", header in line 1, compressed by {name}");
            assert_eq!(found.account().description, told);
        }
    }
}

#[test]
fn a_compressed_log_that_is_cut_off_anywhere_gives_no_rows() {
    let text = log(3000);
    for (name, packer) in packers() {
        let packed = packer(text.as_bytes());
        let lengths = (6..packed.len()).step_by(packed.len() / 40).chain(packed.len() - 12..packed.len());
        for length in lengths {
            let kept = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
            let message = read_with(&packed[..length], &Mapping::default(), &kept).unwrap_err();
            let end = format!(": is cut off: its {name} data break off before their end");
            assert!(message.starts_with("run.csv:") && message.ends_with(&end), "{length} bytes: {message}");
        }
    }
}

#[test]
fn what_is_damaged_inside_is_said_and_what_is_no_log_too() {
    for (name, packer) in packers() {
        let good = packer(log(3000).as_bytes());
        let mut damaged = good.clone();
        let middle = damaged.len() / 2;
        damaged[middle..middle + 40].fill(0xaa);
        let message = read(&damaged).unwrap_err();
        assert!(message.contains(&format!("is damaged: its {name} data cannot be unpacked (")), "{message}");
        assert_eq!(message.lines().count(), 1);
        let garbage: Vec<u8> = (0..4000_u32).map(|index| (index.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
        let behind = [&good[..], &garbage].concat();
        for (bytes, words) in [
            (packer(b""), "run.csv: is empty"),
            (packer(b"\n# only\n"), "run.csv: has no rows"),
            (packer(&garbage), "run.csv: is no text"),
            (packer(&packer(b"time [s],F_o [N]\n0,1\n1,2\n")), &format!("run.csv: is compressed by {name}; unpack")),
            (behind, &format!(" is damaged: its {name} data")),
        ] {
            let message = read(bytes).unwrap_err();
            assert!(message.contains(words) && message.lines().count() == 1, "{message}");
        }
    }
}

#[test]
fn what_swells_when_it_is_unpacked_is_refused_soon() {
    for (name, packer) in packers() {
        // A gigabyte of zeros, in members of 16 MiB; and one line without an end.
        for (byte, words) in [(0, "run.csv: is no text: it holds zero bytes"), (b'7', "the line is longer than 1 MiB")]
        {
            let member = packer(&vec![byte; 16 << 20]);
            let start = packer(b"time [s],F_o [N]\n0,1\n1,2\n");
            let bytes = if byte == 0 { member.repeat(64) } else { [start, member.repeat(64)].concat() };
            let begun = Instant::now();
            let message = read(bytes).unwrap_err();
            assert!(message.contains(words), "{name}: {message}");
            assert!(begun.elapsed() < Duration::from_secs(5), "{name}: {:?}", begun.elapsed());
        }
    }
}

/// Files that somebody has to seek in.
const BINARY: [(bool, &str); 5] = [
    (cfg!(feature = "parquet"), "motion.parquet"),
    (cfg!(feature = "arrow"), "motion.feather"),
    (cfg!(feature = "arrow"), "motion.arrows"),
    (cfg!(feature = "matlab"), "motion-v7.mat"),
    (cfg!(feature = "mdf"), "motion.mf4"),
];

#[test]
fn a_binary_file_may_be_compressed_too() {
    let place = tempfile::tempdir().unwrap();
    for (name, packer) in packers() {
        for (_, file) in BINARY.iter().filter(|(there, _)| *there) {
            let bytes = std::fs::read(golden(file)).unwrap();
            let path = place.path().join(format!("{file}.{name}"));
            let plain = Table::read(&golden(file), &Mapping::default().format).unwrap();
            std::fs::write(&path, packer(&bytes)).unwrap();
            let found = Table::read(&path, &Mapping::default().format).unwrap();
            assert_eq!(found.column("F_o").unwrap(), plain.column("F_o").unwrap(), "{file}");
            let packed = packer(&bytes);
            std::fs::write(&path, &packed[..packed.len() - 9]).unwrap();
            let message = Table::read(&path, &Mapping::default().format).unwrap_err().to_string();
            assert!(message.ends_with(&format!("is cut off: its {name} data break off before their end")), "{message}");
        }
    }
}

/// Reads through a named pipe what another thread writes into it.
#[cfg(unix)]
fn piped(bytes: Vec<u8>, columns: &[&str]) -> Result<Recording, String> {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("pipe");
    assert!(std::process::Command::new("mkfifo").arg(&path).status().unwrap().success());
    let (to, folder) = (path.clone(), format!("{}/", place.path().display()));
    let writer = std::thread::spawn(move || {
        let mut pipe = std::fs::OpenOptions::new().write(true).open(to).unwrap();
        // Who reads may have had enough.
        let _ = bytes.chunks(1000).try_for_each(|part| pipe.write_all(part));
    });
    let cleaning = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
    let found = Recording::read(&path, &mapping(columns), &cleaning);
    writer.join().unwrap();
    found.map_err(|error| error.to_string().replace(&folder, ""))
}

#[cfg(unix)]
#[test]
fn a_pipe_gives_what_a_file_gives() {
    let text = log(20_000);
    let plain = read(&text).unwrap();
    assert_eq!(piped(text.clone().into_bytes(), &[]).unwrap().signals(), plain.signals());
    for (_, packer) in packers() {
        assert_eq!(piped(packer(text.as_bytes()), &[]).unwrap().signals(), plain.signals());
    }
    for (_, file) in BINARY.iter().filter(|(there, _)| *there) {
        let columns = ["time=time [s]", "F_o=F_o [N]", "L=L [H]"];
        let cleaning = Cleaning { drop_incomplete: true, repair_up_to: Some(0.9), ..Cleaning::default() };
        let plain = Recording::read(&golden(file), &mapping(&columns), &cleaning).unwrap();
        let found = piped(std::fs::read(golden(file)).unwrap(), &columns).unwrap();
        assert_eq!(found.signals(), plain.signals(), "{file}");
    }
    assert_eq!(piped(Vec::new(), &[]).unwrap_err(), "pipe: is empty");
}

#[test]
fn text_in_utf_16_and_with_a_mark_is_the_text() {
    let text = "Zeit [ms];F_o [N];Weg (µm)\n0,0;1,5;7\n0,5;-2,25;8\n1,0;3,0;9\n";
    let told = mapping(&["time=Zeit", "u2=Weg"]);
    let plain = read_with(text, &told, &Cleaning::default()).unwrap();
    assert_eq!(plain.channel(Channel::U2).unwrap(), [7e-6, 8e-6, 9e-6]);
    let wide = |text: &str, order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<u8>>();
    let marked = format!("\u{feff}{text}");
    for (bytes, also) in [
        (marked.clone().into_bytes(), ""),
        (wide(&marked, u16::to_le_bytes), ", in UTF-16"),
        (wide(&marked, u16::to_be_bytes), ", in UTF-16"),
        (wide(text, u16::to_le_bytes), ", in UTF-16"),
    ] {
        let found = read_with(&bytes, &told, &Cleaning::default()).unwrap();
        assert_eq!(found.signals(), plain.signals());
        let told = format!("text, columns separated by \";\", decimal comma, header in line 1{also}");
        assert_eq!(found.account().description, told);
        let held = Recording::of_text("run.csv", bytes, &self::told(), &Cleaning::default()).unwrap();
        assert_eq!(held.signals(), plain.signals(), "in memory, as the page has it");
    }
    // Half of a character at the end: the last number may lack digits.
    let mut cut = wide(&marked, u16::to_le_bytes);
    cut.pop();
    let message = read_with(&cut, &told, &Cleaning::default()).unwrap_err();
    assert_eq!(message, "run.csv: is cut off: it is UTF-16 and ends in the middle of a character");
    let long: String = std::iter::once(marked).chain((0..200_000).map(|_| "2,0;1,0;1\n".to_owned())).collect();
    let mut cut = wide(&long, u16::to_le_bytes);
    cut.pop();
    let message = read_with(&cut, &told, &Cleaning { merge_repeated: true, ..Cleaning::default() }).unwrap_err();
    assert_eq!(message, "run.csv:200004: is cut off: it is UTF-16 and ends in the middle of a character");
}

/// Columns of the text above.
fn told() -> Mapping {
    mapping(&["time=Zeit", "u2=Weg"])
}

#[cfg(not(all(feature = "gzip", feature = "zstd")))]
#[test]
fn a_packer_that_was_left_out_is_named() {
    let text = log(3);
    for (there, name, bytes) in [
        (cfg!(feature = "gzip"), "gzip", gzip(text.as_bytes())),
        (cfg!(feature = "zstd"), "zstd", zstd(text.as_bytes())),
    ] {
        let words = format!(
            "run.csv: is compressed by {name}, which this build cannot read: it was made without the feature {name}"
        );
        assert!(there || read(bytes).unwrap_err() == words);
    }
}
