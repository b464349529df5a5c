//! Figures of an experiment's deviations and means.
//!
//! Next door: raw forces and captions (`figures`), the mark of simulated data (`style`).

use coilsense::Channel;
use coilsense_figure::{Axis, Colour, Figure, HorizontalMark, Marker, Panel, Points};

use super::style::{WIDTH, marked};
use crate::experiment::{Experiment, FORCES, Run};
use crate::spec::RunKind;

/// Look of a force's points, and by how much they are set aside \[1\].
fn look(force: Channel) -> (Colour, Marker, f64) {
    match force {
        Channel::OutputForce => (Colour::Red, Marker::Disc, -1.0),
        Channel::DeflectionForce => (Colour::Green, Marker::Square, 0.0),
        _ => (Colour::Ink, Marker::Diamond, 1.0),
    }
}

/// Means of a force over some place of each run.
fn of_force(
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
        ..Points::default()
    }
}

/// Fig. 6: deviations above, means below.
pub(super) fn over_frequency(experiment: &Experiment) -> Figure {
    let highest = experiment.harmonics().map(|(_, run)| run.spec.frequency).fold(0.0, f64::max);
    let room = 0.04 * highest;
    let x = Axis { label: "Frequency [Hz]".into(), range: Some((-room, highest + room)), ..Axis::default() };
    let deviation = |label: &str, colour, marker, of: &dyn Fn(&Run) -> f64| Points {
        label: label.into(),
        x: experiment.harmonics().map(|(_, run)| run.spec.frequency).collect(),
        y: experiment.harmonics().map(|(_, run)| experiment.percent(of(run))).collect(),
        colour,
        marker,
        ..Points::default()
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
        points: FORCES.map(|force| of_force(experiment, force, true, frequency, 0.006 * highest)).into(),
        limits: vec![HorizontalMark { y: 0.0, label: String::new() }],
        ..Panel::default()
    };
    Figure { panels: vec![above, below], columns: 1, panel_width: WIDTH, panel_height: 270.0 }
}

/// Means as the runs followed each other.
pub(super) fn in_order(experiment: &Experiment) -> Figure {
    let place = |index: usize, _: &Run| index as f64 + 1.0;
    let last = experiment.runs.len() as f64;
    let panel = Panel {
        title: marked(experiment, &order_title(experiment)),
        x: Axis { label: "Run, as recorded".into(), range: Some((0.5, last + 0.5)), ..Axis::default() },
        y: Axis { label: "Mean force [% of F_{nom}]".into(), ..Axis::default() },
        points: FORCES.map(|force| of_force(experiment, force, false, place, 0.12)).into(),
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
