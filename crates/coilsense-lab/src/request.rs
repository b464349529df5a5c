//! What may be asked of a verb: one row an option, of which the command's arguments, the page's form and the reference are made.
//!
//! Next door: the rows of a verb (`mitigation::OPTIONS`), quantities as text (`quantity`).

use crate::quantity::Dimension;

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
}

/// What an option takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Takes {
    /// A number with its unit.
    Quantity(Dimension),
    /// A whole number.
    Count,
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
    /// From the first to the second, both among them.
    Within(f64, f64),
}

/// What holds where nothing is said.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IfAbsent {
    /// This, as it would be written.
    Value(&'static str),
    /// What the spec or the science says, in words.
    Found(&'static str),
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
    /// Its name as an option of the command, without dashes in front.
    pub fn flag(&self) -> String {
        flag(self.name)
    }

    /// What stands for its value in a line of help.
    pub fn value_name(&self) -> &'static str {
        match self.takes {
            Takes::Count => "COUNT",
            Takes::Quantity(dimension) => dimension.placeholder(),
        }
    }

    /// Its value in SI units from what a person wrote.
    ///
    /// # Errors
    /// [`Wrong`], with what was written.
    pub fn value(&self, text: &str) -> Result<f64, Wrong> {
        self.read(text).map_err(|reason| self.wrong(format!("{reason}, got {text:?}")))
    }

    /// The same for who says by himself what was written.
    ///
    /// # Errors
    /// One line on what it must be, without the option's name and what was written.
    pub fn read(&self, text: &str) -> Result<f64, String> {
        let value = match self.takes {
            Takes::Quantity(dimension) => dimension.parse(text),
            Takes::Count => text.trim().parse::<u64>().ok().map(|count| count as f64),
        };
        match value.filter(|value| value.is_finite()) {
            None => Err(match self.takes {
                Takes::Quantity(dimension) => dimension.refusal(text),
                Takes::Count => format!("must be a whole number{}", self.range_in_words()),
            }),
            Some(value) if self.allows(value) => Ok(value),
            Some(_) => Err(format!("must be{}", self.range_in_words())),
        }
    }

    /// A value that came in SI units, where it is allowed.
    ///
    /// # Errors
    /// [`Wrong`], with the value.
    pub fn checked(&self, value: f64) -> Result<f64, Wrong> {
        let unit = match self.takes {
            Takes::Quantity(dimension) if dimension != Dimension::Share => format!(" {}", dimension.si_unit()),
            _ => String::new(),
        };
        let reason = || format!("must be{}, got {value}{unit}", self.range(|value| value.to_string()));
        if self.allows(value) { Ok(value) } else { Err(self.wrong(reason())) }
    }

    /// Whether a value in SI units is allowed.
    pub fn allows(&self, value: f64) -> bool {
        match self.allowed {
            Allowed::Any => value.is_finite(),
            Allowed::AboveZero => value > 0.0 && value.is_finite(),
            Allowed::Below(from, to) => (from..to).contains(&value),
            Allowed::Within(from, to) => (from..=to).contains(&value),
        }
    }

    /// What is allowed, in words, a blank in front; empty where all is.
    fn range(&self, written: impl Fn(f64) -> String) -> String {
        match self.allowed {
            Allowed::Any => " finite".to_owned(),
            Allowed::AboveZero => " above zero".to_owned(),
            Allowed::Below(from, to) => format!(" from {} to below {}", written(from), written(to)),
            Allowed::Within(from, to) => format!(" from {} to {}", written(from), written(to)),
        }
    }

    /// The same as a person would write it.
    fn range_in_words(&self) -> String {
        self.range(|value| match self.takes {
            Takes::Quantity(Dimension::Share) => format!("{} %", 100.0 * value),
            _ => value.to_string(),
        })
    }

    /// A line of help: what it is, what is allowed and what holds without it.
    pub fn help(&self) -> String {
        let range = match self.allowed {
            Allowed::Any | Allowed::AboveZero => String::new(),
            _ => format!(",{}", self.range_in_words()),
        };
        match self.if_absent {
            IfAbsent::Value(_) => format!("{}{range}", self.meaning),
            IfAbsent::Found(words) => format!("{}{range}; without it, {words}", self.meaning),
        }
    }

    /// The value that holds where nothing is said, in SI units; `None` where the spec or the science says it.
    pub fn default_value(&self) -> Option<f64> {
        match self.if_absent {
            IfAbsent::Value(text) => self.read(text).ok(),
            IfAbsent::Found(_) => None,
        }
    }

    /// That a value of it cannot be.
    pub fn wrong(&self, reason: impl ToString) -> Wrong {
        Wrong { option: self.name, reason: reason.to_string() }
    }
}

/// Values of a verb's options in SI units, in the order of its rows: what `given` says, or what holds without it.
///
/// # Errors
/// [`Wrong`] for the first that cannot be.
pub fn values<const N: usize>(
    rows: &[Row; N],
    given: impl Fn(&Row) -> Option<String>,
) -> Result<[Option<f64>; N], Wrong> {
    let mut values = [None; N];
    for (value, row) in values.iter_mut().zip(rows) {
        *value = match given(row) {
            Some(text) => Some(row.value(&text)?),
            None => row.default_value(),
        };
    }
    Ok(values)
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
    };
    const SEEDS: Row = Row {
        name: "seeds",
        takes: Takes::Count,
        allowed: Allowed::Within(1.0, 1000.0),
        if_absent: IfAbsent::Value("5"),
        meaning: "Number of noise realisations",
    };

    #[test]
    fn a_value_is_read_in_si_units_or_refused_with_what_is_allowed() {
        assert_eq!(TOLERANCE.read("5 %"), Ok(0.05));
        assert_eq!(SEEDS.read(" 7 "), Ok(7.0));
        for (row, text, reason) in [
            (&TOLERANCE, "100 %", "must be from 0 % to below 100 %, got \"100 %\""),
            (&TOLERANCE, "-1 %", "must be from 0 % to below 100 %, got \"-1 %\""),
            (&TOLERANCE, "5", "got \"5\""),
            (&TOLERANCE, "NaN %", "got \"NaN %\""),
            (&SEEDS, "0", "must be from 1 to 1000, got \"0\""),
            (&SEEDS, "2.5", "must be a whole number from 1 to 1000, got \"2.5\""),
        ] {
            let refused = row.value(text).unwrap_err().to_string();
            assert!(refused.ends_with(reason), "{refused}");
        }
    }

    #[test]
    fn what_is_not_said_is_what_holds_without_it() {
        let rows = [TOLERANCE, SEEDS];
        let given = |row: &Row| (row.name == "seeds").then(|| "3".to_owned());
        assert_eq!(values(&rows, given), Ok([Some(0.1), Some(3.0)]));
        let wrong = values(&rows, |row| (row.name == "mass_tolerance").then(|| "2".to_owned())).unwrap_err();
        assert_eq!(wrong.option, "mass_tolerance");
        assert!(wrong.to_string().starts_with("mass-tolerance: must be "), "{wrong}");
        assert_eq!(SEEDS.checked(1001.0).unwrap_err().reason, "must be from 1 to 1000, got 1001");
        assert_eq!(TOLERANCE.checked(1.0).unwrap_err().reason, "must be from 0 to below 1, got 1");
        assert_eq!(TOLERANCE.help(), "Tolerance of the mass, to either side, from 0 % to below 100 %");
    }
}
