//! `coilsense pareto`.

use std::path::{Component, Path};

use anyhow::bail;
use coilsense_lab::output::Output;
use coilsense_lab::pareto::{Question, Study};
use coilsense_lab::report::verbs::{DATASET, MAXIMIZE, MINIMIZE, SPEC_ROW, WHERE};
use coilsense_lab::report::{add_pareto, pareto_json, pareto_text};
use coilsense_lab::request::{Given, JSON, OUT};
use coilsense_lab::sweep::Dataset;

use crate::{date, files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let [minimize, maximize, conditions] = [&MINIMIZE, &MAXIMIZE, &WHERE].map(|row| given.texts(row));
    if minimize.is_empty() && maximize.is_empty() {
        bail!("say what is wanted: --minimize COLUMN or --maximize COLUMN");
    }
    let dataset = Dataset::open(given.needed(&DATASET)?)?;
    let question = Question::new(dataset.plan(), &minimize, &maximize, &conditions)?;
    let mut output = files::asked(given)?;
    let study = Study::of(&dataset, question)?;
    let mut text = if given.holds(&JSON) { pareto_json(&study)? } else { pareto_text(&study) };
    let mut specs = Vec::new();
    if let Some(output) = &mut output {
        let date = date::or_today(given);
        add_pareto(&study, &dataset, &date, output)?;
        specs = add_specs(&given.texts(&SPEC_ROW), &study, &dataset, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    if let (Some(files), Some(folder), false) = (files, given.file(&OUT), given.holds(&JSON)) {
        text.push_str(&terminal::where_to_look(given, files, folder, None));
        for spec in specs {
            text.push_str(&format!("coilsense analyze {}\n", folder.join(spec).display()));
        }
    }
    Ok(terminal::answer(given, &text)?)
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
