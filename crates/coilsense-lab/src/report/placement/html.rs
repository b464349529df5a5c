//! `report.html` of a placement: one page that needs no other file and no network; the answer first.
//!
//! Next door: its layout (`page.html`), its figures (`figures`).

use minijinja::{Value, context};

use super::text::significant;
use super::{bounded, figures, robust};
use crate::placement::{BESIDE, LoopRun, MOST_PEAK, Placement, answered, drive_words};
use crate::quantity::digits;
use crate::report::ReportError;
use crate::report::page::{self, drawn};

/// The page of a placement.
pub(super) fn page(placement: &Placement, date: &str) -> Result<String, ReportError> {
    let traces = figures::Traces::of(placement)?;
    let [answer, rest] = answered(placement);
    let step = figures::step(placement).map(|figure| drawn("step", &figure)).transpose()?;
    let steps = figures::steps(placement).map(|figure| drawn("steps", &figure)).transpose()?;
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            spring => &placement.spec.spring.name,
            file => std::path::Path::new(&placement.spec.file).file_name().map(|name| name.to_string_lossy()),
            text => &placement.spec.text,
            answer,
            rest,
            rows => rows(placement),
            tolerance => format!("{:.0}", 100.0 * crate::placement::TOLERANCE),
            estimates => placement.estimates.iter().map(|estimate| context! {
                name => estimate.name,
                stable_to => bounded(estimate.stable_crossover, digits),
                robust_to => robust([estimate.robust_from, estimate.robust_crossover], digits),
            }).collect::<Vec<_>>(),
            most_peak => MOST_PEAK,
            shown => &placement.dampings[placement.shown()].label,
            crossover => digits(placement.crossover),
            gain => significant(placement.gain),
            unit => placement.control.drive.command_unit(),
            sampled => placement.control.sample_time.map(|step| digits(1.0 / step)),
            bode => drawn("bode", &figures::bode(placement, &traces))?,
            tracking => figures::tracking(placement)?.map(|figure| drawn("tracking", &figure)).transpose()?,
            nyquist => drawn("nyquist", &figures::nyquist(&traces))?,
            step,
            steps,
            drive => drive_words(&placement.control.drive),
            runs => placement.runs.iter().map(run_row).collect::<Vec<_>>(),
            beside => [1.0 - BESIDE, 1.0 + BESIDE],
            rendered => drawn("rendered", &figures::rendered(placement)?)?,
        },
    )?)
}

fn run_row(run: &LoopRun) -> Value {
    let none = || "–".to_owned();
    let percent = |value: f64| digits(100.0 * value);
    context! {
        fed_back => run.fed_back,
        damping => run.case(),
        off => !run.stable,
        state => run.state(),
        place => run.last.filter(|_| run.stable).map_or_else(none, |[place, _]| percent(place)),
        swing => run.last.map_or_else(none, |[_, swing]| percent(swing)),
        command => run.shown.as_ref().map_or_else(|_| none(), |_| digits(run.largest_command)),
        verdict => run.verdict.words(),
    }
}

fn rows(placement: &Placement) -> Vec<Value> {
    let of_candidate = |candidate: &crate::placement::Candidate| {
        let name = candidate.channel.name();
        let each = candidate.judged.iter().zip(&placement.dampings).enumerate();
        each.map(|(index, (judged, damping))| {
            let margins = &judged.margins;
            let when = |holds: bool, text: String| if holds { text } else { "–".to_owned() };
            context! {
                first => index == 0,
                name,
                damping => &damping.label,
                stable_to => bounded(judged.stable_crossover, digits),
                robust_to => robust([judged.robust_from, judged.robust_crossover], digits),
                rings => when(judged.oscillates_at > 0.0, digits(judged.oscillates_at)),
                is_stable => margins.stable,
                phase => when(margins.stable && margins.phase.is_finite(), format!("{:.0}", margins.phase.to_degrees())),
                delay => when(margins.stable && margins.delay.is_finite(), digits(1e3 * margins.delay)),
                sensitivity => when(margins.stable, digits(1.0 / margins.modulus)),
                quiet => when(candidate.calm_crossover > 0.0, digits(candidate.calm_crossover)),
                drive_peak => judged.peaks.map_or_else(|| "–".to_owned(), |[drive, _]| format!("{} at {}", digits(drive.size), digits(drive.at))),
                peak => judged.peaks.map_or_else(|| "–".to_owned(), |[_, load]| format!("{} at {}", digits(load.size), digits(load.at))),
                passive => judged.passivity.as_ref().filter(|_| margins.stable).map(|passivity| {
                    passivity.active.first().map_or_else(|| format!("≥ {}", digits(passivity.up_to)), |band| digits(band[0]))
                }),
            }
        })
        .collect::<Vec<_>>()
    };
    placement.candidates.iter().flat_map(of_candidate).collect()
}
