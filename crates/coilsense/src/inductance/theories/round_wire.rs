//! What round wire changes of a current sheet: Rosa's two corrections.
//!
//! Next door: the sheet (`nagaoka`), rings of round wire added up (`crate::inductance::MaxwellSum`), round wire as a helix (`helix`).

use std::f64::consts::TAU;

use super::Coil;
use super::nagaoka::nagaoka;
use crate::inductance::MU_0;

/// Rosa's correction k_s of each turn's own inductance \[1\]: a round wire instead of a strip as wide as the pitch.
///
/// k_s = 5/4 − ln(2p/d), d = 2ρ: ln of the strip's geometric mean distance p e^(−3/2) over the wire's ρ e^(−1/4), with the sign turned
///
/// - `pitch`: p \[m\], above zero; `wire_radius`: ρ \[m\]
///
/// Source:   `[Rosa1906]` eq. 26, whose 0.77880 and 0.22313 are e^(−1/4) and e^(−3/2); `[Grover1946]` chapter 16 (its G).
/// Valid:    direct current in round wire, ρ far below the coil radius. Negative where p > 1.75 d.
/// Accuracy: 4e-16 of 1.
///
/// ```
/// use coilsense::inductance::theories::rosa_self;
/// // The sources write ln(1.7452 d/p).
/// assert!((rosa_self(2e-3, 1e-3) - 1.7452_f64.ln()).abs() < 1e-4);
/// ```
pub fn rosa_self(pitch: f64, wire_radius: f64) -> f64 {
    1.25 - (pitch / wire_radius).ln()
}

/// Rosa's correction k_m of the turns' mutual inductances \[1\], of any number of windings.
///
/// k_m = ln 2π − 3/2 − ln N/(6N) − 0.33084236/N − 1/(120N³) + 1/(504N⁵) − 0.0011923/N⁷ + 0.0005068/N⁹
///
/// - `windings`: N, at least 1, may be fractional
///
/// Source:   `[Grover1929]` up to 1/N⁵; the last two terms, which make k_m(1) zero, `[Knight2010]`.
/// Valid:    N ≥ 1; between whole numbers it is an interpolation.
/// Accuracy: 1.4e-8, against [`rosa_mutual_sum`] in 40 digits, N = 1…1000.
///
/// ```
/// use coilsense::inductance::theories::{rosa_mutual, rosa_mutual_sum};
/// assert!((rosa_mutual(10.0) - rosa_mutual_sum(10)).abs() < 1.4e-8);
/// ```
pub fn rosa_mutual(windings: f64) -> f64 {
    let inverse = 1.0 / windings;
    let square = inverse * inverse;
    let odd = square * (-1.0 / 120.0 + square * (1.0 / 504.0 + square * (-0.001_192_3 + square * 0.000_506_8)));
    TAU.ln() - 1.5 - inverse * (windings.ln() / 6.0 + 0.330_842_36 - odd)
}

/// The same for a whole number of turns, without a series in N.
///
/// k_m = (2/N) Σ_{i=1}^{N−1} (N − i)(ln i − ln R_i), ln i − ln R_i = Σ_{j≥1} i^(−2j) / (2j(j + 1)(2j + 1))
///
/// - `turns`: N; zero and one turn give zero
///
/// Source:   `[Rosa1906]` eqs. 13 and 27: R_i, the geometric mean distance of two strips of width 1 that are i apart.
/// Valid:    any N; the work grows with N.
/// Accuracy: 1e-15, against 40 digits.
/// Differs:  at i = 1, where the series converges slowly, the closed form 3/2 − 2 ln 2 is taken.
///
/// ```
/// use coilsense::inductance::theories::rosa_mutual_sum;
/// assert!((rosa_mutual_sum(2) - (1.5 - 4.0_f64.ln())).abs() < 1e-15);
/// ```
pub fn rosa_mutual_sum(turns: usize) -> f64 {
    let terms = (1..turns).rev().map(|apart| (turns - apart) as f64 * nearness(apart as f64));
    2.0 / turns.max(1) as f64 * terms.sum::<f64>()
}

/// ln i − ln R_i.
fn nearness(apart: f64) -> f64 {
    if apart < 1.5 {
        return 1.5 - 4.0_f64.ln();
    }
    let square = 1.0 / (apart * apart);
    // 4^(−j) is below the last bit from j = 26 on.
    (1..27).rev().map(f64::from).fold(0.0, |sum, j| (sum + 1.0 / (2.0 * j * (j + 1.0) * (2.0 * j + 1.0))) * square)
}

/// Inductance of a coil of round wire \[H\]: the current sheet with Rosa's corrections.
///
/// L = L_Nagaoka − μ₀ r N (k_s + k_m), p = l/N
///
/// - `length`: l \[m\], above zero
///
/// Source:   `[Rosa1906]` eq. 27; k_m by [`rosa_mutual`], so that N may be fractional.
/// Valid:    direct current, circular turns (no pitch angle), ρ far below r. It ignores what the sheet's axial current adds.
/// Accuracy: within 5e-4 of Maxwell's sum over whole turns of springs: the corrections are those of straight strips, L of circles.
///
/// ```
/// use coilsense::inductance::theories::{Coil, nagaoka, nagaoka_rosa};
/// let coil = Coil::new(41.904, 8.47e-3, 1.41e-3)?;
/// assert!(nagaoka_rosa(&coil, 0.118) < nagaoka(&coil, 0.118));
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn nagaoka_rosa(coil: &Coil, length: f64) -> f64 {
    let windings = coil.windings();
    let correction = rosa_self(length / windings, coil.wire_radius()) + rosa_mutual(windings);
    nagaoka(coil, length) - MU_0 * coil.coil_radius() * windings * correction
}
