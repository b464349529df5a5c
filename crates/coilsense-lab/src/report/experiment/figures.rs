//! The figures of an experiment: raw forces (Fig. 5 of the paper), deviations and means over frequency (Fig. 6), means as they followed.
//!
//! Next door: those of means and deviations (`means`), how figures are drawn (`coilsense_figure`).

use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, Panel, Stroke};

use super::means;
use super::style::{WIDTH, marked};
use crate::experiment::{Experiment, Findings, Run};
use crate::quantity::digits;

/// Names of all figures that there may be.
pub(super) const NAMES: [&str; 3] = ["figure-5", "figure-6", "means-in-order"];

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
        add(NAMES[1], caption.to_owned(), means::over_frequency(experiment));
    }
    let caption = "The same means in the order in which the runs were recorded: a spring that relaxes, or an instrument that drifts, shows here as a \
                   slope. Bars: standard errors over blocks of whole periods.";
    add(NAMES[2], caption.to_owned(), means::in_order(experiment));
    figures
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
