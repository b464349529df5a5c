//! Paints a drawing and packs it as PNG.
//!
//! Letters are painted from the outlines that `lettering` carries, so that no font needs to be
//! installed. `svg` writes the same drawing as text.

use ::png::{BitDepth, ColorType, Compression, Encoder, PixelDimensions, Unit};
use tiny_skia::{
    Color, ColorU8, FillRule, FilterQuality, LineJoin, Paint, Path, PathBuilder, Pixmap, PixmapPaint, Stroke,
    StrokeDash, Transform,
};

use crate::PlotError;
use crate::drawing::{Anchor, Drawing, Frame, Pen, Point, Shape, Text};
use crate::glyphs::glyphs;
use crate::lettering::width;
use crate::picture::Picture;
use crate::stroke::Rgb;

/// Dots of a PNG per pixel of the figure: 192 dpi, as the file itself says.
pub const PNG_SCALE: f64 = 2.0;

/// Dots per metre at [`PNG_SCALE`] × 96 dpi.
const DOTS_PER_METRE: u32 = 7559;

/// The most dots of one sheet, 400 MB of memory: about 30 letter pages at 192 dpi.
const MOST_DOTS: u64 = 100_000_000;

/// The drawing as the bytes of a PNG file.
pub(crate) fn write(drawing: &Drawing) -> Result<Vec<u8>, PlotError> {
    let dots = |pixels: f64| (pixels * PNG_SCALE).round() as u32;
    let (across, down) = (dots(drawing.width), dots(drawing.height));
    let too_large = || PlotError::Png(format!("{across} by {down} dots are too many"));
    if u64::from(across) * u64::from(down) > MOST_DOTS {
        return Err(too_large());
    }
    let mut sheet = Pixmap::new(across, down).ok_or_else(too_large)?;
    let [red, green, blue] = drawing.paper;
    sheet.fill(Color::from_rgba8(red, green, blue, 255));
    for shape in &drawing.shapes {
        match shape {
            Shape::Lines { runs, pen } => lines(&mut sheet, runs, pen),
            Shape::Area { outlines, ink, opacity } => area(&mut sheet, outlines, *ink, *opacity),
            Shape::Picture { picture: shown, frame } => picture(&mut sheet, shown, frame),
            Shape::Text(text) => letters(&mut sheet, text),
        }
    }
    packed(&sheet).map_err(|error| PlotError::Png(error.to_string()))
}

fn paint(rgb: Rgb, opacity: f64) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(rgb[0], rgb[1], rgb[2], (255.0 * opacity).round() as u8);
    paint
}

fn scale() -> Transform {
    Transform::from_scale(PNG_SCALE as f32, PNG_SCALE as f32)
}

/// Runs as one path, each closed if asked for.
fn path(runs: &[Vec<Point>], closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for run in runs {
        for (index, [x, y]) in run.iter().map(|point| point.map(|v| v as f32)).enumerate() {
            if index == 0 {
                builder.move_to(x, y);
            } else {
                builder.line_to(x, y);
            }
        }
        if closed {
            builder.close();
        }
    }
    builder.finish()
}

fn lines(sheet: &mut Pixmap, runs: &[Vec<Point>], pen: &Pen) {
    let Some(path) = path(runs, false) else { return };
    let dashes = pen.dashes.iter().map(|length| *length as f32).collect();
    let stroke = Stroke {
        width: pen.width as f32,
        line_join: LineJoin::Round,
        dash: StrokeDash::new(dashes, 0.0),
        ..Stroke::default()
    };
    sheet.stroke_path(&path, &paint(pen.ink, 1.0), &stroke, scale(), None);
}

fn area(sheet: &mut Pixmap, outlines: &[Vec<Point>], ink: Rgb, opacity: f64) {
    let Some(path) = path(outlines, true) else { return };
    sheet.fill_path(&path, &paint(ink, opacity), FillRule::Winding, scale(), None);
}

/// A picture over its frame; a sheet that could be made has room for it.
fn picture(sheet: &mut Pixmap, picture: &Picture, frame: &Frame) {
    let (across, down) = (picture.columns as u32, picture.rows() as u32);
    let Some(mut dots) = Pixmap::new(across, down) else { return };
    for (dot, [red, green, blue, opacity]) in dots.pixels_mut().iter_mut().zip(picture.rgba()) {
        *dot = ColorU8::from_rgba(red, green, blue, opacity).premultiply();
    }
    let [left, top] = [frame.left, frame.top].map(|pixels| pixels as f32);
    let stretch = [frame.width / f64::from(across), frame.height / f64::from(down)].map(|pixels| pixels as f32);
    let place = scale().pre_translate(left, top).pre_scale(stretch[0], stretch[1]);
    let paint = PixmapPaint { quality: FilterQuality::Bilinear, ..PixmapPaint::default() };
    sheet.draw_pixmap(0, 0, dots.as_ref(), &paint, place, None);
}

fn letters(sheet: &mut Pixmap, text: &Text) {
    let Some(path) = glyphs(&text.markup) else { return };
    let shift = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5,
        Anchor::End => -1.0,
    } * width(&text.markup, text.size);
    let [x, y] = text.at.map(|pixels| (pixels * PNG_SCALE) as f32);
    let size = (text.size * PNG_SCALE) as f32;
    let turned = if text.upwards { Transform::from_rotate(-90.0) } else { Transform::identity() };
    let transform = turned.pre_translate((shift * PNG_SCALE) as f32, 0.0).pre_scale(size, -size).post_translate(x, y);
    sheet.fill_path(&path, &paint(text.ink, 1.0), FillRule::Winding, transform, None);
}

/// Packs an opaque sheet, without its alpha channel.
fn packed(sheet: &Pixmap) -> Result<Vec<u8>, ::png::EncodingError> {
    let rgb: Vec<u8> = sheet.data().chunks_exact(4).flat_map(|dot| [dot[0], dot[1], dot[2]]).collect();
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, sheet.width(), sheet.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Fast);
    encoder.set_pixel_dims(Some(PixelDimensions { xppu: DOTS_PER_METRE, yppu: DOTS_PER_METRE, unit: Unit::Meter }));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    Ok(file)
}
