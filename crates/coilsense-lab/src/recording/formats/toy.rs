//! A format of log files that only the tests know: one row of the table is all that reading it takes.

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::mapping::Format;
use super::super::source::Source;
use super::super::table::Table;
use super::super::title::Title;
use super::in_memory::TableRows;
use super::{Row, Takes};

pub(super) const ROW: Row =
    Row { name: "a toy", magic: &[b"TOY1"], takes: Takes::Advice("which is a toy"), open: Some(open) };

/// After the magic bytes pairs of little-endian numbers: time in ms, force in N.
fn open(input: Input, _: &Format) -> Result<Box<dyn Source>, RecordingError> {
    let path = input.path().to_owned();
    let bytes = input.bytes(1 << 20, "a toy")?;
    let pairs: Vec<[f64; 2]> = bytes[4..]
        .chunks_exact(4)
        .map(|pair| [[pair[0], pair[1]], [pair[2], pair[3]]].map(|two| i16::from_le_bytes(two).into()))
        .collect();
    Ok(Box::new(TableRows::of(Table {
        file: path,
        description: "toy".to_owned(),
        remarks: Vec::new(),
        titles: vec![Title::parse("time [ms]"), Title::parse("F_o [N]")],
        columns: [0, 1].map(|column| pairs.iter().map(|pair| pair[column]).collect()).into(),
        lines: (1..=pairs.len() as u64).collect(),
    })))
}

#[test]
fn a_row_of_the_table_is_all_that_a_format_takes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.toy");
    let numbers: [i16; 6] = [0, 5, 10, -7, 20, 9];
    let bytes: Vec<u8> =
        b"TOY1".iter().copied().chain(numbers.iter().flat_map(|number| number.to_le_bytes())).collect();
    std::fs::write(&path, &bytes).unwrap();
    let mapping = super::super::Mapping::default();
    let recording = super::super::Recording::read(&path, &mapping, &super::super::Cleaning::default()).unwrap();
    assert_eq!(recording.signals().time(), [0.0, 0.010, 0.020]);
    assert_eq!(recording.channel(coilsense::Channel::OutputForce).unwrap(), [5.0, -7.0, 9.0]);
    let table = Table::read(&path, &mapping.format).unwrap();
    assert_eq!((table.rows(), table.column("F_o").unwrap()), (3, &[5.0, -7.0, 9.0][..]));
    let cleaning = super::super::Cleaning::default();
    let held = super::super::Recording::of_text("log.toy", bytes, &mapping, &cleaning).unwrap_err().to_string();
    assert_eq!(held, "log.toy: is no text");
}
