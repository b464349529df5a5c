//! The figures of a log: the course of each channel, and below it its spectrogram on the same axis of time.
//!
//! Next door: how figures are drawn (`coilsense_figure`), densities (`coilsense::identify::Welch`).

use coilsense::identify::Welch;
use coilsense_figure::{Axis, Band, Colour, Curve, Dash, Figure, HeatMap, Panel, Stroke};

use crate::recording::Recording;

/// Width of a figure \[px\].
const WIDTH: f64 = 760.0;
/// Most dots of a course, and most columns of a spectrogram.
const MOST_DOTS: usize = 1500;
const MOST_COLUMNS: usize = 500;
/// What is so far below the largest density \[dB\] is not told apart.
const DEPTH: f64 = 80.0;
/// Fewest samples of which a spectrogram is made.
const FEWEST: usize = 256;

/// Name, caption and figure of each channel.
pub(super) fn all(recording: &Recording) -> Vec<(String, String, Figure)> {
    let time = recording.signals().time();
    let rate = recording.sample_rate().ok().filter(|_| time.len() >= FEWEST);
    let said = if recording.simulated().is_some() { " Simulated data." } else { "" };
    let title = if recording.simulated().is_some() { "simulated data" } else { "" };
    let figure = |(channel, values): (coilsense::Channel, &[f64])| {
        let name = channel.name();
        // As people think of a spring's ends.
        let (factor, unit) = if channel.unit() == "m" { (1e3, "mm") } else { (1.0, channel.unit()) };
        let values: Vec<f64> = values.iter().map(|value| factor * value).collect();
        let mut panels = vec![course(title, &format!("{name} [{unit}]"), time, &values)];
        let spectrogram = rate.and_then(|rate| spectrogram(time, &values, rate));
        let with = if spectrogram.is_some() { " and its spectrogram" } else { "" };
        panels.extend(spectrogram);
        let caption = format!("{name} over time{with}.{said}");
        (name.to_owned(), caption, Figure { panels, columns: 1, panel_width: WIDTH, panel_height: 200.0 })
    };
    recording.signals().channels().map(figure).collect()
}

fn seconds(time: &[f64]) -> Axis {
    let range = time.first().copied().zip(time.last().copied()).filter(|(from, to)| from < to);
    Axis { label: "Time [s]".into(), range, ..Axis::default() }
}

fn course(title: &str, label: &str, time: &[f64], values: &[f64]) -> Panel {
    let panel = Panel {
        title: title.to_owned(),
        x: seconds(time),
        y: Axis { label: label.to_owned(), ..Axis::default() },
        ..Panel::default()
    };
    let each = values.len().div_ceil(MOST_DOTS).max(1);
    if each == 1 {
        let stroke = Stroke { colour: Colour::Blue, dash: Dash::Solid, width: 1.2 };
        let curve = Curve { label: String::new(), x: time.to_vec(), y: values.to_vec(), stroke };
        return Panel { curves: vec![curve], ..panel };
    }
    let edge = |start: f64, chosen: fn(f64, f64) -> f64| -> Vec<f64> {
        values.chunks(each).map(|chunk| chunk.iter().copied().fold(start, chosen)).collect()
    };
    let band = Band {
        label: String::new(),
        x: time.chunks(each).map(|chunk| chunk[chunk.len() / 2]).collect(),
        lower: edge(f64::INFINITY, f64::min),
        upper: edge(f64::NEG_INFINITY, f64::max),
        colour: Colour::Blue,
    };
    let middle = band.lower.iter().zip(&band.upper).map(|(low, high)| 0.5 * (low + high)).collect();
    let stroke = Stroke { colour: Colour::Blue, dash: Dash::Solid, width: 1.0 };
    let curve = Curve { label: String::new(), x: band.x.clone(), y: middle, stroke };
    Panel { bands: vec![band], curves: vec![curve], ..panel }
}

/// Densities of pieces one after the other; `None` where nothing but a mean is there.
fn spectrogram(time: &[f64], values: &[f64], rate: f64) -> Option<Panel> {
    let length = ((2.0 * (values.len() as f64).sqrt()) as usize).next_power_of_two().clamp(64, 4096).min(values.len());
    let piece = values.len().div_ceil(MOST_COLUMNS).max(length / 2);
    let columns = values.len().div_ceil(piece);
    let rows = length / 2 + 1;
    let mut densities = vec![f64::NAN; rows * columns];
    for column in 0..columns {
        // Half a taper on either side, so that what happens at an edge is seen.
        let from = (column * piece).saturating_sub(length / 2).min(values.len() - length);
        let to = ((column + 1) * piece + length / 2).clamp(from + length, values.len());
        for (row, density) in Welch::of(&values[from..to], rate, length).density.into_iter().enumerate() {
            densities[row * columns + column] = density;
        }
    }
    let largest = densities.iter().copied().fold(0.0, f64::max);
    if largest <= 0.0 || !largest.is_finite() {
        return None;
    }
    let decibels = |density: f64| (10.0 * (density / largest).log10()).max(-DEPTH);
    let spacing = rate / length as f64;
    let heat = HeatMap {
        label: "Density [dB]".into(),
        rows,
        values: densities.into_iter().map(decibels).collect(),
        x: (time[0], time[0] + (columns * piece) as f64 / rate),
        y: (-0.5 * spacing, 0.5 * rate + 0.5 * spacing),
        range: Some((-DEPTH, 0.0)),
        smooth: false,
        marked: None,
    };
    let y = Axis { label: "Frequency [Hz]".into(), range: Some((0.0, 0.5 * rate)), ..Axis::default() };
    Some(Panel { x: seconds(time), y, heat: Some(heat), ..Panel::default() })
}

#[cfg(test)]
mod tests {
    use super::spectrogram;

    #[test]
    fn a_tone_that_begins_late_is_seen_where_and_when_it_is() {
        let (rate, count) = (1000.0, 20_000);
        let time: Vec<f64> = (0..count).map(|n| n as f64 / rate).collect();
        let tone = |t: &f64| if *t < 12.0 { 0.0 } else { (std::f64::consts::TAU * 125.0 * t).sin() };
        let values: Vec<f64> = time.iter().map(tone).collect();
        let panel = spectrogram(&time, &values, rate).unwrap();
        let heat = panel.heat.unwrap();
        let columns = heat.values.len() / heat.rows;
        let spacing = 0.5 * rate / (heat.rows - 1) as f64;
        let at = |hertz: f64, second: f64| {
            let column = ((second - heat.x.0) / (heat.x.1 - heat.x.0) * columns as f64) as usize;
            heat.values[(hertz / spacing).round() as usize * columns + column]
        };
        assert!(at(125.0, 16.0) > -0.1 && at(125.0, 5.0) < -79.0 && at(300.0, 16.0) < -79.0);
        assert!(spectrogram(&time, &vec![3.0; count], rate).is_none());
    }
}
