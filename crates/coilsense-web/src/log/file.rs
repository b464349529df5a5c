//! A log as the page has it: a file that the worker reads piece by piece while the rows are parsed, so that never all of it is in memory.
//!
//! Next door: what is asked of it (`identified`, `calibrated`), who reads a log (`coilsense_lab::recording`).

use std::io::{BufReader, Error, Read};

use coilsense_lab::recording::Handed;
use wasm_bindgen::prelude::wasm_bindgen;

/// Pieces of the head are small and many; rows are read by the megabyte anyway, past this buffer.
const HEAD: usize = 1 << 16;

/// A log that somebody dropped.
#[wasm_bindgen]
#[derive(Debug)]
pub struct LogFile {
    log: Handed,
}

#[wasm_bindgen]
impl LogFile {
    /// The file of this number among those of a question; `size` in bytes. Only in a worker, which has the files.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str, number: u32, size: f64) -> Self {
        let pieces = BufReader::with_capacity(HEAD, Pieces { number, at: 0.0 });
        Self { log: Handed::new(name, pieces, size as u64) }
    }
}

impl LogFile {
    /// A text that is in memory.
    pub fn of_text(name: &str, text: Vec<u8>) -> Self {
        Self { log: Handed::text(name, text) }
    }

    pub(crate) fn handed(self) -> Handed {
        self.log
    }
}

/// Where the next piece of a file begins \[bytes\].
struct Pieces {
    number: u32,
    at: f64,
}

impl Read for Pieces {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Error> {
        let read = coilsense_read(self.number, self.at, buffer);
        self.at += f64::from(read);
        usize::try_from(read).map_err(|_| Error::other("it is a folder, or was moved or changed since it was given"))
    }
}

#[wasm_bindgen]
extern "C" {
    /// The worker's function that fills a buffer from a file: how many bytes, 0 at the end, or −1 where it cannot be read.
    #[wasm_bindgen(js_namespace = globalThis, js_name = coilsenseRead)]
    fn coilsense_read(number: u32, from: f64, buffer: &mut [u8]) -> i32;
}
