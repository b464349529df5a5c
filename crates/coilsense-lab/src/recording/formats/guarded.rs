//! A damaged file that a decoder of someone else's trips over is an error, and no fall.
//!
//! Next door: the readers that hand bytes to such decoders (`parquet`, `matlab`, `mdf`).

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::path::Path;
use std::sync::Once;

use super::super::error::RecordingError;

thread_local! {
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// What a decoder gives; where it panics, that the file is damaged, without a word on standard error.
///
/// What it borrowed must not be read on after that.
pub(super) fn guarded<T>(file: &Path, decode: impl FnOnce() -> Result<T, RecordingError>) -> Result<T, RecordingError> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            if !GUARDED.get() {
                before(panic);
            }
        }));
    });
    let outer = GUARDED.replace(true);
    let decoded = panic::catch_unwind(AssertUnwindSafe(decode));
    GUARDED.set(outer);
    decoded.unwrap_or_else(|_| Err(RecordingError::of_file(file, "is damaged and cannot be read")))
}
