//! What a key's value can be: a quantity, a number, a text.
//!
//! Next door: the keys (the parent), reading their values (`crate::spec::value`).

use super::{Key, Table};
use crate::quantity::Dimension;

/// What a key takes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Domain {
    /// A number with a unit of one of these dimensions.
    Quantity(Vec<Dimension>),
    /// A number without a unit.
    Number,
    /// A word, a name, a file.
    Text,
    /// A list that only a person writes.
    List,
}

/// What keys take besides what their example shows.
const OTHERS: [(&str, &str, &[Dimension]); 8] = [
    ("condition", "length", &[Dimension::Length, Dimension::Share]),
    ("condition", "frequency", &[Dimension::Frequency]),
    ("condition", "amplitude", &[Dimension::Length, Dimension::Force]),
    ("goal", "error", &[Dimension::Force]),
    ("sensor", "range", NATIVE),
    ("sensor", "noise", NATIVE),
    ("sensor", "resolution", &[Dimension::Share, Dimension::Force, Dimension::Inductance]),
    ("sensor", "accuracy_full_scale", NATIVE),
];
const NATIVE: &[Dimension] = &[Dimension::Force, Dimension::Length, Dimension::Inductance];

impl Table {
    /// What one of its keys takes: as its example is written.
    pub(crate) fn domain(&self, key: &Key) -> Domain {
        let shown = example(key);
        let others = OTHERS.iter().filter(|(table, name, _)| *table == self.name && *name == key.name);
        let mut dimensions: Vec<Dimension> = others.flat_map(|(_, _, dimensions)| dimensions.iter().copied()).collect();
        if let Domain::Quantity(own) = &shown {
            dimensions.splice(0..0, own.iter().copied().filter(|own| !dimensions.contains(own)).collect::<Vec<_>>());
        }
        if dimensions.is_empty() { shown } else { Domain::Quantity(dimensions) }
    }
}

fn example(key: &Key) -> Domain {
    match key.example.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(text) => match Dimension::ALL.into_iter().find(|dimension| dimension.parse(text).is_some()) {
            Some(dimension) => Domain::Quantity(vec![dimension]),
            None => Domain::Text,
        },
        None if key.example.starts_with('[') => Domain::List,
        None => Domain::Number,
    }
}

#[cfg(test)]
mod tests {
    use super::super::TABLES;
    use super::Domain;
    use crate::quantity::Dimension;

    fn domain(table: &str, key: &str) -> Domain {
        let table = TABLES.iter().find(|known| known.name == table).unwrap();
        table.domain(table.keys.iter().find(|known| known.name == key).unwrap())
    }

    #[test]
    fn keys_take_what_their_examples_show_and_what_else_the_reader_takes() {
        assert_eq!(domain("spring", "stiffness"), Domain::Quantity(vec![Dimension::Stiffness]));
        assert_eq!(domain("spring", "windings"), Domain::Number);
        assert_eq!(domain("spring", "material"), Domain::Text);
        assert_eq!(domain("mount", "damping_ratio"), Domain::Number);
        assert_eq!(domain("condition", "window"), Domain::List);
        assert_eq!(domain("goal", "error"), Domain::Quantity(vec![Dimension::Share, Dimension::Force]));
        assert_eq!(domain("condition", "length"), Domain::Quantity(vec![Dimension::Length, Dimension::Share]));
    }
}
