//! How the ends of a spring are held against tilting and turning: keys of `[mount]` that the axial model does not ask for.
//!
//! Next door: what end 2 is tied to along the axis (`mount`), what the ends make of the coil (`crate::helix`).

use coilsense::geometry::EndType;
use coilsense::helix::Holding;

use super::SpecError;
use super::section::Section;
use crate::helix::Held;
use crate::quantity::Dimension;

/// Whether an end is held against a rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hold {
    /// It is.
    Held,
    /// It is not.
    Free,
    /// It is not known which, or something gives: both are looked at.
    Between,
}

/// How one end is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct End {
    tilt: Hold,
    turn: Hold,
}

/// How both ends are held, and how well a sensor of force is aligned with the spring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndsSpec {
    ends: [End; 2],
    /// Whether the spec says so, or it is assumed of such ends.
    pub is_given: bool,
    /// Angle between the spring's axis and that of a load cell \[rad\].
    pub misalignment: f64,
}

const WORDS: [(&str, Hold); 3] = [("held", Hold::Held), ("free", Hold::Free), ("between", Hold::Between)];

impl EndsSpec {
    /// What is assumed of a kind of ends: those ground flat stand in seats, of all others it is not known whether they tilt.
    pub fn assumed(end_type: EndType) -> Self {
        let tilt = if end_type == EndType::ClosedGround { Hold::Held } else { Hold::Between };
        let end = End { tilt, turn: Hold::Held };
        Self { ends: [end; 2], is_given: false, misalignment: 0.0 }
    }

    /// Reads the keys of `[mount]`.
    pub(super) fn parse(section: &Section<'_>, end_type: EndType) -> Result<Self, SpecError> {
        let mut spec = Self::assumed(end_type);
        let words = WORDS.map(|(word, _)| word);
        let of = |key: &str| -> Result<Option<Hold>, SpecError> {
            let word = section.optional_word(key, &words)?;
            Ok(WORDS.iter().find(|(known, _)| Some(*known) == word).map(|(_, hold)| *hold))
        };
        let (tilt, turn) = (of("ends_tilt")?, of("ends_turn")?);
        let each = [("end1_tilt", "end1_turn"), ("end2_tilt", "end2_turn")];
        for (end, (tilt_key, turn_key)) in spec.ends.iter_mut().zip(each) {
            let (own_tilt, own_turn) = (of(tilt_key)?, of(turn_key)?);
            spec.is_given |= own_tilt.or(own_turn).or(tilt).or(turn).is_some();
            end.tilt = own_tilt.or(tilt).unwrap_or(end.tilt);
            end.turn = own_turn.or(turn).unwrap_or(end.turn);
        }
        if let Some(angle) = section.not_negative("misalignment", Dimension::Angle)? {
            let holds = angle <= LARGEST_MISALIGNMENT;
            section.check("misalignment", holds, angle, "from 0 to 45 deg")?;
            spec.misalignment = angle;
        }
        Ok(spec)
    }

    /// The ways in which the ends may be: the tightest, and the loosest where something is between.
    pub fn ways(&self) -> (Held, Option<Held>) {
        let tightest = self.with(Hold::Held);
        (tightest, Some(self.with(Hold::Free)).filter(|loosest| *loosest != tightest))
    }

    /// Whether an end may tilt.
    pub fn may_tilt(&self) -> bool {
        self.ends.iter().any(|end| end.tilt != Hold::Held)
    }

    /// One way, with what is between taken for `between`.
    fn with(&self, between: Hold) -> Held {
        let is_free = |hold: Hold| (if hold == Hold::Between { between } else { hold }) == Hold::Free;
        let holding = |end: End| match (is_free(end.tilt), is_free(end.turn)) {
            (false, false) => Holding::clamped(),
            (true, false) => Holding::pinned(),
            (false, true) => Holding::swivel(),
            (true, true) => Holding::ball(),
        };
        Held::new(self.ends.map(holding), self.ends.map(|end| is_free(end.turn)))
    }
}

/// Farther from the axis a load cell measures something else \[rad\].
const LARGEST_MISALIGNMENT: f64 = std::f64::consts::FRAC_PI_4;

#[cfg(test)]
mod tests {
    use coilsense::helix::Turning;

    use super::super::document::Document;
    use super::*;

    fn read(end_type: EndType, keys: &str) -> Result<EndsSpec, SpecError> {
        let text = format!("[mount]\n{keys}");
        let document = Document::parse("toy.toml", &text)?;
        EndsSpec::parse(&document.section("mount")?, end_type)
    }

    fn words(end_type: EndType, keys: &str) -> Vec<String> {
        let (tightest, loosest) = read(end_type, keys).unwrap().ways();
        [Some(tightest), loosest].iter().flatten().map(Held::words).collect()
    }

    #[test]
    fn ends_are_as_their_kind_unless_the_spec_says_otherwise() {
        let both = ["ends held".to_owned(), "ends free to tilt".to_owned()];
        assert_eq!(words(EndType::Hooks, ""), both);
        assert_eq!(words(EndType::Open, ""), both);
        assert_eq!(words(EndType::ClosedGround, ""), ["ends held"]);
        assert_eq!(words(EndType::ClosedGround, "ends_tilt = \"between\""), both);
        assert_eq!(
            words(EndType::Hooks, "ends_tilt = \"free\"\nend2_tilt = \"held\""),
            ["end 1 free to tilt, end 2 held"]
        );
        assert_eq!(words(EndType::ClosedGround, "end2_turn = \"free\""), ["end 1 held, end 2 free to turn"]);
        let (held, swivel) = read(EndType::ClosedGround, "end2_turn = \"between\"").unwrap().ways();
        assert_eq!((held.turning(), swivel.map(|way| way.turning())), (Turning::Held, Some(Turning::Free)));
    }

    #[test]
    fn what_is_no_way_to_hold_an_end_is_refused_at_its_key() {
        for (keys, line) in
            [("ends_tilt = \"loose\"", 2), ("misalignment = \"60 deg\"", 2), ("misalignment = \"-1 deg\"", 2)]
        {
            let refused = read(EndType::Hooks, keys).unwrap_err().to_string();
            assert!(refused.starts_with(&format!("toy.toml:{line}: ")), "{refused}");
        }
        assert!(
            (read(EndType::Hooks, "misalignment = \"1 deg\"").unwrap().misalignment.to_degrees() - 1.0).abs() < 1e-12
        );
    }
}
