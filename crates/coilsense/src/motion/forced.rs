//! One undamped oscillator under a sine, from rest.
//!
//! Next door: all modes together (`modal`).

/// Response from rest of `q̈ + ω_n² q = sin(ωt + φ)`, without a special case at resonance.
///
/// q(t)  = 1/(2ω_n) [C − D], q̇(t) = ½ [A − B] with
/// C = t sinc(σt/2) cos(Δt/2 − φ), D = t sinc(Δt/2) cos(σt/2 + φ),
/// A = t sinc(Δt/2) sin(σt/2 + φ), B = t sinc(σt/2) sin(Δt/2 − φ), Δ = ω_n − ω, σ = ω_n + ω.
///
/// At Δ = 0 this is the secular solution, whose amplitude grows as t / 2ω.
///
/// Source:   Duhamel's integral of the sine, product of sines turned into sums.
/// Valid:    ω_n, ω above zero.
/// Accuracy: rounding of the phases, about 1e-16 · ω_n t; no cancellation near resonance.
pub(crate) struct ForcedOscillator {
    /// ω_n \[rad/s\].
    pub natural: f64,
    /// ω \[rad/s\].
    pub drive: f64,
    /// φ \[rad\].
    pub phase: f64,
}

impl ForcedOscillator {
    /// q(t) \[s²\] for a unit acceleration.
    pub(crate) fn displacement(&self, time: f64) -> f64 {
        let (difference, sum) = self.half_angles(time);
        let slow = half_sine(difference, time) * (sum + self.phase).cos();
        let fast = half_sine(sum, time) * (difference - self.phase).cos();
        (fast - slow) / (2.0 * self.natural)
    }

    /// q̇(t) \[s\] for a unit acceleration.
    pub(crate) fn velocity(&self, time: f64) -> f64 {
        let (difference, sum) = self.half_angles(time);
        let slow = half_sine(difference, time) * (sum + self.phase).sin();
        let fast = half_sine(sum, time) * (difference - self.phase).sin();
        0.5 * (slow - fast)
    }

    /// Δt/2 and σt/2.
    fn half_angles(&self, time: f64) -> (f64, f64) {
        (
            0.5 * (self.natural - self.drive) * time,
            0.5 * (self.natural + self.drive) * time,
        )
    }
}

/// t sin(x)/x, by its series where x is small.
fn half_sine(angle: f64, time: f64) -> f64 {
    if angle.abs() < 1e-4 {
        time * (1.0 - angle * angle / 6.0) // next term 1e-18
    } else {
        time * angle.sin() / angle
    }
}
