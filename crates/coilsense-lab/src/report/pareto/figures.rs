//! The figure of a front: the cloud, the front, its knee and its ends, for every two objectives.
//!
//! Next door: how figures are drawn (`coilsense_figure`), the page that holds it (`html`).

use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, Marker, Panel, Points, Scale, Stroke};

use crate::pareto::{Aim, Study};
use crate::quantity::Shown;
use crate::report::prose::plain;

/// Width and height of a panel \[px\].
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 440.0;
/// The same where there are more.
const SMALL: [f64; 2] = [420.0, 330.0];
/// Share of the cloud that is shown where the rest lies far out.
const SHOWN: f64 = 0.9;
/// Most designs of the front that are drawn.
const MOST: usize = 600;
/// From this ratio of largest to least on, an axis is logarithmic.
const DECADES: f64 = 50.0;

/// A panel for every two objectives; none for a single one.
pub(super) fn front(study: &Study) -> Option<Figure> {
    let count = study.question.objectives.len();
    let units = study.shown();
    let pairs = (0..count).flat_map(|x| (x + 1..count).map(move |y| [x, y]));
    let pairs: Vec<[usize; 2]> = pairs.collect();
    // Many small panels together show no more points than two large ones.
    let every = pairs.len().div_ceil(2).max(1);
    let panels: Vec<Panel> = pairs.iter().map(|pair| panel(study, &units, *pair, every)).collect();
    match panels.len() {
        0 => None,
        1 => Some(Figure { panels, columns: 1, panel_width: WIDTH, panel_height: HEIGHT }),
        _ => Some(Figure { panels, columns: 2, panel_width: SMALL[0], panel_height: SMALL[1] }),
    }
}

fn panel(study: &Study, units: &[Shown], pair: [usize; 2], every: usize) -> Panel {
    let [x, y] = pair.map(|axis| Coordinates::of(study, &units[axis], axis));
    let some = |values: Vec<f64>| values.into_iter().step_by(every).collect();
    let points = |label: &str, places: &[usize], colour, marker| Points {
        label: label.to_owned(),
        x: places.iter().map(|place| x.front[*place]).collect(),
        y: places.iter().map(|place| y.front[*place]).collect(),
        colour,
        marker,
        ..Points::default()
    };
    let step = study.rows.len().div_ceil(MOST).max(1);
    let drawn: Vec<usize> = (0..study.rows.len()).step_by(step).collect();
    let cloud = Points {
        label: "compared".to_owned(),
        x: some(x.cloud),
        y: some(y.cloud),
        colour: Colour::Ink,
        marker: Marker::Dot,
        ..Points::default()
    };
    let ends: Vec<usize> = pair.map(|axis| study.extremes[axis]).into();
    Panel {
        x: x.axis,
        y: y.axis,
        curves: if units.len() == 2 { vec![stairs(&x.front, &y.front)] } else { Vec::new() },
        points: vec![
            cloud,
            points("Pareto-optimal", &drawn, Colour::Blue, Marker::Disc),
            points("best in one respect", &ends, Colour::Green, Marker::Square),
            points("knee", &[study.knee], Colour::Red, Marker::Diamond),
        ],
        ..Panel::default()
    }
}

/// One objective of all that is drawn, in the unit in which it is shown.
struct Coordinates {
    axis: Axis,
    front: Vec<f64>,
    cloud: Vec<f64>,
}

impl Coordinates {
    fn of(study: &Study, shown: &Shown, axis: usize) -> Self {
        let front: Vec<f64> =
            (0..study.rows.len()).map(|place| shown.scaled(study.objectives_of(place)[axis])).collect();
        let cloud: Vec<f64> = study.cloud.iter().map(|point| shown.scaled(point[axis])).collect();
        let mut sorted = cloud.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        // The far side of the cloud is where designs are bad.
        let far = (SHOWN * sorted.len().saturating_sub(1) as f64) as usize;
        let kept = match study.question.objectives[axis].aim {
            Aim::Minimize => &sorted[..(far + 1).min(sorted.len())],
            Aim::Maximize => &sorted[sorted.len().saturating_sub(far + 1)..],
        };
        let (least, most) = kept
            .iter()
            .chain(&front)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(*value), most.max(*value)));
        let scale = if least > 0.0 && most / least > DECADES { Scale::Log10 } else { Scale::Linear };
        let margin = 0.04 * (most - least);
        let range = match scale {
            _ if most <= least => None,
            Scale::Linear => Some((least - margin, most + margin)),
            Scale::Log10 => Some((least / 1.15, most * 1.15)),
        };
        Self { axis: Axis { label: plain(&shown.title()), range, scale }, front, cloud }
    }
}

/// What two objectives leave to be reached: nothing lies beyond the stairs.
fn stairs(x: &[f64], y: &[f64]) -> Curve {
    let (mut across, mut up) = (Vec::new(), Vec::new());
    for place in 0..x.len() {
        if place > 0 {
            across.push(x[place]);
            up.push(y[place - 1]);
        }
        across.push(x[place]);
        up.push(y[place]);
    }
    Curve {
        label: String::new(),
        x: across,
        y: up,
        stroke: Stroke { colour: Colour::Blue, dash: Dash::Solid, width: 1.1 },
    }
}
