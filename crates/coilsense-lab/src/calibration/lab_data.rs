//! The preset `lab-data`: files as the rig of the measured runs wrote them.
//!
//! Semicolons, no header, a row per position: step, two settings, displacement \[mm\], ten pairs of resistance \[Ω\] and inductance \[H\].
//! As their authors do, the first row (zero displacement) is left out and L is the mean of the ten. Next door: other logs.

use std::path::Path;

use super::{CalibrationError, Measured};

/// Fields of a row.
const FIELDS: usize = 24;
/// Where the displacement stands, from zero.
const DISPLACEMENT: usize = 3;
/// Where the first inductance stands; each second field after it is another.
const INDUCTANCE: usize = 5;
/// Readings per position.
const READINGS: usize = 10;
/// More rows than this are not a calibration.
const MOST_ROWS: usize = 1_000_000;

/// Reads such a file.
///
/// - `zero_length`: length of the coil at zero displacement \[m\]
///
/// # Errors
/// [`CalibrationError`] with file, row and column for what cannot be read, is no number, or is not finite; and where fewer than two rows are
/// left.
pub fn read_lab_data(path: &Path, zero_length: f64) -> Result<Measured, CalibrationError> {
    let file = path.display().to_string();
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(b';')
        .has_headers(false)
        .trim(csv::Trim::All)
        .flexible(true)
        .from_path(path)
        .map_err(|error| CalibrationError::of(&file, reason(&error)))?;
    let (mut lengths, mut inductances, mut standard_errors) = (Vec::new(), Vec::new(), Vec::new());
    let mut rows = Vec::new();
    for (index, record) in reader.records().enumerate() {
        // As an editor counts them: a blank line is one, too.
        let line = |record: &csv::StringRecord| record.position().map_or(index + 1, |place| place.line() as usize);
        let row = record.as_ref().map_or(index + 1, line);
        let refuse = |message: String| CalibrationError::of(&file, format!("row {row}: {message}"));
        let record = record.map_err(|error| refuse(reason(&error)))?;
        if record.len() != FIELDS {
            return Err(refuse(format!("must hold {FIELDS} values between semicolons, got {}", record.len())));
        }
        if index >= MOST_ROWS {
            return Err(refuse(format!("a calibration has at most {MOST_ROWS} rows")));
        }
        let values = numbers(&record).map_err(refuse)?;
        // Zero displacement: windings may still touch there.
        if index > 0 {
            rows.push(row);
            let (mean, standard_error) = mean(values.iter().skip(INDUCTANCE).step_by(2));
            lengths.push(zero_length + 1e-3 * values[DISPLACEMENT]);
            inductances.push(mean);
            standard_errors.push(standard_error);
        }
    }
    let points = Measured::pairs(&file, &lengths, &inductances)?;
    let account = vec![
        "Row 1, at zero displacement, is left out, as the runs' authors do.".to_owned(),
        format!("L is the mean of a row's {READINGS} readings; its resistances are not used."),
    ];
    Ok(Measured { file, points, standard_errors, rows, zero_length: Some(zero_length), account, simulated: false })
}

/// The numbers of a row.
fn numbers(record: &csv::StringRecord) -> Result<Vec<f64>, String> {
    let number = |(index, text): (usize, &str)| {
        let value = text.parse::<f64>().ok().filter(|value| value.is_finite());
        value.ok_or_else(|| format!("column {}: must be a number, got {text:?}", index + 1))
    };
    record.iter().enumerate().map(number).collect()
}

/// Mean and its standard error, σ/√n.
fn mean<'a>(values: impl Iterator<Item = &'a f64> + Clone) -> (f64, f64) {
    let count = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / count;
    let squares: f64 = values.map(|value| (value - mean) * (value - mean)).sum();
    (mean, (squares / (count - 1.0) / count).sqrt())
}

/// What the reader of CSV says, without the place, which is named already.
fn reason(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::Io(error) => format!("cannot be read: {}", error.kind()),
        csv::ErrorKind::Utf8 { .. } => "is not text in UTF-8".to_owned(),
        _ => error.to_string(),
    }
}
