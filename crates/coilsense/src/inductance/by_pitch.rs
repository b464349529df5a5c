//! What the second-order form is made of, as polynomials in the mean pitch: for those who have no elliptic integrals at hand.
//!
//! Next door: the form at one length (`second_order`), its polynomials over the lengths of a few samples (`near_uniform`), who writes these down
//! (`crate::plant`).

use super::chebyshev::Interpolation;
use super::derivatives::{MutualDerivatives, mutual_inductance_derivatives};
use super::maxwell::MaxwellSum;
use crate::error::{Error, check};

/// L0(p), 2M′(ap), M″(ap), ⅓ |M‴(ap)| ap as polynomials in z = (p − p0)/w from −1 to 1, coefficients lowest power first; series by the number
/// of turns apart.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ByPitch {
    /// p0 and w \[m\].
    pub pitches: [f64; 2],
    /// L0 \[H\], shape `terms`.
    pub inductance: Vec<f64>,
    /// 2M′ \[H/m\], shape `turns − 1 × terms`.
    pub slopes: Vec<Vec<f64>>,
    /// M″ \[H/m²\], likewise.
    pub curvatures: Vec<Vec<f64>>,
    /// Nowhere below ⅓ |M‴| ap \[H/m²\], likewise.
    pub remainders: Vec<Vec<f64>>,
    /// What polynomials leave of L, at most \[1\]; of turns anywhere short of meeting.
    pub left: f64,
}

/// What polynomials may leave of L \[1\]: of S_T's force 1e-8 N.
const LEFT: f64 = 1e-11;
/// Of the remainder, which is a bound itself, polynomials may leave this much \[1\].
const OF_REMAINDER: f64 = 1e-3;
/// Most coefficients of a polynomial.
const MOST_TERMS: usize = 32;
/// Places between two nodes at which polynomials are held against what they stand for.
const CHECKS: usize = 4;

impl MaxwellSum {
    /// The second-order form's coefficients over lengths \[m\], the shorter first.
    ///
    /// # Errors
    /// [`Error::Value`] for a coil of sections, for lengths of which the first is not above zero or not below the second, and where
    /// polynomials of 32 coefficients leave more than 1e-11 of L.
    pub(crate) fn by_pitch(&self, lengths: [f64; 2]) -> Result<ByPitch, Error> {
        self.check_even()?;
        let [shortest, longest] = lengths;
        crate::error::above_zero("shortest length", shortest, "m")?;
        let allowed = format!("above {shortest} m and finite");
        check(longest > shortest && longest.is_finite(), "longest length", longest, "m", allowed)?;
        let found = (4..=MOST_TERMS).map(|terms| self.polynomials(lengths, terms)).find(|found| found.left <= LEFT);
        let allowed = format!("nearer to {shortest} m: polynomials over all lengths between lose digits of L");
        check(found.is_some(), "longest length", longest, "m", allowed)?;
        found.ok_or(Error::MissingSignal("L"))
    }

    fn polynomials(&self, [shortest, longest]: [f64; 2], terms: usize) -> ByPitch {
        let pitches = [0.5 * (longest + shortest) / self.windings(), 0.5 * (longest - shortest) / self.windings()];
        let [middle, half] = pitches;
        let interpolation = Interpolation::new(terms);
        let values: Vec<AtPitch> =
            interpolation.nodes().iter().map(|node| AtPitch::of(self, middle + half * node)).collect();
        let polynomial = |value: &dyn Fn(&AtPitch) -> f64| {
            let mut coefficients = vec![0.0; terms];
            interpolation.coefficients(&values.iter().map(value).collect::<Vec<f64>>(), &mut coefficients);
            coefficients
        };
        let by_lag = |value: &dyn Fn(&Lag) -> f64| -> Vec<Vec<f64>> {
            (1..self.places().len()).map(|lag| polynomial(&|at| value(&at.lags[lag - 1]))).collect()
        };
        let above = 1.0 + 2.0 * OF_REMAINDER;
        let mut made = ByPitch {
            pitches,
            inductance: polynomial(&|at| at.inductance),
            slopes: by_lag(&|lag| lag.slope),
            curvatures: by_lag(&|lag| lag.curvature),
            remainders: by_lag(&|lag| above * lag.remainder),
            left: 0.0,
        };
        let checks = CHECKS * terms;
        let z = |index: usize| 2.0 * index as f64 / checks as f64 - 1.0;
        let worst = (0..=checks).map(|index| made.leaves(self, z(index))).fold(0.0, f64::max);
        made.left = 2.0 * worst;
        made
    }
}

impl ByPitch {
    /// How far L is off at z \[1\], its turns as far from even as they may be; infinite where a remainder is too small.
    fn leaves(&self, coil: &MaxwellSum, z: f64) -> f64 {
        let pitch = self.pitches[0] + self.pitches[1] * z;
        let exact = AtPitch::of(coil, pitch);
        let mut off = (value(&self.inductance, z) - exact.inductance).abs();
        let turns = coil.places().len();
        let polynomials = self.slopes.iter().zip(&self.curvatures).zip(&self.remainders);
        for (index, (((slope, curvature), remainder), lag)) in polynomials.zip(&exact.lags).enumerate() {
            // Turns a apart are up to ap nearer or further, and there are N − a pairs of them.
            let (pairs, most) = ((turns - 1 - index) as f64, (index + 1) as f64 * pitch);
            off += pairs * most * (value(slope, z) - lag.slope).abs();
            off += pairs * most * most * (value(curvature, z) - lag.curvature).abs();
            if value(remainder, z) < lag.remainder {
                return f64::INFINITY;
            }
        }
        off / exact.inductance
    }
}

/// What is found at one pitch.
struct AtPitch {
    inductance: f64,
    lags: Vec<Lag>,
}

/// Of turns a apart.
struct Lag {
    slope: f64,
    curvature: f64,
    remainder: f64,
}

impl AtPitch {
    fn of(coil: &MaxwellSum, pitch: f64) -> Self {
        let turns = coil.places().len();
        let mut pairs = 0.0;
        let mut lags = Vec::with_capacity(turns.saturating_sub(1));
        for lag in 1..turns {
            let distance = lag as f64 * pitch;
            let MutualDerivatives { value, first, second, third } =
                mutual_inductance_derivatives(coil.coil_radius(), distance);
            pairs += 2.0 * (turns - lag) as f64 * value;
            lags.push(Lag { slope: 2.0 * first, curvature: second, remainder: third.abs() * distance / 3.0 });
        }
        Self { inductance: coil.self_part() + pairs, lags }
    }
}

/// Horner's scheme.
fn value(coefficients: &[f64], z: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |value, coefficient| value * z + coefficient)
}
