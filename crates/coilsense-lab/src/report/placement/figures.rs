//! The figures of a placement: Bode, Nyquist and rendered impedance of the nominal spring, the step over time.
//!
//! Next door: how figures are drawn (`coilsense_figure`), the page that holds them (`html`).

use std::f64::consts::TAU;

use coilsense::control::{Point, rendered_stiffness};
use coilsense::{Channel, Error};
use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, HorizontalMark, Mark, Panel, Scale, Stroke};

use crate::placement::Placement;

/// Width and height of a panel \[px\].
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 260.0;
/// How many times the set crossover's neighbourhood is shown below it.
const DECADES_BELOW: f64 = 100.0;

const LOOKS: [(Channel, Colour, Dash); 4] = [
    (Channel::InputForce, Colour::Blue, Dash::Solid),
    (Channel::OutputForce, Colour::Red, Dash::Dashed),
    (Channel::DeflectionForce, Colour::Green, Dash::DashDot),
    (Channel::InductanceForce, Colour::Ink, Dash::Dotted),
];

/// Each force's loop response at the shown damping.
pub(super) struct Traces(Vec<(Channel, Colour, Dash, Vec<Point>)>);

impl Traces {
    pub fn of(placement: &Placement) -> Result<Self, Error> {
        let traced = LOOKS.map(|(channel, colour, dash)| {
            let looped = placement.force_loop(placement.shown(), channel)?;
            Ok((channel, colour, dash, looped.trace()?.points().to_vec()))
        });
        traced.into_iter().collect::<Result<_, _>>().map(Self)
    }
}

fn stroke(colour: Colour, dash: Dash) -> Stroke {
    Stroke { colour, dash, width: 1.5 }
}

fn surge_marks(placement: &Placement, up_to: f64) -> Vec<Mark> {
    let first = placement.spec.spring.spring.surge_frequency();
    let each = (1..=4).map(|n| Mark { x: f64::from(n) * first, label: format!("f_{n}") });
    each.filter(|mark| mark.x < up_to).collect()
}

/// |L| and its phase.
pub(super) fn bode(placement: &Placement, traces: &Traces) -> Figure {
    let surge = placement.spec.spring.spring.surge_frequency();
    let (from, to) = ((placement.crossover.min(surge)) / DECADES_BELOW, 5.0 * surge);
    let in_range = |point: &&Point| (from..=to).contains(&(point.angular_frequency / TAU));
    let curve = |pick: fn(&[Point]) -> Vec<f64>| {
        let each = traces.0.iter().map(|(channel, colour, dash, points)| {
            let points: Vec<Point> = points.iter().filter(in_range).copied().collect();
            Curve {
                label: channel.name().into(),
                x: points.iter().map(|point| point.angular_frequency / TAU).collect(),
                y: pick(&points),
                stroke: stroke(*colour, *dash),
            }
        });
        each.collect::<Vec<_>>()
    };
    let x = Axis { label: "Frequency [Hz]".into(), range: Some((from, to)), scale: Scale::Log10 };
    let size = Panel {
        title: "Loop response as set".into(),
        x: x.clone(),
        y: Axis { label: "|L| [1]".into(), scale: Scale::Log10, ..Axis::default() },
        curves: curve(|points| points.iter().map(|point| point.response.norm()).collect()),
        limits: vec![HorizontalMark { y: 1.0, label: "1".into() }],
        marks: surge_marks(placement, to),
        ..Panel::default()
    };
    let phase = Panel {
        x,
        y: Axis { label: "Phase [°]".into(), range: Some((-540.0, 90.0)), ..Axis::default() },
        curves: curve(unwrapped),
        limits: vec![HorizontalMark { y: -180.0, label: "−180°".into() }],
        ..Panel::default()
    };
    Figure { panels: vec![size, phase], columns: 1, panel_width: WIDTH, panel_height: HEIGHT }
}

/// F_o over its reference with the loop closed, for each force with which it is stable; `None` where it is with none.
pub(super) fn tracking(placement: &Placement) -> Result<Option<Figure>, Error> {
    let (surge, shown) = (placement.spec.spring.spring.surge_frequency(), placement.shown());
    let (from, to) = (placement.crossover.min(surge) / DECADES_BELOW, 5.0 * surge);
    let is_stable = |channel: Channel| {
        let candidate = placement.nominal.iter().find(|candidate| candidate.channel == channel);
        candidate.is_some_and(|candidate| candidate.judged[shown].margins.stable)
    };
    let of = |(channel, colour, dash): &(Channel, Colour, Dash)| {
        let in_range = |point: &Point| (from..=to).contains(&(point.angular_frequency / TAU));
        let points: Vec<Point> = placement.tracking(shown, *channel)?.into_iter().filter(in_range).collect();
        let x: Vec<f64> = points.iter().map(|point| point.angular_frequency / TAU).collect();
        let curve = |label: &str, y| Curve { label: label.into(), x: x.clone(), y, stroke: stroke(*colour, *dash) };
        let size = points.iter().map(|point| point.response.norm()).collect();
        Ok([curve(channel.name(), size), curve(channel.name(), unwrapped(&points))])
    };
    let stable = LOOKS.iter().filter(|(channel, ..)| is_stable(*channel));
    let (sizes, phases): (Vec<Curve>, Vec<Curve>) = stable
        .map(of)
        .collect::<Result<Vec<[Curve; 2]>, Error>>()?
        .into_iter()
        .map(|[size, phase]| (size, phase))
        .unzip();
    if sizes.is_empty() {
        return Ok(None);
    }
    let x = Axis { label: "Frequency [Hz]".into(), range: Some((from, to)), scale: Scale::Log10 };
    let size = Panel {
        title: "Tracking: F_o over its reference, loop closed".into(),
        x: x.clone(),
        y: Axis { label: "|F_o/reference| [1]".into(), scale: Scale::Log10, ..Axis::default() },
        curves: sizes,
        limits: vec![HorizontalMark { y: 1.0, label: "1".into() }],
        marks: surge_marks(placement, to),
        ..Panel::default()
    };
    let phase = Panel {
        x,
        y: Axis { label: "Phase [°]".into(), range: Some((-540.0, 90.0)), ..Axis::default() },
        curves: phases,
        ..Panel::default()
    };
    Ok(Some(Figure { panels: vec![size, phase], columns: 1, panel_width: WIDTH, panel_height: HEIGHT }))
}

/// Phase without jumps [°].
fn unwrapped(points: &[Point]) -> Vec<f64> {
    let mut phases: Vec<f64> = Vec::with_capacity(points.len());
    for (index, point) in points.iter().enumerate() {
        let phase = match index {
            0 => point.response.arg(),
            _ => phases[index - 1] + (point.response / points[index - 1].response).arg(),
        };
        phases.push(phase);
    }
    phases.into_iter().map(f64::to_degrees).collect()
}

/// L(jω) about −1.
pub(super) fn nyquist(traces: &Traces) -> Figure {
    let reach = 3.0;
    let curve = |(channel, colour, dash, points): &(Channel, Colour, Dash, Vec<Point>)| {
        // What is far out only leads in and out of the picture.
        let near = |value: f64| value.clamp(-20.0 * reach, 20.0 * reach);
        Curve {
            label: channel.name().into(),
            x: points.iter().map(|point| near(point.response.re)).collect(),
            y: points.iter().map(|point| near(point.response.im)).collect(),
            stroke: stroke(*colour, *dash),
        }
    };
    let turn = (0..=90).map(|step| TAU * f64::from(step) / 90.0);
    let circle = Curve {
        label: "sensitivity 2".into(),
        x: turn.clone().map(|angle| -1.0 + 0.5 * angle.cos()).collect(),
        y: turn.map(|angle| 0.5 * angle.sin()).collect(),
        stroke: Stroke { colour: Colour::Ink, dash: Dash::Solid, width: 0.8 },
    };
    let axis = |label: &str| Axis { label: label.into(), range: Some((-reach, reach)), ..Axis::default() };
    let panel = Panel {
        title: "Nyquist: the loop is unstable where its curve goes round −1".into(),
        equal_units: true,
        x: axis("Re L [1]"),
        y: axis("Im L [1]"),
        curves: traces.0.iter().map(curve).chain([circle]).collect(),
        marks: vec![Mark { x: -1.0, label: "−1".into() }],
        limits: vec![HorizontalMark { y: 0.0, label: String::new() }],
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: 520.0, panel_height: 480.0 }
}

/// Most points of a curve over time, and how far F_o is followed, over the step \[%\].
const MOST_POINTS: usize = 4000;
const FOLLOWED: [f64; 2] = [-1.0, 3.0];
/// Looks of what is estimated.
const ESTIMATES: [(Colour, Dash); 2] = [(Colour::Blue, Dash::Dotted), (Colour::Red, Dash::Dotted)];

/// A series over time, in % of F_nom; a loop that grows is followed out of the picture and no further.
fn followed(placement: &Placement, label: String, times: &[f64], series: &[f64], look: (Colour, Dash)) -> Curve {
    let nominal = placement.spec.spring.spring.nominal_force();
    let stride = times.len().div_ceil(MOST_POINTS).max(1);
    let points = times.iter().zip(series).step_by(stride).map(|(time, force)| (*time, 100.0 * force / nominal));
    let (x, y) = points.take_while(|(_, force)| (10.0 * FOLLOWED[0]..10.0 * FOLLOWED[1]).contains(force)).unzip();
    Curve { label, x, y, stroke: stroke(look.0, look.1) }
}

fn over_time(title: String, curves: Vec<Curve>) -> Figure {
    let within = |curve: &Curve| curve.y.iter().all(|force| (FOLLOWED[0]..FOLLOWED[1]).contains(force));
    let range = if curves.iter().all(within) { None } else { Some((FOLLOWED[0], FOLLOWED[1])) };
    let panel = Panel {
        title,
        x: Axis { label: "Time [s]".into(), ..Axis::default() },
        y: Axis { label: "Force less its mean [% of F_{nom}]".into(), range, ..Axis::default() },
        curves,
        limits: vec![HorizontalMark { y: 1.0, label: "reference".into() }],
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: HEIGHT }
}

/// The best loop over time; `None` where it was not run.
pub(super) fn step(placement: &Placement) -> Option<Figure> {
    let best = placement.best_run();
    let run = best.shown.as_ref().ok()?;
    let fed = best.fed_back;
    let load = followed(placement, "F_o, at the load".into(), &run.time, &run.output, (Colour::Red, Dash::Solid));
    let look = (Colour::Blue, Dash::Dashed);
    let fed_back = followed(placement, format!("{fed}, fed back"), &run.time, &run.fed_back, look);
    Some(over_time(format!("A step of the reference, 1 % of F_{{nom}}, with {fed} fed back"), vec![load, fed_back]))
}

/// F_o by what is fed back; `None` where nothing was run.
pub(super) fn steps(placement: &Placement) -> Option<Figure> {
    let looks = LOOKS.iter().map(|(_, colour, dash)| (*colour, *dash)).chain(ESTIMATES);
    let shown = placement.runs.iter().zip(looks).filter_map(|(run, look)| Some((run, run.shown.as_ref().ok()?, look)));
    let curves: Vec<Curve> = shown
        .map(|(run, shown, look)| followed(placement, run.fed_back.into(), &shown.time, &shown.output, look))
        .collect();
    (!curves.is_empty()).then(|| over_time("F_o under the same step, by what is fed back".into(), curves))
}

/// Real part of the rendered impedance over the wave impedance.
pub(super) fn rendered(placement: &Placement) -> Result<Figure, Error> {
    let (spring, up_to) = (&placement.spec.spring.spring, placement.control.passive_up_to);
    let from = 1e-2 * up_to;
    let frequencies: Vec<f64> = (0..1500).map(|index| from * (up_to / from).powf(f64::from(index) / 1499.0)).collect();
    let mut curves = Vec::new();
    for (channel, colour, dash) in &LOOKS[..3] {
        let looped = placement.force_loop(placement.shown(), *channel)?;
        let real = |frequency: &f64| {
            let stiffness = rendered_stiffness(&looped, TAU * frequency)?;
            Ok::<f64, Error>(stiffness.im / (TAU * frequency) / spring.wave_impedance())
        };
        let y = frequencies.iter().map(real).collect::<Result<Vec<_>, _>>()?;
        curves.push(Curve { label: channel.name().into(), x: frequencies.clone(), y, stroke: stroke(*colour, *dash) });
    }
    let panel = Panel {
        title: "Real part of the rendered impedance: below zero it could give energy away".into(),
        x: Axis { label: "Frequency [Hz]".into(), range: Some((from, up_to)), scale: Scale::Log10 },
        y: Axis { label: "Re(F_o/v_2) / \u{221a}(km) [1]".into(), range: Some((-3.0, 6.0)), ..Axis::default() },
        curves,
        limits: vec![HorizontalMark { y: 0.0, label: "passive".into() }],
        marks: surge_marks(placement, up_to),
        ..Panel::default()
    };
    Ok(Figure { panels: vec![panel], columns: 1, panel_width: WIDTH, panel_height: HEIGHT })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use coilsense::Channel;

    use super::tracking;
    use crate::placement::Placement;
    use crate::spec::Spec;

    #[test]
    fn tracking_begins_at_one_peaks_as_judged_and_leaves_unstable_loops_out() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/sea-ankle.toml");
        let placement = Placement::of(Spec::read(&file).unwrap()).unwrap();
        let figure = tracking(&placement).unwrap().unwrap();
        let stable: Vec<_> =
            placement.nominal.iter().filter(|one| one.judged[placement.shown()].margins.stable).collect();
        assert!(stable.iter().all(|one| one.channel != Channel::OutputForce) && stable.len() > 1);
        assert_eq!(figure.panels[0].curves.len(), stable.len());
        for candidate in stable {
            let curve = figure.panels[0].curves.iter().find(|curve| curve.label == candidate.channel.name()).unwrap();
            assert!((curve.y[0] - 1.0).abs() < 1e-3, "{}: {}", curve.label, curve.y[0]);
            let [_, load] = candidate.judged[placement.shown()].peaks.unwrap();
            let largest = curve.y.iter().fold(0.0_f64, |most, y| most.max(*y));
            // Where nothing rises above the static one, the figure begins a little above its frequency.
            assert!((largest / load.size - 1.0).abs() < 1e-4, "{}: {largest} for {}", curve.label, load.size);
        }
    }
}
