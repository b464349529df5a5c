//! Rows of an Arrow file (Feather, version 2) or stream, one record batch in memory at a time.
//!
//! | file | holds |
//! |---|---|
//! | `messages` | its messages, none longer than what can be held |
//! | `values` | a column's numbers |
//!
//! Next door: Parquet (`parquet`), what numbers mean (`columnar`).

mod messages;
mod values;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use arrow_array::ArrayRef;
use arrow_ipc::MessageHeader;
use arrow_ipc::reader::{read_dictionary, read_record_batch};
use arrow_schema::{ArrowError, DataType, FieldRef, Schema, SchemaRef};

use super::super::error::{RecordingError, shortened};
use super::super::input::{Input, Stream};
use super::super::order::MOST_NUMBERS;
use super::super::source::{Next, Source};
use super::super::title::Title;
use super::columnar::Kind;
use crate::guarded::guarded;
use messages::{Message, Messages};

#[cfg(feature = "parquet")]
pub(super) use values::duration;

/// An Arrow file or stream that is being read.
pub(super) struct ArrowRows {
    path: PathBuf,
    messages: Messages,
    schema: SchemaRef,
    titles: Vec<Title>,
    /// What each column holds: numbers, or something else.
    kinds: Vec<Result<Kind, &'static str>>,
    /// First instant of each column that holds such.
    origins: Vec<Option<i128>>,
    dictionaries: HashMap<i64, ArrayRef>,
    /// The record batch in memory: its number, the columns that were wanted, and the next row of it.
    batch: usize,
    columns: Vec<Vec<f64>>,
    row: usize,
    /// Rows that were handed on.
    rows: u64,
    size: u64,
    done: Arc<AtomicU64>,
}

impl ArrowRows {
    /// Opens a file or stream.
    pub fn open(input: Input) -> Result<Self, RecordingError> {
        let path = input.path().to_owned();
        let wrong = |message: String| RecordingError::of_file(&path, message);
        if input.head().starts_with(messages::MARK) {
            let file = input.file()?;
            let size = file.metadata().map_or(0, |metadata| metadata.len());
            let (messages, schema) = guarded(&path, || Messages::of_file(file).map_err(wrong))?;
            return Ok(Self::begin(path, messages, schema, size, Arc::default()));
        }
        let Stream { bytes, size, done, .. } = input.stream();
        let (messages, schema) = guarded(&path, || Messages::of_stream(bytes).map_err(wrong))?;
        Ok(Self::begin(path, messages, schema, size, done))
    }

    fn begin(path: PathBuf, messages: Messages, schema: Schema, size: u64, done: Arc<AtomicU64>) -> Self {
        let kinds: Vec<_> = schema.fields().iter().map(|field| values::kind(field.data_type())).collect();
        let titled = |(field, kind): (&FieldRef, &Result<Kind, &str>)| {
            let title = Title::parse(field.name());
            let unit = if matches!(kind, Ok(Kind::Duration(_))) { Some("s".to_owned()) } else { title.unit };
            Title { stamps: kind.is_ok_and(Kind::stamps), unit, ..title }
        };
        Self {
            path,
            messages,
            titles: schema.fields().iter().zip(&kinds).map(titled).collect(),
            origins: vec![None; kinds.len()],
            kinds,
            schema: Arc::new(schema),
            dictionaries: HashMap::new(),
            batch: 0,
            columns: Vec::new(),
            row: 0,
            rows: 0,
            size,
            done,
        }
    }

    /// Reads the next record batch that has rows; false where none is left.
    fn advance(&mut self, wanted: &[usize]) -> Result<bool, RecordingError> {
        let path = self.path.clone();
        let wrong = |message: String| RecordingError::of_file(&path, message);
        while let Some(message) = self.messages.next().map_err(wrong)? {
            let (header, version) = (message.header(), message.header().version());
            match header.header_type() {
                MessageHeader::DictionaryBatch if self.wants_dictionaries(wanted) => {
                    let batch = header.header_as_dictionary_batch();
                    let batch = batch.ok_or_else(|| wrong("is damaged: a dictionary of it is empty".to_owned()))?;
                    messages::bounded(batch.data(), &message.body).map_err(wrong)?;
                    read_dictionary(&message.body, batch, &self.schema, &mut self.dictionaries, &version)
                        .map_err(|error| wrong(damaged(&error)))?;
                }
                MessageHeader::RecordBatch => {
                    self.batch += 1;
                    // A stream's bytes are counted where they are read.
                    if matches!(self.messages, Messages::File(..)) {
                        self.done.fetch_add(message.body.len() as u64, Ordering::Relaxed);
                    }
                    self.take(&message, wanted)?;
                    if self.columns.first().is_some_and(|column| !column.is_empty()) {
                        return Ok(true);
                    }
                }
                _ => {}
            }
        }
        Ok(false)
    }

    /// The wanted columns of a record batch.
    fn take(&mut self, message: &Message, wanted: &[usize]) -> Result<(), RecordingError> {
        let place = format!("record batch {}", self.batch);
        let wrong = |message: String| RecordingError::of_file(&self.path, message);
        for &index in wanted {
            let column = || self.titles[index].place(index);
            self.kinds[index].map_err(|what| wrong(format!("{}: it holds {what}, no numbers", column())))?;
        }
        let batch = message.header().header_as_record_batch();
        let batch = batch.ok_or_else(|| wrong(format!("is damaged: {place} is empty")))?;
        messages::bounded(Some(batch), &message.body).map_err(wrong)?;
        let rows = usize::try_from(batch.length()).unwrap_or(usize::MAX);
        if rows.saturating_mul(wanted.len()) > MOST_NUMBERS {
            return Err(wrong(format!("its {place} is too large to be held in memory")));
        }
        let version = message.header().version();
        let (body, schema) = (&message.body, self.schema.clone());
        let batch = read_record_batch(body, batch, schema, &self.dictionaries, Some(wanted), &version)
            .map_err(|error| wrong(format!("{place}: {}", damaged(&error))))?;
        self.columns.clear();
        for (array, &index) in batch.columns().iter().zip(wanted) {
            let kind = self.kinds[index].unwrap_or(Kind::Plain);
            let numbers = values::numbers(array, kind, &mut self.origins[index])
                .map_err(|what| wrong(format!("{}, {place}: {what}", self.titles[index].place(index))))?;
            self.columns.push(numbers);
        }
        self.row = 0;
        Ok(())
    }

    /// Whether a column is wanted whose numbers stand in a dictionary.
    fn wants_dictionaries(&self, wanted: &[usize]) -> bool {
        let kind = |&index: &usize| self.schema.fields().get(index).map(|field| field.data_type());
        wanted.iter().filter_map(kind).any(|kind| matches!(kind, DataType::Dictionary(..)))
    }
}

/// What the library says, on one line.
fn damaged(error: &ArrowError) -> String {
    format!("is damaged: {}", shortened(&error.to_string()))
}

impl Source for ArrowRows {
    fn file(&self) -> &Path {
        &self.path
    }

    fn description(&self) -> String {
        format!("Arrow {}, {} columns", self.messages.kind(), self.titles.len())
    }

    fn titles(&self) -> &[Title] {
        &self.titles
    }

    fn remarks(&self) -> &[String] {
        &[]
    }

    fn progress(&self) -> [u64; 2] {
        [self.done.load(Ordering::Relaxed), self.size]
    }

    fn numeric(&self) -> Vec<usize> {
        (0..self.kinds.len()).filter(|&index| self.kinds[index].is_ok()).collect()
    }

    fn next(&mut self, wanted: &[usize], values: &mut Vec<f64>) -> Result<Next, RecordingError> {
        if self.columns.first().is_none_or(|column| self.row >= column.len()) {
            let path = self.path.clone();
            if !guarded(&path, || self.advance(wanted))? {
                self.columns.clear();
                return Ok(Next::End);
            }
        }
        values.clear();
        values.extend(self.columns.iter().map(|column| column[self.row]));
        self.row += 1;
        self.rows += 1;
        Ok(Next::Row(self.rows))
    }
}
