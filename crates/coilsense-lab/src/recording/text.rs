//! Rows of a text file, line by line.
//!
//! Next door: how it is written (`layout`), its cells (`cell`).

use std::io::{BufRead, BufReader, Cursor, Read};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::account::Reason;
use super::cell::{Cell, bare, split, words};
use super::error::{RecordingError, clipped};
use super::input::{Input, Stream, unreadable};
use super::layout::{FileClock, Layout, Line, comment};
use super::mapping::Format;
use super::numeral::Thousands;
use super::packing::told;
use super::source::{Next, Source};
use super::stamp::Stamp;
use super::title::Title;
use super::trial::detect;
use super::unicode::recoded;
use crate::message::{Hint, Message};

/// A text file that is being read.
pub(super) struct Text {
    path: PathBuf,
    reader: Box<dyn BufRead + Send>,
    layout: Layout,
    /// What it was before it was a text, where it was something else.
    what: Option<String>,
    /// What else there is to say of how it is written.
    also: String,
    comment: Option<String>,
    line: u64,
    /// Bytes that there are, 0 where nobody knows, and how many of them were read.
    size: u64,
    done: Arc<AtomicU64>,
    buffer: Vec<u8>,
    cells: Vec<Range<usize>>,
    /// The first stamp, from whose midnight time counts.
    first_stamp: Option<Stamp>,
    /// What each column tells of parted thousands.
    thousands: Vec<Thousands>,
    /// Whether what is no number is a missing one.
    lenient: bool,
}

/// How much of a file is looked at to find out how it is written.
const HEAD: u64 = 256 << 10;
/// Most lines of that, and the longest line of a log.
const HEAD_LINES: usize = 500;
const LONGEST_LINE: u64 = 1 << 20;

const MARK: &[u8] = b"\xef\xbb\xbf";

impl Text {
    /// Finds out how a text is written.
    pub fn open(input: Input, format: &Format) -> Result<Self, RecordingError> {
        let path = input.path().to_owned();
        Self::begin(path, input.stream(), format)
    }

    /// A text in memory, under a name for messages.
    #[cfg(feature = "sheets")]
    pub fn held(name: &Path, text: Vec<u8>, format: &Format) -> Result<Self, RecordingError> {
        let size = text.len() as u64;
        let stream =
            Stream { bytes: Box::new(Cursor::new(text)), size, done: Arc::new(AtomicU64::new(size)), packing: None };
        Self::begin(name.to_owned(), stream, format)
    }

    fn begin(path: PathBuf, stream: Stream, format: &Format) -> Result<Self, RecordingError> {
        let Stream { mut bytes, size, done, packing } = stream;
        let mut first = Vec::new();
        (&mut bytes).take(64).read_to_end(&mut first).map_err(|error| unreadable(&path, &error))?;
        let (mut bytes, is_wide) = recoded(&first.clone(), Box::new(Cursor::new(first).chain(bytes)));
        let mut head = Vec::new();
        (&mut bytes).take(HEAD).read_to_end(&mut head).map_err(|error| unreadable(&path, &error))?;
        let whole = (head.len() as u64) < HEAD;
        let layout = text_only(&head)
            .and_then(|()| detect(&lines(&head, whole), format))
            .map_err(|message| RecordingError::of_file(&path, message))?;
        let wide = if is_wide { ", in UTF-16" } else { "" };
        let unsettled = if format.decimal_comma.is_some() { Thousands::settled() } else { Thousands::default() };
        let packed = packing.map_or(String::new(), |packing| format!(", compressed by {}", packing.name()));
        Ok(Self {
            path,
            reader: Box::new(BufReader::with_capacity(1 << 20, Cursor::new(head).chain(bytes))),
            thousands: vec![unsettled; layout.titles.len()],
            layout,
            what: None,
            also: format!("{wide}{packed}"),
            comment: format.comment.clone(),
            line: 0,
            size,
            done,
            buffer: Vec::new(),
            cells: Vec::new(),
            first_stamp: None,
            lenient: false,
        })
    }

    /// The same, made of something that is no text.
    #[cfg(feature = "sheets")]
    pub fn described(self, what: String) -> Self {
        Self { what: Some(what), ..self }
    }

    /// Moves on to the next line; false at the end.
    fn advance(&mut self) -> Result<bool, RecordingError> {
        self.buffer.clear();
        self.line += 1;
        let read = (&mut self.reader).take(LONGEST_LINE).read_until(b'\n', &mut self.buffer);
        let read = read.map_err(|error| RecordingError::of_line(&self.path, self.line, told(&error)))?;
        if read as u64 == LONGEST_LINE {
            return Err(RecordingError::of_line(&self.path, self.line, "the line is longer than 1 MiB"));
        }
        if self.line == 1 && self.buffer.starts_with(MARK) {
            self.buffer.drain(..MARK.len());
        }
        Ok(read > 0)
    }

    /// Moves on to the titles of a further segment.
    fn skip_head(&mut self) -> Result<(), RecordingError> {
        let end = self.layout.segments.unwrap_or_default();
        while !self.buffer.starts_with(end) {
            if !self.advance()? {
                return Ok(());
            }
        }
        self.advance().map(|_| ())
    }

    /// Refuses a column whose cells may be a thousand times as much.
    fn certain(&self, wanted: &[usize]) -> Result<(), RecordingError> {
        let doubted = wanted.iter().find_map(|&index| Some((index, self.thousands[index].doubt()?)));
        let Some((index, cell)) = doubted else { return Ok(()) };
        let sign = if cell.contains(',') { ',' } else { '.' };
        let place = self.layout.titles[index].place(index);
        let text =
            format!("{place}: {cell} may be a decimal, or {} with its thousands parted; ", cell.replace(sign, ""));
        let (decimal, parted) = if sign == ',' { (",", ".") } else { (".", ",") };
        let message = Message::from(text)
            + Hint::Value("decimal", decimal.to_owned())
            + " takes it for a decimal, "
            + Hint::Value("decimal", parted.to_owned())
            + " for thousands";
        Err(RecordingError::of_file(&self.path, message))
    }

    fn broken(&self, reason: Reason, message: String) -> Next {
        Next::Broken { line: self.line, reason, message }
    }

    fn cell(&mut self, index: usize) -> Result<f64, Next> {
        let Some(range) = self.cells.get(index) else { return Ok(f64::NAN) };
        let cell = &self.buffer[range.clone()];
        let stamps = self.layout.titles[index].stamps;
        let comma = self.layout.decimal_comma;
        match Cell::of(cell, comma) {
            Cell::Number(value) if !stamps => {
                self.thousands[index].see(bare(cell), comma);
                Ok(value)
            }
            Cell::Missing => Ok(f64::NAN),
            Cell::Stamp(stamp) if stamps => {
                let first = *self.first_stamp.get_or_insert(stamp);
                Ok(86_400.0 * stamp.days_since(first) as f64 + stamp.second)
            }
            _ if self.lenient => Ok(f64::NAN),
            _ => {
                let wanted = if stamps { "a time stamp as in the first row" } else { "a number" };
                let place = self.layout.titles[index].place(index);
                Err(self.broken(Reason::NoNumber, format!("{place}: {} is not {wanted}", clipped(&words(cell)))))
            }
        }
    }
}

impl Source for Text {
    fn file(&self) -> &Path {
        &self.path
    }

    fn description(&self) -> String {
        let header = || self.layout.header.map_or("no header".to_owned(), |row| format!("header in row {row}"));
        match &self.what {
            Some(what) => format!("{what}, {}", header()),
            None => self.layout.description() + &self.also,
        }
    }

    fn titles(&self) -> &[Title] {
        &self.layout.titles
    }

    fn remarks(&self) -> &[String] {
        &self.layout.remarks
    }

    fn progress(&self) -> [u64; 2] {
        [self.done.load(Ordering::Relaxed), self.size]
    }

    fn clock(&self) -> Option<FileClock> {
        self.layout.clock
    }

    fn be_lenient(&mut self) {
        self.lenient = true;
    }

    fn next(&mut self, wanted: &[usize], values: &mut Vec<f64>) -> Result<Next, RecordingError> {
        loop {
            if !self.advance()? {
                self.certain(wanted)?;
                return Ok(Next::End);
            }
            if self.line < self.layout.first_row || comment(&self.buffer, self.comment.as_deref()).is_some() {
                continue;
            }
            let mut end = self.buffer.len();
            while end > 0 && matches!(self.buffer[end - 1], b'\n' | b'\r') {
                end -= 1;
            }
            if self.buffer[..end].trim_ascii().is_empty() {
                continue;
            }
            if self.layout.segments.is_some_and(|_| self.buffer.starts_with(b"Channels")) {
                self.skip_head()?;
                continue;
            }
            split(&self.buffer[..end], self.layout.delimiter, &mut self.cells);
            break;
        }
        let (columns, present) = (self.layout.titles.len(), self.cells.len());
        let too_many = self.cells.iter().skip(columns).any(|cell| !bare(&self.buffer[cell.clone()]).is_empty());
        if present < self.layout.shortest || too_many {
            let plural = if present == 1 { "column" } else { "columns" };
            let whose = self.layout.header.map_or("the first row has".to_owned(), |line| format!("line {line} has"));
            return Ok(self.broken(Reason::CellCount, format!("it has {present} {plural} where {whose} {columns}")));
        }
        values.clear();
        for &index in wanted {
            match self.cell(index) {
                Ok(value) => values.push(value),
                Err(broken) => return Ok(broken),
            }
        }
        Ok(Next::Row(self.line))
    }
}

/// Refuses what is no text, by name where its first bytes tell.
fn text_only(head: &[u8]) -> Result<(), String> {
    if head.is_empty() {
        return Err("is empty".to_owned());
    }
    let known: [(&[u8], &str); 2] = [
        (b"\x1f\x8b", "compressed by gzip; unpack it first"),
        (b"\x28\xb5\x2f\xfd", "compressed by zstd; unpack it first"),
    ];
    match known.iter().find(|(magic, _)| head.starts_with(magic)) {
        Some((_, what)) => Err(format!("is {what}")),
        None if head.contains(&0) => Err("is no text: it holds zero bytes".to_owned()),
        None => Ok(()),
    }
}

/// The first lines with their numbers; the last one only where it is whole.
fn lines(head: &[u8], whole: bool) -> Vec<Line<'_>> {
    let mut all: Vec<&[u8]> = head.strip_prefix(MARK).unwrap_or(head).split(|byte| *byte == b'\n').collect();
    if !whole && all.len() > 1 {
        all.pop();
    }
    let ending = |line| <[u8]>::strip_suffix(line, b"\r").unwrap_or(line);
    (1..).zip(all.into_iter().map(ending)).take(HEAD_LINES).collect()
}
