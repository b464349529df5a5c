//! The messages of an Arrow file or stream, one after the other: a schema, dictionaries, record batches.
//!
//! A file has a table of their places at its end, and not all writers put a schema at its beginning, where a stream has it.
//!
//! Next door: what becomes of them (`super`).

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom};

use arrow_buffer::Buffer;
use arrow_ipc::convert::{MessageBuffer, try_fb_to_schema};
use arrow_ipc::{Endianness, RecordBatch};
use arrow_schema::Schema;

use super::super::super::error::shortened;
use super::super::super::order::MOST_NUMBERS;
use super::super::super::packing::{Bytes, told};

/// The messages that are left.
pub(super) enum Messages {
    /// Those of a file, at these places.
    File(BufReader<File>, std::vec::IntoIter<u64>),
    /// Those of a stream; it may have had its end.
    Stream(BufReader<Bytes>, bool),
}

/// A message: what it is, and its bytes.
pub(super) struct Message {
    header: MessageBuffer,
    pub body: Buffer,
}

impl Message {
    pub fn header(&self) -> arrow_ipc::Message<'_> {
        self.header.as_ref()
    }
}

/// Most bytes of a message's header, and of its body.
const MOST_HEADER: u64 = 64 << 20;
const MOST_BODY: u64 = 8 * MOST_NUMBERS as u64;
/// Bytes that a stream is read by.
const AT_ONCE: usize = 1 << 20;
/// How a file begins and ends.
pub(super) const MARK: &[u8] = b"ARROW1";

impl Messages {
    /// Those of a file but its schema, which comes apart.
    pub fn of_file(mut file: File) -> Result<(Self, Schema), String> {
        let size = file.seek(SeekFrom::End(0)).map_err(|error| told(&error))?;
        let (tail, mark) = (4 + MARK.len() as u64, MARK.len() as u64 + 2);
        let no_end = || "is cut off: the table at its end is missing".to_owned();
        if size < mark + tail {
            return Err(no_end());
        }
        file.seek(SeekFrom::Start(size - tail)).map_err(|error| told(&error))?;
        let end = exactly(&mut file, tail)?;
        let length = end.get(..4).and_then(|word| word.try_into().ok()).map_or(0, u32::from_le_bytes);
        if end.get(4..) != Some(MARK) {
            return Err(no_end());
        }
        let place = (size - tail).checked_sub(length.into()).filter(|place| *place >= mark);
        let place = place.ok_or_else(|| format!("is damaged: its table has {length} bytes"))?;
        file.seek(SeekFrom::Start(place)).map_err(|error| told(&error))?;
        let table = exactly(&mut file, length.into())?;
        let footer = arrow_ipc::root_as_footer(&table);
        let footer = footer.map_err(|error| format!("is damaged: {}", shortened(&error.to_string())))?;
        let schema = schema(footer.schema())?;
        let blocks = footer.dictionaries().into_iter().flatten().chain(footer.recordBatches().into_iter().flatten());
        // A place that is none lies behind the end.
        let places: Vec<u64> = blocks.map(|block| u64::try_from(block.offset()).unwrap_or(u64::MAX >> 1)).collect();
        Ok((Self::File(BufReader::new(file), places.into_iter()), schema))
    }

    /// Those of a stream but its schema, which comes apart.
    pub fn of_stream(bytes: Bytes) -> Result<(Self, Schema), String> {
        let mut messages = Self::Stream(BufReader::with_capacity(AT_ONCE, bytes), false);
        let first = messages.next()?;
        let schema = schema(first.as_ref().and_then(|message| message.header().header_as_schema()))?;
        Ok((messages, schema))
    }

    /// In words.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::File(..) => "file (Feather)",
            Self::Stream(..) => "stream",
        }
    }

    /// The next message; `None` at the end.
    pub fn next(&mut self) -> Result<Option<Message>, String> {
        match self {
            Self::File(file, places) => {
                let Some(place) = places.next() else { return Ok(None) };
                file.seek(SeekFrom::Start(place)).map_err(|error| told(&error))?;
                message(file)?.ok_or_else(cut_off).map(Some)
            }
            Self::Stream(_, true) => Ok(None),
            Self::Stream(bytes, ended) => {
                let message = message(bytes)?;
                *ended = message.is_none();
                Ok(message)
            }
        }
    }
}

/// A schema whose numbers lie as they do here.
fn schema(schema: Option<arrow_ipc::Schema<'_>>) -> Result<Schema, String> {
    let schema = schema.ok_or_else(|| "is damaged: it has no schema of Arrow's".to_owned())?;
    if schema.endianness() != Endianness::Little {
        return Err("is Arrow of a big-endian machine, which is not read; save it as Parquet".to_owned());
    }
    try_fb_to_schema(schema).map_err(|error| format!("is damaged: {}", shortened(&error.to_string())))
}

/// The message that stands here; `None` where the end does.
fn message(bytes: &mut impl Read) -> Result<Option<Message>, String> {
    let mut size = word(bytes)?;
    // A mark that old writers leave out.
    if size == Some(u32::MAX) {
        size = Some(word(bytes)?.ok_or_else(cut_off)?);
    }
    let Some(size) = size.filter(|size| *size > 0).map(u64::from) else { return Ok(None) };
    if size > MOST_HEADER {
        return Err(format!("is damaged: a message's header has {size} bytes"));
    }
    let header = MessageBuffer::try_new(exactly(bytes, size)?);
    let header = header.map_err(|error| format!("is damaged: {}", shortened(&error.to_string())))?;
    let size = header.as_ref().bodyLength();
    let size = u64::try_from(size).map_err(|_| format!("is damaged: a message has {size} bytes"))?;
    if size > MOST_BODY {
        return Err("has a record batch that is too large to be held in memory".to_owned());
    }
    Ok(Some(Message { body: exactly(bytes, size)?, header }))
}

/// Four bytes; `None` where nothing is left.
fn word(bytes: &mut impl Read) -> Result<Option<u32>, String> {
    let mut word = Vec::new();
    bytes.take(4).read_to_end(&mut word).map_err(|error| told(&error))?;
    match word.as_slice() {
        [] => Ok(None),
        &[a, b, c, d] => Ok(Some(u32::from_le_bytes([a, b, c, d]))),
        _ => Err(cut_off()),
    }
}

/// So many bytes, and not fewer.
fn exactly(bytes: &mut impl Read, size: u64) -> Result<Buffer, String> {
    let mut all = Vec::new();
    let read: io::Result<usize> = bytes.take(size).read_to_end(&mut all);
    match read {
        Ok(read) if read as u64 == size => Ok(Buffer::from_vec(all)),
        Ok(_) => Err(cut_off()),
        Err(error) => Err(told(&error)),
    }
}

fn cut_off() -> String {
    "is cut off: a message of it breaks off before its end".to_owned()
}

/// Refuses a batch that is to be unpacked to more than can be held: its library takes the sizes that it tells for true.
pub(super) fn bounded(batch: Option<RecordBatch<'_>>, body: &Buffer) -> Result<(), String> {
    let Some(batch) = batch.filter(|batch| batch.compression().is_some()) else { return Ok(()) };
    let mut sum = 0_u64;
    for buffer in batch.buffers().into_iter().flatten() {
        let start = usize::try_from(buffer.offset()).ok();
        let size = start.and_then(|start| body.get(start..start.checked_add(8)?)?.try_into().ok());
        let size = size.map_or(0, i64::from_le_bytes);
        // -1 says that it is not compressed.
        sum = sum.saturating_add(u64::try_from(size).unwrap_or(0));
    }
    if sum > 2 * MOST_BODY {
        return Err("has a record batch that is too large to be held in memory when it is unpacked".to_owned());
    }
    Ok(())
}
