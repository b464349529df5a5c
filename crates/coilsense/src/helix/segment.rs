//! The dynamic stiffness of a short piece of the stretched helix, exact, as a series in λ = ω².
//!
//! Next door: the state that the wire is in (`state`), how pieces join (`block`).

use super::block::{Block, Number, Square, reduce};
use super::state::{Helix, Scaled};

/// Terms of the series: with λ at most 1/125 of the first mode of the held piece the last one is 125⁻⁷ = 2e-15 of the first.
const TERMS: usize = 7;

/// One of a power of two equal pieces of the wire.
///
/// Small motions about the stretched state, in spatial resultants and in the section's axes, y = (w, θ, N, M):
///
/// ```text
/// δ  = −v×θ + C_n (N − θ×n)           w' = −u×w + δ          θ' = −u×θ + C_m (M − θ×m)
/// N' = −u×N − λ w                     M' = −u×M − v×N − δ×n − λ J θ
/// ```
///
/// Constant coefficients: exp of the 12 x 12 matrix times the length leads from one end to the other, and a power series of it in λ
/// stays in place of one exponential per frequency. Rotations of the ends are taken as rotation vectors, ±½ m×θ, which makes the
/// stiffness symmetric under load.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    /// Matrices of λ⁰, λ¹, ...
    series: [Square<f64, 12>; TERMS],
    /// log2 of how many make the wire.
    doublings: u32,
    /// Largest λ up to which the series holds.
    most: f64,
    /// Largest difference of the static stiffness to its transpose, relative to the largest entry, before both are averaged.
    #[cfg_attr(not(test), allow(dead_code))]
    asymmetry: f64,
}

/// λ h⁴ up to which a piece of length h is followed: 1/125 of the first mode of a held beam, (22.4)².
const MOST_BENDING: f64 = 4.0;

/// λ c h² up to which it is followed, c the compliance to shear: 1/125 of π².
const MOST_SHEAR: f64 = 0.079;

/// Length of a part that is taken by Taylor's series, in radii of the coil.
const SHORT: f64 = 0.5;

/// Halvings of the wire that are tried: a million pieces, as many as no spring needs.
const MOST_DOUBLINGS: u32 = 20;

impl Segment {
    /// So many pieces that one winding has at least `per_winding`, and more where λ asks for them; `None` beyond any use.
    pub fn new(helix: &Helix, per_winding: f64, lambda: f64) -> Option<Self> {
        let windings = helix.rod().parameters().windings;
        // At least eight pieces: the wire is put together from unequal parts.
        let least = (per_winding * windings).log2().ceil().clamp(3.0, f64::from(MOST_DOUBLINGS)) as u32;
        let doublings = (least..=MOST_DOUBLINGS).find(|doublings| most(&helix.scaled, *doublings) >= lambda)?;
        Some(Self::at_level(&helix.scaled, doublings))
    }

    fn at_level(state: &Scaled, doublings: u32) -> Self {
        let length = state.wire / f64::from(1 << doublings);
        let transfer = exponential(&system(state), state.inertia, length);
        let (series, asymmetry) = stiffness(&transfer, &state.m);
        Self { series, doublings, most: most(state, doublings), asymmetry }
    }

    /// log2 of how many make the wire.
    pub fn doublings(&self) -> u32 {
        self.doublings
    }

    /// Largest λ up to which it may be asked.
    pub fn most(&self) -> f64 {
        self.most
    }

    /// The piece at one λ.
    pub fn at<T: Number>(&self, lambda: T) -> Block<T> {
        let stiffness = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let terms = self.series.iter().rev();
                terms.fold(T::zero(), |sum, term| sum * lambda + T::real(term[i][j]))
            })
        });
        Block { stiffness, below: 0 }
    }

    /// Mass of the piece as a motion of its ends moves it, −dK/dλ.
    pub fn mass(&self, lambda: f64) -> Square<f64, 12> {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let terms = self.series.iter().enumerate().skip(1).rev();
                terms.fold(0.0, |sum, (power, term)| sum * lambda - power as f64 * term[i][j])
            })
        })
    }
}

/// Largest λ for pieces of one of 2^doublings.
fn most(state: &Scaled, doublings: u32) -> f64 {
    let length = state.wire / f64::from(1 << doublings);
    let shear = if state.shear > 0.0 { MOST_SHEAR / (state.shear * length.powi(2)) } else { f64::INFINITY };
    shear.min(MOST_BENDING / length.powi(4))
}

/// The matrix X with X b = a × b.
pub(super) fn cross([x, y, z]: [f64; 3]) -> Square<f64, 3> {
    [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
}

/// The matrix of the equations at λ = 0.
fn system(state: &Scaled) -> Square<f64, 12> {
    let compliance = [state.extension, state.shear, state.shear];
    let flexibility = [1.0 / state.torsion, 1.0, 1.0];
    let (u, v) = (cross(state.u), cross(state.v));
    let (n, m) = (cross(state.n), cross(state.m));
    let mut a = [[0.0; 12]; 12];
    // δ as a row of (w, θ, N, M): −v×θ + C_n N + C_n n×θ.
    let mut delta = [[0.0; 12]; 3];
    for i in 0..3 {
        for j in 0..3 {
            delta[i][3 + j] = compliance[i] * n[i][j] - v[i][j];
            for part in [0, 3, 6, 9] {
                a[part + i][part + j] = -u[i][j];
            }
            a[3 + i][3 + j] += flexibility[i] * m[i][j];
            a[9 + i][6 + j] = -v[i][j];
        }
        delta[i][6 + i] = compliance[i];
        a[3 + i][9 + i] = flexibility[i];
    }
    for i in 0..3 {
        for j in 0..12 {
            a[i][j] += delta[i][j];
            a[9 + i][j] += (0..3).map(|k| n[i][k] * delta[k][j]).sum::<f64>();
        }
    }
    a
}

/// Series in λ of exp((a + λ b) length), b the inertia: by squaring that of a part so short that its terms fall from the first on.
fn exponential(a: &Square<f64, 12>, inertia: f64, length: f64) -> [Square<f64, 12>; TERMS] {
    let squarings = (length / SHORT).log2().ceil().max(0.0);
    let mut transfer = taylor(a, inertia, length / squarings.exp2());
    for _ in 0..squarings as u32 {
        transfer = product(&transfer, &transfer);
    }
    transfer
}

/// The same by Taylor's series, b: −1 from w to N and −J from θ to M.
fn taylor(a: &Square<f64, 12>, inertia: f64, length: f64) -> [Square<f64, 12>; TERMS] {
    let inertia = [1.0, 1.0, 1.0, 2.0 * inertia, inertia, inertia];
    let mut power = [[[0.0; 12]; 12]; TERMS];
    for (i, row) in power[0].iter_mut().enumerate() {
        row[i] = 1.0;
    }
    let mut sum = power;
    for order in 1..100 {
        let step = length / f64::from(order);
        let mut next = [[[0.0; 12]; 12]; TERMS];
        let mut largest = 0.0_f64;
        for term in 0..TERMS {
            for i in 0..12 {
                let mut row = [0.0; 12];
                for (k, factor) in a[i].iter().enumerate().filter(|(_, factor)| **factor != 0.0) {
                    (0..12).for_each(|j| row[j] += factor * power[term][k][j]);
                }
                if term > 0 && i >= 6 {
                    (0..12).for_each(|j| row[j] -= inertia[i - 6] * power[term - 1][i - 6][j]);
                }
                for j in 0..12 {
                    next[term][i][j] = row[j] * step;
                    sum[term][i][j] += next[term][i][j];
                    largest = largest.max(next[term][i][j].abs());
                }
            }
        }
        power = next;
        if largest < 1e-20 {
            break;
        }
    }
    sum
}

/// Product of two series of matrices.
fn product<const N: usize>(one: &[Square<f64, N>; TERMS], other: &[Square<f64, N>; TERMS]) -> [Square<f64, N>; TERMS] {
    let mut sum = [[[0.0; N]; N]; TERMS];
    for p in 0..TERMS {
        for q in 0..TERMS - p {
            for i in 0..N {
                for k in 0..N {
                    let factor = one[p][i][k];
                    (0..N).for_each(|j| sum[p + q][i][j] += factor * other[q][k][j]);
                }
            }
        }
    }
    sum
}

/// Inverse of a series of 6 x 6 matrices.
fn inverse(series: &[Square<f64, 6>; TERMS]) -> [Square<f64, 6>; TERMS] {
    let mut first: [[f64; 12]; 6] =
        std::array::from_fn(|i| std::array::from_fn(|j| if j < 6 { series[0][i][j] } else { f64::from(i + 6 == j) }));
    reduce(&mut first);
    let mut result = [[[0.0; 6]; 6]; TERMS];
    result[0] = std::array::from_fn(|i| std::array::from_fn(|j| first[i][6 + j]));
    for p in 1..TERMS {
        let sum = product(series, &result)[p];
        let first = result[0];
        result[p] = first.map(|row| std::array::from_fn(|j| -(0..6).map(|k| row[k] * sum[k][j]).sum::<f64>()));
    }
    result
}

/// Series of the stiffness from that of the transfer matrix, made symmetric, and how far it was from it.
fn stiffness(transfer: &[Square<f64, 12>; TERMS], couple: &[f64; 3]) -> ([Square<f64, 12>; TERMS], f64) {
    let part = |row: usize, column: usize| -> [Square<f64, 6>; TERMS] {
        std::array::from_fn(|p| std::array::from_fn(|i| std::array::from_fn(|j| transfer[p][row + i][column + j])))
    };
    let from_far = inverse(&part(0, 6));
    let from_near = product(&from_far, &part(0, 0));
    let (far_far, far_near) = (product(&part(6, 6), &from_far), product(&part(6, 6), &from_near));
    let (half, mut asymmetry) = (cross(couple.map(|value| 0.5 * value)), 0.0_f64);
    let series = std::array::from_fn(|p| {
        let mut k = [[0.0; 12]; 12];
        for i in 0..6 {
            for j in 0..6 {
                k[i][j] = from_near[p][i][j];
                k[i][6 + j] = -from_far[p][i][j];
                k[6 + i][j] = transfer[p][6 + i][j] - far_near[p][i][j];
                k[6 + i][6 + j] = far_far[p][i][j];
                if p == 0 && i >= 3 && j >= 3 {
                    k[i][j] -= half[i - 3][j - 3];
                    k[6 + i][6 + j] += half[i - 3][j - 3];
                }
            }
        }
        let largest = k.iter().flatten().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let averaged: Square<f64, 12> = std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (k[i][j] + k[j][i])));
        let apart = (0..144).map(|at| (k[at / 12][at % 12] - averaged[at / 12][at % 12]).abs()).fold(0.0, f64::max);
        if p == 0 {
            asymmetry = 2.0 * apart / largest;
        }
        averaged
    });
    (series, asymmetry)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::helix::{Hand, Rod, RodParameters, Turning};

    /// S_T-like at 230 mm, and a thick compressed coil, either under load.
    fn loaded() -> [Helix; 2] {
        let s_t = RodParameters {
            wire_diameter: 0.002,
            coil_radius: 0.008,
            windings: 52.0,
            rest_span: 0.104,
            youngs_modulus: 206e9,
            shear_modulus: 81.5e9,
            density: 7850.0,
            hand: Hand::Right,
        };
        let thick =
            RodParameters { wire_diameter: 0.004, coil_radius: 0.0125, windings: 5.75, rest_span: 0.049, ..s_t };
        [(s_t, 0.230), (thick, 0.035)]
            .map(|(parameters, span)| Helix::new(&Rod::new(parameters).unwrap(), span, Turning::Held).unwrap())
    }

    #[test]
    fn the_stiffness_of_a_piece_is_symmetric_under_load() {
        for helix in loaded() {
            for per_winding in [2.0, 4.0, 8.0, 32.0] {
                // Rounding of the exponential and of one inverse; without the rotation vectors of the ends it is 1e-3.
                let asymmetry = Segment::new(&helix, per_winding, 0.0).unwrap().asymmetry;
                assert!(asymmetry < 1e-14, "{asymmetry:e}");
            }
        }
    }

    #[test]
    fn the_series_ends_early_enough() {
        for helix in loaded() {
            let long = Segment::new(&helix, 4.0, 0.0).unwrap();
            let lambda = long.most();
            let short = Segment::at_level(&helix.scaled, long.doublings() + 1);
            let (one, two) = (long.at(lambda), short.at(lambda).then(&short.at(lambda)));
            let largest = one.stiffness.iter().flatten().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            for (one, two) in one.stiffness.iter().flatten().zip(two.stiffness.iter().flatten()) {
                // At the largest λ that is taken: the first term left out, and rounding of the join.
                assert!((one - two).abs() < 1e-12 * largest, "{one} {two}");
            }
        }
    }
}
