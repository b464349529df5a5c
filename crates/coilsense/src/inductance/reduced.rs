//! The reduced mutual inductance F(h/r) of two equal rings, without a branch: LLVM makes vector code of a loop over it.
//!
//! Next door: the coefficients (`fits`), the doors with units (`mutual`, `derivatives`), the sum over windings (`pairs`).

use super::fits::{B_LOGARITHM, B_REGULAR, D_LOGARITHM, D_REGULAR, INVERSE_TANGENT};

/// Distances of more radii than this count as this many: M is then below 1e-209 μ₀ r, and no intermediate overflows.
const FAR: f64 = 1e70;

/// a b + c, in one rounding where the processor has an instruction for it.
#[inline(always)]
fn multiply_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// Horner's scheme, lowest degree first in `coefficients`.
#[inline(always)]
fn polynomial<const FUSED: bool, const COUNT: usize>(coefficients: &[f64; COUNT], x: f64) -> f64 {
    let mut sum = coefficients[COUNT - 1];
    for index in (0..COUNT - 1).rev() {
        sum = multiply_add::<FUSED>(sum, x, coefficients[index]);
    }
    sum
}

/// What every quantity of a pair of rings is made of, at q = h/r.
pub(super) struct Pair {
    /// |q|.
    pub(super) ratio: f64,
    /// S/r = √(4 + q²).
    pub(super) s: f64,
    /// 1/w = ½ y², w = 2 + q² + q S/r = ½ (S/r + q)².
    pub(super) inverse_w: f64,
    /// c = 1 − y⁴ = n/w with n = 2 q S/r.
    pub(super) c: f64,
    /// ln c.
    pub(super) logarithm: f64,
}

impl Pair {
    /// One division serves 1/w and the logarithm's argument.
    #[inline(always)]
    pub(super) fn at<const FUSED: bool>(ratio: f64) -> Self {
        let ratio = ratio.abs();
        let ratio = if ratio > FAR { FAR } else { ratio };
        let square = multiply_add::<FUSED>(ratio, ratio, 2.0);
        let s = (square + 2.0).sqrt();
        let w = multiply_add::<FUSED>(ratio, s, square);
        let n = 2.0 * ratio * s;
        // n/w = 2^power near/w with near/w near 1: the difference of the bit patterns is nearly 2^52 times the logarithm to base 2.
        let power = n.to_bits().wrapping_sub(w.to_bits()).wrapping_add(HALF_POWER) & POWERS;
        let near = f64::from_bits(n.to_bits().wrapping_sub(power));
        let (difference, sum) = (near - w, near + w);
        let inverse = 1.0 / (sum * w);
        // 1/w enters squared: the rounding of the shared division is taken back by a step of Newton, which needs one rounding to work.
        let shared = inverse * sum;
        let inverse_w = if FUSED { (-w).mul_add(shared, 1.0).mul_add(shared, shared) } else { 1.0 / w };
        Self { ratio, s, inverse_w, c: n * inverse_w, logarithm: logarithm::<FUSED>(power, difference * (inverse * w)) }
    }

    /// y³ = 2 (S/r + q) / w².
    #[inline(always)]
    pub(super) fn cube(&self) -> f64 {
        2.0 * (self.s + self.ratio) * (self.inverse_w * self.inverse_w)
    }

    /// D = (K − E)/m at complementary parameter c, as P(c) − Q(c) ln c.
    #[inline(always)]
    pub(super) fn d<const FUSED: bool>(&self) -> f64 {
        let regular = polynomial::<FUSED, _>(&D_REGULAR, self.c);
        let factor = polynomial::<FUSED, _>(&D_LOGARITHM, self.c);
        multiply_add::<FUSED>(-factor, self.logarithm, regular)
    }

    /// B = (E − cK)/m at complementary parameter c, as P(c) − c Q(c) ln c.
    #[inline(always)]
    pub(super) fn b<const FUSED: bool>(&self) -> f64 {
        let regular = polynomial::<FUSED, _>(&B_REGULAR, self.c);
        let factor = polynomial::<FUSED, _>(&B_LOGARITHM, self.c);
        multiply_add::<FUSED>(-factor * self.c, self.logarithm, regular)
    }
}

/// F and its first three derivatives by q at |q|; infinite at 0, NaN of NaN.
///
/// With θ = y d/dy and B = (E − cK)/m: θD = 2(B/c − D), θ(B/c) = 2(D − B)/c + 4mB/c², so that all of θF, θ²F, θ³F are sums of
/// positive terms; dy/dq = −y/(S/r) turns them into derivatives by q.
#[inline(always)]
pub(super) fn with_derivatives<const FUSED: bool>(ratio: f64) -> [f64; 4] {
    let pair = Pair::at::<FUSED>(ratio);
    let (cube, d, b) = (pair.cube(), pair.d::<FUSED>(), pair.b::<FUSED>());
    let m = 4.0 * (pair.inverse_w * pair.inverse_w);
    let e = 1.0 / (pair.c * pair.s);
    let per_c = e * pair.s;
    let per_s = e * pair.c;
    let slope = pair.ratio * per_s;
    let first = d + 2.0 * b * per_c;
    let second = d + (4.0 * (b + d) + 8.0 * m * b * per_c) * per_c;
    let third_2 = (24.0 * m + 8.0) * b + 32.0 * m * d + 32.0 * m * (1.0 + m) * b * per_c;
    let third = d + (6.0 * b + 12.0 * d + third_2 * per_c) * per_c;
    let scale = cube * per_s;
    let coincide = pair.ratio < f64::MIN_POSITIVE;
    let or_limit = |value: f64, limit: f64| if coincide { limit } else { value };
    [
        or_limit(cube * d, f64::INFINITY),
        or_limit(-scale * first, f64::NEG_INFINITY),
        or_limit(scale * per_s * (second + slope * first), f64::INFINITY),
        or_limit(
            -scale * per_s * per_s * (third + 3.0 * slope * second + (3.0 * slope * slope - 1.0) * first),
            f64::NEG_INFINITY,
        ),
    ]
}

/// ½ in units of the last bit of a double's exponent.
const HALF_POWER: u64 = 1 << 51;
/// Sign and exponent of a double.
const POWERS: u64 = 0xFFF0_0000_0000_0000;

/// power ln 2 + ln((1 + z)/(1 − z)), the power in the exponent's bits.
#[inline(always)]
fn logarithm<const FUSED: bool>(power: u64, z: f64) -> f64 {
    // A small integer in the low bits of 2^52 is that integer added: a conversion that every instruction set has.
    const TWO_52: f64 = 4_503_599_627_370_496.0;
    const ABOVE_ZERO: u64 = 2048;
    let lifted = (power >> 52).wrapping_add(ABOVE_ZERO) & (2 * ABOVE_ZERO - 1);
    let power = f64::from_bits(lifted | TWO_52.to_bits()) - (TWO_52 + ABOVE_ZERO as f64);
    let square = z * z;
    let series = polynomial::<FUSED, _>(&INVERSE_TANGENT, square);
    let near = multiply_add::<FUSED>(z * square, series, 2.0 * z);
    multiply_add::<FUSED>(power, std::f64::consts::LN_2, near)
}

/// y³ D(c) at q = h/r of either sign: all of the mutual inductance but 2 μ₀ r. Infinite at 0, NaN of NaN.
#[inline(always)]
pub(super) fn mutual<const FUSED: bool>(ratio: f64) -> f64 {
    let pair = Pair::at::<FUSED>(ratio);
    let value = pair.cube() * pair.d::<FUSED>();
    if pair.ratio < f64::MIN_POSITIVE { f64::INFINITY } else { value }
}
