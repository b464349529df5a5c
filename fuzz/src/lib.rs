//! What each target asks of bytes that anybody may have sent: they are read, or refused in one line, within the time and the memory that the
//! fuzzer is given.
//!
//! Next door: the targets, one line each (`fuzz_targets`), who builds and runs them (`cargo xtask fuzz`).

use std::cell::RefCell;
use std::fs;

use coilsense_lab::quantity::{Dimension, with_point};
use coilsense_lab::recording::{Cleaning, Mapping, Recording, RecordingError};
use coilsense_lab::spec::Spec;
use tempfile::TempDir;

/// Everything that a user may ask for at once.
const ALL: Cleaning = Cleaning {
    drop_incomplete: true,
    sort: true,
    merge_repeated: true,
    unwrap: true,
    repair_up_to: Some(1.0),
    fill_gaps: Some(10.0),
    resample: None,
    from: None,
    to: None,
};

/// A file that a spec may name.
const ROAD: &str = "time [s],u1 [m]\n0,0\n0.1,0.001\n0.2,0.002\n0.3,0\n0.4,0.001\n";

/// One line.
fn one_line(message: &str) {
    assert!(!message.contains('\n'), "{message:?}");
}

/// A spec's text.
pub fn spec(text: &str) {
    let files = |name: &str| match name {
        "road.csv" => Ok(ROAD.to_owned()),
        _ => Err("is not there".to_owned()),
    };
    if let Err(error) = Spec::parse("spec.toml", text, &files) {
        one_line(&error.to_string());
    }
}

/// A number with its unit.
pub fn quantity(text: &str) {
    for dimension in Dimension::ALL {
        let read = dimension.parse(text);
        let spaced = dimension.parse(&format!(" {text}\t"));
        assert!(read.map(f64::to_bits) == spaced.map(f64::to_bits), "{text:?}: {read:?} and {spaced:?}");
        // A text is quoted there, so that it stays on its line.
        one_line(&dimension.refusal(text));
    }
    if let Some(pointed) = with_point(text) {
        assert!(!pointed.contains(','), "{pointed:?}");
    }
}

/// A log's text.
pub fn text_log(text: &[u8]) {
    each_way(|mapping, cleaning| Recording::of_text("log.csv", text.to_vec(), mapping, cleaning));
}

/// A log's file, where it begins as those of a format do.
pub fn log_file(begins: &[u8], bytes: &[u8]) {
    thread_local! {
        static PLACE: RefCell<Option<TempDir>> = const { RefCell::new(None) };
    }
    if !bytes.starts_with(begins) {
        return;
    }
    PLACE.with_borrow_mut(|place| {
        let place = place.get_or_insert_with(|| tempfile::tempdir().expect("a temporary folder"));
        let path = place.path().join("log");
        fs::write(&path, bytes).expect("written");
        each_way(|mapping, cleaning| Recording::read(&path, mapping, cleaning));
    });
}

/// Reads a log by its titles and by its first columns, as it is and cleaned.
fn each_way(read: impl Fn(&Mapping, &Cleaning) -> Result<Recording, RecordingError>) {
    let mut first = Mapping::default();
    for column in ["time=#1 [s]", "F_o=#2 [N]"] {
        first.set(column).expect("a column");
    }
    for mapping in [Mapping::default(), first] {
        for cleaning in [Cleaning::default(), ALL] {
            match read(&mapping, &cleaning) {
                Ok(recording) => {
                    assert_eq!(recording.account().rows as usize, recording.signals().time().len());
                }
                Err(error) => one_line(&error.to_string()),
            }
        }
    }
}
