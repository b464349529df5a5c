//! The two kinds of number: what a step needs of either.
//!
//! Next door: everything that is generic over it.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `f32` or `f64`; no other type can be one.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + sealed::Sealed
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// 2⁻⁸.
    const TWO_TO_MINUS_8: Self;
    /// The largest finite number.
    const LARGEST: Self;
    /// 1.5 · 2^n, so large that numbers near it have no digits after the point: a sum with it is rounded
    /// to whole numbers, halves to the even one.
    const ROUNDS: Self;
    /// Up to here a number has a digit after the point, and [`Self::ROUNDS`] rounds it.
    const HALF_WHOLE: Self;
    /// What a last digit is of a number, at most.
    const ROUNDING: f64;
    /// 64 in single precision: after so many steps a mode makes up for what the rounding of its coefficients has added up to. 0 where that
    /// is not needed.
    const STEPS_TO_MEND: u32;

    /// The number nearest to a double one.
    fn nearest(value: f64) -> Self;

    /// What the nearest number leaves of a double one.
    fn leftover(value: f64) -> f64;
}

impl Real for f32 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const TWO_TO_MINUS_8: Self = 0.003_906_25;
    const LARGEST: Self = f32::MAX;
    const ROUNDS: Self = 12_582_912.0;
    const HALF_WHOLE: Self = 4_194_304.0;
    const ROUNDING: f64 = f32::EPSILON as f64;
    const STEPS_TO_MEND: u32 = 64;

    #[inline]
    fn nearest(value: f64) -> Self {
        value as Self
    }

    #[inline]
    fn leftover(value: f64) -> f64 {
        value - f64::from(value as Self)
    }
}

impl Real for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const TWO_TO_MINUS_8: Self = 0.003_906_25;
    const LARGEST: Self = f64::MAX;
    const ROUNDS: Self = 6_755_399_441_055_744.0;
    const HALF_WHOLE: Self = 2_251_799_813_685_248.0;
    const ROUNDING: f64 = f64::EPSILON;
    const STEPS_TO_MEND: u32 = 0;

    #[inline]
    fn nearest(value: f64) -> Self {
        value
    }

    #[inline]
    fn leftover(_: f64) -> f64 {
        0.0
    }
}

mod sealed {
    /// Keeps the number types to those whose rounding has been tested.
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}
