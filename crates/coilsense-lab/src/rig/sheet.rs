//! Columns of numbers as an instrument's logger writes them.
//!
//! Next door: where they come from (`log`), which files they become (`write`).

use std::fmt::Write as _;

/// A column of readings.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name: `time` or a signal's.
    pub name: &'static str,
    /// The unit in which it is written.
    pub unit: &'static str,
    /// That unit in SI.
    pub factor: f64,
    /// Decimals that are written; `None` for as many as bring back the same double.
    pub decimals: Option<usize>,
    /// The readings in SI, shape `rows`.
    pub values: Vec<f64>,
}

/// Columns of one length.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Time first.
    pub columns: Vec<Column>,
}

impl Sheet {
    /// The readings of a column in SI units.
    pub fn values(&self, name: &str) -> Option<&[f64]> {
        self.columns.iter().find(|column| column.name == name).map(|column| column.values.as_slice())
    }

    /// How many rows it has.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// As CSV under comment lines: a header `name [unit]`, one line per row.
    pub fn csv(&self, comments: &[String]) -> String {
        let mut text = String::with_capacity(200 + 30 * self.rows());
        for comment in comments {
            text.push_str("# ");
            text.push_str(comment);
            text.push('\n');
        }
        let titles: Vec<String> = self.columns.iter().map(|c| format!("{} [{}]", c.name, c.unit)).collect();
        text.push_str(&titles.join(","));
        text.push('\n');
        for row in 0..self.rows() {
            for (index, column) in self.columns.iter().enumerate() {
                if index > 0 {
                    text.push(',');
                }
                let value = column.values[row] / column.factor;
                // Writing to a String cannot fail.
                let _ = match column.decimals {
                    Some(decimals) => write!(text, "{value:.decimals$}"),
                    None => write!(text, "{value}"),
                };
            }
            text.push('\n');
        }
        text
    }
}
