//! The paper's Figs. 2 and 4, in its line styles.
//!
//! Next door: the simulations (`case`), the drawing (`coilsense_figure`).

use coilsense::{Channel, Spring, transmittance};
use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, Mark, Panel, Scale, Stroke};

use super::{CaseResult, Condition, Reproduction};

/// A figure with its file name and what it shows.
#[derive(Debug, Clone)]
pub struct NamedFigure {
    /// File name without its extension.
    pub name: String,
    /// Caption.
    pub caption: String,
    /// The figure.
    pub figure: Figure,
}

/// Part of the judged window that Fig. 4 shows \[s\]: five periods of S_T's first mode.
const SHOWN: (f64, f64) = (0.9, 1.0);

/// Step of Fig. 2 \[Hz\]; finer than the paper's 1 Hz so that the flanks of the poles are smooth.
const STEP: f64 = 0.2;

impl Reproduction {
    /// Figs. 2 and 4, and Fig. 4 for S_A.
    pub fn figures(&self) -> Vec<NamedFigure> {
        let (name, spring) = self.springs.first();
        let mut figures = vec![transmittance_figure(name, spring)];
        for (name, _) in self.springs.each() {
            figures.push(self.force_figure(name));
        }
        figures
    }

    /// Fig. 4 for one spring: heel strike, end stop when extending, resonance.
    fn force_figure(&self, spring: &str) -> NamedFigure {
        let shown = [
            (Condition::HeelStrike, "(a) Heel strike"),
            (Condition::EndStopMax, "(b) End stop when extending"),
            (Condition::Resonance, "(c) Harmonic input at the first eigenfrequency, eq. (3)"),
        ];
        let panels =
            shown.into_iter().filter_map(|(condition, title)| Some(force_panel(self.case(spring, condition)?, title)));
        let touching = shown
            .into_iter()
            .any(|(condition, _)| self.case(spring, condition).is_some_and(|case| case.clash.happens()));
        let clash = if touching {
            " The windings of (c) have touched before: beyond that the curves are arithmetic, not a spring."
        } else {
            ""
        };
        NamedFigure {
            name: format!("figure-4-{spring}"),
            caption: format!(
                "Fig. 4 of the paper for {spring}: forces at both ends and by deflection and inductance, the last 0.1 s of 1 s.{clash}"
            ),
            figure: Figure { panels: panels.collect(), columns: 1, panel_width: 672.0, panel_height: 184.0 },
        }
    }
}

fn force_panel(result: &CaseResult, title: &str) -> Panel {
    let time = result.signals.time();
    let first = time.partition_point(|&t| t < SHOWN.0);
    let styles = [
        (Channel::OutputForce, Colour::Red, Dash::Solid, 1.4),
        (Channel::InputForce, Colour::Blue, Dash::DashDot, 1.4),
        (Channel::InductanceForce, Colour::Ink, Dash::Dashed, 1.4),
        // Last, so that its dots stay visible on the dashes of F_L.
        (Channel::DeflectionForce, Colour::Green, Dash::Dotted, 1.8),
    ];
    let curves = result.signals.channels().filter_map(|(channel, values)| {
        let (order, (_, colour, dash, width)) = styles.into_iter().enumerate().find(|(_, style)| style.0 == channel)?;
        let stroke = Stroke { colour, dash, width };
        let (x, y) = (time[first..].to_vec(), values[first..].to_vec());
        Some((order, Curve { label: channel.name().to_owned(), x, y, stroke }))
    });
    let mut curves: Vec<(usize, Curve)> = curves.collect();
    curves.sort_by_key(|(order, _)| *order);
    Panel {
        title: title.to_owned(),
        x: Axis { label: "Time [s]".to_owned(), range: Some(SHOWN), scale: Scale::Linear },
        y: Axis { label: "Force [N]".to_owned(), range: None, scale: Scale::Linear },
        curves: curves.into_iter().map(|(_, curve)| curve).collect(),
        ..Panel::default()
    }
}

fn transmittance_figure(name: &str, spring: &Spring) -> NamedFigure {
    let (masses, tau) = (spring.chain_masses(), spring.transit_time());
    let frequencies: Vec<f64> = (0..=995).map(|step| 1.0 + STEP * f64::from(step)).collect();
    let curve = |label: String, colour, dash, of: &dyn Fn(f64) -> f64| Curve {
        label,
        y: frequencies.iter().map(|hertz| of(std::f64::consts::TAU * hertz).abs()).collect(),
        x: frequencies.clone(),
        stroke: Stroke { colour, dash, width: 1.4 },
    };
    let poles = (0..4).map(|pole| f64::from(2 * pole + 1) * 0.25 / tau).filter(|hertz| *hertz < 200.0);
    let panel = Panel {
        title: String::new(),
        x: Axis { label: "Frequency [Hz]".to_owned(), range: Some((0.0, 200.0)), scale: Scale::Linear },
        y: Axis {
            label: "Transmittance |F_o / F_i| [–]".to_owned(), range: Some((0.5, 1000.0)), scale: Scale::Log10
        },
        curves: vec![
            curve(format!("chain of {masses} windings"), Colour::Red, Dash::Solid, &|omega| {
                transmittance::chain(masses, tau, omega)
            }),
            curve("eq. (1)".to_owned(), Colour::Blue, Dash::DashDot, &|omega| transmittance::continuous(tau, omega)),
        ],
        marks: poles.map(|hertz| Mark { x: hertz, label: format!("{hertz:.1} Hz") }).collect(),
        ..Panel::default()
    };
    NamedFigure {
        name: "figure-2".to_owned(),
        caption: format!(
            "Fig. 2 of the paper: transmittance of the chain of {name} against eq. (1), 1–200 Hz in steps of {STEP} Hz, far end clamped. \
             The poles are the fixed–free frequencies of eq. (1), not those of eq. (3); without damping they are infinitely high, and \
             how high they show depends on the step."
        ),
        figure: Figure { panels: vec![panel], columns: 1, panel_width: 560.0, panel_height: 330.0 },
    }
}
