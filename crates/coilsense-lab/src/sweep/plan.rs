//! All that decides the rows of a sweep: the spec, what is varied and how, and what is recorded.
//!
//! Next door: the rows themselves (`chunk`), where they go (`dataset`).

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

use super::SweepError;
use super::catalogue::{Catalogue, Ready};
use super::column::{self, Column, Kind, MOVES, Names, Needs};
use super::sampling::{Sampler, Sampling};
use super::variable::{Cell, Variable};
use super::{chunking, sobol, variable};
use crate::message::{Hint, Message};
use crate::spec::{Draft, Files, Recordings, Spec, SpringSpec, TABLES, files_beside, read_text};

/// A plan as people give it, and as a manifest keeps it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanParameters {
    /// The spec's name, as messages call it.
    pub spec_file: String,
    /// Its text.
    pub spec: String,
    /// Files that the spec names, by the name it has for them.
    #[serde(default)]
    pub files: BTreeMap<String, String>,
    /// What is varied: `KEY=VALUES` each.
    #[serde(default)]
    pub over: Vec<String>,
    /// Rows of values beside them.
    #[serde(default)]
    pub catalogue: Option<Catalogue>,
    /// How rows are laid over the variables; without it a grid where every variable has its points, else a Latin hypercube.
    #[serde(default)]
    pub sampling: Option<Sampling>,
    /// How many rows, for each of the catalogue where there is one; a grid has its own number. Of Saltelli's design base rows, each of which
    /// is evaluated two times and once more for each variable.
    #[serde(default)]
    pub rows: Option<u64>,
    /// Of all randomness.
    #[serde(default)]
    pub seed: u64,
    /// What is recorded; without it the spring and the forces that are quick to have.
    #[serde(default)]
    pub columns: Vec<String>,
    /// Rows of a file; without it by how long a row takes.
    #[serde(default)]
    pub chunk_rows: Option<u64>,
}

/// A plan, checked, whose parameters have all been filled in.
#[derive(Debug, Clone)]
pub struct Plan {
    parameters: PlanParameters,
    pub(super) variables: Vec<Variable>,
    pub(super) catalogue: Option<Ready>,
    pub(super) columns: Vec<(String, Column)>,
    pub(super) needs: Needs,
    sampler: Sampler,
    /// Files that designs share, as they have been read.
    recordings: Arc<Recordings>,
    /// Rows for each of the catalogue.
    inner: u64,
    rows: u64,
    chunk_rows: u64,
    /// As it is once asked for.
    pub(super) digest: OnceLock<String>,
}

/// Most rows of a sweep.
const MOST_ROWS: u64 = 1_000_000_000;

impl PlanParameters {
    /// The plan's spec from a file, with the files that it names beside it.
    ///
    /// # Errors
    /// [`SweepError`] where one of them cannot be read.
    pub fn with_spec(self, path: &Path) -> Result<Self, SweepError> {
        self.with_text(&path.display().to_string(), &read_text(path)?, &files_beside(path))
    }

    /// The plan's spec from its text; `file` names it in errors, `beside` reads the files that it names.
    ///
    /// # Errors
    /// [`SweepError`] where one of them cannot be read.
    pub fn with_text(self, file: &str, text: &str, beside: &Files<'_>) -> Result<Self, SweepError> {
        let kept = RefCell::new(BTreeMap::new());
        let reader = |name: &str| -> Result<String, String> {
            let text = beside(name)?;
            kept.borrow_mut().insert(name.to_owned(), text.clone());
            Ok(text)
        };
        // Whatever else is wrong with the spec is said by the plan.
        let _ = Spec::parse(file, text, &reader);
        let draft = Draft::parse(file, text)?;
        for over in &self.over {
            let variable = Variable::parse(over, &draft)?;
            if variable.target.key.ends_with(".file") {
                for name in variable.texts() {
                    reader(name).map_err(|message| SweepError::new(format!("{}: {message}", variable.target.key)))?;
                }
            }
        }
        Ok(Self { files: kept.into_inner(), spec_file: file.to_owned(), spec: text.to_owned(), ..self })
    }
}

impl Plan {
    /// Checks a plan and fills in what it leaves open.
    ///
    /// # Errors
    /// [`SweepError`], one line that names the key, the value and what is allowed.
    pub fn new(parameters: PlanParameters) -> Result<Self, SweepError> {
        let draft = Draft::parse(&parameters.spec_file, &parameters.spec)?;
        let variables: Vec<Variable> =
            parameters.over.iter().map(|over| Variable::parse(over, &draft)).collect::<Result<_, _>>()?;
        let catalogue = parameters.catalogue.as_ref().map(|table| Ready::new(table, &draft)).transpose()?;
        if variables.is_empty() && catalogue.is_none() {
            let message = Message::from("nothing is varied: give ") + Hint::Option("over", "KEY=VALUES");
            return Err(SweepError::new(message + " or " + Hint::Option("catalogue", "FILE")));
        }
        once_each(&variables, catalogue.as_ref())?;
        let points: Vec<Option<u64>> = variables.iter().map(Variable::points).collect();
        let whole = points.iter().all(Option::is_some);
        let usual = if whole && parameters.rows.is_none() { Sampling::Grid } else { Sampling::Lhs };
        let sampling = parameters.sampling.unwrap_or(usual);
        let asked = number_of_rows(sampling, &variables, parameters.rows)?;
        let inner = asked.saturating_mul(evaluations(sampling, variables.len()));
        let items = parameters.catalogue.as_ref().map_or(1, |table| table.rows.len() as u64);
        let rows = inner.saturating_mul(items);
        if rows > MOST_ROWS {
            return Err(SweepError::new(format!("the sweep has {rows} rows; at most {MOST_ROWS} are taken")));
        }
        let sampler = Sampler::new(sampling, &points, inner, parameters.seed);
        let names = names(&draft);
        let words = words(&parameters, &draft, &names);
        let columns = columns(&words, &names, &parameters.spec_file)?;
        let mut needs = Needs::default();
        columns.iter().for_each(|(_, column)| column.add_to(&mut needs));
        if needs.motion() && !variables.iter().any(|variable| variable.target.place.is_of_spring("model")) {
            // Whatever else is wrong with the spring is said by its designs.
            if let Ok(spring) = SpringSpec::parse(&parameters.spec_file, &parameters.spec) {
                let refused = spring.needs_axial(&parameters.spec_file, MOVES);
                refused.map_err(|error| SweepError::new(error.to_string()))?;
            }
        }
        let chunk_rows = chunking::rows_of_chunk(parameters.chunk_rows, &needs, rows)?;
        let parameters = PlanParameters {
            sampling: Some(sampling),
            rows: Some(asked),
            columns: words,
            chunk_rows: Some(chunk_rows),
            ..parameters
        };
        let plan = Self {
            parameters,
            variables,
            catalogue,
            columns,
            needs,
            sampler,
            recordings: Arc::default(),
            inner,
            rows,
            chunk_rows,
            digest: OnceLock::new(),
        };
        plan.check_titles()?;
        plan.check_spec()?;
        Ok(plan)
    }

    /// The plan of a text that [`Self::to_json`] made.
    ///
    /// # Errors
    /// [`SweepError`] where it is none.
    pub fn from_json(text: &str) -> Result<Self, SweepError> {
        Self::new(serde_json::from_str(text).map_err(|error| SweepError::of("the plan", error.to_string()))?)
    }

    /// All of it as a text that makes the same plan anywhere.
    pub fn to_json(&self) -> String {
        // A map of texts and numbers can always be written.
        serde_json::to_string(&self.parameters).unwrap_or_default()
    }

    /// What it was made from, with all that was left open filled in.
    pub fn parameters(&self) -> &PlanParameters {
        &self.parameters
    }

    /// How many rows there are.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// How many chunks they fall into.
    pub fn chunks(&self) -> u64 {
        self.rows.div_ceil(self.chunk_rows)
    }

    /// The rows of a chunk; of one that is not there, none.
    pub fn rows_of(&self, chunk: u64) -> std::ops::Range<u64> {
        let from = chunk.saturating_mul(self.chunk_rows).min(self.rows);
        from..(from + self.chunk_rows).min(self.rows)
    }

    /// Titles of all columns, in order, each with its unit in brackets where it holds numbers.
    pub fn titles(&self) -> Vec<String> {
        titles(self).into_iter().map(|(title, _)| title).collect()
    }

    /// What a row's design replaces in the spec, and by what; the catalogue's first.
    pub(super) fn settings(&self, row: u64) -> Vec<(&variable::Target, variable::Setting)> {
        let (item, inner) = (row / self.inner, row % self.inner);
        let catalogue = self.catalogue.iter().flat_map(|catalogue| catalogue.settings(item as usize));
        let of_variable = |(variable, coordinate): (&'_ Variable, _)| variable.at(coordinate);
        let sampled = self.variables.iter().zip(self.sampler.row(inner)).map(of_variable);
        catalogue.chain(self.variables.iter().map(|variable| &variable.target).zip(sampled)).collect()
    }

    /// Sets a draft to a row's design; gives the values as the result shows them, the catalogue's first.
    pub(super) fn set(&self, row: u64, draft: &mut Draft<'_>) -> Vec<Cell> {
        let (item, inner) = (row / self.inner, row % self.inner);
        let mut cells = Vec::with_capacity(self.variables.len());
        if let Some(catalogue) = &self.catalogue {
            catalogue.set(item as usize, draft);
            cells = catalogue.cells(item as usize);
        }
        for (variable, coordinate) in self.variables.iter().zip(self.sampler.row(inner)) {
            let setting = variable.at(coordinate);
            draft.set(&variable.target.place, setting.0.clone());
            cells.push(variable.target.cell(&setting, !variable.is_text()));
        }
        cells
    }

    /// The spec, ready for a row's values.
    pub(super) fn draft(&self) -> Result<Draft<'_>, SweepError> {
        Ok(Draft::parse(&self.parameters.spec_file, &self.parameters.spec)?.sharing(&self.recordings))
    }

    /// Reads a file that the spec names.
    pub(super) fn file(&self, name: &str) -> Result<String, String> {
        self.parameters.files.get(name).cloned().ok_or_else(|| format!("{name} is not in the plan"))
    }

    /// No two columns have one title.
    fn check_titles(&self) -> Result<(), SweepError> {
        let titles = self.titles();
        let twice = titles.iter().enumerate().find(|(index, title)| titles[..*index].contains(title));
        match twice {
            Some((_, title)) => Err(SweepError::new(format!("two columns are called {title:?}"))),
            None => Ok(()),
        }
    }

    /// The spec itself can be read, or at least with the values of a row from among the first: else every row would be refused.
    fn check_spec(&self) -> Result<(), SweepError> {
        let mut draft = self.draft()?;
        let files = |name: &str| self.file(name);
        let Err(error) = draft.spec(&files) else { return Ok(()) };
        for row in 0..self.rows.min(TRIED) {
            self.set(row, &mut draft);
            if draft.spec(&files).is_ok() {
                return Ok(());
            }
        }
        Err(error.into())
    }
}

/// How many rows are tried with a spec that cannot be read by itself.
const TRIED: u64 = 100;

const ROWS: Hint = Hint::Option("rows", "");

fn number_of_rows(sampling: Sampling, variables: &[Variable], rows: Option<u64>) -> Result<u64, SweepError> {
    if sampling == Sampling::Grid {
        if rows.is_some_and(|rows| Some(rows) != grid_rows(variables)) {
            let message = Message::from("a grid has its own number of rows; leave ") + ROWS;
            return Err(SweepError::new(message + " out, or sample otherwise"));
        }
        let open = variables.iter().find(|variable| variable.points().is_none());
        if let Some(variable) = open {
            let key = &variable.target.key;
            return Err(SweepError::new(format!("{key}: a grid needs its number of points, as in {key}=1..2 : 11")));
        }
        return grid_rows(variables).ok_or_else(|| SweepError::new(format!("the grid has more than {MOST_ROWS} rows")));
    }
    if variables.is_empty() {
        return Ok(1);
    }
    let Some(rows) = rows else {
        let open = variables.iter().find(|variable| variable.points().is_none());
        let key = open.map_or("", |variable| variable.target.key.as_str());
        let text = format!(", or give {key} points, as in {key}=1..2 : 11");
        return Err(SweepError::new(Message::from("say how many rows with ") + ROWS + text));
    };
    if matches!(sampling, Sampling::Sobol | Sampling::Saltelli) {
        let most = if sampling == Sampling::Sobol { sobol::MOST_VARIABLES } else { sobol::MOST_VARIABLES / 2 };
        if variables.len() > most {
            let text =
                format!("sampling {} is here for {most} variables at most, got {}", sampling.name(), variables.len());
            return Err(SweepError::new(text));
        }
        if rows > sobol::MOST_ROWS {
            return Err(SweepError::new(format!("Sobol's sequence has {} rows at most, got {rows}", sobol::MOST_ROWS)));
        }
    }
    let none = || SweepError::new(Message::from(ROWS) + " must be at least 1, got 0");
    if rows == 0 { Err(none()) } else { Ok(rows) }
}

/// Rows of one that is asked for.
fn evaluations(sampling: Sampling, variables: usize) -> u64 {
    if sampling == Sampling::Saltelli { variables as u64 + 2 } else { 1 }
}

fn grid_rows(variables: &[Variable]) -> Option<u64> {
    variables.iter().try_fold(1u64, |rows, variable| rows.checked_mul(variable.points()?)).filter(|n| *n <= MOST_ROWS)
}

/// No key is set twice.
fn once_each(variables: &[Variable], catalogue: Option<&Ready>) -> Result<(), SweepError> {
    let targets: Vec<&variable::Target> =
        catalogue.into_iter().flat_map(Ready::targets).chain(variables.iter().map(|v| &v.target)).collect();
    let twice = targets.iter().enumerate().find(|(index, t)| targets[..*index].iter().any(|o| o.place == t.place));
    match twice {
        Some((_, target)) => Err(SweepError::new(format!("{}: is varied twice", target.key))),
        None => Ok(()),
    }
}

/// Conditions and sensors that columns may name.
fn names(draft: &Draft<'_>) -> Names {
    let table = |name| TABLES.into_iter().find(|table| table.name == name);
    let names = |name| table(name).map_or_else(Vec::new, |table| draft.names(table));
    Names { conditions: names("condition"), sensors: names("sensor"), springs: draft.springs() }
}

/// Words of the columns that are asked for, or of the usual ones.
fn words(parameters: &PlanParameters, draft: &Draft<'_>, names: &Names) -> Vec<String> {
    match parameters.columns.is_empty() {
        true => column::usual(draft.truth(), names),
        false => parameters.columns.iter().map(|word| word.trim().to_owned()).collect(),
    }
}

/// The columns of words, each with its title.
fn columns(words: &[String], names: &Names, spec_file: &str) -> Result<Vec<(String, Column)>, SweepError> {
    let mut columns = Vec::new();
    let mut needs = Needs::default();
    for word in words {
        let column = Column::parse(word, names)?;
        column.add_to(&mut needs);
        let title = column.unit().map_or_else(|| word.clone(), |unit| format!("{word} [{unit}]"));
        columns.push((title, column));
    }
    let forces = needs != Needs::default();
    if forces && names.conditions.is_empty() {
        return Err(SweepError::new(format!("{}: no [[condition]] says what is done to the spring", spec_file)));
    }
    Ok(columns)
}

/// Titles of all columns of a plan, and what they hold.
pub(super) fn titles(plan: &Plan) -> Vec<(String, Kind)> {
    let of = |numeric: bool| if numeric { Kind::Numbers } else { Kind::Texts };
    let mut titles = vec![("row".to_owned(), Kind::Whole)];
    titles.extend(plan.catalogue.iter().flat_map(|table| table.titles()).map(|(title, n)| (title.to_owned(), of(n))));
    let variables = plan.variables.iter().map(|variable| !variable.is_text()).zip(&plan.variables);
    titles.extend(variables.map(|(numeric, variable)| (variable.target.title(numeric), of(numeric))));
    titles.extend(["status", "reason"].map(|title| (title.to_owned(), Kind::Texts)));
    titles.extend(plan.columns.iter().map(|(title, column)| (title.clone(), column.kind())));
    titles
}
