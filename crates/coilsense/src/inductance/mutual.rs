//! Two coaxial circular rings of one radius: their mutual inductance.
//!
//! Next door: the integrals by themselves (`elliptic`), the sum over all pairs of windings (`maxwell`).

/// μ₀ \[H/m\]: permeability of vacuum, the paper's "permeability of air"; 4π·10⁻⁷, which the 2019 SI changed by 2e-10 relative at most.
pub const MU_0: f64 = 4.0e-7 * std::f64::consts::PI;

/// Mutual inductance of two coaxial rings of equal radius \[H\].
///
/// M = 2 μ₀ r y³ D(c), S = √(4r² + h²), y = 2r/(S + h), c = 4hS/(S + h)², D = (K − E)/(1 − c) at complementary parameter c
///
/// - `radius`: r \[m\], above zero; `distance`: h \[m\], above zero (at 0 the rings coincide and M is infinite)
///
/// Source:   `[Weijde2017]` eqs. 8–9, `[Maxwell1873]` art. 701, after an ascending Landen step (`[DLMF]` 19.8).
/// Valid:    thin rings, direct current, no core.
/// Accuracy: 2e-15 relative over h/r = 1e-5…1e4, against 40 digits.
/// Differs:  eq. 8 as printed subtracts nearly equal terms: it loses about (h/r)⁴ of its digits far away, and forming 1 − κ² by
///           subtraction loses half of them close by. This form has no difference at all.
///
/// ```
/// use coilsense::inductance::{MU_0, mutual_inductance};
/// let m = mutual_inductance(0.008, 0.008) / (MU_0 * 0.008);
/// assert!((m / 0.393_175_148_372_004_73 - 1.0).abs() < 1e-15);
/// ```
pub fn mutual_inductance(radius: f64, distance: f64) -> f64 {
    2.0 * MU_0 * radius * reduced_mutual(distance / radius)
}

/// y³ D(c) for h/r: all of the mutual inductance but 2 μ₀ r.
fn reduced_mutual(ratio: f64) -> f64 {
    let s = (4.0 + ratio * ratio).sqrt();
    let inverse = 1.0 / (s + ratio);
    let y = 2.0 * inverse;
    let c = y * y * ratio * s;
    y * y * y * elliptic_d(c)
}

/// D = (K − E)/m at complementary parameter c = 1 − m \[1\], as P(c) − Q(c) ln c.
fn elliptic_d(c: f64) -> f64 {
    polynomial(&D_REGULAR, c) - polynomial(&D_LOGARITHM, c) * c.ln()
}

/// Horner's scheme, lowest degree first in `coefficients`.
fn polynomial(coefficients: &[f64; 11], x: f64) -> f64 {
    coefficients
        .iter()
        .rev()
        .fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// P: relative minimax fit of D over c = 1e-12…1, error 4.3e-17; made by `reference/elliptic_d_fit.py`, compared with its file by a test.
const D_REGULAR: [f64; 11] = [
    0.38629436111989063,
    0.03972077087018226,
    0.01380077041176886,
    0.006916723345762544,
    0.004626644351127254,
    0.011039610125396782,
    0.053322646772748845,
    0.12457888108888666,
    0.1111611605990793,
    0.0320280779278331,
    0.0019085167847720944,
];

/// Q: as [`D_REGULAR`].
const D_LOGARITHM: [f64; 11] = [
    0.5,
    0.3749999999967554,
    0.3515624926361114,
    0.3417948583476364,
    0.33631944147020515,
    0.32996009025548206,
    0.30215071544812566,
    0.21163027257842013,
    0.08330766267041059,
    0.01278589154455907,
    0.0004051983383970111,
];

#[cfg(test)]
mod tests {
    use super::{D_LOGARITHM, D_REGULAR};

    #[test]
    fn the_coefficients_are_those_of_the_generator() {
        let file = include_str!("../../../../reference/elliptic_d_fit.csv");
        let rows: Vec<Vec<&str>> = file
            .lines()
            .filter(|line| line.starts_with(|first: char| first.is_ascii_digit()))
            .map(|line| line.split(',').collect())
            .collect();
        assert_eq!(rows.len(), D_REGULAR.len());
        for (index, row) in rows.iter().enumerate() {
            assert_eq!(row[1].parse(), Ok(D_REGULAR[index]));
            assert_eq!(row[2].parse(), Ok(D_LOGARITHM[index]));
        }
    }
}
