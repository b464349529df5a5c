//! Workbooks: which sheet is the log, what its cells are, and what is wrong with one, in one line.

use std::path::{Path, PathBuf};

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping, Recording};

use super::fixtures::mapping;

fn golden(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/logs").join(name)
}

fn read(path: &Path, mapping: &Mapping, cleaning: &Cleaning) -> Result<Recording, String> {
    let found = Recording::read(path, mapping, cleaning).map_err(|error| error.to_string());
    let folder = format!("{}/", path.parent().unwrap().display());
    // Once, so that a line to paste keeps it.
    found.map_err(|message| message.replacen(&folder, "", 1))
}

/// The log of other programs as text.
fn text() -> Recording {
    read(&golden("motion.csv"), &mapping(&["F_i=counts [N]"]), &Cleaning::default()).unwrap()
}

/// What a workbook holds of numbers: openpyxl writes 16 digits, the others all.
fn held(name: &str, numbers: &[f64]) -> Vec<f64> {
    let short = |number: &f64| format!("{number:.15e}").parse().unwrap();
    if name == "motion.xlsx" { numbers.iter().map(short).collect() } else { numbers.to_vec() }
}

#[test]
fn a_workbook_of_openpyxl_and_of_odfpy_is_the_log() {
    for (name, kind) in [("motion.xlsx", "Excel workbook (.xlsx)"), ("motion.ods", "OpenDocument spreadsheet (.ods)")] {
        // A sheet of settings stands first, the titles over a row of units.
        let found = read(&golden(name), &mapping(&["F_i=counts [N]"]), &Cleaning::default()).unwrap();
        for channel in [Channel::OutputForce, Channel::Inductance, Channel::InputForce] {
            let told = held(name, text().channel(channel).unwrap());
            assert_eq!(found.channel(channel).unwrap(), told, "{name} {channel:?}");
        }
        assert_eq!(found.signals().time(), held(name, text().signals().time()));
        assert_eq!(found.account().description, format!("{kind}, sheet \"run\", header in row 2"));
        assert_eq!(found.remarks(), ["the rig, 21.11.2026"]);
    }
}

#[test]
fn a_sheet_can_be_told_and_has_stamps_gaps_and_stretches_of_time() {
    for name in ["motion.xlsx", "motion.ods"] {
        let told = |columns: &str| {
            Mapping::parse("map", &format!("[log]\nsheet = \"stamped\"\n[columns]\n{columns}")).unwrap()
        };
        let kept = Cleaning { drop_incomplete: true, ..Cleaning::default() };
        let found = read(&golden(name), &told("time = \"when\""), &kept).unwrap();
        // Five rows at 4 ms from noon on, the third without a force.
        let expected = [0.0, 0.004, 0.012, 0.016].map(|second| 43_200.0 + second);
        assert_eq!(found.signals().time(), expected, "{name}");
        assert_eq!(found.account().left_out(), 1);
        let found = read(&golden(name), &told("time = \"elapsed\""), &kept).unwrap();
        assert_eq!(found.signals().time(), [0.0, 0.004, 0.012, 0.016], "{name}");
        // A share of 5 % is 0.05, a truth value no number.
        let shares = read(&golden(name), &told("time = \"when\"\nF_i = \"share [N]\""), &kept).unwrap();
        assert_eq!(shares.channel(Channel::InputForce).unwrap(), held(name, &[0.0, 0.05, 3.0 * 0.05, 0.2]));
        let message =
            read(&golden(name), &told("time = \"when\"\nF_i = \"ok [N]\""), &Cleaning::default()).unwrap_err();
        let words =
            format!("{name}:3: column 5 \"ok\": \"TRUE\" is not a number; --drop-incomplete leaves such rows out");
        assert_eq!(message, words);
        let none = Mapping::parse("map", "[log]\nsheet = \"Run 3\"").unwrap();
        let message = read(&golden(name), &none, &kept).unwrap_err();
        assert_eq!(message, format!("{name}: no sheet is called \"Run 3\"; it has \"settings\", \"run\", \"stamped\""));
    }
}

/// A ZIP archive of one deflated file, which says nothing of its own size.
fn archive(files: &[(&str, &[u8])]) -> Vec<u8> {
    let (mut archive, mut table) = (Vec::new(), Vec::new());
    for (name, bytes) in files {
        let mut packed = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::best());
        std::io::Write::write_all(&mut packed, bytes).unwrap();
        let packed = packed.finish().unwrap();
        let mut crc = flate2::Crc::new();
        crc.update(bytes);
        let mut common = vec![20, 0, 0, 0, 8, 0, 0, 0, 0, 0];
        for word in [crc.sum(), packed.len() as u32, bytes.len() as u32, name.len() as u32] {
            common.extend_from_slice(&word.to_le_bytes());
        }
        table.extend_from_slice(b"PK\x01\x02\x14\0");
        table.extend_from_slice(&common);
        table.extend_from_slice(&[0; 10]);
        table.extend_from_slice(&(archive.len() as u32).to_le_bytes());
        table.extend_from_slice(name.as_bytes());
        archive.extend_from_slice(b"PK\x03\x04");
        archive.extend_from_slice(&common);
        archive.extend_from_slice(name.as_bytes());
        archive.extend_from_slice(&packed);
    }
    let place = archive.len() as u32;
    archive.extend_from_slice(&table);
    archive.extend_from_slice(b"PK\x05\x06\0\0\0\0");
    archive.extend_from_slice(&(files.len() as u16).to_le_bytes().repeat(2));
    archive.extend_from_slice(&(table.len() as u32).to_le_bytes());
    archive.extend_from_slice(&place.to_le_bytes());
    archive.extend_from_slice(&[0, 0]);
    archive
}

#[test]
fn what_is_wrong_with_a_workbook_is_said_in_one_line() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("run.xlsx");
    let good = std::fs::read(golden("motion.xlsx")).unwrap();
    let zeros = vec![0; 300 << 20];
    let wide =
        b"<table:table-row table:number-rows-repeated=\"1048576\"><table:table-cell office:value-type=\"float\" \
                 table:number-columns-repeated=\"16384\"/></table:table-row>";
    let kind = b"application/vnd.oasis.opendocument.spreadsheet";
    let mut ods = archive(&[("content.xml", wide)]);
    // The kind is stored as it is.
    ods = stored_first("mimetype", kind, &ods);
    let secret: Vec<u8> = "EncryptedPackage".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let old = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";
    // A bit of the packed sheet: a number would be another.
    let mut flipped = good.clone();
    let name = b"xl/worksheets/sheet2.xml";
    let sheet = good.windows(name.len()).position(|window| window == name).unwrap();
    flipped[sheet + 600] ^= 4;
    for (bytes, words) in [
        (flipped, "run.xlsx: is damaged: xl/worksheets/sheet2.xml in it cannot be unpacked"),
        (good[..good.len() - 30].to_vec(), "run.xlsx: is a ZIP archive that is cut off or damaged"),
        (
            archive(&[("a.csv", b"time [s],F_o [N]\n0,1\n")]),
            "run.xlsx: is a ZIP archive, which is not read; unpack it first: unzip /",
        ),
        (archive(&[("xl/workbook.xml", b"<nothing/>")]), "run.xlsx: "),
        (
            archive(&[("xl/workbook.xml", b"<a/>"), ("xl/sharedStrings.xml", &zeros)]),
            "run.xlsx: is a workbook that is too large to be held in memory; save it as CSV",
        ),
        (
            archive(&[
                ("xl/workbook.xml", b"<a/>"),
                ("xl/sharedStrings.xml", b"<sst uniqueCount=\"4000000000\"></sst>"),
            ]),
            "run.xlsx: spans more cells than can be held in memory; save its sheet as CSV",
        ),
        (ods, "run.xlsx: spans more cells than can be held in memory; save its sheet as CSV"),
        ([old, secret.as_slice()].concat(), "run.xlsx: is a workbook that opens with a password only"),
        (
            [old.as_slice(), &[0; 600]].concat(),
            "run.xlsx: is a file of old Office (.xls), which is not read; convert it by: soffice --headless --convert-to xlsx /",
        ),
        (
            archive(&[("xl/workbook.bin", b"")]),
            "run.xlsx: is a binary workbook (.xlsb), which is not read; convert it by: soffice --headless --convert-to xlsx /",
        ),
    ] {
        std::fs::write(&path, &bytes).unwrap();
        let message = read(&path, &Mapping::default(), &Cleaning::default()).unwrap_err();
        assert!(message.starts_with(words) && message.lines().count() == 1, "{message}");
    }
}

/// An archive with one more file, as it is, before all others.
fn stored_first(name: &str, bytes: &[u8], archive: &[u8]) -> Vec<u8> {
    let mut crc = flate2::Crc::new();
    crc.update(bytes);
    let mut common = vec![20, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    for word in [crc.sum(), bytes.len() as u32, bytes.len() as u32, name.len() as u32] {
        common.extend_from_slice(&word.to_le_bytes());
    }
    let end = archive.len() - 22;
    let place = u32::from_le_bytes(archive[end + 16..end + 20].try_into().unwrap()) as usize;
    let mut table = archive[place..end].to_vec();
    let local = [b"PK\x03\x04", common.as_slice(), name.as_bytes(), bytes].concat();
    // The only other entry lies behind it.
    table[42..46].copy_from_slice(&(local.len() as u32).to_le_bytes());
    let entry = [b"PK\x01\x02\x14\0", common.as_slice(), &[0; 14], name.as_bytes()].concat();
    let all = [local.as_slice(), &archive[..place], &entry, &table].concat();
    let place = (all.len() - entry.len() - table.len()) as u32;
    let size = (entry.len() + table.len()) as u32;
    [&all, b"PK\x05\x06\0\0\0\0\x02\0\x02\0".as_slice(), &size.to_le_bytes(), &place.to_le_bytes(), &[0, 0]].concat()
}
