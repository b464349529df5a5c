//! A theory turned round: the length at which it gives a measured inductance.
//!
//! Next door: the theories (`crate::inductance::theories`), what is made of the lengths (`misfit`).

use super::misfit::Misfit;
use super::points::CalibrationPoints;
use crate::error::{Error, called, check};

/// How the length is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Inversion {
    /// The root of L(l) = L nearest to a length, searched for from there by steps of 2 % for as long as L falls with l, then closed in on to
    /// the last bits.
    Exact,
    /// Straight lines between 25 equidistant lengths from 1 to 1.55 times the zero length, the outer ones prolonged: the measured runs'
    /// authors' way, which is off by what the curve bends.
    TwentyFiveLengths {
        /// Length of the coil at zero displacement \[m\].
        zero_length: f64,
    },
}

/// By how much the exact search moves on.
const STEP: f64 = 1.02;

/// Most steps of the exact search: a factor 2.7e8 in length.
const STEPS: usize = 980;

impl Inversion {
    /// Length \[m\] at which a relation gives an inductance.
    ///
    /// - `relation`: L \[H\] of l \[m\], falling; `inductance`: L \[H\]; `near`: where to search from \[m\], used by [`Self::Exact`] only
    ///
    /// # Errors
    /// [`Error::Value`] for a `near` or zero length that is not above zero and finite, or where the relation does not reach that
    /// inductance, or does not fall with length on the way to it.
    ///
    /// ```
    /// use coilsense::calibrate::Inversion;
    /// use coilsense::inductance::theories::{Coil, nagaoka};
    /// let coil = Coil::new(52.0, 8e-3, 1e-3)?;
    /// let length = Inversion::Exact.length(|l| nagaoka(&coil, l), nagaoka(&coil, 0.25), 0.2)?;
    /// assert!((length - 0.25).abs() < 1e-15);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn length(self, relation: impl Fn(f64) -> f64, inductance: f64, near: f64) -> Result<f64, Error> {
        check(inductance.is_finite(), "inductance", inductance, "H", "finite")?;
        match self {
            Self::Exact => exact(relation, inductance, near),
            Self::TwentyFiveLengths { zero_length } => Ok(interpolate(&table(relation, zero_length)?, inductance)),
        }
    }

    /// How a relation, which was not fitted, does on points.
    ///
    /// - `relation`: L \[H\] of l \[m\], falling; the exact search starts from each point's own length
    ///
    /// # Errors
    /// As [`Self::length`] and [`Misfit::of`].
    ///
    /// ```
    /// use coilsense::calibrate::{CalibrationPoints, Inversion};
    /// use coilsense::inductance::theories::{Coil, Theory};
    /// let coil = Coil::new(52.0, 8e-3, 1e-3)?;
    /// let lengths = [0.20, 0.22, 0.24];
    /// let points = CalibrationPoints::new(&lengths, &lengths.map(|l| Theory::Lundin.inductance(&coil, l)))?;
    /// let misfit = Inversion::Exact.judge(&points, |l| Theory::Nagaoka.inductance(&coil, l))?;
    /// assert!(1.0 - misfit.r2 < 1e-9 && misfit.rmse < 1e-6);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn judge(self, points: &CalibrationPoints, relation: impl Fn(f64) -> f64) -> Result<Misfit, Error> {
        let predicted: Vec<f64> = points.lengths().iter().map(|&l| relation(l)).collect();
        let pairs = points.inductances().iter().zip(points.lengths());
        let read: Vec<f64> = match self {
            Self::Exact => pairs.map(|(&henry, &near)| exact(&relation, henry, near)).collect::<Result<_, _>>()?,
            Self::TwentyFiveLengths { zero_length } => {
                let table = table(&relation, zero_length)?;
                points.inductances().iter().map(|&henry| interpolate(&table, henry)).collect()
            }
        };
        Misfit::of(points, &predicted, &read)
    }
}

fn exact(relation: impl Fn(f64) -> f64, inductance: f64, near: f64) -> Result<f64, Error> {
    check(near.is_finite() && near > 0.0, called("near", "length to search from"), near, "m", "above zero and finite")?;
    let excess = |length: f64| relation(length) - inductance;
    let (mut here, mut left) = (near, excess(near));
    let onward = if left > 0.0 { STEP } else { 1.0 / STEP };
    for _ in 0..STEPS {
        if left == 0.0 {
            return Ok(here);
        }
        let next = here * onward;
        let beyond = excess(next);
        if left * beyond <= 0.0 {
            return Ok(root(excess, [here, next], [left, beyond]));
        }
        // Falling with length, or there is no telling which way the root lies.
        if !((beyond < left) == (next > here) && beyond.is_finite()) {
            break;
        }
        (here, left) = (next, beyond);
    }
    let allowed = format!("one that the theory reaches while it falls with length from {near} m");
    check(false, "inductance", inductance, "H", allowed)
}

/// A root between two ends of opposite sign, by false position with the weight of a stuck end halved (the Illinois rule).
fn root(function: impl Fn(f64) -> f64, [mut a, mut b]: [f64; 2], [mut fa, mut fb]: [f64; 2]) -> f64 {
    for _ in 0..100 {
        if fb == 0.0 || (b - a).abs() <= f64::EPSILON * b.abs() {
            break;
        }
        let c = b - fb * (b - a) / (fb - fa);
        let fc = function(c);
        if fb * fc < 0.0 {
            (a, fa) = (b, fb);
        } else {
            fa *= 0.5;
        }
        if (c - b).abs() <= 0.5 * f64::EPSILON * c.abs() {
            return c;
        }
        (b, fb) = (c, fc);
    }
    b
}

/// 25 lengths with their inductances, shortest first.
fn table(relation: impl Fn(f64) -> f64, zero_length: f64) -> Result<Vec<[f64; 2]>, Error> {
    check(zero_length.is_finite() && zero_length > 0.0, "zero_length", zero_length, "m", "above zero and finite")?;
    let rows: Vec<[f64; 2]> = (0..25)
        .map(|index| {
            let length = zero_length * (1.0 + 0.55 * f64::from(index) / 24.0);
            [length, relation(length)]
        })
        .collect();
    for pair in rows.windows(2) {
        let [[_, before], [length, after]] = [pair[0], pair[1]];
        check(after < before, "inductance of the theory", after, "H", format!("falling with length up to {length} m"))?;
    }
    Ok(rows)
}

fn interpolate(rows: &[[f64; 2]], inductance: f64) -> f64 {
    let reached = rows.iter().position(|row| row[1] < inductance).unwrap_or(rows.len());
    let upper = reached.clamp(1, rows.len() - 1);
    let [[from, high], [to, low]] = [rows[upper - 1], rows[upper]];
    from + (high - inductance) / (high - low) * (to - from)
}
