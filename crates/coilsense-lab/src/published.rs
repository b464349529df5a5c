//! The paper's printed numbers, Tables II and III, as data.
//!
//! Next door: the same numbers computed (`reproduce`).

use coilsense::Channel;

use crate::condition::Condition;

/// Tables II and III as the paper prints them; compiled in so that the command works from any folder.
const FILES: [(Table, &str, &str); 2] = [
    (Table::Two, "data/paper/table-2.csv", include_str!(concat!(env!("OUT_DIR"), "/table-2.csv"))),
    (Table::Three, "data/paper/table-3.csv", include_str!(concat!(env!("OUT_DIR"), "/table-3.csv"))),
];

/// A table of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Table {
    /// Table II: RMSD.
    Two,
    /// Table III: maximum deviation.
    Three,
}

impl Table {
    /// The paper's numeral.
    pub fn numeral(self) -> &'static str {
        match self {
            Self::Two => "II",
            Self::Three => "III",
        }
    }
}

/// One printed cell.
#[derive(Debug, Clone, PartialEq)]
pub struct PublishedCell {
    /// Which table.
    pub table: Table,
    /// `S_T` or `S_A`.
    pub spring: String,
    /// Which condition.
    pub condition: Condition,
    /// F_i, F_o or F_L.
    pub force: Channel,
    /// The printed value \[% of F_nom\].
    pub percent: f64,
}

/// The data file is not as it must be; it is part of the program, so this is a fault of the program.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {message}")]
pub struct PublishedError {
    file: &'static str,
    message: String,
}

/// The columns of the files that hold values.
pub const COLUMNS: [Channel; 3] = [Channel::InputForce, Channel::OutputForce, Channel::InductanceForce];

/// All printed cells, in the paper's order: table, spring, condition, force.
///
/// # Errors
/// [`PublishedError`] where a data file is damaged.
pub fn published_cells() -> Result<Vec<PublishedCell>, PublishedError> {
    let mut cells = Vec::new();
    for (table, file, text) in FILES {
        let fault = |message: String| PublishedError { file, message };
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        for row in reader.records() {
            let row = row.map_err(|error| fault(error.to_string()))?;
            let field = |column: usize| row.get(column).unwrap_or_default();
            let condition =
                Condition::named(field(1)).ok_or_else(|| fault(format!("unknown condition {}", field(1))))?;
            for (column, force) in COLUMNS.into_iter().enumerate() {
                let text = field(2 + column);
                let percent = text.parse().map_err(|_| fault(format!("{text:?} must be a number")))?;
                cells.push(PublishedCell { table, spring: field(0).to_owned(), condition, force, percent });
            }
        }
    }
    Ok(cells)
}
