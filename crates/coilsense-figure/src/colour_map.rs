//! From a value to a colour: even to the eye, and told apart by colour-blind readers.
//!
//! Colours are set out in Oklab (Björn Ottosson, 2020), in which equal steps look equal, with
//! lightness rising or falling evenly; hue only runs between blue and yellow or orange, which
//! the common kinds of colour blindness keep. What is coloured is `heat`'s matter.

use crate::Theme;
use crate::stroke::Rgb;

/// Number of colours of a scale: odd, so that one of them stands for zero.
pub(crate) const LEVELS: usize = 251;

/// How colours go with values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// From little to much, away from the paper.
    Sequential,
    /// From blue over the paper's shade, at zero, to orange.
    Diverging,
}

/// Lightness, chroma, and hue in degrees.
type Lch = [f64; 3];

/// The colours of a scale, from its lower to its upper end.
pub(crate) fn colours(kind: Kind, theme: Theme) -> Vec<Rgb> {
    let stations: &[Lch] = match (kind, theme) {
        (Kind::Sequential, Theme::Light) => {
            &[[0.97, 0.035, 105.0], [0.785, 0.10, 165.0], [0.60, 0.115, 235.0], [0.415, 0.125, 275.0]]
        }
        (Kind::Sequential, Theme::Dark) => {
            &[[0.27, 0.06, 285.0], [0.46, 0.125, 260.0], [0.65, 0.105, 210.0], [0.84, 0.12, 120.0]]
        }
        (Kind::Diverging, Theme::Light) => {
            &[[0.45, 0.15, 258.0], [0.71, 0.11, 248.0], [0.97, 0.0, 0.0], [0.71, 0.13, 62.0], [0.45, 0.115, 48.0]]
        }
        (Kind::Diverging, Theme::Dark) => {
            &[[0.80, 0.10, 235.0], [0.535, 0.125, 250.0], [0.27, 0.0, 0.0], [0.535, 0.115, 52.0], [0.80, 0.135, 72.0]]
        }
    };
    let stations: Vec<[f64; 3]> = stations.iter().copied().map(lab).collect();
    (0..LEVELS).map(|level| srgb(between(&stations, level as f64 / (LEVELS - 1) as f64))).collect()
}

/// Lightness and the two opponent colours.
fn lab([lightness, chroma, hue]: Lch) -> [f64; 3] {
    let (sine, cosine) = hue.to_radians().sin_cos();
    [lightness, chroma * cosine, chroma * sine]
}

/// The colour at a share of the way along evenly spaced stations.
fn between(stations: &[[f64; 3]], share: f64) -> [f64; 3] {
    let legs = stations.len() - 1;
    let place = share * legs as f64;
    let leg = (place as usize).min(legs - 1);
    let part = place - leg as f64;
    [0, 1, 2].map(|axis| (1.0 - part) * stations[leg][axis] + part * stations[leg + 1][axis])
}

/// From Oklab to what a screen is told; the matrices are Ottosson's.
fn srgb([lightness, a, b]: [f64; 3]) -> Rgb {
    let cones = [
        lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b,
        lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b,
        lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b,
    ];
    let [l, m, s] = cones.map(|cone| cone.powi(3));
    let linear = [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ];
    linear.map(|light| {
        let light = light.clamp(0.0, 1.0);
        let shown = if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
        (255.0 * shown).round() as u8
    })
}
