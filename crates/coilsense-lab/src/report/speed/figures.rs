//! Figures of a speed map: what happens over speed, and the harmonics of the cam across the lines of the spring.
//!
//! Next door: the page (`html`).

use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, HeatMap, HorizontalMark, Panel, Stroke};

use crate::speed::{HARMONICS, Line, SpeedMap, SpeedPoint};

const PANEL: (f64, f64) = (430.0, 165.0);
/// Of a phone.
const NARROW: (f64, f64) = (355.0, 170.0);
/// How ways are told apart, by colour and dash.
const COLOURS: [Colour; 4] = [Colour::Red, Colour::Blue, Colour::Green, Colour::Ink];
const DASHES: [Dash; 2] = [Dash::Solid, Dash::Dashed];

/// Campbell's map, a follower that floats, windings that meet, surge; without a follower forces at both ends. So many columns of panels.
pub(super) fn overview(map: &SpeedMap, columns: usize) -> Figure {
    let mut panels = vec![campbell(map)];
    let has_follower = map.points.iter().any(|point| point.floating.is_some());
    if has_follower {
        let share = |point: &SpeedPoint| 100.0 * point.floating.map_or(0.0, |floating| floating.share);
        panels.push(over_speed(map, "Follower off its cam [%]", share));
    }
    panels.push(over_speed(map, "Touches a turn [1]", |point| point.touches));
    panels.push(over_speed(map, "Surge, max |F \u{2212} F_x| [N]", |point| point.surge));
    if !has_follower {
        panels.push(forces(map));
    }
    let (panel_width, panel_height) = if columns == 1 { NARROW } else { PANEL };
    Figure { panels, columns, panel_width, panel_height }
}

/// Least and largest forces at both ends of the first way.
pub(super) fn ends(map: &SpeedMap) -> Figure {
    Figure { panels: vec![forces(map)], columns: 1, panel_width: 760.0, panel_height: 300.0 }
}

fn speeds(map: &SpeedMap) -> Axis {
    let range = Some((60.0 * map.range.from, (60.0 * map.range.to).max(60.0 * map.range.from + 1.0)));
    Axis { label: "Engine speed [rpm]".into(), range, ..Axis::default() }
}

fn of_way(map: &SpeedMap, way: usize, label: String, stroke: Stroke, of: impl Fn(&SpeedPoint) -> f64) -> Curve {
    let points: Vec<&SpeedPoint> = map.of_way(way).collect();
    let x = points.iter().map(|point| 60.0 * point.speed).collect();
    let y = points.iter().map(|point| of(point)).collect();
    Curve { label, x, y, stroke }
}

fn over_speed(map: &SpeedMap, label: &str, of: impl Fn(&SpeedPoint) -> f64 + Copy) -> Panel {
    let ways = &map.spec.mount.cases;
    let curve = |way: usize| {
        let stroke =
            Stroke { colour: COLOURS[way % COLOURS.len()], dash: DASHES[(way / COLOURS.len()) % 2], width: 1.5 };
        of_way(map, way, ways[way].label.clone(), stroke, of)
    };
    Panel {
        x: speeds(map),
        y: Axis { label: label.into(), ..Axis::default() },
        curves: (0..ways.len()).map(curve).collect(),
        ..Panel::default()
    }
}

fn forces(map: &SpeedMap) -> Panel {
    type Side = (&'static str, fn(&SpeedPoint) -> f64, Colour, Dash);
    let each: [Side; 4] = [
        ("F_i hardest push", |point| point.input[0], Colour::Red, Dash::Solid),
        ("F_i least", |point| point.input[1], Colour::Red, Dash::Dashed),
        ("F_o hardest push", |point| point.output[0], Colour::Blue, Dash::Solid),
        ("F_o least", |point| point.output[1], Colour::Blue, Dash::Dashed),
    ];
    let curve =
        |(name, of, colour, dash): Side| of_way(map, 0, name.to_owned(), Stroke { colour, dash, width: 1.5 }, of);
    Panel {
        x: speeds(map),
        y: Axis { label: "Force [N]".into(), ..Axis::default() },
        curves: each.into_iter().map(curve).collect(),
        ..Panel::default()
    }
}

/// Harmonics of the cam as rising lines, those of spring and neighbours level.
fn campbell(map: &SpeedMap) -> Panel {
    let lines = &map.campbell.lines;
    let first = lines.first().map_or(1.0, |line| line.frequency);
    let top = 1.6 * first;
    let range = &map.range;
    let shown = lines.iter().filter(|line| line.frequency < top);
    let limits = shown.map(|line| HorizontalMark { y: line.frequency, label: line.name.clone() }).collect();
    let harmonic = |number: usize| Curve {
        label: if number == 1 {
            format!("harmonics 1 to {} of the cam", map.campbell.harmonics)
        } else {
            String::new()
        },
        x: vec![60.0 * range.from, 60.0 * range.to],
        y: [range.from, range.to].map(|speed| number as f64 * range.ratio * speed).to_vec(),
        stroke: Stroke { colour: Colour::Ink, dash: Dash::Solid, width: 0.8 },
    };
    Panel {
        x: speeds(map),
        y: Axis { label: "Frequency [Hz]".into(), range: Some((0.0, top)), ..Axis::default() },
        curves: (1..=map.campbell.harmonics).map(harmonic).collect(),
        limits,
        ..Panel::default()
    }
}

/// Amplitudes of F_o's harmonics over the speed, in decibels; columns are the steps, and of the speeds within one the largest is shown.
pub(super) fn waterfall(map: &SpeedMap) -> Figure {
    let range = &map.range;
    let step = range.step.max((range.to - range.from) / MOST_COLUMNS);
    let columns = ((range.to - range.from) / step).round() as usize + 1;
    let mut values = vec![f64::NAN; HARMONICS * columns];
    for point in map.of_way(0) {
        let column = (((point.speed - range.from) / step).round() as usize).min(columns - 1);
        for (harmonic, amplitude) in point.harmonics.iter().enumerate() {
            let value = &mut values[harmonic * columns + column];
            *value = value.max(20.0 * amplitude.max(1.0).log10());
        }
    }
    let edge = |column: f64| 60.0 * (range.from + (column - 0.5) * step);
    let heat = HeatMap {
        label: "Amplitude [dB re 1 N]".into(),
        rows: HARMONICS,
        values,
        x: (edge(0.0), edge(columns as f64)),
        y: (0.5, HARMONICS as f64 + 0.5),
        range: None,
        smooth: false,
        marked: None,
    };
    let surges = map.campbell.lines.iter().filter(|line| line.is_surge());
    let panel = Panel {
        x: Axis { label: "Engine speed [rpm]".into(), range: Some(heat.x), ..Axis::default() },
        y: Axis { label: "Harmonic of the camshaft [1]".into(), range: Some(heat.y), ..Axis::default() },
        curves: surges.enumerate().map(|(index, line)| order(map, index, line)).collect(),
        heat: Some(heat),
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: 760.0, panel_height: 340.0 }
}

/// Most columns of the waterfall.
const MOST_COLUMNS: f64 = 200.0;

/// Which harmonic has a line's frequency, over the speed.
fn order(map: &SpeedMap, index: usize, line: &Line) -> Curve {
    let range = &map.range;
    let speeds: Vec<f64> =
        (0..=100).map(|part| range.from + f64::from(part) / 100.0 * (range.to - range.from)).collect();
    Curve {
        label: line.name.clone(),
        x: speeds.iter().map(|speed| 60.0 * speed).collect(),
        y: speeds.iter().map(|speed| line.frequency / (range.ratio * speed)).collect(),
        stroke: Stroke { colour: Colour::Ink, dash: if index == 0 { Dash::Solid } else { Dash::Dashed }, width: 1.0 },
    }
}
