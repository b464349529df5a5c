//! A spec as its tables, whose values can be replaced before it is read: one design among many.
//!
//! Next door: the tables (`document`), which keys there are (`keys`), who replaces values (`crate::sweep`).

use std::sync::Arc;

use coilsense::Channel;
use toml::de::DeValue;

use super::beside::{Alone, Beside, Side, check_together};
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
    /// Of a table within one of several springs, which of these.
    pub(super) spring: Option<usize>,
    /// Which of several tables of that name.
    pub(super) index: Option<usize>,
    pub(super) key: &'static str,
    /// What the key takes.
    pub domain: Domain,
}

impl Place {
    /// Whether it is that of a key of a spring.
    pub fn is_of_spring(&self, key: &str) -> bool {
        self.table == "spring" && self.key == key
    }
}

/// What forces follow from; instruments and what is asked of them are left out.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Core {
    pub spring: SpringSpec,
    pub mount: MountSpec,
    pub conditions: Vec<ConditionSpec>,
    pub goal: Goal,
    /// Springs between the same ends.
    pub beside: Vec<Beside>,
}

impl Core {
    /// F_nom \[N\], of several springs that of all.
    pub fn nominal_force(&self) -> f64 {
        nominal_force(&self.spring, &self.beside)
    }

    /// Each spring by itself, with which way it acts; the first comes first.
    pub fn each(self) -> Vec<(Side, Self)> {
        let Self { spring, mount, conditions, goal, beside } = self;
        let first = (Side::Same, Self { spring, mount, conditions, goal, beside: Vec::new() });
        let other = |it: Beside| {
            let Beside { side, spring, mount, conditions, .. } = it;
            (side, Self { spring, mount, conditions, goal, beside: Vec::new() })
        };
        [first].into_iter().chain(beside.into_iter().map(other)).collect()
    }
}

/// F_nom of the only spring, and of several their largest static force in use together, eq. (14) \[N\].
fn nominal_force(first: &SpringSpec, beside: &[Beside]) -> f64 {
    if beside.is_empty() || !cfg!(feature = "several-springs") {
        return first.spring.nominal_force();
    }
    let (shortest, longest) = first.spring.operating_range();
    let at = |length: f64| {
        let of = |it: &Beside| it.side.sign() * it.spring.spring.static_force(it.length_where(&first.spring, length));
        first.spring.static_force(length) + beside.iter().map(of).sum::<f64>()
    };
    at(shortest).abs().max(at(longest).abs())
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
        self.document.set(place.table, [place.spring, place.index], place.key, DeValue::String(value.into()));
    }

    /// Everything that the spec says.
    pub fn spec(&self, files: &Files<'_>) -> Result<Spec, SpecError> {
        let document = &self.document;
        let Core { spring, mount, conditions, goal, beside } = self.core(files)?;
        let strength = StrengthSpec::parse(&document.springs()?[0])?;
        let sensors = SensorSpec::parse_all(document, &spring, files)?;
        Ok(Spec {
            rig: RigSpec::parse(document, &sensors)?,
            uncertainty: UncertaintySpec::parse(document)?,
            strength,
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
            beside,
        })
    }

    /// What forces follow from.
    pub fn core(&self, files: &Files<'_>) -> Result<Core, SpecError> {
        let document = &self.document;
        let sections = document.springs()?;
        let Alone { spring, mount } = self.alone(&sections[0])?;
        let setting = Setting { spring: &spring.spring, mount: &mount, files, recordings: &self.recordings };
        let conditions = ConditionSpec::parse_all(document, &setting)?;
        let beside = if cfg!(feature = "several-springs") {
            self.beside(&sections, (&spring, &mount), &conditions)?
        } else {
            Vec::new()
        };
        let goal = Goal::parse(document, nominal_force(&spring, &beside))?;
        Ok(Core { conditions, goal, spring, mount, beside })
    }

    /// The springs beside the first.
    fn beside(
        &self,
        sections: &[Section<'_>],
        (first, mount): (&SpringSpec, &MountSpec),
        conditions: &[ConditionSpec],
    ) -> Result<Vec<Beside>, SpecError> {
        let mut beside: Vec<Beside> = Vec::new();
        for section in &sections[1..] {
            let alone = self.alone(section)?;
            let before = [first].into_iter().chain(beside.iter().map(|it| &it.spring));
            let each: Vec<&SpringSpec> = before.chain([&alone.spring]).collect();
            check_together(sections, &each, mount.far_end())?;
            StrengthSpec::parse(section)?;
            beside.push(Beside::of(section, alone, first, conditions)?);
        }
        if !beside.is_empty() {
            self.check_tables(&sections[1])?;
        }
        Ok(beside)
    }

    /// What no several springs have.
    fn check_tables(&self, second: &Section<'_>) -> Result<(), SpecError> {
        if let Some(sensor) = self.document.sections("sensor")?.first() {
            return Err(sensor.together("take no sensors: the forces of each and of all are told"));
        }
        let follows = self.document.optional_section("mount")?.is_some_and(|mount| mount.has("follower_mass"));
        if follows {
            return Err(second.together("take no follower_mass: they would move one another by it"));
        }
        Ok(())
    }

    /// A spring by itself, and what it stands on.
    fn alone(&self, section: &Section<'_>) -> Result<Alone, SpecError> {
        let document = &self.document;
        let mut spring = SpringSpec::of(section)?;
        let end_type = spring.geometry.parameters().end_type;
        // First, for dampings count the masses that the chain then has.
        spring.follow_helix(&MountSpec::ends(document, end_type)?);
        let mount = MountSpec::parse(document, &spring.spring, end_type)?;
        let mount = if spring.model == Model::Helix { for_helix(section, mount)? } else { mount };
        let contacts = ContactCase::parse_all(document, &spring, mount.far_end())?;
        let mount = mount.by_contacts(&contacts);
        let moves = contacts.is_empty() && !document.sections("condition")?.is_empty();
        if let Some(length) = spring.closes_in_use().filter(|_| moves) {
            let why = format!(
                "close from {:.3} mm on, within the range in use: give a table [contact] with windings = \"hard\", or raise min_length",
                1e3 * length
            );
            return Err(section.refuse("section", why));
        }
        Ok(Alone { spring, mount })
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
        let springs = table.name == "spring" && self.document.has_several_springs();
        let (spring, middle) = match middle.filter(|_| springs) {
            Some(middle) => self.one_spring(table, middle).map(|(number, rest)| (Some(number), rest))?,
            None => (None, middle),
        };
        let (table, middle) = within(table, middle).unwrap_or((table, middle));
        let key = table.keys.iter().find(|key| key.name == last.trim()).ok_or_else(|| match inner(table.name) {
            Some(_) => format!("{path}: no key of {}; allowed: {}", table.heading(), table.names(None).join(", ")),
            None => unknown(path),
        })?;
        if springs && spring.is_none() {
            let spring = TABLES.into_iter().find(|table| table.name == "spring").unwrap_or(table);
            let rest = path.split_once('.').map_or(key.name, |(_, rest)| rest);
            return Err(format!("{path}: say which: {}", self.examples(spring, rest)));
        }
        let index = match (table.repeats, middle) {
            (true, Some(name)) => Some(self.index_of(table, spring, name)?),
            (false, None) if inner(table.name).is_none() => spring,
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
        Ok(Place { table: table.name, spring, index, key: key.name, domain })
    }

    /// Which of several springs a dotted key is of, by its name or its number, and what of the key comes after that.
    fn one_spring<'p>(&self, table: &Table, middle: &'p str) -> Result<(usize, Option<&'p str>), String> {
        let after = |name: &str| {
            let rest = middle.strip_prefix(name)?;
            let rest = rest.strip_prefix('"').unwrap_or(rest);
            if rest.is_empty() { Some(None) } else { rest.strip_prefix('.').map(Some) }
        };
        let names = self.names(table);
        // The longest name that fits: one may begin with another and a point.
        let named = names.iter().enumerate().filter_map(|(number, name)| Some((number, name.len(), after(name)?)));
        let numbered = (0..names.len()).filter_map(|number| Some((number, 0, after(&(number + 1).to_string())?)));
        let found = named.chain(numbered).max_by_key(|(_, length, _)| *length);
        if let Some((number, _, rest)) = found {
            return Ok((number, rest));
        }
        self.index_of(table, None, middle.split('.').next().unwrap_or_default()).map(|number| (number, None))
    }

    /// Number of a table by its name, else by its number from 1.
    fn index_of(&self, table: &Table, spring: Option<usize>, name: &str) -> Result<usize, String> {
        let names = match spring.filter(|_| inner(table.name).is_some()) {
            Some(spring) => self.names_within(table, spring),
            None => self.names(table),
        };
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

    /// How many springs there are.
    pub fn springs(&self) -> usize {
        self.document.springs().map_or(0, |springs| springs.len())
    }

    /// What tables of one kind are called, in order.
    ///
    /// Those within another have numbers only.
    pub fn names(&self, table: &Table) -> Vec<String> {
        if inner(table.name).is_some() {
            return self.names_within(table, 0);
        }
        let sections = self.document.sections(table.name).unwrap_or_default();
        let name = |section: &super::section::Section<'_>| {
            let text = |key| section.optional_text(key).ok().flatten();
            text("name").or_else(|| text("class")).or_else(|| text("kind")).unwrap_or_default()
        };
        sections.iter().map(name).collect()
    }

    /// The same of tables within a spring.
    fn names_within(&self, table: &Table, spring: usize) -> Vec<String> {
        let (springs, name) = (self.document.springs().unwrap_or_default(), inner(table.name));
        let count = springs.get(spring).zip(name).map_or(0, |(spring, (_, name))| spring.number_of(name));
        vec![String::new(); count]
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
