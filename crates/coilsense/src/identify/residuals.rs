//! What a fit leaves: whether it is noise, and whether it asks for one more pole.
//!
//! Next door: the fit (`pole_fit`), what is made of that (`refine`).

use num_complex::Complex;

use super::pole_fit::{Block, Fit, column};

/// Mean square left near the line over that of the whole band, where it is larger by more than chance: noise that is not white.
pub(super) fn near_excess(blocks: &[Block], found: &Fit) -> f64 {
    let (mut near, mut count) = (0.0, 0.0_f64);
    for (block, residual) in blocks.iter().zip(&found.residuals) {
        let reach = 6.0 * std::f64::consts::TAU / block.length as f64 + 2.0 * found.poles[0].re.abs();
        for (angle, value) in block.angles.iter().zip(residual) {
            if (angle - found.poles[0].im).abs() < reach {
                near += value.norm_sqr();
                count += 1.0;
            }
        }
    }
    let ratio = near / count.max(1.0) / found.excess.max(f64::MIN_POSITIVE);
    if ratio > 1.0 + 3.0 / count.max(1.0).sqrt() { ratio } else { 1.0 }
}

/// A pole that what is left asks for: as broad as the line, or far broader, as a folded high mode is.
pub(super) fn left_over(blocks: &[Block], found: &Fit, band: (f64, f64)) -> Option<Complex<f64>> {
    let typical = blocks.first()?.length as f64;
    let step = 0.5 * std::f64::consts::TAU / typical;
    let narrow = found.poles[0].re.abs().max(1.0 / typical);
    let mut best = (0.0, Complex::default());
    let mut angle = band.0 + 2.0 * step;
    while angle < band.1 - 2.0 * step {
        for broader in [1.0, 8.0] {
            let pole = Complex::new(-narrow * broader, angle);
            let score = score(blocks, found, pole);
            if score > best.0 {
                best = (score, pole);
            }
        }
        angle += step;
    }
    let count = blocks.len() as f64;
    let chance = found.excess * (count + 5.0 * count.sqrt() + 12.0);
    (best.0 > chance).then_some(best.1)
}

/// How much of what is left one more pole would take.
fn score(blocks: &[Block], found: &Fit, pole: Complex<f64>) -> f64 {
    let each = blocks.iter().zip(&found.residuals).map(|(block, residual)| {
        let shape = column(pole, &block.turns);
        let part: Complex<f64> = shape.iter().zip(residual).map(|(a, b)| a.conj() * b).sum();
        part.norm_sqr() / shape.iter().map(Complex::norm_sqr).sum::<f64>()
    });
    each.sum()
}
