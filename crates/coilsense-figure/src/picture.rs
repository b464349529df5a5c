//! A picture of few colours: indices into a palette, as a file of its own or as painted dots.
//!
//! What it shows is `heat`'s matter.

use ::png::{BitDepth, ColorType, Compression, Encoder, EncodingError};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::PlotError;
use crate::stroke::Rgb;

/// Dots in rows from the top, each the index of a colour.
#[derive(Debug, Clone)]
pub(crate) struct Picture {
    pub columns: usize,
    pub dots: Vec<u8>,
    /// At most 256 colours; none lets the paper show.
    pub palette: Vec<Option<Rgb>>,
}

impl Picture {
    pub fn rows(&self) -> usize {
        self.dots.len() / self.columns.max(1)
    }

    /// Each dot as red, green, blue and opacity.
    pub fn rgba(&self) -> impl Iterator<Item = [u8; 4]> {
        self.dots.iter().map(|&index| match self.palette.get(usize::from(index)) {
            Some(Some([red, green, blue])) => [*red, *green, *blue, 255],
            _ => [0; 4],
        })
    }

    /// The picture as a PNG inside a URI.
    pub fn data_uri(&self) -> Result<String, PlotError> {
        let file = self.packed().map_err(|error| PlotError::Png(error.to_string()))?;
        Ok(format!("data:image/png;base64,{}", STANDARD.encode(file)))
    }

    fn packed(&self) -> Result<Vec<u8>, EncodingError> {
        let mut file = Vec::new();
        let mut encoder = Encoder::new(&mut file, self.columns as u32, self.rows() as u32);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_compression(Compression::Balanced);
        encoder.set_palette(self.palette.iter().flat_map(|colour| colour.unwrap_or_default()).collect::<Vec<u8>>());
        let opacities = self.palette.iter().map(|colour| if colour.is_some() { 255 } else { 0 });
        encoder.set_trns(opacities.collect::<Vec<u8>>());
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.dots)?;
        writer.finish()?;
        Ok(file)
    }
}
