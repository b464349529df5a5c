//! A log that is handed over piece by piece under a name, as a browser does it: there is no path to open, and never all of it in memory.
//!
//! Next door: what is read from paths and pipes (`input`), who takes it (`formats`).

use std::io::{Cursor, Read};
use std::path::PathBuf;

use super::packing::Bytes;

/// A name for messages, the bytes in their order, and how many there are.
pub struct Handed {
    pub(super) name: PathBuf,
    pub(super) bytes: Bytes,
    pub(super) size: u64,
}

impl Handed {
    /// From whatever can be read; `size` is in bytes, 0 where nobody knows.
    pub fn new(name: &str, bytes: impl Read + Send + 'static, size: u64) -> Self {
        Self { name: name.into(), bytes: Box::new(bytes), size }
    }

    /// A text that is in memory already.
    pub fn text(name: &str, text: Vec<u8>) -> Self {
        let size = text.len() as u64;
        Self::new(name, Cursor::new(text), size)
    }
}

impl std::fmt::Debug for Handed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Handed").field("name", &self.name).field("size", &self.size).finish_non_exhaustive()
    }
}
