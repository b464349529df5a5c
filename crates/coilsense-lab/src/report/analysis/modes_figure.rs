//! Modes of the coil against its length, with what drives it across them.
//!
//! Next door: the other figures of an analysis (`figures`), the modes (`crate::helix`).

use coilsense_figure::{Axis, Band, Colour, Curve, Dash, Figure, HorizontalMark, Panel, Stroke};

use crate::analysis::{Analysis, driven as driven_lines};
use crate::helix::{BandOfKind, CurveOfKind};
use crate::quantity::digits;
use crate::report::prose::plain;

/// Lengths at which modes are found.
const LENGTHS: usize = 25;
/// A band that is nowhere wider than this is drawn as its line \[1\].
const WIDE: f64 = 1.02;
/// Lines of the input that are drawn.
const LINES: usize = 6;
/// Kinds with their looks, in the order of the legend.
const LOOKS: [(&str, Colour, Dash); 4] = [
    ("axial", Colour::Red, Dash::Solid),
    ("torsional", Colour::Green, Dash::DashDot),
    ("lateral", Colour::Blue, Dash::Dashed),
    ("mixed", Colour::Ink, Dash::Dotted),
];

/// The figure; `None` where the coil is no helix.
pub(super) fn modes(analysis: &Analysis) -> Option<Figure> {
    let spec = &analysis.spec;
    let lines = spec.spring.helix(&spec.mount.ends).and_then(|coil| coil.lines(LENGTHS)).ok()?;
    let lengths: Vec<f64> = lines.lengths.iter().map(|length| 1e3 * length).collect();
    let panel = Panel {
        x: Axis {
            label: "Length [mm]".into(),
            range: Some((lengths[0], lengths[lengths.len() - 1])),
            ..Axis::default()
        },
        y: Axis { label: "Frequency [Hz]".into(), range: Some((0.0, lines.top)), ..Axis::default() },
        curves: LOOKS.iter().flat_map(|look| of_kind(&lines.ways[0].curves, look, &lengths)).collect(),
        bands: LOOKS.iter().flat_map(|look| loosest(&lines.bands, look, &lengths)).collect(),
        limits: driven(analysis, lines.top),
        ..Panel::default()
    };
    Some(Figure { panels: vec![panel], columns: 1, panel_width: 760.0, panel_height: 340.0 })
}

/// The curves of a kind, the ends at their tightest; the first is in the legend.
fn of_kind(all: &[CurveOfKind], (kind, colour, dash): &(&str, Colour, Dash), lengths: &[f64]) -> Vec<Curve> {
    let stroke = Stroke { colour: *colour, dash: *dash, width: 1.6 };
    let label = |index: usize| if index == 0 { (*kind).to_owned() } else { String::new() };
    let each = all.iter().filter(|curve| curve.kind == *kind).enumerate();
    let curve = |(index, of): (usize, &CurveOfKind)| {
        let (x, y) = (lengths.to_vec(), of.frequency.clone());
        Curve { label: label(index), x, y, stroke }
    };
    each.map(curve).collect()
}

/// How far down the lines of a kind come where the ends are looser.
fn loosest(all: &[BandOfKind], (kind, colour, _): &(&str, Colour, Dash), lengths: &[f64]) -> Vec<Band> {
    let label = |index: usize| if index == 0 { format!("{kind}, down to the loosest ends") } else { String::new() };
    let each = all.iter().filter(|band| band.kind == *kind && is_wide(band)).enumerate();
    let band = |(index, of): (usize, &BandOfKind)| Band {
        label: label(index),
        x: lengths.to_vec(),
        lower: of.lower.clone(),
        upper: of.upper.clone(),
        colour: *colour,
    };
    each.map(band).collect()
}

/// Whether a band is wider than a line anywhere.
fn is_wide(band: &BandOfKind) -> bool {
    band.lower.iter().zip(&band.upper).any(|(lower, upper)| *upper > WIDE * lower)
}

/// What drives the ends, as far as there is room for it.
fn driven(analysis: &Analysis, top: f64) -> Vec<HorizontalMark> {
    let name = |condition: usize| plain(&analysis.spec.conditions[condition].name);
    let mark =
        |(condition, y): (usize, f64)| HorizontalMark { y, label: format!("{}, {} Hz", name(condition), digits(y)) };
    driven_lines(&analysis.spec).into_iter().filter(|(_, hertz)| *hertz < top).take(LINES).map(mark).collect()
}
