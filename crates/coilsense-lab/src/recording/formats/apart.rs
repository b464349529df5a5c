//! What of a file was not read, and why, for its description.
//!
//! Next door: the readers that leave something out (`tdms`, `matlab`).

use super::super::error::shortened;

/// What was left out.
#[derive(Debug, Default)]
pub(super) struct Apart(Vec<String>);

/// Most that is named.
const MOST: usize = 5;

impl Apart {
    /// One more of it.
    pub fn leave(&mut self, name: &str, why: &str) {
        self.0.push(format!("{} ({why})", shortened(name)));
    }

    /// The end of a description; empty where nothing was left out.
    pub fn told(&self) -> String {
        let named: Vec<&str> = self.0.iter().take(MOST).map(String::as_str).collect();
        match self.0.len().checked_sub(MOST) {
            _ if named.is_empty() => String::new(),
            None | Some(0) => format!("; not read: {}", named.join(", ")),
            Some(more) => format!("; not read: {}, and {more} more", named.join(", ")),
        }
    }
}
