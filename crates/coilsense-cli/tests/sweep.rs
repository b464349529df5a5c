//! `coilsense sweep` as a person meets it: killed at any time, on a full disk, beside another run, on another processor.
//!
//! Next door: rows and refusals as a library (`coilsense-lab/tests/sweep`).

#[cfg(unix)]
mod answering;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use coilsense_lab::sweep::{Data, Dataset};

/// A coil of few windings, watched for a few samples: thousands of rows a second, also in a test build.
const SPEC: &str = include_str!("short-coil.toml");

/// A folder with the spec, and the command on it.
struct Place {
    folder: tempfile::TempDir,
}

impl Place {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("spec.toml"), SPEC).expect("written");
        Self { folder }
    }

    fn command(&self, out: &str, rows: u64) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
        command.current_dir(self.folder.path()).args(["sweep", "spec.toml", "--over", "spring.mass=-1..20 g"]);
        command.args(["--over", "spring.stiffness=normal(760 N/m, 5 %)", "--chunk", "100", "--seed", "4"]);
        command.args(["--rows", &rows.to_string(), "--out", out]).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.folder.path().join(name)
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// Exit code 2 and one line.
fn refusal(output: &Output) -> String {
    let message = text(&output.stderr);
    assert_eq!((output.status.code(), message.lines().count()), (Some(2), 1), "{message}");
    message
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let file = |entry: std::io::Result<fs::DirEntry>| {
        let entry = entry.expect("an entry");
        (entry.file_name().into_string().expect("UTF-8"), fs::read(entry.path()).expect("read"))
    };
    fs::read_dir(folder).expect("a folder").map(file).collect()
}

#[test]
fn a_sweep_says_how_its_rows_went_and_how_to_read_them() {
    let place = Place::new();
    let output = place.command("out", 300).output().expect("it starts");
    let printed = text(&output.stdout);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(printed.starts_with("300 rows in out (3 files): "), "{printed}");
    // Masses from -1 to 20 g in 300 parts: those of one in 21, 14 or 15 parts, are not above zero.
    let refused = |count: u32| {
        printed.contains(&format!(" 0 in which windings would touch, {count} that could not be judged\n  {count} × such as: spec.toml:8: mass = \"-"))
    };
    assert!(refused(14) || refused(15), "{printed}");
    assert!(printed.contains("300 designs in ") && printed.contains("pandas.read_parquet(\"out\")"), "{printed}");
    let again = text(&place.command("out", 300).output().expect("it starts").stdout);
    assert!(again.contains("all of them were there before"), "{again}");
    assert!(refusal(&place.command("out", 400).output().expect("it starts")).contains("--rows is 400, not 300"));
}

/// Twenty kills at random times, then a run to the end: no row lost, doubled or torn, and not a byte that differs from an unbroken run.
#[test]
fn a_run_that_is_killed_again_and_again_leaves_the_rows_of_an_unbroken_one() {
    const ROWS: u64 = 20_000;
    let place = Place::new();
    let begun = Instant::now();
    assert!(place.command("unbroken", ROWS).output().expect("it starts").status.success());
    let whole = begun.elapsed();
    // A fixed sequence of fractions (golden ratio), so that kills spread over all phases of a run; each run makes a twentieth of the way at most,
    // all of them half: the unbroken run may have had less of the machine.
    let mut struck = 0;
    for kill in 1..=20 {
        let mut running = place.command("killed", ROWS).spawn().expect("it starts");
        let fraction = (f64::from(kill) * 0.618_034).fract();
        sleep(Duration::from_secs_f64(0.002 + 0.05 * fraction * whole.as_secs_f64()));
        struck += u32::from(running.try_wait().expect("asked").is_none());
        running.kill().expect("killed");
        running.wait().expect("gone");
    }
    // A kill that comes before the manifest leaves a folder to begin with.
    assert!(struck >= 10, "only {struck} of 20 kills met a run");
    assert!(place.command("killed", ROWS).output().expect("it starts").status.success());
    let (unbroken, killed) = (files(&place.path("unbroken")), files(&place.path("killed")));
    assert_eq!(unbroken.len() as u64, ROWS / 100 + 2);
    assert_eq!(unbroken.keys().collect::<Vec<_>>(), killed.keys().collect::<Vec<_>>());
    assert!(unbroken == killed, "a file differs");
}

#[test]
fn the_bytes_are_the_same_on_any_number_of_threads() {
    let place = Place::new();
    for jobs in ["1", "3"] {
        assert!(place.command(jobs, 500).args(["--jobs", jobs]).output().expect("it starts").status.success());
    }
    assert!(files(&place.path("1")) == files(&place.path("3")));
}

#[test]
fn a_sweep_of_other_vector_instructions_is_not_gone_on_with() {
    let place = Place::new();
    let scalar = |command: &mut Command| command.env("COILSENSE_SIMD", "scalar").output().expect("it starts");
    assert!(scalar(&mut place.command("out", 200)).status.success());
    fs::remove_file(place.path("out/chunk-000001.parquet")).expect("removed");
    let other = place.command("out", 200).env_remove("COILSENSE_SIMD").output().expect("it starts");
    if !other.status.success() {
        // Where the processor has nothing wider, there is nothing to refuse.
        assert!(refusal(&other).contains("set COILSENSE_SIMD=scalar"));
    }
    assert!(scalar(&mut place.command("out", 200)).status.success());
}

#[test]
fn a_folder_that_cannot_be_written_is_one_line() {
    let place = Place::new();
    fs::write(place.path("file"), "").expect("written");
    let message = refusal(&place.command("file/out", 10).output().expect("it starts"));
    assert!(message.contains("file/out: cannot be written"), "{message}");
    let message = refusal(&place.command("file", 10).output().expect("it starts"));
    assert!(message.contains("file: "), "{message}");
}

/// A limit on the size of files stands for a full disk: the write fails in the middle of a chunk.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_one_line_and_the_next_run_goes_on() {
    let place = Place::new();
    let mut limited = Command::new("sh");
    let script = "trap '' XFSZ; ulimit -f 8; exec \"$@\"";
    let plain = place.command("out", 400);
    limited.args(["-c", script, "sh"]).arg(plain.get_program()).args(plain.get_args());
    let output = limited.current_dir(place.folder.path()).output().expect("it starts");
    let message = refusal(&output);
    assert!(message.contains("out/chunk-000000.parquet: cannot be written: "), "{message}");
    assert_eq!(files(&place.path("out")).keys().collect::<Vec<_>>(), ["_lock", "_manifest.json"]);
    assert!(place.command("out", 400).output().expect("it starts").status.success());
    assert!(place.command("whole", 400).output().expect("it starts").status.success());
    assert!(files(&place.path("out")) == files(&place.path("whole")));
}

/// What is interrupted by hand stops between rows, keeps whole chunks, and says how to go on.
#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_is_whole() {
    let place = Place::new();
    let plain = place.command("out", 1_000_000);
    let mut command = answering::answering();
    command.args(plain.get_args()).current_dir(place.folder.path());
    let running = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    while !place.path("out/chunk-000000.parquet").is_file() {
        sleep(Duration::from_millis(5));
    }
    let status = Command::new("kill").args(["-INT", &running.id().to_string()]).status().expect("kill");
    assert!(status.success());
    let output = running.wait_with_output().expect("it ends");
    let message = text(&output.stderr);
    assert_eq!((output.status.code(), message.lines().count()), (Some(130), 1), "{message}");
    assert!(message.contains("of 10000 chunks are whole, the same command goes on from there"), "{message}");
    assert!(files(&place.path("out")).keys().all(|name| !name.starts_with('.')));
}

/// What is damaged, copied over or gone is said and made anew; until then nobody answers from it.
#[test]
fn chunks_that_are_not_as_written_are_made_anew_and_said() {
    let place = Place::new();
    assert!(place.command("out", 500).output().expect("it starts").status.success());
    let whole = files(&place.path("out"));
    let chunk = |number: u32| format!("chunk-{number:06}.parquet");
    let put = |number: u32, bytes: &[u8]| fs::write(place.path("out").join(chunk(number)), bytes).expect("written");
    let mut flipped = whole[&chunk(0)].clone();
    flipped[100] ^= 4;
    put(0, &flipped);
    put(1, &whole[&chunk(2)]);
    put(3, &whole[&chunk(3)][..2000]);
    fs::remove_file(place.path("out").join(chunk(4))).expect("removed");
    for (verb, option) in [("pareto", ["--minimize", "mass"]), ("sensitivity", ["--of", "mass"])] {
        let mut asked = Command::new(env!("CARGO_BIN_EXE_coilsense"));
        asked.current_dir(place.folder.path()).args([verb, "out"]).args(option);
        let message = refusal(&asked.output().expect("it starts"));
        // Not laid out for it, which is seen first.
        let expected = match verb {
            "pareto" => "out/chunk-000000.parquet: is damaged",
            _ => "need a sweep with --sampling saltelli",
        };
        assert!(message.contains(expected), "{message}");
    }
    let json = place.command("out", 500).arg("--json").output().expect("it starts");
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).expect("JSON");
    let recomputed = json["recomputed"].as_array().expect("a list");
    let named: Vec<&str> = recomputed.iter().map(|row| row["file"].as_str().expect("a file")).collect();
    assert_eq!(named, [0, 1, 3].map(|number| format!("out/{}", chunk(number))));
    assert_eq!((json["made"].as_u64(), json["rows"].as_u64()), (Some(400), Some(500)));
    assert!(files(&place.path("out")) == whole);
    put(1, &whole[&chunk(2)]);
    let printed = text(&place.command("out", 500).output().expect("it starts").stdout);
    let said = "1 file that was not as written was made anew:\n  out/chunk-000001.parquet: it holds rows 200 to 299, which are those of another chunk\n";
    assert!(printed.contains(said), "{printed}");
}

#[test]
fn the_same_spec_elsewhere_and_with_a_comment_goes_on_and_another_does_not() {
    let place = Place::new();
    assert!(place.command("out", 300).output().expect("it starts").status.success());
    let whole = files(&place.path("out"));
    fs::remove_file(place.path("out/chunk-000000.parquet")).expect("removed");
    fs::create_dir(place.path("sub")).expect("made");
    let moved = |text: &str| {
        fs::write(place.path("sub/moved.toml"), text).expect("written");
        let mut command = place.command("out", 300);
        let arguments: Vec<_> = command.get_args().map(|word| word.to_owned()).collect();
        command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
        let elsewhere =
            arguments.into_iter().map(|word| if word == "spec.toml" { "sub/moved.toml".into() } else { word });
        command.current_dir(place.folder.path()).args(elsewhere).output().expect("it starts")
    };
    let output = moved(&format!("# moved\n\n{SPEC}"));
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(files(&place.path("out")) == whole);
    let message = refusal(&moved(&SPEC.replacen("35 mm", "36 mm", 1)));
    assert!(
        message.contains("holds another sweep: the spec sub/moved.toml says other than spec.toml did"),
        "{message}"
    );
}

/// As many files as no folder bears are refused before anything is begun.
#[test]
fn a_thousand_million_chunks_are_refused_at_once() {
    let place = Place::new();
    let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
    command.current_dir(place.folder.path()).args(["sweep", "spec.toml", "--over", "spring.mass=1..20 g"]);
    command.args(["--rows", "1000000000", "--chunk", "1", "--out", "out"]);
    let begun = Instant::now();
    let message = refusal(&command.output().expect("it starts"));
    assert!(message.contains("are 1000000000 files, at most 100000 are taken; give --chunk from 10000"), "{message}");
    assert!(begun.elapsed() < Duration::from_secs(10) && !place.path("out").exists(), "{:?}", begun.elapsed());
}

#[test]
fn all_rows_are_one_table_for_a_spreadsheet_too() {
    let place = Place::new();
    let run = |csv: &[&str]| place.command("out", 250).args(csv).output().expect("runs");
    // Not among the Parquet files, where readers would take it for rows; refused before there is a folder.
    let message = refusal(&run(&["--csv", "out/rows.csv"]));
    assert!(message.contains("lies in the sweep's folder") && !place.path("out").exists(), "{message}");
    // Nor in the place of what is not coilsense's own.
    fs::write(place.path("rows.csv"), "mine").expect("written");
    let message = refusal(&run(&["--csv", "rows.csv"]));
    assert!(message.contains("rows.csv") && !place.path("out").exists(), "{message}");
    assert_eq!(fs::read_to_string(place.path("rows.csv")).expect("read"), "mine");
    let output = run(&["--csv", "rows.csv", "--overwrite"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("all rows as one table: rows.csv"), "{}", text(&output.stdout));
    // The same rows as the Parquet files, to the bit; what could not be judged has its reason and no numbers.
    let dataset = Dataset::open(&place.path("out")).expect("a sweep");
    let titles = dataset.plan().titles();
    let words: Vec<&str> = titles.iter().map(String::as_str).collect();
    let columns = dataset.read(&words).expect("read");
    let mut reader = csv::Reader::from_path(place.path("rows.csv")).expect("a table");
    assert_eq!(reader.headers().expect("titles").iter().collect::<Vec<_>>(), words);
    let rows: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>().expect("rows");
    assert_eq!(rows.len(), 250);
    let mut empty = 0;
    for (place, column) in columns.iter().enumerate() {
        let Data::Numbers(values) = column else { continue };
        for (value, row) in values.iter().zip(&rows) {
            empty += usize::from(row[place].is_empty());
            assert!(value.is_nan() && row[place].is_empty() || row[place].parse() == Ok(*value), "{}", &row[place]);
        }
    }
    assert!(empty > 0, "a mass below zero cannot be judged");
    // A folder that is whole gives its table, too.
    let again = run(&["--csv", "again.csv"]);
    assert!(text(&again.stdout).contains("all of them were there before"), "{}", text(&again.stdout));
    assert_eq!(fs::read(place.path("again.csv")).expect("read"), fs::read(place.path("rows.csv")).expect("read"));
}
