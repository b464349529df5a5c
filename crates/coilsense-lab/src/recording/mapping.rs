//! Which column of a log is which channel, and how its text is written.
//!
//! Next door: the same as TOML (`mapping_file`), finding the columns in a file (`selection`).

use super::error::RecordingError;
use super::quantity::Quantity;
use super::title::Title;
use crate::message::{Hint, Message};

/// Which column is which channel. Columns that carry a channel's name need no entry.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mapping {
    /// How the text is written, where that is told.
    pub format: Format,
    /// The columns that are told, in no order.
    pub(super) columns: Vec<(Quantity, Columns)>,
}

/// How a text is written; what is `None` is found out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Format {
    /// What parts the columns: a character, or a space for any number of spaces and tabs.
    pub delimiter: Option<char>,
    /// Whether decimals stand behind a comma.
    pub decimal_comma: Option<bool>,
    /// Whether titles stand above the columns.
    pub header: Option<bool>,
    /// What comment lines begin with, beside `#`, `%` and `//`.
    pub comment: Option<String>,
    /// So many rows at the beginning are left out.
    pub skip: u64,
    /// Samples per second \[Hz\], in place of a time column: row 0 is at 0 s.
    pub sample_rate: Option<f64>,
}

/// The columns of a quantity: one, or several of which the mean counts. In SI: mean · unit · `factor` + `offset`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Columns {
    /// Titles, names or `#3`.
    pub titles: Vec<String>,
    pub unit: Option<String>,
    /// SI units for one of the column's numbers, in place of a unit.
    pub gain: Option<f64>,
    pub factor: f64,
    pub offset: f64,
}

impl Columns {
    /// One column as a title says it.
    pub fn titled(text: &str) -> Self {
        let title = Title::parse(text);
        // Where a number stands for the title, the unit is certainly none of it.
        Self { titles: vec![title.name], unit: title.unit, gain: None, factor: 1.0, offset: 0.0 }
    }
}

/// Formats of other people's logs, by name.
pub const PRESETS: [(&str, &str); 1] = [(
    "lab-data",
    "[log]
header = false
delimiter = \";\"
skip = 1
[columns]
u2 = \"#4 [mm]\"
L = { columns = [\"#6\", \"#8\", \"#10\", \"#12\", \"#14\", \"#16\", \"#18\", \"#20\", \"#22\", \"#24\"], unit = \"H\" }
",
)];

impl Mapping {
    /// The mapping of a known format: `lab-data` (no header, `;`, displacement \[mm\] in column 4, ten pairs of resistance and inductance from
    /// column 5 on, the first row left out).
    ///
    /// # Errors
    /// [`RecordingError`] for a name that is not known.
    pub fn preset(name: &str) -> Result<Self, RecordingError> {
        let Some((name, text)) = PRESETS.iter().find(|(known, _)| *known == name) else {
            let known = PRESETS.map(|(name, _)| name).join(", ");
            let text = format!(": no preset of that name; there are: {known}");
            return Err(RecordingError::of_words(Message::from(Hint::Value("preset", name.to_owned())) + text));
        };
        Self::parse(name, text)
    }

    /// Tells the column of a quantity, as in `F_o=LC [N]` or `F_o=#3 [N]`.
    ///
    /// # Errors
    /// [`RecordingError`] where it is not of that form or names no channel.
    pub fn set(&mut self, text: &str) -> Result<(), RecordingError> {
        let refused = |message: &str| {
            RecordingError::of_words(Message::from(Hint::Option("column", "")) + format!(" {text:?}: {message}"))
        };
        let (name, title) = text.split_once('=').ok_or_else(|| refused("must be NAME=\"title [unit]\""))?;
        let quantity =
            Quantity::named(name.trim()).map_err(|allowed| refused(&format!("the name before = {allowed}")))?;
        if title.trim().is_empty() {
            return Err(refused("the title behind = is missing"));
        }
        self.put(quantity, Columns::titled(title));
        Ok(())
    }

    /// Sets the columns of a quantity, in place of those set before.
    pub(super) fn put(&mut self, quantity: Quantity, columns: Columns) {
        self.columns.retain(|(other, _)| *other != quantity);
        self.columns.push((quantity, columns));
    }

    /// Whether the column of a quantity is told.
    pub fn tells(&self, quantity: Quantity) -> bool {
        self.columns.iter().any(|(other, _)| *other == quantity)
    }
}
