//! What may be mended in a log, on the command line.
//!
//! Next door: the log itself (`log`), an experiment of many logs (`experiment`).

use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::Repairs;

/// Heading of these options in the help.
pub const REPAIRS: &str = "What may be cleaned up (by default nothing)";

/// Options that say what may be mended in the rows of a log.
#[derive(clap::Args)]
pub struct RepairArguments {
    /// Leave out rows that lack a value or cannot be read
    #[arg(long, help_heading = REPAIRS)]
    drop_incomplete: bool,
    /// Put rows into the order of their times
    #[arg(long, help_heading = REPAIRS)]
    sort: bool,
    /// Take the mean of rows that have the same time
    #[arg(long, help_heading = REPAIRS)]
    merge_repeated: bool,
    /// Fill gaps and missing values up to this length along straight lines, such as "10 ms"
    #[arg(long, value_name = "TIME", value_parser = positive_time, allow_hyphen_values = true, help_heading = REPAIRS)]
    fill_gaps: Option<f64>,
    /// Bring all channels to this rate along straight lines, such as "2.5 kHz"
    #[arg(long, value_name = "RATE", value_parser = frequency, allow_hyphen_values = true, help_heading = REPAIRS)]
    resample: Option<f64>,
}

impl RepairArguments {
    /// The same for the reader, without a window of time.
    pub fn repairs(&self) -> Repairs {
        Repairs {
            drop_incomplete: self.drop_incomplete,
            sort: self.sort,
            merge_repeated: self.merge_repeated,
            fill_gaps: self.fill_gaps,
            resample: self.resample,
            ..Repairs::default()
        }
    }
}

/// Any time \[s\].
pub fn time(text: &str) -> Result<f64, String> {
    let parsed = Dimension::Time.parse(text).filter(|time| time.is_finite());
    parsed.ok_or_else(|| format!("must be {}, as in \"10 ms\"", Dimension::Time.expectation()))
}

/// A time above zero \[s\].
fn positive_time(text: &str) -> Result<f64, String> {
    time(text).and_then(|time| if time > 0.0 { Ok(time) } else { Err("must be above zero".to_owned()) })
}

/// A frequency that instruments have \[Hz\].
pub fn frequency(text: &str) -> Result<f64, String> {
    let parsed = Dimension::Frequency.parse(text);
    let rate = parsed.ok_or_else(|| format!("must be {}, as in \"2.5 kHz\"", Dimension::Frequency.expectation()))?;
    if (1e-9..=1e9).contains(&rate) { Ok(rate) } else { Err("must be from 1e-9 to 1e9 Hz".to_owned()) }
}
