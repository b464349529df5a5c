//! e^z of many z at once, in the processor's vector instructions.
//!
//! Next door: what needs them (`phasors`, `stretch`), one at a time (`oscillator`).

use num_complex::Complex64;

use super::oscillator::exponential;

/// Angles beyond this many radians are left to the standard library: reduced as here they would lose digits.
const LARGEST_ANGLE: f64 = 1e6;

/// Added and taken away again, this rounds to a whole number, which then stands in the low bits.
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Numbers z, then e^z, real and imaginary parts apart.
#[derive(Default)]
pub(super) struct Exponentials {
    re: Vec<f64>,
    im: Vec<f64>,
}

impl Exponentials {
    /// Appends a z.
    #[inline(always)]
    pub(super) fn push(&mut self, z: Complex64) {
        self.re.push(z.re);
        self.im.push(z.im);
    }

    pub(super) fn get(&self, index: usize) -> Complex64 {
        Complex64::new(self.re[index], self.im[index])
    }

    /// Turns every z into e^z; Re z must not be above zero.
    ///
    /// Source:   reduction by π/2 in two parts, polynomials of fdlibm for sine and cosine; by ln 2 and Taylor's series for e^x.
    /// Valid:    any angle; those above 1e6 rad, and processors without fused multiply-add, take the standard library.
    /// Accuracy: 3e-16 of |e^z| (test), but for what the last digit of an angle means.
    #[inline(always)]
    pub(super) fn evaluate<const FUSED: bool>(&mut self) {
        let largest =
            self.im.iter().fold(0.0, |largest: f64, angle| if angle.abs() > largest { angle.abs() } else { largest });
        if !FUSED || largest >= LARGEST_ANGLE {
            for (re, im) in self.re.iter_mut().zip(&mut self.im) {
                let value = exponential(Complex64::new(*re, *im));
                (*re, *im) = (value.re, value.im);
            }
            return;
        }
        if self.re.iter().all(|re| *re == 0.0) {
            for (re, im) in self.re.iter_mut().zip(&mut self.im) {
                (*im, *re) = sine_and_cosine(*im);
            }
            return;
        }
        for (re, im) in self.re.iter_mut().zip(&mut self.im) {
            let (size, (sine, cosine)) = (decay(*re), sine_and_cosine(*im));
            (*re, *im) = (size * cosine, size * sine);
        }
    }
}

/// Horner's scheme, highest degree first, in fused steps.
#[inline(always)]
fn polynomial<const COUNT: usize>(coefficients: [f64; COUNT], x: f64) -> f64 {
    let mut sum = coefficients[0];
    for coefficient in &coefficients[1..] {
        sum = sum.mul_add(x, *coefficient);
    }
    sum
}

/// sin x and cos x without a branch.
#[inline(always)]
fn sine_and_cosine(x: f64) -> (f64, f64) {
    // π/2 and what its double lacks.
    const QUARTER: f64 = std::f64::consts::FRAC_PI_2;
    const QUARTER_REST: f64 = 6.123_233_995_736_766e-17;
    const SINE: [f64; 6] = [
        1.589_690_995_211_55e-10,
        -2.505_076_025_340_686_3e-8,
        2.755_731_370_707_006_8e-6,
        -1.984_126_982_985_795e-4,
        8.333_333_333_322_49e-3,
        -1.666_666_666_666_663_2e-1,
    ];
    const COSINE: [f64; 6] = [
        -1.135_964_755_778_819_5e-11,
        2.087_572_321_298_175e-9,
        -2.755_731_435_139_066_3e-7,
        2.480_158_728_947_673e-5,
        -1.388_888_888_887_411e-3,
        4.166_666_666_666_66e-2,
    ];
    let lifted = x.mul_add(std::f64::consts::FRAC_2_PI, ROUNDING);
    let (quadrant, turns) = (lifted.to_bits(), lifted - ROUNDING);
    // The first difference is exact: both sides are whole multiples of 2^-52, or smaller than π/4 already.
    let rest = (-turns).mul_add(QUARTER_REST, (-turns).mul_add(QUARTER, x));
    let square = rest * rest;
    let sine = (rest * square).mul_add(polynomial(SINE, square), rest);
    let cosine = (square * square).mul_add(polynomial(COSINE, square), (-0.5_f64).mul_add(square, 1.0));
    let exchanged = quadrant & 1 == 1;
    let (first, second) = if exchanged { (cosine, sine) } else { (sine, cosine) };
    let sign = |value: f64, quadrant: u64| f64::from_bits(value.to_bits() ^ ((quadrant & 2) << 62));
    (sign(first, quadrant), sign(second, quadrant.wrapping_add(1)))
}

/// e^x for x not above zero; nothing below e^−700.
#[inline(always)]
fn decay(x: f64) -> f64 {
    const LN_2: f64 = 6.931_471_803_691_238e-1;
    const LN_2_REST: f64 = 1.908_214_929_270_587_7e-10;
    /// 1/n! from n = 13 down to 0.
    const FACTORIALS: [f64; 14] = [
        1.605_904_383_682_161_5e-10,
        2.087_675_698_786_81e-9,
        2.505_210_838_544_172e-8,
        2.755_731_922_398_589e-7,
        2.755_731_922_398_589_3e-6,
        2.480_158_730_158_73e-5,
        1.984_126_984_126_984e-4,
        1.388_888_888_888_889e-3,
        8.333_333_333_333_333e-3,
        4.166_666_666_666_666_4e-2,
        1.666_666_666_666_666_6e-1,
        0.5,
        1.0,
        1.0,
    ];
    let bounded = if x < -700.0 { -700.0 } else { x };
    let lifted = bounded.mul_add(std::f64::consts::LOG2_E, ROUNDING);
    let power = lifted - ROUNDING;
    let rest = (-power).mul_add(LN_2_REST, (-power).mul_add(LN_2, bounded));
    let scale = f64::from_bits(lifted.to_bits().wrapping_add(1023) << 52);
    let value = polynomial(FACTORIALS, rest) * scale;
    if x < -700.0 { 0.0 } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd;

    struct Evaluate<'a>(&'a mut Exponentials);

    impl pulp::WithSimd for Evaluate<'_> {
        type Output = ();

        #[inline(always)]
        fn with_simd<S: pulp::Simd>(self, _: S) {
            if S::IS_SCALAR { self.0.evaluate::<false>() } else { self.0.evaluate::<true>() }
        }
    }

    #[test]
    fn many_at_once_are_what_each_is_alone() {
        for decays in [0.0, 1.0] {
            for scale in [1e-9, 0.1, 1.0, 77.0, 1e4, 9e5, 1e8] {
                let z =
                    |k: u32| Complex64::new(-decays * f64::from(k % 57) * 0.31, scale * (f64::from(k) * 0.618).sin());
                let mut ours = Exponentials::default();
                (0..3000).for_each(|k| ours.push(z(k)));
                simd::dispatch(Evaluate(&mut ours));
                for k in 0..3000 {
                    let (off, size) = ((ours.get(k as usize) - exponential(z(k))).norm(), z(k).re.exp());
                    // One rounding of either part, and of the product with e^x, on both sides.
                    assert!(off < 6e-16 * size, "{k} {scale} {decays}: {off:e} of {size}");
                }
            }
        }
        let mut deep = Exponentials::default();
        [-699.0, -701.0, -1e6].into_iter().for_each(|re| deep.push(Complex64::new(re, 0.0)));
        simd::dispatch(Evaluate(&mut deep));
        // What is that small is nothing beside any other term.
        assert!((0..3).all(|k| deep.get(k).norm() <= 1.01 * (-699.0_f64).exp()));
    }
}
