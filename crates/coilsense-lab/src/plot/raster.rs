//! Paints a drawing and packs it as PNG.
//!
//! Letters are painted from the outlines that `lettering` carries, so that no font needs to be
//! installed. `svg` writes the same drawing as text.

use ::png::{BitDepth, ColorType, Compression, Encoder, PixelDimensions, Unit};
use tiny_skia::{Color, FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};
use ttf_parser::OutlineBuilder;

use super::PlotError;
use super::drawing::{Anchor, Drawing, Pen, Point, Shape, Text};
use super::lettering::{outline, width};
use super::stroke::Rgb;

/// Dots of a PNG per pixel of the figure: 192 dpi, as the file itself says.
pub const PNG_SCALE: f64 = 2.0;

/// Dots per metre at [`PNG_SCALE`] × 96 dpi.
const DOTS_PER_METRE: u32 = 7559;

/// The most dots of one sheet, 400 MB of memory: about 30 letter pages at 192 dpi.
const MOST_DOTS: u64 = 100_000_000;

/// The drawing as the bytes of a PNG file.
pub(super) fn write(drawing: &Drawing) -> Result<Vec<u8>, PlotError> {
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
            Shape::Text(text) => letters(&mut sheet, text),
        }
    }
    packed(&sheet).map_err(|error| PlotError::Png(error.to_string()))
}

fn paint(rgb: Rgb) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(rgb[0], rgb[1], rgb[2], 255);
    paint
}

fn lines(sheet: &mut Pixmap, runs: &[Vec<Point>], pen: &Pen) {
    let mut builder = PathBuilder::new();
    for run in runs {
        for (index, [x, y]) in run.iter().map(|point| point.map(|v| v as f32)).enumerate() {
            if index == 0 {
                builder.move_to(x, y);
            } else {
                builder.line_to(x, y);
            }
        }
    }
    let Some(path) = builder.finish() else { return };
    let dashes = pen.dashes.iter().map(|length| *length as f32).collect();
    let stroke = Stroke {
        width: pen.width as f32,
        line_join: LineJoin::Round,
        dash: StrokeDash::new(dashes, 0.0),
        ..Stroke::default()
    };
    let scale = Transform::from_scale(PNG_SCALE as f32, PNG_SCALE as f32);
    sheet.stroke_path(&path, &paint(pen.ink), &stroke, scale, None);
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
    sheet.fill_path(&path, &paint(text.ink), FillRule::Winding, transform, None);
}

/// The outlines of a text of letter size 1, y upwards.
fn glyphs(markup: &str) -> Option<Path> {
    let mut pen = GlyphPen { path: PathBuilder::new(), at: [0.0; 2], unit: 1.0 };
    outline(markup, &mut pen, |pen, at, unit| {
        (pen.at, pen.unit) = (at.map(|v| v as f32), unit as f32);
    });
    pen.path.finish()
}

/// Carries a font's outlines over to the painter's path.
struct GlyphPen {
    path: PathBuilder,
    at: [f32; 2],
    unit: f32,
}

impl GlyphPen {
    fn x(&self, x: f32) -> f32 {
        self.at[0] + self.unit * x
    }

    fn y(&self, y: f32) -> f32 {
        self.at[1] + self.unit * y
    }
}

impl OutlineBuilder for GlyphPen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.move_to(self.x(x), self.y(y));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.path.line_to(self.x(x), self.y(y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.path.quad_to(self.x(x1), self.y(y1), self.x(x), self.y(y));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (x1, y1, x2, y2) = (self.x(x1), self.y(y1), self.x(x2), self.y(y2));
        self.path.cubic_to(x1, y1, x2, y2, self.x(x), self.y(y));
    }

    fn close(&mut self) {
        self.path.close();
    }
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
