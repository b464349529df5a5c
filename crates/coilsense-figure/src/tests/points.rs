//! What points must keep: their place, the whole of their error bars in a fitted axis, their words.

use super::*;
use crate::drawing::Shape;
use crate::layout;

fn points(errors: Vec<f64>) -> Points {
    Points { label: "F_o".into(), x: vec![0.0, 1.0, 2.0], y: vec![1.0, 3.0, 2.0], errors, ..Points::default() }
}

fn of(points: Vec<Points>) -> Figure {
    let panel = Panel {
        x: axis("Frequency [Hz]", None, Scale::Linear),
        y: axis("Force [N]", None, Scale::Linear),
        points,
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: 480.0, panel_height: 320.0 }
}

#[test]
fn a_fitted_axis_holds_error_bars_whole() {
    let reach: Vec<f64> = points(vec![0.5, 4.0, f64::NAN]).reach().collect();
    assert_eq!(reach, [0.5, 1.5, -1.0, 7.0, 2.0, 2.0]);
    let drawing = layout::draw(&of(vec![points(vec![0.5, 4.0, f64::NAN])]), Theme::Light).unwrap();
    // Two bars with two caps each: the third point has none.
    let whiskers = drawing.shapes.iter().filter_map(|shape| match shape {
        Shape::Lines { runs, pen } if pen.ink == Theme::Light.shade(Colour::Blue) => Some(runs.len()),
        _ => None,
    });
    assert_eq!(whiskers.collect::<Vec<_>>(), [6]);
    // One marker in the legend, three in the axes.
    let markers = drawing.shapes.iter().filter_map(|shape| match shape {
        Shape::Area { outlines, ink, .. } if *ink == Theme::Light.shade(Colour::Blue) => Some(outlines.len()),
        _ => None,
    });
    assert_eq!(markers.collect::<Vec<_>>(), [1, 3]);
}

#[test]
fn every_marker_is_centred_and_both_writers_draw_it() {
    let markers = [Marker::Disc, Marker::Square, Marker::Diamond];
    for marker in markers {
        let outline = marker.outline([10.0, 20.0]);
        let mean = |axis: usize| outline.iter().map(|point| point[axis]).sum::<f64>() / outline.len() as f64;
        assert!((mean(0) - 10.0).abs() < 1e-12 && (mean(1) - 20.0).abs() < 1e-12);
    }
    let figure = of(markers.map(|marker| Points { marker, ..points(Vec::new()) }).into());
    assert!(figure.to_svg(Theme::Dark).unwrap().contains("points: Fo"));
    decoded_size(&figure.to_png(Theme::Light).unwrap());
}

#[test]
fn points_whose_series_do_not_go_together_are_refused() {
    let refused = of(vec![points(vec![1.0])]).to_svg(Theme::Light).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "points `F_o` need as many x as y values and no error bars or as many, got 3, 3 and 1"
    );
}

#[test]
fn names_of_points_stand_beside_them_and_on_nothing_else() {
    let named = |x: Vec<f64>, names: &[&str]| Points {
        y: vec![1.0; x.len()],
        x,
        names: names.iter().map(|name| (*name).to_owned()).collect(),
        ..Points::default()
    };
    // Three far apart, and three on one another: the last has no side left.
    let figure = of(vec![
        named(vec![0.0, 5.0, 10.0], &["left", "middle", "right"]),
        named(vec![2.0; 5], &["first", "second", "third", "fourth", "fifth"]),
    ]);
    let svg = figure.to_svg(Theme::Light).unwrap();
    for name in ["left", "middle", "right", "first", "second", "third", "fourth"] {
        assert!(svg.contains(&format!(">{name}</text>")), "{name}");
    }
    assert!(!svg.contains(">fifth</text>"));
    let refused = of(vec![named(vec![0.0, 1.0], &["one"])]).to_svg(Theme::Light).unwrap_err();
    assert_eq!(refused.to_string(), "points `` need no names or one each, got 1 for 2 points");
}
