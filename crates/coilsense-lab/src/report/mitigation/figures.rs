//! The figures of a mitigation: the trade-off of error against lag, and forces over time.
//!
//! Next door: how figures are drawn (`coilsense_figure`), the page that holds them (`html`).

use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, Marker, Panel, Points, Scale, Stroke};

use super::text::{judged, percent};
use crate::mitigation::{Judgement, Made, Origin, Ranking, Truth};

/// Worst-case error against lag.
pub(super) fn trade_off(answer: &Ranking) -> Figure {
    let points = |truth, origin, label: &str, colour, marker| {
        let those = answer.judged.iter().filter(|(c, _)| c.truth == truth && c.origin == origin);
        let names =
            those.clone().map(|(c, j)| if is_on_front(answer, truth, j) { c.name.clone() } else { String::new() });
        let names = names.collect();
        let (x, y) = those.map(|(_, j)| (j.lag.to_degrees(), percent(answer, j.worst))).unzip();
        Points { label: label.to_owned(), x, y, names, colour, marker, ..Points::default() }
    };
    let axis = |label: String, range, scale| Axis { label, range, scale };
    // No point stands on the frame.
    let around = |truth| {
        let lags = answer.judged.iter().filter(|(c, _)| c.truth == truth).map(|(_, j)| j.lag.to_degrees());
        let (least, most) = lags.fold((0.0_f64, 0.0_f64), |(least, most), lag| (least.min(lag), most.max(lag)));
        let room = 0.05 * (most - least).max(1.0);
        Some((least - room, most + room))
    };
    // A name has room below the least.
    let errors = || {
        let worst = answer.judged.iter().map(|(_, j)| percent(answer, j.worst)).filter(|worst| *worst > 0.0);
        let (least, most) =
            worst.fold((f64::INFINITY, 0.0_f64), |(least, most), worst| (least.min(worst), most.max(worst)));
        (least < most).then_some((0.65 * least, 1.25 * most))
    };
    let panel = |title: &str, truth| Panel {
        title: title.to_owned(),
        x: axis(format!("Lag at {:.3} Hz [°]", answer.study.bandwidth), around(truth), Scale::Linear),
        y: axis("Worst error [% of F_{nom}]".to_owned(), errors(), Scale::Log10),
        points: vec![
            points(truth, Origin::Fitted, "fitted", Colour::Red, Marker::Diamond),
            points(truth, Origin::Textbook, "textbook", Colour::Blue, Marker::Square),
            points(truth, Origin::Raw, "nothing done", Colour::Ink, Marker::Disc),
        ],
        ..Panel::default()
    };
    Figure {
        panels: judged(answer).into_iter().map(|truth| panel(title(truth), truth)).collect(),
        columns: 2,
        panel_width: 420.0,
        panel_height: 320.0,
    }
}

/// Whether nothing is both less wrong and less late, one of them by some.
fn is_on_front(answer: &Ranking, truth: Truth, judged: &Judgement) -> bool {
    let mut others = answer.judged.iter().filter(|(candidate, _)| candidate.truth == truth).map(|(_, other)| other);
    !others.any(|other| {
        other.worst <= judged.worst
            && other.lag.abs() <= judged.lag.abs()
            && (other.worst < judged.worst || other.lag.abs() < judged.lag.abs())
    })
}

fn title(truth: Truth) -> &'static str {
    match truth {
        Truth::Static => "Filters of F_i",
        Truth::Output => "Estimators of F_o",
    }
}

/// What is measured, what is true and what comes out, over time.
pub(super) fn over_time(answer: &Ranking) -> Option<Figure> {
    let shown = answer.shown.as_ref()?;
    let curve = |label: &str, series: &[f64], colour, dash, width| Curve {
        label: label.to_owned(),
        x: shown.time.clone(),
        y: series.iter().map(|force| percent(answer, *force)).collect(),
        stroke: Stroke { colour, dash, width },
    };
    let panel = |made: &Made| Panel {
        title: format!("{}: {}", if made.truth == Truth::Static { "F_i" } else { "F_o" }, made.name),
        x: Axis { label: "Time [s]".to_owned(), ..Axis::default() },
        y: Axis { label: "Force [% of F_{nom}]".to_owned(), ..Axis::default() },
        curves: vec![
            curve("F_i as measured", &shown.measured, Colour::Blue, Dash::Solid, 0.9),
            curve(&format!("true {}", made.truth.name()), &made.truly, Colour::Ink, Dash::Dashed, 1.8),
            curve("what comes out", &made.out, Colour::Red, Dash::Solid, 1.5),
        ],
        ..Panel::default()
    };
    let of_best = |truth| shown.made.get(answer.place_of_best(truth)?);
    let panels: Vec<Panel> = [Truth::Static, Truth::Output].into_iter().filter_map(of_best).map(panel).collect();
    (!panels.is_empty()).then_some(Figure { panels, columns: 1, panel_width: 760.0, panel_height: 280.0 })
}
