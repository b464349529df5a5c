//! Square roots, exponentials, logarithms and sines, of sums and products only: the same bits wherever numbers are rounded as IEEE 754 has it, with no
//! library beneath.
//!
//! Next door: what a mode does in a step, which needs them (`oscillator`). C has them line by line (`coilsense-lab`, `plant/export/plant.h`).

/// 1/k! for k = 1…14.
const EXPONENTIAL: [f64; 14] = [
    1.0,
    1.0 / 2.0,
    1.0 / 6.0,
    1.0 / 24.0,
    1.0 / 120.0,
    1.0 / 720.0,
    1.0 / 5_040.0,
    1.0 / 40_320.0,
    1.0 / 362_880.0,
    1.0 / 3_628_800.0,
    1.0 / 39_916_800.0,
    1.0 / 479_001_600.0,
    1.0 / 6_227_020_800.0,
    1.0 / 87_178_291_200.0,
];
/// ±1/k! for k = 3, 5 … 17.
const SINE: [f64; 8] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5_040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
];
/// ±1/k! for k = 2, 4 … 18.
const COSINE: [f64; 9] = [
    -1.0 / 2.0,
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
    -1.0 / 6_402_373_705_728_000.0,
];
/// 1/k for k = 3, 5 … 23.
const ARTANH: [f64; 11] = [
    1.0 / 3.0,
    1.0 / 5.0,
    1.0 / 7.0,
    1.0 / 9.0,
    1.0 / 11.0,
    1.0 / 13.0,
    1.0 / 15.0,
    1.0 / 17.0,
    1.0 / 19.0,
    1.0 / 21.0,
    1.0 / 23.0,
];
/// ln 2 in two parts, and π/2 in three; all but the last have so few digits that a count times them is exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21];
const PER_LN_2: f64 = core::f64::consts::LOG2_E;
const PER_HALF_PI: f64 = core::f64::consts::FRAC_2_PI;
/// Below this e^x is less than half of the last digit of 1.
const NOTHING_LEFT: f64 = -40.0;

/// Σ c_k x^k, k from 0.
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// √x for x above zero and finite.
///
/// Source:   Newton's (Heron's) method from a chord, after taking out powers of 4.
/// Accuracy: 2.3e-16 relative (test).
pub fn square_root(x: f64) -> f64 {
    let (mut rest, mut scale) = (x, 1.0);
    while rest >= 4.0 {
        rest *= 0.25;
        scale *= 2.0;
    }
    while rest < 1.0 {
        rest *= 4.0;
        scale *= 0.5;
    }
    // Off by 5 % at most; each step squares that.
    let mut root = 0.72 + 0.33 * rest;
    for _ in 0..4 {
        root = 0.5 * (root + rest / root);
    }
    scale * root
}

/// e^x − 1 for x not above zero.
///
/// Source:   Taylor's series about the nearest multiple of ln 2.
/// Accuracy: 4e-16 relative (test).
pub fn exponential_less_one(x: f64) -> f64 {
    if x < NOTHING_LEFT {
        return -1.0;
    }
    let halvings = (0.5 - x * PER_LN_2) as u32;
    let count = f64::from(halvings);
    let rest = (x + count * LN_2[0]) + count * LN_2[1];
    let mut scale = 1.0;
    for _ in 0..halvings {
        scale *= 0.5;
    }
    scale * (rest * polynomial(&EXPONENTIAL, rest)) + (scale - 1.0)
}

/// How many quarter turns are nearest to x, for x from 0 to 6e9, and what is left of it, within π/4.
///
/// Source:   π/2 is taken off in three parts (Cody and Waite).
/// Accuracy: 2e-16 of the rest up to 1e6; from there on the last digit of x (test, through the sine).
pub fn quarter_turns(x: f64) -> (u32, f64) {
    let quarters = (x * PER_HALF_PI + 0.5) as u32;
    let count = f64::from(quarters);
    (quarters % 4, ((x - count * HALF_PI[0]) - count * HALF_PI[1]) - count * HALF_PI[2])
}

/// sin x and cos x − 1 for x within π/4.
///
/// Source:   Taylor's series.
/// Accuracy: 3e-16 relative, 5e-16 of the cosine (test).
pub fn sine_and_cosine_less_one(x: f64) -> [f64; 2] {
    let square = x * x;
    [x + x * (square * polynomial(&SINE, square)), square * polynomial(&COSINE, square)]
}

/// ln x for x above zero and finite.
///
/// Source:   2 artanh((m − 1)/(m + 1)) for m within √½ and √2, after taking out powers of 2.
/// Accuracy: 4e-16 relative, and 2e-16 where it is near zero (test).
pub fn natural_logarithm(x: f64) -> f64 {
    let (mut rest, mut count) = (x, 0.0);
    while rest >= core::f64::consts::SQRT_2 {
        rest *= 0.5;
        count += 1.0;
    }
    while rest < core::f64::consts::FRAC_1_SQRT_2 {
        rest *= 2.0;
        count -= 1.0;
    }
    let z = (rest - 1.0) / (rest + 1.0);
    let square = z * z;
    let of_rest = 2.0 * (z + z * (square * polynomial(&ARTANH, square)));
    count * LN_2[0] + (count * LN_2[1] + of_rest)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;

    /// 10^k in steps of a seventh of a decade.
    fn sizes(from: i32, to: i32) -> impl Iterator<Item = f64> {
        (7 * from..7 * to).map(|k| 10.0_f64.powf(f64::from(k) / 7.0))
    }

    #[test]
    fn roots_are_those_of_the_processor_but_for_the_last_digit() {
        for x in sizes(-30, 30) {
            assert!((square_root(x) / x.sqrt() - 1.0).abs() <= 2.3e-16, "{x}");
        }
        assert_eq!([1.0, 4.0, 0.25].map(square_root), [1.0, 2.0, 0.5]);
    }

    #[test]
    fn exponentials_are_those_of_the_library_but_for_the_last_digits() {
        for x in sizes(-18, 3).map(|x| -x) {
            assert!((exponential_less_one(x) / x.exp_m1() - 1.0).abs() < 4e-16, "{x}");
        }
        assert_eq!(exponential_less_one(0.0), 0.0);
    }

    #[test]
    fn logarithms_are_those_of_the_library_but_for_the_last_digits() {
        for x in sizes(-30, 30).chain((0..2000).map(|k| 1.0 + 1e-3 * (f64::from(k) - 900.0))) {
            let (ours, theirs) = (natural_logarithm(x), x.ln());
            assert!((ours - theirs).abs() <= 4e-16 * theirs.abs().max(0.5), "{x}: {ours} {theirs}");
        }
        assert_eq!(natural_logarithm(1.0), 0.0);
    }

    #[test]
    fn sines_are_those_of_the_library_to_the_last_digit_of_the_angle() {
        for x in sizes(-18, 9) {
            let (quarters, rest) = quarter_turns(x);
            let [s, less] = sine_and_cosine_less_one(rest);
            let [s, c] = [[s, 1.0 + less], [1.0 + less, -s], [-s, -1.0 - less], [-1.0 - less, s]][quarters as usize];
            let (sine, cosine) = x.sin_cos();
            let allowed = if x < 1e6 { 3e-16 } else { f64::EPSILON * x };
            assert!((s - sine).abs() < allowed && (c - cosine).abs() < allowed, "{x}: {s} {sine}, {c} {cosine}");
            if x < 0.7 {
                let half = (0.5 * x).sin();
                assert!((s / sine - 1.0).abs() < 3e-16 && (less / (-2.0 * half * half) - 1.0).abs() < 5e-16, "{x}");
            }
        }
    }
}
