//! L to second order about uniform turns, with a bound of its error.
//!
//! Next door: the series that uses it only where the bound is met (`within`), coefficients (`expansion`), the quadratic form
//! (`quadratic`), the exact sum (`maxwell`).

use super::expansion::{Expansion, LANES, Lanes};
use super::maxwell::MaxwellSum;
use super::quadratic::Samples;
use crate::error::{Error, above_zero, all_finite, count};

/// What rounding may add to either form, relative to L, for up to some hundred turns.
pub(super) const ROUNDING: f64 = 1e-14;

/// Inductance of turns near their uniform spacing at one length, to second order in their displacements δ.
///
/// L ≈ L0 + gᵀδ + ½ δᵀHδ, ½ δᵀHδ = Σ_a M″(ap) Σ_i (δ_{i+a} − δ_i)², p = l/N_L; H couples modes of equal parity only
///
/// |error| ≤ ε/(1 − ε)⁶ Σ_a ⅓ |M‴(ap)| ap Σ_i (δ_{i+a} − δ_i)² + 1e-14 L, ε = max_i |δ_{i+1} − δ_i| / p
///
/// The bound is Taylor's remainder pair by pair. M is completely monotone in h, M = π μ₀ r² ∫ J₁(κr)² e^(−κh) dκ, so |M‴| is largest at
/// the smallest distance on the way; turns a apart come no nearer than ap(1 − ε) and their distance changes by aεp at most; and
/// |M‴(h(1 − ε))| ≤ |M‴(h)| (1 − ε)⁻⁶ because −d ln|M‴|/d ln h stays below 6 (checked on a grid of 1800 distances over h/r = 1e-5…1e4,
/// not proven). Where ε ≥ 1 the bound is infinite.
///
/// Source:   Taylor's theorem on `[Weijde2017]` eq. 11; M″, M‴ of [`super::mutual_inductance_derivatives`].
/// Valid:    as [`MaxwellSum`]; useful where neighbours' distances change by a few per cent.
/// Accuracy: its own bound, which the tests hold against the exact sum.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::inductance::{MaxwellSum, SecondOrder, SelfDistance};
/// let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
/// let near = SecondOrder::about(&coil, 0.23)?.at_displacements(&[0.0; 52])?;
/// assert!((near.inductance / coil.at_length(0.23) - 1.0).abs() < 1e-14);
/// assert!(near.bound <= 1e-14 * near.inductance);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SecondOrder {
    expansion: Expansion,
}

/// An inductance and how far it may be off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundedInductance {
    /// L \[H\].
    pub inductance: f64,
    /// The largest |error| \[H\].
    pub bound: f64,
}

impl SecondOrder {
    /// The expansion about uniform turns at a length \[m\].
    ///
    /// # Errors
    /// [`Error::Value`] for a length that is not finite or not above zero.
    pub fn about(coil: &MaxwellSum, length: f64) -> Result<Self, Error> {
        coil.check_even()?;
        let pitch = above_zero("length", length, "m")? / coil.windings();
        let mut expansion = Expansion::new(coil.places().len());
        expansion.expand(coil, [pitch; LANES]);
        Ok(Self { expansion })
    }

    /// g: ∂L/∂x_t of uniform turns \[H/m\]; shape `turns`.
    pub fn gradient(&self) -> Vec<f64> {
        self.expansion.gradient.iter().map(|lanes| lanes[0]).collect()
    }

    /// M″(ap) \[H/m²\] for turns a = 1…turns − 1 apart: H_ts = −2 M″(|t − s| p), and each row of H sums to zero.
    pub fn curvatures(&self) -> Vec<f64> {
        self.expansion.curvatures.iter().map(|lanes| lanes[0]).collect()
    }

    /// L and its bound for displacements δ of the turns from uniform \[m\], shape `turns`.
    ///
    /// # Errors
    /// [`Error::Count`] for another number of turns; [`Error::Value`] for the first displacement that is not finite.
    pub fn at_displacements(&self, displacements: &[f64]) -> Result<BoundedInductance, Error> {
        count("displacements", displacements.len(), self.expansion.gradient.len())?;
        all_finite("displacements", displacements, "m")?;
        let displacements: Vec<Lanes> = displacements.iter().map(|&value| [value; LANES]).collect();
        Ok(bounded(&self.expansion, &displacements)[0])
    }
}

/// L of every lane with its bound: infinite where neighbours may meet, where the pitch is not above zero, or where NaN came in.
pub(super) fn bounded(expansion: &Expansion, displacements: &[Lanes]) -> [BoundedInductance; LANES] {
    let forms = Samples { expansion, displacements }.forms();
    std::array::from_fn(|lane| {
        let inductance = expansion.inductance[lane] + forms.change[lane];
        let (pitch, strain) = (expansion.pitches[lane], forms.largest[lane] / expansion.pitches[lane]);
        let remainder = if pitch > 0.0 { bound(strain, forms.remainder[lane]) } else { f64::INFINITY };
        BoundedInductance { inductance, bound: remainder + ROUNDING * inductance }
    })
}

/// What terms above the second may add up to \[H\], for strains ε and Σ_a ⅓ |M‴(ap)| ap Σ_i e² \[H\].
pub(super) fn bound(strain: f64, remainder: f64) -> f64 {
    if strain < 1.0 { strain / (1.0 - strain).powi(6) * remainder } else { f64::INFINITY }
}
