//! How a text is written: what parts its columns, its decimal sign, where its titles are. Told by the mapping, else found out from its
//! first lines.
//!
//! Next door: how that is found out (`trial`), single cells (`cell`), the rows below (`text`).

use super::cell::{Delimiter, words};
use super::error::shortened;
use super::mapping::Format;
use super::title::Title;

/// How a text is written.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layout {
    pub delimiter: Delimiter,
    pub decimal_comma: bool,
    /// One for each column.
    pub titles: Vec<Title>,
    /// Line of the titles, where there is one.
    pub header: Option<u64>,
    /// Line of the first row of numbers.
    pub first_row: u64,
    /// Least cells of a row: the last columns may be left out.
    pub shortest: usize,
    /// What ends the head of a further segment, behind which titles stand again; such heads begin with `Channels`.
    pub segments: Option<&'static [u8]>,
    /// The clock that the head tells.
    pub clock: Option<FileClock>,
    /// Comment lines and what else stands above, without marks.
    pub remarks: Vec<String>,
}

/// The clock of a log whose head tells it: row n is at start + n · interval \[s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FileClock {
    pub start: f64,
    pub interval: f64,
}

/// A line and its number.
pub(super) type Line<'a> = (u64, &'a [u8]);

/// Most columns of a log.
pub(super) const MOST_COLUMNS: usize = 10_000;

/// What follows the mark of a comment line; `None` where it is none.
pub(super) fn comment<'a>(line: &'a [u8], own: Option<&str>) -> Option<&'a [u8]> {
    let line = line.trim_ascii_start();
    let own = own.map(str::as_bytes).and_then(|mark| line.strip_prefix(mark));
    own.or(match line {
        [b'#' | b'%', rest @ ..] | [b'/', b'/', rest @ ..] => Some(rest),
        _ => None,
    })
}

impl Layout {
    /// In words, for people.
    pub fn description(&self) -> String {
        let parted = match self.delimiter {
            Delimiter::Space => "spaces".to_owned(),
            Delimiter::Sign(b'\t') => "tabs".to_owned(),
            Delimiter::Sign(sign) => format!("\"{}\"", char::from(sign)),
        };
        let decimal = if self.decimal_comma { ", decimal comma" } else { "" };
        let header = self.header.map_or("no header".to_owned(), |line| format!("header in line {line}"));
        format!("text, columns separated by {parted}{decimal}, {header}")
    }
}

/// Most remarks that are kept.
const MOST_REMARKS: usize = 1000;

/// Comment lines and what else stands above the rows.
pub(super) fn remarks(head: &[Line<'_>], first_row: u64, header: Option<u64>, format: &Format) -> Vec<String> {
    let own = format.comment.as_deref();
    // Below the titles stands their units row, which is none.
    let is_remark = |line: u64, text: &[u8]| comment(text, own).is_some() || header.is_none_or(|header| line < header);
    let above = head.iter().filter(|(line, text)| *line < first_row && Some(*line) != header && is_remark(*line, text));
    let texts = above.map(|(_, text)| words(comment(text, own).unwrap_or(text)));
    texts.filter(|text| !text.is_empty()).take(MOST_REMARKS).map(|text| shortened_remark(&text)).collect()
}

fn shortened_remark(text: &str) -> String {
    if text.chars().count() <= 500 { text.to_owned() } else { shortened(text) }
}
