//! A damaged file that a decoder of someone else's trips over is an error, and no fall.
//!
//! Next door: the readers that hand bytes to such decoders (`recording::formats`, `sweep::encoded`, `sweep::catalogue`).

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::sync::Once;

thread_local! {
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// That a file is damaged so that its decoder fell over it.
#[derive(Debug)]
pub(crate) struct Damaged {
    /// The file.
    pub file: PathBuf,
}

impl Damaged {
    /// What is said of the file.
    pub const WORDS: &str = "is damaged and cannot be read";
}

impl From<Damaged> for String {
    fn from(_: Damaged) -> Self {
        Damaged::WORDS.to_owned()
    }
}

/// What a decoder gives; where it panics, that the file is damaged, without a word on standard error.
///
/// What it borrowed must not be read on after that.
pub(crate) fn guarded<T, E: From<Damaged>>(file: &Path, decode: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
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
    decoded.unwrap_or_else(|_| Err(Damaged { file: file.to_owned() }.into()))
}
