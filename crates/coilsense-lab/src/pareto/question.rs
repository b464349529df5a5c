//! What is asked: objectives, and conditions that a design has to meet.
//!
//! Next door: reading a condition (`condition`), what comes of it (`study`).

use super::condition::Condition;
use crate::quantity::without_unit;
use crate::sweep::{Plan, SweepError};

/// What is wanted of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aim {
    /// Little of it.
    Minimize,
    /// Much of it.
    Maximize,
}

/// A column and what is wanted of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Objective {
    /// Title of the column, with its unit.
    pub title: String,
    /// What is wanted.
    pub aim: Aim,
}

/// Objectives and conditions, whose columns are those of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// The objectives, from 1 to 6.
    pub objectives: Vec<Objective>,
    pub(super) conditions: Vec<Condition>,
}

/// Beyond this many objectives nearly every design is on the front.
const MOST_OBJECTIVES: usize = 6;

impl Question {
    /// Reads a question about the rows of a plan.
    ///
    /// - `minimize`, `maximize`: columns by their titles, with or without units
    /// - `conditions`: such as `mass < 100 g`, `F_o.rmsd <= 2`, `worst = "heel strike"`; a number without a unit is in that of its column
    ///
    /// # Errors
    /// [`SweepError`] for a column that is not there, holds no numbers or is asked for twice, and for a condition that says nothing.
    pub fn new(
        plan: &Plan,
        minimize: &[String],
        maximize: &[String],
        conditions: &[String],
    ) -> Result<Self, SweepError> {
        let of = |words: &[String], aim: Aim| {
            let objective = |word: &String| Ok(Objective { title: plan.numbers(word)?, aim });
            words.iter().map(objective).collect::<Result<Vec<_>, SweepError>>()
        };
        let mut objectives = of(minimize, Aim::Minimize)?;
        objectives.extend(of(maximize, Aim::Maximize)?);
        if !(1..=MOST_OBJECTIVES).contains(&objectives.len()) {
            let text = format!("a front has from 1 to {MOST_OBJECTIVES} objectives, got {}", objectives.len());
            return Err(SweepError::new(text));
        }
        let twice = |(place, objective): &(usize, &Objective)| {
            objectives[..*place].iter().any(|other| other.title == objective.title)
        };
        if let Some((_, objective)) = objectives.iter().enumerate().find(twice) {
            return Err(SweepError::new(format!("{} is asked for twice", objective.name())));
        }
        let conditions = conditions.iter().map(|text| Condition::parse(text, plan)).collect::<Result<_, _>>()?;
        Ok(Self { objectives, conditions })
    }

    /// The conditions in words.
    pub fn conditions(&self) -> Vec<String> {
        self.conditions.iter().map(|condition| condition.text.clone()).collect()
    }
}

impl Objective {
    /// The column without its unit.
    pub fn name(&self) -> &str {
        without_unit(&self.title)
    }

    /// A value as a coordinate of which less is better.
    pub(super) fn cost(&self, value: f64) -> f64 {
        match self.aim {
            Aim::Minimize => value,
            Aim::Maximize => -value,
        }
    }

    /// `least` or `most`.
    pub(crate) fn best_word(&self) -> &'static str {
        match self.aim {
            Aim::Minimize => "least",
            Aim::Maximize => "most",
        }
    }
}
