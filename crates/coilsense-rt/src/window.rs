//! A finite window: the weighted sum of the last samples.
//!
//! Next door: equal weights at the price of two additions (`boxcar`).

use crate::delay::Ring;
use crate::real::Real;

/// y = Σ_i h_i x(t − i T), `N` products a step.
///
/// - `taps`: h_i \[1\], newest sample first
///
/// Source:   definition.
/// Valid:    always; it cannot be unstable.
/// Accuracy: response equal to the formula to 1e-12 in `f64`.
///
/// ```
/// use coilsense_rt::Window;
/// let window = Window { taps: [0.75_f32, 0.25] };
/// let mut state = window.settled(0.0);
/// assert_eq!([1.0, 1.0].map(|x| window.step(&mut state, x)), [0.75, 1.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window<T, const N: usize> {
    /// h_i, newest sample first.
    pub taps: [T; N],
}

impl<T: Real, const N: usize> Window<T, N> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U) -> Window<U, N> {
        Window { taps: self.taps.map(change) }
    }

    /// The state after the input has been `x` for ever.
    pub fn settled(&self, x: T) -> Ring<T, N> {
        Ring::filled(x)
    }

    /// Takes a sample in and gives the weighted sum.
    #[inline]
    pub fn step(&self, state: &mut Ring<T, N>, x: T) -> T {
        state.push(x);
        let (recent, older) = state.halves();
        let (of_recent, of_older) = self.taps.split_at_checked(recent.len()).unwrap_or((&[], &[]));
        weighted(weighted(T::ZERO, of_recent, recent), of_older, older)
    }
}

/// `sum` and every sample, the last first, times its tap.
#[inline]
fn weighted<T: Real>(sum: T, taps: &[T], samples: &[T]) -> T {
    taps.iter().zip(samples.iter().rev()).fold(sum, |sum, (tap, sample)| sum + *tap * *sample)
}
