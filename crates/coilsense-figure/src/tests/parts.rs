//! What bands, limits, colour maps and bars must keep: their place, their peaks, their words.

use super::*;
use crate::colour_map::{Kind, LEVELS, colours};
use crate::drawing::{Anchor, Drawing, Shape};
use crate::{band, layout, lettering};

fn of(panel: Panel) -> Figure {
    Figure { panels: vec![panel], columns: 1, panel_width: 480.0, panel_height: 320.0 }
}

fn refused(panel: Panel) -> PlotError {
    of(panel).to_svg(Theme::Light).unwrap_err()
}

fn spectrum() -> Panel {
    let x: Vec<f64> = (1..=400).map(|step| 2.0 * f64::from(step)).collect();
    let gain = |factor: f64| x.iter().map(|hertz| factor * 40.0 / hertz).collect::<Vec<f64>>();
    Panel {
        title: "Deviation".into(),
        x: axis("Frequency [Hz]", None, Scale::Linear),
        y: axis("Amplitude [%]", None, Scale::Log10),
        curves: vec![curve("F_o", x.clone(), gain(1.0))],
        bands: vec![Band {
            label: "damping 1 to 5 %".into(),
            lower: gain(0.5),
            upper: gain(2.0),
            x,
            colour: Colour::Red,
        }],
        marks: (1..=8).map(|mode| Mark { x: 54.0 * f64::from(mode), label: format!("f_{mode} of the coil") }).collect(),
        limits: [(1.0, "goal 1 %"), (0.95, "noise of the load cell"), (0.9, "drift")]
            .map(|(y, label)| HorizontalMark { y, label: label.into() })
            .into(),
        ..Panel::default()
    }
}

/// Twelve windings over half a second, the displacement 1 at most, with marks and a gap.
fn windings() -> Panel {
    let (rows, columns) = (12, 5000);
    let wave = |row: usize, column: usize| (0.7 * row as f64 + 0.01 * column as f64).sin();
    let mut values: Vec<f64> = (0..rows * columns).map(|cell| wave(cell / columns, cell % columns)).collect();
    values[7] = f64::NAN;
    let cells = values.iter().map(|value| *value > 0.99).collect();
    let heat = HeatMap {
        label: "Displacement [mm]".into(),
        rows,
        values,
        x: (0.0, 0.5),
        y: (0.5, 12.5),
        range: None,
        smooth: false,
        marked: Some(MarkedCells { label: "windings touch".into(), cells }),
    };
    Panel {
        x: axis("Time [s]", None, Scale::Linear),
        y: axis("Winding", None, Scale::Linear),
        heat: Some(heat),
        ..Panel::default()
    }
}

pub(super) fn budget() -> Panel {
    let long = "Cross-talk of the current loop that drives the motor beside it";
    let bar = |(index, value): (usize, f64)| Bar {
        name: if index == 2 { long.into() } else { format!("Contribution {index}") },
        value,
        interval: Some((0.8 * value, 1.3 * value)),
        text: format!("{value} %"),
        group: if value > 1.0 { "exceeds goal".into() } else { String::new() },
        ..Bar::default()
    };
    let values = [3.2, -2.0, 0.9, 0.5, f64::NAN, 0.0];
    Panel {
        x: axis("Uncertainty [%]", None, Scale::Linear),
        marks: vec![Mark { x: 1.0, label: "goal 1 %".into() }],
        bars: Some(Bars { bars: values.into_iter().enumerate().map(bar).collect(), ..Bars::default() }),
        ..Panel::default()
    }
}

pub(super) fn drawn(panel: Panel) -> Drawing {
    layout::draw(&of(panel), Theme::Light).unwrap()
}

/// Left, top, right and bottom of every text, with its words.
pub(super) fn boxes(drawing: &Drawing) -> Vec<([f64; 4], String)> {
    let texts = drawing.shapes.iter().filter_map(|shape| if let Shape::Text(text) = shape { Some(text) } else { None });
    let around = texts.map(|text| {
        let long = lettering::width(&text.markup, text.size);
        let from = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * long,
            Anchor::End => -long,
        };
        let [x, y] = text.at;
        // Capitals rise to 0.73 of the letter size; a line of small print is 13 px.
        let (above, below) = (0.75 * text.size, 0.2 * text.size);
        let sides = if text.upwards {
            [x - above, y - from - long, x + below, y - from]
        } else {
            [x + from, y - above, x + from + long, y + below]
        };
        (sides, text.markup.clone())
    });
    around.collect()
}

#[test]
fn letters_stay_on_the_sheet_and_off_each_other() {
    for panel in [spectrum(), windings(), budget()] {
        let drawing = drawn(panel);
        let boxes = boxes(&drawing);
        for (index, ([left, top, right, bottom], words)) in boxes.iter().enumerate() {
            let inside = *left >= 0.0 && *top >= 0.0 && *right <= drawing.width && *bottom <= drawing.height;
            assert!(inside, "`{words}` leaves the sheet");
            for (other, name) in &boxes[index + 1..] {
                let apart = *right <= other[0] || other[2] <= *left || *bottom <= other[1] || other[3] <= *top;
                assert!(apart, "`{words}` and `{name}` overlap");
            }
        }
    }
}

#[test]
fn areas_and_pictures_stay_on_the_sheet() {
    for panel in [spectrum(), windings(), budget()] {
        let drawing = drawn(panel);
        for shape in &drawing.shapes {
            let corners = match shape {
                Shape::Area { outlines, .. } => outlines.concat(),
                Shape::Picture { frame, .. } => frame.corners(),
                _ => Vec::new(),
            };
            let inside = |[x, y]: Point| (0.0..=drawing.width).contains(&x) && (0.0..=drawing.height).contains(&y);
            assert!(corners.into_iter().all(inside));
        }
    }
}

#[test]
fn crowded_mark_labels_take_three_rows_and_no_more() {
    let mut crowded = spectrum();
    crowded.marks = (0..60).map(|line| Mark { x: 10.0 * f64::from(line), label: format!("line {line}") }).collect();
    let drawing = drawn(crowded);
    let labels = boxes(&drawing).into_iter().filter(|(_, words)| words.starts_with("line"));
    let mut rows: Vec<f64> = labels.map(|(sides, _)| sides[3]).collect();
    rows.sort_by(f64::total_cmp);
    rows.dedup();
    assert_eq!(rows.len(), 3);
}

#[test]
fn limits_are_fitted_into_the_axis() {
    let mut low = spectrum();
    low.limits[0].y = 5000.0;
    let svg = of(low).to_svg(Theme::Light).unwrap();
    assert!(svg.contains(">goal 1 %</text>"));
    let mut cut = spectrum();
    cut.y.range = Some((2.0, 10.0));
    assert!(!of(cut).to_svg(Theme::Light).unwrap().contains(">goal 1 %</text>"), "out of a given range");
}

#[test]
fn a_band_breaks_at_gaps_and_ends_at_the_walls() {
    let nan = f64::NAN;
    let unit = Ruler { lower: 0.0, upper: 1.0, scale: Scale::Linear };
    let wide = Band {
        label: String::new(),
        x: (0..7).map(|step| f64::from(step) / 6.0).collect(),
        lower: vec![-5.0, 0.2, nan, 0.6, nan, 0.5, 0.1],
        upper: vec![7.0, 0.1, 0.3, 0.9, 0.2, f64::INFINITY, 0.1],
        colour: Colour::Blue,
    };
    let outlines = band::outlines(&wide, &[unit, unit], &FRAME);
    assert_eq!(outlines.len(), 3, "two slices, one, and one beside what is not finite");
    for [x, y] in outlines.concat() {
        // 1e-9 px: the rounding of the crossing.
        assert!((FRAME.left - 1e-9..=FRAME.right() + 1e-9).contains(&x), "x at {x} px");
        assert!((FRAME.top - 1e-9..=FRAME.bottom() + 1e-9).contains(&y), "y at {y} px");
    }
}

#[test]
fn on_a_logarithmic_axis_a_band_from_zero_reaches_the_foot() {
    let x = Ruler { lower: 0.0, upper: 1.0, scale: Scale::Linear };
    let y = Ruler { lower: -3.0, upper: 0.0, scale: Scale::Log10 };
    let from_zero = Band {
        label: String::new(),
        x: vec![0.0, 1.0],
        lower: vec![0.0; 2],
        upper: vec![0.1; 2],
        colour: Colour::Blue,
    };
    let points = band::outlines(&from_zero, &[x, y], &FRAME).concat();
    let lowest = points.iter().map(|point| point[1]).fold(0.0, f64::max);
    assert_eq!(lowest, FRAME.bottom());
}

fn shown_picture(panel: Panel) -> crate::picture::Picture {
    let mut pictures = drawn(panel).shapes.into_iter().filter_map(|shape| match shape {
        Shape::Picture { picture, .. } if picture.columns > 1 => Some(picture),
        _ => None,
    });
    pictures.next_back().unwrap()
}

#[test]
fn a_single_peak_survives_the_narrowing_of_a_colour_map() {
    let mut quiet = windings();
    let heat = quiet.heat.as_mut().unwrap();
    heat.values.fill(0.1);
    heat.values[3 * 5000 + 1234] = -4.0;
    heat.values[9 * 5000 + 4321] = 4.0;
    heat.marked = None;
    let picture = shown_picture(quiet);
    assert!(picture.columns <= 900 && picture.rows() <= 400);
    let rows_of = |colour: usize| {
        let hits = picture.dots.iter().enumerate().filter(move |(_, dot)| usize::from(**dot) == colour);
        hits.map(|(index, _)| index / picture.columns).collect::<Vec<_>>()
    };
    let (lowest, highest) = (rows_of(0), rows_of(LEVELS - 1));
    // Rows of 12 are counted from below: row 3 is the ninth from the top.
    assert!(!lowest.is_empty() && lowest.iter().all(|row| row * 12 / picture.rows() == 8));
    assert!(!highest.is_empty() && highest.iter().all(|row| row * 12 / picture.rows() == 2));
}

#[test]
fn colours_of_signed_values_are_centred_at_zero() {
    let mut signed = windings();
    let heat = signed.heat.as_mut().unwrap();
    let scale = |heat: &HeatMap| heat.scale().map(|(ruler, kind)| (ruler.lower, ruler.upper, kind)).unwrap();
    heat.values.fill(-1.0);
    heat.values[0] = 3.0;
    assert_eq!(scale(heat), (-3.0, 3.0, Kind::Diverging));
    heat.range = Some((0.0, 2.0));
    assert_eq!(scale(heat), (0.0, 2.0, Kind::Sequential));
    heat.range = None;
    heat.values.fill(f64::NAN);
    assert_eq!(heat.scale().unwrap_err(), PlotError::NoData { label: "Displacement [mm]".into() });
}

/// What a screen shows, linear in light.
fn linear(colour: Rgb) -> [f64; 3] {
    colour.map(|part| {
        let shown = f64::from(part) / 255.0;
        if shown <= 0.04045 { shown / 12.92 } else { ((shown + 0.055) / 1.055).powf(2.4) }
    })
}

fn times(matrix: [[f64; 3]; 3], [r, g, b]: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * r + row[1] * g + row[2] * b)
}

/// Linear light in Oklab; the matrices are Ottosson's.
fn oklab(light: [f64; 3]) -> [f64; 3] {
    let cones = times(
        [
            [0.4122214708, 0.5363325363, 0.0514459929],
            [0.2119034982, 0.6806995451, 0.1073969566],
            [0.0883024619, 0.2817188376, 0.6299787005],
        ],
        light,
    );
    times(
        [
            [0.2104542553, 0.7936177850, -0.0040720468],
            [1.9779984951, -2.4285922050, 0.4505937099],
            [0.0259040371, 0.7827717662, -0.8086757660],
        ],
        cones.map(f64::cbrt),
    )
}

#[test]
fn signs_stay_apart_for_colour_blind_readers() {
    // Machado, Oliveira and Fernandes 2009, full severity: protan, deutan.
    let sights = [
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    ];
    for theme in [Theme::Light, Theme::Dark] {
        let scale = colours(Kind::Diverging, theme);
        for sight in sights {
            // Halfway and full, either side of zero: equally light, so that hue alone tells.
            for step in [LEVELS / 4, 0] {
                let seen = [scale[step], scale[LEVELS - 1 - step]]
                    .map(|colour| oklab(times(sight, linear(colour)).map(|light| light.max(0.0))));
                let apart = (0..3).map(|axis| (seen[0][axis] - seen[1][axis]).powi(2)).sum::<f64>().sqrt();
                // 0.02 is what the eye just tells apart; ten times that is plain.
                assert!(apart > 0.2, "{theme:?}, step {step}: {apart:.3}");
            }
        }
    }
}

#[test]
fn colours_are_even_in_lightness() {
    for theme in [Theme::Light, Theme::Dark] {
        for (kind, legs) in [(Kind::Sequential, 1), (Kind::Diverging, 2)] {
            let light: Vec<f64> = colours(kind, theme).into_iter().map(|colour| oklab(linear(colour))[0]).collect();
            let leg = (LEVELS - 1) / legs;
            for start in (0..legs).map(|index| index * leg) {
                let (from, to) = (light[start], light[start + leg]);
                for step in 0..=leg {
                    let even = from + (to - from) * step as f64 / leg as f64;
                    // 0.01: 8-bit colours, and stations rounded to two digits, are not finer.
                    let off = (light[start + step] - even).abs();
                    assert!(off < 0.01, "{kind:?} on {theme:?}, step {step}: {off}");
                }
            }
        }
    }
}

#[test]
fn a_colour_map_is_a_small_picture_inside_the_svg() {
    let svg = of(windings()).to_svg(Theme::Dark).unwrap();
    assert_eq!(svg.matches("href=\"data:image/png;base64,").count(), 2, "cells and colour bar");
    assert!(svg.contains(">Displacement [mm]</text>") && svg.contains(">windings touch</text>"));
    assert!(!svg.contains(" id="));
    assert!(svg.len() < 150_000, "{} bytes", svg.len());
}

#[test]
fn both_writers_paint_the_same_cells() {
    let picture = shown_picture(windings());
    let uri = picture.data_uri().unwrap();
    let file = base64::Engine::decode(&base64::prelude::BASE64_STANDARD, uri.rsplit(',').next().unwrap()).unwrap();
    let mut decoder = ::png::Decoder::new(std::io::Cursor::new(file));
    decoder.set_transformations(::png::Transformations::EXPAND | ::png::Transformations::ALPHA);
    let mut reader = decoder.read_info().unwrap();
    let mut dots = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut dots).unwrap();
    assert_eq!(dots, picture.rgba().collect::<Vec<_>>().concat());
}

#[test]
fn the_description_names_every_part() {
    let words = |panel| of(panel).to_svg(Theme::Light).unwrap();
    let spectrum = words(spectrum());
    assert!(
        spectrum.contains("Fo; shaded: damping 1 to 5 %; limits: goal 1 %, noise of the load cell, drift.</title>")
    );
    let map = words(windings());
    assert!(map.contains("<title>Displacement [mm] in colour over Winding against Time [s]; marked: windings touch."));
    let budget = words(budget());
    assert!(
        budget.contains("<title>bars of Uncertainty [%]; Contribution 0 3.2 % (exceeds goal), Contribution 1 -2 %")
    );
}

#[test]
fn fourteen_bars_have_room_in_the_height_they_ask_for() {
    let mut many = budget();
    let bars = many.bars.as_mut().unwrap();
    let long = bars.bars[2].clone();
    bars.bars.resize(14, long);
    let panel_height = bars.panel_height(336.0);
    let figure = Figure { panel_width: 336.0, panel_height, ..of(many) };
    assert!(figure.to_svg(Theme::Light).is_ok());
    let low = Figure { panel_height: 200.0, ..figure };
    let error = low.to_svg(Theme::Light).unwrap_err();
    assert!(matches!(error, PlotError::BarRoom { .. }), "{error}");
}

#[test]
fn parts_that_do_not_fit_together_are_refused_by_name() {
    let mut uneven = spectrum();
    uneven.bands[0].upper.pop();
    let error = refused(uneven);
    assert_eq!(
        error.to_string(),
        "band `damping 1 to 5 %` needs as many x as lower and upper values, got 400, 400 and 399"
    );
    let with_heat = |change: &dyn Fn(&mut HeatMap)| {
        let mut panel = windings();
        change(panel.heat.as_mut().unwrap());
        refused(panel)
    };
    for rows in [0, 7] {
        let label = "Displacement [mm]".into();
        assert_eq!(with_heat(&|heat| heat.rows = rows), PlotError::Cells { label, rows, values: 60_000 });
    }
    let marked = with_heat(&|heat| heat.marked.as_mut().unwrap().cells.clear());
    assert_eq!(marked, PlotError::MarkedCells { label: "windings touch".into(), values: 60_000, cells: 0 });
    assert!(matches!(with_heat(&|heat| heat.x = (1.0, f64::NAN)), PlotError::Range { .. }));
    assert!(matches!(with_heat(&|heat| heat.values.fill(f64::NAN)), PlotError::NoData { .. }));
    let label = || "Uncertainty [%]".to_owned();
    let none = Panel { bars: Some(Bars::default()), ..budget() };
    assert_eq!(refused(none), PlotError::NoBars { label: label() });
    let mixed = Panel { limits: spectrum().limits, ..budget() };
    assert_eq!(refused(mixed), PlotError::BarsNotAlone { label: label() });
}
