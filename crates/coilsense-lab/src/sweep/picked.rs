//! Some rows and columns of a dataset, for what is asked of sweeps afterwards.
//!
//! Next door: the folder (`dataset`), what is asked (`crate::pareto`, `crate::sensitivity`).

use super::SweepError;
use super::chunk::{Chunk, Data};
use super::column::Kind;
use super::dataset::Dataset;
use super::plan::{Plan, titles};
use crate::likeness::nearest;
use crate::quantity::without_unit;

impl Plan {
    /// Title and kind of a column by its title, with or without its unit.
    pub(crate) fn column(&self, word: &str) -> Result<(String, Kind), SweepError> {
        let word = word.trim();
        let all = titles(self);
        let exact = all.iter().find(|(title, _)| title == word);
        let found = exact.or_else(|| all.iter().find(|(title, _)| without_unit(title) == word));
        found.cloned().ok_or_else(|| {
            let names = || all.iter().map(|(title, _)| without_unit(title));
            let meant = nearest(word, names()).map_or_else(String::new, |nearest| format!("did you mean {nearest}? "));
            let known: Vec<&str> = names().collect();
            SweepError::new(format!("no column {word:?}; {meant}there are: {}", known.join(", ")))
        })
    }

    /// Title of a column of numbers, by its title with or without its unit.
    pub(crate) fn numbers(&self, word: &str) -> Result<String, SweepError> {
        match self.column(word)? {
            (title, Kind::Numbers) => Ok(title),
            (title, _) => Err(SweepError::new(format!("column {title:?} holds no numbers"))),
        }
    }

    /// Keys of what is swept, without those of a catalogue, in their order.
    pub(crate) fn swept_keys(&self) -> Vec<String> {
        self.variables.iter().map(|variable| variable.target.key.clone()).collect()
    }

    /// Titles of what is varied and of what is recorded, where they hold numbers.
    pub(crate) fn numeric_titles(&self) -> [Vec<String>; 2] {
        let all = titles(self);
        let status = all.iter().position(|(title, _)| title == "status").unwrap_or(all.len());
        let of = |part: &[(String, Kind)]| {
            part.iter().filter(|(_, kind)| *kind == Kind::Numbers).map(|(title, _)| title.clone()).collect()
        };
        [of(&all[..status]), of(&all[status..])]
    }
}

impl Dataset {
    /// All columns of some rows, in the order in which they are asked for.
    ///
    /// # Errors
    /// [`SweepError`] for a row that is not there and a file that cannot be read.
    pub fn rows(&self, rows: &[u64]) -> Result<Chunk, SweepError> {
        let plan = self.plan();
        let titles = plan.titles();
        let words: Vec<&str> = titles.iter().map(String::as_str).collect();
        let length = plan.rows_of(0).end.max(1);
        let mut order: Vec<usize> = (0..rows.len()).collect();
        order.sort_by_key(|place| rows[*place]);
        let mut columns: Vec<Option<Data>> = vec![None; titles.len()];
        let there = self.there()?;
        for group in order.chunk_by(|a, b| rows[*a] / length == rows[*b] / length) {
            let chunk = rows[group[0]] / length;
            let first = chunk * length;
            let missing = || SweepError::new(format!("row {} is not there yet", rows[group[0]]));
            if rows[group[0]] >= plan.rows() {
                let message = format!("row {}: there are {}, counted from 0", rows[group[0]], plan.rows());
                return Err(SweepError::new(message));
            }
            if there.binary_search(&chunk).is_err() {
                return Err(missing());
            }
            let places: Vec<usize> = group.iter().map(|place| (rows[*place] - first) as usize).collect();
            for (column, data) in columns.iter_mut().zip(self.columns_of(chunk, &words)?) {
                // A chunk that is as it was written has all of its rows.
                let data = data.at(&places).ok_or_else(missing)?;
                match column {
                    Some(column) => column.append(data),
                    None => *column = Some(data),
                }
            }
        }
        let mut back = vec![0; order.len()];
        order.iter().enumerate().for_each(|(sorted, place)| back[*place] = sorted);
        let columns =
            columns.into_iter().map(|data| data.and_then(|data| data.at(&back)).unwrap_or(Data::Texts(Vec::new())));
        Ok(Chunk { columns: titles.into_iter().zip(columns).collect() })
    }
}

impl Data {
    /// The values at some places; `None` where one is not there.
    fn at(&self, places: &[usize]) -> Option<Self> {
        fn picked<T: Clone>(values: &[T], places: &[usize]) -> Option<Vec<T>> {
            places.iter().map(|place| values.get(*place).cloned()).collect()
        }
        Some(match self {
            Self::Whole(values) => Self::Whole(picked(values, places)?),
            Self::Numbers(values) => Self::Numbers(picked(values, places)?),
            Self::Texts(values) => Self::Texts(picked(values, places)?),
            Self::Flags(values) => Self::Flags(picked(values, places)?),
        })
    }
}
