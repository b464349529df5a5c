//! The figures of an identification: spectrum with its lines, spectrogram, a ring-down with its fit, force over length.
//!
//! Next door: how figures are drawn (`coilsense_figure`).

use coilsense::Channel;
use coilsense::identify::{Meaning, Part, RingDown, Stiffness, Welch};
use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, Mark, Panel, Points, Scale, Stroke};

use crate::identification::Identified;
use crate::report::spectrogram::spectrogram;

/// Width of a figure \[px\].
const WIDTH: f64 = 760.0;
/// Most samples of a curve and most points that are drawn.
const MOST: usize = 4000;

/// Name, caption and figure of each.
pub(super) fn all(identified: &Identified) -> Vec<(String, String, Figure)> {
    let found = &identified.found;
    let said = if identified.simulated.is_some() { " Simulated data." } else { "" };
    let mut figures = Vec::new();
    if found.spectra.iter().any(|(_, welch)| welch.density.len() > 2) {
        let caption = "Spectrum of the whole record (Welch), with the modes f_j that were found; grey lines without a name are other lines.";
        figures.push(("spectrum".to_owned(), format!("{caption}{said}"), spectrum(identified)));
    }
    if let Some((channel, figure)) = over_time(identified) {
        let caption = format!("Which frequencies {} has when; upright lines are the hits.", channel.name());
        figures.push(("spectrogram".to_owned(), format!("{caption}{said}"), figure));
    }
    if let Some(ring_down) = &found.ring_down {
        let caption = format!(
            "The strongest hit, at {:.3} s, and the lines that decay, fitted to all hits together.",
            ring_down.hit
        );
        figures.push(("ring-down".to_owned(), format!("{caption}{said}"), decay(identified, ring_down)));
    }
    if let Ok(line) = &found.stiffness {
        let caption = "Force over length, each point the mean of 0.2 s, and the line of the stiffness.";
        figures.push(("stiffness".to_owned(), format!("{caption}{said}"), stiffness(identified, line)));
    }
    figures
}

/// What every figure of simulated data says on its face.
fn title(identified: &Identified) -> String {
    if identified.simulated.is_some() { "simulated data".to_owned() } else { String::new() }
}

fn label(part: Part) -> String {
    match part {
        Part::Difference => "½(F_o − F_i)".into(),
        Part::Sum => "½(F_o + F_i), slow force taken out".into(),
        Part::Single(channel) => format!("{}, slow force taken out", channel.name()),
    }
}

/// Up to which frequency \[Hz\] there is something to see.
fn highest(identified: &Identified) -> f64 {
    let found = &identified.found;
    let nyquist = 0.5 * found.sampling.rate;
    let seen = found.lines.iter().map(|line| line.frequency.value).fold(0.0, f64::max);
    if seen > 0.0 { (1.15 * seen).min(nyquist) } else { nyquist }
}

/// The spectrogram of a force with the hits, where there are hits.
fn over_time(identified: &Identified) -> Option<(Channel, Figure)> {
    let (found, signals) = (&identified.found, &identified.signals);
    if found.hits.is_empty() {
        return None;
    }
    let forces = [Channel::OutputForce, Channel::InputForce].into_iter();
    let (channel, values) = forces.filter_map(|force| Some((force, signals.channel(force).ok()?))).next()?;
    let panel = spectrogram(signals.time(), values, found.sampling.rate, highest(identified))?;
    let marks = found.hits.iter().map(|hit| Mark { x: hit.time, label: String::new() }).collect();
    let panel = Panel { title: title(identified), marks, ..panel };
    Some((channel, Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: 280.0 }))
}

fn spectrum(identified: &Identified) -> Figure {
    let found = &identified.found;
    let modes = || found.lines.iter().filter_map(|line| Some((line.mode()?, line.frequency.value)));
    let highest = highest(identified);
    let looks = [(Colour::Red, Dash::Solid), (Colour::Blue, Dash::Dashed)];
    let mut peak = f64::MIN_POSITIVE;
    let mut bottom = f64::INFINITY;
    let mut curves = Vec::new();
    for ((part, welch), (colour, dash)) in found.spectra.iter().zip(looks) {
        let (x, y) = amplitudes(welch, highest);
        peak = y.iter().copied().fold(peak, f64::max);
        let mut sorted = y.clone();
        sorted.sort_by(f64::total_cmp);
        bottom = bottom.min(sorted.get(sorted.len() / 20).copied().unwrap_or(peak));
        curves.push(Curve { label: label(*part), x, y, stroke: Stroke { colour, dash, width: 1.2 } });
    }
    let mut marks: Vec<Mark> = modes().map(|(j, x)| Mark { x, label: format!("f_{{{j}}}") }).collect();
    marks.extend(found.lines.iter().filter(|line| line.mode().is_none()).map(|line| {
        let name = match line.meaning {
            Meaning::Alias { mode, .. } => format!("f_{{{mode}}} folded"),
            Meaning::Mains { mains, .. } => format!("{mains} Hz"),
            Meaning::Torsional { .. } => "torsional".to_owned(),
            Meaning::Lateral => "lateral".to_owned(),
            _ => String::new(),
        };
        Mark { x: line.frequency.value, label: name }
    }));
    let range = Some((0.5 * bottom.max(1e-9 * peak), 2.0 * peak));
    let panel = Panel {
        title: title(identified),
        x: Axis { label: "Frequency [Hz]".into(), range: Some((0.0, highest)), ..Axis::default() },
        y: Axis { label: "Density [N/√Hz]".into(), range, scale: Scale::Log10 },
        curves,
        marks,
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: 340.0 }
}

/// Square root of the density up to a frequency, the first lines left out; where there are many, the largest of each group.
fn amplitudes(welch: &Welch, highest: f64) -> (Vec<f64>, Vec<f64>) {
    let count = welch.density.len().min((highest / welch.spacing) as usize + 1);
    let shown = welch.density.get(1..count).unwrap_or(&[]);
    let group = shown.len().div_ceil(MOST).max(1);
    let each = shown.chunks(group).enumerate().map(|(index, chunk)| {
        let largest = chunk.iter().copied().fold(0.0, f64::max);
        ((1.0 + (index * group) as f64) * welch.spacing, largest.sqrt())
    });
    each.unzip()
}

fn decay(identified: &Identified, ring_down: &RingDown) -> Figure {
    let count = ring_down.time.len();
    // Few swings are told apart on a page: the begin is shown, and beside it the whole.
    let turns =
        identified.found.lines.iter().filter(|line| line.decays).max_by(|a, b| a.strength.total_cmp(&b.strength));
    let period = turns.map_or(ring_down.time[count - 1], |line| 1.0 / line.frequency.value);
    let begin = ring_down.time.partition_point(|time| *time < ring_down.time[0] + 6.0 * period).clamp(2, count);
    let curve = |name: &str, values: &[f64], to: usize, colour, dash, width| {
        let step = to.div_ceil(MOST).max(1);
        Curve {
            label: name.into(),
            x: ring_down.time[..to].iter().step_by(step).map(|t| 1e3 * t).collect(),
            y: values[..to].iter().step_by(step).copied().collect(),
            stroke: Stroke { colour, dash, width },
        }
    };
    let panel = |to: usize, name: &str| Panel {
        title: if title(identified).is_empty() { name.to_owned() } else { format!("{name}, {}", title(identified)) },
        x: Axis { label: "Time since the hit [ms]".into(), ..Axis::default() },
        y: Axis {
            label: format!("{} [N]", label(ring_down.part).split(',').next().unwrap_or_default()),
            ..Axis::default()
        },
        curves: vec![
            curve("recorded", &ring_down.measured, to, Colour::Blue, Dash::Solid, 1.2),
            curve("fitted", &ring_down.fitted, to, Colour::Red, Dash::Dashed, 1.4),
        ],
        ..Panel::default()
    };
    let panels = vec![panel(begin, "first six periods of the strongest line"), panel(count, "the whole")];
    Figure { panels, columns: 1, panel_width: WIDTH, panel_height: 240.0 }
}

fn stiffness(identified: &Identified, line: &Stiffness) -> Figure {
    let step = line.lengths.len().div_ceil(MOST).max(1);
    let points = Points {
        label: "means of 0.2 s".into(),
        x: line.lengths.iter().step_by(step).map(|length| 1e3 * length).collect(),
        y: line.forces.iter().step_by(step).copied().collect(),
        ..Points::default()
    };
    let ends = [line.range.0, line.range.1];
    let fitted = Curve {
        label: "F = k (l − l0)".into(),
        x: ends.iter().map(|length| 1e3 * length).collect(),
        y: ends.iter().map(|length| line.value() * (length - line.length_at_zero.value)).collect(),
        stroke: Stroke { colour: Colour::Red, dash: Dash::Solid, width: 1.4 },
    };
    let name = if line.both_positions { "Length [mm]" } else { "Position [mm]" };
    let panel = Panel {
        title: title(identified),
        x: Axis { label: name.into(), ..Axis::default() },
        y: Axis { label: "Force [N]".into(), ..Axis::default() },
        curves: vec![fitted],
        points: vec![points],
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: 300.0 }
}
