//! The front of a sweep: one pass over its chunks for who is on it, another for all that is known of those.
//!
//! Next door: what is asked (`question`), the first pass (`pass`), the answer in words (`words`).

use super::counts::Counts;
use super::pass::{NOWHERE, Pass, wider};
use super::question::Question;
use super::{extremes, knee};
use crate::quantity::Shown;
use crate::sweep::{Chunk, Data, Dataset, SweepError};

/// Where a variable lies: among all that were compared, and on the front.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Title of its column.
    pub title: String,
    /// Least and most of those compared.
    pub all: [f64; 2],
    /// Least and most on the front.
    pub front: [f64; 2],
}

/// A front and all that is known of its designs.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// What was asked.
    pub question: Question,
    /// What became of the rows.
    pub counts: Counts,
    /// The designs on the front with all their columns, the best in the first objective first.
    pub front: Chunk,
    /// Their rows.
    pub rows: Vec<u64>,
    /// Their objectives, shape (designs × objectives).
    pub values: Vec<f64>,
    /// Place of the knee among them.
    pub knee: usize,
    /// Place of the best in each objective.
    pub extremes: Vec<usize>,
    /// Objectives of some of those compared, drawn by lot.
    pub cloud: Vec<Vec<f64>>,
    /// What is varied.
    pub spans: Vec<Span>,
}

impl Study {
    /// The front of the rows of a dataset that are there.
    ///
    /// # Errors
    /// [`SweepError`] for a file that cannot be read, and where no row is left to compare.
    pub fn of(dataset: &Dataset, question: Question) -> Result<Self, SweepError> {
        let mut pass = Pass::new(dataset, &question);
        let titles = pass.titles();
        let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
        dataset.for_each_chunk(&titles, |columns| pass.take(&columns))?;
        let Pass { mut front, counts, cloud, varied, all, .. } = pass;
        let mut points = front.points();
        if points.is_empty() {
            return Err(SweepError::new(format!("no design is left to compare: {}", counts.account())));
        }
        points.sort_by(|(a, first), (b, second)| first[0].total_cmp(&second[0]).then(a.cmp(b)));
        let width = question.objectives.len();
        let costs: Vec<f64> = points.iter().flat_map(|(_, costs)| costs.iter().copied()).collect();
        let rows: Vec<u64> = points.into_iter().map(|(row, _)| row).collect();
        let front = dataset.rows(&rows)?;
        let spans = varied.into_iter().zip(all).filter_map(|(title, all)| {
            let (_, data) = front.columns.iter().find(|(other, _)| *other == title)?;
            let Data::Numbers(values) = data else { return None };
            let on_front = values.iter().fold(NOWHERE, |range, value| wider(range, *value));
            Some(Span { title, all, front: on_front })
        });
        Ok(Self {
            spans: spans.collect(),
            counts,
            knee: knee(&costs, width).unwrap_or(0),
            extremes: extremes(&costs, width),
            values: costs.iter().zip(question.objectives.iter().cycle()).map(|(cost, own)| own.cost(*cost)).collect(),
            cloud: cloud.points(),
            question,
            front,
            rows,
        })
    }

    /// Objectives of a design on the front.
    pub fn objectives_of(&self, place: usize) -> &[f64] {
        let width = self.question.objectives.len();
        self.values.get(place * width..(place + 1) * width).unwrap_or(&[])
    }

    /// How the numbers of each objective are shown.
    pub(crate) fn shown(&self) -> Vec<Shown> {
        let width = self.question.objectives.len();
        let objectives = self.question.objectives.iter().enumerate();
        let values = |place: usize| self.values.iter().skip(place).step_by(width).copied();
        objectives.map(|(place, objective)| Shown::of(&objective.title, values(place))).collect()
    }
}
