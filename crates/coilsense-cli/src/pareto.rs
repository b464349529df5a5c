//! `coilsense pareto`.

use std::io::Write;
use std::path::{Component, Path, PathBuf};

use anyhow::bail;
use coilsense_lab::output::Output;
use coilsense_lab::pareto::{Question, Study};
use coilsense_lab::report::{add_pareto, pareto_json, pareto_text};
use coilsense_lab::sweep::Dataset;

use crate::date;

/// Options of `coilsense pareto`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder of a sweep, as `coilsense sweep --out` makes it
    #[arg(value_name = "DIR")]
    sweep: PathBuf,
    /// Column of which little is wanted, such as F_o.rmsd or mass; may be given several times
    #[arg(long, value_name = "COLUMN")]
    minimize: Vec<String>,
    /// Column of which much is wanted, such as f1
    #[arg(long, value_name = "COLUMN")]
    maximize: Vec<String>,
    /// What a design has to meet, such as 'mass < 100 g' or 'F_o.rmsd <= 2'; may be given several times
    #[arg(long = "where", value_name = "CONDITION")]
    conditions: Vec<String>,
    /// Folder for report.html, pareto.csv, pareto.parquet, results.json and the figure; its other files are left alone
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write the spec of a row, or of the knee, into the folder of --out, for `coilsense analyze`; may be given several times
    #[arg(long, value_name = "ROW|knee", requires = "out")]
    spec_row: Vec<String>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Date that the report carries, such as 2026-11-21; without it, today's
    #[arg(long, value_name = "DATE", requires = "out", value_parser = date::parse)]
    date: Option<String>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    if arguments.minimize.is_empty() && arguments.maximize.is_empty() {
        bail!("say what is wanted: --minimize COLUMN or --maximize COLUMN");
    }
    let dataset = Dataset::open(&arguments.sweep)?;
    let question = Question::new(dataset.plan(), &arguments.minimize, &arguments.maximize, &arguments.conditions)?;
    let mut output = arguments.out.as_deref().map(Output::begin).transpose()?;
    let study = Study::of(&dataset, question)?;
    let text = if arguments.json { pareto_json(&study)? } else { pareto_text(&study) };
    let mut specs = Vec::new();
    if let Some(output) = &mut output {
        let date = date::or_today(arguments.date.as_ref());
        add_pareto(&study, &dataset, &date, output)?;
        specs = add_specs(&arguments.spec_row, &study, &dataset, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants.
    let _ = write!(out, "{text}");
    if let (Some(files), Some(folder), false) = (files, &arguments.out, arguments.json) {
        let _ = writeln!(out, "\n{files} files in {}; open {}", folder.display(), folder.join("report.html").display());
        for spec in specs {
            let _ = writeln!(out, "coilsense analyze {}", folder.join(spec).display());
        }
    }
    Ok(())
}

/// Adds the specs of rows and the files that they name; gives the specs' names.
fn add_specs(rows: &[String], study: &Study, dataset: &Dataset, output: &mut Output) -> anyhow::Result<Vec<String>> {
    let plan = dataset.plan();
    let mut names = Vec::new();
    for row in rows {
        let row = match row.trim() {
            "knee" => study.rows[study.knee],
            number => match number.parse() {
                Ok(number) => number,
                Err(_) => bail!("--spec-row {number}: must be a row's number, counted from 0, or knee"),
            },
        };
        let name = format!("row-{row}.toml");
        output.add(&name, plan.spec_of(row)?.as_bytes())?;
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let files = plan.parameters().files.iter().filter(|_| !names.is_empty());
    for (name, text) in files {
        if Path::new(name).components().all(|part| matches!(part, Component::Normal(_))) {
            output.add(name, text.as_bytes())?;
        } else {
            bail!(
                "{name}, which the spec names, does not lie beside it: copy it to where its rows' specs are to be, and name it so"
            );
        }
    }
    Ok(names)
}
