//! Settings to paste: as JSON, as a C header that runs alone, and as a Rust constant for `coilsense-rt`.
//!
//! Next door: what each kind of settings consists of (`settings`), the header's text (`c`).

mod settings;

use std::fmt::Write as _;

use minijinja::{AutoEscape, Environment, context};
use serde_json::{Value, json};

pub use settings::Settings;

/// In which numbers the target computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// `f32`, C's `float`.
    Single,
    /// `f64`, C's `double`.
    Double,
}

impl Precision {
    pub(crate) fn rust(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
        }
    }

    pub(crate) fn c(self) -> &'static str {
        match self {
            Self::Single => "float",
            Self::Double => "double",
        }
    }

    /// A number as C reads it to the bit; the shortest decimal that means it.
    pub(crate) fn literal(self, value: f64) -> String {
        match self {
            Self::Single => format!("{:?}f", value as f32),
            Self::Double => format!("{value:?}"),
        }
    }
}

/// What can go wrong.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// A name that is none in C or Rust.
    #[error("name of the export must be a lower-case letter and then letters, digits or underscores, got \"{0}\"")]
    Name(String),
    /// A setting that a target cannot hold.
    #[error("{name}: {quantity} must be {allowed}, got {value}")]
    Number {
        /// Of the export.
        name: String,
        /// Which number, by its path.
        quantity: String,
        /// What it is.
        value: f64,
        /// What it may be.
        allowed: &'static str,
    },
    /// The header's text.
    #[error("C header: {0}")]
    Header(#[from] minijinja::Error),
}

/// Settings with a name, for a sampling rate.
pub struct Export<'a> {
    name: &'a str,
    rate: f64,
    precision: Precision,
    settings: &'a dyn Settings,
}

impl<'a> Export<'a> {
    /// Settings `settings`, designed for `rate` \[Hz\], called `name`.
    ///
    /// # Errors
    /// [`ExportError::Name`] for a name that is no identifier; [`ExportError::Number`] for a setting that is no finite number in the precision asked for.
    pub fn new(
        name: &'a str,
        rate: f64,
        precision: Precision,
        settings: &'a dyn Settings,
    ) -> Result<Self, ExportError> {
        check_name(name)?;
        check(name, "settings", &settings.numbers(), precision)?;
        Ok(Self { name, rate, precision, settings })
    }

    /// `<name>.json`: everything, in full precision.
    pub fn json(&self) -> Value {
        json!({
            "name": self.name,
            "kind": self.settings.kind(),
            "sampling_rate_hz": self.rate,
            "ring": self.settings.ring(),
            "settings": self.settings.numbers(),
        })
    }

    /// `<name>.rs`: a constant, and how large its ring is where it has one.
    pub fn rust(&self) -> String {
        let scalar = self.precision.rust();
        let upper = self.name.to_ascii_uppercase();
        let mut text = format!("// {}\n\nuse coilsense_rt::*;\n", self.title());
        let kind = self.settings.rust_type(scalar);
        let value = self.settings.rust_value(self.precision);
        if let Some(ring) = self.settings.ring() {
            let _ =
                write!(text, "\n/// Samples that the state's ring holds.\npub const {upper}_RING: usize = {ring};\n");
        }
        let _ = write!(text, "\n/// For {} Hz.\npub const {upper}: {kind} = {value};\n", self.rate);
        text
    }

    /// `<name>.h`: C99 without a library. Compiled without contraction (`-std=c99`, or `-ffp-contract=off`) its numbers are Rust's to the bit.
    ///
    /// # Errors
    /// [`ExportError::Header`] where the text cannot be made.
    pub fn c(&self) -> Result<String, ExportError> {
        let mut environment = Environment::new();
        environment.set_auto_escape_callback(|_| AutoEscape::None);
        let precision = self.precision;
        environment.add_filter("real", move |value: f64| precision.literal(value));
        environment.add_template("ring", include_str!("c/ring.h"))?;
        environment.add_template("mean", include_str!("c/mean.h"))?;
        environment.add_template("member", include_str!("c/member.h"))?;
        environment.add_template("body", self.settings.c_template())?;
        environment.add_template("header", include_str!("c/header.h"))?;
        let page = environment.get_template("header")?;
        Ok(page.render(context! {
            title => self.title(),
            name => self.name,
            upper => self.name.to_ascii_uppercase(),
            real => precision.c(),
            ring => self.settings.ring(),
            s => shown(&self.settings.numbers()),
        })?)
    }

    fn title(&self) -> String {
        format!("{}: {}, for {} Hz. Made by coilsense {}.", self.name, self.settings.kind(), self.rate, VERSION)
    }
}

/// Lets through a name that C and Rust can have.
pub(crate) fn check_name(name: &str) -> Result<(), ExportError> {
    let rest = name.strip_prefix(|first: char| first.is_ascii_lowercase());
    let word = |rest: &str| rest.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
    if !rest.is_some_and(word) || name.ends_with('_') {
        return Err(ExportError::Name(name.to_owned()));
    }
    Ok(())
}

const VERSION: &str = env!("CARGO_PKG_VERSION");

/// A value for the header's text.
fn shown(value: &Value) -> minijinja::Value {
    match value {
        Value::Number(number) => match number.as_u64() {
            Some(whole) => whole.into(),
            None => number.as_f64().into(),
        },
        Value::Array(values) => values.iter().map(shown).collect::<Vec<_>>().into(),
        Value::Object(fields) => {
            minijinja::Value::from_pairs(fields.iter().map(|(field, value)| (field.as_str(), shown(value))))
        }
        _ => minijinja::Value::UNDEFINED,
    }
}

/// Lets through numbers that are finite in `precision`; a zero that was none is told, too.
fn check(name: &str, path: &str, value: &Value, precision: Precision) -> Result<(), ExportError> {
    let told =
        |value, allowed| Err(ExportError::Number { name: name.to_owned(), quantity: path.to_owned(), value, allowed });
    match value {
        Value::Null => told(f64::NAN, "finite"),
        Value::Number(number) => {
            let value = number.as_f64().unwrap_or(f64::NAN);
            if precision == Precision::Single && !(value as f32).is_finite() {
                return told(value, "within what single precision holds");
            }
            Ok(())
        }
        Value::Array(values) => {
            let mut each = values.iter().enumerate();
            each.try_for_each(|(index, value)| check(name, &format!("{path}[{index}]"), value, precision))
        }
        Value::Object(fields) => {
            fields.iter().try_for_each(|(field, value)| check(name, &format!("{path}.{field}"), value, precision))
        }
        _ => Ok(()),
    }
}
