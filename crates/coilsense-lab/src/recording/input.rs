//! What a log is read from: a file, a pipe, or standard input (`-`), each of them compressed or not.
//!
//! A reader of a format takes an [`Input`] and says what it needs: the bytes one after the other, a file to seek in, or all in memory. What comes
//! through a pipe or is compressed goes into a nameless temporary file where a reader has to seek; it is gone however the program ends.
//!
//! Next door: decompression (`packing`), who takes it (`formats`, `text`).

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::error::RecordingError;
use super::handed::Handed;
use super::packing::{Bytes, Packing, told};

/// An opened log of which nothing but the first bytes was looked at.
pub(super) struct Input {
    path: PathBuf,
    packing: Option<Packing>,
    /// How it begins, unpacked.
    head: Vec<u8>,
    rest: Rest,
    /// Bytes that there are, 0 where nobody knows, and how many of them were read.
    size: u64,
    done: Arc<AtomicU64>,
}

/// What can be read behind the head.
enum Rest {
    /// A plain file, in which one can seek.
    File(Counted<File>),
    /// What comes once only.
    Stream(Bytes),
}

/// A log's bytes from the first on.
pub(super) struct Stream {
    pub bytes: Bytes,
    /// Bytes that there are as the file lies there, 0 where nobody knows, and how many of them were read.
    pub size: u64,
    pub done: Arc<AtomicU64>,
    /// What it was compressed by.
    pub packing: Option<Packing>,
}

/// How much of a file a format may be told by.
const HEAD: u64 = 4096;
/// Most bytes that are written aside for a reader that has to seek; where temporary files lie in memory, that is memory.
const MOST_ASIDE: u64 = 4 << 30;
/// The path that means standard input.
const STANDARD_INPUT: &str = "-";

impl Input {
    /// Opens a path and looks at its first bytes. A pipe is waited for.
    pub fn open(path: &Path) -> Result<Self, RecordingError> {
        let done = Arc::new(AtomicU64::new(0));
        if path == Path::new(STANDARD_INPUT) {
            let bytes = Counted { inner: io::stdin(), done: done.clone() };
            return Self::begin(Path::new("standard input"), Rest::Stream(Box::new(bytes)), 0, done);
        }
        let file = crate::input::open(path).map_err(|error| unreadable(path, &error))?;
        let plain = file.metadata().ok().filter(std::fs::Metadata::is_file);
        let file = Counted { inner: file, done: done.clone() };
        match plain {
            Some(metadata) => Self::begin(path, Rest::File(file), metadata.len(), done),
            None => Self::begin(path, Rest::Stream(Box::new(file)), 0, done),
        }
    }

    fn begin(path: &Path, mut rest: Rest, size: u64, done: Arc<AtomicU64>) -> Result<Self, RecordingError> {
        let mut head = beginning(path, rest.as_read())?;
        let packing = Packing::of(&head);
        if let Some(packing) = packing {
            let packed = Box::new(io::Cursor::new(head).chain(rest.into_stream()));
            let mut bytes = packing.unpacked(packed).map_err(|message| RecordingError::of_file(path, message))?;
            head = beginning(path, &mut bytes)?;
            rest = Rest::Stream(bytes);
        }
        Ok(Self { path: path.to_owned(), packing, head, rest, size, done })
    }

    /// A text that is handed over. It is read as it is: what is compressed is refused by the reader of texts.
    pub fn of_handed(log: Handed) -> Result<Self, RecordingError> {
        let done = Arc::new(AtomicU64::new(0));
        let mut rest = Rest::Stream(Box::new(Counted { inner: log.bytes, done: done.clone() }));
        let head = beginning(&log.name, rest.as_read())?;
        Ok(Self { path: log.name, packing: None, head, rest, size: log.size, done })
    }

    /// What it is called in messages.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The first 4096 bytes, unpacked; fewer where there are no more.
    pub fn head(&self) -> &[u8] {
        &self.head
    }

    /// Its bytes, unpacked, one after the other: for what fits into no memory.
    pub fn stream(self) -> Stream {
        let bytes = Box::new(io::Cursor::new(self.head).chain(self.rest.into_stream()));
        Stream { bytes, size: self.size, done: self.done, packing: self.packing }
    }

    /// Lets `look` seek in all of it; what comes once only is put into a temporary file for that, from which it then comes.
    #[cfg(feature = "matlab")]
    pub fn in_file<T>(&mut self, look: impl FnOnce(&mut File) -> T) -> Result<T, RecordingError> {
        let failed = |error: io::Error| unreadable(&self.path, &error);
        if let Rest::Stream(stream) = &mut self.rest {
            let mut bytes = io::Cursor::new(self.head.as_slice()).chain(stream);
            let inner = aside(&self.path, &mut bytes)?;
            self.rest = Rest::File(Counted { inner, done: self.done.clone() });
        }
        let head = self.head.len() as u64;
        match &mut self.rest {
            Rest::File(Counted { inner, .. }) => {
                let found = look(inner);
                inner.seek(SeekFrom::Start(head)).map_err(failed)?;
                Ok(found)
            }
            Rest::Stream(_) => Err(RecordingError::of_file(&self.path, "cannot be put into a file")),
        }
    }

    /// A file to seek in, at its beginning: the log itself, or a temporary one of what is in it.
    #[cfg_attr(not(feature = "parquet"), allow(dead_code, reason = "the formats that need it may be left out"))]
    pub fn file(self) -> Result<File, RecordingError> {
        let path = self.path;
        let failed = |error: io::Error| unreadable(&path, &error);
        let stream = match self.rest {
            Rest::File(Counted { mut inner, .. }) => {
                inner.seek(SeekFrom::Start(0)).map_err(failed)?;
                return Ok(inner);
            }
            Rest::Stream(stream) => stream,
        };
        aside(&path, &mut io::Cursor::new(self.head).chain(stream))
    }

    /// All of it in memory, where it is at most `most` bytes.
    ///
    /// `kind` says what it is, after "is", in the message that it is larger.
    #[cfg_attr(not(feature = "matlab"), allow(dead_code, reason = "the formats that need it may be left out"))]
    #[cfg(any(feature = "mdf", feature = "sheets"))]
    pub fn bytes(self, most: u64, kind: &str) -> Result<Vec<u8>, RecordingError> {
        let path = self.path.clone();
        let mut bytes = Vec::new();
        let read = self.stream().bytes.take(most.saturating_add(1)).read_to_end(&mut bytes);
        read.map_err(|error| unreadable(&path, &error))?;
        if bytes.len() as u64 > most {
            let most = most >> 20;
            let message =
                format!("is {kind} of more than {most} MiB, which is read as a whole; save its columns as Parquet");
            return Err(RecordingError::of_file(&path, message));
        }
        Ok(bytes)
    }
}

impl Rest {
    fn as_read(&mut self) -> &mut dyn Read {
        match self {
            Self::File(file) => file,
            Self::Stream(stream) => stream,
        }
    }

    fn into_stream(self) -> Bytes {
        match self {
            Self::File(file) => Box::new(file),
            Self::Stream(stream) => stream,
        }
    }
}

/// A temporary file of all these bytes, at its beginning.
fn aside(path: &Path, bytes: &mut dyn Read) -> Result<File, RecordingError> {
    let failed = |error: io::Error| unreadable(path, &error);
    let aside = |error: io::Error| {
        RecordingError::of_file(path, format!("cannot be put into a temporary file to be read: {error}"))
    };
    let mut file = tempfile::tempfile().map_err(aside)?;
    let mut bytes = bytes.take(MOST_ASIDE + 1);
    let mut block = vec![0; 1 << 16];
    let mut there = 0;
    loop {
        // Apart, so that what is wrong with the log is not taken for a full disk.
        let read = match bytes.read(&mut block) {
            Ok(0) => break,
            Ok(read) => read,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(failed(error)),
        };
        there += read as u64;
        if there > MOST_ASIDE {
            let message = "holds more than 4 GiB and can be read from a plain file only; unpack it into one";
            return Err(RecordingError::of_file(path, message));
        }
        io::Write::write_all(&mut file, &block[..read]).map_err(aside)?;
    }
    file.seek(SeekFrom::Start(0)).map_err(aside)?;
    Ok(file)
}

/// The first bytes.
fn beginning(path: &Path, bytes: &mut dyn Read) -> Result<Vec<u8>, RecordingError> {
    let mut head = Vec::new();
    bytes.take(HEAD).read_to_end(&mut head).map_err(|error| unreadable(path, &error))?;
    Ok(head)
}

/// That a file cannot be read, and why.
pub(super) fn unreadable(path: &Path, error: &io::Error) -> RecordingError {
    RecordingError::of_file(path, told(error))
}

/// Counts what is read.
struct Counted<R> {
    inner: R,
    done: Arc<AtomicU64>,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.inner.read(buffer)?;
        self.done.fetch_add(read as u64, Ordering::Relaxed);
        Ok(read)
    }
}
