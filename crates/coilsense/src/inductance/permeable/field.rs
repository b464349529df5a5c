//! Vector potential and field of a thin ring, over μ₀ and for a current of one ampere.
//!
//! Next door: complete elliptic integrals (`inductance::elliptic`), what rings link (`inductance::rings`), the rings of wire that are made of it (`disc`, `surface`).

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use crate::inductance::elliptic::{complete_d, complete_e, complete_k};
use crate::inductance::mutual::MU_0;
use crate::inductance::rings::mutual_inductance_of_rings;

/// A point of the half-plane beside the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    /// From the axis \[m\], above zero.
    pub r: f64,
    /// Along it \[m\].
    pub z: f64,
}

impl Point {
    /// The same, farther along.
    pub fn moved(self, by: f64) -> Self {
        Self { z: self.z + by, ..self }
    }
}

/// What a ring through `source` does at `at`.
struct Pair {
    source: Point,
    at: Point,
    /// Along the axis \[m\].
    along: f64,
    /// Squares of the longest and the shortest distance of the rings \[m²\].
    far: f64,
    near: f64,
}

impl Pair {
    fn new(source: Point, at: Point) -> Self {
        let along = at.z - source.z;
        let square = along * along;
        Self { source, at, along, far: (at.r + source.r).powi(2) + square, near: (at.r - source.r).powi(2) + square }
    }

    /// Along r and z, from K and from E over `near`.
    fn components(&self, k: f64, e_over_near: f64) -> [f64; 2] {
        let (source, at, along) = (self.source.r * self.source.r, self.at.r * self.at.r, self.along * self.along);
        let scale = 1.0 / (TAU * self.far.sqrt());
        [
            scale * self.along / self.at.r * ((source + at + along) * e_over_near - k),
            scale * ((source - at - along) * e_over_near + k),
        ]
    }
}

/// A/μ₀ of a ring at a point \[A\]: of what a ring there links with it, so much for each metre round.
pub(super) fn potential(source: Point, at: Point) -> f64 {
    mutual_inductance_of_rings([source.r, at.r], at.z - source.z) / (MU_0 * TAU * at.r)
}

/// B/μ₀ of a ring at a point, along r and along z \[A/m\].
pub(super) fn field(source: Point, at: Point) -> [f64; 2] {
    let pair = Pair::new(source, at);
    let complement = (pair.near / pair.far).sqrt();
    pair.components(complete_k(complement), complete_e(complement) / pair.near)
}

/// What goes with ln k'² in that: K = −K̂/π ln k'² + …, E = −(K̂ − Ê)/π ln k'² + …, of which the rest is smooth, K̂ and Ê being those of modulus k'.
pub(super) fn logarithmic_part(source: Point, at: Point) -> [f64; 2] {
    let pair = Pair::new(source, at);
    let square = pair.near / pair.far;
    let modulus = (1.0 - square).max(0.0).sqrt();
    // (K̂ − Ê)/k'², which is what E over the near distance has; at coinciding points that of modulus zero.
    let d = if square > 0.0 { complete_d(modulus) } else { FRAC_PI_4 };
    pair.components(-complete_k(modulus) / PI, -d / (PI * pair.far))
}
