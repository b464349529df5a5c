//! A text as a cell of a CSV file that a spreadsheet may open.
//!
//! Next door: who writes such files (`csv`, `stream`, `report`).

use std::borrow::Cow;

/// A text that a spreadsheet would take for a formula, with an apostrophe in front; any other as it is. Numbers are no texts.
pub(crate) fn text_cell(text: &str) -> Cow<'_, str> {
    // As OWASP lists them, the wide forms of the same signs included.
    let first = ['=', '+', '-', '@', '\t', '\r', '\n', '＝', '＋', '－', '＠'];
    if text.starts_with(first) { format!("'{text}").into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::text_cell;

    #[test]
    fn what_a_spreadsheet_would_compute_is_told_to_be_a_text() {
        for text in ["=cmd|' /C calc'!A0", "+1 mm", "-20 °C", "@SUM(A1)", "\t=1", "\r=1", "＝1"] {
            assert_eq!(text_cell(text), format!("'{text}"));
        }
        for text in ["heel strike", "0.01", "a=b", "1-2", "'=1", "", " =1"] {
            assert_eq!(text_cell(text), text);
        }
    }
}
