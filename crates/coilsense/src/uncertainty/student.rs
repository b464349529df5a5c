//! How many standard uncertainties a coverage takes: Student's t, and the normal distribution.
//!
//! Next door: the degrees of freedom that a budget has (`budget`).

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_PI, FRAC_PI_2};

use super::probability;
use crate::error::{Error, check};

/// Above these, t follows from the normal distribution's z by an expansion in 1/ν.
const MANY: f64 = 1000.0;

/// k: half the width, in standard deviations, of the interval that holds `coverage` of Student's t.
///
/// ∫ f_ν(t) dt from −k to k = p; normal where ν is infinite
///
/// - `coverage`: p, above 0 and below 1; `degrees_of_freedom`: ν, 1 or above, infinite allowed; its whole part counts
///
/// Source:   `[JCGM100]` G.3 and table G.2, G.6.4 for the whole part; `[Abramowitz1964]` 26.7.3–26.7.5.
/// Valid:    p from 1e-6 to 1 − 1e-6.
/// Accuracy: 2e-12 relative against mpmath for ν of 1 to 1000, 1e-9 above.
///
/// # Errors
/// [`Error::Value`] for a coverage that is not between 0 and 1, or degrees of freedom below 1.
///
/// ```
/// use coilsense::uncertainty::coverage_factor;
///
/// assert!((coverage_factor(0.99, 16.0)? - 2.920_781_622_425).abs() < 1e-10);
/// assert!((coverage_factor(0.95, f64::INFINITY)? - 1.959_963_984_540).abs() < 1e-10);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn coverage_factor(coverage: f64, degrees_of_freedom: f64) -> Result<f64, Error> {
    probability(coverage)?;
    check(degrees_of_freedom >= 1.0, "degrees_of_freedom", degrees_of_freedom, "", "1 or above")?;
    // The sum that gave 16 may have rounded to just below it.
    let whole = (degrees_of_freedom * (1.0 + 1e-9)).floor();
    if whole <= MANY {
        let angle = bisect(0.0, FRAC_PI_2, |angle| within_angle(angle, whole as u32) < coverage);
        return Ok(whole.sqrt() * angle.tan());
    }
    let z = bisect(0.0, 40.0, |z| libm::erfc(z * FRAC_1_SQRT_2) > 1.0 - coverage);
    Ok(expanded(z, 1.0 / whole))
}

/// Probability of |t| ≤ √ν tan θ: finite sums of positive terms, one for even and one for odd ν.
fn within_angle(angle: f64, degrees_of_freedom: u32) -> f64 {
    let (sine, cosine) = angle.sin_cos();
    let square = cosine * cosine;
    let sum = |from: u32| {
        let (mut term, mut sum) = (1.0, 1.0);
        for factor in (from..degrees_of_freedom - 2).step_by(2) {
            term *= square * f64::from(factor) / f64::from(factor + 1);
            sum += term;
        }
        sum
    };
    match degrees_of_freedom {
        1 => FRAC_2_PI * angle,
        even if even % 2 == 0 => sine * sum(1),
        _ => FRAC_2_PI * (angle + sine * cosine * sum(2)),
    }
}

/// t after z, in powers of 1/ν.
fn expanded(z: f64, inverse: f64) -> f64 {
    let s = z * z;
    let first = z * (s + 1.0) / 4.0;
    let second = z * ((5.0 * s + 16.0) * s + 3.0) / 96.0;
    let third = z * (((3.0 * s + 19.0) * s + 17.0) * s - 15.0) / 384.0;
    z + inverse * (first + inverse * (second + inverse * third))
}

/// Where `below` turns false, to the last digit.
fn bisect(low: f64, high: f64, below: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (low, high);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if below(middle) { low = middle } else { high = middle }
    }
}
