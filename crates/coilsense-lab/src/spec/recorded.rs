//! The file of a `[[condition]]` of kind `recorded`: time and the ends' motion as CSV.
//!
//! Next door: the rest of a condition (`condition`), files that many designs share (`recordings`).

use coilsense::excitation::Sampled;
use coilsense::{EndInput, FarEnd};

use super::heading;
use crate::quantity::Dimension;

/// A recorded motion of one end or both, or of end 1 and the force at end 2.
#[derive(Debug, Clone)]
pub(super) struct Recorded {
    /// The inputs of end 1 and end 2.
    pub inputs: [EndInput; 2],
    /// Its comment lines, without the `#`.
    pub remarks: Vec<String>,
    last: f64,
    /// The least that u2 − u1 becomes \[m\].
    pub shortest: f64,
}

/// A column of the file: which one, and what takes its numbers to SI.
struct Column {
    index: usize,
    factor: f64,
}

impl Recorded {
    /// The time of the last sample in the file \[s\], however fast it is played.
    pub fn duration(&self) -> f64 {
        self.last
    }

    /// The same motion in less time: `speed` times as fast \[1\]; forces at end 2 stay what they are.
    pub fn played(self, speed: f64) -> Result<Self, String> {
        let [one, two] = self.inputs;
        let faster = |input: EndInput| match input {
            EndInput::Sampled(sampled) => {
                sampled.played(speed).map(EndInput::Sampled).map_err(|error| error.to_string())
            }
            other => Ok(other),
        };
        let mut remarks = self.remarks;
        remarks.push(format!("played at {} % of the file's speed", 100.0 * speed));
        Ok(Self { inputs: [faster(one)?, faster(two)?], remarks, last: self.last, shortest: self.shortest })
    }

    pub fn parse(text: &str, far_end: FarEnd) -> Result<Self, String> {
        let is_remark = |line: &&str| line.trim_start().starts_with('#');
        let remarks =
            text.lines().filter(is_remark).map(|line| line.trim_start_matches(['#', ' ']).to_owned()).collect();
        let mut reader =
            csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
        let header = reader.headers().map_err(|error| error.to_string())?.clone();
        let end2 = if far_end == FarEnd::Position { ("u2", Dimension::Length) } else { ("F_2", Dimension::Force) };
        let wanted = [("time", Dimension::Time), ("u1", Dimension::Length), end2];
        let mut columns: [Option<Column>; 3] = [None, None, None];
        for (index, title) in header.iter().enumerate() {
            let place = wanted.iter().position(|(name, _)| title.split([' ', '[']).next() == Some(name));
            let Some(place) = place else {
                let names = wanted.map(|(name, _)| name).join(", ");
                return Err(format!(
                    "column {} is {title:?}; allowed: {names}, each with its unit, as in \"u1 [mm]\"",
                    index + 1
                ));
            };
            if columns[place].is_some() {
                return Err(format!("column {} is {:?} again; give it once", index + 1, wanted[place].0));
            }
            columns[place] = Some(Column::of(index, title, wanted[place].1)?);
        }
        let [Some(time), first, second] = columns else {
            return Err("the column \"time [s]\" is missing".to_owned());
        };
        if first.is_none() && second.is_none() {
            return Err(format!("neither a column \"u1\" nor \"{}\" is there: one end must be driven", end2.0));
        }
        Self::rows(&mut reader, &time, [first, second], remarks)
    }

    fn rows(
        reader: &mut csv::Reader<&[u8]>,
        time: &Column,
        ends: [Option<Column>; 2],
        remarks: Vec<String>,
    ) -> Result<Self, String> {
        let mut times = Vec::new();
        let mut values: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
        for row in reader.records() {
            let row = row.map_err(|error| of_row(&error))?;
            let (now, line) = (time.value(&row)?, row.position().map_or(0, csv::Position::line));
            if let Some(before) = times.last().filter(|before| now <= **before) {
                return Err(format!("line {line}: time must be above the {before} s before it, got {now} s"));
            }
            times.push(now);
            for (column, values) in ends.iter().zip(&mut values) {
                if let Some(column) = column {
                    values.push(column.value(&row)?);
                }
            }
        }
        let last = times.last().copied().ok_or("no samples are below its header")?;
        if times.len() < 2 {
            return Err("a single sample is below its header; at least two are needed".to_owned());
        }
        if times.first().is_some_and(|first| *first < 0.0) {
            return Err(format!("time starts at {} s; it must not be below zero", times[0]));
        }
        let [first, second] = values;
        let at = |values: &[f64], index: usize| values.get(index).copied().unwrap_or(0.0);
        let shortest = (0..times.len()).map(|index| at(&second, index) - at(&first, index)).fold(0.0, f64::min);
        let input = |values: Vec<f64>| match values.is_empty() {
            true => Ok(EndInput::Held),
            false => Sampled::new(times.clone(), values).map(EndInput::Sampled).map_err(|error| error.to_string()),
        };
        Ok(Self { inputs: [input(first)?, input(second)?], remarks, last, shortest })
    }
}

/// Largest value in SI units, as the science takes it.
const LARGEST: f64 = 1e9;

/// What is wrong with a row, without the reader's own words.
fn of_row(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, csv::Position::line);
            format!("line {line}: it has {len} columns where the header has {expected_len}")
        }
        _ => error.to_string(),
    }
}

impl Column {
    /// A column `name [unit]`.
    fn of(index: usize, title: &str, dimension: Dimension) -> Result<Self, String> {
        let factor = heading::unit(title).and_then(|unit| heading::scale(unit, dimension));
        let wrong = || format!("column {}, {title:?}: its unit must be that of {}", index + 1, dimension.expectation());
        Ok(Self { index, factor: factor.ok_or_else(wrong)? })
    }

    fn value(&self, row: &csv::StringRecord) -> Result<f64, String> {
        let text = row.get(self.index).unwrap_or_default();
        let line = row.position().map_or(0, csv::Position::line);
        match text.parse::<f64>().map(|value| value * self.factor) {
            Ok(value) if value.abs() <= LARGEST => Ok(value),
            _ => Err(format!(
                "line {line}, column {}: {text:?} must be a number, in SI units up to {LARGEST:e} either way",
                self.index + 1
            )),
        }
    }
}
