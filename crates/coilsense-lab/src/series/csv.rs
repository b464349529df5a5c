//! Series as CSV.
//!
//! Next door: the other formats (`json`, `parquet`).

use std::fmt::Write as _;
use std::io;

use super::{Run, text_cell};

/// A header and one row per sample; with `condition` and `damping` in front where there are several runs.
pub(super) fn write(runs: &[Run<'_>], out: &mut impl io::Write) -> io::Result<()> {
    let Some(first) = runs.first() else { return Ok(()) };
    let several = runs.len() > 1;
    let mut writer = ::csv::Writer::from_writer(&mut *out);
    let labels: &[&str] = if several { &["condition", "damping"] } else { &[] };
    let titles = first.columns.iter().map(|column| text_cell(&column.title()).into_owned());
    writer.write_record(labels.iter().map(|label| (*label).to_owned()).chain(titles))?;
    let mut field = String::new();
    for run in runs {
        for sample in 0..run.samples() {
            if several {
                writer.write_field(text_cell(&run.condition).as_bytes())?;
                writer.write_field(text_cell(&run.damping).as_bytes())?;
            }
            for column in &run.columns {
                field.clear();
                // Writing to a String cannot fail.
                let _ = write!(field, "{}", column.values[sample]);
                writer.write_field(&field)?;
            }
            writer.write_record(None::<&[u8]>)?;
        }
    }
    writer.flush()
}
