//! A log on the command line: which file, which column is what. Shared by all commands that read one.
//!
//! Next door: what may be mended (`repairs`), what is done with it (`import`).

use std::path::PathBuf;

use coilsense_lab::recording::{Clock, Mapping, Points, Recording, RecordingError, Repairs};

use crate::repairs::{REPAIRS, RepairArguments, frequency, time};

/// Options of every command that reads a log.
#[derive(clap::Args)]
pub struct LogArguments {
    /// The log: a text with columns (CSV and the like)
    #[arg(value_name = "LOG")]
    pub log: PathBuf,
    /// Which column is which channel (time, u1, u2, F_i, F_o, F_x, F_L, L), by its title or, as in #3, its number; columns that carry a
    /// channel's name need none
    #[arg(long = "column", value_name = "NAME=\"TITLE [UNIT]\"", help_heading = LAYOUT)]
    columns: Vec<String>,
    /// The same, and how the text is written, as a TOML file: see book/src/guide/logs.md
    #[arg(long, value_name = "FILE", conflicts_with = "preset", help_heading = LAYOUT)]
    mapping: Option<PathBuf>,
    /// A known layout: lab-data
    #[arg(long, value_name = "NAME", help_heading = LAYOUT)]
    preset: Option<String>,
    /// How often a log without a time column was sampled, such as "2.5 kHz"
    #[arg(long, value_name = "RATE", value_parser = frequency, allow_hyphen_values = true, help_heading = LAYOUT)]
    sample_rate: Option<f64>,
    #[command(flatten)]
    repairs: RepairArguments,
    /// Leave out what is before this time, such as "2 s"
    #[arg(long, value_name = "TIME", value_parser = time, allow_hyphen_values = true, help_heading = REPAIRS)]
    from: Option<f64>,
    /// Leave out what is after this time
    #[arg(long, value_name = "TIME", value_parser = time, allow_hyphen_values = true, help_heading = REPAIRS)]
    to: Option<f64>,
    /// A second device's log, whose channels are added to the first's rows
    #[arg(long, value_name = "LOG", help_heading = SECOND)]
    with: Option<PathBuf>,
    /// Which of its columns is which channel
    #[arg(long = "with-column", value_name = "NAME=\"TITLE [UNIT]\"", requires = "with", help_heading = SECOND)]
    with_columns: Vec<String>,
    /// The same as a TOML file
    #[arg(long, value_name = "FILE", requires = "with", help_heading = SECOND)]
    with_mapping: Option<PathBuf>,
    /// What to add to its times, such as "-0.2 s"; or auto, by a channel that both have; or two channels that saw the same motion, as in
    /// F_o=F_x
    #[arg(long, value_name = "OFFSET|auto|A=B", value_parser = Clock::parse, requires = "with", default_value = "auto", allow_hyphen_values = true, help_heading = SECOND)]
    clock: Clock,
}

const SECOND: &str = "A second device";
const LAYOUT: &str = "What is in the log";

impl LogArguments {
    /// The log over time.
    pub fn recording(&self) -> Result<Recording, RecordingError> {
        let recording = Recording::read(&self.log, &self.mapping()?, &self.repairs())?;
        let Some(with) = &self.with else { return Ok(recording) };
        let mut mapping = self.with_mapping.as_deref().map_or(Ok(Mapping::default()), Mapping::read)?;
        self.with_columns.iter().try_for_each(|column| mapping.set(column))?;
        // The window is one of the first device's clock.
        let repairs = Repairs { from: None, to: None, ..self.repairs() };
        recording.joined(&Recording::read(with, &mapping, &repairs)?, self.clock)
    }

    /// Whether there is a second device.
    pub fn has_second(&self) -> bool {
        self.with.is_some()
    }

    /// The log row by row, without a clock.
    pub fn points(&self) -> Result<Points, RecordingError> {
        Points::read(&self.log, &self.mapping()?, &self.repairs())
    }

    /// The known layout that is asked for.
    pub fn preset(&self) -> Option<&str> {
        self.preset.as_deref()
    }

    /// Which column is which channel.
    pub fn mapping(&self) -> Result<Mapping, RecordingError> {
        let mut mapping = match (&self.preset, &self.mapping) {
            (Some(name), _) => Mapping::preset(name)?,
            (None, Some(file)) => Mapping::read(file)?,
            (None, None) => Mapping::default(),
        };
        self.columns.iter().try_for_each(|column| mapping.set(column))?;
        mapping.format.sample_rate = self.sample_rate.or(mapping.format.sample_rate);
        Ok(mapping)
    }

    /// What may be mended.
    pub fn repairs(&self) -> Repairs {
        Repairs { from: self.from, to: self.to, ..self.repairs.repairs() }
    }
}
