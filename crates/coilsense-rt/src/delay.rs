//! Past samples: a ring of them, and delays of a fractional number of samples.
//!
//! Next door: what is made of it (`boxcar`, `comb`, `window`, `shaper`, `delay_line`, `fusion`).

use crate::real::Real;

/// A delay of `whole + fraction` samples, straight between samples.
///
/// D(z) = (1 − φ) z⁻ⁿ + φ z⁻ⁿ⁻¹
///
/// - `whole`: n \[samples\]; `fraction`: φ \[samples\], from 0 to 1
///
/// Source:   linear interpolation.
/// Valid:    n + 1 at most what the ring holds less one; longer delays are cut to that.
/// Accuracy: off by at most φ(1 − φ)(ω T)²/2 of a sine's amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Delay<T> {
    /// n \[samples\].
    pub whole: usize,
    /// φ \[samples\].
    pub fraction: T,
}

impl<T: Copy> Delay<T> {
    /// The same with its number changed, into another precision.
    pub fn map<U>(&self, change: impl FnOnce(T) -> U) -> Delay<U> {
        Delay { whole: self.whole, fraction: change(self.fraction) }
    }
}

/// The last `N` samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring<T, const N: usize> {
    samples: [T; N],
    newest: usize,
}

impl<T: Real, const N: usize> Ring<T, N> {
    /// The ring after the signal has been `x` for ever.
    pub fn filled(x: T) -> Self {
        Self { samples: [x; N], newest: 0 }
    }

    /// Puts a sample in; the oldest goes.
    #[inline]
    pub fn push(&mut self, x: T) {
        let next = self.newest.wrapping_add(1);
        self.newest = if next < N { next } else { 0 };
        if let Some(place) = self.samples.get_mut(self.newest) {
            *place = x;
        }
    }

    /// The sample put in `ago` pushes before the last; the oldest where the ring does not reach so far.
    #[inline]
    pub fn back(&self, ago: usize) -> T {
        let ago = ago.min(N.saturating_sub(1));
        let place = if ago <= self.newest {
            self.newest.wrapping_sub(ago)
        } else {
            self.newest.wrapping_add(N).wrapping_sub(ago)
        };
        self.samples.get(place).copied().unwrap_or(T::ZERO)
    }

    /// The signal as it was `delay` before the last push.
    #[inline]
    pub fn delayed(&self, delay: &Delay<T>) -> T {
        let near = self.back(delay.whole);
        near + delay.fraction * (self.back(delay.whole.saturating_add(1)) - near)
    }

    /// What was pushed since the ring last began anew, and what is left from before; in either the newest last.
    #[inline]
    pub(crate) fn halves(&self) -> (&[T], &[T]) {
        self.samples.split_at_checked(self.newest.saturating_add(1)).unwrap_or((&[], &[]))
    }
}
