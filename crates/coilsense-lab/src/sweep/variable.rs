//! A key of the spec whose value differs from design to design, and what it is set to in each.
//!
//! Next door: its values as people write them (`values`), which of them a row has (`sampling`), the spec's keys (`crate::spec`).

use super::SweepError;
use super::sampling::Coordinate;
use super::values::{self, Unit, Values};
use crate::spec::{Domain, Draft, Place};

/// A key and the unit in which its values come.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Target {
    /// As the user wrote it: `spring.stiffness`.
    pub key: String,
    pub place: Place,
    pub unit: Option<Unit>,
}

/// A key with all values that it may take.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Variable {
    pub target: Target,
    values: Values,
}

/// What a key is set to, as a spec has it but for quotes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Setting(pub String);

/// The same as a column of the result has it.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Cell {
    /// In SI.
    Number(f64),
    Text(String),
}

impl Variable {
    /// Reads `KEY=VALUES`.
    pub fn parse(over: &str, draft: &Draft<'_>) -> Result<Self, SweepError> {
        let (key, text) =
            split(over).ok_or_else(|| SweepError::of(over, "is not KEY=VALUES, such as spring.mass=50..80 g"))?;
        let refuse = |message: String| SweepError::new(format!("{key}={text}: {message}"));
        let place = draft.place(key).map_err(SweepError::new)?;
        let (values, unit) = values::parse(text, &place.domain).map_err(refuse)?;
        Ok(Self { target: Target { key: key.to_owned(), place, unit }, values })
    }

    /// How many values it takes; `None` where it takes any of a range.
    pub fn points(&self) -> Option<u64> {
        match &self.values {
            Values::Numbers(numbers) => Some(numbers.len() as u64),
            Values::Texts(texts) => Some(texts.len() as u64),
            Values::Spread { points, .. } => *points,
        }
    }

    /// Its texts, where it takes such.
    pub fn texts(&self) -> &[String] {
        if let Values::Texts(texts) = &self.values { texts } else { &[] }
    }

    /// Whether it takes texts.
    pub fn is_text(&self) -> bool {
        matches!(self.values, Values::Texts(_))
    }

    /// Its value in a row.
    pub fn at(&self, coordinate: Coordinate) -> Setting {
        let point = |share: f64, points: u64| ((share * points as f64) as u64).min(points.saturating_sub(1));
        let coordinate = match (coordinate, self.points()) {
            // A variable of a few values takes each of them equally often.
            (Coordinate::Share(share), Some(points)) => Coordinate::Point(point(share, points)),
            (coordinate, _) => coordinate,
        };
        let number = match (&self.values, coordinate) {
            (Values::Texts(texts), Coordinate::Point(point)) => {
                return Setting(texts.get(point as usize).cloned().unwrap_or_default());
            }
            (Values::Numbers(numbers), Coordinate::Point(point)) => {
                numbers.get(point as usize).copied().unwrap_or(f64::NAN)
            }
            (Values::Spread { spread, points }, Coordinate::Point(point)) => spread.grid(point, points.unwrap_or(1)),
            (Values::Spread { spread, .. }, Coordinate::Share(share)) => spread.quantile(share),
            (Values::Numbers(_) | Values::Texts(_), Coordinate::Share(_)) => f64::NAN,
        };
        self.target.written(number)
    }
}

/// At the `=` that is not within a name in quotes.
fn split(over: &str) -> Option<(&str, &str)> {
    let mut quoted = false;
    let at = over.char_indices().find(|(_, c)| {
        quoted ^= *c == '"';
        *c == '=' && !quoted
    });
    at.map(|(at, _)| (over[..at].trim(), over[at + 1..].trim()))
}

/// From here on a number is written with an exponent.
const LONGEST: f64 = 1e15;

impl Target {
    /// A number in the unit of the values, as a spec has it: all its digits, and the unit.
    fn written(&self, number: f64) -> Setting {
        let digits = if number.abs() < LONGEST { format!("{number}") } else { format!("{number:e}") };
        Setting(match &self.unit {
            Some((unit, _)) => format!("{digits} {unit}"),
            None => digits,
        })
    }

    /// The setting for a column of numbers in SI, or of texts.
    pub fn cell(&self, setting: &Setting, numeric: bool) -> Cell {
        if !numeric {
            return Cell::Text(setting.0.clone());
        }
        let number = match &self.place.domain {
            Domain::Quantity(dimensions) => dimensions.iter().find_map(|dimension| dimension.parse(&setting.0)),
            _ => setting.0.trim().parse().ok(),
        };
        Cell::Number(number.unwrap_or(f64::NAN))
    }

    /// `spring.stiffness [N/m]`; of texts the key alone.
    pub fn title(&self, numeric: bool) -> String {
        match (numeric, &self.unit) {
            (false, _) => self.key.clone(),
            (true, Some((_, dimension))) if !dimension.si_unit().is_empty() => {
                format!("{} [{}]", self.key, dimension.si_unit())
            }
            (true, _) => format!("{} [1]", self.key),
        }
    }
}
