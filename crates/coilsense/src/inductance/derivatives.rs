//! How the mutual inductance of two equal rings changes with their distance: one pair with units, or rows of pairs without.
//!
//! Next door: the arithmetic (`reduced`), the coil's gradient and Hessian (`gradient`), its second-order form (`second_order`).

use super::mutual::MU_0;
use super::reduced;
use crate::simd;

/// Mutual inductance of two equal coaxial rings and its derivatives by their distance h.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MutualDerivatives {
    /// M \[H\].
    pub value: f64,
    /// dM/dh \[H/m\].
    pub first: f64,
    /// d²M/dh² \[H/m²\].
    pub second: f64,
    /// d³M/dh³ \[H/m³\].
    pub third: f64,
}

/// M, dM/dh, d²M/dh² and d³M/dh³ of two coaxial rings of equal radius.
///
/// With M = 2 μ₀ r y³ D and θ = y d/dy (y, c, S of [`super::mutual_inductance`], q = h/r, s = S/r, m = 1 − c = y⁴, B = (E − cK)/m):
///
/// - t₁ = D + 2B/c, t₂ = D + 4(B + D)/c + 8mB/c², t₃ = D + (6B + 12D)/c + ((24m + 8)B + 32mD)/c² + 32m(1 + m)B/c³,
///   which are θ, θ², θ³ of y³D over y³;
/// - M′ = −2 μ₀ (y³/s) t₁, M″ = (2 μ₀/r)(y³/s²)(t₂ + (q/s) t₁), M‴ = −(2 μ₀/r²)(y³/s³)(t₃ + 3(q/s) t₂ + (3q²/s² − 1) t₁)
///
/// - `radius`: r \[m\], above zero; `distance`: h \[m\], of either sign: M is even in h
///
/// Source:   eq. 8 of `[Weijde2017]` after a Landen step, with 2m dD/dm = B/c − D and 2m dB/dm = D − B (`[DLMF]` 19.4).
/// Valid:    as [`super::mutual_inductance`]; infinite at h = 0.
/// Accuracy: 5e-15 relative over h/r = 1e-5…1e4, against 40 digits, on every vector path.
/// Differs:  the textbook form (2 − κ²)/(1 − κ²) E − 2K cancels far away; here all terms but the last −t₁ (at most t₃/9) are positive.
///
/// ```
/// use coilsense::inductance::mutual_inductance_derivatives;
/// let rings = mutual_inductance_derivatives(0.008, 0.004);
/// assert!(rings.value > 0.0 && rings.first < 0.0 && rings.second > 0.0 && rings.third < 0.0);
/// ```
pub fn mutual_inductance_derivatives(radius: f64, distance: f64) -> MutualDerivatives {
    let [value, first, second, third] = reduced::with_derivatives::<false>(distance / radius);
    let scale = 2.0 * MU_0;
    let sign = if distance < 0.0 { -1.0 } else { 1.0 };
    MutualDerivatives {
        value: scale * radius * value,
        first: sign * scale * first,
        second: scale / radius * second,
        third: sign * scale / (radius * radius) * third,
    }
}

/// Replaces every q = h/r by the derivative of order `ORDER` of F by |q|; of order 0 by F itself.
pub(super) fn replace<const ORDER: usize>(ratios: &mut [f64]) {
    simd::dispatch(Replace::<'_, ORDER>(ratios));
}

/// One call of [`replace`].
struct Replace<'a, const ORDER: usize>(&'a mut [f64]);

impl<const ORDER: usize> pulp::WithSimd for Replace<'_, ORDER> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        for ratio in self.0.iter_mut() {
            *ratio = if S::IS_SCALAR {
                reduced::with_derivatives::<false>(*ratio)[ORDER]
            } else {
                reduced::with_derivatives::<true>(*ratio)[ORDER]
            };
        }
    }
}
