//! Means over a span of time: of one surge period 2τ they null every surge frequency n·f1, in a measured force or in a command.
//!
//! Next door: the same zeros with narrow notches (`comb`), any weights (`window`), single impulses (`shaper`).

use crate::delay::Ring;
use crate::real::Real;

/// The mean over the last `whole + fraction` samples.
///
/// H(z) = (1 + z⁻¹ + … + z^−(n−1) + φ z⁻ⁿ) / (n + φ)
///
/// - `whole`: n \[samples\], from 1 to one less than the ring holds; `fraction`: φ \[samples\], from 0 to 1; `scale`: 1/(n + φ)
///
/// As a command shaper it makes a ramp of every step.
///
/// Source:   definition.
/// Valid:    zeros at multiples of 1/(n + φ) of the sampling rate, for φ ≠ 0 to the error of [`crate::Delay`].
/// Accuracy: response equal to the formula to 1e-12 in `f64`; the running sum begins anew every n samples, so rounding does not pile up.
///
/// ```
/// use coilsense_rt::Boxcar;
/// let mean = Boxcar { whole: 2, fraction: 0.0_f32, scale: 0.5 };
/// let mut state = mean.settled::<4>(0.0);
/// let step = [1.0, 1.0, 1.0].map(|x| mean.step(&mut state, x));
/// assert_eq!(step, [0.5, 1.0, 1.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boxcar<T> {
    /// n \[samples\].
    pub whole: usize,
    /// φ \[samples\].
    pub fraction: T,
    /// 1/(n + φ).
    pub scale: T,
}

/// What a [`Boxcar`] remembers: `N` samples, at least n + 1, and sums of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoxcarState<T, const N: usize> {
    ring: Ring<T, N>,
    sum: T,
    fresh: T,
    age: usize,
}

impl<T: Real> Boxcar<T> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U) -> Boxcar<U> {
        Boxcar { whole: self.whole, fraction: change(self.fraction), scale: change(self.scale) }
    }

    /// The state after the input has been `x` for ever.
    pub fn settled<const N: usize>(&self, x: T) -> BoxcarState<T, N> {
        let mut sum = T::ZERO;
        for _ in 0..self.whole.min(N) {
            sum = sum + x;
        }
        BoxcarState { ring: Ring::filled(x), sum, fresh: T::ZERO, age: 0 }
    }

    /// Takes a sample in and gives the mean.
    #[inline]
    pub fn step<const N: usize>(&self, state: &mut BoxcarState<T, N>, x: T) -> T {
        self.scale * self.weighted_sum(state, x)
    }

    /// The sum over the span, its last sample in part.
    #[inline]
    pub(crate) fn weighted_sum<const N: usize>(&self, state: &mut BoxcarState<T, N>, x: T) -> T {
        state.ring.push(x);
        let leaving = state.ring.back(self.whole);
        state.sum = state.sum + (x - leaving);
        state.fresh = state.fresh + x;
        state.age = state.age.wrapping_add(1);
        if state.age >= self.whole {
            // The last n samples, summed without a subtraction.
            (state.sum, state.fresh, state.age) = (state.fresh, T::ZERO, 0);
        }
        state.sum + self.fraction * leaving
    }
}

impl<T: Real, const N: usize> BoxcarState<T, N> {
    /// The sample taken in so many steps before the last.
    #[inline]
    pub(crate) fn back(&self, ago: usize) -> T {
        self.ring.back(ago)
    }
}

/// Two means, one after the other: zeros of order two, or zeros on either side of where they are wanted.
///
/// H(z) is the product of theirs.
///
/// ```
/// use coilsense_rt::{Boxcar, DoubleBoxcar};
/// let mean = Boxcar { whole: 2, fraction: 0.0_f32, scale: 0.5 };
/// let shaper = DoubleBoxcar { first: mean, second: mean };
/// let mut state = shaper.settled::<4>(0.0);
/// let step = [1.0, 1.0, 1.0].map(|x| shaper.step(&mut state, x));
/// assert_eq!(step, [0.25, 0.75, 1.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleBoxcar<T> {
    /// Run first.
    pub first: Boxcar<T>,
    /// Run on what the first gives.
    pub second: Boxcar<T>,
}

/// What a [`DoubleBoxcar`] remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleBoxcarState<T, const N: usize>([BoxcarState<T, N>; 2]);

impl<T: Real> DoubleBoxcar<T> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U + Copy) -> DoubleBoxcar<U> {
        DoubleBoxcar { first: self.first.map(change), second: self.second.map(change) }
    }

    /// The state after the input has been `x` for ever.
    pub fn settled<const N: usize>(&self, x: T) -> DoubleBoxcarState<T, N> {
        DoubleBoxcarState([self.first.settled(x), self.second.settled(x)])
    }

    /// Takes a sample in and gives the mean of means.
    #[inline]
    pub fn step<const N: usize>(&self, state: &mut DoubleBoxcarState<T, N>, x: T) -> T {
        let [first, second] = &mut state.0;
        let mean = self.first.step(first, x);
        self.second.step(second, mean)
    }
}
