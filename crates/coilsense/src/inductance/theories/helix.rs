//! Neumann's integral of the wire as it is wound: a helix of round wire.
//!
//! Next door: rings instead of a helix (`crate::inductance::MaxwellSum`), a sheet (`nagaoka`).

use std::f64::consts::{PI, TAU};

use super::Coil;
use crate::inductance::MU_0;
use crate::quadrature::panel;

/// How the wire's thickness enters Neumann's integral of its axis. g = ρ e^(−1/4) is a round section's geometric mean distance from itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum HelixSelf {
    /// 1/s becomes 1/√(s² + g²) along the wire; turns lie their centre distance apart, which is the mean of two round sections exactly.
    #[default]
    GeometricMean,
    /// The mutual inductance of the axis and a like helix on the same cylinder, g away across the wire: the program of the measured runs'
    /// authors. It also moves the neighbouring turns nearer, by g one way and the other, which adds to L where they nearly touch.
    ParallelFilament,
}

/// Where the current goes back.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ReturnPath {
    /// Nowhere: the partial inductance of the wire between its ends, which a loop's inductance exceeds or not as its leads lie.
    #[default]
    Open,
    /// Along a straight wire of the same thickness on the coil's axis; the two radial leads are left out.
    StraightOnAxis,
}

/// Inductance of a helix of round wire with uniform current \[H\].
///
/// L = (μ₀/4π) ∮∮ dx·dx'/|x − x'|. A helix looks the same from each of its points, so one integral is left: with S² = r² + (p/2π)²,
/// W = 2πNS, s = Sφ, T = (r² cos φ + (p/2π)²)/S², R² = 4r² sin²(φ/2) + (pφ/2π)²,
///
/// - L = (μ₀/2π) (∫₀^W (W − s)(T/R − 1/s) ds + P(W, g)), P(l, a) = l asinh(l/a) − √(l² + a²) + a ([`HelixSelf::GeometricMean`])
/// - L = (μ₀/4π) ∫₋W^W (W − |s|) T(φ + θ)/√(4r² sin²((φ + θ)/2) + (pφ/2π + y)²) ds, (rθ, y) across the wire, g away
///   ([`HelixSelf::ParallelFilament`])
/// - with [`ReturnPath::StraightOnAxis`], + (μ₀/2π) (P(l, g) − 2 P(l, r))
///
/// - `length`: l \[m\], above zero, from end to end of the wire's axis; N may be fractional: the wire then ends within a turn
///
/// Source:   Neumann's formula, `[Grover1946]` chapter 1; the parallel filament as `[Snow1926]` and the program of `[Vlasblom2015]`.
/// Valid:    direct current, l ≥ 2ρN (turns that do not overlap), ρ far below r: terms of order (ρ/r)² are left out.
/// Accuracy: the integral converges to 1e-14 relative (geometric mean), 3e-13 (parallel filament), against 25 digits.
/// Differs:  the current is uniform over the section; in a bent wire it crowds towards the inside, of order (ρ/r)² too.
///
/// ```
/// use coilsense::inductance::theories::{Coil, HelixSelf, ReturnPath, helix};
/// let coil = Coil::new(41.904, 8.47e-3, 1.41e-3)?;
/// let l = |own| helix(&coil, 0.124, own, ReturnPath::Open);
/// assert!((1.02..1.04).contains(&(l(HelixSelf::ParallelFilament) / l(HelixSelf::GeometricMean))));
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn helix(coil: &Coil, length: f64, own: HelixSelf, back: ReturnPath) -> f64 {
    if !(length > 0.0 && length.is_finite()) {
        return f64::NAN;
    }
    let shape = Shape::new(coil, length);
    let reduced = match own {
        HelixSelf::GeometricMean => shape.bent() + straight(shape.wire(), shape.own),
        HelixSelf::ParallelFilament => shape.beside(),
    };
    let returned = match back {
        ReturnPath::Open => 0.0,
        ReturnPath::StraightOnAxis => straight(length, shape.own) - 2.0 * straight(length, shape.radius),
    };
    MU_0 / TAU * (reduced + returned)
}

/// ½ ∫∫ dx dx'/√((x − x')² + a²) over a straight line of length l: l asinh(l/a) − √(l² + a²) + a.
fn straight(length: f64, apart: f64) -> f64 {
    length * (length / apart).asinh() - length * length / (length.hypot(apart) + apart)
}

/// A helix; lengths in m.
struct Shape {
    windings: f64,
    radius: f64,
    /// g.
    own: f64,
    /// p/2π: along the axis, per radian.
    advance: f64,
    /// S: along the wire, per radian.
    along: f64,
}

impl Shape {
    fn new(coil: &Coil, length: f64) -> Self {
        let advance = length / coil.windings() / TAU;
        let own = coil.wire_radius() * (-0.25_f64).exp();
        let (windings, radius) = (coil.windings(), coil.coil_radius());
        Self { windings, radius, own, advance, along: radius.hypot(advance) }
    }

    /// W.
    fn wire(&self) -> f64 {
        TAU * self.windings * self.along
    }

    /// T/R of two points φ apart, the second one turned by θ and lifted by y.
    fn kernel(&self, angle: f64, turn: f64, lift: f64) -> f64 {
        let (sine, cosine) = (angle + turn).sin_cos();
        // sin²(a/2) = sin² a/(2(1 + cos a)) where that does not cancel.
        let half_square = if cosine > 0.0 { 0.5 * sine * sine / (1.0 + cosine) } else { 0.5 * (1.0 - cosine) };
        let tangents = (self.radius * self.radius * cosine + self.advance * self.advance) / (self.along * self.along);
        tangents / (2.0 * self.radius * half_square.sqrt()).hypot(self.advance * angle + lift)
    }

    /// ∫ (W − s)(T/R − 1/s) ds.
    fn bent(&self) -> f64 {
        self.integral(0.5 * PI, 0.0, |angle| self.kernel(angle, 0.0, 0.0) - 1.0 / (self.along * angle))
    }

    /// Half the integral of the parallel filament.
    fn beside(&self) -> f64 {
        let (turn, lift) = self.offset();
        let both = |angle| self.kernel(angle, turn, lift) + self.kernel(-angle, turn, lift);
        0.5 * self.integral(self.own / self.radius, self.own, both)
    }

    /// θ and y of the filament beside: w across the wire on the unrolled cylinder, so far that the chord is g.
    fn offset(&self) -> (f64, f64) {
        let (sine, cosine) = (self.advance / self.along, self.radius / self.along);
        let mut width = self.own;
        // Each step leaves (g/r)² of the error, times sin² of the pitch angle.
        for _ in 0..30 {
            let half = 0.5 * width * sine / self.radius;
            let chord = if half > 0.0 { half.sin() / half } else { 1.0 };
            width = self.own / (cosine * cosine + (chord * sine).powi(2)).sqrt();
        }
        (-width * sine / self.radius, width * cosine)
    }

    /// ∫ (W − s) f(φ) ds by half turns, each cut in halves towards its near end, where the wire meets itself as near as `first` radians
    /// (along the wire) or j p − `nearer` (j turns on).
    fn integral(&self, first: f64, nearer: f64, function: impl Fn(f64) -> f64) -> f64 {
        let end = TAU * self.windings;
        let weighted = |angle: f64| self.along * self.along * (end - angle) * function(angle);
        let whole = |from: f64, to: f64| if from < end { panel(from, to.min(end), weighted) } else { 0.0 };
        let mut sum = 0.0;
        for turn in 0..=(self.windings + 0.5) as usize {
            let meeting = TAU * turn as f64;
            let apart = if turn == 0 { first } else { (meeting * self.advance - nearer) / self.radius };
            // Turns that overlap would come as near as zero; so the cutting ends.
            let apart = apart.max(1e-9);
            let mut far = PI;
            while far > apart {
                sum += whole(meeting + 0.5 * far, meeting + far);
                if turn > 0 {
                    sum += whole(meeting - far, meeting - 0.5 * far);
                }
                far *= 0.5;
            }
            sum += whole(meeting, meeting + far);
            if turn > 0 {
                sum += whole(meeting - far, meeting);
            }
        }
        sum
    }
}
