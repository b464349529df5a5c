//! The options of the commands that read a folder of logs.
//!
//! Next door: the other commands (the parent), how a log is read (`crate::recording::request`).

use crate::request::{CHECK, DATE, IfAbsent, JSON, OVERWRITE, OVERWRITE_OUT, Row, Takes, out};

/// Where the experiment lies.
pub const FOLDER: Row = Row {
    name: "folder",
    takes: Takes::File("DIR"),
    if_absent: IfAbsent::Refused,
    meaning: "Folder with experiment.toml, which lists the logs: see book/src/guide/experiment.md",
    by_place: true,
    ..Row::PLAIN
};
pub(super) const EXPERIMENT: [Row; 4] =
    [JSON, Row { if_absent: IfAbsent::Value("out/experiment"), ..super::FIGURES }, OVERWRITE, DATE];

/// A record's folder.
pub const RECORD_FOLDER: Row = Row {
    meaning: "Folder with record.toml, which says who recorded what, and lists the logs: see book/src/guide/record.md",
    ..FOLDER
};
/// Writes what is to be filled in.
pub const BEGIN: Row = Row {
    name: "begin",
    meaning: "Write a record.toml to fill in into the folder",
    conflicts: &["out", "check"],
    ..Row::PLAIN
};
pub(super) const RECORD: [Row; 6] = [
    RECORD_FOLDER,
    BEGIN,
    Row {
        takes: Takes::File("FILE"),
        elsewhere: &[],
        ..out(
            "ZIP archive to send (FILE.zip), with every file as it is; refused while something is missing",
            IfAbsent::Nothing,
        )
    },
    JSON,
    Row { meaning: "Exit with code 3 where something is missing or doubtful", elsewhere: &[], ..CHECK },
    Row { elsewhere: &[], ..OVERWRITE_OUT },
];
