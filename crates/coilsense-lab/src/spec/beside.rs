//! Springs beside the first, between the same two ends: nested, side by side, or pulling against it.
//!
//! Next door: one spring (`spring`), what is done to the first (`condition`), the motion of all (`crate::study`).

use coilsense::{FarEnd, Spring};

use super::SpecError;
use super::condition::ConditionSpec;
use super::mount::MountSpec;
use super::section::Section;
use super::spring::{ROUNDING, SpringSpec};
use super::spring_table::millimetres;
use crate::quantity::Dimension;

/// How a spring acts beside the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Side {
    /// It gets longer where the first does, and pulls the same way.
    #[default]
    Same,
    /// It gets as much shorter, and pulls the other way.
    Opposite,
}

impl Side {
    /// 1, or −1 where a force of it counts the other way.
    pub fn sign(self) -> f64 {
        match self {
            Self::Same => 1.0,
            Self::Opposite => -1.0,
        }
    }
}

/// A spring by itself and what it stands on.
pub(super) struct Alone {
    pub spring: SpringSpec,
    pub mount: MountSpec,
}

/// A spring beside the first, on the same mount under the same conditions, as it undergoes them.
#[derive(Debug, Clone, PartialEq)]
pub struct Beside {
    /// Which way it acts.
    pub side: Side,
    /// Its length where the first is at the middle of its range in use \[m\].
    pub length_at_mid: f64,
    /// The spring.
    pub spring: SpringSpec,
    /// The mount, as its masses take it.
    pub mount: MountSpec,
    /// What is done to it: of each condition of the first what that does to this one.
    pub conditions: Vec<ConditionSpec>,
}

impl Beside {
    /// A spring of a table, read by itself as `alone`, beside `first` under its `conditions`.
    pub(super) fn of(
        section: &Section<'_>,
        alone: Alone,
        first: &SpringSpec,
        conditions: &[ConditionSpec],
    ) -> Result<Self, SpecError> {
        let side = match section.optional_word("side", &["same", "opposite"])? {
            Some("opposite") => Side::Opposite,
            _ => Side::Same,
        };
        let usual = match side {
            Side::Same => first.spring.mid_length(),
            Side::Opposite => alone.spring.spring.mid_length(),
        };
        let length_at_mid = section.above_zero("length_at_mid", Dimension::Length)?.unwrap_or(usual);
        let Alone { spring, mount } = alone;
        let beside = Self { side, length_at_mid, spring, mount, conditions: Vec::new() };
        beside.check_range(section, first)?;
        let felt = |condition: &ConditionSpec| -> Result<ConditionSpec, SpecError> {
            let excitation = match side {
                Side::Same => Ok(condition.excitation.clone()),
                Side::Opposite => condition.excitation.mirrored(),
            };
            let length = beside.length_where(&first.spring, condition.excitation.mean_length());
            let excitation = excitation.and_then(|excitation| excitation.about(length));
            let excitation = excitation.map_err(|error| section.refuse_science(&error, &LENGTHS))?;
            Ok(ConditionSpec { excitation, ..condition.clone() })
        };
        let conditions = conditions.iter().map(felt).collect::<Result<_, _>>()?;
        Ok(Self { conditions, ..beside })
    }

    /// Its length \[m\] where the first has `length`.
    pub fn length_where(&self, first: &Spring, length: f64) -> f64 {
        self.length_at_mid + self.side.sign() * (length - first.mid_length())
    }

    /// Its range in use holds all lengths that it has while the first goes through its own.
    fn check_range(&self, section: &Section<'_>, first: &SpringSpec) -> Result<(), SpecError> {
        let (shortest, longest) = first.spring.operating_range();
        let ends = [shortest, longest].map(|length| self.length_where(&first.spring, length));
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let (least, most) = self.spring.spring.operating_range();
        if low >= least * (1.0 - ROUNDING) && high <= most * (1.0 + ROUNDING) {
            return Ok(());
        }
        let why = format!(
            "while {:?} is {} to {} long, {:?} is {} to {}; its own range in use must hold that, and is {} to {}",
            first.name,
            millimetres(shortest),
            millimetres(longest),
            self.spring.name,
            millimetres(low),
            millimetres(high),
            millimetres(least),
            millimetres(most),
        );
        Err(section.refuse("length_at_mid", why))
    }
}

/// The key that sets a parameter of an excitation.
const LENGTHS: [(&str, &str); 1] = [("mean_length", "length_at_mid")];

/// Springs that do not act on one another: each has a name of its own, both ends of all have prescribed positions, and all are chains.
pub(super) fn check_together(sections: &[Section<'_>], each: &[&SpringSpec], far_end: FarEnd) -> Result<(), SpecError> {
    for (number, spring) in each.iter().enumerate() {
        if each[..number].iter().any(|other| super::stem(&other.name) == super::stem(&spring.name)) {
            return Err(sections[number].refuse("name", "is that of another spring; give each its own"));
        }
        if spring.model == super::Model::Helix {
            let why = "of several springs must be \"coil\" or \"chain\"; \"helix\" moves a single one";
            return Err(sections[number].refuse("model", why));
        }
    }
    if far_end != FarEnd::Position {
        let why = "take [mount] end2 = \"held\": with a force or a mass at end 2 they would move one another";
        return Err(sections[1].together(why));
    }
    Ok(())
}
