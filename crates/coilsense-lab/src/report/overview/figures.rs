//! The figures of a log: the course of each channel, and below it its spectrogram on the same axis of time.
//!
//! Next door: how figures are drawn (`coilsense_figure`), spectrograms (`report::spectrogram`).

use coilsense_figure::{Axis, Band, Colour, Curve, Dash, Figure, Panel, Stroke};

use crate::recording::Recording;
use crate::report::spectrogram::{seconds, spectrogram};

/// Width of a figure \[px\].
const WIDTH: f64 = 760.0;
/// Most dots of a course.
const MOST_DOTS: usize = 1500;

/// Name, caption and figure of each channel.
pub(super) fn all(recording: &Recording) -> Vec<(String, String, Figure)> {
    let time = recording.signals().time();
    let rate = recording.sample_rate().ok();
    let said = if recording.simulated().is_some() { " Simulated data." } else { "" };
    let title = if recording.simulated().is_some() { "simulated data" } else { "" };
    let figure = |(channel, values): (coilsense::Channel, &[f64])| {
        let name = channel.name();
        // As people think of a spring's ends.
        let (factor, unit) = if channel.unit() == "m" { (1e3, "mm") } else { (1.0, channel.unit()) };
        let values: Vec<f64> = values.iter().map(|value| factor * value).collect();
        let mut panels = vec![course(title, &format!("{name} [{unit}]"), time, &values)];
        let spectrogram = rate.and_then(|rate| spectrogram(time, &values, rate, 0.5 * rate));
        let with = if spectrogram.is_some() { " and its spectrogram" } else { "" };
        panels.extend(spectrogram);
        let caption = format!("{name} over time{with}.{said}");
        (name.to_owned(), caption, Figure { panels, columns: 1, panel_width: WIDTH, panel_height: 200.0 })
    };
    recording.signals().channels().map(figure).collect()
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
