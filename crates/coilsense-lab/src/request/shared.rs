//! Options that many verbs share: what is read, where it is written, what a report carries.
//!
//! Next door: the tables of the verbs (`report::VERBS`).

use super::{Allowed, Door, IfAbsent, Row, Takes};
use crate::quantity::Dimension;

/// The spec.
pub const SPEC: Row = Row {
    name: "spec",
    takes: Takes::File("SPEC"),
    if_absent: IfAbsent::Refused,
    meaning: "The spec",
    by_place: true,
    ..Row::PLAIN
};
/// Where files are written; what they are is said by each verb, see [`out`].
pub const OUT: Row = Row {
    name: "out",
    takes: Takes::File("DIR"),
    elsewhere: &[(Door::Python, "the result's method `save`"), (Door::Page, "its buttons that save")],
    ..Row::PLAIN
};
/// A length of the coil or its wire; verbs say which.
pub const LENGTH: Row = Row { takes: Takes::Quantity(Dimension::Length), allowed: Allowed::AboveZero, ..Row::PLAIN };
/// N of a coil; verbs say what for.
pub const WINDINGS: Row =
    Row { name: "windings", takes: Takes::Number, allowed: Allowed::Within(1.0, 1e6), ..Row::PLAIN };
/// The spec of a known spring; verbs say what is taken from it.
pub const KNOWN_SPRING: Row = Row {
    name: "spec",
    takes: Takes::File("SPEC"),
    elsewhere: &[(Door::Python, "spring"), (Door::Page, "spring")],
    ..Row::PLAIN
};
/// What may be replaced.
pub const OVERWRITE: Row = Row {
    name: "overwrite",
    meaning: "Replace files, too, that coilsense did not write or that have changed since; a file that is read never is",
    elsewhere: &[(Door::Python, "the result's method `save`"), (Door::Page, "its buttons that save")],
    ..Row::PLAIN
};
/// The same of files that are written only where a folder is named.
pub const OVERWRITE_OUT: Row = Row { requires: &["out"], ..OVERWRITE };
/// What programs read.
pub const JSON: Row = Row {
    name: "json",
    meaning: "Print JSON",
    elsewhere: &[(Door::Python, "the result's method `to_dict`"), (Door::Page, "its buttons that save")],
    ..Row::PLAIN
};
/// For scripts: an exit code of its own where the answer is no, or open; verbs say which.
pub const CHECK: Row = Row {
    name: "check",
    elsewhere: &[(Door::Python, "the result's `check`"), (Door::Page, "the verdict")],
    ..Row::PLAIN
};
/// The date of a report.
pub const DATE: Row = Row {
    name: "date",
    takes: Takes::Date,
    if_absent: IfAbsent::Found("today's"),
    meaning: "Date that the report carries, such as 2026-11-21",
    elsewhere: &[(Door::Python, "the result's method `save`"), (Door::Page, "today")],
    ..Row::PLAIN
};
/// The date of a report that is written only where a folder is named.
pub const DATE_OF_OUT: Row = Row { requires: &["out"], ..DATE };

/// The folder of a verb's files.
pub const fn out(meaning: &'static str, if_absent: IfAbsent) -> Row {
    Row { meaning, if_absent, ..OUT }
}
