//! The modes of the chain with a mass at end 2: the roots of their characteristic equation.
//!
//! Next door: shapes, norms and participations of all mounts (the parent).

use std::f64::consts::{FRAC_PI_2, PI};

/// What characterises a mode: `φ(i) = sin(θ(i−½))`, or above cut-off `φ(i) = (−1)^(i−1) cosh(φ(i−½)) / cosh(φN)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Angle {
    /// θ in (0, π), with sin(Nθ) and cos(Nθ): from θ alone they would lose their digits where end 2 nearly stands still.
    Wave { theta: f64, sine: f64, cosine: f64 },
    /// φ above 0: neighbours swing against each other, most at end 2.
    AboveCutOff(f64),
}

/// The N + 1 angles of a chain of N masses between a prescribed position and a mass M.
///
/// N sin θ tan(Nθ) = m/M with one root in each ((j−1)π/N, (j−½)π/N), and N sinh φ tanh(Nφ) = m/M above cut-off
///
/// From the last equations of the chain, `u2 = (φ_N + φ_{N+1})/2 = sin(Nθ) cos(θ/2)` (the mass sits half a segment beyond mass N, so the
/// chain continues to a fictitious mass N + 1) and `M ω² u2 = 2Nk (u2 − φ_N) = 2Nk cos(Nθ) sin(θ/2)` with `ω = (2N/τ) sin(θ/2)`; dividing
/// gives the first. θ = π + iφ gives the second, with `ω = (2N/τ) cosh(φ/2)`.
///
/// - `masses`: N, at least 1; `mass_ratio`: m/M, above zero
///
/// Source:   derived here from `[Weijde2017]` eqs. 4–7 with `M ü2 = −F_o`.
/// Valid:    no damping; β tan β = m/M as N → ∞ with β = Nθ.
/// Accuracy: 1e-15 relative in θ (Newton's method inside a bracket until it stands still).
pub(super) fn angles(masses: usize, mass_ratio: f64) -> Vec<Angle> {
    let count = masses as f64;
    let wave = (0..masses).map(|index| {
        let base = PI * index as f64 / count;
        let x = bracketed_newton(0.0, FRAC_PI_2, |x| {
            let (sin, cos) = (base + x / count).sin_cos();
            let (sin_x, cos_x) = x.sin_cos();
            let value = count * sin * sin_x - mass_ratio * cos_x;
            let slope = cos * sin_x + count * sin * cos_x + mass_ratio * sin_x;
            (value, slope)
        });
        let sign = if index % 2 == 0 { 1.0 } else { -1.0 };
        Angle::Wave { theta: base + x / count, sine: sign * x.sin(), cosine: sign * x.cos() }
    });
    // N sinh φ tanh(Nφ) is below N sinh φ and, from where tanh is above ½ on, above half of it: the root lies below this.
    let upper = (2.0 * mass_ratio / count).asinh() + 1.0 / count;
    let above = bracketed_newton(0.0, upper, |x| {
        let (sinh, tanh) = (x.sinh(), (count * x).tanh());
        let value = count * sinh * tanh - mass_ratio;
        let slope = count * (x.cosh() * tanh + count * sinh * (1.0 - tanh * tanh));
        (value, slope)
    });
    wave.chain([Angle::AboveCutOff(above)]).collect()
}

/// Root of a function that is below zero at `low` and above zero at `high`; `function` gives value and slope.
pub(super) fn bracketed_newton(low: f64, high: f64, function: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (mut low, mut high) = (low, high);
    let mut x = 0.5 * (low + high);
    // Newton doubles the digits at each step; bisection alone would end within 60.
    for _ in 0..100 {
        let (value, slope) = function(x);
        if value < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if next == x || high - low <= f64::EPSILON * high {
            return next;
        }
        x = next;
    }
    x
}
