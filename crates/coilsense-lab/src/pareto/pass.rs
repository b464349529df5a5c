//! The first pass over a sweep: every row that is fine is offered to the front.
//!
//! Next door: what comes of it (`study`).

use super::Front;
use super::cloud::Cloud;
use super::counts::Counts;
use super::question::Question;
use crate::sweep::{Data, Dataset};

/// A range that holds nothing.
pub(super) const NOWHERE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

/// A range that also holds a value.
pub(super) fn wider([least, most]: [f64; 2], value: f64) -> [f64; 2] {
    [least.min(value), most.max(value)]
}

/// What the first pass holds.
pub(super) struct Pass<'q> {
    question: &'q Question,
    pub front: Front,
    pub counts: Counts,
    pub cloud: Cloud,
    pub varied: Vec<String>,
    pub all: Vec<[f64; 2]>,
}

impl<'q> Pass<'q> {
    pub fn new(dataset: &Dataset, question: &'q Question) -> Self {
        let [varied, _] = dataset.plan().numeric_titles();
        Self {
            front: Front::new(question.objectives.len()),
            counts: Counts { planned: dataset.plan().rows(), ..Counts::default() },
            cloud: Cloud::default(),
            all: vec![NOWHERE; varied.len()],
            varied,
            question,
        }
    }

    /// What is read: row, status, objectives, columns of conditions, variables.
    pub fn titles(&self) -> Vec<String> {
        let own = ["row", "status"].map(str::to_owned).into_iter();
        let objectives = self.question.objectives.iter().map(|objective| objective.title.clone());
        let conditions = self.question.conditions.iter().map(|condition| condition.title.clone());
        own.chain(objectives).chain(conditions).chain(self.varied.iter().cloned()).collect()
    }

    /// Compares the rows of a chunk.
    pub fn take(&mut self, columns: &[Data]) {
        let [Data::Whole(rows), Data::Texts(statuses), rest @ ..] = columns else { return };
        let (objectives, rest) = rest.split_at(self.question.objectives.len().min(rest.len()));
        let (conditions, varied) = rest.split_at(self.question.conditions.len().min(rest.len()));
        let at = |column: &Data, place: usize| match column {
            Data::Numbers(values) => values.get(place).copied().unwrap_or(f64::NAN),
            _ => f64::NAN,
        };
        let mut costs = Vec::with_capacity(objectives.len());
        for (place, (row, status)) in rows.iter().zip(statuses).enumerate() {
            self.counts.rows += 1;
            match status.as_str() {
                "ok" => {}
                "clash" => {
                    self.counts.clash += 1;
                    continue;
                }
                _ => {
                    self.counts.refused += 1;
                    continue;
                }
            }
            let row = row.unsigned_abs();
            if !self.question.conditions.iter().zip(conditions).all(|(own, column)| own.holds(column, place)) {
                self.counts.excluded += 1;
                continue;
            }
            costs.clear();
            costs.extend(
                objectives.iter().zip(&self.question.objectives).map(|(column, own)| own.cost(at(column, place))),
            );
            if !self.front.offer(row, &costs) {
                self.counts.without_number += 1;
                continue;
            }
            self.counts.compared += 1;
            let natural: Vec<f64> = objectives.iter().map(|column| at(column, place)).collect();
            self.cloud.offer(row, &natural);
            for (range, column) in self.all.iter_mut().zip(varied) {
                *range = wider(*range, at(column, place));
            }
        }
    }
}
