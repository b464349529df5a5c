//! What the tabs *Log* and *Mitigate* ask: an engine twice as large, which a page loads only with them (feature `workshop`).
//!
//! Next door: what every page asks (`door`), the answers (`log`, `mitigate`).

use wasm_bindgen::prelude::wasm_bindgen;

use crate::answer::Answer;
use crate::{Engine, log, mitigate};

#[wasm_bindgen]
impl Engine {
    /// How the text of a log is written, and its columns.
    ///
    /// # Errors
    /// One line, with the log's name.
    pub fn log_columns(&self, name: &str, text: Vec<u8>) -> Result<Answer, String> {
        log::columns(name, text)
    }

    /// What a log says; `asked` is JSON, see [`log::Asked`].
    ///
    /// # Errors
    /// One line, with the log's name and where it can be said line and column.
    pub fn identify(&self, name: &str, text: Vec<u8>, asked: &str) -> Result<Answer, String> {
        log::identify(name, text, &log::Asked::parse(asked)?)
    }

    /// Inductance over length of a log; `asked` is JSON, see [`log::Asked`].
    ///
    /// # Errors
    /// One line, with the log's name and where it can be said line and column.
    pub fn calibrate(&self, name: &str, text: Vec<u8>, asked: &str) -> Result<Answer, String> {
        log::calibrate(name, text, &log::Asked::parse(asked)?)
    }

    /// What to do about the ringing of a spec's conditions; `asked` is JSON with the command's options, see [`mitigate::asked`].
    ///
    /// # Errors
    /// What the spec's reader or the science says, behind `option: ` where it is about one.
    pub fn mitigate(&self, text: &str, asked: &str) -> Result<Answer, String> {
        mitigate::run(&self.spec(text)?, &log::Asked::parse(asked)?, &tell)
    }

    /// The same on a log.
    ///
    /// # Errors
    /// As [`Self::mitigate`]; for the log with its name, and where it can be said line and column.
    pub fn mitigate_log(&self, text: &str, asked: &str, name: &str, log: Vec<u8>) -> Result<Answer, String> {
        mitigate::run_on(&self.spec(text)?, &log::Asked::parse(asked)?, (name, log), &tell)
    }

    /// What those options are where nothing is said, and what is wrong with those that are given.
    ///
    /// # Errors
    /// What the spec's reader says.
    pub fn mitigate_usual(&self, text: &str, asked: &str) -> Result<Answer, String> {
        mitigate::usual(&self.spec(text)?, &log::Asked::parse(asked)?)
    }
}

#[wasm_bindgen]
extern "C" {
    /// The worker's function that hears how much is done.
    #[wasm_bindgen(js_namespace = globalThis, js_name = coilsenseTold)]
    fn coilsense_told(done: u32, of: u32);
}

/// Tells the worker; there is none where the engine is tested without a browser.
fn tell(done: usize, of: usize) {
    if cfg!(target_family = "wasm") {
        coilsense_told(done as u32, of as u32);
    }
}
