//! A spec as its tables, whose values can be replaced before it is read: one design among many.
//!
//! Next door: the tables (`document`), which keys there are (`keys`), who replaces values (`crate::sweep`).

use std::sync::Arc;

use coilsense::Channel;
use toml::de::DeValue;

use super::cam::CamSpec;
use super::condition::ConditionSpec;
use super::contact::ContactCase;
use super::control::ControlSpec;
use super::document::{Document, inner};
use super::goal::{Goal, UncertaintySpec};
use super::keys::{Domain, TABLES, Table};
use super::mount::MountSpec;
use super::recordings::Recordings;
use super::rig::RigSpec;
use super::section::Section;
use super::sensor::SensorSpec;
use super::setting::Setting;
use super::spring::{Model, SpringSpec};
use super::strength::StrengthSpec;
use super::synonyms::synonym;
use super::{Files, Spec, SpecError};
use crate::likeness::alike;

/// A spec's tables.
#[derive(Clone)]
pub(crate) struct Draft<'a> {
    document: Document<'a>,
    recordings: Arc<Recordings>,
}

/// Where a value stands in a spec.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Place {
    /// `spring`, or `spring.section` of a table within it.
    pub(super) table: &'static str,
    /// Which of several tables of that name.
    pub(super) index: Option<usize>,
    pub(super) key: &'static str,
    /// What the key takes.
    pub domain: Domain,
}

/// What forces follow from; instruments and what is asked of them are left out.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Core {
    pub spring: SpringSpec,
    pub mount: MountSpec,
    pub conditions: Vec<ConditionSpec>,
    pub goal: Goal,
}

impl<'a> Draft<'a> {
    /// The tables of a spec's text, which must all be known.
    pub fn parse(file: &'a str, text: &'a str) -> Result<Self, SpecError> {
        Ok(Self { document: Document::parse(file, text)?, recordings: Arc::default() })
    }

    /// The same where all keys have been found to be known.
    pub fn known(self) -> Self {
        Self { document: self.document.known(), ..self }
    }

    /// The same with recorded files that others have read already, or will.
    pub fn sharing(self, recordings: &Arc<Recordings>) -> Self {
        Self { recordings: Arc::clone(recordings), ..self }
    }

    /// Puts a value in place of a key's: a number with its unit, a number, or a text without quotes.
    pub fn set(&mut self, place: &Place, value: String) {
        self.document.set(place.table, place.index, place.key, DeValue::String(value.into()));
    }

    /// Everything that the spec says.
    pub fn spec(&self, files: &Files<'_>) -> Result<Spec, SpecError> {
        let document = &self.document;
        let Core { spring, mount, conditions, goal } = self.core(files)?;
        let sensors = SensorSpec::parse_all(document, &spring)?;
        Ok(Spec {
            rig: RigSpec::parse(document, &sensors)?,
            uncertainty: UncertaintySpec::parse(document)?,
            strength: StrengthSpec::parse(document)?,
            cam: CamSpec::parse(document, &spring, files)?,
            control: ControlSpec::parse(document, &spring.spring, &mount)?,
            notes: document.notes().to_vec(),
            file: document.file().to_owned(),
            text: document.text().to_owned(),
            spring,
            mount,
            conditions,
            sensors,
            goal,
        })
    }

    /// What forces follow from.
    pub fn core(&self, files: &Files<'_>) -> Result<Core, SpecError> {
        let document = &self.document;
        let mut spring = SpringSpec::of(&document.section("spring")?)?;
        let end_type = spring.geometry.parameters().end_type;
        // First, for dampings count the masses that the chain then has.
        spring.follow_helix(&MountSpec::ends(document, end_type)?);
        let mount = MountSpec::parse(document, &spring.spring, end_type)?;
        let mount = if spring.model == Model::Helix { for_helix(&document.section("spring")?, mount)? } else { mount };
        let contacts = ContactCase::parse_all(document, &spring, mount.far_end())?;
        let mount = mount.by_contacts(&contacts);
        if contacts.is_empty() && !document.sections("condition")?.is_empty() {
            let section = document.section("spring")?;
            if let Some(length) = spring.closes_in_use() {
                let why = format!(
                    "close from {:.3} mm on, within the range in use: give a table [contact] with windings = \"hard\", or raise min_length",
                    1e3 * length
                );
                return Err(section.refuse("section", why));
            }
        }
        let setting = Setting { spring: &spring.spring, mount: &mount, files, recordings: &self.recordings };
        let conditions = ConditionSpec::parse_all(document, &setting)?;
        Ok(Core { conditions, goal: Goal::parse(document, &spring.spring)?, spring, mount })
    }

    /// Where a dotted key stands: `spring.stiffness`, `spring.section.2.pitch`, `condition.1.velocity`, `sensor."laser".delay`.
    ///
    /// # Errors
    /// One line that names the nearest known key, or the tables there are.
    pub fn place(&self, path: &str) -> Result<Place, String> {
        let (head, rest) = path.split_once('.').ok_or_else(|| unknown(path))?;
        let (middle, last) = match rest.rsplit_once('.') {
            Some((middle, last)) => (Some(middle.trim().trim_matches('"')), last),
            None => (None, rest),
        };
        let table = TABLES.into_iter().find(|table| table.name == head.trim()).ok_or_else(|| unknown(path))?;
        let (table, middle) = within(table, middle).unwrap_or((table, middle));
        let key = table.keys.iter().find(|key| key.name == last.trim()).ok_or_else(|| match inner(table.name) {
            Some(_) => format!("{path}: no key of {}; allowed: {}", table.heading(), table.names(None).join(", ")),
            None => unknown(path),
        })?;
        let index = match (table.repeats, middle) {
            (true, Some(name)) => Some(self.index_of(table, name)?),
            (false, None) => None,
            (true, None) => return Err(format!("{path}: say which: {}", self.examples(table, key.name))),
            (false, Some(_)) => {
                return Err(format!("{path}: there is one table [{}]; write {}.{}", table.name, table.name, key.name));
            }
        };
        let domain = table.domain(key);
        if domain == Domain::List {
            return Err(format!("{path}: takes a list, which cannot be swept"));
        }
        Ok(Place { table: table.name, index, key: key.name, domain })
    }

    /// Number of a table by its name, else by its number from 1.
    fn index_of(&self, table: &Table, name: &str) -> Result<usize, String> {
        let names = self.names(table);
        let by_number =
            || name.parse::<usize>().ok().filter(|number| (1..=names.len()).contains(number)).map(|n| n - 1);
        names.iter().position(|known| known == name).or_else(by_number).ok_or_else(|| {
            let numbered = |(n, name): (usize, &String)| match name.as_str() {
                "" => format!("{}", n + 1),
                name => format!("{} {name:?}", n + 1),
            };
            let known: Vec<String> = names.iter().enumerate().map(numbered).collect();
            let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
            format!("no {} {name:?} is there; there are: {known}", table.name)
        })
    }

    /// The force that counts as true, as far as the spec says it by itself.
    pub fn truth(&self) -> Channel {
        let section = self.document.optional_section("goal").ok().flatten();
        let word = section.and_then(|section| section.optional_text("force").ok().flatten());
        let named = Channel::FORCES.into_iter().find(|force| Some(force.name()) == word.as_deref());
        named.unwrap_or(Channel::DeflectionForce)
    }

    /// What tables of one kind are called, in order.
    ///
    /// Those within another have numbers only.
    pub fn names(&self, table: &Table) -> Vec<String> {
        if let Some((outer, inner)) = inner(table.name) {
            let outer = self.document.optional_section(outer).ok().flatten();
            return vec![String::new(); outer.map_or(0, |outer| outer.number_of(inner))];
        }
        let sections = self.document.sections(table.name).unwrap_or_default();
        let name = |section: &super::section::Section<'_>| {
            let text = |key| section.optional_text(key).ok().flatten();
            text("name").or_else(|| text("class")).or_else(|| text("kind")).unwrap_or_default()
        };
        sections.iter().map(name).collect()
    }

    fn examples(&self, table: &Table, key: &str) -> String {
        match self.names(table).first() {
            Some(first) if first.is_empty() => format!("{}.1.{key}", table.name),
            Some(first) => format!("{}.\"{first}\".{key}, or by its number: {}.1.{key}", table.name, table.name),
            None => format!("there is no [[{}]] in the spec", table.name),
        }
    }
}

/// The table within one that a dotted key is of, and which of those: of `spring` and `section.2` the second `[[spring.section]]`.
fn within<'p>(table: &Table, middle: Option<&'p str>) -> Option<(&'static Table, Option<&'p str>)> {
    let middle = middle?;
    let (name, which) = middle.split_once('.').map_or((middle, None), |(name, which)| (name, Some(which.trim())));
    Some((table.child(name.trim())?, which))
}

/// The mount of a helix, in each way in which its ends may be held.
fn for_helix(section: &Section<'_>, mount: MountSpec) -> Result<MountSpec, SpecError> {
    if section.has("masses_per_winding") {
        let why = "\"helix\" does not take masses_per_winding: it has no masses; \"coil\" does";
        return Err(section.refuse("model", why));
    }
    Ok(mount.by_ways())
}

/// An unknown key, and the one that is probably meant.
fn unknown(path: &str) -> String {
    let (head, tail) = (path.split('.').next().unwrap_or_default(), path.rsplit('.').next().unwrap_or_default());
    let (head, tail) = (head.trim(), tail.trim());
    let likeness = |table: &str, key: &str| strsim::jaro_winkler(tail, key) + 0.5 * strsim::jaro_winkler(head, table);
    let all = TABLES.iter().flat_map(|table| table.keys.iter().map(|key| (*table, key.name)));
    let nearest = || {
        let alike = all.filter(|(_, key)| alike(tail, key));
        alike.max_by(|a, b| likeness(a.0.name, a.1).total_cmp(&likeness(b.0.name, b.1)))
    };
    let table = TABLES.into_iter().find(|table| table.name == head);
    let synonym = table.and_then(|table| Some((table, synonym(table, None, tail)?.0)));
    let meant = synonym.or_else(nearest).map_or_else(String::new, |(table, key)| match table.repeats {
        true => format!("did you mean {}.NAME.{key}? ", table.name),
        false => format!("did you mean {}.{key}? ", table.name),
    });
    format!("{path}: no key of a spec; {meant}book/src/guide/spec.md lists all")
}
