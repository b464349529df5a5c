//! What a figure must keep: peaks, gaps, ticks, words, and the size of its files.

mod parts;
mod places;
mod points;

use super::drawing::{Frame, Point};
use super::ruler::Ruler;
use super::stroke::Rgb;
use super::ticks::ticks;
use super::*;

const STROKE: Stroke = Stroke { colour: Colour::Red, dash: Dash::DashDot, width: 1.4 };

const FRAME: Frame = Frame { left: 50.0, top: 10.0, width: 400.0, height: 200.0 };

fn axis(label: &str, range: Option<(f64, f64)>, scale: Scale) -> Axis {
    Axis { label: label.into(), range, scale }
}

fn curve(label: &str, x: Vec<f64>, y: Vec<f64>) -> Curve {
    Curve { label: label.into(), x, y, stroke: STROKE }
}

/// A force ringing at 54 Hz with harmonics, 2500 samples over 0.25 s.
fn ringing(label: &str, phase: f64) -> Curve {
    let x: Vec<f64> = (0..2500).map(|index| 0.75 + 1e-4 * f64::from(index)).collect();
    let tone = |t: f64, n: f64| (n * (std::f64::consts::TAU * 54.0 * t + phase)).sin() / n;
    let y = x.iter().map(|t| 96.0 + (0..20).map(|n| tone(*t, f64::from(2 * n + 1))).sum::<f64>());
    let y = y.collect();
    curve(label, x, y)
}

fn figure(curves: Vec<Curve>) -> Figure {
    let panel = Panel {
        title: "(a) bearing & clamp".into(),
        x: axis("Time [s]", None, Scale::Linear),
        y: axis("Force [N]", None, Scale::Linear),
        curves,
        marks: vec![Mark { x: 0.8, label: "t_1".into() }],
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: 336.0, panel_height: 240.0 }
}

/// Runs of a curve on a 400 px by 200 px frame that spans 0 to 1 both ways.
fn runs_on_unit_frame(curve: &Curve) -> Vec<Vec<Point>> {
    let unit = Ruler { lower: 0.0, upper: 1.0, scale: Scale::Linear };
    trace::runs(curve, &unit, &unit, &FRAME)
}

fn decoded_size(file: &[u8]) -> (u32, u32) {
    let mut reader = ::png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
    let mut dots = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut dots).unwrap();
    assert_eq!(&dots[..3], &[255, 255, 255], "the corner is white paper");
    assert!(dots.contains(&0), "something is drawn in black");
    (info.width, info.height)
}

#[test]
fn a_single_spike_survives_thinning() {
    let count = 100_000;
    let x: Vec<f64> = (0..count).map(|i| f64::from(i) / f64::from(count)).collect();
    let mut y: Vec<f64> = x.iter().map(|x| 0.5 + 0.1 * (900.0 * x).sin()).collect();
    (y[31_415], y[92_653]) = (0.95, 0.05);
    let run = runs_on_unit_frame(&curve("", x, y)).concat();
    let highest = run.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min);
    let lowest = run.iter().map(|point| point[1]).fold(0.0, f64::max);
    // Extremes are kept as they are; 1e-9 px is the rounding of the mapping.
    assert!((highest - FRAME.at(0.0, 0.95)[1]).abs() < 1e-9, "highest at {highest} px");
    assert!((lowest - FRAME.at(0.0, 0.05)[1]).abs() < 1e-9, "lowest at {lowest} px");
    assert!(run.len() <= 4 * 400, "four points per pixel column at most, got {}", run.len());
}

#[test]
fn points_on_a_straight_line_are_not_repeated() {
    let x: Vec<f64> = (0..500).map(|i| f64::from(i) / 499.0).collect();
    let run = runs_on_unit_frame(&curve("", x.clone(), x)).concat();
    // Points are judged in stretches of 64, whose ends stay.
    assert!(run.len() <= 500 / 64 + 2, "{} points", run.len());
    assert_eq!(run[0], FRAME.at(0.0, 0.0));
    assert_eq!(run[run.len() - 1], FRAME.at(1.0, 1.0));
}

#[test]
fn values_that_are_not_finite_break_the_line() {
    let nan = f64::NAN;
    let x: Vec<f64> = (0..9).map(|i| f64::from(i) / 8.0).collect();
    let y = vec![0.1, 0.9, nan, 0.5, nan, nan, 0.2, f64::INFINITY, 0.4];
    let runs = runs_on_unit_frame(&curve("", x, y));
    let lengths: Vec<usize> = runs.iter().map(Vec::len).collect();
    assert_eq!(lengths, [2, 2, 2, 1 + 1], "a lone sample shows as a short dash");
    assert!(runs.concat().iter().flatten().all(|pixel| pixel.is_finite()));
}

#[test]
fn values_beyond_all_reason_do_no_harm() {
    let y = vec![-1e308, 1e308, 0.5, 1e300, f64::MAX, f64::MIN];
    let x = (0..6).map(|i| f64::from(i) / 5.0).collect();
    for [x, y] in runs_on_unit_frame(&curve("", x, y)).concat() {
        // 1e-6 px: what the far ends, 1e9 px away, leave of double precision.
        assert!(x >= FRAME.left - 1e-6 && x <= FRAME.right() + 1e-6, "x at {x} px");
        assert!(y >= FRAME.top - 1e-6 && y <= FRAME.bottom() + 1e-6, "y at {y} px");
    }
}

#[test]
fn a_line_is_cut_where_it_leaves_the_axes() {
    let runs = runs_on_unit_frame(&curve("", vec![0.0, 0.5, 1.0], vec![0.5, 1.5, 0.5]));
    let expected = [vec![FRAME.at(0.0, 0.5), FRAME.at(0.25, 1.0)], vec![FRAME.at(0.75, 1.0), FRAME.at(1.0, 0.5)]];
    assert_eq!(runs, expected);
}

#[test]
fn svg_scales_and_says_what_it_shows() {
    let svg = figure(vec![ringing("F_o", 0.0)]).to_svg(Theme::Light).unwrap();
    assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 336 "));
    let words = "(a) bearing &amp; clamp: Force [N] against Time [s]; Fo.";
    assert!(svg.contains(&format!("role=\"img\" aria-label=\"{words}\"")));
    assert!(svg.contains(&format!("<title>{words}</title>")));
    assert!(svg.contains(">Time [s]</text>") && svg.contains(">Force [N]</text>"));
    assert!(svg.contains(">F<tspan dy=\"2.4\" font-size=\"8.88\">o</tspan></text>"));
    assert!(svg.contains("max-width:100%") && svg.contains("sans-serif"));
    assert!(!svg.contains(" id=") && !svg.contains("NaN"), "many figures share one page");
    assert!(svg.contains("stroke-dasharray=\"9.1 2.8 1.82 2.8\""));
}

#[test]
fn each_name_stands_once_in_the_legend() {
    let mut double = figure(vec![ringing("F_o", 0.0), ringing("F_i", 1.0)]);
    double.panels.push(double.panels[0].clone());
    double.columns = 2;
    let svg = double.to_svg(Theme::Dark).unwrap();
    assert_eq!(svg.matches(">o</tspan>").count(), 1);
    assert_eq!(svg.matches(">Force [N]</text>").count(), 1, "neighbours share the axis label");
    assert_eq!(svg.matches(">Time [s]</text>").count(), 2, "columns do not");
}

#[test]
fn twelve_ringing_curves_stay_below_150_kb() {
    let names = ["F_o", "F_i", "F_x", "F_L"];
    let mut tall = figure(names.iter().zip([0.0, 1.0, 2.0, 3.0]).map(|(n, p)| ringing(n, p)).collect());
    tall.panels = vec![tall.panels[0].clone(); 3];
    tall.panel_width = 672.0;
    let size = tall.to_svg(Theme::Light).unwrap().len();
    assert!(size < 150_000, "{size} bytes");
}

#[test]
fn png_has_two_dots_per_pixel_on_white() {
    let figure = figure(vec![ringing("F_o", 0.0)]);
    let file = figure.to_png(Theme::Light).unwrap();
    // The legend's one row is 26 px high.
    assert_eq!(decoded_size(&file), (2 * 336, 2 * (240 + 26)));
}

#[test]
fn log_axis_refuses_zero_and_below() {
    let mut log = figure(vec![ringing("F_o", 0.0)]);
    log.panels[0].y = axis("Gain", Some((0.0, 10.0)), Scale::Log10);
    let error = log.to_svg(Theme::Light).unwrap_err();
    assert_eq!(error, PlotError::LogRange { label: "Gain".into(), lower: 0.0, upper: 10.0 });
    assert_eq!(error.to_string(), "range of logarithmic axis `Gain` must be above zero, got 0 to 10");
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let good = figure(vec![ringing("F_o", 0.0)]);
    let refusal = |change: &dyn Fn(&mut Figure)| {
        let mut bad = good.clone();
        change(&mut bad);
        bad.to_png(Theme::Light).unwrap_err()
    };
    let empty = refusal(&|figure| figure.columns = 0);
    assert_eq!(empty, PlotError::Empty { panels: 1, columns: 0 });
    let uneven = refusal(&|figure| figure.panels[0].curves[0].y.truncate(7));
    assert_eq!(uneven, PlotError::Lengths { label: "F_o".into(), x: 2500, y: 7 });
    let falling = refusal(&|figure| figure.panels[0].x.range = Some((1.0, 0.5)));
    assert!(matches!(falling, PlotError::Range { .. }));
    let endless = refusal(&|figure| figure.panels[0].x.range = Some((-1e308, 1e308)));
    assert!(matches!(endless, PlotError::Range { .. }));
    let tiny = refusal(&|figure| figure.panels[0].x.range = Some((1.0, 1.0 + 1e-15)));
    assert!(matches!(tiny, PlotError::Range { .. }));
    let thin = refusal(&|figure| figure.panels[0].curves[0].stroke.width = 0.0);
    assert_eq!(thin, PlotError::Width { label: "F_o".into(), width: 0.0 });
    let nothing = refusal(&|figure| figure.panels[0].curves.clear());
    assert_eq!(nothing, PlotError::NoData { label: "Time [s]".into() });
    let huge = refusal(&|figure| {
        (figure.panel_width, figure.panel_height) = (19_000.0, 19_000.0);
    });
    assert!(matches!(huge, PlotError::Png(_)));
    for width in [80.0, f64::NAN, 1e9] {
        let size = refusal(&|figure| figure.panel_width = width);
        assert!(matches!(size, PlotError::Size { .. }), "{width} px");
    }
}

#[test]
fn ticks_are_round_and_within_the_range() {
    let labels = |lower: f64, upper: f64, scale| {
        let ruler = Ruler { lower, upper, scale };
        let found = ticks(&ruler, 7);
        assert!(found.major.iter().all(|(share, _)| Ruler::holds(*share)));
        assert!(found.minor.iter().all(|share| Ruler::holds(*share)));
        found.major.into_iter().map(|(_, label)| label).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(labels(0.75, 1.0, Scale::Linear), "0.75 0.80 0.85 0.90 0.95 1.00");
    assert_eq!(labels(-2.5, 2.5, Scale::Linear), "−2 −1 0 1 2");
    assert_eq!(labels(0.0, 4e-5, Scale::Linear), "0 1·10^{−5} 2·10^{−5} 3·10^{−5} 4·10^{−5}");
    assert_eq!(labels(-2.0, 1.0, Scale::Log10), "10^{−2} 10^{−1} 10^{0} 10^{1}");
    assert_eq!(labels(-20.0, 0.0, Scale::Log10), "10^{−18} 10^{−15} 10^{−12} 10^{−9} 10^{−6} 10^{−3} 10^{0}");
    assert_eq!(labels(-0.31, 1.01, Scale::Log10), "0.5 1 2 5 10");
    assert_eq!(labels(20f64.log10(), 45f64.log10(), Scale::Log10), "20 25 30 35 40 45");
}

#[test]
fn markup_is_lowered_raised_or_escaped() {
    assert_eq!(lettering::plain(r"F_o 10^{-3} a\_b"), "Fo 10-3 a_b");
    let raised = lettering::width("10^{-3}", 12.0);
    assert!(raised < lettering::width("10-3", 12.0) && raised > lettering::width("10", 12.0));
}

/// Contrast of two colours as WCAG 2.2 defines it, 1 to 21.
fn contrast(a: Rgb, b: Rgb) -> f64 {
    let linear = |part: u8| {
        let share = f64::from(part) / 255.0;
        if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    };
    let light = |c: Rgb| 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
    let (low, high) = (light(a).min(light(b)), light(a).max(light(b)));
    (high + 0.05) / (low + 0.05)
}

#[test]
fn every_colour_stands_out_from_its_paper() {
    for theme in [Theme::Light, Theme::Dark] {
        for colour in [Colour::Red, Colour::Blue, Colour::Green, Colour::Ink] {
            let ratio = contrast(theme.shade(colour), theme.paper());
            assert!(ratio >= 4.5, "{colour:?} on {theme:?}: {ratio:.2} to 1");
        }
    }
}
