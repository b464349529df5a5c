//! What the places of a figure must keep: a bar's text off the marks, a circle round.

use super::parts::{boxes, budget, drawn};
use super::*;
use crate::drawing::Shape;
use crate::layout;

#[test]
fn the_text_of_a_bar_stands_on_no_mark() {
    for value in [0.3, 0.8, 0.93, 0.99, 1.0, 1.01] {
        let bar = Bar { name: "laser".into(), value, text: format!("{value} %"), ..Bar::default() };
        let far = Bar { name: "load cell".into(), value: 9.0, ..Bar::default() };
        let mut panel = budget();
        panel.bars = Some(Bars { bars: vec![bar, far], ..Bars::default() });
        let drawing = drawn(panel);
        let goal = boxes(&drawing).into_iter().find(|(_, words)| words == "goal 1 %").unwrap().0;
        let mark = 0.5 * (goal[0] + goal[2]);
        let text = boxes(&drawing).into_iter().find(|(_, words)| *words == format!("{value} %")).unwrap().0;
        assert!(text[2] < mark || mark < text[0], "{value}: the mark at {mark} crosses {text:?}");
    }
}

#[test]
fn with_equal_units_a_circle_is_round_and_all_of_a_range_is_shown() {
    for (width, height) in [(520.0, 480.0), (300.0, 600.0), (760.0, 200.0)] {
        let turn: Vec<f64> = (0..=100).map(|step| std::f64::consts::TAU * f64::from(step) / 100.0).collect();
        let circle = curve("", turn.iter().map(|t| t.cos()).collect(), turn.iter().map(|t| t.sin()).collect());
        let panel = Panel {
            x: axis("Re L", Some((-3.0, 3.0)), Scale::Linear),
            y: axis("Im L", Some((-2.0, 2.0)), Scale::Linear),
            equal_units: true,
            curves: vec![circle],
            ..Panel::default()
        };
        let figure = Figure { panels: vec![panel], columns: 1, panel_width: width, panel_height: height };
        let drawing = layout::draw(&figure, Theme::Light).unwrap();
        let red = Theme::Light.shade(Colour::Red);
        let all = drawing.shapes.iter().filter_map(|shape| match shape {
            Shape::Lines { runs, pen } if pen.ink == red => Some(runs.concat()),
            _ => None,
        });
        let dots = all.flatten().collect::<Vec<Point>>();
        let size = |axis: usize| {
            let each = || dots.iter().map(move |dot| dot[axis]);
            each().fold(f64::MIN, f64::max) - each().fold(f64::MAX, f64::min)
        };
        assert!((size(0) / size(1) - 1.0).abs() < 0.01, "{width} × {height}: {} by {}", size(0), size(1));
        // The curve is whole.
        assert!(dots.len() > 50);
    }
}
