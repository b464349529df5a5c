//! What lies in a ZIP archive, before a library unpacks it: its kind, and whether it swells to more than can be held.
//!
//! Next door: the workbook that it is (`book`).

use std::io::Read;

use flate2::Crc;
use flate2::read::DeflateDecoder;

use crate::recording::error::shortened;

/// What an archive is by the names of what lies in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Excel's workbook as XML.
    Xlsx,
    /// Excel's workbook, binary.
    Xlsb,
    /// A spreadsheet of OpenDocument.
    Ods,
    /// Anything else.
    Other,
}

/// Most bytes that its worksheets may have when they are unpacked, and all else together; most cells that they may repeat, and texts that they may
/// share.
const MOST_SHEETS: u64 = 2 << 30;
const MOST_OTHERS: u64 = 256 << 20;
const MOST_CELLS: u64 = 20_000_000;

/// A file of an archive: its name, how it is packed, and its bytes with all that follows.
struct Entry<'a> {
    name: &'a [u8],
    method: u16,
    checksum: u32,
    /// Its bytes when it is unpacked, as the table says.
    size: usize,
    bytes: &'a [u8],
}

/// What an archive is; whether it can be unpacked, and into how much, where it is a workbook.
pub(super) fn looked_into(archive: &[u8]) -> Result<Kind, String> {
    let entries = entries(archive).ok_or("is a ZIP archive that is cut off or damaged")?;
    let holds = |name: &[u8]| entries.iter().any(|entry| entry.name == name);
    let mimetype = entries.iter().find(|entry| entry.name == b"mimetype");
    let is_sheet = |bytes: &[u8]| bytes.starts_with(b"application/vnd.oasis.opendocument.spreadsheet");
    let kind = match () {
        () if holds(b"xl/workbook.xml") => Kind::Xlsx,
        () if holds(b"xl/workbook.bin") => Kind::Xlsb,
        () if holds(b"content.xml") && mimetype.is_some_and(|entry| is_sheet(entry.bytes)) => Kind::Ods,
        () => return Ok(Kind::Other),
    };
    let (mut sheets, mut others) = (MOST_SHEETS, MOST_OTHERS);
    for entry in &entries {
        let is_content = kind == Kind::Ods && entry.name == b"content.xml";
        let left = if is_content || entry.name.starts_with(b"xl/worksheets/") { &mut sheets } else { &mut others };
        let is_claiming = is_content || entry.name.ends_with(b"sharedStrings.xml");
        let mut cells = is_claiming.then(Claims::default);
        let mut counted = |bytes: &[u8]| cells.as_mut().is_none_or(|cells| cells.take(bytes));
        let size = unpacked(entry, *left, &mut counted)?;
        *left = left.checked_sub(size).ok_or("is a workbook that is too large to be held in memory; save it as CSV")?;
    }
    Ok(kind)
}

/// How many bytes an entry has when it is unpacked, at most one more than `most`; those of a damaged one are not what its checksum says.
fn unpacked(entry: &Entry<'_>, most: u64, watch: &mut dyn FnMut(&[u8]) -> bool) -> Result<u64, String> {
    const STORED: u16 = 0;
    const DEFLATED: u16 = 8;
    let damaged =
        || format!("is damaged: {} in it cannot be unpacked", shortened(&String::from_utf8_lossy(entry.name)));
    let mut packed: Box<dyn Read> = match entry.method {
        STORED => Box::new(entry.bytes.get(..entry.size).ok_or_else(damaged)?),
        DEFLATED => Box::new(DeflateDecoder::new(entry.bytes)),
        method => return Err(format!("is packed in a way that is not read (method {method}); save it anew")),
    };
    let (mut block, mut crc, mut size) = (vec![0; 1 << 16], Crc::new(), 0);
    while size <= most {
        let read = packed.read(&mut block).map_err(|_| damaged())?;
        let Some(bytes) = block.get(..read).filter(|bytes| !bytes.is_empty()) else {
            return if crc.sum() == entry.checksum { Ok(size) } else { Err(damaged()) };
        };
        if !watch(bytes) {
            return Err("spans more cells than can be held in memory; save its sheet as CSV".to_owned());
        }
        crc.update(bytes);
        size += read as u64;
    }
    Ok(size)
}

/// All that an archive's table lists; `None` where the archive is cut off.
fn entries(archive: &[u8]) -> Option<Vec<Entry<'_>>> {
    let half = |at: usize| Some(u16::from_le_bytes(archive.get(at..at.checked_add(2)?)?.try_into().ok()?));
    let word = |at: usize| Some(u32::from_le_bytes(archive.get(at..at.checked_add(4)?)?.try_into().ok()?));
    // The table's own end is the last thing but a comment.
    const END: &[u8] = b"PK\x05\x06";
    let from = archive.len().saturating_sub(22 + (1 << 16));
    let end = from + archive.get(from..)?.windows(END.len()).rposition(|window| window == END)?;
    let (count, mut at) = (half(end + 10)?, word(end + 16)? as usize);
    let mut entries = Vec::new();
    for _ in 0..count {
        if word(at)? != 0x0201_4b50 {
            return None;
        }
        let [name, extra, comment] = [28, 30, 32].map(|place| half(at + place).map_or(0, usize::from));
        let local = word(at + 42)? as usize;
        let data = local + 30 + usize::from(half(local + 26)?) + usize::from(half(local + 28)?);
        entries.push(Entry {
            name: archive.get(at + 46..at + 46 + name)?,
            method: half(at + 10)?,
            checksum: word(at + 16)?,
            size: word(at + 24)? as usize,
            bytes: archive.get(data..)?,
        });
        at += 46 + name + extra + comment;
    }
    Some(entries)
}

/// Counts what is claimed in tags: cells that a spreadsheet of OpenDocument repeats, and texts that a workbook of Excel shares.
#[derive(Default)]
struct Claims {
    /// The tag that is being read, as far as it matters, its last two bytes, and the quote that is open in it.
    tag: Vec<u8>,
    last: [u8; 2],
    quote: Option<u8>,
    is_inside: bool,
    rows: u64,
    columns: u64,
    /// The last column of the row that holds something.
    width: u64,
    all: u64,
}

/// Most bytes of a tag that are looked at.
const LONGEST_TAG: usize = 1 << 16;

impl Claims {
    /// Takes what comes next; false where it is too much.
    fn take(&mut self, bytes: &[u8]) -> bool {
        for &byte in bytes {
            let is_comment = self.tag.starts_with(b"!--");
            match byte {
                _ if !self.is_inside => {
                    if byte == b'<' {
                        (self.is_inside, self.quote) = (true, None);
                        self.tag.clear();
                    }
                }
                b'>' if (is_comment && self.last == *b"--") || (!is_comment && self.quote.is_none()) => {
                    self.is_inside = false;
                    self.close();
                }
                _ => {
                    match (byte, self.quote) {
                        (b'"' | b'\'', None) => self.quote = Some(byte),
                        (_, Some(open)) if open == byte => self.quote = None,
                        _ => {}
                    }
                    if self.tag.len() < LONGEST_TAG {
                        self.tag.push(byte);
                    }
                }
            }
            self.last = [self.last[1], byte];
        }
        self.all <= MOST_CELLS
    }

    fn close(&mut self) {
        let tag = self.tag.as_slice();
        let name = tag.split(|byte| b" \t\r\n/".contains(byte)).next().unwrap_or_default();
        let claimed = |name: &[u8]| {
            let place = tag.windows(name.len()).position(|window| window == name)? + name.len() + 2;
            let digits = tag.get(place..)?.iter().map_while(|byte| byte.is_ascii_digit().then_some(char::from(*byte)));
            // What is no number cannot be read later on either.
            Some(digits.collect::<String>().parse().unwrap_or(u64::MAX))
        };
        let holds = |name: &[u8]| tag.windows(name.len()).any(|window| window == name);
        match name {
            // What is claimed behind the part that is looked at is not known.
            _ if tag.len() == LONGEST_TAG && !tag.starts_with(b"!--") => self.all = u64::MAX,
            b"table:table-row" => {
                (self.rows, self.columns, self.width) = (claimed(b"table:number-rows-repeated").unwrap_or(1), 0, 0);
            }
            b"table:table-cell" | b"table:covered-table-cell" => {
                self.columns = self.columns.saturating_add(claimed(b"table:number-columns-repeated").unwrap_or(1));
                if holds(b"office:value-type") || holds(b"table:formula") {
                    self.width = self.columns;
                }
            }
            b"" if tag == b"/table:table-row" => {
                self.all = self.all.saturating_add(self.width.saturating_mul(self.rows));
            }
            _ if name.ends_with(b"sst") => self.all = self.all.saturating_add(claimed(b"uniqueCount").unwrap_or(0)),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Claims;

    #[test]
    fn repeated_cells_are_counted_and_empty_ones_at_the_end_are_not() {
        let mut cells = Claims::default();
        let text = "<table:table-row table:number-rows-repeated=\"3\"><table:table-cell office:value-type=\"float\" \
                    table:number-columns-repeated=\"4\"/><table:table-cell table:number-columns-repeated=\"16380\"/></table:table-row>\
                    <table:table-row><table:table-cell/><table:table-cell office:value-type=\"string\"><text:p>x</text:p></table:table-cell></table:table-row>\
                    <table:table-row table:number-rows-repeated=\"1048000\"><table:table-cell table:number-columns-repeated=\"16384\"/></table:table-row>";
        for part in text.as_bytes().chunks(7) {
            assert!(cells.take(part));
        }
        assert_eq!(cells.all, 14);
        let row = "<table:table-row table:number-rows-repeated=\"1000\"><table:table-cell office:value-type=\"float\" \
                   table:number-columns-repeated=\"99999999999999999999\"/></table:table-row>";
        assert!(!cells.take(row.as_bytes()));
        let mut quoted = Claims::default();
        let text = "<!-- ' > --><table:table-row><table:table-cell office:value='>' office:value-type=\"float\" \
                    table:number-columns-repeated='7'/></table:table-row>";
        assert!(quoted.take(text.as_bytes()) && quoted.all == 7, "{}", quoted.all);
        for claim in ["<sst count=\"1\" uniqueCount=\"4000000000\">", "<x:sst uniqueCount='-1'>"] {
            assert!(!Claims::default().take(claim.as_bytes()), "{claim}");
        }
    }
}
