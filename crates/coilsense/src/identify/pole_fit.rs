//! Exponentials that several hits share, fitted together: frequencies and dampings by Gauss and Newton, amplitudes projected out.
//!
//! Next door: which lines are fitted over which stretches (`refine`).

use nalgebra::{DMatrix, DVector};
use num_complex::Complex;

/// The transform of one stretch of one series, within a band.
#[derive(Debug, Clone)]
pub(super) struct Block {
    /// Which series and which hit it is of.
    pub(super) series: usize,
    pub(super) hit: usize,
    /// Angle ω of each line per sample \[rad\], shape `lines`.
    pub(super) angles: Vec<f64>,
    /// e^(−iω) of each, which every trial pole asks for.
    pub(super) turns: Vec<Complex<f64>>,
    /// Transform of each line over the series' noise, shape `lines`.
    pub(super) values: Vec<Complex<f64>>,
    /// How many samples the stretch has.
    pub(super) length: usize,
}

/// What a fit found.
#[derive(Debug, Clone)]
pub(super) struct Fit {
    /// λ = −σ + iω per sample of each free pole.
    pub(super) poles: Vec<Complex<f64>>,
    /// Standard uncertainty of Re λ and of Im λ, each \[per sample\].
    pub(super) standard: Vec<f64>,
    /// Mean square of what is left over that of the noise which it was scaled by: 1 for white noise.
    pub(super) excess: f64,
    /// Complex degrees of freedom.
    pub(super) freedom: usize,
    /// Amplitude of each free pole in each block, at the stretch's first sample, over the noise; shape `blocks` of `free`.
    pub(super) amplitudes: Vec<Vec<Complex<f64>>>,
    /// What is left of each block.
    pub(super) residuals: Vec<Vec<Complex<f64>>>,
}

/// Complex terms of the smooth rest per block: a polynomial over the band's angles.
const SMOOTH: usize = 7;
/// Terms of slow motion, (1 − e^(−iω))^(−p), where the band begins low.
const SLOW: usize = 2;
/// Most steps of a fit.
const STEPS: usize = 25;

/// Orthonormal columns of what is not looked for, and everything else less its part in them.
struct Prepared {
    nuisance: Vec<Vec<Complex<f64>>>,
    values: Vec<Complex<f64>>,
}

/// Fits `free` poles (starting values) beside `fixed` ones to all blocks together.
///
/// The transform of A z^n, n = 0…N−1, z = e^λ, on the lines ω_k = 2πk/N of its own stretch is exactly A (1 − z^N)/(1 − z e^(−iω_k)): one
/// term per pole. What lies outside of the band is smooth within it: a polynomial takes it. So
/// y_k = Σ_p c_p/(1 − z_p e^(−iω_k)) + smooth + noise, with c and the smooth terms of each block projected out, and λ the same in all.
/// Noise that is white about the band makes the lines' errors independent, circular and alike; then u²(Re λ) = u²(Im λ) = ½ s² [(GᴴG)⁻¹]_pp.
///
/// Source:   variable projection, `[Golub2003]`, with Kaufman's derivative; the rational form is that of local polynomial methods, `[Pintelon2012]` chapter 7.
/// Valid:    poles that do not change, linear ringing, noise smooth over the band.
/// Accuracy: 1e-9 of the frequency without noise; coverage of the intervals measured in `tests/identify`.
pub(super) fn fit(blocks: &[Block], free: &[Complex<f64>], fixed: &[Complex<f64>]) -> Option<Fit> {
    let prepared: Vec<Prepared> = blocks.iter().map(|block| prepare(block, fixed)).collect();
    let mut poles = free.to_vec();
    let mut state = State::at(blocks, &prepared, &poles)?;
    let mut damping = 0.0;
    for _ in 0..STEPS {
        let step = state.step(damping)?;
        let trial: Vec<Complex<f64>> = poles.iter().zip(step.iter()).map(|(pole, step)| bounded(pole + step)).collect();
        let small = step.iter().zip(&state.standard(1.0)?).all(|(step, u)| step.norm() < 1e-3 * u);
        match State::at(blocks, &prepared, &trial) {
            Some(next) if next.square <= state.square => {
                let still = state.square - next.square <= 1e-9 * state.square;
                (poles, state) = (trial, next);
                damping *= 0.1;
                if small || (still && damping < 1e-6) {
                    break;
                }
            }
            _ if small => break,
            _ => damping = if damping == 0.0 { 1e-2 } else { 10.0 * damping },
        }
        if damping > 1e6 {
            break;
        }
    }
    let taken = blocks.len() * free.len() + prepared.iter().map(|p| p.nuisance.len()).sum::<usize>() + free.len();
    let lines: usize = blocks.iter().map(|block| block.values.len()).sum();
    let freedom = lines.checked_sub(taken).filter(|freedom| *freedom >= 4)?;
    // A transform of N white samples of variance 1 has lines of mean square N, by which blocks are scaled.
    let excess = state.square / freedom as f64;
    let standard = state.standard(excess)?;
    Some(Fit { poles, standard, excess, freedom, amplitudes: state.amplitudes, residuals: state.residuals })
}

/// Amplitudes of poles that stay as they are, in each block at the stretch's first sample, over the noise; shape `blocks` of `poles`.
pub(super) fn amplitudes(
    blocks: &[Block],
    poles: &[Complex<f64>],
    fixed: &[Complex<f64>],
) -> Option<Vec<Vec<Complex<f64>>>> {
    let prepared: Vec<Prepared> = blocks.iter().map(|block| prepare(block, fixed)).collect();
    State::at(blocks, &prepared, poles).map(|state| state.amplitudes)
}

/// A pole that grows or that no longer swings is none.
fn bounded(pole: Complex<f64>) -> Complex<f64> {
    Complex::new(pole.re.clamp(-1.0, 1e-4), pole.im.clamp(1e-6, std::f64::consts::PI - 1e-6))
}

/// 1/(1 − z e^(−iω)) over the lines, of their e^(−iω).
pub(super) fn column(pole: Complex<f64>, turns: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let z = pole.exp();
    let term = |turn: &Complex<f64>| {
        let distance = 1.0 - z * turn;
        // A pole that meets a line would have no number there.
        1.0 / if distance.norm_sqr() < 1e-24 { Complex::new(1e-12, 0.0) } else { distance }
    };
    turns.iter().map(term).collect()
}

fn prepare(block: &Block, fixed: &[Complex<f64>]) -> Prepared {
    let angles = &block.angles;
    let (low, high) = (angles[0], angles[angles.len() - 1]);
    let (middle, half) = (0.5 * (low + high), (0.5 * (high - low)).max(f64::MIN_POSITIVE));
    let mut columns: Vec<Vec<Complex<f64>>> = (0..SMOOTH)
        .map(|power| {
            angles.iter().map(|angle| Complex::new(((angle - middle) / half).powi(power as i32), 0.0)).collect()
        })
        .collect();
    if low < half {
        for power in 1..=SLOW {
            columns.push(block.turns.iter().map(|turn| (1.0 - turn).powi(-(power as i32))).collect());
        }
    }
    columns.extend(fixed.iter().map(|pole| column(*pole, &block.turns)));
    let mut nuisance: Vec<Vec<Complex<f64>>> = Vec::new();
    for column in columns {
        let size = norm(&column);
        if let Some(unit) = orthonormal(column, &nuisance, 1e-10 * size) {
            nuisance.push(unit);
        }
    }
    let mut values = block.values.clone();
    remove(&mut values, &nuisance);
    Prepared { nuisance, values }
}

/// Residual and derivatives at one choice of poles.
struct State {
    square: f64,
    amplitudes: Vec<Vec<Complex<f64>>>,
    residuals: Vec<Vec<Complex<f64>>>,
    normal: DMatrix<Complex<f64>>,
    right: DVector<Complex<f64>>,
}

impl State {
    fn at(blocks: &[Block], prepared: &[Prepared], poles: &[Complex<f64>]) -> Option<Self> {
        let count = poles.len();
        let mut normal = DMatrix::zeros(count, count);
        let mut right = DVector::zeros(count);
        let (mut amplitudes, mut residuals, mut square) = (Vec::new(), Vec::new(), 0.0);
        for (block, prepared) in blocks.iter().zip(prepared) {
            let mut basis: Vec<Vec<Complex<f64>>> = Vec::with_capacity(count);
            let mut upper = DMatrix::<Complex<f64>>::zeros(count, count);
            for (index, pole) in poles.iter().enumerate() {
                let mut vector = column(*pole, &block.turns);
                let size = norm(&vector);
                remove(&mut vector, &prepared.nuisance);
                for (row, unit) in basis.iter().enumerate() {
                    upper[(row, index)] = project(&mut vector, unit);
                }
                for (row, unit) in basis.iter().enumerate() {
                    upper[(row, index)] += project(&mut vector, unit);
                }
                let left = norm(&vector);
                if left <= 1e-9 * size {
                    return None;
                }
                upper[(index, index)] = left.into();
                vector.iter_mut().for_each(|x| *x /= left);
                basis.push(vector);
            }
            let mut rest = prepared.values.clone();
            let coefficients = DVector::from_iterator(count, basis.iter().map(|unit| project(&mut rest, unit)));
            let weights = upper.solve_upper_triangular(&coefficients)?;
            let slopes: Vec<Vec<Complex<f64>>> = poles
                .iter()
                .zip(weights.iter())
                .map(|(pole, weight)| {
                    // dφ/dλ = z e^(−iω) φ² = φ² − φ.
                    let mut slope: Vec<Complex<f64>> =
                        column(*pole, &block.turns).iter().map(|x| (x * x - x) * weight).collect();
                    remove(&mut slope, &prepared.nuisance);
                    remove(&mut slope, &basis);
                    slope
                })
                .collect();
            for (row, slope) in slopes.iter().enumerate() {
                right[row] += inner(slope, &rest);
                for (column, other) in slopes.iter().enumerate() {
                    normal[(row, column)] += inner(slope, other);
                }
            }
            square += rest.iter().map(Complex::norm_sqr).sum::<f64>();
            let last = block.length as f64;
            let started = |(weight, pole): (&Complex<f64>, &Complex<f64>)| {
                let gone = -(pole * last).exp() + 1.0;
                weight / if gone.norm() < 1e-9 { Complex::new(1e-9, 0.0) } else { gone }
            };
            amplitudes.push(weights.iter().zip(poles).map(started).collect());
            residuals.push(rest);
        }
        square.is_finite().then_some(Self { square, amplitudes, residuals, normal, right })
    }

    /// Step of Gauss and Newton, held back by `damping` after Marquardt.
    fn step(&self, damping: f64) -> Option<DVector<Complex<f64>>> {
        let mut normal = self.normal.clone();
        for index in 0..normal.nrows() {
            normal[(index, index)] *= Complex::from(1.0 + damping);
        }
        normal.cholesky().map(|factor| factor.solve(&self.right))
    }

    /// Standard uncertainties of Re λ and of Im λ where the noise's lines have the mean square `noise`.
    fn standard(&self, noise: f64) -> Option<Vec<f64>> {
        let inverse = self.normal.clone().cholesky()?.inverse();
        Some((0..inverse.nrows()).map(|index| (0.5 * noise * inverse[(index, index)].re.max(0.0)).sqrt()).collect())
    }
}

fn inner(left: &[Complex<f64>], right: &[Complex<f64>]) -> Complex<f64> {
    left.iter().zip(right).map(|(a, b)| a.conj() * b).sum()
}

fn norm(vector: &[Complex<f64>]) -> f64 {
    vector.iter().map(Complex::norm_sqr).sum::<f64>().sqrt()
}

/// Takes a vector's part along a unit vector out, and returns it.
fn project(vector: &mut [Complex<f64>], unit: &[Complex<f64>]) -> Complex<f64> {
    let part = inner(unit, vector);
    vector.iter_mut().zip(unit).for_each(|(x, u)| *x -= part * u);
    part
}

fn remove(vector: &mut [Complex<f64>], basis: &[Vec<Complex<f64>>]) {
    for unit in basis {
        project(vector, unit);
    }
}

/// A column made orthogonal to a basis (twice, against rounding) and of length 1; none where nothing is left.
fn orthonormal(mut column: Vec<Complex<f64>>, basis: &[Vec<Complex<f64>>], least: f64) -> Option<Vec<Complex<f64>>> {
    remove(&mut column, basis);
    remove(&mut column, basis);
    let left = norm(&column);
    if left <= least {
        return None;
    }
    column.iter_mut().for_each(|x| *x /= left);
    Some(column)
}
