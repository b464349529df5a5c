//! SI numbers of a column in the units in which people think of them (grams, millimetres, megapascals), and the column's title, which holds
//! the SI unit: `stiffness [N/m]`.
//!
//! Next door: quantities as people write them (`super`), the columns themselves (`crate::sweep`).

use super::digits;

/// How the numbers of a column are shown.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Shown {
    /// The column without its unit.
    pub name: String,
    factor: f64,
    unit: &'static str,
    own: String,
}

/// From a unit, below which size of its largest number, to which unit, by what.
const SMALLER: [(&str, f64, &str, f64); 5] = [
    ("kg", 1.0, "g", 1e3),
    ("m", 1.0, "mm", 1e3),
    ("s", 1.0, "ms", 1e3),
    ("H", 1.0, "µH", 1e6),
    ("m/s", 0.1, "mm/s", 1e3),
];
const LARGER: [(&str, f64, &str, f64); 2] = [("Pa", 1e4, "MPa", 1e-6), ("N/m", 1e5, "kN/m", 1e-3)];

impl Shown {
    /// Of a column by its title and the largest size of its numbers.
    pub fn new(title: &str, largest: f64) -> Self {
        let unit = unit_of(title);
        let smaller = SMALLER.iter().find(|(from, below, ..)| *from == unit && largest < *below);
        let larger = LARGER.iter().find(|(from, above, ..)| *from == unit && largest >= *above);
        let (unit, factor) = smaller.or(larger).map_or(("", 1.0), |(_, _, to, factor)| (*to, *factor));
        Self { name: without_unit(title).to_owned(), factor, unit, own: unit_of(title).to_owned() }
    }

    /// Of numbers under a title.
    pub fn of(title: &str, values: impl IntoIterator<Item = f64>) -> Self {
        let finite = values.into_iter().filter(|value| value.is_finite());
        Self::new(title, finite.fold(0.0, |most, value| most.max(value.abs())))
    }

    /// The unit that it is shown in.
    pub fn unit(&self) -> &str {
        if self.unit.is_empty() { &self.own } else { self.unit }
    }

    /// A number in that unit.
    pub fn scaled(&self, value: f64) -> f64 {
        self.factor * value
    }

    /// Three digits of it.
    pub fn digits(&self, value: f64) -> String {
        let value = self.scaled(value);
        let size = value.abs();
        if value.is_nan() {
            "–".to_owned()
        } else if size != 0.0 && !(1e-4..1e6).contains(&size) {
            format!("{value:.2e}")
        } else {
            digits(value)
        }
    }

    /// With its unit.
    pub fn with_unit(&self, value: f64) -> String {
        format!("{} {}", self.digits(value), self.unit()).trim_end().to_owned()
    }

    /// What stands over a column or along an axis.
    pub fn title(&self) -> String {
        let unit = if self.unit().is_empty() { "1" } else { self.unit() };
        format!("{} [{unit}]", self.name)
    }
}

/// A title without its unit.
pub(crate) fn without_unit(title: &str) -> &str {
    match title.strip_suffix(']').and_then(|rest| rest.rsplit_once(" [")) {
        Some((name, _)) => name,
        None => title,
    }
}

/// The unit of a title; that of a plain number is empty.
pub(crate) fn unit_of(title: &str) -> &str {
    let unit = title.strip_suffix(']').and_then(|rest| rest.rsplit_once(" [")).map_or("", |(_, unit)| unit);
    if unit == "1" { "" } else { unit }
}
