//! Polynomials through values at Chebyshev's points of the first kind.
//!
//! Next door: mutual inductance by lag (`lag_polynomials`), uniform turns by pitch (`near_uniform`).

use std::f64::consts::PI;

/// What turns `count` values at Chebyshev's points into the coefficients of 1, z, z² … of the polynomial through them, z from −1 to 1.
///
/// By way of Chebyshev's coefficients: straight from the values, coefficients of high powers would drown in the values' rounding.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Interpolation {
    /// z of each value, in (−1, 1), rising.
    nodes: Vec<f64>,
    /// Chebyshev's coefficient by value, shape `count × count`.
    transform: Vec<f64>,
    /// Powers in each Chebyshev polynomial, shape `count × count`: whole numbers.
    powers: Vec<f64>,
}

impl Interpolation {
    pub(super) fn new(count: usize) -> Self {
        let angle = |node: usize| PI * (count as f64 - 0.5 - node as f64) / count as f64;
        let entry = |degree: usize, node: usize| {
            let scale = if degree == 0 { 1.0 } else { 2.0 };
            scale / count as f64 * (degree as f64 * angle(node)).cos()
        };
        let transform = (0..count).flat_map(|degree| (0..count).map(move |node| entry(degree, node))).collect();
        let mut powers = vec![0.0; count * count];
        for degree in 0..count {
            // T_0 = 1, T_1 = z, T_k = 2 z T_(k−1) − T_(k−2)
            for power in 0..=degree {
                let before = |back: usize, power: usize| powers[(degree - back) * count + power];
                powers[degree * count + power] = match degree {
                    0 => 1.0,
                    1 => power as f64,
                    _ => (if power > 0 { 2.0 * before(1, power - 1) } else { 0.0 }) - before(2, power),
                };
            }
        }
        Self { nodes: (0..count).map(|node| angle(node).cos()).collect(), transform, powers }
    }

    pub(super) fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// |Chebyshev's coefficients| of the two highest degrees together, of which one may happen to be nothing.
    pub(super) fn highest(&self, values: &[f64]) -> f64 {
        let rows = self.transform.chunks_exact(self.nodes.len()).rev().take(2);
        rows.map(|row| row.iter().zip(values).map(|(entry, value)| entry * value).sum::<f64>().abs()).sum()
    }

    /// The coefficients, lowest power first; shapes `count`.
    pub(super) fn coefficients(&self, values: &[f64], coefficients: &mut [f64]) {
        let count = self.nodes.len();
        coefficients.fill(0.0);
        for (transform, powers) in self.transform.chunks_exact(count).zip(self.powers.chunks_exact(count)) {
            let chebyshev: f64 = transform.iter().zip(values).map(|(entry, value)| entry * value).sum();
            for (coefficient, power) in coefficients.iter_mut().zip(powers) {
                *coefficient += chebyshev * power;
            }
        }
    }
}

/// How fast Chebyshev's coefficients shrink for what is analytic but left of `left`, on an interval of half-width `half` about `middle`:
/// the ρ of Bernstein's ellipse that reaches there. At most 1 where it is within the interval.
///
/// |f − p| ≤ 4 M ρ^(−n)/(ρ − 1) for degree n and M the largest |f| on the ellipse
///
/// Source: `[Trefethen2013]` theorem 8.2.
pub(super) fn ellipse(middle: f64, half: f64, left: f64) -> f64 {
    let reach = (middle - left) / half;
    if reach > 1.0 { reach + (reach * reach - 1.0).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polynomial_passes_through_its_values_and_converges_at_the_rate_of_its_ellipse() {
        // ln h on 1 ± 0.1: singular at 0 only, and largest on the ellipse at its left.
        let (half, left) = (0.1, 0.25);
        let rho = ellipse(1.0, half, left);
        for count in 2..16 {
            let interpolation = Interpolation::new(count);
            let values: Vec<f64> = interpolation.nodes().iter().map(|z| (1.0 + half * z).ln()).collect();
            let mut coefficients = vec![0.0; count];
            interpolation.coefficients(&values, &mut coefficients);
            let at = |z: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * z + c);
            for (z, value) in interpolation.nodes().iter().zip(&values) {
                assert!((at(*z) - value).abs() < 1e-15, "{count}");
            }
            // Of cos(n arccos z), by projection on a thousand points.
            let projected = |degree: usize| {
                let angles = (0..1000).map(|k| PI * (f64::from(k) + 0.5) / 1000.0);
                let each = angles.map(|angle| at(angle.cos()) * (degree as f64 * angle).cos());
                (if degree == 0 { 1e-3 } else { 2e-3 }) * each.sum::<f64>()
            };
            let two = projected(count - 1).abs() + projected(count - 2).abs();
            assert!((interpolation.highest(&values) - two).abs() < 1e-14, "{count}");
            // |ln h| ≤ |ln left| + π on the ellipse, within the right half-plane.
            let bound = 4.0 * (left.ln().abs() + PI) * rho.powi(1 - count as i32) / (rho - 1.0);
            for k in 0..=100 {
                let z = -1.0 + 0.02 * f64::from(k);
                assert!((at(z) - (1.0 + half * z).ln()).abs() < bound + 1e-15, "{count} at {z}");
            }
        }
    }
}
