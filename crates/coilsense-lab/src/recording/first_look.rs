//! What the head of a log tells of its columns: what they are called, and what each is, for certain or by a guess. No row but the first is read.
//!
//! Next door: guesses (`guess`), what is certain (`selection`), all of a log (`overview`).

use super::error::RecordingError;
use super::formats;
use super::guess::{self, guess};
use super::handed::Handed;
use super::mapping::{Format, PRESETS};
use super::quantity::Quantity;
use super::selection::{by_name, find};
use super::source::{Next, Source};
use super::title::Title;
use super::unit;
use crate::quantity::Dimension;

/// How a log is written, and its columns.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstLook {
    /// How it is written, in words.
    pub description: String,
    /// The titles of its columns.
    pub titles: Vec<Title>,
    /// What each column is; `None` where nothing speaks for any channel.
    pub meant: Vec<Option<Meant>>,
    /// The preset of [`PRESETS`] that it is written in, where its columns have no titles but are those of one.
    pub preset: Option<&'static str>,
    /// What stands above the rows.
    pub remarks: Vec<String>,
}

/// What a column is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Meant {
    /// A channel, or time.
    pub quantity: Quantity,
    /// Whether that is a guess by its unit and the words of its title.
    pub guessed: bool,
}

/// Columns of the preset `lab-data`, and what its pairs of resistance \[Ω\] and inductance \[H\] may be.
const PAIRED: usize = 24;
const RESISTANCES: std::ops::Range<f64> = 1e-6..1e6;
const INDUCTANCES: std::ops::Range<f64> = 1e-10..1.0;
/// Rows that are looked at for it.
const LOOKED_AT: usize = 3;

impl FirstLook {
    /// Looks at the head of a log; `format` says how a text is written.
    ///
    /// # Errors
    /// [`RecordingError`] for what is no text with columns.
    pub fn of(log: Handed, format: &Format) -> Result<Self, RecordingError> {
        let mut source = formats::held(log, format)?;
        let titles = source.titles().to_vec();
        Ok(Self {
            description: source.description(),
            remarks: source.remarks().to_vec(),
            meant: meant(&titles),
            preset: if is_paired(&mut source, &titles)? { PRESETS.first().map(|(name, _)| *name) } else { None },
            titles,
        })
    }
}

/// What each column is: those that carry a channel's name, and guesses for what none of these measures.
fn meant(titles: &[Title]) -> Vec<Option<Meant>> {
    let mut all = vec![None; titles.len()];
    let mut named = Vec::new();
    for quantity in Quantity::all() {
        let place = by_name(titles, quantity).and_then(|title| find(titles, &title, quantity).ok());
        if let Some(index) = place.filter(|&index| all[index].is_none()) {
            all[index] = Some(Meant { quantity, guessed: false });
            named.push(quantity);
        }
    }
    let put =
        |all: &mut Vec<Option<Meant>>, index: usize, quantity| all[index] = Some(Meant { quantity, guessed: true });
    let free = |all: &[Option<Meant>]| (0..titles.len()).filter(|&index| all[index].is_none()).collect::<Vec<_>>();
    if !named.contains(&Quantity::Time)
        && let Some(index) = guess::time(titles, &free(&all))
    {
        put(&mut all, index, Quantity::Time);
    }
    let has = |dimension: Dimension| named.iter().any(|quantity| quantity.dimension() == dimension);
    let [mut told, mut untold] = [Vec::new(), Vec::new()];
    for index in free(&all) {
        match titles[index].unit.as_deref() {
            Some(unit) if unit::dimension(unit).is_some_and(|of| !has(of)) => told.push(index),
            None => untold.push(index),
            Some(_) => {}
        }
    }
    let mut found = guess(titles, &told);
    // A column without a unit keeps a log from being read until somebody tells it: only where nothing else is a channel.
    if found.is_empty() && named.iter().all(|quantity| *quantity == Quantity::Time) {
        found = guess(titles, &untold);
    }
    for (index, channel) in found {
        put(&mut all, index, Quantity::Channel(channel));
    }
    all
}

/// Whether the rows are as the rig of the measured runs wrote them: numbered, and behind the displacement pairs of resistance and inductance.
fn is_paired(source: &mut impl Source, titles: &[Title]) -> Result<bool, RecordingError> {
    if titles.len() != PAIRED || titles.iter().any(|title| !title.text.is_empty()) {
        return Ok(false);
    }
    let wanted: Vec<usize> = (0..PAIRED).collect();
    let mut cells = Vec::new();
    for number in 1..=LOOKED_AT {
        match source.next(&wanted, &mut cells)? {
            Next::End => return Ok(number > 1),
            Next::Broken { .. } => return Ok(false),
            Next::Row(_) => {
                let pairs = cells[4..].chunks_exact(2);
                let fits = |pair: &[f64]| RESISTANCES.contains(&pair[0]) && INDUCTANCES.contains(&pair[1]);
                #[expect(clippy::float_cmp, reason = "the rows' own whole numbers")]
                let counts = cells[0] == number as f64;
                if !(counts && pairs.clone().all(fits)) {
                    return Ok(false);
                }
            }
        }
    }
    Ok(true)
}
