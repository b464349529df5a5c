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
const KINDS: [(&str, Colour, Dash); 3] = [
    ("axial", Colour::Red, Dash::Solid),
    ("torsional", Colour::Green, Dash::DashDot),
    ("lateral", Colour::Blue, Dash::Dashed),
];

/// The figure; `None` where the coil is no helix.
pub(super) fn modes(analysis: &Analysis) -> Option<Figure> {
    let spec = &analysis.spec;
    let all = spec.spring.helix(&spec.mount.ends).and_then(|coil| coil.over_lengths(LENGTHS)).ok()?;
    let highest = all.iter().flat_map(ModesAt::ways).map(|way| way.first_surge_hz);
    let top = REACH * highest.fold(0.0, f64::max);
    let lengths: Vec<f64> = all.iter().map(|at| 1e3 * at.length_m).collect();
    let (mut curves, mut bands) = (Vec::new(), Vec::new());
    for (kind, colour, dash) in KINDS {
        let held = families(all.iter().map(|at| &at.held), kind, top);
        let loosest = families(all.iter().filter_map(|at| at.loosest.as_ref()), kind, top);
        for (order, y) in held.iter().enumerate() {
            let label = if order == 0 { kind.to_owned() } else { String::new() };
            curves.push(Curve { label, x: lengths.clone(), y: y.clone(), stroke: Stroke { colour, dash, width: 1.6 } });
            if let Some(lower) = loosest.get(order).filter(|lower| lower.len() == y.len()) {
                let label = if order == 0 { format!("{kind}, to the loosest ends") } else { String::new() };
                bands.push(Band { label, x: lengths.clone(), lower: lower.clone(), upper: y.clone(), colour });
            }
        }
    }
    let panel = Panel {
        x: Axis {
            label: "Length [mm]".into(),
            range: Some((lengths[0], lengths[lengths.len() - 1])),
            ..Axis::default()
        },
        y: Axis { label: "Frequency [Hz]".into(), range: Some((0.0, top)), ..Axis::default() },
        curves,
        bands,
        limits: driven(analysis, top),
        ..Panel::default()
    };
    Some(Figure { panels: vec![panel], columns: 1, panel_width: 760.0, panel_height: 340.0 })
}

/// The n-th frequency of a kind over the lengths, as long as one lies below `top`; not a number where there is none.
fn families<'a>(ways: impl Iterator<Item = &'a UnderEnds>, kind: &str, top: f64) -> Vec<Vec<f64>> {
    let each: Vec<Vec<f64>> = ways
        .map(|way| way.modes.iter().filter(|mode| mode.kind == kind).map(|mode| mode.frequency_hz).collect())
        .collect();
    let most = each.iter().map(Vec::len).max().unwrap_or(0);
    let of_order = |order: usize| -> Vec<f64> {
        each.iter()
            .map(|of_length| of_length.get(order).copied().filter(|hertz| *hertz < top).unwrap_or(f64::NAN))
            .collect()
    };
    (0..most).map(of_order).take_while(|values| values.iter().any(|value| value.is_finite())).collect()
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
