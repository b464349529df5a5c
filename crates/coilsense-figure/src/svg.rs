//! Writes a drawing as an SVG element.
//!
//! It holds no ids and no styles that reach beyond itself, so that many can share a page, and
//! its letters are text, so that they can be searched and read out. `raster` paints the same.

use std::fmt::Write;

use crate::PlotError;
use crate::drawing::{Anchor, Drawing, Frame, Pen, Point, Shape, Text};
use crate::lettering::{Level, pieces};
use crate::picture::Picture;
use crate::stroke::Rgb;
use crate::svg_path::path;

/// Faces of nearly the same width, one of which every system has.
const FONTS: &str = "Arial, Helvetica, 'Liberation Sans', Arimo, 'DejaVu Sans Condensed', sans-serif";

/// The drawing as SVG, with what it shows in words. Writing to a string cannot fail.
///
/// # Errors
/// [`PlotError::Png`] when a picture within it cannot be packed.
pub(crate) fn write(drawing: &Drawing, description: &str) -> Result<String, PlotError> {
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
            Shape::Area { outlines, ink, opacity } => area(&mut svg, outlines, *ink, *opacity),
            Shape::Picture { picture: shown, frame } => picture(&mut svg, shown, frame)?,
            Shape::Text(text) => letters(&mut svg, text),
        }
    }
    svg.push_str("</svg>\n");
    Ok(svg)
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

fn area(svg: &mut String, outlines: &[Vec<Point>], ink: Rgb, opacity: f64) {
    if outlines.is_empty() {
        return;
    }
    let _ = write!(svg, "<path fill=\"{}\"", hex(ink));
    if opacity < 1.0 {
        let _ = write!(svg, " fill-opacity=\"{}\"", decimal(opacity));
    }
    svg.push_str(" d=\"");
    for outline in outlines {
        path(svg, outline);
        svg.push('z');
    }
    svg.push_str("\"/>\n");
}

fn picture(svg: &mut String, picture: &Picture, frame: &Frame) -> Result<(), PlotError> {
    let [left, top, width, height] = [frame.left, frame.top, frame.width, frame.height].map(decimal);
    let _ = writeln!(
        svg,
        "<image x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" \
         preserveAspectRatio=\"none\" href=\"{}\"/>",
        picture.data_uri()?,
    );
    Ok(())
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
