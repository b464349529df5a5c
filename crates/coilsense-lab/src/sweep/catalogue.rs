//! A catalogue of springs, or of any keys: a table whose titles are keys of the spec and whose rows are designs.
//!
//! Next door: variables that are swept for each of its rows (`variable`).

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::SweepError;
use super::variable::{Cell, Setting, Target};
use crate::spec::{Domain, Draft};

/// A table of texts, as its file has them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Catalogue {
    /// `spring.stiffness [N/m]`, or without a unit where each cell has its own; a title without a dot is a column that is carried along.
    pub titles: Vec<String>,
    /// Rows of cells, as many as titles.
    pub rows: Vec<Vec<String>>,
}

/// Most bytes of a catalogue's file, and most rows.
const MOST_BYTES: u64 = 1 << 28;
const MOST_ROWS: usize = 1_000_000;

impl Catalogue {
    /// Reads a CSV file with a header, or a Parquet file.
    ///
    /// # Errors
    /// [`SweepError`], one line that names the file.
    pub fn read(path: &Path) -> Result<Self, SweepError> {
        let named = |message: String| SweepError::new(format!("{}: {message}", path.display()));
        let is_parquet = path.extension().is_some_and(|ending| ending == "parquet");
        let catalogue = if is_parquet { parquet(path) } else { csv(path) };
        let catalogue = catalogue.map_err(named)?;
        match catalogue.rows.len() {
            0 => Err(named("no row is below its titles".to_owned())),
            rows if rows > MOST_ROWS => Err(named(format!("it has {rows} rows; at most {MOST_ROWS} are taken"))),
            _ => Ok(catalogue),
        }
    }
}

fn csv(path: &Path) -> Result<Catalogue, String> {
    let text = crate::spec::bounded(path, MOST_BYTES)?;
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let cells = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect::<Vec<_>>();
    let titles = cells(reader.headers().map_err(|error| error.to_string())?);
    let rows = reader.records().map(|record| record.map(|record| cells(&record)).map_err(|error| error.to_string()));
    Ok(Catalogue { titles, rows: rows.collect::<Result<_, _>>()? })
}

#[cfg(feature = "parquet")]
fn parquet(path: &Path) -> Result<Catalogue, String> {
    crate::guarded::guarded(path, || decoded(path))
}

#[cfg(feature = "parquet")]
fn decoded(path: &Path) -> Result<Catalogue, String> {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    let one_line = |error: parquet::errors::ParquetError| error.to_string().replace('\n', " ");
    let file = crate::input::open(path).map_err(|error| error.to_string())?;
    let reader = SerializedFileReader::new(crate::bounded::Bounded(file)).map_err(one_line)?;
    let schema = reader.metadata().file_metadata().schema().clone();
    let titles: Vec<String> = schema.get_fields().iter().map(|field| field.name().to_owned()).collect();
    let text = |field: &Field| match field {
        Field::Null => String::new(),
        Field::Str(text) => text.clone(),
        other => other.to_string(),
    };
    let mut rows = Vec::new();
    for row in reader.get_row_iter(None).map_err(one_line)?.take(MOST_ROWS + 1) {
        let row = row.map_err(one_line)?;
        rows.push(row.get_column_iter().map(|(_, field)| text(field)).collect());
    }
    Ok(Catalogue { titles, rows })
}

#[cfg(not(feature = "parquet"))]
fn parquet(_: &Path) -> Result<Catalogue, String> {
    Err("this build reads no Parquet files".to_owned())
}

/// A catalogue whose titles have been found in the spec.
#[derive(Debug, Clone)]
pub(super) struct Ready {
    columns: Vec<Column>,
    /// Of each column, which are as long as the catalogue.
    cells: Vec<Vec<Setting>>,
}

/// A column of the catalogue.
#[derive(Debug, Clone)]
struct Column {
    /// `None` of a column that is carried along.
    target: Option<Target>,
    title: String,
    numeric: bool,
}

impl Ready {
    pub fn new(catalogue: &Catalogue, draft: &Draft<'_>) -> Result<Self, SweepError> {
        let mut ready = Self { columns: Vec::new(), cells: Vec::new() };
        for (index, title) in catalogue.titles.iter().enumerate() {
            let cells: Vec<&str> = catalogue.rows.iter().map(|row| row.get(index).map_or("", String::as_str)).collect();
            let (column, cells) = column(title, &cells, draft)
                .map_err(|message| SweepError::new(format!("catalogue, column {} {title:?}: {message}", index + 1)))?;
            ready.columns.push(column);
            ready.cells.push(cells);
        }
        Ok(ready)
    }

    /// Title and kind of each column: whether it holds numbers.
    pub fn titles(&self) -> impl Iterator<Item = (&str, bool)> {
        self.columns.iter().map(|column| (column.title.as_str(), column.numeric))
    }

    /// The keys that it sets.
    pub fn targets(&self) -> impl Iterator<Item = &Target> {
        self.columns.iter().filter_map(|column| column.target.as_ref())
    }

    /// Puts a row's values into a design.
    pub fn set(&self, row: usize, design: &mut Draft<'_>) {
        for (column, cells) in self.columns.iter().zip(&self.cells) {
            if let (Some(target), Some(setting)) = (&column.target, cells.get(row)) {
                design.set(&target.place, setting.0.clone());
            }
        }
    }

    /// What a row sets.
    pub fn settings(&self, row: usize) -> impl Iterator<Item = (&Target, Setting)> {
        let columns = self.columns.iter().zip(&self.cells);
        columns.filter_map(move |(column, cells)| Some((column.target.as_ref()?, cells.get(row)?.clone())))
    }

    /// A row's values as the result shows them.
    pub fn cells(&self, row: usize) -> Vec<Cell> {
        let cell = |(column, cells): (&Column, &Vec<Setting>)| {
            let setting = cells.get(row).cloned().unwrap_or(Setting(String::new()));
            match &column.target {
                Some(target) => target.cell(&setting, column.numeric),
                None if column.numeric => Cell::Number(setting.0.parse().unwrap_or(f64::NAN)),
                None => Cell::Text(setting.0),
            }
        };
        self.columns.iter().zip(&self.cells).map(cell).collect()
    }
}

/// A column from its title and cells.
fn column(title: &str, cells: &[&str], draft: &Draft<'_>) -> Result<(Column, Vec<Setting>), String> {
    let (key, unit) = match title.split_once('[') {
        Some((key, rest)) => (key.trim(), Some(rest.trim_end().trim_end_matches(']').trim())),
        None => (title.trim(), None),
    };
    if !key.contains('.') {
        let numeric = cells.iter().all(|cell| cell.is_empty() || cell.parse::<f64>().is_ok());
        let settings = cells.iter().map(|cell| Setting((*cell).to_owned())).collect();
        return Ok((Column { target: None, title: title.to_owned(), numeric }, settings));
    }
    let place = draft.place(key)?;
    let numeric = place.domain != Domain::Text;
    let unit = match (&place.domain, unit) {
        (Domain::Quantity(dimensions), Some(unit)) => {
            let of = dimensions.iter().find(|dimension| dimension.scale(unit).is_some());
            let wrong = || format!("its unit must be that of {}", dimensions[0].expectation());
            Some((unit.to_owned(), *of.ok_or_else(wrong)?))
        }
        // Each cell has its unit: that of the first says of what.
        (Domain::Quantity(dimensions), None) => {
            let first = dimensions.iter().find(|dimension| cells.first().is_some_and(|c| dimension.parse(c).is_some()));
            first.map(|dimension| (String::new(), *dimension))
        }
        (_, Some(unit)) if !unit.is_empty() && unit != "1" => return Err(format!("{key} takes no unit, got {unit}")),
        _ => None,
    };
    let setting = |cell: &&str| match &unit {
        Some((unit, _)) if !unit.is_empty() => Setting(format!("{cell} {unit}")),
        _ => Setting((*cell).to_owned()),
    };
    let settings = cells.iter().map(setting).collect();
    let target = Target { key: key.to_owned(), place, unit };
    let title = target.title(numeric);
    Ok((Column { target: Some(target), title, numeric }, settings))
}
