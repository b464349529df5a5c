//! Modes of the coil against its length, with what drives it across them.
//!
//! Next door: the other figures of an analysis (`figures`), the modes (`crate::helix`).

use coilsense_figure::{Axis, Band, Colour, Curve, Dash, Figure, HorizontalMark, Panel, Stroke};

use crate::analysis::{Analysis, lines};
use crate::helix::{ModesAt, UnderEnds};
use crate::quantity::digits;
use crate::report::prose::plain;

/// Lengths at which modes are found.
const LENGTHS: usize = 25;
/// The figure reaches so many times as high as the first surge.
const REACH: f64 = 2.4;
/// Lines of the input that are drawn.
const LINES: usize = 6;
/// Kinds with their looks, in the order of the legend.
const KINDS: [(&str, Colour, Dash); 4] = [
    ("axial", Colour::Red, Dash::Solid),
    ("torsional", Colour::Green, Dash::DashDot),
    ("lateral", Colour::Blue, Dash::Dashed),
    ("mixed", Colour::Ink, Dash::Dotted),
];

/// The figure; `None` where the coil is no helix.
pub(super) fn modes(analysis: &Analysis) -> Option<Figure> {
    let spec = &analysis.spec;
    let all = spec.spring.helix(&spec.mount.ends).and_then(|coil| coil.over_lengths(LENGTHS)).ok()?;
    let highest = all.iter().flat_map(ModesAt::ways).map(|way| way.first_surge_hz);
    let top = REACH * highest.fold(0.0, f64::max);
    let lengths: Vec<f64> = all.iter().map(|at| 1e3 * at.length_m).collect();
    let curves = KINDS.iter().flat_map(|look| of_kind(&all, look, &lengths, top)).collect();
    let panel = Panel {
        x: Axis {
            label: "Length [mm]".into(),
            range: Some((lengths[0], lengths[lengths.len() - 1])),
            ..Axis::default()
        },
        y: Axis { label: "Frequency [Hz]".into(), range: Some((0.0, top)), ..Axis::default() },
        curves,
        bands: loosest(&all, &lengths, top),
        limits: driven(analysis, top),
        ..Panel::default()
    };
    Some(Figure { panels: vec![panel], columns: 1, panel_width: 760.0, panel_height: 340.0 })
}

/// The lines of a kind, the ends at their tightest: the n-th frequency of all, where it is of this kind, and on to the next length.
fn of_kind(all: &[ModesAt], (kind, colour, dash): &(&str, Colour, Dash), lengths: &[f64], top: f64) -> Vec<Curve> {
    let count = all.iter().map(|at| at.held.modes.len()).min().unwrap_or(0);
    let value = |order: usize, at: usize| -> f64 {
        let is = |at: usize| all[at].held.modes[order].kind == *kind;
        let hertz = all[at].held.modes[order].frequency_hz;
        if hertz < top && (is(at) || at > 0 && is(at - 1)) { hertz } else { f64::NAN }
    };
    let of_order = |order: usize| -> Vec<f64> { (0..all.len()).map(|at| value(order, at)).collect() };
    let each = (0..count).map(of_order).filter(|y| y.iter().any(|value| value.is_finite()));
    let stroke = Stroke { colour: *colour, dash: *dash, width: 1.6 };
    let label = |index: usize| if index == 0 { (*kind).to_owned() } else { String::new() };
    each.enumerate().map(|(index, y)| Curve { label: label(index), x: lengths.to_vec(), y, stroke }).collect()
}

/// How far down the lateral lines come where the ends are looser: of each pair the first.
fn loosest(all: &[ModesAt], lengths: &[f64], top: f64) -> Vec<Band> {
    let tight = lateral_pairs(all.iter().map(|at| &at.held), top);
    let loose = lateral_pairs(all.iter().filter_map(|at| at.loosest.as_ref()), top);
    let both = tight.into_iter().zip(loose).filter(|(upper, lower)| upper.len() == lower.len());
    let band = |(index, (upper, lower)): (usize, (Vec<f64>, Vec<f64>))| {
        let label = if index == 0 { "lateral, down to the loosest ends".to_owned() } else { String::new() };
        Band { label, x: lengths.to_vec(), lower, upper, colour: Colour::Blue }
    };
    both.enumerate().map(band).collect()
}

/// The first frequency of each lateral pair over the lengths, as long as one lies below `top`; not a number where there is none.
fn lateral_pairs<'a>(ways: impl Iterator<Item = &'a UnderEnds>, top: f64) -> Vec<Vec<f64>> {
    let of_way = |way: &UnderEnds| -> Vec<f64> {
        way.modes.iter().filter(|mode| mode.kind == "lateral").step_by(2).map(|mode| mode.frequency_hz).collect()
    };
    let each: Vec<Vec<f64>> = ways.map(of_way).collect();
    let at = |of_length: &Vec<f64>, pair: usize| of_length.get(pair).copied().filter(|hertz| *hertz < top);
    let of_pair = |pair: usize| -> Vec<f64> { each.iter().map(|of| at(of, pair).unwrap_or(f64::NAN)).collect() };
    let most = each.iter().map(Vec::len).max().unwrap_or(0);
    (0..most).map(of_pair).take_while(|values| values.iter().any(|value| value.is_finite())).collect()
}

/// What drives the ends, each frequency once.
fn driven(analysis: &Analysis, top: f64) -> Vec<HorizontalMark> {
    let mut marks: Vec<HorizontalMark> = Vec::new();
    for (index, condition) in analysis.spec.conditions.iter().enumerate() {
        for hertz in lines(&analysis.spec, index) {
            let is_new = marks.iter().all(|mark| (mark.y / hertz - 1.0).abs() > 1e-6);
            if hertz > 0.0 && hertz < top && is_new && marks.len() < LINES {
                marks.push(HorizontalMark {
                    y: hertz,
                    label: format!("{}, {} Hz", plain(&condition.name), digits(hertz)),
                });
            }
        }
    }
    marks
}
