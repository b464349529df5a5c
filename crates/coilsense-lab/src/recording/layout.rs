//! How a text is written: what parts its columns, its decimal sign, where its titles are. Told by the mapping, else found out from its
//! first lines.
//!
//! Next door: single cells (`cell`), the rows below (`text`).

use std::ops::Range;

use super::cell::{Cell, Delimiter, split, words};
use super::error::{clipped, shortened};
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
    /// Comment lines and what else stands above, without marks.
    pub remarks: Vec<String>,
}

/// A line and its number.
pub(super) type Line<'a> = (u64, &'a [u8]);

/// Most columns of a log.
const MOST_COLUMNS: usize = 10_000;

/// What follows the mark of a comment line; `None` where it is none.
pub(super) fn comment<'a>(line: &'a [u8], own: Option<&str>) -> Option<&'a [u8]> {
    let line = line.trim_ascii_start();
    let own = own.map(str::as_bytes).and_then(|mark| line.strip_prefix(mark));
    own.or_else(|| match line {
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
        format!("text, columns parted by {parted}{decimal}, {header}")
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

/// What a text looks like when its cells are parted in one way.
struct Trial {
    delimiter: Delimiter,
    comma: bool,
    score: f64,
    columns: usize,
    /// The first row of numbers, as an index of the content lines.
    first: Option<usize>,
}

impl Trial {
    fn of(content: &[Line<'_>], delimiter: Delimiter, comma: bool) -> Self {
        let counts: Vec<(usize, usize, usize)> =
            content.iter().map(|(_, line)| count(line, delimiter, comma)).collect();
        let columns = mode(counts.iter().filter(|(_, numbers, _)| *numbers > 0).map(|(cells, _, _)| *cells));
        let is_row = |(cells, numbers, _): &(usize, usize, usize)| *cells == columns && *numbers > 0;
        let rows = counts.iter().filter(|counted| is_row(counted));
        // A text among numbers may be a label; that a sign parts into more numbers says more.
        let score = rows.map(|(_, numbers, texts)| *numbers as f64 - 0.1 * *texts as f64).sum();
        Self { delimiter, comma, score, columns, first: counts.iter().position(|counted| is_row(counted)) }
    }

    fn layout(&self, head: &[Line<'_>], content: &[Line<'_>], format: &Format) -> Result<Layout, String> {
        let mut first = self.first.unwrap_or(0);
        let above = |index: usize| content.get(index).map(|(line, text)| (*line, self.cells(text)));
        let mut header = match format.header {
            Some(false) => None,
            Some(true) if first == 0 => {
                first = 1;
                above(0)
            }
            told => {
                first.checked_sub(1).and_then(above).filter(|(_, cells)| told == Some(true) || self.are_titles(cells))
            }
        };
        let mut units = None;
        if let Some((_, cells)) = &header {
            let is_unit = |cell: &String| cell.is_empty() || Title::unit_below(cell).is_some();
            if let (true, Some(over)) = (cells.iter().all(is_unit), first.checked_sub(2).and_then(above)) {
                units = Some(std::mem::replace(&mut header, Some(over)).map_or(Vec::new(), |(_, cells)| cells));
            }
        }
        let Some(first_row) = content.get(first).map(|(line, _)| *line) else {
            return Err("has a header, but no row below it".to_owned());
        };
        let from_comment = || self.commented_titles(head, first_row, format);
        let header = header.or_else(|| if format.header == Some(false) { None } else { from_comment() });
        let columns = match &header {
            Some((_, cells)) if !self.ends_in_nothing(cells.len(), content, first) => cells.len(),
            _ => self.columns,
        };
        if columns > MOST_COLUMNS {
            return Err(format!("has {columns} columns; at most {MOST_COLUMNS} are read"));
        }
        Ok(Layout {
            delimiter: self.delimiter,
            decimal_comma: self.comma,
            titles: self.titles(columns, header.as_ref().map(|(_, cells)| cells.as_slice()), units, content.get(first)),
            header: header.as_ref().map(|(line, _)| *line),
            first_row,
            remarks: remarks(head, first_row, header.map(|(line, _)| line), format),
        })
    }

    /// Rows end in a delimiter that the header lacks.
    fn ends_in_nothing(&self, titles: usize, content: &[Line<'_>], first: usize) -> bool {
        let mut last = content.iter().skip(first).map(|(_, line)| self.cells(line));
        titles + 1 == self.columns
            && last.all(|cells| cells.len() != self.columns || cells.last().is_some_and(String::is_empty))
    }

    fn titles(
        &self,
        columns: usize,
        header: Option<&[String]>,
        units: Option<Vec<String>>,
        row: Option<&Line<'_>>,
    ) -> Vec<Title> {
        let row = row.map(|(_, line)| self.kinds(line)).unwrap_or_default();
        (0..columns)
            .map(|index| {
                let mut title = Title::parse(header.and_then(|cells| cells.get(index)).map_or("", String::as_str));
                let below = units.as_ref().and_then(|units| units.get(index)).and_then(|unit| Title::unit_below(unit));
                title.unit = title.unit.or_else(|| below.map(str::to_owned));
                title.stamps = matches!(row.get(index), Some(Cell::Stamp { .. }));
                title
            })
            .collect()
    }

    fn ranges(&self, line: &[u8]) -> Vec<Range<usize>> {
        let mut cells = Vec::new();
        split(line, self.delimiter, &mut cells);
        cells
    }

    fn kinds(&self, line: &[u8]) -> Vec<Cell> {
        self.ranges(line).into_iter().map(|range| Cell::of(&line[range], self.comma)).collect()
    }

    /// The cells of a line as texts; a unit in brackets behind a space belongs to its name.
    fn cells(&self, line: &[u8]) -> Vec<String> {
        let mut cells: Vec<String> = Vec::new();
        for range in self.ranges(line) {
            let cell = words(&line[range]);
            match cells.last_mut() {
                Some(last) if self.delimiter == Delimiter::Space && cell.starts_with(['[', '(']) => {
                    last.push(' ');
                    last.push_str(&cell);
                }
                _ => cells.push(cell),
            }
        }
        cells
    }

    /// Titles hold no number, and are as many as the columns or nearly so: prose is not.
    fn are_titles(&self, cells: &[String]) -> bool {
        let is_text = |cell: &String| matches!(Cell::of(cell.as_bytes(), self.comma), Cell::Text | Cell::Missing);
        let named = cells.iter().filter(|cell| !cell.is_empty()).count();
        cells.iter().all(is_text)
            && named > 0
            && 2 * cells.len() >= self.columns
            && (cells.len() > 1 || self.columns == 1)
    }

    /// Titles behind the mark of the last comment above the rows, as NumPy writes them.
    fn commented_titles(&self, head: &[Line<'_>], first_row: u64, format: &Format) -> Option<(u64, Vec<String>)> {
        let above = head.iter().rev().find(|(line, text)| *line < first_row && !text.trim_ascii().is_empty())?;
        let line = comment(above.1, format.comment.as_deref())?.trim_ascii();
        let fits = |cells: &Vec<String>| cells.len() == self.columns && self.columns > 1 && self.are_titles(cells);
        let commas = Self { delimiter: Delimiter::Sign(b','), ..*self };
        [commas.cells(line), self.cells(line)].into_iter().find(fits).map(|cells| (above.0, cells))
    }
}

/// Cells, numbers and texts of a line.
fn count(line: &[u8], delimiter: Delimiter, comma: bool) -> (usize, usize, usize) {
    let mut cells = Vec::new();
    split(line, delimiter, &mut cells);
    let kinds = cells.iter().map(|range| Cell::of(&line[range.clone()], comma));
    let (mut numbers, mut texts) = (0, 0);
    for kind in kinds {
        numbers += usize::from(matches!(kind, Cell::Number(_) | Cell::Stamp { .. }));
        texts += usize::from(kind == Cell::Text);
    }
    (cells.len(), numbers, texts)
}

/// The most frequent count; the larger of two.
fn mode(counts: impl Iterator<Item = usize>) -> usize {
    let mut all: Vec<usize> = counts.collect();
    all.sort_unstable();
    let runs = all.chunk_by(|a, b| a == b).map(|run| (run.len(), run.first().copied().unwrap_or(0)));
    runs.max().map_or(0, |(_, count)| count)
}

/// Most remarks that are kept.
const MOST_REMARKS: usize = 1000;

fn remarks(head: &[Line<'_>], first_row: u64, header: Option<u64>, format: &Format) -> Vec<String> {
    let above = head.iter().filter(|(line, _)| *line < first_row && Some(*line) != header);
    let texts = above.map(|(_, text)| words(comment(text, format.comment.as_deref()).unwrap_or(text)));
    texts.filter(|text| !text.is_empty()).take(MOST_REMARKS).map(|text| shortened_remark(&text)).collect()
}

fn shortened_remark(text: &str) -> String {
    if text.chars().count() <= 500 { text.to_owned() } else { shortened(text) }
}
