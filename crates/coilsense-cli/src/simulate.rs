//! `coilsense simulate`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, bail};
use coilsense_lab::analysis::{AnalysisError, Case, Together, simulate, warnings_of_simulated};
use coilsense_lab::report::verbs::ONE_FILE;
use coilsense_lab::report::{SimulationOutcome, to_json};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::series::{self, Format, Run};
use coilsense_lab::spec::Spec;

use crate::progress::Watch;
use crate::{files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let (begun, out) = (Instant::now(), given.needed(&OUT)?);
    let (folder, stem, ending) = parts(out)?;
    let known = Format::ALL.iter().map(|(ending, _)| *ending).collect::<Vec<_>>().join(", ");
    let wrong = || format!("{}: must end in one of {known}", out.display());
    let format = Format::of_ending(&ending).with_context(wrong)?;
    let spec = Spec::read(given.needed(&SPEC)?)?;
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("simulating")?;
    let mut output = files::folder(given, &folder)?;
    let apart = format == Format::Csv && spec.conditions.len() * spec.mount.cases.len() > 1 && !given.holds(&ONE_FILE);
    if !apart {
        output.check(&format!("{stem}.{ending}"))?;
    }
    let progress = |done, of| watch.tell(done, of);
    let (cases, together) = match spec.beside.is_empty() {
        true => (simulate(&spec, &progress)?, None),
        false => (Vec::new(), Some(Together::of(&spec, &progress)?)),
    };
    let runs: Vec<Run<'_>> = match &together {
        Some(together) => (0..together.all.len()).map(|number| together.series(number)).collect(),
        None => cases.iter().map(|case| case.series(&spec, &spec.sensors)).collect(),
    };
    if apart {
        let cases = together.as_ref().map_or(&cases, |together| &together.springs[0].cases);
        for (case, run) in cases.iter().zip(&runs) {
            let damping = &spec.mount.cases[case.damping].stem;
            let condition = spec.conditions[case.condition].stem();
            let name = format!("{stem}-{condition}-{damping}.{ending}");
            output.write(&name, |file| series::write(std::slice::from_ref(run), format, file))?;
        }
    } else {
        output.write(&format!("{stem}.{ending}"), |file| series::write(&runs, format, file))?;
    }
    let warnings = warnings(&spec, &cases, together.as_ref())?;
    watch.end();
    if watch.is_stopped() {
        return Err(AnalysisError::Interrupted.into());
    }
    let names = output.files().iter().map(|file| file.display().to_string()).collect();
    let files = output.commit()?;
    let samples: usize = runs.iter().map(Run::samples).sum();
    warnings.iter().for_each(terminal::warn);
    if given.holds(&JSON) {
        let (spec_file, runs) = (spec.file.as_str(), runs.len());
        let text = to_json(SimulationOutcome { spec_file, files: names, runs, samples, warnings })?;
        return Ok(terminal::answer(given, &text)?);
    }
    let plural = if files == 1 { "file" } else { "files" };
    let text = format!(
        "{samples} samples of {} run{} in {files} {plural} in {} in {:.2} s\n",
        runs.len(),
        if runs.len() == 1 { "" } else { "s" },
        folder.display(),
        begun.elapsed().as_secs_f64()
    );
    Ok(terminal::say(&text)?)
}

/// What a reader of the series must know; of several springs, with each one's name.
fn warnings(spec: &Spec, cases: &[Case], together: Option<&Together>) -> Result<Vec<String>, coilsense::Error> {
    let mut all: Vec<String> = spec.spring.magnetisation_left_out().into_iter().collect();
    let Some(together) = together else {
        all.extend(warnings_of_simulated(spec, cases)?.into_iter().map(|warning| warning.text));
        return Ok(all);
    };
    for strand in &together.springs {
        let of_spring = warnings_of_simulated(&strand.spec, &strand.cases)?.into_iter();
        all.extend(of_spring.map(|warning| format!("{}: {}", strand.spec.spring.name, warning.text)));
    }
    Ok(all)
}

/// Folder, stem and ending of a file's path.
fn parts(path: &Path) -> anyhow::Result<(PathBuf, String, String)> {
    let text = |part: Option<&std::ffi::OsStr>| part.and_then(std::ffi::OsStr::to_str).map(str::to_owned);
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match (text(path.file_stem()), text(path.extension())) {
        (Some(stem), ending) => Ok((folder.to_owned(), stem, ending.unwrap_or_default())),
        _ => bail!("{}: is no name of a file", path.display()),
    }
}
