//! Up to which frequency two records have the same motion in them.
//!
//! Next door: what is made of it (the parent).

use super::transform;
use crate::error::Error;
use num_complex::Complex64;

/// Parts of the record, each tapered after Hann.
const PARTS: usize = 16;
/// Probability that noise alone is taken for coherent at any line.
const CHANCE: f64 = 0.01;

/// The highest frequency \[cycles a sample\] at which records of one length are coherent, and two lines more.
///
/// γ² = |Σ Ā B|²/(Σ|A|² Σ|B|²) over K parts is above 1 − p^(1/(K−1)) with probability p where there is nothing in common.
///
/// Source: `[Carter1987]` for the distribution of the estimated coherence.
pub(super) fn coherent(a: &[f64], b: &[f64]) -> Result<f64, Error> {
    let length = a.len() / PARTS;
    let taper = |index: usize| 0.5 - 0.5 * (std::f64::consts::TAU * index as f64 / length as f64).cos();
    let lines = |values: &[f64], part: usize| {
        let values = values.iter().skip(part * length).take(length).enumerate();
        transform(&mut values.map(|(index, value)| value * taper(index)).collect::<Vec<f64>>())
    };
    let count = length / 2 + 1;
    let (mut cross, mut power) = (vec![Complex64::ZERO; count], vec![(0.0, 0.0); count]);
    for part in 0..PARTS {
        for (line, (a, b)) in lines(a, part)?.into_iter().zip(lines(b, part)?).enumerate() {
            cross[line] += a.conj() * b;
            power[line].0 += a.norm_sqr();
            power[line].1 += b.norm_sqr();
        }
    }
    let threshold = 1.0 - (CHANCE / count as f64).powf(1.0 / (PARTS as f64 - 1.0));
    let is_coherent = |&line: &usize| cross[line].norm_sqr() > threshold * power[line].0 * power[line].1;
    let highest = (1..count).rev().find(is_coherent).unwrap_or(1);
    Ok((highest + 2) as f64 / length as f64)
}
