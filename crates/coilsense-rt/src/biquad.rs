//! Biquad cascades: Butterworth low-passes, notches and sets of notches n·f1 are all of this form.
//!
//! Next door: where coefficients come from (`coilsense::mitigation`), filters with a ring of past samples (`boxcar`, `comb`, `window`).

use crate::real::Real;

/// One second-order section, its leading denominator coefficient 1.
///
/// H(z) = (b0 + b1 z⁻¹ + b2 z⁻²) / (1 + a1 z⁻¹ + a2 z⁻²)
///
/// Run as a transposed direct form II: y = b0 x + s1; s1' = b1 x − a1 y + s2; s2' = b2 x − a2 y.
///
/// Source:   `[Oppenheim2010]` section 6.3.
/// Valid:    |a2| < 1 and |a1| < 1 + a2, else unstable.
/// Accuracy: response equal to the formula to 1e-12 in `f64`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Biquad<T> {
    /// b0 \[1\].
    pub b0: T,
    /// b1 \[1\].
    pub b1: T,
    /// b2 \[1\].
    pub b2: T,
    /// a1 \[1\].
    pub a1: T,
    /// a2 \[1\].
    pub a2: T,
}

impl<T: Real> Biquad<T> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U) -> Biquad<U> {
        let [b0, b1, b2, a1, a2] = [self.b0, self.b1, self.b2, self.a1, self.a2].map(change);
        Biquad { b0, b1, b2, a1, a2 }
    }

    /// s1, s2 and the output after the input has been `x` for ever; the gain at rest must be finite.
    fn settled(&self, x: T) -> ([T; 2], T) {
        let y = (self.b0 + self.b1 + self.b2) / (T::ONE + self.a1 + self.a2) * x;
        let second = self.b2 * x - self.a2 * y;
        ([self.b1 * x - self.a1 * y + second, second], y)
    }

    #[inline]
    fn step(&self, state: &mut [T; 2], x: T) -> T {
        let [first, second] = *state;
        let y = self.b0 * x + first;
        *state = [self.b1 * x - self.a1 * y + second, self.b2 * x - self.a2 * y];
        y
    }
}

/// `SECTIONS` biquads, one after the other: H(z) is the product of theirs.
///
/// ```
/// use coilsense_rt::{Biquad, Cascade};
/// let half = Biquad { b0: 0.5, b1: 0.0, b2: 0.0, a1: 0.0, a2: 0.0 };
/// let filter = Cascade { sections: [half, half] };
/// let mut state = filter.settled(4.0);
/// assert_eq!(filter.step(&mut state, 4.0), 1.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cascade<T, const SECTIONS: usize> {
    /// In the order in which they are run.
    pub sections: [Biquad<T>; SECTIONS],
}

/// What a [`Cascade`] remembers: s1, s2 of each section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CascadeState<T, const SECTIONS: usize>([[T; 2]; SECTIONS]);

impl<T: Real, const SECTIONS: usize> Cascade<T, SECTIONS> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U + Copy) -> Cascade<U, SECTIONS> {
        Cascade { sections: self.sections.map(|section| section.map(change)) }
    }

    /// The state after the input has been `x` for ever.
    pub fn settled(&self, x: T) -> CascadeState<T, SECTIONS> {
        let mut state = [[T::ZERO; 2]; SECTIONS];
        let mut value = x;
        for (section, memory) in self.sections.iter().zip(&mut state) {
            (*memory, value) = section.settled(value);
        }
        CascadeState(state)
    }

    /// Takes a sample in and gives the filtered one.
    #[inline]
    pub fn step(&self, state: &mut CascadeState<T, SECTIONS>, x: T) -> T {
        let sections = self.sections.iter().zip(&mut state.0);
        sections.fold(x, |value, (section, memory)| section.step(memory, value))
    }
}
