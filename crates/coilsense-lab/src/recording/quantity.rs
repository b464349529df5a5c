//! What a log can hold: time, and the channels of `Signals`; and what takes a column's numbers to SI.
//!
//! Next door: units (`crate::quantity`), which column is which (`mapping`, `selection`).

use coilsense::Channel;

use crate::quantity::Dimension;

/// Dimensions of a log's columns.
pub(super) const LOGGED: [Dimension; 5] =
    [Dimension::Time, Dimension::Length, Dimension::Force, Dimension::Inductance, Dimension::Resistance];

/// What a column means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Quantity {
    /// The instant of a row.
    Time,
    /// A channel of `Signals`.
    Channel(Channel),
}

impl Quantity {
    /// Time, then every channel.
    pub fn all() -> impl Iterator<Item = Self> {
        std::iter::once(Self::Time).chain(Channel::ALL.map(Self::Channel))
    }

    /// Its name in mappings and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Channel(channel) => channel.name(),
        }
    }

    /// The quantity of a name, or which names there are.
    pub(super) fn named(name: &str) -> Result<Self, String> {
        let names = || Self::all().map(Self::name).collect::<Vec<_>>().join(", ");
        Self::all().find(|quantity| quantity.name() == name).ok_or_else(|| format!("must be one of {}", names()))
    }

    /// What its units are of.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Time => Dimension::Time,
            Self::Channel(Channel::U1 | Channel::U2) => Dimension::Length,
            Self::Channel(Channel::Inductance) => Dimension::Inductance,
            Self::Channel(Channel::Resistance) => Dimension::Resistance,
            Self::Channel(_) => Dimension::Force,
        }
    }

    /// Largest size of a value in SI units, as the science takes it; of a time, so that seconds since 1970 fit.
    pub(super) fn largest(self) -> f64 {
        match self {
            Self::Time => 1e11,
            Self::Channel(_) => 1e9,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Quantity;
    use crate::recording::quantity::LOGGED;

    #[test]
    fn every_quantity_is_of_a_dimension_that_titles_know() {
        assert!(Quantity::all().all(|quantity| LOGGED.contains(&quantity.dimension())));
        assert!(Quantity::named("F_0").unwrap_err().ends_with("time, u1, u2, F_i, F_o, F_x, F_L, L, R"));
    }
}
