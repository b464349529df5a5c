//! A ratio of polynomials in s: what a controller is over frequency, and from sample to sample.
//!
//! Next door: which one it is (`controller`).

use num_complex::Complex64;

/// N(s)/D(s), coefficients with rising powers.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Rational {
    pub numerator: Vec<f64>,
    pub denominator: Vec<f64>,
}

/// A difference equation a_0 y_n = Σ b_i x_{n−i} − Σ_{i>0} a_i y_{n−i}.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Difference {
    pub forward: Vec<f64>,
    pub backward: Vec<f64>,
}

impl Rational {
    pub fn at(&self, s: Complex64) -> Complex64 {
        evaluate(&self.numerator, s) / evaluate(&self.denominator, s)
    }

    /// So many times as large.
    pub fn times(mut self, factor: f64) -> Self {
        self.numerator.iter_mut().for_each(|coefficient| *coefficient *= factor);
        self
    }

    /// By Tustin's rule s = (2/h)(z − 1)/(z + 1).
    pub fn tustin(&self, step: f64) -> Difference {
        let order = self.numerator.len().max(self.denominator.len()) - 1;
        let falling = |coefficients: &[f64]| {
            let mut sum = vec![0.0; order + 1];
            for (power, coefficient) in coefficients.iter().enumerate() {
                let mut term = vec![coefficient * (2.0 / step).powi(power as i32)];
                for _ in 0..power {
                    term = product(&term, &[1.0, -1.0]);
                }
                for _ in power..order {
                    term = product(&term, &[1.0, 1.0]);
                }
                sum.iter_mut().zip(&term).for_each(|(sum, term)| *sum += term);
            }
            sum
        };
        let (forward, backward) = (falling(&self.numerator), falling(&self.denominator));
        let first = backward[0];
        Difference {
            forward: forward.into_iter().map(|value| value / first).collect(),
            backward: backward.into_iter().map(|value| value / first).collect(),
        }
    }
}

impl Difference {
    /// Over frequency, `delay` = z⁻¹.
    pub fn at(&self, delay: Complex64) -> Complex64 {
        evaluate(&self.forward, delay) / evaluate(&self.backward, delay)
    }
}

/// Σ c_i x^i.
pub(super) fn evaluate(coefficients: &[f64], x: Complex64) -> Complex64 {
    coefficients.iter().rev().fold(Complex64::ZERO, |sum, coefficient| sum * x + coefficient)
}

/// Product of two polynomials.
pub(super) fn product(first: &[f64], second: &[f64]) -> Vec<f64> {
    let mut result = vec![0.0; first.len() + second.len() - 1];
    for (i, a) in first.iter().enumerate() {
        for (j, b) in second.iter().enumerate() {
            result[i + j] += a * b;
        }
    }
    result
}

/// Sum of two polynomials.
pub(super) fn sum(first: &[f64], second: &[f64]) -> Vec<f64> {
    let at = |coefficients: &[f64], index: usize| coefficients.get(index).copied().unwrap_or(0.0);
    (0..first.len().max(second.len())).map(|index| at(first, index) + at(second, index)).collect()
}
