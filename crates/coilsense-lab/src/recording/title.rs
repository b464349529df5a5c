//! The title of a column: its name and unit as people write them in a header.
//!
//! Next door: where the header is (`layout`), which column is which channel (`selection`).

use super::unit;

/// A column's title.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Title {
    /// As it stands in the file; empty where the file has no header.
    pub text: String,
    /// Without its unit.
    pub name: String,
    /// Its unit, where one is given.
    pub unit: Option<String>,
    /// Whether it holds dates or times of day, which need no unit.
    pub stamps: bool,
}

impl Title {
    /// Reads `F_o [N]`, `F_o (N)`, `F_o/N`, `F_o in N` or `F_o`. Between square brackets anything is a unit; elsewhere only what is known as one.
    /// A title that is a unit spelled out is its own unit.
    pub fn parse(text: &str) -> Self {
        let text = text.trim();
        // As Rohde & Schwarz titles the time.
        if let Some(unit) = text.strip_prefix("in ").filter(|unit| unit::is_known(unit)) {
            return Self { text: text.to_owned(), name: text.to_owned(), unit: Some(unit.to_owned()), stamps: false };
        }
        let bracket = text.strip_suffix(']').and_then(|text| text.rsplit_once('['));
        let parted = bracket.or_else(|| {
            let round = text.strip_suffix(')').and_then(|text| text.rsplit_once('('));
            let all = [round, text.rsplit_once('/'), text.rsplit_once(" in "), text.rsplit_once(',')];
            all.into_iter().flatten().find(|(_, unit)| unit::is_known(unit.trim()))
        });
        let (name, unit) = match parted {
            Some((name, unit)) => (name.trim(), Some(unit.trim().to_owned()).filter(|unit| !unit.is_empty())),
            // Oscilloscopes write `Second` and `Volt` for titles.
            None => (text, Some(text.to_owned()).filter(|text| unit::is_spelled(text))),
        };
        Self { text: text.to_owned(), name: name.to_owned(), unit, stamps: false }
    }

    /// The unit of a cell below the header, such as `N` or `[N]`; `None` where the cell is none.
    pub(super) fn unit_below(cell: &str) -> Option<&str> {
        let inner = cell.trim().trim_start_matches(['[', '(']).trim_end_matches([']', ')']).trim();
        unit::is_known(inner).then_some(inner)
    }

    /// How messages call column `index` (from 0): `column 3 "LC [N]"`.
    pub(super) fn place(&self, index: usize) -> String {
        match self.text.is_empty() {
            true => format!("column {}", index + 1),
            false => format!("column {} {}", index + 1, super::error::clipped(&self.text)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Title;

    #[test]
    fn a_unit_stands_in_brackets_or_behind_a_stroke() {
        for text in ["F_o [N]", "F_o (N)", "F_o/N", "F_o in N", "F_o, N", "F_o[ N ]"] {
            let title = Title::parse(text);
            assert_eq!((title.name.as_str(), title.unit.as_deref()), ("F_o", Some("N")), "{text}");
        }
        assert_eq!(Title::parse("force [V]").unit.as_deref(), Some("V"));
        for text in ["force (left)", "and/or", "F_o"] {
            assert_eq!((Title::parse(text).name.as_str(), Title::parse(text).unit), (text, None));
        }
    }
}
