//! Writes a drawing as an SVG element.
//!
//! It holds no ids and no styles that reach beyond itself, so that many can share a page, and
//! its letters are text, so that they can be searched and read out. `raster` paints the same.

use std::fmt::Write;

use super::drawing::{Anchor, Drawing, Pen, Point, Shape, Text};
use super::lettering::{Level, pieces};
use super::stroke::Rgb;

/// Faces of nearly the same width, one of which every system has.
const FONTS: &str = "Arial, Helvetica, 'Liberation Sans', Arimo, 'DejaVu Sans Condensed', sans-serif";

/// The drawing as SVG, with what it shows in words. Writing to a string cannot fail.
pub(super) fn write(drawing: &Drawing, description: &str) -> String {
    let (width, height) = (decimal(drawing.width), decimal(drawing.height));
    let words = escaped(description);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\" style=\"max-width:100%;height:auto\" role=\"img\" \
         aria-label=\"{words}\" font-family=\"{FONTS}\">\n<title>{words}</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n",
        hex(drawing.paper),
    );
    for shape in &drawing.shapes {
        match shape {
            Shape::Lines { runs, pen } => lines(&mut svg, runs, pen),
            Shape::Text(text) => letters(&mut svg, text),
        }
    }
    svg.push_str("</svg>\n");
    svg
}

fn lines(svg: &mut String, runs: &[Vec<Point>], pen: &Pen) {
    if runs.is_empty() {
        return;
    }
    svg.push_str("<path fill=\"none\" stroke-linejoin=\"round\" stroke=\"");
    let _ = write!(svg, "{}\" stroke-width=\"{}\"", hex(pen.ink), decimal(pen.width));
    if !pen.dashes.is_empty() {
        let dashes: Vec<String> = pen.dashes.iter().map(|length| decimal(*length)).collect();
        let _ = write!(svg, " stroke-dasharray=\"{}\"", dashes.join(" "));
    }
    svg.push_str(" d=\"");
    for run in runs {
        path(svg, run);
    }
    svg.push_str("\"/>\n");
}

/// A run as steps in tenths of a pixel, counted from the rounded point before, so that
/// rounding does not add up. Frames stand on half pixels and stay sharp.
fn path(svg: &mut String, run: &[Point]) {
    let mut pen = [0_i64; 2];
    for (index, point) in run.iter().enumerate() {
        let here = point.map(|pixels| (pixels * 10.0).round() as i64);
        svg.push_str(match index {
            0 => "M",
            1 => "l",
            _ => "",
        });
        for axis in 0..2 {
            let step = here[axis] - pen[axis];
            if step >= 0 && (axis == 1 || index > 1) {
                svg.push(' ');
            }
            tenths(svg, step);
        }
        pen = here;
    }
}

/// A count of tenths as a short decimal: 25 is `2.5`, -3 is `-.3`.
fn tenths(svg: &mut String, count: i64) {
    let (whole, tenth) = (count.abs() / 10, count.abs() % 10);
    if count < 0 {
        svg.push('-');
    }
    if whole > 0 || tenth == 0 {
        let _ = write!(svg, "{whole}");
    }
    if tenth > 0 {
        let _ = write!(svg, ".{tenth}");
    }
}

fn letters(svg: &mut String, text: &Text) {
    let [x, y] = text.at.map(decimal);
    let anchor = match text.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let (size, ink) = (decimal(text.size), hex(text.ink));
    let _ = write!(svg, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{ink}\"");
    if text.upwards {
        let _ = write!(svg, " transform=\"rotate(-90 {x} {y})\"");
    }
    svg.push('>');
    let mut line = Level::Base;
    for (level, words) in pieces(&text.markup) {
        if level == line {
            svg.push_str(&escaped(&words));
            continue;
        }
        let drop = decimal((level.drop() - line.drop()) * text.size);
        let size = decimal(level.size() * text.size);
        let _ = write!(svg, "<tspan dy=\"{drop}\" font-size=\"{size}\">{}</tspan>", escaped(&words));
        line = level;
    }
    svg.push_str("</text>\n");
}

/// A number of pixels with two digits behind the point at most.
fn decimal(pixels: f64) -> String {
    let text = format!("{pixels:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn hex([red, green, blue]: Rgb) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn escaped(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut safe, letter| {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            // XML knows no other control characters, not even escaped.
            '\t' | '\n' | '\r' => safe.push(' '),
            letter if letter.is_control() => {}
            letter => safe.push(letter),
        }
        safe
    })
}
