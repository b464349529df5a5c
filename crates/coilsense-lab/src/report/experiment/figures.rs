//! The figures of an experiment: raw forces (Fig. 5 of the paper), deviations and means over frequency (Fig. 6), means as they followed.
//!
//! Next door: how figures are drawn (`crate::plot`).

use coilsense::Channel;

use crate::experiment::{Experiment, FORCES, Findings, Run};
use crate::plot::{Axis, Colour, Curve, Dash, Figure, HorizontalMark, Marker, Panel, Points, Stroke};
use crate::quantity::digits;
use crate::spec::RunKind;

/// Names of all figures that there may be.
pub(super) const NAMES: [&str; 3] = ["figure-5", "figure-6", "means-in-order"];

/// Width of a figure \[px\].
const WIDTH: f64 = 760.0;
/// Frequencies of Fig. 5 over that at which forces part most: 4.5, 20.2 and 27.0 Hz in the paper.
const SHOWN: [f64; 3] = [2.0 / 12.0, 9.0 / 12.0, 1.0];

/// Name, caption and figure of each.
pub(super) fn all(experiment: &Experiment, findings: &Findings) -> Vec<(String, String, Figure)> {
    let said = if experiment.simulated { " Simulated data." } else { "" };
    let mut figures = Vec::new();
    let mut add =
        |name: &str, caption: String, figure| figures.push((name.to_owned(), format!("{caption}{said}"), figure));
    let shown = shown(experiment, findings);
    if !shown.is_empty() {
        let caption =
            "Raw forces at the load cell, F_o, and by the measured position, F_x, as Fig. 5 of the paper shows them.";
        add(NAMES[0], caption.to_owned(), raw(experiment, &shown));
        let caption = "Above: root mean square and largest difference of F_o and F_x over the frequency of the sine. Below: means of all three \
                       forces less the first preload's by position, with the standard errors of eq. (15); points of one frequency are \
                       set a little apart. Preloads stand at 0 Hz, first and last. As Fig. 6 of the paper.";
        add(NAMES[1], caption.to_owned(), over_frequency(experiment));
    }
    let caption = "The same means in the order in which the runs were recorded: a spring that relaxes, or an instrument that drifts, shows here as a \
                   slope. Bars: standard errors over blocks of whole periods.";
    add(NAMES[2], caption.to_owned(), in_order(experiment));
    figures
}

/// What every figure of simulated data says on its face.
fn marked(experiment: &Experiment, title: &str) -> String {
    match (experiment.simulated, title.is_empty()) {
        (false, _) => title.to_owned(),
        (true, true) => "simulated data".to_owned(),
        (true, false) => format!("{title}, simulated data"),
    }
}

/// The sines whose frequencies are nearest to those of Fig. 5, slowest first.
fn shown<'a>(experiment: &'a Experiment, findings: &Findings) -> Vec<&'a Run> {
    let Some(peak) = findings.peak else { return Vec::new() };
    let highest = experiment.runs[peak.run].spec.frequency;
    let nearest = |share: f64| {
        let distance = |run: &Run| (run.spec.frequency - share * highest).abs();
        experiment.harmonics().map(|(_, run)| run).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    let mut shown: Vec<&Run> = SHOWN.into_iter().filter_map(nearest).collect();
    shown.dedup_by(|a, b| std::ptr::eq(*a, *b));
    shown
}

fn raw(experiment: &Experiment, shown: &[&Run]) -> Figure {
    let panel = |run: &&Run| {
        let excerpt = &run.fast.excerpt;
        let curve = |label: &str, y: &[f64], colour, dash, width| Curve {
            label: label.into(),
            x: excerpt.time.clone(),
            y: y.to_vec(),
            stroke: Stroke { colour, dash, width },
        };
        Panel {
            title: marked(experiment, &format!("{} Hz", digits(run.spec.frequency))),
            x: Axis { label: "Time [s]".into(), ..Axis::default() },
            y: Axis { label: "Force [N]".into(), ..Axis::default() },
            curves: vec![
                curve("F_o", &excerpt.output, Colour::Red, Dash::Solid, 1.3),
                curve("F_x", &excerpt.deflection, Colour::Green, Dash::Dashed, 1.5),
            ],
            ..Panel::default()
        }
    };
    Figure { panels: shown.iter().map(panel).collect(), columns: 1, panel_width: WIDTH, panel_height: 190.0 }
}

/// Look of a force's points, and by how much they are set aside \[1\].
fn look(force: Channel) -> (Colour, Marker, f64) {
    match force {
        Channel::OutputForce => (Colour::Red, Marker::Disc, -1.0),
        Channel::DeflectionForce => (Colour::Green, Marker::Square, 0.0),
        _ => (Colour::Ink, Marker::Diamond, 1.0),
    }
}

/// Means of a force over some place of each run.
fn means(
    experiment: &Experiment,
    force: Channel,
    errors: bool,
    place: impl Fn(usize, &Run) -> f64,
    aside: f64,
) -> Points {
    let (colour, marker, side) = look(force);
    let points = experiment.runs.iter().enumerate().filter_map(|(index, run)| {
        let mean = run.mean(force)?;
        let error = if errors { mean.standard_error } else { mean.judged_error() };
        let y = experiment.percent(mean.mean - experiment.reference);
        Some((place(index, run) + side * aside, y, experiment.percent(error)))
    });
    let points: Vec<(f64, f64, f64)> = points.collect();
    Points {
        label: if points.is_empty() { String::new() } else { format!("mean of {}", force.name()) },
        x: points.iter().map(|point| point.0).collect(),
        y: points.iter().map(|point| point.1).collect(),
        errors: points.iter().map(|point| point.2).collect(),
        colour,
        marker,
    }
}

fn over_frequency(experiment: &Experiment) -> Figure {
    let highest = experiment.harmonics().map(|(_, run)| run.spec.frequency).fold(0.0, f64::max);
    let room = 0.04 * highest;
    let x = Axis { label: "Frequency [Hz]".into(), range: Some((-room, highest + room)), ..Axis::default() };
    let deviation = |label: &str, colour, marker, of: &dyn Fn(&Run) -> f64| Points {
        label: label.into(),
        x: experiment.harmonics().map(|(_, run)| run.spec.frequency).collect(),
        y: experiment.harmonics().map(|(_, run)| experiment.percent(of(run))).collect(),
        errors: Vec::new(),
        colour,
        marker,
    };
    let above = Panel {
        title: marked(experiment, ""),
        x: x.clone(),
        y: Axis { label: "F_o − F_x [% of F_{nom}]".into(), ..Axis::default() },
        points: vec![
            deviation("RMSD", Colour::Blue, Marker::Disc, &|run| run.fast.deviation.rmsd),
            deviation("largest difference", Colour::Blue, Marker::Diamond, &|run| run.fast.deviation.maximum_absolute),
        ],
        limits: vec![HorizontalMark { y: 0.0, label: String::new() }],
        ..Panel::default()
    };
    let frequency = |_: usize, run: &Run| run.spec.frequency;
    let below = Panel {
        x,
        y: Axis { label: "Mean force [% of F_{nom}]".into(), ..Axis::default() },
        points: FORCES.map(|force| means(experiment, force, true, frequency, 0.006 * highest)).into(),
        limits: vec![HorizontalMark { y: 0.0, label: String::new() }],
        ..Panel::default()
    };
    Figure { panels: vec![above, below], columns: 1, panel_width: WIDTH, panel_height: 270.0 }
}

fn in_order(experiment: &Experiment) -> Figure {
    let place = |index: usize, _: &Run| index as f64 + 1.0;
    let last = experiment.runs.len() as f64;
    let panel = Panel {
        title: marked(experiment, &order_title(experiment)),
        x: Axis { label: "Run, as recorded".into(), range: Some((0.5, last + 0.5)), ..Axis::default() },
        y: Axis { label: "Mean force [% of F_{nom}]".into(), ..Axis::default() },
        points: FORCES.map(|force| means(experiment, force, false, place, 0.12)).into(),
        limits: vec![HorizontalMark { y: 0.0, label: String::new() }],
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: 270.0 }
}

/// Which of the runs are preloads.
fn order_title(experiment: &Experiment) -> String {
    let preload = |(index, run): (usize, &Run)| (run.spec.kind == RunKind::Preload).then(|| (index + 1).to_string());
    let places: Vec<String> = experiment.runs.iter().enumerate().filter_map(preload).collect();
    if places.len() > 4 { String::new() } else { format!("at the preload: {}", places.join(", ")) }
}
