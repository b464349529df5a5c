//! `record.toml`: who recorded what, how, and what may be done with it.
//!
//! Next door: whether it is whole (`checks`).

use std::path::Path;

use serde::Deserialize;

use super::RecordError;
use crate::input;

/// Its name.
pub const FILE: &str = "record.toml";

/// One to fill in.
pub const TEMPLATE: &str = include_str!("template.toml");

/// What it holds.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub who: Who,
    pub spring: SpringEntry,
    #[serde(default)]
    pub instrument: Vec<Instrument>,
    #[serde(default)]
    pub log: Vec<LogEntry>,
}

/// Who recorded it, and what may be done with it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Who {
    #[serde(default)]
    pub name: String,
    #[serde(default)]
    pub date: String,
    #[serde(default)]
    pub place: String,
    #[serde(default)]
    pub licence: String,
}

/// The spring and what holds it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SpringEntry {
    #[serde(default)]
    pub spec: String,
    #[serde(default)]
    pub described: String,
    #[serde(default)]
    pub mount: String,
}

/// What made a channel.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Instrument {
    pub channel: String,
    #[serde(default)]
    pub is: String,
    #[serde(default)]
    pub range: String,
    #[serde(default)]
    pub filter: String,
}

/// A log.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LogEntry {
    pub file: String,
    pub kind: Kind,
    pub mapping: Option<String>,
    pub length: Option<String>,
}

/// What a log is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Ten seconds of nothing.
    Silence,
    /// There and back over the range in use.
    Stretch,
    /// The coil or a seat is hit.
    Hits,
    /// The table and the frame are hit.
    Table,
}

impl Kind {
    /// As `record.toml` has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Silence => "silence",
            Self::Stretch => "stretch",
            Self::Hits => "hits",
            Self::Table => "table",
        }
    }
}

impl File {
    pub fn read(folder: &Path) -> Result<Self, RecordError> {
        let path = folder.join(FILE);
        let name = path.display();
        if !path.is_file() {
            let begin = format!(
                "{name} is not there; write one to fill in with: coilsense record {} --begin",
                folder.display()
            );
            return Err(RecordError::of(begin));
        }
        input::note(&path);
        let text = std::fs::read_to_string(&path).map_err(|error| RecordError::of(format!("{name}: {error}")))?;
        toml::from_str(&text).map_err(|error| {
            let line = error.span().map_or(0, |span| text[..span.start].matches('\n').count() + 1);
            RecordError::of(format!("{name}:{line}: {}", error.message().replace('\n', " ")))
        })
    }
}
