//! What may be asked of a verb: one row an option, of which the command's arguments, the page's form and the reference are made.
//!
//! Next door: what was given (`given`), the options that many verbs share (`shared`), the rows of a verb (`mitigation::OPTIONS`), quantities
//! as text (`quantity`).

mod given;
mod shared;

pub use given::{Given, Value};
pub use shared::{
    CHECK, DATE, DATE_OF_OUT, JSON, KNOWN_SPRING, LENGTH, OUT, OVERWRITE, OVERWRITE_OUT, SPEC, WINDINGS, out,
};

use crate::quantity::Dimension;

/// A verb: what may be asked of it, in groups in the order in which they are told.
#[derive(Debug, Clone, Copy)]
pub struct Verb {
    /// The command's name.
    pub name: &'static str,
    /// What it does, in a line.
    pub about: &'static str,
    /// Its options.
    pub groups: &'static [&'static [Row]],
    /// What its help says at the end; empty where it says nothing.
    pub more: &'static str,
}

impl Verb {
    /// Its options, one by one.
    pub fn rows(&self) -> impl Iterator<Item = &'static Row> + use<> {
        self.groups.iter().flat_map(|group| group.iter())
    }
}

/// An option of a verb.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// As Python and JSON have it; [`Self::flag`] is the command's.
    pub name: &'static str,
    /// What it takes.
    pub takes: Takes,
    /// Which of these are allowed.
    pub allowed: Allowed,
    /// What holds where nothing is said.
    pub if_absent: IfAbsent,
    /// What it is, in a line.
    pub meaning: &'static str,
    /// Under which heading the command's help has it; empty for the common one.
    pub heading: &'static str,
    /// Whether the command takes it by its place, without a name.
    pub by_place: bool,
    /// Whether it may be given several times.
    pub repeated: bool,
    /// Options that cannot stand beside it.
    pub conflicts: &'static [&'static str],
    /// Options that must stand beside it.
    pub requires: &'static [&'static str],
    /// Doors that have no option of this name, and what says it there.
    pub elsewhere: &'static [(Door, &'static str)],
}

/// Where a verb is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Door {
    /// The command.
    Command,
    /// Python.
    Python,
    /// The page.
    Page,
}

/// What an option takes.
#[derive(Debug, Clone, Copy)]
pub enum Takes {
    /// A number with its unit.
    Quantity(Dimension),
    /// A plain number.
    Number,
    /// A whole number.
    Count,
    /// Nothing: it holds where it is said.
    Flag,
    /// One of these words.
    Word(&'static [&'static str]),
    /// A text; what stands for it in a line of help.
    Text(&'static str),
    /// A text of some form; what stands for it, and what says what is allowed where it has not that form.
    Form(&'static str, fn(&str) -> Result<(), String>),
    /// The path of a file or a folder; what stands for it.
    File(&'static str),
    /// A day.
    Date,
}

/// Which values are allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Allowed {
    /// Any finite one.
    Any,
    /// Those above zero.
    AboveZero,
    /// From the first to below the second, in the option's SI unit.
    Below(f64, f64),
    /// Above the first and below the second.
    Between(f64, f64),
    /// From the first to the second, both among them.
    Within(f64, f64),
}

/// What holds where nothing is said.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IfAbsent {
    /// Nothing: it is not asked for.
    Nothing,
    /// This, as it would be written.
    Value(&'static str),
    /// What the spec or the science says, in words.
    Found(&'static str),
    /// It has to be given.
    Refused,
    /// It has to be given where this other option is not.
    RefusedWithout(&'static str),
}

/// An option that cannot be, and why. Its text begins with the option as the command has it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}: {reason}", flag(.option))]
pub struct Wrong {
    /// The option's name.
    pub option: &'static str,
    /// One line.
    pub reason: String,
}

impl Row {
    /// An option that takes nothing; a row of a table says in what it differs.
    pub const PLAIN: Self = Self {
        name: "",
        takes: Takes::Flag,
        allowed: Allowed::Any,
        if_absent: IfAbsent::Nothing,
        meaning: "",
        heading: "",
        by_place: false,
        repeated: false,
        conflicts: &[],
        requires: &[],
        elsewhere: &[],
    };

    /// Its name as an option of the command, without dashes in front.
    pub fn flag(&self) -> String {
        flag(self.name)
    }

    /// What says it at a door that has no option of its name.
    pub fn elsewhere(&self, door: Door) -> Option<&'static str> {
        self.elsewhere.iter().find(|(other, _)| *other == door).map(|(_, what)| *what)
    }

    /// What stands for its value in a line of help.
    pub fn value_name(&self) -> &'static str {
        match self.takes {
            Takes::Count => "COUNT",
            Takes::Number => "NUMBER",
            Takes::Quantity(dimension) => dimension.placeholder(),
            Takes::Word(_) => "WORD",
            Takes::Date => "DATE",
            Takes::Flag => "",
            Takes::Text(name) | Takes::Form(name, _) | Takes::File(name) => name,
        }
    }

    /// Its value in SI units from what a person wrote.
    ///
    /// # Errors
    /// [`Wrong`], with what was written.
    pub fn value(&self, text: &str) -> Result<Value, Wrong> {
        self.read(text).map_err(|reason| self.wrong(format!("{reason}, got {text:?}")))
    }

    /// The same for who says by himself what was written.
    ///
    /// # Errors
    /// One line on what it must be, without the option's name and what was written.
    pub fn read(&self, text: &str) -> Result<Value, String> {
        match self.takes {
            Takes::Quantity(_) | Takes::Number => self.number(text).map(Value::Number),
            Takes::Count => match text.trim().parse::<u64>() {
                Ok(count) if self.allows(count as f64) => Ok(Value::Count(count)),
                Ok(_) => Err(format!("must be{}", self.range_in_words())),
                Err(_) if self.allowed == Allowed::Any => Err("must be a whole number".to_owned()),
                Err(_) => Err(format!("must be a whole number{}", self.range_in_words())),
            },
            Takes::Word(words) if words.contains(&text) => Ok(Value::Text(text.to_owned())),
            Takes::Word(words) => Err(format!("must be one of {}", words.join(", "))),
            Takes::Form(_, check) => check(text).map(|()| Value::Text(text.to_owned())),
            Takes::File(_) => Ok(Value::File(text.into())),
            Takes::Flag | Takes::Text(_) | Takes::Date => Ok(Value::Text(text.to_owned())),
        }
    }

    /// A quantity in SI units, or a plain number, from what a person wrote.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn number(&self, text: &str) -> Result<f64, String> {
        let read = match self.takes {
            Takes::Quantity(dimension) => dimension.parse(text).ok_or_else(|| dimension.refusal(text)),
            _ => text.trim().parse().map_err(|_| format!("must be a number{}", self.range_in_words())),
        };
        match read? {
            value if !value.is_finite() => Err("must be finite".to_owned()),
            value if self.allows(value) => Ok(value),
            _ => Err(format!("must be{}", self.range_in_words())),
        }
    }

    /// A value that came in SI units, where it is allowed.
    ///
    /// # Errors
    /// [`Wrong`], with the value.
    pub fn checked(&self, value: f64) -> Result<f64, Wrong> {
        let range = if value.is_finite() { self.range(written, self.unit()) } else { " finite".to_owned() };
        let reason = || format!("must be{range}, got {value}{}", self.unit());
        if self.allows(value) { Ok(value) } else { Err(self.wrong(reason())) }
    }

    /// Whether a value in SI units is allowed.
    pub fn allows(&self, value: f64) -> bool {
        match self.allowed {
            Allowed::Any => value.is_finite(),
            Allowed::AboveZero => value > 0.0 && value.is_finite(),
            Allowed::Below(from, to) => (from..to).contains(&value),
            Allowed::Between(from, to) => value > from && value < to,
            Allowed::Within(from, to) => (from..=to).contains(&value),
        }
    }

    /// The unit of its SI value with a blank in front; empty for shares and plain numbers.
    fn unit(&self) -> String {
        match self.takes {
            Takes::Quantity(dimension) if dimension != Dimension::Share => format!(" {}", dimension.si_unit()),
            _ => String::new(),
        }
    }

    /// What is allowed, in words, a blank in front.
    fn range(&self, written: impl Fn(f64) -> String, unit: String) -> String {
        match self.allowed {
            Allowed::Any => " finite".to_owned(),
            Allowed::AboveZero => " above zero".to_owned(),
            Allowed::Below(from, to) => format!(" from {} to below {}{unit}", written(from), written(to)),
            Allowed::Between(from, to) => format!(" above {} and below {}{unit}", written(from), written(to)),
            Allowed::Within(from, to) => format!(" from {} to {}{unit}", written(from), written(to)),
        }
    }

    /// The same as a person would write it.
    fn range_in_words(&self) -> String {
        let is_share = matches!(self.takes, Takes::Quantity(Dimension::Share));
        let written = |value| if is_share { format!("{} %", 100.0 * value) } else { written(value) };
        self.range(written, self.unit())
    }

    /// What is allowed, in words; empty where nothing is said of it.
    pub fn allowed_in_words(&self) -> String {
        match self.allowed {
            Allowed::Any => String::new(),
            _ => self.range_in_words().trim_start().to_owned(),
        }
    }

    /// A line of help: what it is, what is allowed and what holds without it.
    pub fn help(&self) -> String {
        let range = match self.allowed {
            Allowed::Any | Allowed::AboveZero => String::new(),
            _ => format!(", {}", self.allowed_in_words()),
        };
        let range = match self.takes {
            Takes::Word(words) => format!("{range}: {}", words.join(", ")),
            _ => range,
        };
        match self.if_absent {
            IfAbsent::Found(words) => format!("{}{range}; without it, {words}", self.meaning),
            _ => format!("{}{range}", self.meaning),
        }
    }

    /// The value that holds where nothing is said; `None` where the spec or the science says it.
    pub fn default_value(&self) -> Option<Value> {
        match self.if_absent {
            IfAbsent::Value(text) => self.read(text).ok(),
            _ => None,
        }
    }

    /// That a value of it cannot be.
    pub fn wrong(&self, reason: impl ToString) -> Wrong {
        Wrong { option: self.name, reason: reason.to_string() }
    }
}

/// A bound as people write it.
fn written(value: f64) -> String {
    if value != 0.0 && !(1e-4..1e7).contains(&value.abs()) { format!("{value:e}") } else { value.to_string() }
}

/// A name as the command has it.
fn flag(name: &str) -> String {
    name.replace('_', "-")
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: Row = Row {
        name: "mass_tolerance",
        takes: Takes::Quantity(Dimension::Share),
        allowed: Allowed::Below(0.0, 1.0),
        if_absent: IfAbsent::Value("10 %"),
        meaning: "Tolerance of the mass, to either side",
        ..Row::PLAIN
    };
    const SEEDS: Row = Row {
        name: "seeds",
        takes: Takes::Count,
        allowed: Allowed::Within(1.0, 1000.0),
        if_absent: IfAbsent::Value("5"),
        ..Row::PLAIN
    };
    const RATE: Row = Row {
        name: "resample",
        takes: Takes::Quantity(Dimension::Frequency),
        allowed: Allowed::Within(1e-9, 1e9),
        ..Row::PLAIN
    };
    const METHOD: Row = Row { name: "method", takes: Takes::Word(&["two-point", "all"]), ..Row::PLAIN };

    #[test]
    fn a_value_is_read_in_si_units_or_refused_with_what_is_allowed() {
        assert_eq!(TOLERANCE.read("5 %"), Ok(Value::Number(0.05)));
        assert_eq!(SEEDS.read(" 7 "), Ok(Value::Count(7)));
        for (row, text, reason) in [
            (&TOLERANCE, "100 %", "must be from 0 % to below 100 %, got \"100 %\""),
            (&TOLERANCE, "-1 %", "must be from 0 % to below 100 %, got \"-1 %\""),
            (&TOLERANCE, "5", "got \"5\""),
            (&TOLERANCE, "NaN %", "must be finite, got \"NaN %\""),
            (&SEEDS, "0", "must be from 1 to 1000, got \"0\""),
            (&SEEDS, "2.5", "must be a whole number from 1 to 1000, got \"2.5\""),
            (&RATE, "-1 Hz", "must be from 1e-9 to 1e9 Hz, got \"-1 Hz\""),
            (&METHOD, "some", "must be one of two-point, all, got \"some\""),
        ] {
            let refused = row.value(text).unwrap_err().to_string();
            assert!(refused.ends_with(reason), "{refused}");
        }
    }

    #[test]
    fn a_number_in_si_units_is_refused_in_the_same_words() {
        for (row, value, reason) in [
            (&SEEDS, 1001.0, "must be from 1 to 1000, got 1001"),
            (&TOLERANCE, 1.0, "must be from 0 to below 1, got 1"),
            (&RATE, -1.0, "must be from 1e-9 to 1e9 Hz, got -1 Hz"),
            (&RATE, f64::NAN, "must be finite, got NaN Hz"),
        ] {
            assert_eq!(row.checked(value).unwrap_err().reason, reason);
        }
        assert_eq!(TOLERANCE.help(), "Tolerance of the mass, to either side, from 0 % to below 100 %");
    }
}
