//! Inductance fusion: F_L is slow and without bias, F_i is fast and off by an offset or a gain; together they are neither.
//!
//! Next door: how F_L is made of an inductance (`coilsense::sensors`).

use crate::delay::{Delay, Ring};
use crate::real::Real;

/// A complementary filter: y = F_i + b, b' = b + g (F_L − F_i(t − d) − b) wherever there is a new F_L.
///
/// Y = F_i (1 − B D) + F_L B, B(z) = g / (1 − (1 − g) z⁻¹), D the delay by d, with an F_L at every step
///
/// - `gain`: g \[1\], above 0 and at most 1: the share of what F_L says against F_i that is taken over at each F_L
/// - `lateness`: d \[samples\], how late F_L is, at most two less than the ring holds
///
/// Source:   `[Higgins1975]`, a complementary filter of order one.
/// Valid:    F_L and F_i of one force: while the spring rings both ends differ, and b follows the mean of the difference.
/// Accuracy: response equal to the formula to 1e-12 in `f64`.
///
/// ```
/// use coilsense_rt::{Delay, Fusion};
/// let fusion = Fusion { gain: 0.5_f32, lateness: Delay { whole: 0, fraction: 0.0 } };
/// let mut state = fusion.settled::<2>(10.0, 8.0);
/// assert_eq!(fusion.step(&mut state, 10.0, Some(8.0)), 8.0);
/// assert_eq!(fusion.step(&mut state, 12.0, None), 10.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fusion<T> {
    /// g \[1\].
    pub gain: T,
    /// d \[samples\].
    pub lateness: Delay<T>,
}

/// What a [`Fusion`] remembers: b \[N\] and `N` samples of F_i.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FusionState<T, const N: usize> {
    bias: T,
    fast: Ring<T, N>,
}

impl<T: Real> Fusion<T> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U + Copy) -> Fusion<U> {
        Fusion { gain: change(self.gain), lateness: self.lateness.map(change) }
    }

    /// The state after both forces have been so for ever.
    pub fn settled<const N: usize>(&self, fast: T, slow: T) -> FusionState<T, N> {
        FusionState { bias: slow - fast, fast: Ring::filled(fast) }
    }

    /// Takes F_i \[N\] in, and F_L \[N\] where there is a new one; gives the fused force \[N\].
    #[inline]
    pub fn step<const N: usize>(&self, state: &mut FusionState<T, N>, fast: T, slow: Option<T>) -> T {
        state.fast.push(fast);
        if let Some(slow) = slow {
            let then = state.fast.delayed(&self.lateness);
            state.bias = state.bias + self.gain * (slow - then - state.bias);
        }
        fast + state.bias
    }
}
