//! Bars of total indices with their intervals, and of first-order ones below them.
//!
//! Next door: how figures are drawn (`coilsense_figure`), the page that holds them (`html`).

use coilsense_figure::{Axis, Bar, Bars, Colour, Figure, Panel};

use crate::report::prose::plain;
use crate::sensitivity::{Indices, Study, ranked};

/// Width of a panel \[px\].
const WIDTH: f64 = 760.0;

/// The indices of one column, the largest first.
pub(super) fn bars(study: &Study, found: &Indices) -> Figure {
    let bar = |(key, index): (&str, &crate::sensitivity::Index)| Bar {
        name: plain(key),
        value: index.total.value,
        second: Some(index.first.value.max(0.0)),
        interval: Some((index.total.lower, index.total.upper)),
        text: format!("{:.2}", index.total.value),
        group: "S_T, with others".to_owned(),
        colour: Colour::Blue,
    };
    let bars = Bars { bars: ranked(study, found).into_iter().map(bar).collect(), second: "S_1, alone".to_owned() };
    let height = bars.panel_height(WIDTH);
    let panel = Panel {
        x: Axis { label: "Share of the variance [1]".into(), ..Axis::default() },
        bars: Some(bars),
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: height }
}
