//! A comb: one notch at every surge frequency n·f1 for the price of one ring, and less late than a mean over a surge period.
//!
//! Next door: the mean (`boxcar`), single notches (`biquad`).

use crate::boxcar::{Boxcar, BoxcarState};
use crate::delay::{Delay, Ring};
use crate::real::Real;

/// Notches at all multiples of one frequency but zero, where it lets everything through.
///
/// H(z) = K (1 − D)/(1 − z⁻¹) · (1 − ρ z⁻¹)/(1 − ρᴸ D), D = (1 − φ) z⁻ⁿ + φ z⁻ⁿ⁻¹, L = n + φ, K = (1 − ρᴸ)/(L (1 − ρ))
///
/// - `period`: n \[samples\], from 1 to two less than the rings hold, and φ, from 0 to 1; its `scale` is K here
/// - `radius`: ρ \[1\], from 0 (the mean over L samples) to below 1 (narrow notches)
/// - `feedback`: ρᴸ \[1\]
///
/// Source:   the zeros of `[Oppenheim2010]` section 6.5's comb, each with a pole of radius ρ inside it, that at zero frequency left out.
/// Valid:    0 ≤ ρ < 1: always stable, since |D| ≤ 1 on and outside of the unit circle.
/// Accuracy: response equal to the formula to 1e-12 in `f64`.
///
/// ```
/// use coilsense_rt::{Boxcar, Comb};
/// // Two samples a period, ρ = 1/2: K = (1 − ¼)/(2 · ½).
/// let comb = Comb { period: Boxcar { whole: 2, fraction: 0.0_f32, scale: 0.75 }, radius: 0.5, feedback: 0.25 };
/// let mut state = comb.settled::<4>(8.0);
/// assert_eq!(comb.step(&mut state, 8.0), 8.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comb<T> {
    /// L, and K as its scale.
    pub period: Boxcar<T>,
    /// ρ \[1\].
    pub radius: T,
    /// ρᴸ \[1\].
    pub feedback: T,
}

/// What a [`Comb`] remembers: rings of `N` samples, at least n + 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CombState<T, const N: usize> {
    inputs: BoxcarState<T, N>,
    last_sum: T,
    outputs: Ring<T, N>,
}

impl<T: Real> Comb<T> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U + Copy) -> Comb<U> {
        Comb { period: self.period.map(change), radius: change(self.radius), feedback: change(self.feedback) }
    }

    /// The state after the input has been `x` for ever; a comb's gain there is 1.
    pub fn settled<const N: usize>(&self, x: T) -> CombState<T, N> {
        let mut inputs = self.period.settled(x);
        let last_sum = self.period.weighted_sum(&mut inputs, x);
        CombState { inputs, last_sum, outputs: Ring::filled(x) }
    }

    /// Takes a sample in and gives the filtered one.
    #[inline]
    pub fn step<const N: usize>(&self, state: &mut CombState<T, N>, x: T) -> T {
        let sum = self.period.weighted_sum(&mut state.inputs, x);
        // The ring's last push was one step ago.
        let back = Delay { whole: self.period.whole.saturating_sub(1), fraction: self.period.fraction };
        let y = self.period.scale * (sum - self.radius * state.last_sum) + self.feedback * state.outputs.delayed(&back);
        state.last_sum = sum;
        state.outputs.push(y);
        y
    }
}
