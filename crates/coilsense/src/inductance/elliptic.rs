//! Complete elliptic integrals by their complementary modulus or parameter, so that nothing cancels where rings are near.
//!
//! Next door: the rings (`mutual`).

use std::f64::consts::FRAC_PI_2;

/// Complete elliptic integral of the first kind \[1\].
///
/// K = π / (2 agm(1, k'))
///
/// - `complementary_modulus`: k' = √(1 − κ²), above 0 and at most 1
///
/// Source:   `[DLMF]` 19.8.5.
/// Valid:    0 < k' ≤ 1.
/// Accuracy: 5e-16 relative over k' = 1e-6…1, against 40 digits.
/// Differs:  takes k', not κ: K is singular at κ = 1, where 1 − κ² has lost all its digits.
///
/// ```
/// assert_eq!(coilsense::inductance::elliptic::complete_k(1.0), std::f64::consts::FRAC_PI_2);
/// ```
pub fn complete_k(complementary_modulus: f64) -> f64 {
    FRAC_PI_2 / mean_and_deficit(complementary_modulus).0
}

/// Complete elliptic integral of the second kind \[1\].
///
/// E = K (1 − Σ_{n≥0} 2^(n−1) c_n²), c_0² = 1 − k'², c_{n+1} = (a_n − b_n)/2 of the arithmetic–geometric mean
///
/// - `complementary_modulus`: k', above 0 and at most 1
///
/// Source:   `[DLMF]` 19.8.6.
/// Valid:    0 < k' ≤ 1.
/// Accuracy: 3e-15 relative over k' = 1e-6…1, against 40 digits (the bracket loses a few digits where E → 1 and K grows).
///
/// ```
/// assert!((coilsense::inductance::elliptic::complete_e(1.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// ```
pub fn complete_e(complementary_modulus: f64) -> f64 {
    let (mean, deficit) = mean_and_deficit(complementary_modulus);
    FRAC_PI_2 / mean * (1.0 - deficit)
}

/// Complete elliptic integral D = (K − E)/κ² \[1\].
///
/// D = K (½ + Σ_{n≥1} 2^(n−1) c_n²/κ²), c_1²/κ² = (1 − k')/(4(1 + k')), c_{n+1} = c_n²/(4a_{n+1})
///
/// - `complementary_modulus`: k' = √(1 − κ²), above 0 and at most 1
///
/// Source:   `[DLMF]` 19.2.6 and 19.8.6.
/// Valid:    0 < k' ≤ 1.
/// Accuracy: 1e-15 relative over k' = 1e-6…1, against 40 digits.
/// Differs:  (K − E)/κ² as it stands loses all its digits at κ → 0; this sum has no difference but 1 − k', which is exact from k' = ½ up.
///
/// ```
/// let d = coilsense::inductance::elliptic::complete_d(1.0);
/// assert!((d - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
/// ```
pub fn complete_d(complementary_modulus: f64) -> f64 {
    let kc = complementary_modulus;
    let (mut a, mut b) = (0.5 * (1.0 + kc), kc.sqrt());
    // c_n² and c_n²/κ², which stays where κ² vanishes.
    let (mut c_square, mut share) = (0.25 * (1.0 - kc) * (1.0 - kc), 0.25 * (1.0 - kc) / (1.0 + kc));
    let (mut sum, mut weight) = (0.5, 1.0);
    while share > 1e-17 && weight < 1024.0 {
        sum += weight * share;
        weight *= 2.0;
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        let shrink = c_square / (16.0 * a * a);
        (c_square, share) = (c_square * shrink, share * shrink);
    }
    FRAC_PI_2 / (0.5 * (a + b)) * sum
}

/// agm(1, k') and Σ 2^(n−1) c_n².
fn mean_and_deficit(complementary_modulus: f64) -> (f64, f64) {
    let (mut a, mut b) = (1.0, complementary_modulus);
    let mut deficit = 0.5 * (1.0 - b) * (1.0 + b);
    let mut weight = 1.0;
    // Converges quadratically: seven steps reach the last bit from k' = 1e-6.
    while (a - b) > 1e-16 * a && weight < 1024.0 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        deficit += weight * c * c;
        weight *= 2.0;
    }
    (a, deficit)
}
