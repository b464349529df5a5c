//! A quantity from Python: a number in SI, a text with its unit as a spec has it, or a number of a library of units, which converts it.
//!
//! Next door: series of numbers (`series`).

use coilsense_lab::message::python_name;
use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::request::{
    DROP_INCOMPLETE, FILL_GAPS, MERGE_REPEATED, REPAIR_UP_TO, RESAMPLE, SORT, UNWRAP,
};
use coilsense_lab::request::{Allowed, Given, Row, Takes, Value, Wrong};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::count::Count;
use crate::errors::Error;
use crate::names::Word;

/// A number in SI, or a text such as "2.5 kHz".
#[derive(FromPyObject)]
pub enum Quantity {
    /// In SI.
    Number(f64),
    /// With its unit.
    Text(String),
    /// A number that knows its unit, such as pint's, or what is no quantity at all.
    Other(Anything),
}

/// An object of any class.
pub struct Anything(Py<PyAny>);

impl<'a, 'py> FromPyObject<'a, 'py> for Anything {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(object.to_owned().unbind()))
    }
}

/// What libraries call units of an angle: to them a turn is 2π, so that 60 rpm would be 6.28 Hz.
const ANGLES: [&str; 5] = ["radian", "degree", "turn", "revolution", "rpm"];

impl Anything {
    /// Its value in the SI unit of the first of some dimensions that it has; `None` where it knows no unit.
    fn si(&self, dimensions: &[Dimension]) -> Option<f64> {
        Python::attach(|py| {
            let object = self.0.bind(py);
            let units = object.getattr("units").ok()?.str().ok()?.to_string();
            dimensions.iter().find_map(|dimension| {
                if *dimension == Dimension::Frequency && ANGLES.iter().any(|angle| units.contains(angle)) {
                    return None;
                }
                let unit = if dimension.si_unit().is_empty() { "dimensionless" } else { dimension.si_unit() };
                let converted = object.call_method1("to", (unit,)).ok()?;
                converted.getattr("magnitude").ok()?.extract().ok()
            })
        })
    }

    /// The object.
    pub fn bind<'py>(&self, py: Python<'py>) -> &Bound<'py, PyAny> {
        self.0.bind(py)
    }

    /// Its class.
    pub fn class(&self) -> String {
        Python::attach(|py| {
            self.bind(py).get_type().name().map_or_else(|_| "an object".to_owned(), |name| name.to_string())
        })
    }

    /// As an error calls it: what it shows where it knows a unit, else its class.
    fn described(&self) -> String {
        Python::attach(|py| {
            let object = self.0.bind(py);
            let shown = if object.hasattr("units").unwrap_or(false) { object.str().ok() } else { None };
            shown.map_or_else(|| self.class(), |shown| shown.to_string())
        })
    }
}

impl Quantity {
    /// Its value in SI, whatever it is: who takes it checks it.
    pub fn si(&self, name: &str, dimension: Dimension) -> PyResult<f64> {
        self.si_of(name, &[dimension])
    }

    /// The same where it may be of one of several dimensions.
    pub fn si_of(&self, name: &str, dimensions: &[Dimension]) -> PyResult<f64> {
        let refused = |got: String| format!("{name} must be {}, got {got}", allowed(dimensions));
        match self {
            Self::Number(value) => Ok(*value),
            Self::Text(text) => {
                let found = dimensions.iter().find_map(|dimension| dimension.parse(text));
                found.ok_or_else(|| Error::new_err(refused(format!("{text:?}"))))
            }
            Self::Other(object) => {
                object.si(dimensions).ok_or_else(|| PyTypeError::new_err(refused(object.described())))
            }
        }
    }

    /// Its value where it has no unit: a number alone.
    pub fn plain(&self, name: &str) -> PyResult<f64> {
        match self {
            Self::Number(value) => Ok(*value),
            Self::Text(text) => Err(Error::new_err(format!("{name} must be a number, got {text:?}"))),
            Self::Other(object) => object
                .si(&[Dimension::Share])
                .ok_or_else(|| PyTypeError::new_err(format!("{name} must be a number, got {}", object.described()))),
        }
    }

    /// Its value in SI, any finite one.
    pub fn finite(&self, name: &'static str, dimension: Dimension) -> PyResult<f64> {
        self.checked(&Row { name, takes: Takes::Quantity(dimension), ..Row::PLAIN })
    }

    /// Its value in SI, above zero.
    pub fn positive(&self, name: &'static str, dimension: Dimension) -> PyResult<f64> {
        let allowed = Allowed::AboveZero;
        self.checked(&Row { name, takes: Takes::Quantity(dimension), allowed, ..Row::PLAIN })
    }

    /// Its value in SI, where an option allows it.
    fn checked(&self, row: &Row) -> PyResult<f64> {
        let refused = |allowed: String, text: &str| row.wrong(format!("must be {allowed}, got {text:?}"));
        let value = match (self, row.takes) {
            (Self::Number(value), _) => Ok(*value),
            (Self::Text(text), Takes::Quantity(dimension)) => dimension.parse(text).ok_or_else(|| {
                refused(format!("a number in {} or {}", dimension.si_unit(), dimension.expectation()), text)
            }),
            (Self::Text(text), _) => Err(refused("a number".to_owned(), text)),
            (Self::Other(_), Takes::Quantity(dimension)) => return self.si(python_name(row.name), dimension),
            (Self::Other(_), _) => return self.plain(python_name(row.name)),
        };
        value.and_then(|value| row.checked(value)).map_err(wrong)
    }
}

/// What a quantity of some dimensions may be.
fn allowed(dimensions: &[Dimension]) -> String {
    let units: Vec<&str> = dimensions.iter().map(|dimension| dimension.si_unit()).collect();
    let texts: Vec<String> = dimensions.iter().map(|dimension| dimension.expectation()).collect();
    let number = if units == [""] { "a number".to_owned() } else { format!("a number in {}", units.join(" or ")) };
    format!("{number} or {}", texts.join(" or "))
}

/// The value in SI of an argument that may be left out.
pub fn si(argument: Option<&Quantity>, name: &str, dimension: Dimension) -> PyResult<Option<f64>> {
    argument.map(|quantity| quantity.si(name, dimension)).transpose()
}

/// An exception for an option that cannot be.
pub fn wrong(wrong: Wrong) -> PyErr {
    Error::new_err(format!("{} {}", python_name(wrong.option), wrong.reason))
}

/// The value of an argument without a unit that may be left out.
pub fn plain(argument: Option<&Quantity>, name: &str) -> PyResult<Option<f64>> {
    argument.map(|quantity| quantity.plain(name)).transpose()
}

/// An exception for what is none of what an argument takes.
pub fn neither(name: &str, wanted: &str, object: &Anything) -> PyErr {
    PyTypeError::new_err(format!("{name} must be {wanted}, got {}", object.class()))
}

/// What an argument says of an option.
pub enum Said {
    /// Nothing.
    Nothing,
    /// That it holds.
    Yes,
    /// A quantity, or a plain number.
    Quantity(Quantity),
    /// A whole number.
    Count(Count),
    /// A word.
    Word(Word),
    /// Texts of an option that may be given several times.
    Texts(Vec<String>),
}

impl<T: Into<Self>> From<Option<T>> for Said {
    fn from(said: Option<T>) -> Self {
        said.map_or(Self::Nothing, Into::into)
    }
}

impl From<bool> for Said {
    fn from(said: bool) -> Self {
        if said { Self::Yes } else { Self::Nothing }
    }
}

impl From<f64> for Said {
    fn from(number: f64) -> Self {
        Self::Quantity(Quantity::Number(number))
    }
}

impl From<Quantity> for Said {
    fn from(quantity: Quantity) -> Self {
        Self::Quantity(quantity)
    }
}

impl From<Count> for Said {
    fn from(count: Count) -> Self {
        Self::Count(count)
    }
}

impl From<String> for Said {
    fn from(word: String) -> Self {
        Self::Word(Word::Text(word))
    }
}

impl From<&str> for Said {
    fn from(word: &str) -> Self {
        Self::Word(Word::Text(word.to_owned()))
    }
}

impl From<Word> for Said {
    fn from(word: Word) -> Self {
        Self::Word(word)
    }
}

/// What arguments say of options, each as its row allows.
pub fn given<'a>(said: impl IntoIterator<Item = (&'a Row, Said)>) -> PyResult<Given> {
    let mut given = Given::default();
    for (row, said) in said {
        let value = match said {
            Said::Nothing => continue,
            Said::Yes => {
                given.set(row, Vec::new());
                continue;
            }
            Said::Texts(texts) if texts.is_empty() => continue,
            Said::Texts(texts) => {
                given.set(row, texts.into_iter().map(Value::Text).collect());
                continue;
            }
            Said::Quantity(quantity) => Value::Number(quantity.checked(row)?),
            Said::Count(count) => {
                let count = count.number(python_name(row.name))?;
                row.checked(count as f64).map(|_| Value::Count(count)).map_err(wrong)?
            }
            Said::Word(word) => row.value(word.text(python_name(row.name))?).map_err(wrong)?,
        };
        given.set(row, vec![value]);
    }
    Ok(given)
}

/// What the arguments of everything that reads logs say of cleaning them.
pub fn cleaning(
    drop_incomplete: bool,
    sort: bool,
    merge_repeated: bool,
    unwrap: bool,
    fill_gaps: Option<Quantity>,
    resample: Option<Quantity>,
    repair_up_to: Option<Quantity>,
) -> [(&'static Row, Said); 7] {
    [
        (&DROP_INCOMPLETE, drop_incomplete.into()),
        (&SORT, sort.into()),
        (&MERGE_REPEATED, merge_repeated.into()),
        (&UNWRAP, unwrap.into()),
        (&FILL_GAPS, fill_gaps.into()),
        (&RESAMPLE, resample.into()),
        (&REPAIR_UP_TO, repair_up_to.into()),
    ]
}

/// The value of an argument that may be left out, above zero.
pub fn positive(argument: Option<&Quantity>, name: &'static str, dimension: Dimension) -> PyResult<Option<f64>> {
    argument.map(|quantity| quantity.positive(name, dimension)).transpose()
}
