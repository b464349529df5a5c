//! Command shaping by impulses: ZV, ZVD and any like them. A command shaped so leaves the mode at rest for which it was made.
//!
//! Next door: shaping by means (`boxcar`): a ramp over 2τ leaves *all* modes at rest.

use crate::delay::{Delay, Ring};
use crate::real::Real;

/// One impulse of a shaper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impulse<T> {
    /// A_i \[1\]; those of a shaper add up to 1.
    pub amplitude: T,
    /// t_i \[samples\].
    pub delay: Delay<T>,
}

/// y(t) = Σ_i A_i x(t − t_i)
///
/// - `impulses`: A_i and t_i, at most two less than the ring holds
///
/// Source:   `[Singer1990]`.
/// Valid:    linear vibration.
/// Accuracy: response equal to the formula to 1e-12 in `f64`; a fractional delay as [`Delay`].
///
/// ```
/// use coilsense_rt::{Delay, Impulse, Shaper};
/// let half = |whole| Impulse { amplitude: 0.5_f32, delay: Delay { whole, fraction: 0.0 } };
/// let zero_vibration = Shaper { impulses: [half(0), half(2)] };
/// let mut state = zero_vibration.settled::<4>(0.0);
/// let step = [1.0, 1.0, 1.0].map(|x| zero_vibration.step(&mut state, x));
/// assert_eq!(step, [0.5, 0.5, 1.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaper<T, const IMPULSES: usize> {
    /// A_i, t_i.
    pub impulses: [Impulse<T>; IMPULSES],
}

impl<T: Real, const IMPULSES: usize> Shaper<T, IMPULSES> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U + Copy) -> Shaper<U, IMPULSES> {
        let each =
            |impulse: Impulse<T>| Impulse { amplitude: change(impulse.amplitude), delay: impulse.delay.map(change) };
        Shaper { impulses: self.impulses.map(each) }
    }

    /// The state after the command has been `x` for ever.
    pub fn settled<const N: usize>(&self, x: T) -> Ring<T, N> {
        Ring::filled(x)
    }

    /// Takes a command in and gives the shaped one.
    #[inline]
    pub fn step<const N: usize>(&self, state: &mut Ring<T, N>, x: T) -> T {
        state.push(x);
        let each = self.impulses.iter();
        each.fold(T::ZERO, |sum, impulse| sum + impulse.amplitude * state.delayed(&impulse.delay))
    }
}
