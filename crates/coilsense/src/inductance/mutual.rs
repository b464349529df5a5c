//! Two coaxial circular rings of one radius: their mutual inductance, one distance or many.
//!
//! Next door: its arithmetic without units (`reduced`), its derivatives (`derivatives`), the sum over all pairs of windings (`maxwell`).

use super::reduced;
use crate::error::{Error, above_zero, count};
use crate::simd;

/// μ₀ \[H/m\]: permeability of vacuum, the paper's "permeability of air"; 4π·10⁻⁷ exactly, as before the 2019 SI.
pub const MU_0: f64 = 4.0e-7 * std::f64::consts::PI;

/// Mutual inductance of two coaxial rings of equal radius \[H\].
///
/// M = 2 μ₀ r y³ D(c), S = √(4r² + h²), y = 2r/(S + h), c = 4hS/(S + h)², D = (K − E)/(1 − c) at complementary parameter c
///
/// - `radius`: r \[m\], above zero; `distance`: h \[m\], of either sign
///
/// Source:   `[Weijde2017]` eqs. 8–9, `[Maxwell1873]` art. 701, after an ascending Landen step (`[DLMF]` 19.8).
/// Valid:    thin rings, direct current, no core. At h = 0 the rings coincide and M is infinite; NaN gives NaN.
/// Accuracy: 2e-15 relative over h/r = 1e-5…1e4, against 40 digits, on every vector path.
/// Differs:  eq. 8 as printed subtracts nearly equal terms: it loses about (h/r)⁴ of its digits far away, and forming 1 − κ² by
///           subtraction loses half of them close by. This form has no difference at all.
///
/// ```
/// use coilsense::inductance::{MU_0, mutual_inductance};
/// let m = mutual_inductance(0.008, 0.008) / (MU_0 * 0.008);
/// assert!((m / 0.393_175_148_372_004_73 - 1.0).abs() < 1e-15);
/// ```
#[inline]
pub fn mutual_inductance(radius: f64, distance: f64) -> f64 {
    2.0 * MU_0 * radius * reduced::mutual::<false>(distance / radius)
}

/// As [`mutual_inductance`] for many distances at once, on the vector path of [`crate::simd::SimdPath::selected`].
///
/// M as above, entry by entry
///
/// - `radius`: r \[m\], above zero; `distances`: h \[m\], shape `count`, of either sign; `inductances`: M \[H\], shape `count`, overwritten
///
/// Source:   as [`mutual_inductance`].
/// Valid:    as [`mutual_inductance`]; an entry's value does not depend on its place or its neighbours.
/// Accuracy: 2e-15 relative over h/r = 1e-5…1e4, against 40 digits, on every vector path.
///
/// # Errors
/// [`Error::Value`] for a radius that is not above zero and finite; [`Error::Count`] where the two slices differ in length.
///
/// ```
/// use coilsense::inductance::{mutual_inductance, mutual_inductances};
/// let mut inductances = [0.0; 3];
/// mutual_inductances(0.008, &[0.004, 0.008, -0.008], &mut inductances)?;
/// assert!((inductances[0] / mutual_inductance(0.008, 0.004) - 1.0).abs() < 2e-15);
/// assert_eq!(inductances[1], inductances[2]);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn mutual_inductances(radius: f64, distances: &[f64], inductances: &mut [f64]) -> Result<(), Error> {
    above_zero("radius", radius, "m")?;
    count("inductances", inductances.len(), distances.len())?;
    simd::dispatch(Many { radius, distances, inductances });
    Ok(())
}

/// One call of [`mutual_inductances`].
struct Many<'a> {
    radius: f64,
    distances: &'a [f64],
    inductances: &'a mut [f64],
}

impl Many<'_> {
    #[inline(always)]
    fn fill<const FUSED: bool>(self) {
        let scale = 2.0 * MU_0 * self.radius;
        for (inductance, distance) in self.inductances.iter_mut().zip(self.distances) {
            *inductance = scale * reduced::mutual::<FUSED>(distance / self.radius);
        }
    }
}

impl pulp::WithSimd for Many<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        if S::IS_SCALAR {
            self.fill::<false>();
        } else {
            self.fill::<true>();
        }
    }
}
