//! Force in at one end, force out at the clamped other end, over frequency: eq. (1) of the paper and the same for its chain.
//!
//! Next door: the modes behind the peaks (`modes`).

use std::f64::consts::PI;

/// Transmittance of the continuous coil, real and dimensionless: force out over force in, far end clamped.
///
/// F_o/F_i = 2 / (e^(jωτ) + e^(−jωτ)) = 1 / cos(ωτ)
///
/// - `transit_time`: τ \[s\]; `angular_frequency`: ω \[rad/s\]
///
/// Source:   `[Weijde2017]` eq. 1.
/// Valid:    a uniform undamped coil.
/// Accuracy: rounding of ωτ, so 1e-16 · ωτ tan(ωτ) relative; poles at the fixed–free frequencies (j−½)π/τ.
/// Differs:  the paper reads eq. 3's frequencies beside its Fig. 2; the poles of eq. 1 are the fixed–free ones, half way between.
///
/// ```
/// let tau = (0.065_f64 / 760.0).sqrt();
/// assert_eq!(coilsense::transmittance::continuous(tau, 0.0), 1.0);
/// ```
pub fn continuous(transit_time: f64, angular_frequency: f64) -> f64 {
    1.0 / (angular_frequency * transit_time).cos()
}

/// Transmittance of the paper's chain of N masses, real and dimensionless: force out over force in, far end clamped.
///
/// F_o/F_i = 1 / cos(Nθ), sin(θ/2) = ωτ/2N; above cut-off (ωτ > 2N) it is (−1)^N / cosh(2N arcosh(ωτ/2N))
///
/// - `masses`: N; `transit_time`: τ \[s\]; `angular_frequency`: ω \[rad/s\]
///
/// Source:   `[Weijde2017]` eqs. 4–7 with a harmonic force at end 1, by the chain's dispersion relation.
/// Valid:    no damping.
/// Accuracy: 1e-10 relative against a direct solve of the equations in the tests, away from the poles.
///
/// ```
/// let tau = (0.065_f64 / 760.0).sqrt();
/// let omega = 10.0 * std::f64::consts::TAU;
/// let chain = coilsense::transmittance::chain(52, tau, omega);
/// assert!((chain / coilsense::transmittance::continuous(tau, omega) - 1.0).abs() < 1e-4);
/// ```
pub fn chain(masses: usize, transit_time: f64, angular_frequency: f64) -> f64 {
    let count = masses as f64;
    let half = angular_frequency.abs() * transit_time / (2.0 * count);
    if half <= 1.0 {
        return 1.0 / (count * 2.0 * half.asin()).cos();
    }
    let sign = (count * PI).cos().signum();
    sign / (2.0 * count * half.acosh()).cosh()
}
