//! Which frequencies a signal has when, as a panel.
//!
//! Next door: the figures of a log (`overview`) and of what rings in it (`identification`), densities (`coilsense::identify::Welch`).

use coilsense::identify::Welch;
use coilsense_figure::{Axis, HeatMap, Panel};

/// Most columns of a spectrogram.
const MOST_COLUMNS: usize = 500;
/// What is so far below the largest density \[dB\] is not told apart.
const DEPTH: f64 = 80.0;
/// Fewest samples of which a spectrogram is made.
const FEWEST: usize = 256;

/// The axis of a record's time.
pub(super) fn seconds(time: &[f64]) -> Axis {
    let range = time.first().copied().zip(time.last().copied()).filter(|(from, to)| from < to);
    Axis { label: "Time [s]".into(), range, ..Axis::default() }
}

/// Densities of pieces one after the other, of values sampled at a rate, shown up to a frequency \[Hz\]; `None` where nothing but a mean is there.
pub(super) fn spectrogram(time: &[f64], values: &[f64], rate: f64, up_to: f64) -> Option<Panel> {
    if time.len() < FEWEST {
        return None;
    }
    let length = ((2.0 * (values.len() as f64).sqrt()) as usize).next_power_of_two().clamp(64, 4096).min(values.len());
    let piece = values.len().div_ceil(MOST_COLUMNS).max(length / 2);
    let columns = values.len().div_ceil(piece);
    let spacing = rate / length as f64;
    let rows = ((up_to / spacing).ceil() as usize + 1).min(length / 2 + 1);
    let mut densities = vec![f64::NAN; rows * columns];
    for column in 0..columns {
        // Half a taper on either side, so that what happens at an edge is seen.
        let from = (column * piece).saturating_sub(length / 2).min(values.len() - length);
        let to = ((column + 1) * piece + length / 2).clamp(from + length, values.len());
        for (row, density) in Welch::of(&values[from..to], rate, length).density.into_iter().enumerate().take(rows) {
            densities[row * columns + column] = density;
        }
    }
    let largest = densities.iter().copied().fold(0.0, f64::max);
    if largest <= 0.0 || !largest.is_finite() {
        return None;
    }
    let decibels = |density: f64| (10.0 * (density / largest).log10()).max(-DEPTH);
    let heat = HeatMap {
        label: "Density [dB]".into(),
        rows,
        values: densities.into_iter().map(decibels).collect(),
        x: (time[0], time[0] + (columns * piece) as f64 / rate),
        y: (-0.5 * spacing, (rows as f64 - 0.5) * spacing),
        range: Some((-DEPTH, 0.0)),
        smooth: false,
        marked: None,
    };
    let y = Axis { label: "Frequency [Hz]".into(), range: Some((0.0, up_to)), ..Axis::default() };
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
        let panel = spectrogram(&time, &values, rate, 0.5 * rate).unwrap();
        let heat = panel.heat.unwrap();
        let columns = heat.values.len() / heat.rows;
        let spacing = (heat.y.1 - heat.y.0) / heat.rows as f64;
        let at = |hertz: f64, second: f64| {
            let column = ((second - heat.x.0) / (heat.x.1 - heat.x.0) * columns as f64) as usize;
            heat.values[(hertz / spacing).round() as usize * columns + column]
        };
        let low = spectrogram(&time, &values, rate, 150.0).unwrap().heat.unwrap();
        assert!(low.rows < heat.rows / 3 && low.y.1 >= 150.0);
        assert_eq!(low.values[..], heat.values[..low.rows * columns]);
        assert!(at(125.0, 16.0) > -0.1 && at(125.0, 5.0) < -79.0 && at(300.0, 16.0) < -79.0);
        assert!(spectrogram(&time, &vec![3.0; count], rate, 0.5 * rate).is_none());
    }
}
