//! Which column of a log is which channel, and how its text is written.
//!
//! Next door: the same as TOML (`mapping_file`), finding the columns in a file (`selection`).

use super::error::RecordingError;
use super::quantity::Quantity;
use super::title::Title;
use super::unit::Gain;
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
    /// Which sheet of a workbook is the log.
    pub sheet: Option<String>,
}

/// The columns of a quantity: one, or several of which the mean counts. In SI: mean · unit · `factor` + `offset`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Columns {
    /// Titles, names or `#3`; none where the column carries the quantity's name.
    pub titles: Vec<String>,
    pub unit: Option<String>,
    /// What the sensor's own signal means, in place of a unit.
    pub gain: Option<Gain>,
    pub factor: f64,
    pub offset: f64,
    /// The same value in every row \[SI\], in place of columns.
    pub constant: Option<f64>,
}

impl Columns {
    /// The column that carries the quantity's name.
    pub const BY_NAME: Self =
        Self { titles: Vec::new(), unit: None, gain: None, factor: 1.0, offset: 0.0, constant: None };

    /// One column as a title says it.
    pub fn titled(text: &str) -> Self {
        let title = Title::parse(text);
        // Where a number stands for the title, the unit is certainly none of it.
        Self { titles: vec![title.name], unit: title.unit, ..Self::BY_NAME }
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
        let (quantity, title) = named("column", "title [unit]", text)?;
        self.put(quantity, Columns::titled(title));
        Ok(())
    }

    /// Tells what a sensor's own signal means, as in `F_o=12.5 N/V`, or `F_o=12.5 N` for one of the column's numbers.
    ///
    /// # Errors
    /// [`RecordingError`] where it is not of that form, names no channel, or is not of that channel's dimension.
    pub fn set_gain(&mut self, text: &str) -> Result<(), RecordingError> {
        let (quantity, value) = named("gain", "12.5 N/V", text)?;
        let dimension = quantity.dimension();
        let gain = Gain::parse(dimension, value).ok_or_else(|| {
            let unit = dimension.si_unit();
            let allowed =
                format!("the gain must be so many {unit} for one V, mV, A, mV/V or count, such as \"12.5 {unit}/V\"");
            refused("gain", text, &allowed)
        })?;
        self.entry(quantity).gain = Some(gain);
        Ok(())
    }

    /// Tells what is added to a channel in the end, as in `F_o=0.2 N`.
    ///
    /// # Errors
    /// As [`Self::set_gain`].
    pub fn set_offset(&mut self, text: &str) -> Result<(), RecordingError> {
        let (quantity, value) = quantity_of("offset", text)?;
        self.entry(quantity).offset = value;
        Ok(())
    }

    /// Turns the sign of a channel, as in `F_o`.
    ///
    /// # Errors
    /// [`RecordingError`] for a name that is no channel's.
    pub fn set_negated(&mut self, name: &str) -> Result<(), RecordingError> {
        let channel = Quantity::named(name.trim()).and_then(|quantity| match quantity {
            Quantity::Time => Err("must be a channel; time has no sign to turn".to_owned()),
            channel => Ok(channel),
        });
        let quantity = channel.map_err(|allowed| refused("negate", name, &allowed))?;
        self.entry(quantity).factor *= -1.0;
        Ok(())
    }

    /// Tells a channel that is the same in every row, as in `u2=104 mm` of an end that is held.
    ///
    /// # Errors
    /// As [`Self::set_gain`]; for the time, too.
    pub fn set_constant(&mut self, text: &str) -> Result<(), RecordingError> {
        let (quantity, value) = quantity_of("constant", text)?;
        if quantity == Quantity::Time {
            return Err(refused("constant", text, "time cannot stand still"));
        }
        self.put(quantity, Columns { constant: Some(value), ..Columns::BY_NAME });
        Ok(())
    }

    /// Sets the columns of a quantity, in place of those set before.
    pub(super) fn put(&mut self, quantity: Quantity, columns: Columns) {
        self.columns.retain(|(other, _)| *other != quantity);
        self.columns.push((quantity, columns));
    }

    /// What is told of a quantity's columns; that they carry its name, where nothing is.
    fn entry(&mut self, quantity: Quantity) -> &mut Columns {
        let place = self.columns.iter().position(|(other, _)| *other == quantity).unwrap_or_else(|| {
            self.columns.push((quantity, Columns::BY_NAME));
            self.columns.len() - 1
        });
        &mut self.columns[place].1
    }

    /// Whether the column of a quantity is told.
    pub fn tells(&self, quantity: Quantity) -> bool {
        self.columns.iter().any(|(other, _)| *other == quantity)
    }
}

fn refused(option: &'static str, text: &str, message: &str) -> RecordingError {
    RecordingError::of_words(Message::from(Hint::Option(option, "")) + format!(" {text:?}: {message}"))
}

/// The quantity of `NAME=VALUE`, and the value's text.
fn named<'a>(option: &'static str, value: &str, text: &'a str) -> Result<(Quantity, &'a str), RecordingError> {
    let form = || refused(option, text, &format!("must be NAME=\"{value}\""));
    let (name, told) = text.split_once('=').ok_or_else(form)?;
    let quantity = Quantity::named(name.trim())
        .map_err(|allowed| refused(option, text, &format!("the name before = {allowed}")))?;
    let what = if option == "column" { "title" } else { "value" };
    if told.trim().is_empty() {
        Err(refused(option, text, &format!("the {what} behind = is missing")))
    } else {
        Ok((quantity, told.trim()))
    }
}

/// The quantity of `NAME=VALUE`, and the value in SI.
fn quantity_of(option: &'static str, text: &str) -> Result<(Quantity, f64), RecordingError> {
    let (quantity, told) = named(option, "0.2 N", text)?;
    let dimension = quantity.dimension();
    let value = dimension.parse(told).filter(|value| value.abs() <= quantity.largest());
    value.map(|value| (quantity, value)).ok_or_else(|| refused(option, text, &dimension.refusal(told)))
}
