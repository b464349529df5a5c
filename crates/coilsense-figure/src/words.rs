//! A figure in words, for those who do not see it.
//!
//! `svg` carries them as its title.

use crate::lettering::plain;
use crate::{Bar, Bars, Figure, Panel};

/// All panels, a sentence each.
pub(crate) fn of(figure: &Figure) -> String {
    let sentences: Vec<String> = figure.panels.iter().map(panel).collect();
    sentences.join(" ")
}

fn panel(panel: &Panel) -> String {
    let [title, x, y] = [&panel.title, &panel.x.label, &panel.y.label].map(|s| plain(s));
    let title = if title.is_empty() { title } else { format!("{title}: ") };
    if let Some(bars) = &panel.bars {
        return format!("{title}bars of {x}{}{}.", clause("; ", bars.bars.iter().map(bar)), second(bars));
    }
    let colour = panel.heat.as_ref().map(|heat| format!("{} in colour over ", plain(&heat.label)));
    let marked = panel.heat.iter().filter_map(|heat| heat.marked.as_ref());
    let parts = [
        clause("; ", panel.curves.iter().map(|curve| plain(&curve.label))),
        clause("; points: ", panel.points.iter().map(|points| plain(&points.label))),
        clause("; shaded: ", panel.bands.iter().map(|band| plain(&band.label))),
        clause("; limits: ", panel.limits.iter().map(|limit| plain(&limit.label))),
        clause("; marked: ", marked.map(|marked| plain(&marked.label))),
    ];
    format!("{title}{}{y} against {x}{}.", colour.unwrap_or_default(), parts.concat())
}

/// The names that are not empty, with what leads to them; nothing where there are none.
fn clause(lead: &str, names: impl Iterator<Item = String>) -> String {
    let names: Vec<String> = names.filter(|name| !name.is_empty()).collect();
    if names.is_empty() { String::new() } else { format!("{lead}{}", names.join(", ")) }
}

fn bar(bar: &Bar) -> String {
    let value = if bar.text.is_empty() { spoken(bar.value) } else { plain(&bar.text) };
    let group = if bar.group.is_empty() { String::new() } else { format!(" ({})", plain(&bar.group)) };
    format!("{} {value}{group}", plain(&bar.name))
}

fn spoken(value: f64) -> String {
    match value.abs() {
        0.0 | 1e-2..1e5 => format!("{value:.3}"),
        size if size.is_finite() => format!("{value:.3e}"),
        _ => "without a value".to_owned(),
    }
}

fn second(bars: &Bars) -> String {
    let compared = bars.bars.iter().any(|bar| bar.second.is_some()) && !bars.second.is_empty();
    if compared { format!("; beside them {}", plain(&bars.second)) } else { String::new() }
}
