//! Finds out how a text is written: each way of parting it into cells, and what its first lines look like then.
//!
//! Next door: what is found (`layout`), texts whose head says it (`dialect`), single cells (`cell`).

use std::ops::Range;

use super::cell::{Cell, Delimiter, split, words};
use super::dialect;
use super::error::clipped;
use super::layout::{Layout, Line, MOST_COLUMNS, comment, remarks};
use super::mapping::Format;
use super::title::Title;

/// Finds out how a text is written from its first lines.
pub(super) fn detect(head: &[Line<'_>], format: &Format) -> Result<Layout, String> {
    if let Some(layout) = dialect::known(head).filter(|_| format.header.is_none() && format.delimiter.is_none()) {
        return layout;
    }
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
    // Decimal commas between commas stand in quotes; where they do not, they are not told from the others, and the first candidate is as good.
    delimiters.into_iter().flat_map(|delimiter| commas.iter().map(move |comma| (delimiter, *comma))).collect()
}

/// What a text looks like when its cells are parted in one way.
pub(super) struct Trial {
    delimiter: Delimiter,
    comma: bool,
    pub score: f64,
    columns: usize,
    /// The first row that has all columns, as an index of the content lines.
    whole: Option<usize>,
    /// The first row of numbers.
    pub first: Option<usize>,
}

impl Trial {
    pub fn of(content: &[Line<'_>], delimiter: Delimiter, comma: bool) -> Self {
        let counts: Vec<Counted> = content.iter().map(|(_, line)| Counted::of(line, delimiter, comma)).collect();
        let columns = mode(counts.iter().filter(|counted| counted.numbers > 0).map(Counted::cells));
        let rows = || counts.iter().filter(|counted| counted.cells() == columns && counted.numbers > 0);
        // A text among numbers may be a label; that a sign parts into more numbers says more.
        let score = rows().map(|counted| counted.numbers as f64 - 0.1 * counted.texts as f64).sum();
        // Which columns hold numbers: rows of many numbers say more of it than a line of settings with one.
        let of_numbers = |index: usize| {
            let weight = |counted: &Counted| match counted.kinds[index] {
                Kind::Number => (counted.numbers * counted.numbers) as f64,
                Kind::Text => -((counted.numbers * counted.numbers) as f64),
                Kind::Missing => 0.0,
            };
            rows().map(weight).sum::<f64>() > 0.0
        };
        let numeric: Vec<bool> = (0..columns).map(of_numbers).collect();
        let is_good = |counted: &Counted| {
            let holds = |(kind, numeric): (&Kind, &bool)| !(*numeric && *kind == Kind::Text);
            counted.cells() == columns && counted.numbers > 0 && counted.kinds.iter().zip(&numeric).all(holds)
        };
        let is_row = |counted: &Counted| counted.cells() == columns && counted.numbers > 0;
        let good = counts.iter().position(is_good);
        let titles =
            good.and_then(|good| counts[..good].iter().rposition(|counted| counted.numbers == 0 && counted.texts > 0));
        let whole = match titles {
            // Whatever stands between the titles and the first good row is a row, too: it is not to be lost as a remark.
            Some(titles) => Some(titles + 1),
            None => counts.iter().position(is_row),
        };
        let is_short = |counted: &&Counted| counted.numbers > 0 && counted.texts == 0;
        let first = whole.map(|whole| whole - counts[..whole].iter().rev().take_while(is_short).count());
        let whole = counts
            .iter()
            .enumerate()
            .skip(first.unwrap_or(0))
            .find(|(_, counted)| is_row(counted))
            .map(|(place, _)| place);
        Self { delimiter, comma, score, columns, whole: good.or(whole), first }
    }

    /// The layout, if this is the way.
    pub fn layout(&self, head: &[Line<'_>], content: &[Line<'_>], format: &Format) -> Result<Layout, String> {
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
                units = Some(header.replace(over).map_or(Vec::new(), |(_, cells)| cells));
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
            titles: self.titles(
                columns,
                header.as_ref().map(|(_, cells)| cells.as_slice()),
                units,
                self.whole.and_then(|whole| content.get(whole)),
            ),
            header: header.as_ref().map(|(line, _)| *line),
            first_row,
            shortest: columns,
            segments: None,
            clock: None,
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
                title.stamps = matches!(row.get(index), Some(Cell::Stamp(_)));
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

/// What a cell is to a row.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Number,
    Text,
    Missing,
}

/// The cells of a line, and how many of them are numbers and texts.
struct Counted {
    kinds: Vec<Kind>,
    numbers: usize,
    texts: usize,
}

impl Counted {
    fn of(line: &[u8], delimiter: Delimiter, comma: bool) -> Self {
        let mut ranges = Vec::new();
        split(line, delimiter, &mut ranges);
        let kind = |range: &Range<usize>| match Cell::of(&line[range.clone()], comma) {
            Cell::Number(_) | Cell::Stamp(_) => Kind::Number,
            Cell::Text => Kind::Text,
            Cell::Missing => Kind::Missing,
        };
        let kinds: Vec<Kind> = ranges.iter().map(kind).collect();
        let count = |wanted: Kind| kinds.iter().filter(|kind| **kind == wanted).count();
        let (numbers, texts) = (count(Kind::Number), count(Kind::Text));
        Self { kinds, numbers, texts }
    }

    fn cells(&self) -> usize {
        self.kinds.len()
    }
}

/// The most frequent count; the larger of two.
fn mode(counts: impl Iterator<Item = usize>) -> usize {
    let mut all: Vec<usize> = counts.collect();
    all.sort_unstable();
    let runs = all.chunk_by(|a, b| a == b).map(|run| (run.len(), run.first().copied().unwrap_or(0)));
    runs.max().map_or(0, |(_, count)| count)
}
