//! The datasets of a file, in groups within groups: those that hold numbers are read, window by window.
//!
//! Next door: the numbers of a row (`members`), the table (`super::super::vectors`).

use std::path::Path;

use hdf5_pure::{Dataset, Error, File, FormatError, Group, ReadSeekSource};

use super::super::super::error::shortened;
use super::super::super::order::MOST_NUMBERS;
use super::super::apart::Apart;
use super::super::only_matlab::advice;
use super::super::vectors::Variable;
use super::members::Member;

/// Along which dimension of a matrix a column lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// The first: each row is a sample.
    Rows,
    /// The last, as MATLAB stores it.
    Columns,
}

/// What was found.
pub(super) struct Datasets {
    pub variables: Vec<Variable>,
    pub apart: Apart,
    /// How to get at what only MATLAB reads.
    pub advice: Option<String>,
    order: Order,
    file: String,
    /// Bytes of the file.
    size: u64,
    numbers: usize,
    groups: usize,
}

/// Why a dataset is not read.
enum Wrong {
    Library(Error),
    Told(String),
}

impl From<Error> for Wrong {
    fn from(error: Error) -> Self {
        Self::Library(error)
    }
}

/// Most groups and datasets, how deep they may lie, most columns of a matrix.
const MOST: usize = 10_000;
const DEEPEST: usize = 16;
const MOST_COLUMNS: u64 = 1000;
/// Most bytes of a chunk of a dataset, which is unpacked as a whole.
const MOST_CHUNK: u64 = 1 << 28;
/// Most bytes of numbers for each byte of the file; deflate packs zeros to a thousandth.
const MOST_PACKED: u64 = 1100;
/// Numbers that are read at once.
const WINDOW: u64 = 1 << 20;

impl Datasets {
    pub fn of(order: Order) -> Self {
        Self {
            variables: Vec::new(),
            apart: Apart::default(),
            advice: None,
            order,
            file: String::new(),
            size: 0,
            numbers: 0,
            groups: 0,
        }
    }

    /// Reads a file.
    pub fn read(&mut self, path: &Path, file: std::fs::File) -> Result<(), String> {
        // Into the line of Python; a name that would end its quotes is left to be filled in.
        let name = path.display().to_string();
        self.file = if name.contains(['"', '\'', '\\']) { "FILE".to_owned() } else { name };
        self.size = file.metadata().map_or(0, |metadata| metadata.len());
        let file = File::from_source(ReadSeekSource::new(file).map_err(|error| error.to_string())?).map_err(told)?;
        self.group(&file.root(), "", 0)
    }

    fn group(&mut self, group: &Group, above: &str, depth: usize) -> Result<(), String> {
        self.groups += 1;
        if self.groups > MOST || self.variables.len() > MOST {
            return Err(format!("it has more than {MOST} groups or datasets"));
        }
        for (name, dataset) in group.iter_datasets().map_err(told)? {
            self.dataset(&dataset, &format!("{above}{name}"))?;
        }
        for (name, inner) in group.iter_groups().map_err(told)? {
            // Groups of a name that begins so hold the insides of MATLAB's objects, and PyTables' indices.
            if name.starts_with('#') || name.starts_with("_i_") {
                continue;
            }
            if depth >= DEEPEST {
                self.apart.leave(&format!("{above}{name}"), "groups too deep in one another");
                continue;
            }
            // A group of MATLAB's is a struct.
            let within = if self.order == Order::Columns { '.' } else { '/' };
            self.group(&inner, &format!("{above}{name}{within}"), depth + 1)?;
        }
        Ok(())
    }

    fn dataset(&mut self, dataset: &Dataset, name: &str) -> Result<(), String> {
        let attributes = dataset.attrs().unwrap_or_default();
        let attribute = |name: &str| attributes.get(name).and_then(|value| value.as_str().map(str::to_owned));
        let class = attribute("MATLAB_class").unwrap_or_default();
        if attributes.contains_key("MATLAB_object_decode") {
            self.apart.leave(name, &format!("a {}", shortened(&class)));
            let line = || advice(name, &class);
            self.advice.get_or_insert_with(line);
            return Ok(());
        }
        if attributes.contains_key("MATLAB_empty")
            || matches!(class.as_str(), "char" | "cell" | "struct" | "function_handle")
        {
            return Ok(());
        }
        let unit = attribute("unit").or_else(|| attribute("units")).map(|unit| unit.trim().to_owned());
        match self.numbers(dataset, name, unit.filter(|unit| !unit.is_empty())) {
            Ok(()) => Ok(()),
            Err(Wrong::Library(Error::Format(FormatError::InvalidLayoutVersion(5)))) => {
                self.left(name, "in a layout of HDF5 2", "h5py")
            }
            Err(Wrong::Library(Error::Format(FormatError::UnsupportedFilter(filter)))) => {
                self.left(name, &format!("packed by filter {filter}"), "hdf5plugin, h5py")
            }
            Err(Wrong::Library(Error::Format(
                FormatError::UnsupportedVirtualLayout | FormatError::UnsupportedExternalStorage,
            ))) => self.left(name, "in other files", "h5py"),
            Err(Wrong::Library(error)) => Err(format!("{}: {}", shortened(name), told(error))),
            Err(Wrong::Told(message)) => Err(format!("{}: {message}", shortened(name))),
        }
    }

    /// One that only the library of HDF5 reads.
    fn left(&mut self, name: &str, why: &str, library: &str) -> Result<(), String> {
        self.apart.leave(name, why);
        let line = || {
            format!(
                "{} is {why}, which is not read; write it anew: python -c 'import {library}; f = h5py.File(\"{}\"); \
                 g = h5py.File(\"log.h5\", \"w\"); f.visititems(lambda n, d: \
                 g.create_dataset(n, data=d[()]).attrs.update(d.attrs) if isinstance(d, h5py.Dataset) else None)'",
                shortened(name),
                self.file
            )
        };
        self.advice.get_or_insert_with(line);
        Ok(())
    }

    fn numbers(&mut self, dataset: &Dataset, name: &str, unit: Option<String>) -> Result<(), Wrong> {
        let (shape, datatype) = (dataset.shape()?, dataset.datatype()?);
        let members = Member::all(&datatype);
        let (rows, columns) = match (shape.as_slice(), self.order) {
            (&[rows], _) => (rows, 1),
            (&[rows, columns], Order::Rows) | (&[columns, rows], Order::Columns) => (rows, columns),
            _ => return Ok(()),
        };
        let (rows, columns) = if rows == 1 { (columns, 1) } else { (rows, columns) };
        let fits = rows > 0 && (1..=MOST_COLUMNS).contains(&columns) && (columns == 1 || members.len() == 1);
        if members.is_empty() || !fits {
            return Ok(());
        }
        let row = u64::from(datatype.type_size());
        self.count(dataset, rows.saturating_mul(columns), row, members.len())?;
        for (member, mut values) in members.iter().zip(series(dataset, &shape, row, &members)?) {
            let name = if member.name.is_empty() { name.to_owned() } else { format!("{name}/{}", member.name) };
            if columns > 1 && self.order == Order::Rows {
                values = turned(&values, columns as usize);
            }
            let variable = Variable::of(name, [rows as usize, columns as usize], values);
            self.variables.extend(variable.map(|variable| Variable { unit: unit.clone(), ..variable }));
        }
        Ok(())
    }

    /// Counts the numbers of a dataset before they are read.
    fn count(&mut self, dataset: &Dataset, rows: u64, row: u64, members: usize) -> Result<(), Wrong> {
        let count = usize::try_from(rows.saturating_mul(members as u64)).unwrap_or(usize::MAX);
        self.numbers = self.numbers.saturating_add(count);
        if self.numbers > MOST_NUMBERS {
            return Err(Wrong::Told("it is too large to be held in memory".to_owned()));
        }
        if rows.saturating_mul(row) > self.size.saturating_mul(MOST_PACKED) {
            return Err(Wrong::Told(format!("{rows} values are more than its file can hold")));
        }
        let chunk =
            dataset.chunk_shape()?.unwrap_or_default().iter().fold(row, |bytes, size| bytes.saturating_mul(*size));
        if chunk > MOST_CHUNK || row > WINDOW {
            return Err(Wrong::Told("its chunks are larger than 256 MiB".to_owned()));
        }
        // The library makes room for what a chunk says of itself before it looks for its bytes.
        let chunks = if dataset.is_chunked() { dataset.chunks()? } else { Vec::new() };
        if chunks.iter().any(|one| one.storage_size > self.size || one.storage_size > 2 * MOST_CHUNK) {
            return Err(Wrong::Told("a chunk of it is larger than its file".to_owned()));
        }
        Ok(())
    }
}

/// The numbers of each member, in the order of the file.
fn series(dataset: &Dataset, shape: &[u64], row: u64, members: &[Member]) -> Result<Vec<Vec<f64>>, Error> {
    let mut series = vec![Vec::new(); members.len()];
    let first = shape.first().copied().unwrap_or(0);
    let inner: u64 = shape.iter().skip(1).product();
    let window = (WINDOW / (inner.max(1) * row.max(1))).max(1);
    let mut start = 0;
    while start < first {
        let count = window.min(first - start);
        let bytes = dataset.read_raw_rows(start, count)?;
        for row in bytes.chunks_exact(row as usize) {
            for (values, member) in series.iter_mut().zip(members) {
                values.push(member.number(row));
            }
        }
        start += count;
    }
    Ok(series)
}

/// A matrix of rows as one of columns.
fn turned(values: &[f64], columns: usize) -> Vec<f64> {
    (0..columns).flat_map(|column| values.iter().skip(column).step_by(columns).copied()).collect()
}

/// What the library says.
fn told(error: Error) -> String {
    shortened(&error.to_string())
}
