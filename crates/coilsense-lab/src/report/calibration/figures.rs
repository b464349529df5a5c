//! The figures of a calibration: the curve with its theories, residuals, theories ranked.
//!
//! Next door: how figures are drawn (`coilsense_figure`).

use coilsense::inductance::theories::Theory;
use coilsense_figure::{Axis, Bar, Bars, Colour, Curve, Dash, Figure, HorizontalMark, Panel, Points, Stroke};

use crate::calibration::{Curve as Fitted, Outcome, Relation, THEORY_POINTS};
use crate::quantity::digits;

/// Width of a figure \[px\].
const WIDTH: f64 = 760.0;
/// Samples of a smooth curve.
const SAMPLES: usize = 200;
/// Theories that are drawn as curves; Lundin's and Wheeler's would lie on Nagaoka's.
const DRAWN: [(Theory, Colour, Dash); 5] = [
    (Theory::IdealSolenoid, Colour::Blue, Dash::Dotted),
    (Theory::Nagaoka, Colour::Green, Dash::Dashed),
    (Theory::NagaokaRosa, Colour::Red, Dash::Dotted),
    (Theory::MaxwellSum, Colour::Red, Dash::DashDot),
    (Theory::NeumannHelix, Colour::Blue, Dash::Dashed),
];

/// Name, caption and figure of each.
pub(super) fn all(outcome: &Outcome) -> Vec<(String, String, Figure)> {
    let said = if outcome.measured.simulated { " Simulated data." } else { "" };
    let mut figures = vec![
        ("curve".to_owned(), format!("{}{said}", curve_caption(outcome)), curve(outcome)),
        ("residuals".to_owned(), format!("{}{said}", residual_caption(outcome)), residuals(outcome)),
    ];
    if outcome.contest.by_number.len() > 1 {
        let caption = format!(
            "How many points are enough: {} read at points that a relation was not fitted to, over how many it was, spread from the shortest to the longest.",
            outcome.measured.place_name()
        );
        figures.push(("number".to_owned(), format!("{caption}{said}"), number(outcome)));
    }
    if !outcome.theories.is_empty() {
        let caption = "How far the displacement is off that each theory makes of the measured inductances: without a measured point for the \
                       theories, with two or more for the fit.";
        figures.push(("theories".to_owned(), format!("{caption}{said}"), theories(outcome)));
    }
    figures
}

/// What every figure of simulated data says on its face.
fn title(outcome: &Outcome) -> String {
    if outcome.measured.simulated { "simulated data".to_owned() } else { String::new() }
}

/// Some room beside the outer points.
fn place_axis(outcome: &Outcome) -> Axis {
    let label = if outcome.measured.zero_length.is_some() { "Displacement [mm]" } else { "Length [mm]" };
    let places = millimetres(&outcome.measured.places());
    let (lowest, highest) = places.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &x| (a.min(x), b.max(x)));
    let room = 0.03 * (highest - lowest);
    Axis { label: label.into(), range: Some((lowest - room, highest + room)), ..Axis::default() }
}

/// Values of the points that are shown; none of what no point has.
fn shown(outcome: &Outcome, values: &[f64]) -> Vec<f64> {
    outcome.measured.some(THEORY_POINTS).into_iter().filter_map(|index| values.get(index).copied()).collect()
}

fn millimetres(metres: &[f64]) -> Vec<f64> {
    metres.iter().map(|metre| 1e3 * metre).collect()
}

fn curve(outcome: &Outcome) -> Figure {
    let points = &outcome.measured.points;
    let zero = outcome.measured.zero_length.unwrap_or(0.0);
    let shortest = points.lengths().iter().copied().fold(f64::INFINITY, f64::min);
    let step = points.range() / (SAMPLES - 1) as f64;
    let lengths: Vec<f64> = (0..SAMPLES).map(|index| shortest + step * index as f64).collect();
    let x: Vec<f64> = lengths.iter().map(|length| 1e3 * (length - zero)).collect();
    let smooth = |label: &str, colour, dash, width, relation: &dyn Fn(f64) -> f64| Curve {
        label: label.into(),
        x: x.clone(),
        y: lengths.iter().map(|&length| 1e6 * relation(length)).collect(),
        stroke: Stroke { colour, dash, width },
    };
    let fit = |length: f64| outcome.taken.curve.inductance(length);
    let mut curves: Vec<Curve> = outcome
        .plan
        .coil
        .iter()
        .flat_map(|coil| DRAWN.map(|drawn| (coil, drawn)))
        .map(|(coil, (theory, colour, dash))| smooth(theory.name(), colour, dash, 1.4, &|l| theory.inductance(coil, l)))
        .collect();
    if let Fitted::Steel(steel) = &outcome.taken.curve {
        let air = |length: f64| steel.not_magnetic(length);
        curves.push(smooth("the same, wire not magnetic", Colour::Green, Dash::DashDot, 1.4, &air));
    }
    curves.push(smooth(outcome.plan.relation.words(), Colour::Ink, Dash::Solid, 1.5, &fit));
    let micro = |values: &[f64]| shown(outcome, values).iter().map(|henry| 1e6 * henry).collect::<Vec<f64>>();
    let measured = Points {
        label: "measured".into(),
        x: millimetres(&shown(outcome, &outcome.measured.places())),
        y: micro(points.inductances()),
        errors: micro(&outcome.measured.standard_errors),
        colour: Colour::Ink,
        ..Points::default()
    };
    let panel = Panel {
        title: title(outcome),
        x: place_axis(outcome),
        y: Axis { label: "Inductance [µH]".into(), ..Axis::default() },
        curves,
        points: vec![measured],
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: 340.0 }
}

fn curve_caption(outcome: &Outcome) -> String {
    let (fitted, all) = (outcome.taken.fitted.len(), outcome.taken.read.len());
    let own = match outcome.plan.relation {
        Relation::InverseLength if outcome.plan.points.is_none() => {
            format!("Measured inductance and the curve {}.", outcome.plan.method.words(all))
        }
        relation => format!("Measured inductance and {}, fitted to {fitted} of {all} points.", relation.words()),
    };
    if outcome.theories.is_empty() {
        return own;
    }
    format!("{own} Theories that are not drawn are in the table.")
}

fn residuals(outcome: &Outcome) -> Figure {
    let left = outcome.taken.residuals(&outcome.measured);
    let rmse = 1e3 * outcome.taken.rmse(&outcome.measured);
    let lengths = outcome.measured.points.lengths();
    let alpha = outcome.inverse_length.alpha;
    let errors: Vec<f64> =
        outcome.measured.standard_errors.iter().zip(lengths).map(|(henry, l)| (henry * alpha * l * l).abs()).collect();
    let points = Points {
        x: millimetres(&shown(outcome, &outcome.measured.places())),
        y: millimetres(&shown(outcome, &left)),
        errors: millimetres(&shown(outcome, &errors)),
        ..Points::default()
    };
    let rmse = if rmse.is_finite() { rmse } else { 0.0 };
    let limits = if rmse > 0.0 { vec![(rmse, "+RMSE"), (0.0, ""), (-rmse, "−RMSE")] } else { vec![(0.0, "")] };
    let panel = Panel {
        title: title(outcome),
        x: place_axis(outcome),
        y: Axis { label: "Read less given [mm]".into(), ..Axis::default() },
        points: vec![points],
        limits: limits.into_iter().map(|(y, label)| HorizontalMark { y, label: label.into() }).collect(),
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: 260.0 }
}

fn residual_caption(outcome: &Outcome) -> String {
    let name = outcome.measured.place_name();
    let bars = if outcome.measured.standard_errors.is_empty() {
        ""
    } else {
        " Bars: what the standard error of each mean inductance makes of it."
    };
    format!("Residuals of {name}: what the curve reads from each inductance, less what the file gives.{bars}")
}

fn number(outcome: &Outcome) -> Figure {
    let drawn = [
        (Relation::InverseLength, Colour::Ink, Dash::Solid),
        (Relation::Cubic, Colour::Green, Dash::Dashed),
        (Relation::Steel, Colour::Blue, Dash::Solid),
    ];
    let curves = drawn.map(|(relation, colour, dash)| {
        let found = outcome.contest.by_number.iter().filter_map(|number| {
            let share = number.shares.iter().find(|(of, _)| *of == relation)?.1;
            Some((number.fitted as f64, 100.0 * share))
        });
        let (x, y) = found.unzip();
        Curve { label: relation.words().into(), x, y, stroke: Stroke { colour, dash, width: 1.6 } }
    });
    let curves = curves.into_iter().filter(|curve| !curve.x.is_empty()).collect();
    let most = outcome.contest.by_number.last().map_or(2.0, |number| number.fitted as f64);
    let panel = Panel {
        title: title(outcome),
        x: Axis { label: "Points fitted".into(), range: Some((2.0, most)), ..Axis::default() },
        y: Axis { label: "RMS on the others [% of range]".into(), ..Axis::default() },
        curves,
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: 260.0 }
}

fn theories(outcome: &Outcome) -> Figure {
    let bar = |name: &str, share: f64, colour| {
        let percent = 100.0 * share;
        Bar { name: name.into(), value: percent, text: format!("{} %", digits(percent)), colour, ..Bar::default() }
    };
    let judged = outcome.theories.iter().filter_map(|judged| Some((judged.theory, judged.misfit.as_ref().ok()?)));
    let mut bars: Vec<Bar> =
        judged.map(|(theory, misfit)| bar(theory.name(), misfit.rmse_share_of_range, Colour::Blue)).collect();
    bars.sort_by(|a, b| a.value.total_cmp(&b.value));
    let own = match outcome.plan.relation {
        Relation::InverseLength => outcome.inverse_length.misfit.rmse_share_of_range,
        _ => outcome.taken.rms_share,
    };
    bars.insert(0, bar(&format!("the fit, {}", outcome.plan.relation.words()), own, Colour::Ink));
    let bars = Bars { bars, second: String::new() };
    let panel_height = bars.panel_height(WIDTH);
    let label = format!("RMSE of {} [% of the range]", outcome.measured.place_name());
    let panel =
        Panel { title: title(outcome), x: Axis { label, ..Axis::default() }, bars: Some(bars), ..Panel::default() };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height }
}
