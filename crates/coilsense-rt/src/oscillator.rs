//! What a damped mode does in a step without input.
//!
//! Next door: the series that it needs (`elementary`), all modes together (`plant`).

use crate::elementary::{exponential_less_one, sine_and_cosine, square_root};

/// What a step adds to (q, q̇/ω): `[a, b, d]` of `q += a q + b q̇/ω`, `q̇/ω += d q̇/ω − b q`.
///
/// C = e^(−ζx) cos(κx), S = e^(−ζx) sin(κx)/κ, κ = √(1 − ζ²), hyperbolic for ζ > 1; a = C − 1 + ζS, b = S, d = C − 1 − ζS
///
/// - `angle`: x = ωh, above 0 and at most 1e9; `ratio`: ζ, zero or above
///
/// C − 1 is found without cancellation: the rounding of an entry near 1 would add up, step by step, always the same way.
///
/// Source:   the solution of q̈ + 2ζω q̇ + ω² q = 0.
/// Valid:    any damping; undamped, critical and creeping modes among them.
/// Accuracy: 5e-16 of 1 + x (test).
pub fn turn(angle: f64, ratio: f64) -> [f64; 3] {
    let square = (1.0 - ratio) * (1.0 + ratio);
    let (cosine_less_one, sine) = if square > 0.0 {
        let root = square_root(square);
        let [half_sine, half_cosine] = sine_and_cosine(0.5 * (root * angle));
        let less = -2.0 * (half_sine * half_sine);
        let decay = exponential_less_one(-(ratio * angle));
        (decay * (1.0 + less) + less, (decay + 1.0) * (2.0 * (half_sine * half_cosine) / root))
    } else {
        let root = if square < 0.0 { square_root(-square) } else { 0.0 };
        let fast = (ratio + root) * angle;
        let slow = angle / (ratio + root);
        let [of_slow, of_fast] = [exponential_less_one(-slow), exponential_less_one(-fast)];
        let gap = 2.0 * (root * angle);
        // (e^−slow − e^−fast)/gap, by the difference where the roots meet.
        let unit = if gap > 0.0 { -exponential_less_one(-gap) / gap } else { 1.0 };
        (0.5 * (of_slow + of_fast), (of_slow + 1.0) * (unit * angle))
    };
    [cosine_less_one + ratio * sine, sine, cosine_less_one - ratio * sine]
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use num_complex::Complex64;

    /// By complex exponentials of both roots.
    fn by_exponentials(x: f64, ratio: f64) -> [f64; 3] {
        let root = Complex64::new((1.0 - ratio) * (1.0 + ratio), 0.0).sqrt();
        // Both roots multiply to 1: so the slow one keeps its digits.
        let other = Complex64::new(-ratio, 0.0) - Complex64::i() * root * if ratio > 1.0 { -1.0 } else { 1.0 };
        let one = other.inv();
        let (e, f) = ((one * x).exp(), (other * x).exp());
        let (cosine, sine) = ((0.5 * (e + f)).re, ((e - f) / (one - other)).re);
        [cosine - 1.0 + ratio * sine, sine, cosine - 1.0 - ratio * sine]
    }

    #[test]
    fn a_step_is_that_of_both_exponentials() {
        for x in [1e-9, 1e-4, 0.1, 1.0, 3.0, 47.0, 1e3, 1e5] {
            for ratio in [0.0, 1e-6, 0.005, 0.3, 0.99, 1.01, 3.0, 40.0, 1e3] {
                let pairs = turn(x, ratio).into_iter().zip(by_exponentials(x, ratio));
                // Exponentials of a difference lose the ratio's digits near 1.
                let allowed = 5e-16 * (1.0 + x) * if (0.9..1.1).contains(&ratio) { 10.0 } else { 1.0 };
                for (ours, theirs) in pairs {
                    assert!((ours - theirs).abs() < allowed, "x {x} ζ {ratio}: {ours:e} {theirs:e}");
                }
            }
        }
    }

    #[test]
    fn a_critical_mode_is_the_limit_of_its_neighbours() {
        for x in [1e-3, 0.5, 2.0] {
            for (at, (below, above)) in
                turn(x, 1.0).into_iter().zip(turn(x, 1.0 - 1e-9).into_iter().zip(turn(x, 1.0 + 1e-9)))
            {
                assert!((at - below).abs() < 1e-8 && (at - above).abs() < 1e-8);
                assert!((at - 0.5 * (below + above)).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn a_small_step_keeps_the_digits_of_what_it_adds() {
        // a = −x²/2 (1 − x²/12 …), b = x (1 − x²/6 …) without damping.
        for x in [1e-3_f64, 1e-6, 1e-9] {
            let [a, b, d] = turn(x, 0.0);
            assert!((a / (-0.5 * x * x * (1.0 - x * x / 12.0)) - 1.0).abs() < 1e-12 && a == d);
            assert!((b / (x * (1.0 - x * x / 6.0)) - 1.0).abs() < 1e-12);
        }
    }
}
