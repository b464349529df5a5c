//! Files that are compressed as a whole: by which program, and what they hold, as a stream.
//!
//! Next door: where the bytes come from (`input`).

use std::fmt;
use std::io::{self, Read};

/// Bytes that come one after the other.
pub(super) type Bytes = Box<dyn Read + Send>;

/// What a file is compressed by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Packing {
    /// gzip, of any number of members, as bgzip writes them too.
    Gzip,
    /// Zstandard, of any number of frames.
    Zstd,
}

/// What is wrong with bytes as they are, beside what the system says.
#[derive(Debug)]
struct Spoilt(String);

impl fmt::Display for Spoilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Spoilt {}

/// An error of reading that says all there is to say, as in "is cut off".
pub(super) fn spoilt(message: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, Spoilt(message))
}

/// What an error of reading says of a file, after its name.
pub(super) fn told(error: &io::Error) -> String {
    match error.get_ref().and_then(|inner| inner.downcast_ref::<Spoilt>()) {
        Some(Spoilt(message)) => message.clone(),
        None => format!("cannot be read: {error}"),
    }
}

impl Packing {
    /// By how a file begins.
    pub fn of(head: &[u8]) -> Option<Self> {
        match head {
            [0x1f, 0x8b, ..] => Some(Self::Gzip),
            // A frame, or one that is to be skipped, such as pzstd begins with.
            [0x28, 0xb5, 0x2f, 0xfd, ..] | [0x50..=0x5f, 0x2a, 0x4d, 0x18, ..] => Some(Self::Zstd),
            _ => None,
        }
    }

    /// Its program.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gzip => "gzip",
            Self::Zstd => "zstd",
        }
    }

    /// What is in it; errors of reading say whether it is cut off or damaged.
    pub fn unpacked(self, packed: Bytes) -> Result<Bytes, String> {
        let name = self.name();
        let inner = match self {
            Self::Gzip => of_gzip(packed),
            Self::Zstd => of_zstd(packed),
        };
        let inner = inner.ok_or_else(|| {
            format!("is compressed by {name}, which this build cannot read: it was made without the feature {name}")
        })?;
        Ok(Box::new(Unpacking { inner: inner.map_err(|error| told(&error))?, name }))
    }
}

/// What gzip packed; `None` where that is not built.
#[cfg(feature = "gzip")]
fn of_gzip(packed: Bytes) -> Option<io::Result<Bytes>> {
    Some(Ok(Box::new(flate2::read::MultiGzDecoder::new(packed))))
}

#[cfg(not(feature = "gzip"))]
fn of_gzip(_packed: Bytes) -> Option<io::Result<Bytes>> {
    None
}

/// What zstd packed; `None` where that is not built.
#[cfg(feature = "zstd")]
fn of_zstd(packed: Bytes) -> Option<io::Result<Bytes>> {
    Some(zstd::Decoder::new(packed).map(|decoder| Box::new(decoder) as Bytes))
}

#[cfg(not(feature = "zstd"))]
fn of_zstd(_packed: Bytes) -> Option<io::Result<Bytes>> {
    None
}

/// A decompressor whose errors are told in plain words.
struct Unpacking {
    inner: Bytes,
    name: &'static str,
}

impl Read for Unpacking {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let name = self.name;
        self.inner.read(buffer).map_err(|error| match error.kind() {
            io::ErrorKind::Interrupted => error,
            io::ErrorKind::UnexpectedEof => spoilt(format!("is cut off: its {name} data break off before their end")),
            // The system's own.
            _ if error.raw_os_error().is_some() => error,
            _ => spoilt(format!("is damaged: its {name} data cannot be unpacked ({error})")),
        })
    }
}
