//! Whether an analysis settles what its spec asks for: a yes or no for scripts.
//!
//! Next door: the answer in sentences (`answer`).

use super::Analysis;
use super::doubts::is_untold;
use super::words::{name, wish};
use crate::quantity::plainly;

/// What a script may rely on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Check {
    /// The sensor of this name meets the goal, in every case that was asked for.
    Met(String),
    /// No sensor does; the goal.
    Missed(String),
    /// It is not decided; why.
    Undecided(String),
}

impl Check {
    /// Of an analysis: of the sensor that its answer chooses.
    pub fn of(analysis: &Analysis) -> Self {
        let Some(goal) = analysis.spec.goal.error else {
            return Self::Undecided("the spec sets no [goal], so nothing is judged".to_owned());
        };
        let Some(chosen) = analysis.verdicts.iter().find(|verdict| verdict.meets_always() == Some(true)) else {
            return Self::Missed(format!("no sensor meets the goal of {}", wish(analysis, goal)));
        };
        let sensor = name(analysis, chosen);
        if is_untold(&analysis.spec, chosen) {
            return Self::Undecided(format!(
                "how far {sensor} is off hangs on the first surge frequency, which the spec does not say well enough"
            ));
        }
        if !chosen.has_limits {
            return Self::Undecided(format!("the spec gives no limit of error for {sensor}, so it may miss the goal"));
        }
        if let Some(sooner) = chosen.sooner.filter(|sooner| sooner.error > goal) {
            return Self::Undecided(format!(
                "in {} {sensor} misses the goal before the window begins; begin the window at {} s",
                analysis.spec.conditions[analysis.cases[sooner.case].condition].name,
                plainly(sooner.window.0)
            ));
        }
        // Beyond contact the windings of the model pass through one another.
        let beyond = analysis.cases.iter().find(|case| case.contacts.is_none() && case.clash.happens());
        match beyond {
            Some(case) => Self::Undecided(format!(
                "in {} windings would touch, which these numbers leave out; let them meet with a table [contact]",
                analysis.spec.conditions[case.condition].name
            )),
            None => Self::Met(sensor.to_owned()),
        }
    }
}
