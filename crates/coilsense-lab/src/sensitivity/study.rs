//! Indices of the columns of a sweep that was laid out for them.
//!
//! Next door: the estimates (the parent), the layout (`crate::sweep::Sampling::Saltelli`), the answer in words (`words`).

use super::{Indices, Resampling, SensitivityError, indices};
use crate::message::{Hint, Message};
use crate::quantity::without_unit;
use crate::sweep::{Data, Dataset, Sampling, SweepError};

/// What became of a sweep's rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Evaluations {
    /// Rows of the plan.
    pub planned: u64,
    /// Rows that are there.
    pub rows: u64,
    /// Of them, those in which windings would touch; what the linear model says of them does not count.
    pub clash: u64,
    /// Those that could not be judged.
    pub refused: u64,
}

/// The indices of one column, or why there are none.
#[derive(Debug, Clone, PartialEq)]
pub struct OfColumn {
    /// The column's title, with its unit.
    pub title: String,
    /// Its indices, one for each variable.
    pub found: Result<Indices, SensitivityError>,
}

/// Indices of columns of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// The variables' keys, in the order of indices.
    pub variables: Vec<String>,
    /// The columns.
    pub columns: Vec<OfColumn>,
    /// What became of the rows.
    pub evaluations: Evaluations,
    /// How intervals were found.
    pub resampling: Resampling,
}

impl Study {
    /// Indices of some columns of a dataset, or of all that hold numbers and were recorded.
    ///
    /// - `of`: columns by their titles, with or without units; empty for all
    ///
    /// # Errors
    /// [`SweepError`] where the sweep was laid out otherwise, a column is not there, or there are no indices of a column that was asked for.
    pub fn of(dataset: &Dataset, of: &[String], resampling: Resampling) -> Result<Self, SweepError> {
        let plan = dataset.plan();
        let sampling = plan.parameters().sampling.map_or("", Sampling::name);
        if sampling != Sampling::Saltelli.name() {
            let message = Message::from("sensitivity indices need a sweep with ")
                + Hint::Value("sampling", Sampling::Saltelli.name().to_owned());
            return Err(SweepError::new(message + format!(", this one is {sampling}")));
        }
        if let Some(catalogue) = &plan.parameters().catalogue {
            let rows = catalogue.rows.len();
            if rows > 1 {
                let text = format!("sensitivity indices need one design to vary, the catalogue has {rows}");
                return Err(SweepError::new(text));
            }
        }
        let titles: Vec<String> = match of.is_empty() {
            true => {
                let [_, recorded] = plan.numeric_titles();
                recorded
            }
            false => of.iter().map(|word| plan.numbers(word)).collect::<Result<_, _>>()?,
        };
        let variables = plan.swept_keys();
        let mut study = Self { variables, columns: Vec::new(), evaluations: Evaluations::default(), resampling };
        for (place, values) in study.read(dataset, &titles)?.into_iter().enumerate() {
            let title = titles[place].clone();
            let found = indices(&values, study.variables.len(), &resampling);
            if let (Err(error), false) = (&found, of.is_empty()) {
                return Err(SweepError::new(format!("{}: {error}", without_unit(&title))));
            }
            study.columns.push(OfColumn { title, found });
        }
        Ok(study)
    }

    /// Values of columns by row: NaN where there is none, or where the design is not fine.
    fn read(&mut self, dataset: &Dataset, titles: &[String]) -> Result<Vec<Vec<f64>>, SweepError> {
        let planned = dataset.plan().rows();
        let rows = usize::try_from(planned).unwrap_or(usize::MAX);
        let mut values = vec![vec![f64::NAN; rows]; titles.len()];
        let mut counts = Evaluations { planned, ..Evaluations::default() };
        let read: Vec<&str> = ["row", "status"].into_iter().chain(titles.iter().map(String::as_str)).collect();
        dataset.for_each_chunk(&read, |columns| {
            let [Data::Whole(numbers), Data::Texts(statuses), columns @ ..] = columns.as_slice() else { return };
            for (place, (row, status)) in numbers.iter().zip(statuses).enumerate() {
                counts.rows += 1;
                match status.as_str() {
                    "ok" => {}
                    "clash" => counts.clash += 1,
                    _ => counts.refused += 1,
                }
                if status != "ok" {
                    continue;
                }
                let row = usize::try_from(*row).unwrap_or(usize::MAX);
                for (values, column) in values.iter_mut().zip(columns) {
                    if let (Data::Numbers(column), Some(value)) = (column, values.get_mut(row)) {
                        *value = column.get(place).copied().unwrap_or(f64::NAN);
                    }
                }
            }
        })?;
        self.evaluations = counts;
        Ok(values)
    }
}
