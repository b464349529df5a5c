//! How a text is written: what parts its columns, its decimal sign, where its titles are. Told by the mapping, else found out from its
//! first lines.
//!
//! Next door: one way of parting it (`trial`), single cells (`cell`), the rows below (`text`).

use super::cell::{Delimiter, words};
use super::error::{clipped, shortened};
use super::mapping::Format;
use super::title::Title;
use super::trial::Trial;

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
    /// Comment lines and what else stands above, without marks.
    pub remarks: Vec<String>,
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
    /// Finds out how a text is written from its first lines.
    pub fn detect(head: &[Line<'_>], format: &Format) -> Result<Self, String> {
        let own = format.comment.as_deref();
        let content: Vec<Line<'_>> = head
            .iter()
            .filter(|(_, line)| !line.trim_ascii().is_empty() && comment(line, own).is_none())
            .copied()
            .collect();
        let (last, none) = (head.last().map_or(0, |line| line.0), "has no rows: it is empty, or holds comments only");
        if content.is_empty() {
            return Err(none.to_owned());
        }
        let best = candidates(format)
            .into_iter()
            .map(|(delimiter, comma)| Trial::of(&content, delimiter, comma))
            .reduce(|best, next| if next.score > best.score { next } else { best });
        let Some(trial) = best.filter(|trial| trial.first.is_some()) else {
            let first = content.first().map(|(_, line)| clipped(&words(line))).unwrap_or_default();
            return Err(format!("no row of numbers is in its first {last} lines; the first begins with {first}"));
        };
        trial.layout(head, &content, format)
    }

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

/// Delimiter and decimal comma, in the order in which they are preferred.
fn candidates(format: &Format) -> Vec<(Delimiter, bool)> {
    let sign = |sign: char| if sign == ' ' { Delimiter::Space } else { Delimiter::Sign(sign as u8) };
    let delimiters: Vec<Delimiter> = match format.delimiter {
        Some(told) => vec![sign(told)],
        None => ['\t', ';', '|', ',', ' '].map(sign).to_vec(),
    };
    let commas: &[bool] = match format.decimal_comma {
        Some(true) => &[true],
        Some(false) => &[false],
        None => &[false, true],
    };
    let pairs = delimiters.into_iter().flat_map(|delimiter| commas.iter().map(move |comma| (delimiter, *comma)));
    pairs.filter(|(delimiter, comma)| !(*comma && *delimiter == Delimiter::Sign(b','))).collect()
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
