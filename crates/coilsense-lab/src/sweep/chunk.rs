//! A part of a sweep's rows, computed: columns of one length.
//!
//! Next door: one row (`design`), which rows there are (`plan`), columns as a file (`encoded`).

use rayon::prelude::*;

use super::SweepError;
use super::column::Kind;
use super::design::{self, Result as Cell, Row, Status};
use super::plan::{Plan, titles};
use super::variable;
use crate::spec::{Core, Draft, Files, Side};
use crate::study::enough_masses;

/// Columns of one length, each under its title.
#[derive(Debug, Clone, PartialEq)]
pub struct Chunk {
    /// Titles and what they hold, in the order of [`Plan::titles`].
    pub columns: Vec<(String, Data)>,
}

/// What a column holds; nothing where a design was refused.
#[derive(Debug, Clone, PartialEq)]
pub enum Data {
    /// Whole numbers.
    Whole(Vec<i64>),
    /// Numbers, NaN where there is none.
    Numbers(Vec<f64>),
    /// Texts, empty where there is none.
    Texts(Vec<String>),
    /// Truths.
    Flags(Vec<Option<bool>>),
}

impl Data {
    /// How many values there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Whole(values) => values.len(),
            Self::Numbers(values) => values.len(),
            Self::Texts(values) => values.len(),
            Self::Flags(values) => values.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Puts the values of another column of its kind behind its own; one of another kind is left out.
    #[cfg(feature = "parquet")]
    pub(super) fn append(&mut self, other: Self) {
        match (self, other) {
            (Self::Whole(values), Self::Whole(other)) => values.extend(other),
            (Self::Numbers(values), Self::Numbers(other)) => values.extend(other),
            (Self::Texts(values), Self::Texts(other)) => values.extend(other),
            (Self::Flags(values), Self::Flags(other)) => values.extend(other),
            _ => {}
        }
    }
}

impl Plan {
    /// Computes the rows of a chunk on the threads at hand; `None` where `go_on`, which is asked before each row, says no.
    ///
    /// # Errors
    /// [`SweepError`] for a chunk that is not there.
    pub fn chunk(&self, index: u64, go_on: &(dyn Fn() -> bool + Sync)) -> Result<Option<Chunk>, SweepError> {
        let rows = self.rows_of(index);
        if rows.is_empty() {
            return Err(SweepError::new(format!("chunk {index}: there are {}, counted from 0", self.chunks())));
        }
        let draft = self.draft()?.known();
        let files = |name: &str| self.file(name);
        let columns: Vec<_> = self.columns.iter().map(|(_, column)| column.clone()).collect();
        let masses = self.masses(&draft, &files);
        let one = |draft: &mut Draft<'_>, row: u64| {
            if !go_on() {
                return None;
            }
            let values = self.set(row, draft);
            Some((values, design::judge(draft, &files, &columns, &self.needs, &masses)))
        };
        let designs: Option<Vec<_>> = rows.clone().into_par_iter().map_init(|| draft.clone(), one).collect();
        Ok(designs.map(|designs| self.assembled(rows.start, designs)))
    }

    /// Masses per winding that are enough for each spring of the spec as it is written, and are taken for all designs; none where designs differ in
    /// their windings, and each must find its own.
    fn masses(&self, draft: &Draft<'_>, files: &Files<'_>) -> Vec<usize> {
        let winds = self.variables.iter().any(|variable| variable.target.place.is_of_spring("windings"));
        if winds || self.catalogue.is_some() {
            return Vec::new();
        }
        let Ok(core) = draft.core(files) else { return Vec::new() };
        let enough = |(_, core): &(Side, Core)| {
            enough_masses(&core.spring, &core.mount, &core.conditions).map(|masses| masses.per_winding)
        };
        core.each().iter().map(enough).collect::<Result<_, _>>().unwrap_or_default()
    }

    fn assembled(&self, first: u64, designs: Vec<(Vec<variable::Cell>, Row)>) -> Chunk {
        let titles = titles(self);
        let empty = |kind: &Kind| match kind {
            Kind::Whole => Data::Whole(Vec::with_capacity(designs.len())),
            Kind::Numbers => Data::Numbers(Vec::with_capacity(designs.len())),
            Kind::Texts => Data::Texts(Vec::with_capacity(designs.len())),
            Kind::Flags => Data::Flags(Vec::with_capacity(designs.len())),
        };
        let mut columns: Vec<Data> = titles.iter().map(|(_, kind)| empty(kind)).collect();
        let results = self.columns.len();
        for (number, (values, row)) in (first..).zip(designs) {
            let refused = row.status == Status::Refused;
            let results = if refused { vec![Cell::None; results] } else { row.results };
            let values = values.into_iter().map(|value| match value {
                variable::Cell::Number(number) => Cell::Number(number),
                variable::Cell::Text(text) => Cell::Text(text),
            });
            let outcome = [Cell::Text(row.status.name().to_owned()), Cell::Text(row.reason)];
            let cells = [Cell::Number(number as f64)].into_iter().chain(values).chain(outcome).chain(results);
            columns.iter_mut().zip(cells).for_each(|(column, cell)| push(column, cell));
        }
        Chunk { columns: titles.into_iter().map(|(title, _)| title).zip(columns).collect() }
    }
}

fn push(column: &mut Data, cell: Cell) {
    match (column, cell) {
        (Data::Whole(values), Cell::Number(value)) => values.push(value as i64),
        (Data::Whole(values), _) => values.push(0),
        (Data::Numbers(values), Cell::Number(value)) => values.push(value),
        (Data::Numbers(values), _) => values.push(f64::NAN),
        (Data::Texts(values), Cell::Text(text)) => values.push(text),
        (Data::Texts(values), _) => values.push(String::new()),
        (Data::Flags(values), Cell::Flag(flag)) => values.push(Some(flag)),
        (Data::Flags(values), _) => values.push(None),
    }
}
