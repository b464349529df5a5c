//! The formats of log files, as rows of one table: how their files begin, and what opens them.
//!
//! Who adds a format writes its reader beside this file, a row here, and where the reader is someone else's a feature in `Cargo.toml`.
//! A text has no first bytes of its own: it is what no row knows.
//!
//! Next door: texts (`text`), rows one after the other (`source`), what becomes of them (`pipeline`).

#[cfg(any(feature = "matlab", feature = "mdf", feature = "tdms", feature = "hdf5", feature = "mcap"))]
mod apart;
#[cfg(feature = "arrow")]
mod arrow;
#[cfg(any(feature = "mdf", feature = "tdms"))]
mod between;
#[cfg(any(feature = "parquet", feature = "arrow"))]
mod columnar;
#[cfg(any(feature = "mdf", feature = "tdms", feature = "mcap"))]
mod grouped;
#[cfg(feature = "hdf5")]
mod hdf5;
#[cfg(any(feature = "matlab", feature = "mdf", feature = "tdms", feature = "hdf5", feature = "mcap", test))]
mod in_memory;
#[cfg(feature = "matlab")]
mod matlab;
#[cfg(feature = "mcap")]
mod mcap;
#[cfg(feature = "mdf")]
mod mdf;
#[cfg(feature = "mdf")]
mod mdf3;
#[cfg(any(feature = "matlab", feature = "hdf5"))]
mod only_matlab;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(feature = "sheets")]
mod sheets;
#[cfg(feature = "tdms")]
mod tdms;
#[cfg(test)]
mod toy;
#[cfg(any(feature = "matlab", feature = "hdf5"))]
mod vectors;

use std::path::Path;

use super::error::RecordingError;
use super::handed::Handed;
use super::input::Input;
use super::mapping::Format;
use super::source::Source;
use super::text::Text;

/// A format whose files say by their first bytes that they are of it.
struct Row {
    /// What such a file is, after "is".
    name: &'static str,
    /// How it begins, one way or another.
    magic: &'static [&'static [u8]],
    /// What it takes to read it, said where `open` is not there.
    takes: Takes,
    /// Opens a file.
    open: Option<Open>,
}

/// Opens a file of a format; what is told of how it is written matters to those that look like texts.
type Open = fn(Input, &Format) -> Result<Box<dyn Source>, RecordingError>;

/// What it takes to read a file.
enum Takes {
    /// A build with this feature of the command, and of the library.
    Feature(&'static str),
    /// Something that only its owner can do; in it FILE is the file, and STEM what its name is without the ending.
    Advice(&'static str),
}

/// Every format but texts; of two whose first bytes both fit, the first is meant.
const TABLE: &[Row] = &[
    Row {
        name: "Parquet",
        magic: &[b"PAR1"],
        takes: Takes::Feature("files, of the library parquet"),
        #[cfg(feature = "parquet")]
        open: Some(|input, _| Ok(Box::new(parquet::ParquetRows::open(input)?))),
        #[cfg(not(feature = "parquet"))]
        open: None,
    },
    Row {
        name: "Arrow",
        magic: &[b"ARROW1", b"\xff\xff\xff\xff"],
        takes: Takes::Feature("formats, of the library arrow"),
        #[cfg(feature = "arrow")]
        open: Some(|input, _| Ok(Box::new(arrow::ArrowRows::open(input)?))),
        #[cfg(not(feature = "arrow"))]
        open: None,
    },
    Row {
        name: "Feather of version 1",
        magic: &[b"FEA1"],
        takes: Takes::Advice(
            "which is not read; convert it by: python3 -c \"import sys, pandas; \
             pandas.read_feather(sys.argv[1]).to_parquet(sys.argv[2])\" FILE STEM.parquet",
        ),
        open: None,
    },
    Row {
        name: "a workbook or ZIP archive",
        // What old Office wrote, and what has a password, begins as the second does.
        magic: &[b"PK\x03\x04", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"],
        takes: Takes::Feature("files, of the library sheets"),
        #[cfg(feature = "sheets")]
        open: Some(|input, format| Ok(Box::new(sheets::open(input, format)?))),
        #[cfg(not(feature = "sheets"))]
        open: None,
    },
    Row {
        name: "compressed by bzip2",
        magic: &[b"BZh"],
        takes: Takes::Advice("which is not read; unpack it first: bunzip2 --keep FILE"),
        open: None,
    },
    Row {
        name: "compressed by xz",
        magic: &[b"\xfd7zXZ\0"],
        takes: Takes::Advice("which is not read; unpack it first: unxz --keep FILE"),
        open: None,
    },
    Row {
        name: "compressed by lz4",
        magic: &[b"\x04\x22\x4d\x18"],
        takes: Takes::Advice("which is not read; unpack it first: unlz4 --keep FILE"),
        open: None,
    },
    Row {
        name: "a MATLAB file of version 7.3 (HDF5)",
        magic: &[b"MATLAB 7.3"],
        takes: Takes::Feature("formats, of the library hdf5"),
        #[cfg(feature = "hdf5")]
        open: Some(|input, _| Ok(Box::new(in_memory::TableRows::of(hdf5::read_matlab(input)?)))),
        #[cfg(not(feature = "hdf5"))]
        open: None,
    },
    Row {
        name: "a MATLAB file",
        magic: &[b"MATLAB 5.0"],
        takes: Takes::Feature("files, of the library matlab"),
        #[cfg(feature = "matlab")]
        open: Some(|input, _| Ok(Box::new(in_memory::TableRows::of(matlab::read(input)?)))),
        #[cfg(not(feature = "matlab"))]
        open: None,
    },
    Row {
        name: "MDF 3",
        magic: &[b"MDF     3", b"MDF     2"],
        takes: Takes::Feature("formats, of the library mdf"),
        #[cfg(feature = "mdf")]
        open: Some(|input, _| Ok(Box::new(in_memory::TableRows::of(mdf3::read(input)?)))),
        #[cfg(not(feature = "mdf"))]
        open: None,
    },
    Row {
        name: "MDF",
        magic: &[b"MDF     ", b"UnFinMF "],
        takes: Takes::Feature("formats, of the library mdf"),
        #[cfg(feature = "mdf")]
        open: Some(|input, _| Ok(Box::new(in_memory::TableRows::of(mdf::read(input)?)))),
        #[cfg(not(feature = "mdf"))]
        open: None,
    },
    Row {
        name: "NI TDMS",
        magic: &[b"TDSm"],
        takes: Takes::Feature("files, of the library tdms"),
        #[cfg(feature = "tdms")]
        open: Some(|input, _| Ok(Box::new(in_memory::TableRows::of(tdms::read(input)?)))),
        #[cfg(not(feature = "tdms"))]
        open: None,
    },
    Row {
        name: "the index of an NI TDMS file",
        magic: &[b"TDSh"],
        takes: Takes::Advice("which holds no data; read the .tdms beside it"),
        open: None,
    },
    Row {
        name: "HDF5",
        magic: &[b"\x89HDF\r\n\x1a\n"],
        takes: Takes::Feature("formats, of the library hdf5"),
        #[cfg(feature = "hdf5")]
        open: Some(|input, _| Ok(Box::new(in_memory::TableRows::of(hdf5::read(input)?)))),
        #[cfg(not(feature = "hdf5"))]
        open: None,
    },
    Row {
        name: "MCAP",
        magic: &[b"\x89MCAP"],
        takes: Takes::Feature("files, of the library mcap"),
        #[cfg(feature = "mcap")]
        open: Some(|input, _| Ok(Box::new(in_memory::TableRows::of(mcap::read(input)?)))),
        #[cfg(not(feature = "mcap"))]
        open: None,
    },
    #[cfg(test)]
    toy::ROW,
];

/// A format whose files have no first bytes of their own; asked where no row of the table fits.
#[cfg(feature = "matlab")]
const MATLAB_4: Row = Row {
    name: "a MATLAB file of version 4",
    magic: &[],
    takes: Takes::Feature("files, of the library matlab"),
    open: Some(|input, _| Ok(Box::new(in_memory::TableRows::of(matlab::read_level4(input)?)))),
};

impl Row {
    /// The format of a file whose first bytes say nothing, by all of it; `None` of a text.
    fn of_whole(input: &mut Input) -> Option<&'static Self> {
        #[cfg(feature = "matlab")]
        return matlab::is_level4(input).then_some(&MATLAB_4);
        #[cfg(not(feature = "matlab"))]
        {
            let _ = input;
            None
        }
    }

    /// The format of a file that begins so; `None` of a text.
    fn of(head: &[u8]) -> Option<&'static Self> {
        TABLE.iter().find(|row| row.magic.iter().any(|magic| head.starts_with(magic)))
    }

    /// Why it cannot be opened.
    fn refusal(&self, file: &Path) -> String {
        match self.takes {
            Takes::Feature(feature) => {
                format!("is {}, left out of this build: build with --features {feature}", self.name)
            }
            Takes::Advice(advice) => advised(file, self.name, advice),
        }
    }
}

/// That a file is not read, and what its owner can do.
fn advised(file: &Path, name: &str, advice: &str) -> String {
    let (file, stem) = (quoted(file), quoted(&file.with_extension("")));
    // Each word once, so that a file whose name has such a word in it is not torn.
    let words = advice.split(' ').map(|word| match word.strip_prefix("STEM") {
        Some(ending) => format!("{stem}{ending}"),
        None if word == "FILE" => file.clone(),
        None => word.to_owned(),
    });
    format!("is {name}, {}", words.collect::<Vec<_>>().join(" "))
}

/// A path as a shell takes it.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    let is_plain = |c: char| c.is_alphanumeric() || "/._-+:,@%".contains(c);
    match text.chars().all(is_plain) {
        true => text,
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
}

/// Opens a log of any format, from a file, a pipe or standard input; `format` says how a text is written.
///
/// What is no text with columns is refused by the reader of texts.
pub(super) fn open(path: &Path, format: &Format) -> Result<Box<dyn Source>, RecordingError> {
    let mut input = Input::open(path)?;
    match Row::of(input.head()).or_else(|| Row::of_whole(&mut input)) {
        None => Ok(Box::new(Text::open(input, format)?)),
        Some(row) => {
            row.open.ok_or_else(|| RecordingError::of_file(input.path(), row.refusal(input.path())))?(input, format)
        }
    }
}

/// A text that is handed over.
pub(super) fn held(log: Handed, format: &Format) -> Result<Text, RecordingError> {
    let input = Input::of_handed(log)?;
    match Row::of(input.head()) {
        None => Text::open(input, format),
        Some(Row { open: Some(_), .. }) => Err(RecordingError::of_file(input.path(), "is no text")),
        // What is built for the page has no room for other formats.
        Some(Row { name: kind, takes: Takes::Feature(_), .. }) => {
            let message = format!("is {kind}, which is not read here; save its columns as CSV");
            Err(RecordingError::of_file(input.path(), message))
        }
        Some(row) => Err(RecordingError::of_file(input.path(), row.refusal(input.path()))),
    }
}
