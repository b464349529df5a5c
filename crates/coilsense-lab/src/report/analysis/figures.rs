//! The figures of an analysis: sensors ranked, spectra with surge lines, winding maps, budgets.
//!
//! Next door: how figures are drawn (`coilsense_figure`), the page that holds them (`html`).

use coilsense::Channel;
use coilsense::modes::ModalModel;
use coilsense_figure::{
    Axis, Band, Bar, Bars, Colour, Curve, Dash, Figure, HeatMap, Mark, MarkedCells, Panel, Scale, Stroke,
};

use crate::analysis::{Analysis, Case, Verdict};
use crate::quantity::digits;
use crate::report::page::typeset;
use crate::report::prose::plain;

/// Width of a figure \[px\].
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 300.0;
/// Surge lines that are drawn.
const LINES: usize = 8;
/// Most samples of a curve over the length.
const MOST_POINTS: usize = 6000;
/// Share of a length by which it may change and be said to rest.
const STILL: f64 = 1e-6;

/// The sensors by their combined uncertainty, best first, and the goal.
pub(super) fn ranking(analysis: &Analysis) -> Figure {
    let nominal = analysis.spec.spring.spring.nominal_force();
    let bar = |verdict: &Verdict| {
        let percent = 100.0 * verdict.combined() / nominal;
        let (group, colour) = match verdict.meets_always() {
            Some(false) => ("misses the goal", Colour::Red),
            Some(true) => ("meets the goal", Colour::Blue),
            None => ("", Colour::Blue),
        };
        let name = plain(&analysis.sensors[verdict.sensor].name);
        Bar {
            name,
            value: percent,
            text: format!("{} %", typeset(&digits(percent))),
            group: group.into(),
            colour,
            ..Bar::default()
        }
    };
    let goal = analysis.spec.goal.error.map(|error| Mark { x: 100.0 * error / nominal, label: "goal".into() });
    bars_figure(
        analysis.verdicts.iter().map(bar).collect(),
        "Combined standard uncertainty in the worst case [% of F_{nom}]",
        goal.into_iter().collect(),
    )
}

/// The lines of a sensor's budget, the largest first.
pub(super) fn budget(analysis: &Analysis, verdict: &Verdict) -> Figure {
    let nominal = analysis.spec.spring.spring.nominal_force();
    let budget = &verdict.budget.budget;
    let mut lines: Vec<(String, f64)> =
        budget.contributions().iter().map(|line| (line.name.to_string(), line.contribution)).collect();
    let bend = verdict.budget.bend;
    lines.push(("bias of the straight line, uncorrected".to_owned(), bend.abs()));
    lines.push(("bias of the oscillation, uncorrected".to_owned(), (budget.bias() - bend).abs()));
    lines.retain(|(_, newton)| *newton > 1e-9 * nominal);
    lines.sort_by(|a, b| b.1.total_cmp(&a.1));
    lines.push(("combined".to_owned(), verdict.combined()));
    let bar = |(name, newton): (String, f64)| {
        let percent = 100.0 * newton / nominal;
        let colour = if name == "combined" { Colour::Ink } else { Colour::Blue };
        Bar { name, value: percent, text: format!("{} %", typeset(&digits(percent))), colour, ..Bar::default() }
    };
    let goal = analysis.spec.goal.error.map(|error| Mark { x: 100.0 * error / nominal, label: "goal".into() });
    let axis = "Contribution to the standard uncertainty [% of F_{nom}]";
    bars_figure(lines.into_iter().map(bar).collect(), axis, goal.into_iter().collect())
}

fn bars_figure(bars: Vec<Bar>, label: &str, marks: Vec<Mark>) -> Figure {
    let bars = Bars { bars, second: String::new() };
    let panel_height = bars.panel_height(WIDTH);
    let reach = bars.bars.iter().map(|bar| bar.value).chain(marks.iter().map(|mark| mark.x)).fold(0.0, f64::max);
    // Room behind the longest bar for its number.
    let x = Axis { label: label.into(), range: Some((0.0, 1.12 * reach.max(1e-12))), ..Axis::default() };
    let panel = Panel { x, marks, bars: Some(bars), ..Panel::default() };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height }
}

/// Amplitudes of a condition's forces at one damping; the load-side force over all dampings as a band.
pub(super) fn spectra(analysis: &Analysis, condition: usize, shown: usize) -> Option<Figure> {
    let case = analysis.case(condition, shown)?;
    let nominal = analysis.spec.spring.spring.nominal_force();
    let lines = surge_lines(analysis);
    let rate = analysis.spec.conditions[condition].sample_rate;
    let highest = lines.last().map_or(0.5 * rate, |last| (1.1 * last).min(0.5 * rate));
    let percent = |amplitudes: &[f64]| -> Vec<f64> { amplitudes.iter().map(|a| 100.0 * a / nominal).collect() };
    let looks = [
        (Channel::OutputForce, Colour::Red, Dash::Solid),
        (Channel::InputForce, Colour::Blue, Dash::DashDot),
        (Channel::DeflectionForce, Colour::Green, Dash::Dotted),
        (Channel::InductanceForce, Colour::Ink, Dash::Dashed),
    ];
    let frequencies = spectrum(case, Channel::OutputForce)?.frequencies();
    let count = frequencies.partition_point(|frequency| *frequency <= highest).max(2);
    // The mean is no oscillation.
    let part = 1.min(count)..count;
    let curve = |(channel, colour, dash): (Channel, Colour, Dash)| {
        let y = percent(&spectrum(case, channel)?.amplitudes()[part.clone()]);
        let stroke = Stroke { colour, dash, width: 1.4 };
        Some(Curve { label: channel.name().into(), x: frequencies[part.clone()].to_vec(), y, stroke })
    };
    let curves: Vec<Curve> = looks.into_iter().filter_map(curve).collect();
    let peak = curves.iter().flat_map(|curve| &curve.y).fold(0.0_f64, |peak, y| peak.max(*y));
    let panel = Panel {
        x: Axis { label: "Frequency [Hz]".into(), range: Some((0.0, highest)), ..Axis::default() },
        y: Axis {
            label: "Amplitude [% of F_{nom}]".into(),
            range: Some((1e-5 * peak.max(1e-9), 2.0 * peak.max(1e-9))),
            scale: Scale::Log10,
        },
        bands: band(analysis, condition, &frequencies, part.clone()).into_iter().collect(),
        curves,
        marks: lines.iter().enumerate().map(|(j, x)| Mark { x: *x, label: format!("f_{}", j + 1) }).collect(),
        ..Panel::default()
    };
    Some(Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: HEIGHT })
}

/// F_o over all dampings, where there are several.
fn band(analysis: &Analysis, condition: usize, frequencies: &[f64], part: std::ops::Range<usize>) -> Option<Band> {
    let dampings = &analysis.spec.mount.cases;
    if dampings.len() < 2 {
        return None;
    }
    let nominal = analysis.spec.spring.spring.nominal_force();
    let of_damping = |damping: usize| {
        let amplitudes = spectrum(analysis.case(condition, damping)?, Channel::OutputForce)?.amplitudes();
        amplitudes.get(part.clone())
    };
    let all: Vec<&[f64]> = (0..dampings.len()).filter_map(of_damping).collect();
    let extreme = |pick: fn(f64, f64) -> f64, from: f64| -> Vec<f64> {
        let of_line = |index: usize| 100.0 / nominal * all.iter().map(|series| series[index]).fold(from, pick);
        (0..part.len()).map(of_line).collect()
    };
    Some(Band {
        label: format!("F_o, {} to {}", dampings[0].label, dampings[dampings.len() - 1].label),
        x: frequencies[part.clone()].to_vec(),
        lower: extreme(f64::min, f64::INFINITY),
        upper: extreme(f64::max, 0.0),
        colour: Colour::Red,
    })
}

fn spectrum(case: &Case, channel: Channel) -> Option<&coilsense::measures::Spectrum> {
    case.spectra.iter().find(|(of, _)| *of == channel).map(|(_, spectrum)| spectrum)
}

fn surge_lines(analysis: &Analysis) -> Vec<f64> {
    let modes = ModalModel::chain(&analysis.spec.spring.spring, analysis.spec.mount.far_end());
    modes.frequencies().iter().take(LINES).map(|angular| angular / std::f64::consts::TAU).collect()
}

/// Forces over the length, of a condition at one damping: a spring without mass stays on the line of F_x. `None` where the length rests.
pub(super) fn over_length(case: &Case) -> Option<Figure> {
    let part = case.judged.clone();
    let step = part.len().div_ceil(MOST_POINTS).max(1);
    let every = |values: &[f64]| -> Vec<f64> { values[part.clone()].iter().step_by(step).copied().collect() };
    let [first, second] = [Channel::U1, Channel::U2].map(|end| case.signals.channel(end).ok().map(every));
    let lengths: Vec<f64> = first?.iter().zip(second?).map(|(first, second)| 1e3 * (second - first)).collect();
    let bounds = lengths.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (at.min(low), at.max(high)));
    if bounds.1 - bounds.0 < STILL * bounds.1 {
        return None;
    }
    let looks = [
        (Channel::InputForce, Colour::Blue, Dash::Solid),
        (Channel::OutputForce, Colour::Red, Dash::Dashed),
        (Channel::DeflectionForce, Colour::Ink, Dash::Solid),
    ];
    let curve = |(channel, colour, dash): (Channel, Colour, Dash)| {
        let y = every(case.signals.channel(channel).ok()?);
        Some(Curve { label: channel.name().into(), x: lengths.clone(), y, stroke: Stroke { colour, dash, width: 1.2 } })
    };
    let panel = Panel {
        x: Axis { label: "Length [mm]".into(), ..Axis::default() },
        y: Axis { label: "Force [N]".into(), ..Axis::default() },
        curves: looks.into_iter().filter_map(curve).collect(),
        ..Panel::default()
    };
    Some(Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: HEIGHT })
}

/// How far each winding is from where it would lie in a spring without mass, over time.
pub(super) fn map(case: &Case) -> Option<Figure> {
    let frames = &case.frames;
    let (masses, count) = (frames.columns - 2, frames.times.len());
    if masses < 2 || count < 2 {
        return None;
    }
    let departures = frames.departures();
    // The map has a row per winding, the frames a row per moment.
    let values = (0..masses).flat_map(|winding| (0..count).map(move |frame| (winding, frame)));
    let values: Vec<f64> = values.map(|(winding, frame)| 1e3 * departures[frame * masses + winding]).collect();
    // Windings that lie on each other are apart by the contact pitch itself, to rounding.
    let pitch = case.clash.contact_pitch + if case.contacts.is_some() { 1e-9 } else { 0.0 };
    let touches = |winding: usize, frame: usize| {
        let row = frames.row(frame);
        // Pitches stand between x_i and x_{i+1}; a winding touches where either of its pitches does.
        let close = |left: usize| (1..masses).contains(&left) && row[left + 1] - row[left] < pitch;
        close(winding) || close(winding + 1)
    };
    let cells: Vec<bool> = (0..masses)
        .flat_map(|winding| (0..count).map(move |frame| (winding, frame)))
        .map(|(w, f)| touches(w, f))
        .collect();
    let marked = cells.contains(&true).then_some(MarkedCells { label: "windings touch".into(), cells });
    let step = frames.times[1] - frames.times[0];
    let heat = HeatMap {
        label: "Displacement [mm]".into(),
        rows: masses,
        values,
        x: (frames.times[0] - 0.5 * step, frames.times[count - 1] + 0.5 * step),
        y: (0.5, masses as f64 + 0.5),
        range: None,
        smooth: true,
        marked,
    };
    let panel = Panel {
        x: Axis { label: "Time [s]".into(), range: Some(heat.x), ..Axis::default() },
        y: Axis { label: "Winding, from end 1 [1]".into(), range: Some(heat.y), ..Axis::default() },
        heat: Some(heat),
        ..Panel::default()
    };
    Some(Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: HEIGHT })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::over_length;
    use crate::analysis::simulate;
    use crate::spec::Spec;

    #[test]
    fn force_over_length_is_drawn_where_the_length_moves_and_f_x_is_its_line() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/sea-ankle.toml");
        let spec = Spec::read(&file).unwrap();
        let spring = spec.spring.spring.clone();
        let number = |name: &str| spec.conditions.iter().position(|condition| condition.name == name).unwrap();
        let (held, moved) = (number("heel strike"), number("half resonance"));
        let cases = simulate(&spec, &|_, _| true).unwrap();
        let of = |condition: usize| cases.iter().find(|case| case.condition == condition && case.damping == 0).unwrap();
        assert!(over_length(of(held)).is_none(), "both ends rest");
        let panel = &over_length(of(moved)).unwrap().panels[0];
        let [input, _, by_length] = &panel.curves[..] else { panic!() };
        let off = |force: &f64, length: &f64| force - spring.stiffness() * (1e-3 * length - spring.rest_length());
        let largest = |y: &[f64]| y.iter().zip(&by_length.x).map(|(y, x)| off(y, x).abs()).fold(0.0, f64::max);
        assert!(largest(&by_length.y) < 1e-9 && largest(&input.y) > 0.5, "{}", largest(&input.y));
        let travel = by_length.x.iter().fold(0.0_f64, |most, x| most.max(*x))
            - by_length.x.iter().fold(1e9_f64, |least, x| least.min(*x));
        assert!(travel > 1.0, "{travel} mm");
    }
}
