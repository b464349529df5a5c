//! The five conditions of the paper's tables.
//!
//! Next door: how each protocol reads them (`reproduce`), the numbers printed for them (`published`).

/// A row of Tables II and III.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// Impact at mid range.
    HeelStrike,
    /// End stop at the longest length.
    EndStopMax,
    /// End stop at the shortest length.
    EndStopMin,
    /// Harmonic input at half of eq. (3)'s first frequency.
    HalfResonance,
    /// Harmonic input at eq. (3)'s first frequency.
    Resonance,
}

impl Condition {
    /// All of them, in the paper's order.
    pub const ALL: [Self; 5] =
        [Self::HeelStrike, Self::EndStopMax, Self::EndStopMin, Self::HalfResonance, Self::Resonance];

    /// Its name in data files, tables and `tables.json`.
    pub fn name(self) -> &'static str {
        match self {
            Self::HeelStrike => "heel strike",
            Self::EndStopMax => "end stop max",
            Self::EndStopMin => "end stop min",
            Self::HalfResonance => "half resonance",
            Self::Resonance => "resonance",
        }
    }

    /// The condition of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|condition| condition.name() == name)
    }

    /// Whether an end is driven by a sinusoid.
    pub fn is_harmonic(self) -> bool {
        matches!(self, Self::HalfResonance | Self::Resonance)
    }
}
