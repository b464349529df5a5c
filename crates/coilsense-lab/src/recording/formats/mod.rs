//! The formats of log files, as rows of one table: how their files begin, and what opens them.
//!
//! Who adds a format writes its reader beside this file, a row here, and where the reader is someone else's a feature in `Cargo.toml`.
//! A text has no first bytes of its own: it is what no row knows.
//!
//! Next door: texts (`text`), rows one after the other (`source`), what becomes of them (`pipeline`).

#[cfg(any(feature = "matlab", feature = "tdms"))]
mod apart;
#[cfg(any(feature = "mdf", feature = "tdms"))]
mod grouped;
#[cfg(any(feature = "matlab", feature = "mdf", feature = "tdms", test))]
mod in_memory;
#[cfg(feature = "matlab")]
mod matlab;
#[cfg(feature = "mdf")]
mod mdf;
#[cfg(feature = "matlab")]
mod only_matlab;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(feature = "tdms")]
mod tdms;
#[cfg(test)]
mod toy;
#[cfg(feature = "matlab")]
mod vectors;

use std::path::Path;

use super::error::RecordingError;
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

/// Opens a file of a format.
type Open = fn(Input) -> Result<Box<dyn Source>, RecordingError>;

/// What it takes to read a file.
enum Takes {
    /// A build with this feature.
    Feature(&'static str),
    /// Something that only its owner can do.
    Advice(&'static str),
}

/// Every format but texts; of two whose first bytes both fit, the first is meant.
const TABLE: &[Row] = &[
    Row {
        name: "Parquet",
        magic: &[b"PAR1"],
        takes: Takes::Feature("parquet"),
        #[cfg(feature = "parquet")]
        open: Some(|input| Ok(Box::new(parquet::ParquetRows::open(input)?))),
        #[cfg(not(feature = "parquet"))]
        open: None,
    },
    Row {
        name: "a MATLAB file of version 7.3 (HDF5)",
        magic: &[b"MATLAB 7.3"],
        takes: Takes::Advice("which is not read; save it with -v7"),
        open: None,
    },
    Row {
        name: "a MATLAB file",
        magic: &[b"MATLAB 5.0"],
        takes: Takes::Feature("matlab"),
        #[cfg(feature = "matlab")]
        open: Some(|input| Ok(Box::new(in_memory::TableRows::of(matlab::read(input)?)))),
        #[cfg(not(feature = "matlab"))]
        open: None,
    },
    Row {
        name: "MDF",
        magic: &[b"MDF     ", b"UnFinMF "],
        takes: Takes::Feature("mdf"),
        #[cfg(feature = "mdf")]
        open: Some(|input| Ok(Box::new(in_memory::TableRows::of(mdf::read(input)?)))),
        #[cfg(not(feature = "mdf"))]
        open: None,
    },
    Row {
        name: "NI TDMS",
        magic: &[b"TDSm"],
        takes: Takes::Feature("tdms"),
        #[cfg(feature = "tdms")]
        open: Some(|input| Ok(Box::new(in_memory::TableRows::of(tdms::read(input)?)))),
        #[cfg(not(feature = "tdms"))]
        open: None,
    },
    Row {
        name: "the index of an NI TDMS file",
        magic: &[b"TDSh"],
        takes: Takes::Advice("which holds no data; read the .tdms beside it"),
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
    takes: Takes::Feature("matlab"),
    open: Some(|input| Ok(Box::new(in_memory::TableRows::of(matlab::read_level4(input)?)))),
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
    fn refusal(&self) -> String {
        match self.takes {
            Takes::Feature(feature) => {
                format!("is {}, which this build cannot read: it was made without the feature {feature}", self.name)
            }
            Takes::Advice(advice) => format!("is {}, {advice}", self.name),
        }
    }
}

/// Opens a log of any format, from a file, a pipe or standard input; `format` says how a text is written.
///
/// What is no text with columns is refused by the reader of texts.
pub(super) fn open(path: &Path, format: &Format) -> Result<Box<dyn Source>, RecordingError> {
    let mut input = Input::open(path)?;
    match Row::of(input.head()).or_else(|| Row::of_whole(&mut input)) {
        None => Ok(Box::new(Text::open(input, format)?)),
        Some(row) => row.open.ok_or_else(|| RecordingError::of_file(input.path(), row.refusal()))?(input),
    }
}

/// A text in memory, under a name for messages.
pub(super) fn held(name: &str, text: Vec<u8>, format: &Format) -> Result<Text, RecordingError> {
    let name = Path::new(name);
    match Row::of(&text) {
        None => Text::held(name, text, format),
        Some(Row { open: Some(_), .. }) => Err(RecordingError::of_file(name, "is no text")),
        Some(row) => Err(RecordingError::of_file(name, row.refusal())),
    }
}
