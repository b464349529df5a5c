//! Every key that a spec may hold, with its meaning: what the reader accepts, `coilsense init` writes and `book/src/guide/spec.md` lists.
//!
//! Next door: reading them (`section` and one file per table), the commented template (`template`).

mod cam;
mod conditions;
mod contact;
mod control;
mod domain;
mod experiment;
mod rig;
mod sensors;
pub(super) mod springs;

pub(crate) use domain::Domain;
pub use experiment::EXPERIMENT_TABLES;
#[cfg(feature = "reference")]
pub use experiment::experiment_markdown;

/// One key of a table.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// A value as it is written in a spec.
    pub example: &'static str,
    /// What it means, in a sentence.
    pub meaning: &'static str,
    /// What holds where it is left out; `None` where it must be there, or only one of several need be.
    pub default: Option<&'static str>,
    /// The kinds to which it applies; all where empty.
    pub kinds: &'static [&'static str],
}

/// One table of a spec.
#[derive(Debug, Clone, Copy)]
pub struct Table {
    /// Its name without brackets.
    pub name: &'static str,
    /// Whether there may be several: `[[name]]`.
    pub repeats: bool,
    /// What it is for, in a sentence.
    pub meaning: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
}

/// All tables, in the order in which one writes them.
pub const TABLES: [&Table; 11] = [
    &springs::SPRING,
    &springs::SECTION,
    &springs::MOUNT,
    &contact::CONTACT,
    &conditions::CONDITION,
    &cam::CAM,
    &sensors::SENSOR,
    &sensors::GOAL,
    &sensors::UNCERTAINTY,
    &rig::RIG,
    &control::CONTROL,
];

/// A key that must be there.
const fn needed(name: &'static str, example: &'static str, meaning: &'static str) -> Key {
    Key { name, example, meaning: told(meaning), default: None, kinds: &[] }
}

/// A key that may be left out.
const fn optional(name: &'static str, example: &'static str, meaning: &'static str, default: &'static str) -> Key {
    Key { name, example, meaning: told(meaning), default: Some(told(default)), kinds: &[] }
}

/// Words of the reference; without it nothing reads them, and a page need not load them.
const fn told(words: &'static str) -> &'static str {
    if cfg!(feature = "reference") { words } else { "" }
}

impl Key {
    /// The same for some kinds only.
    const fn of(self, kinds: &'static [&'static str]) -> Self {
        Self { kinds, ..self }
    }

    /// Whether it applies to a kind.
    pub fn applies_to(&self, kind: Option<&str>) -> bool {
        self.kinds.is_empty() || kind.is_none_or(|kind| self.kinds.contains(&kind))
    }
}

impl Table {
    /// Names of the keys that apply to a kind, or of all.
    pub(super) fn names(&self, kind: Option<&str>) -> Vec<&'static str> {
        self.keys.iter().filter(|key| key.applies_to(kind)).map(|key| key.name).collect()
    }

    /// Names of all keys that a table may hold, of whatever kind, with tables; those of springs beside the first only where it `also` is one.
    pub(super) fn names_of_any(&self, also: Option<&str>) -> Vec<&'static str> {
        let any = self.names_with_tables(None);
        if also.is_some() {
            return any;
        }
        let of_others = |name: &str| self.keys.iter().any(|key| key.name == name && key.kinds == [springs::BESIDE]);
        any.into_iter().filter(|name| !of_others(name)).collect()
    }

    /// The same, and tables that it may hold.
    pub(super) fn names_with_tables(&self, kind: Option<&str>) -> Vec<&'static str> {
        let mut names = self.names(kind);
        if self.name == springs::SPRING.name && kind.is_none_or(|kind| kind == springs::BY_SECTIONS) {
            names.push(springs::SECTIONS);
        }
        names
    }

    /// A table that it may hold several of, by its key.
    pub(super) fn child(&self, key: &str) -> Option<&'static Table> {
        TABLES
            .into_iter()
            .find(|table| table.name.strip_prefix(self.name).and_then(|rest| rest.strip_prefix('.')) == Some(key))
    }

    /// Whether it stands within another.
    pub(super) fn is_inner(&self) -> bool {
        self.name.contains('.')
    }

    /// As a spec writes it: `[name]` or `[[name]]`.
    pub fn heading(&self) -> String {
        match self.repeats {
            true => format!("[[{}]]", self.name),
            false if self.name.is_empty() => "the top of the file".to_owned(),
            false => format!("[{}]", self.name),
        }
    }
}

/// The reference of all keys, as Markdown: `book/src/guide/spec.md`.
#[cfg(feature = "reference")]
pub fn markdown() -> String {
    sections(INTRODUCTION, &TABLES)
}

/// A page of an introduction and a section for each table.
#[cfg(feature = "reference")]
fn sections(introduction: &str, tables: &[&Table]) -> String {
    let mut text = String::from(introduction);
    for table in tables {
        let heading = if table.name.is_empty() { "At the top".to_owned() } else { format!("`{}`", table.heading()) };
        text.push_str(&format!(
            "\n## {}\n\n{}\n\n| key | example | meaning | default |\n|---|---|---|---|\n",
            heading, table.meaning
        ));
        for key in table.keys {
            let kinds = if key.kinds.is_empty() { String::new() } else { format!(" *({})*", key.kinds.join(", ")) };
            let default = key.default.unwrap_or("needed");
            text.push_str(&format!("| `{}` | `{}` | {}{kinds} | {default} |\n", key.name, key.example, key.meaning));
        }
    }
    text
}

#[cfg(feature = "reference")]
const INTRODUCTION: &str = "# The spec file

A spec is a TOML file: a spring (or several), how it is mounted, what is done to it, which sensors watch it, and what they should achieve.
`coilsense init` writes a commented one. `coilsense spring`, `simulate`, `analyze` and `rig` all read it.

Quantities are texts of a number and a unit, such as `\"760 N/m\"`; pure numbers carry no quotes, and decimals a point. Besides SI units with
their prefixes `in`, `ft`, `mil`, `lb`, `oz`, `lbf`, `kgf`, `gf`, `lbf/in`, `kgf/mm`, `km/h` and `deg` are taken; one that is not is refused with
those that are. An unknown key is an error that says what it probably means. Where a kind stands in brackets, the key belongs to that kind only. This page is made from the table that the reader
itself uses (`crates/coilsense-lab/src/spec/keys`); a test keeps the two equal.
";
