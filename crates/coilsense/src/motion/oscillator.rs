//! One damped mode: its free motion over a step, and its answer to a sine from rest.
//!
//! Next door: all modes together (`closed`, `march`).

use num_complex::Complex64;

/// `q̈ + 2ζω q̇ + ω² q = f`, with ω above zero and ζ not below zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Oscillator {
    /// ω \[rad/s\].
    pub natural: f64,
    /// ζ \[1\].
    pub ratio: f64,
}

/// The two roots λ of `λ² + 2ζωλ + ω² = 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Roots {
    /// λ and its conjugate: −ζω ± iω√(1−ζ²).
    Pair(Complex64),
    /// Two real ones, −ω(ζ ∓ √(ζ²−1)).
    Real(f64, f64),
}

impl Oscillator {
    /// Its roots, the real ones without cancellation.
    pub(super) fn roots(&self) -> Roots {
        let (decay, square) = (self.ratio * self.natural, (1.0 - self.ratio) * (1.0 + self.ratio));
        if square > 0.0 {
            return Roots::Pair(Complex64::new(-decay, self.natural * square.sqrt()));
        }
        let fast = decay + self.natural * (-square).sqrt();
        Roots::Real(-self.natural * (self.natural / fast), -fast)
    }

    /// Its fastest rate, of turning or of decay \[1/s\].
    pub(super) fn fastest(&self) -> f64 {
        match self.roots() {
            Roots::Pair(_) => self.natural,
            Roots::Real(_, fast) => -fast,
        }
    }

    /// Whether its two roots are so close (2.8e-3 of ω) that formulas that divide by their difference lose three digits and more.
    pub(super) fn is_nearly_critical(&self) -> bool {
        (self.ratio - 1.0).abs() < 1e-6
    }

    /// What a jump of an input by one adds to q̇, at a participation of one: 2ζω. To q it adds −1.
    ///
    /// The windings stay while the straight line jumps under them, but damping acts on q̇, which is then a pulse of area −c: with p = q̇ + cẇ
    /// the mode's equation is ṗ = −2ζω q̇ − ω² q, and its integral over the jump 2ζω c. Over a jump of ẇ that area is zero.
    pub(super) fn impulse(&self) -> f64 {
        2.0 * self.ratio * self.natural
    }

    /// What a time `step` adds to `[q, q̇]`, row by row: the step's matrix less the unit matrix.
    ///
    /// S = e^(−ζωh) sin(ω_d h)/ω_d, C = e^(−ζωh) cos(ω_d h); `[C − 1 + ζωS, S, −ω²S, C − 1 − ζωS]`, hyperbolic for ζ > 1.
    /// C − 1 is found without cancellation: the rounding of an entry near 1 would add up, step by step, always the same way.
    pub(super) fn increment(&self, step: f64) -> [f64; 4] {
        let decay = self.ratio * self.natural;
        let (sine, cosine_less_one) = match self.roots() {
            Roots::Pair(root) => {
                let angle = root.im * step;
                let (sin, cos) = angle.sin_cos();
                let half = (0.5 * angle).sin();
                let unit = if angle.abs() < 1e-4 { 1.0 - angle * angle / 6.0 } else { sin / angle };
                ((root.re * step).exp() * unit * step, (root.re * step).exp_m1() * cos - 2.0 * half * half)
            }
            Roots::Real(slow, fast) => {
                let (slow_part, fast_part) = ((slow * step).exp_m1(), (fast * step).exp_m1());
                let gap = (slow - fast) * step;
                // (e^slow − e^fast)/(slow − fast), by expm1 where the roots meet.
                let unit = if gap > 1e-300 { -(-gap).exp_m1() / gap } else { 1.0 };
                ((slow_part + 1.0) * unit * step, 0.5 * (slow_part + fast_part))
            }
        };
        let square = self.natural * self.natural;
        [cosine_less_one + decay * sine, sine, -square * sine, cosine_less_one - decay * sine]
    }

    /// The steady answer to `e^(iωt)`: 1 / (ω_n² − ω² + 2iζω_nω), the difference of squares as a product.
    pub(super) fn steady_gain(&self, drive: f64) -> Complex64 {
        let real = (self.natural - drive) * (self.natural + drive);
        Complex64::new(real, 2.0 * self.ratio * self.natural * drive).inv()
    }
}

/// e^z, for which an undamped mode needs no exponential.
#[inline(always)]
pub(super) fn exponential(z: Complex64) -> Complex64 {
    if z.re == 0.0 {
        let (sin, cos) = z.im.sin_cos();
        return Complex64::new(cos, sin);
    }
    z.exp()
}

/// (e^(at) − e^(bt)) / (a − b), without cancellation where a and b are close: at a = b it is t e^(at), the secular solution.
pub(super) fn divided_exponential(a: Complex64, b: Complex64, time: f64) -> Complex64 {
    let gap = (a - b) * time;
    exponential(b * time) * phi1(gap) * time
}

/// (e^z − 1)/z.
fn phi1(z: Complex64) -> Complex64 {
    if z.norm_sqr() < 1e-2 {
        // Terms below 1e-17 from the ninth on.
        let mut sum = Complex64::new(1.0, 0.0);
        for k in (2..=11).rev() {
            sum = 1.0 + z / f64::from(k) * sum;
        }
        return sum;
    }
    // e^z − 1 = expm1(x) cos y − 2 sin²(y/2) + i e^x sin y
    let (sin, cos) = z.im.sin_cos();
    let half = (0.5 * z.im).sin();
    Complex64::new(z.re.exp_m1() * cos - 2.0 * half * half, z.re.exp() * sin) / z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_of_a_critical_mode_is_the_limit_of_its_neighbours() {
        let step = |ratio| Oscillator { natural: 300.0, ratio }.increment(2e-3);
        for (below, (at, above)) in step(1.0 - 1e-9).into_iter().zip(step(1.0).into_iter().zip(step(1.0 + 1e-9))) {
            // Smooth in ζ: each side differs by 1e-9 of the slope, about ω² S.
            assert!((below - at).abs() < 1e-4 && (above - at).abs() < 1e-4, "{below} {at} {above}");
            assert!((0.5 * (below + above) - at).abs() < 1e-9 * at.abs().max(1.0));
        }
    }

    #[test]
    fn two_half_steps_make_a_whole_one() {
        for ratio in [0.0, 0.01, 0.999_999, 1.0, 1.5, 40.0] {
            let mode = Oscillator { natural: 500.0, ratio };
            let [a, b, c, d] = mode.increment(1e-3);
            let (a, d) = (1.0 + a, 1.0 + d);
            let twice = [a * a + b * c - 1.0, a * b + b * d, c * a + d * c, c * b + d * d - 1.0];
            for (product, whole) in twice.into_iter().zip(mode.increment(2e-3)) {
                assert!((product - whole).abs() < 1e-12 * (1.0 + whole.abs()), "ζ {ratio}: {product} {whole}");
            }
        }
    }

    #[test]
    fn the_divided_exponential_is_smooth_where_its_roots_meet() {
        let (a, t) = (Complex64::new(-1.0, 340.0), 0.7);
        let secular = (a * t).exp() * t;
        for gap in [0.0, 1e-9, 1e-5, 0.1, 0.3] {
            let b = a - Complex64::new(0.0, gap);
            // e^(bt) (1 + i gap t/2 …) t about the secular solution.
            let expected = secular * Complex64::new(0.0, -0.5 * gap * t).exp() * (0.5 * gap * t).sin()
                / (0.5 * gap * t).max(1e-300);
            let expected = if gap == 0.0 { secular } else { expected };
            assert!((divided_exponential(a, b, t) - expected).norm() < 1e-12, "{gap}");
        }
    }
}
