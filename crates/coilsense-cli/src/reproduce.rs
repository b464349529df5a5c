//! `coilsense reproduce`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use clap::ValueEnum;
use coilsense_lab::analysis::AnalysisError;
use coilsense_lab::output::Output;
use coilsense_lab::report::{add_reproduction, reproduction_json, reproduction_text};
use coilsense_lab::reproduce::{PaperSprings, Protocol, reproduce};

use crate::progress::Watch;

/// Options of `coilsense reproduce`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder for report.html, tables.json, figures/ and signals/; its other files are left alone
    #[arg(long, value_name = "DIR", default_value = "out/paper")]
    out: PathBuf,
    /// How to read the paper: by its literal words, by what makes its printed tables come out, or both
    #[arg(long, value_enum, default_value_t = Reading::Both)]
    protocol: Reading,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Folder with S_T.toml and S_A.toml to use in place of the built-in springs of Table I
    #[arg(long, value_name = "DIR")]
    springs: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Reading {
    Text,
    Tables,
    Both,
}

impl Reading {
    fn protocols(self) -> &'static [Protocol] {
        match self {
            Self::Text => &[Protocol::Text],
            Self::Tables => &[Protocol::Tables],
            Self::Both => &Protocol::ALL,
        }
    }
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let begun = Instant::now();
    let springs = match &arguments.springs {
        Some(folder) => PaperSprings::read(folder)?,
        None => PaperSprings::built_in()?,
    };
    let watch = Watch::begin("reproducing")?;
    let mut output = Output::begin(&arguments.out)?;
    let reproduction = reproduce(springs, arguments.protocol.protocols())?;
    add_reproduction(&reproduction, &mut output)?;
    if watch.is_stopped() {
        return Err(AnalysisError::Interrupted.into());
    }
    let text = if arguments.json { reproduction_json(&reproduction)? } else { reproduction_text(&reproduction) };
    let files = output.commit()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early (`| head`) has all it wants: the files are written.
    let _ = write!(out, "{text}");
    if arguments.json {
        return Ok(());
    }
    let _ = writeln!(
        out,
        "\n{files} files in {} in {:.2} s; open {}",
        arguments.out.display(),
        begun.elapsed().as_secs_f64(),
        arguments.out.join("report.html").display()
    );
    Ok(())
}
