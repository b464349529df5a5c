//! What the two ends over frequency and the tabs *Log* and *Mitigate* ask: an engine twice as large, which a page loads once its first curves are
//! drawn (feature `workshop`).
//!
//! Next door: what every page asks (`door`), the answers (`log`, `mitigate`, `response`), the verdict (`verdict`).

use wasm_bindgen::prelude::wasm_bindgen;

use crate::answer::Answer;
use crate::log::LogFile;
use crate::{Engine, log, mitigate, response};

/// Of the noise in the simulated log: any, but always the same.
const TRIAL_SEED: u64 = 20_261_122;
/// What judges filters, in messages.
const MITIGATE: &str = "mitigate";

#[wasm_bindgen]
impl Engine {
    /// How a log is written, and its columns; `asked` is JSON, see [`log::Request`].
    ///
    /// # Errors
    /// One line, with the name of the log or the option.
    pub fn log_columns(&self, log: LogFile, asked: &str) -> Result<Answer, String> {
        log::columns(log, &log::Request::parse(asked)?)
    }

    /// What a log says, and a second device's beside it where there is one; `asked` is JSON, see [`log::Request`].
    ///
    /// # Errors
    /// One line, with the name of the log or the option and where it can be said line and column.
    pub fn identify(&self, log: LogFile, second: Option<LogFile>, asked: &str) -> Result<Answer, String> {
        log::identify(log, second, &log::Request::parse(asked)?)
    }

    /// Inductance over length of a log; `asked` is JSON, see [`log::Request`].
    ///
    /// # Errors
    /// One line, with the name of the log or the option and where it can be said line and column.
    pub fn calibrate(&self, log: LogFile, asked: &str) -> Result<Answer, String> {
        log::calibrate(log, &log::Request::parse(asked)?)
    }

    /// A simulated log of a spec's spring, at the length of a condition.
    ///
    /// # Errors
    /// What the spec's reader or the science says.
    pub fn trial_log(&self, text: &str, condition: usize, damping: usize) -> Result<Answer, String> {
        log::trial(&self.spec_without_contact(text, "a simulated log")?, condition, damping, TRIAL_SEED)
    }

    /// The two ends over frequency, see [`response::curve()`]; `masses`: for each winding, as the exact case has them. Windings that meet are left out.
    ///
    /// # Errors
    /// What the spec's reader or the science says.
    pub fn response(&self, text: &str, condition: usize, damping: usize, masses: usize) -> Result<Answer, String> {
        response::curve(&self.spec(text)?, response::Asked { condition, damping, masses })
    }

    /// The same at one frequency \[Hz\], with `places` of the coil as they move, see [`response::at`].
    ///
    /// # Errors
    /// As [`Self::response`], or what of the question is out of range.
    pub fn response_at(
        &self,
        text: &str,
        condition: usize,
        damping: usize,
        masses: usize,
        frequency: f64,
        places: usize,
    ) -> Result<Answer, String> {
        response::at(&self.spec(text)?, response::Asked { condition, damping, masses }, frequency, places)
    }

    /// What to do about the ringing of a spec's conditions; `asked` is JSON with the command's options, see [`mitigate::asked`].
    ///
    /// # Errors
    /// What the spec's reader or the science says, behind `option: ` where it is about one.
    pub fn mitigate(&self, text: &str, asked: &str) -> Result<Answer, String> {
        mitigate::run(&self.spec_without_contact(text, MITIGATE)?, &log::Request::parse(asked)?, &tell)
    }

    /// The same on a log.
    ///
    /// # Errors
    /// As [`Self::mitigate`]; for the log with its name, and where it can be said line and column.
    pub fn mitigate_log(&self, text: &str, asked: &str, log: LogFile) -> Result<Answer, String> {
        mitigate::run_on(&self.spec_without_contact(text, MITIGATE)?, &log::Request::parse(asked)?, log, &tell)
    }

    /// What those options are where nothing is said, and what is wrong with those that are given.
    ///
    /// # Errors
    /// What the spec's reader says.
    pub fn mitigate_usual(&self, text: &str, asked: &str) -> Result<Answer, String> {
        mitigate::usual(&self.spec_without_contact(text, MITIGATE)?, &log::Request::parse(asked)?)
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
