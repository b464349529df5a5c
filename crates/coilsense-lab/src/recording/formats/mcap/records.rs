//! The records of an MCAP file, one after the other; those of a chunk are unpacked.
//!
//! Next door: what messages hold (`topics`).

use std::io::Read;

/// A record that matters here.
pub(super) enum Record {
    Channel {
        number: u16,
        topic: String,
        encoding: String,
    },
    /// A message, logged so many nanoseconds after some instant.
    Message {
        channel: u16,
        time: u64,
        data: Vec<u8>,
    },
}

/// The records of a file.
pub(super) struct Records<R> {
    reader: R,
    /// The records of a chunk, and how many bytes of them are done.
    chunk: Vec<u8>,
    done: usize,
    cut: bool,
    ended: bool,
}

const MAGIC: &[u8] = b"\x89MCAP0\r\n";
/// Most bytes of a record outside of chunks, and of a chunk when it is unpacked.
const MOST: u64 = 1 << 28;

impl<R: Read> Records<R> {
    pub fn of(mut reader: R) -> Result<Self, String> {
        let mut magic = [0; 8];
        reader.read_exact(&mut magic).map_err(|_| "it is cut off")?;
        if magic != MAGIC {
            return Err("its version is not known".to_owned());
        }
        Ok(Self { reader, chunk: Vec::new(), done: 0, cut: false, ended: false })
    }

    /// Whether the file ended before its data did.
    pub fn is_cut(&self) -> bool {
        self.cut
    }

    /// The next record; none at the end of the data.
    pub fn next(&mut self) -> Result<Option<Record>, String> {
        loop {
            if self.done < self.chunk.len() {
                let mut bytes = Bytes(&self.chunk[self.done..]);
                let (kind, length) = (bytes.byte()?, bytes.long()?);
                let content = bytes.take(length)?;
                self.done = self.chunk.len() - bytes.0.len();
                if let Some(record) = record(kind, content)? {
                    return Ok(Some(record));
                }
                continue;
            }
            let Some((kind, content)) = self.outer()? else { return Ok(None) };
            match kind {
                6 => {
                    self.chunk = unpacked(&content)?;
                    self.done = 0;
                }
                kind => {
                    if let Some(record) = record(kind, &content)? {
                        return Ok(Some(record));
                    }
                }
            }
        }
    }

    /// The next record outside of chunks; none behind the data, and where the file ends before them.
    fn outer(&mut self) -> Result<Option<(u8, Vec<u8>)>, String> {
        let mut head = [0; 9];
        if self.ended || self.reader.read_exact(&mut head).is_err() {
            self.cut |= !self.ended;
            self.ended = true;
            return Ok(None);
        }
        let (kind, length) = (head[0], Bytes(&head[1..]).long()?);
        // The end of the data, or of the file.
        if matches!(kind, 2 | 15) {
            self.ended = true;
            return Ok(None);
        }
        // Attachments may be large, and matter to nobody here.
        if kind == 9 {
            let passed = std::io::copy(&mut (&mut self.reader).take(length), &mut std::io::sink());
            self.cut |= passed.is_ok_and(|passed| passed < length);
            return Ok(Some((kind, Vec::new())));
        }
        if length > MOST {
            return Err("a record of it is larger than 256 MiB".to_owned());
        }
        let mut content = Vec::new();
        let read = (&mut self.reader).take(length).read_to_end(&mut content);
        if read.map_err(|error| error.to_string())? as u64 == length {
            return Ok(Some((kind, content)));
        }
        (self.cut, self.ended) = (true, true);
        Ok(None)
    }
}

/// A record of its kind and content, where it matters.
fn record(kind: u8, content: &[u8]) -> Result<Option<Record>, String> {
    let mut bytes = Bytes(content);
    Ok(match kind {
        4 => {
            let number = bytes.short()?;
            bytes.short()?;
            Some(Record::Channel { number, topic: bytes.text()?, encoding: bytes.text()? })
        }
        5 => {
            let channel = bytes.short()?;
            bytes.take(4)?;
            let time = bytes.long()?;
            bytes.take(8)?;
            Some(Record::Message { channel, time, data: bytes.0.to_vec() })
        }
        _ => None,
    })
}

/// The records of a chunk.
fn unpacked(content: &[u8]) -> Result<Vec<u8>, String> {
    let mut bytes = Bytes(content);
    bytes.take(16)?;
    let size = bytes.long()?;
    bytes.take(4)?;
    let packing = bytes.text()?;
    let length = bytes.long()?;
    let packed = bytes.take(length)?;
    if size > MOST {
        return Err("a chunk of it is larger than 256 MiB".to_owned());
    }
    let mut plain = Vec::new();
    let read = match packing.as_str() {
        "" => return Ok(packed.to_vec()),
        "lz4" => lz4_flex::frame::FrameDecoder::new(packed).take(size).read_to_end(&mut plain),
        "zstd" => match zstd::stream::read::Decoder::with_buffer(packed) {
            Ok(decoder) => decoder.take(size).read_to_end(&mut plain),
            Err(error) => Err(error),
        },
        _ => return Err("a chunk of it is packed in a way that is not known".to_owned()),
    };
    match read {
        Ok(count) if count as u64 == size => Ok(plain),
        _ => Err("a chunk of it is damaged".to_owned()),
    }
}

/// What is left of a record.
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take(&mut self, count: u64) -> Result<&'a [u8], String> {
        let parted = usize::try_from(count).ok().and_then(|count| self.0.split_at_checked(count));
        let (taken, rest) = parted.ok_or("a record of it is cut off")?;
        self.0 = rest;
        Ok(taken)
    }

    fn byte(&mut self) -> Result<u8, String> {
        Ok(self.take(1)?[0])
    }

    fn short(&mut self) -> Result<u16, String> {
        let bytes = self.take(2)?;
        Ok(u16::from_le_bytes([bytes[0], bytes[1]]))
    }

    fn long(&mut self) -> Result<u64, String> {
        let mut bytes = [0; 8];
        bytes.copy_from_slice(self.take(8)?);
        Ok(u64::from_le_bytes(bytes))
    }

    fn text(&mut self) -> Result<String, String> {
        let bytes = self.take(4)?;
        let length = u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
        Ok(String::from_utf8_lossy(self.take(u64::from(length))?).into_owned())
    }
}
