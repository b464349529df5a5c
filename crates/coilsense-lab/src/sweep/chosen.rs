//! One row's design as a spec of its own.
//!
//! Next door: which values a row has (`plan`), a spec's text with values replaced (`crate::spec`).

use super::SweepError;
use super::plan::Plan;
use crate::spec::{Place, Spec, replaced};

impl Plan {
    /// The spec with a row's values in it, comments and all, as `coilsense analyze` reads it.
    ///
    /// # Errors
    /// [`SweepError`] for a row that is not there.
    pub fn spec_of(&self, row: u64) -> Result<String, SweepError> {
        if row >= self.rows() {
            return Err(SweepError::new(format!("row {row}: there are {}, counted from 0", self.rows())));
        }
        let settings = self.settings(row);
        let said: Vec<String> =
            settings.iter().map(|(target, setting)| format!("{} = {}", target.key, setting.0)).collect();
        let places: Vec<(&Place, &str)> =
            settings.iter().map(|(target, setting)| (&target.place, setting.0.as_str())).collect();
        let parameters = self.parameters();
        let text = replaced(&parameters.spec_file, &parameters.spec, &places)?;
        let said = said.join(", ").replace(char::is_control, " ");
        Ok(format!("# Row {row} of a sweep: {said}.\n{text}"))
    }

    /// The same, read: what the spec refuses is an error.
    ///
    /// # Errors
    /// [`SweepError`] with what the spec's reader says.
    pub fn design_of(&self, row: u64) -> Result<Spec, SweepError> {
        let text = self.spec_of(row)?;
        Ok(Spec::parse(&self.parameters().spec_file, &text, &|name| self.file(name))?)
    }
}
