//! Where rows come from: one after the other, so that a file need not fit into memory.
//!
//! Next door: texts (`text`), what is read at once (`table`), what becomes of the rows (`pipeline`).

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::account::Reason;
use super::error::RecordingError;
use super::title::Title;

/// What a file is, by its first bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A text, or what is to be refused by the reader of texts.
    Text,
    #[cfg(feature = "parquet")]
    Parquet,
    #[cfg(feature = "matlab")]
    Matlab,
    #[cfg(feature = "mdf")]
    Mdf,
}

impl Kind {
    pub fn of(path: &Path) -> Result<Self, RecordingError> {
        let wrong = |message: String| RecordingError::of_file(path, message);
        let mut head = Vec::new();
        let read = File::open(path).and_then(|file| file.take(16).read_to_end(&mut head));
        read.map_err(|error| wrong(format!("cannot be read: {error}")))?;
        Self::of_head(path, &head)
    }

    /// The same by the first bytes alone.
    pub fn of_head(path: &Path, head: &[u8]) -> Result<Self, RecordingError> {
        let wrong = |message: String| RecordingError::of_file(path, message);
        #[cfg(not(all(feature = "parquet", feature = "matlab", feature = "mdf")))]
        let missing = |what: &str, feature: &str| -> Result<Self, RecordingError> {
            Err(wrong(format!("is {what}, which this build cannot read: it was made without the feature {feature}")))
        };
        match head {
            head if head.starts_with(b"PAR1") => {
                #[cfg(feature = "parquet")]
                return Ok(Self::Parquet);
                #[cfg(not(feature = "parquet"))]
                missing("Parquet", "parquet")
            }
            head if head.starts_with(b"MATLAB 7.3") => {
                Err(wrong("is a MATLAB file of version 7.3 (HDF5), which is not read; save it with -v7".to_owned()))
            }
            head if head.starts_with(b"MATLAB 5.0") => {
                #[cfg(feature = "matlab")]
                return Ok(Self::Matlab);
                #[cfg(not(feature = "matlab"))]
                missing("a MATLAB file", "matlab")
            }
            head if head.starts_with(b"MDF     ") || head.starts_with(b"UnFinMF ") => {
                #[cfg(feature = "mdf")]
                return Ok(Self::Mdf);
                #[cfg(not(feature = "mdf"))]
                missing("MDF", "mdf")
            }
            _ => Ok(Self::Text),
        }
    }
}

/// A log that hands out its rows.
pub(super) trait Source {
    /// The file, for messages.
    fn file(&self) -> &Path;
    /// How it is written, in words.
    fn description(&self) -> String;
    /// The titles of its columns.
    fn titles(&self) -> &[Title];
    /// Comment lines and what else stands above the rows.
    fn remarks(&self) -> &[String];
    /// How much of it is done, and of how much: bytes, or rows.
    fn progress(&self) -> [u64; 2];
    /// The next row's cells of the columns `wanted` (indices in rising order) into `values`; NaN where there is none.
    fn next(&mut self, wanted: &[usize], values: &mut Vec<f64>) -> Result<Next, RecordingError>;
}

/// What came.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Next {
    /// A row of numbers, and the line where it stands.
    Row(u64),
    /// A row that cannot be read.
    Broken { line: u64, reason: Reason, message: String },
    /// Nothing is left.
    End,
}
