//! One file to send: every file as it is, what was found of it, and their digests.
//!
//! Next door: what is looked at before (`checks`).

use std::fs::File;
use std::io::{self, Read, Seek, Write};

use sha2::{Digest, Sha256};
use zip::CompressionMethod;
use zip::write::{SimpleFileOptions, ZipWriter};

use super::Record;

/// Bytes that are copied at a time.
const CHUNK: usize = 1 << 16;

impl Record {
    /// Writes the record as a ZIP archive: its files byte for byte, `check.json` with `check`, and `SHA256SUMS` of them all.
    ///
    /// # Errors
    /// Those of reading and writing.
    pub fn pack(&self, check: &str, to: impl Write + Seek) -> io::Result<()> {
        let mut archive = ZipWriter::new(to);
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated).large_file(true);
        let mut sums = String::new();
        for name in self.names() {
            let mut source = File::open(self.folder.join(name))?;
            archive.start_file(name, options)?;
            let mut digest = Sha256::new();
            let mut chunk = vec![0; CHUNK];
            loop {
                let count = source.read(&mut chunk)?;
                if count == 0 {
                    break;
                }
                digest.update(&chunk[..count]);
                archive.write_all(&chunk[..count])?;
            }
            sums += &format!("{}  {name}\n", hexadecimal(&digest.finalize()));
        }
        sums += &format!("{}  check.json\n", hexadecimal(&Sha256::digest(check.as_bytes())));
        for (name, text) in [("check.json", check), ("SHA256SUMS", sums.as_str())] {
            archive.start_file(name, options)?;
            archive.write_all(text.as_bytes())?;
        }
        archive.finish()?;
        Ok(())
    }
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
