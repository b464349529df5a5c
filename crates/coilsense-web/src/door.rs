//! The door to JavaScript: an engine that holds the files that specs may name, and answers one question at a time.
//!
//! Next door: the answers (`preview`, `exact`, `modes`, `paper`).

use std::collections::BTreeMap;
use std::sync::Arc;

use coilsense_lab::series::{self, Format};
use coilsense_lab::spec::{Recordings, Spec};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::answer::Answer;
use crate::exact::Exact;
use crate::{catalogue, modes, paper, preview};

/// Name of the page's spec in messages.
const NAME: &str = "spec";

/// What answers the page. An error is one line of text, which for a spec begins with `spec:LINE:`.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Engine {
    files: BTreeMap<String, String>,
    /// Those of them that a spec has named, parsed: a slider asks for the same road at every step.
    recordings: Arc<Recordings>,
}

#[wasm_bindgen]
impl Engine {
    /// An engine without files.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives a file that specs may name: a recorded motion.
    pub fn add_file(&mut self, name: String, text: String) {
        self.files.insert(name, text);
        self.recordings = Arc::default();
    }

    /// Curves of a case between two times \[s\], fit to be drawn: at most `samples` (2 to 2000) times, L to second order.
    ///
    /// # Errors
    /// What the spec's reader or the science says.
    pub fn preview(
        &self,
        text: &str,
        condition: usize,
        damping: usize,
        from: f64,
        to: f64,
        samples: usize,
    ) -> Result<Answer, String> {
        preview::run(&self.spec(text)?, condition, damping, (from, to), samples)
    }

    /// A case as `coilsense analyze` computes it.
    ///
    /// # Errors
    /// What the spec's reader or the science says.
    pub fn exact(&self, text: &str, condition: usize, damping: usize) -> Result<Answer, String> {
        Exact::run(&self.spec(text)?, condition, damping).map(|exact| exact.answer())
    }

    /// Lines of the coil's modes at so many lengths (2 to 200) over those in use.
    ///
    /// # Errors
    /// What the spec's reader says, or why the coil is no helix.
    pub fn modes(&self, text: &str, lengths: usize) -> Result<Answer, String> {
        modes::lines(&self.spec(text)?, lengths)
    }

    /// The modes at a length \[m\], and one of them, by its number from 1, as the wire moves in it, at so many points a winding (1 to 64).
    ///
    /// # Errors
    /// As [`Self::modes`], or what of the question is out of range.
    pub fn mode_shape(
        &self,
        text: &str,
        length: f64,
        loosest: bool,
        number: usize,
        points: usize,
    ) -> Result<Answer, String> {
        modes::shape(&self.spec(text)?, modes::Asked { length, loosest, number, points })
    }

    /// The case's series as `coilsense simulate` writes them.
    ///
    /// # Errors
    /// What the spec's reader or the science says.
    pub fn csv(&self, text: &str, condition: usize, damping: usize) -> Result<Vec<u8>, String> {
        let spec = self.spec(text)?;
        let exact = Exact::run(&spec, condition, damping)?;
        let mut bytes = Vec::new();
        let run = exact.single.case.series(&spec, &spec.sensors);
        series::write(&[run], Format::Csv, &mut bytes).map_err(|error| error.to_string())?;
        Ok(bytes)
    }

    /// Materials and classes of sensors that a spec may name, as JSON.
    ///
    /// # Errors
    /// None but that of a damaged program.
    pub fn catalogue(&self) -> Result<String, String> {
        catalogue::text()
    }

    /// Tables II and III and Figs. 2 and 4 of the paper, computed.
    ///
    /// # Errors
    /// What the science says, which of the paper's own springs it does not.
    pub fn paper(&self) -> Result<Answer, String> {
        paper::run()
    }
}

impl Engine {
    pub(crate) fn spec(&self, text: &str) -> Result<Spec, String> {
        let files = |name: &str| self.files.get(name).cloned().ok_or_else(|| format!("{name} is not on this page"));
        let spec = Spec::parse_sharing(NAME, text, &files, &self.recordings).map_err(|error| error.to_string())?;
        spec.needs_chain("the page").map_err(|error| error.to_string())?;
        if !cfg!(feature = "workshop") {
            spec.needs_no_contact("the page").map_err(|error| error.to_string())?;
        }
        if spec.cam.is_some() {
            return Err(format!(
                "{NAME}: [cam]: the page turns no camshaft: a law is for `coilsense speed`, a recorded cycle (kind = \"recorded\") has its speed here"
            ));
        }
        Ok(spec)
    }

    /// The same for `what` takes no windings that meet.
    #[cfg(feature = "workshop")]
    pub(crate) fn spec_without_contact(&self, text: &str, what: &str) -> Result<Spec, String> {
        let spec = self.spec(text)?;
        spec.needs_no_contact(what).map_err(|error| error.to_string())?;
        Ok(spec)
    }
}
