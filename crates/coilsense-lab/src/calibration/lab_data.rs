//! The preset `lab-data`: files as the rig of the measured runs wrote them.
//!
//! Semicolons, no header, a row per position: step, two settings, displacement \[mm\], ten pairs of resistance \[Ω\] and inductance \[H\].
//! As their authors do, the first row (zero displacement) is left out and L is the mean of the ten; how these scatter is kept, which is why
//! the columns are read here one by one. Next door: logs of any layout (`log`).

use std::path::Path;

use super::{CalibrationError, Measured, Unused};
use crate::recording::{Format, Handed, Mapping, Table};

/// Columns of such a file.
const COLUMNS: usize = 24;
/// Where the displacement stands, from 1.
const DISPLACEMENT: usize = 4;
/// Where the first inductance stands; each second column after it is another.
const INDUCTANCE: usize = 6;
/// Where the first resistance stands; likewise.
const RESISTANCE: usize = 5;

/// Reads such a file.
///
/// - `zero_length`: length of the coil at zero displacement \[m\]
///
/// # Errors
/// [`CalibrationError`] with file, line and column for what cannot be read, is no number, or is not finite; and where fewer than two rows are
/// left.
pub fn read_lab_data(path: &Path, zero_length: f64) -> Result<Measured, CalibrationError> {
    let table = Table::read(path, &format()?).map_err(CalibrationError::new)?;
    of_table(path.display().to_string(), &table, zero_length)
}

/// The same of such a file that is handed over.
///
/// # Errors
/// As [`read_lab_data`].
pub fn lab_data_of(log: Handed, zero_length: f64) -> Result<Measured, CalibrationError> {
    let table = Table::of_handed(log, &format()?).map_err(CalibrationError::new)?;
    of_table(table.file().display().to_string(), &table, zero_length)
}

fn format() -> Result<Format, CalibrationError> {
    Mapping::preset("lab-data").map(|mapping| mapping.format).map_err(CalibrationError::new)
}

fn of_table(file: String, table: &Table, zero_length: f64) -> Result<Measured, CalibrationError> {
    if table.titles().len() != COLUMNS {
        let message = format!("must hold {COLUMNS} columns between semicolons, got {}", table.titles().len());
        return Err(CalibrationError::of(&file, message));
    }
    // All columns, so that a value which is no number is seen even where it is not used.
    let columns: Vec<&[f64]> = (1..=COLUMNS)
        .map(|number| table.column(&format!("#{number}")))
        .collect::<Result<_, _>>()
        .map_err(CalibrationError::new)?;
    let left_out = usize::try_from(format()?.skip).unwrap_or(usize::MAX);
    let (mut lengths, mut inductances, mut standard_errors) = (Vec::new(), Vec::new(), Vec::new());
    let (mut resistances, mut unused) = (Vec::new(), Vec::new());
    for (row, line) in table.lines().iter().enumerate() {
        let values: Vec<f64> = columns.iter().map(|column| column[row]).collect();
        if let Some(column) = values.iter().position(|value| !value.is_finite()) {
            return Err(CalibrationError::of(&file, format!("row {line}: column {}: must be a number", column + 1)));
        }
        // Seen, but not used: at zero displacement windings may still touch.
        let length = zero_length + 1e-3 * values[DISPLACEMENT - 1];
        let (resistance, _) = mean(values.iter().skip(RESISTANCE - 1).step_by(2));
        if row < left_out {
            unused.push(Unused { row: *line as usize, length, resistance: Some(resistance) });
            continue;
        }
        let (mean, standard_error) = mean(values.iter().skip(INDUCTANCE - 1).step_by(2));
        lengths.push(length);
        resistances.push(resistance);
        inductances.push(mean);
        standard_errors.push(standard_error);
    }
    let points = Measured::pairs(&file, &lengths, &inductances)?;
    let account = vec![
        "The first row, at zero displacement, is left out, as the runs' authors do.".to_owned(),
        "L and R are the means of a row's ten readings.".to_owned(),
        "Two theories differ from what the runs' authors print, and why is known: their Rosa takes K = π/2 in Nagaoka's coefficient, a loop that \
         never runs (0.4 to 1 % of L); their Neumann helix runs beside a second filament, which is nearer to the turns on one side (3 % of L)."
            .to_owned(),
    ];
    let rows = table.lines().iter().skip(left_out).map(|&line| line as usize).collect();
    Ok(Measured {
        file,
        points,
        standard_errors,
        resistances,
        unused,
        rows,
        zero_length: Some(zero_length),
        account,
        simulated: false,
    })
}

/// Mean and its standard error, σ/√n.
fn mean<'a>(values: impl Iterator<Item = &'a f64> + Clone) -> (f64, f64) {
    let count = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / count;
    let squares: f64 = values.map(|value| (value - mean) * (value - mean)).sum();
    (mean, (squares / (count - 1.0) / count).sqrt())
}
