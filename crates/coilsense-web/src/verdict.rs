//! What `coilsense analyze` concludes of a spec: every condition under every damping, every sensor within its tolerances. Case by case, so that
//! the page can turn to a newer spec between two; what a change of the spec leaves as it was is not computed again.
//!
//! Next door: the case that is shown (`exact`), how it is concluded (`coilsense_lab::analysis`).

use coilsense_lab::analysis::{AnalysisError, Earlier, UnderWay};
use coilsense_lab::report::analysis_json;
use serde_json::{Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::Engine;
use crate::answer::Answer;

/// Judges one spec after the other.
#[wasm_bindgen]
#[derive(Default)]
pub struct Judge {
    under_way: Option<UnderWay>,
    /// What is known of cases while no spec is under way.
    earlier: Earlier,
}

#[wasm_bindgen]
impl Judge {
    /// One that has judged nothing yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Begins with a spec in place of the one that is under way; how many cases it has.
    ///
    /// # Errors
    /// What the spec's reader or the science says.
    pub fn begin(&mut self, engine: &Engine, text: &str) -> Result<usize, String> {
        let spec = engine.spec(text)?;
        self.give_up();
        let under_way = UnderWay::begin(spec, std::mem::take(&mut self.earlier)).map_err(line)?;
        let (_, count) = under_way.progress();
        self.under_way = Some(under_way);
        Ok(count)
    }

    /// Settles the next case and those known already; how many are settled.
    ///
    /// # Errors
    /// What the science says, or that nothing is under way.
    pub fn step(&mut self) -> Result<usize, String> {
        let under_way = self.under_way.as_mut().ok_or(NOTHING)?;
        loop {
            let computed = under_way.step().map_err(line)?;
            let (done, count) = under_way.progress();
            if computed || done == count {
                return Ok(done);
            }
        }
    }

    /// The verdict, as `coilsense analyze --json` prints it, without a date.
    ///
    /// # Errors
    /// As [`Self::step`].
    pub fn conclude(&mut self) -> Result<Answer, String> {
        let under_way = self.under_way.take().ok_or(NOTHING)?;
        let concluded = under_way.conclude().map_err(line)?;
        let text = analysis_json(&concluded.analysis, "").map_err(|error| error.to_string())?;
        self.earlier = concluded.earlier();
        let told: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
        Ok(Answer::new(&json!({ "json": told }), Vec::new()))
    }

    fn give_up(&mut self) {
        if let Some(under_way) = self.under_way.take() {
            self.earlier = under_way.earlier();
        }
    }
}

/// What a question says that comes without a spec.
const NOTHING: &str = "no spec is being judged";

fn line(error: AnalysisError) -> String {
    error.to_string()
}
