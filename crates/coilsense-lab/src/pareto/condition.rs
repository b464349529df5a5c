//! A condition that a design has to meet: a column, a relation, a value.
//!
//! Next door: objectives (`question`).

use std::cmp::Ordering;

use crate::quantity::Dimension;
use crate::quantity::unit_of;
use crate::sweep::{Data, Kind, Plan, SweepError};

/// A condition.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Condition {
    /// As it was asked.
    pub text: String,
    /// Title of the column.
    pub title: String,
    relation: Relation,
    value: Value,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Relation {
    Less,
    AtMost,
    More,
    AtLeast,
    Equal,
    Other,
}

#[derive(Debug, Clone, PartialEq)]
enum Value {
    Number(f64),
    Text(String),
    Flag(bool),
}

/// Relations as they are written, the longer ones first.
const RELATIONS: [(&str, Relation); 9] = [
    ("<=", Relation::AtMost),
    (">=", Relation::AtLeast),
    ("!=", Relation::Other),
    ("==", Relation::Equal),
    ("≤", Relation::AtMost),
    ("≥", Relation::AtLeast),
    ("<", Relation::Less),
    (">", Relation::More),
    ("=", Relation::Equal),
];

impl Condition {
    /// Reads `COLUMN < VALUE`.
    pub fn parse(text: &str, plan: &Plan) -> Result<Self, SweepError> {
        let refuse = |message: String| SweepError::new(format!("{text:?}: {message}"));
        let (column, relation, value) = split(text)
            .ok_or_else(|| refuse("is not COLUMN < VALUE, with one of < <= > >= = != between them".to_owned()))?;
        let (title, kind) = plan.column(column).map_err(|error| refuse(error.to_string()))?;
        let value = value_of(value, kind, &title).map_err(refuse)?;
        let ordered = !matches!(relation, Relation::Equal | Relation::Other);
        if ordered && !matches!(value, Value::Number(_)) {
            return Err(refuse(format!("{column} holds no numbers: compare it with = or !=")));
        }
        Ok(Self { text: text.trim().to_owned(), title, relation, value })
    }

    /// Whether a place of its column meets it; what is not there does not.
    pub fn holds(&self, column: &Data, place: usize) -> bool {
        let order = match (&self.value, column) {
            (Value::Number(value), Data::Numbers(column)) => column.get(place).and_then(|own| own.partial_cmp(value)),
            (Value::Number(value), Data::Whole(column)) => {
                column.get(place).and_then(|own| (*own as f64).partial_cmp(value))
            }
            (Value::Text(value), Data::Texts(column)) => column.get(place).map(|own| own.cmp(value)),
            (Value::Flag(value), Data::Flags(column)) => column.get(place).copied().flatten().map(|own| own.cmp(value)),
            _ => None,
        };
        order.is_some_and(|order| match self.relation {
            Relation::Less => order.is_lt(),
            Relation::AtMost => order.is_le(),
            Relation::More => order.is_gt(),
            Relation::AtLeast => order.is_ge(),
            Relation::Equal => order == Ordering::Equal,
            Relation::Other => order != Ordering::Equal,
        })
    }
}

/// At the first relation that is not within brackets.
fn split(text: &str) -> Option<(&str, Relation, &str)> {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        depth += i32::from(c == '[') - i32::from(c == ']');
        let rest = &text[at..];
        let relation = RELATIONS.iter().find(|(word, _)| depth == 0 && rest.starts_with(word));
        if let Some((word, relation)) = relation {
            let (column, value) = (text[..at].trim(), rest[word.len()..].trim());
            return (!column.is_empty() && !value.is_empty()).then_some((column, *relation, value));
        }
    }
    None
}

fn value_of(text: &str, kind: Kind, title: &str) -> Result<Value, String> {
    match kind {
        Kind::Texts => Ok(Value::Text(text.trim_matches('"').to_owned())),
        Kind::Flags => match text {
            "yes" | "true" => Ok(Value::Flag(true)),
            "no" | "false" => Ok(Value::Flag(false)),
            _ => Err(format!("{title} is yes or no, got {text}")),
        },
        Kind::Numbers | Kind::Whole => number(text, unit_of(title)).map(Value::Number),
    }
}

/// A number in a column's unit, or in one that goes with it.
fn number(text: &str, unit: &str) -> Result<f64, String> {
    let plain = text.parse().ok();
    let percent = || text.strip_suffix('%').filter(|_| unit == "%").and_then(|number| number.trim().parse().ok());
    let of_unit = |dimension: &Dimension| dimension.si_unit() == unit && !unit.is_empty();
    let dimension = Dimension::ALL.into_iter().find(of_unit);
    let quantity = || dimension.and_then(|dimension| dimension.parse(text));
    plain.or_else(percent).or_else(quantity).filter(|value: &f64| value.is_finite()).ok_or_else(|| {
        let other = dimension.map_or_else(String::new, |dimension| format!(", or {}", dimension.expectation()));
        match unit {
            "" => format!("{text} must be a number"),
            _ => format!("{text} must be a number in {unit}{other}"),
        }
    })
}
