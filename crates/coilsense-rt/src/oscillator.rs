//! What a damped mode does in a step without input.
//!
//! Next door: the series that it needs (`elementary`), all modes together (`plant`).

use crate::elementary::{exponential_less_one, quarter_turns, sine_and_cosine_less_one, square_root};

/// Up to this ζωh a mode rings on for 64 steps and more.
const RINGS_ON: f64 = 1.0 / 64.0;

/// A step of a mode (q, q̇/ω): whole quarter turns, and what is left, which is small where the mode is hardly damped.
///
/// q' = r₀ q + r₁ p + (a q + b p), p' = r₀ p − r₁ q + (d p − b q)
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeStep {
    /// r₀, r₁ \[1\]: 1, 0 or −1.
    pub quarters: [f64; 2],
    /// a, b, d \[1\].
    pub rest: [f64; 3],
}

impl ModeStep {
    /// The step of a mode without input.
    ///
    /// C = e^(−ζx) cos(κx), S = e^(−ζx) sin(κx)/κ, κ = √(1 − ζ²), hyperbolic for ζ > 1; a = C + ζS − r₀, b = S − r₁, d = C − ζS − r₀
    ///
    /// - `angle`: x = ωh, above 0 and at most 1e9; `ratio`: ζ, zero or above
    ///
    /// C − 1 is found without cancellation: the rounding of an entry near 1 would add up, step by step, always the same way. That of a mode
    /// which turns by nearly a quarter would, too, and so the quarters are taken out.
    ///
    /// Source:   the solution of q̈ + 2ζω q̇ + ω² q = 0.
    /// Valid:    any damping; undamped, critical and creeping modes among them.
    /// Accuracy: 5e-16 of 1 + x (test).
    ///
    /// ```
    /// let [r0, _] = coilsense_rt::ModeStep::new(std::f64::consts::PI, 0.0).quarters;
    /// assert_eq!(r0, -1.0); // half a turn
    /// ```
    pub fn new(angle: f64, ratio: f64) -> Self {
        let square = (1.0 - ratio) * (1.0 + ratio);
        if square > 0.0 {
            Self::turning(angle, ratio, square_root(square))
        } else {
            Self::creeping(angle, ratio, -square)
        }
    }

    /// Below critical damping.
    fn turning(angle: f64, ratio: f64, root: f64) -> Self {
        let (quarters, rest) = quarter_turns(root * angle);
        let [s, dip] = sine_and_cosine_less_one(rest);
        let c = 1.0 + dip;
        let decay = exponential_less_one(-(ratio * angle));
        let left = 1.0 + decay;
        // e^(−ζx) of cos − 1 and sin, whole.
        let (less, sine) = match quarters {
            0 => (decay * c + dip, left * s / root),
            1 => (-(left * s) - 1.0, left * c / root),
            2 => (-(left * c) - 1.0, -(left * s) / root),
            _ => (left * s - 1.0, -(left * c) / root),
        };
        let taken = if ratio * angle <= RINGS_ON { quarters } else { 0 };
        match taken {
            0 => Self { quarters: [1.0, 0.0], rest: entries(less, sine, ratio, 0.0) },
            1 => Self { quarters: [0.0, 1.0], rest: entries(less + 1.0, sine, ratio, 1.0) },
            2 => Self { quarters: [-1.0, 0.0], rest: entries(-(decay * c + dip), sine, ratio, 0.0) },
            _ => Self { quarters: [0.0, -1.0], rest: entries(less + 1.0, sine, ratio, -1.0) },
        }
    }

    /// From critical damping on; `square`: ζ² − 1.
    fn creeping(angle: f64, ratio: f64, square: f64) -> Self {
        let root = if square > 0.0 { square_root(square) } else { 0.0 };
        let fast = (ratio + root) * angle;
        let slow = angle / (ratio + root);
        let [of_slow, of_fast] = [exponential_less_one(-slow), exponential_less_one(-fast)];
        let gap = 2.0 * (root * angle);
        // (e^−slow − e^−fast)/gap, by the difference where the roots meet.
        let unit = if gap > 0.0 { -exponential_less_one(-gap) / gap } else { 1.0 };
        let sine = (of_slow + 1.0) * (unit * angle);
        Self { quarters: [1.0, 0.0], rest: entries(0.5 * (of_slow + of_fast), sine, ratio, 0.0) }
    }

    /// The same as a matrix.
    pub fn matrix(&self) -> [[f64; 2]; 2] {
        let ([r0, r1], [a, b, d]) = (self.quarters, self.rest);
        [[r0 + a, r1 + b], [-(r1 + b), r0 + d]]
    }
}

/// a, b, d.
fn entries(cosine: f64, sine: f64, ratio: f64, taken: f64) -> [f64; 3] {
    [cosine + ratio * sine, sine - taken, cosine - ratio * sine]
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use num_complex::Complex64;

    /// Less the unit matrix.
    fn turn(x: f64, ratio: f64) -> [f64; 3] {
        let step = ModeStep::new(x, ratio);
        let ([r0, r1], [a, b, d]) = (step.quarters, step.rest);
        [(r0 - 1.0) + a, r1 + b, (r0 - 1.0) + d]
    }

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
    fn what_is_left_of_quarter_turns_is_small() {
        for k in 0..2000 {
            let step = ModeStep::new(1e-3 + 0.013 * f64::from(k), 1e-5);
            assert!(step.rest.iter().all(|entry| entry.abs() < 0.71), "{step:?}");
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
