//! A Parquet file that ends: its decoder goes on past the end of a damaged file as long as a length in it says, without noticing.
//!
//! Next door: what falls over a damaged file (`guarded`), who reads such files (`recording`, `sweep`).

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom};

use bytes::Bytes;
use parquet::errors::{ParquetError, Result};
use parquet::file::reader::{ChunkReader, Length};

/// A file whose end is an error to whoever reads on there.
pub(crate) struct Bounded(pub File);

/// Reads up to the end of the file, and fails from then on.
pub(crate) struct Ending(BufReader<File>);

impl Read for Ending {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self.0.read(buffer) {
            Ok(0) if !buffer.is_empty() => Err(io::ErrorKind::UnexpectedEof.into()),
            read => read,
        }
    }
}

impl Length for Bounded {
    fn len(&self) -> u64 {
        self.0.metadata().map_or(0, |metadata| metadata.len())
    }
}

impl ChunkReader for Bounded {
    type T = Ending;

    fn get_read(&self, start: u64) -> Result<Ending> {
        let mut file = self.0.try_clone()?;
        file.seek(SeekFrom::Start(start))?;
        Ok(Ending(BufReader::new(file)))
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes> {
        let left = Length::len(self).saturating_sub(start);
        if length as u64 > left {
            return Err(ParquetError::EOF(format!("{length} bytes are told where {left} are left")));
        }
        let mut bytes = vec![0; length];
        let mut file = self.0.try_clone()?;
        file.seek(SeekFrom::Start(start))?;
        file.read_exact(&mut bytes)?;
        Ok(bytes.into())
    }
}
