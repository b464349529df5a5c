//! Frequencies and shapes of a chain of unequal masses and segments, each to its own last digits.
//!
//! Next door: the closed form of the uniform chain and what a motion takes of them (`crate::modes`).

/// Halvings after which a frequency is known to rounding.
const HALVINGS: usize = 64;

/// The modes of a chain, lowest first.
pub(crate) struct ChainSpectrum {
    /// ω_j \[rad/s\], shape `N`.
    pub frequencies: Vec<f64>,
    /// φ_j(i), of the largest entry 1, shape `N × N`, row-major by modes.
    pub shapes: Vec<f64>,
}

/// Of `masses` \[kg\], shape `N`, and `stiffnesses` \[N/m\], shape `N + 1`, all above zero but for the last, which is zero at a free end.
///
/// ω_j are the singular values of √K S M^(−1/2), S the differences between neighbours: the upper half of the spectrum of a symmetric tridiagonal
/// matrix with a diagonal of zeros and √(k_j/m_i) beside it. Counted by Sturm's sequence, each is found to its own relative accuracy, the lowest too,
/// where a general eigenvalue solver has the largest's; shapes by twisted factorization.
///
/// Source:   `[Demmel1990]`; twisted factorization as in `[Dhillon2004]`.
/// Valid:    any chain; frequencies that lie within 1e-13 of one another share what their shapes span.
/// Accuracy: 1e-14 of each frequency, 1e-9 of shapes of a thousand masses (test).
pub(crate) fn chain_spectrum(masses: &[f64], stiffnesses: &[f64]) -> ChainSpectrum {
    let Matrix { squares, below, top } = Matrix::of(masses, stiffnesses);
    let squares = &squares;
    let mut spectrum = ChainSpectrum { frequencies: Vec::new(), shapes: Vec::new() };
    let mut lower = 0.0;
    for mode in 1..=masses.len() {
        let frequency = find(squares, below + mode, lower, top);
        lower = frequency * (1.0 - 1e-12);
        spectrum.frequencies.push(frequency);
        spectrum.shapes.extend(shape(squares, frequency, masses));
    }
    spectrum
}

/// ω_1 \[rad/s\] of such a chain alone.
pub(crate) fn first_frequency(masses: &[f64], stiffnesses: &[f64]) -> f64 {
    let Matrix { squares, below, top } = Matrix::of(masses, stiffnesses);
    find(&squares, below + 1, 0.0, top)
}

/// The symmetric tridiagonal matrix with a diagonal of zeros.
struct Matrix {
    /// What couples segment, mass, segment, … each to the next, squared.
    squares: Vec<f64>,
    /// Eigenvalues that are not above zero: as many below as above, and one at zero where a segment is at either end.
    below: usize,
    /// A bound on all of them.
    top: f64,
}

impl Matrix {
    fn of(masses: &[f64], stiffnesses: &[f64]) -> Self {
        let each = masses.iter().enumerate();
        let mut squares: Vec<f64> =
            each.flat_map(|(mass, m)| [stiffnesses[mass] / m, stiffnesses[mass + 1] / m]).collect();
        let is_free = stiffnesses.last() == Some(&0.0);
        if is_free {
            squares.pop();
        }
        let pairs = squares.windows(2).map(|pair| pair[0].sqrt() + pair[1].sqrt());
        let top = pairs.fold(squares.iter().fold(0.0_f64, |most, square| most.max(square.sqrt())), f64::max);
        Self { squares, below: masses.len() + usize::from(!is_free), top: top * (1.0 + 1e-14) }
    }
}

/// The `number`th eigenvalue from below, which lies between two bounds.
fn find(squares: &[f64], number: usize, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = if low > 0.0 && high > 4.0 * low { (low * high).sqrt() } else { 0.5 * (low + high) };
        if middle <= low || middle >= high {
            break;
        }
        if count_below(squares, middle) >= number { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// How many eigenvalues lie below a value.
fn count_below(squares: &[f64], value: f64) -> usize {
    let mut pivot = -value;
    let mut count = usize::from(pivot < 0.0);
    for square in squares {
        pivot = -value - square / pivot;
        if pivot == 0.0 {
            pivot = -f64::MIN_POSITIVE;
        }
        count += usize::from(pivot < 0.0);
    }
    count
}

/// The masses' part of an eigenvector, as displacements.
fn shape(squares: &[f64], value: f64, masses: &[f64]) -> Vec<f64> {
    let size = squares.len() + 1;
    let (mut down, mut up) = (vec![-value; size], vec![-value; size]);
    // A pivot that rounding alone has left says nothing but that.
    let least = 1e-3 * f64::EPSILON * value;
    let pivot = |sum: f64| if sum.abs() < least { least } else { sum };
    for row in 1..size {
        down[row] = pivot(-value - squares[row - 1] / down[row - 1]);
    }
    for row in (0..size - 1).rev() {
        up[row] = pivot(-value - squares[row] / up[row + 1]);
    }
    let twist = |row: &usize| (down[*row] + up[*row] + value).abs();
    // A mass, since what is wanted is the masses' part.
    let begin = (1..size).step_by(2).min_by(|a, b| twist(a).total_cmp(&twist(b))).unwrap_or(0);
    let mut vector = vec![0.0; size];
    vector[begin] = 1.0;
    for row in (0..begin).rev() {
        vector[row] = -squares[row].sqrt() / down[row] * vector[row + 1];
    }
    for row in begin + 1..size {
        vector[row] = -squares[row - 1].sqrt() / up[row] * vector[row - 1];
    }
    // Signs: a mass pulls its two segments in opposite directions, which the matrix of positive entries does not know.
    let mut shape: Vec<f64> = (1..size).step_by(2).zip(masses).map(|(row, mass)| vector[row] / mass.sqrt()).collect();
    shape.iter_mut().skip(1).step_by(2).for_each(|value| *value = -*value);
    let largest = shape.iter().fold(0.0_f64, |most, value| if value.abs() > most.abs() { *value } else { most });
    let first = if shape[0] < 0.0 { -largest.abs() } else { largest.abs() };
    shape.iter_mut().for_each(|value| *value /= first);
    shape
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uniform(lumps: usize, last: f64) -> ChainSpectrum {
        let stiffness = lumps as f64;
        let mut stiffnesses = vec![stiffness; lumps + 1];
        (stiffnesses[0], stiffnesses[lumps]) = (2.0 * stiffness, last * 2.0 * stiffness);
        chain_spectrum(&vec![1.0 / lumps as f64; lumps], &stiffnesses)
    }

    #[test]
    fn a_uniform_chain_has_its_closed_form() {
        for lumps in [1, 2, 6, 25, 52, 500] {
            for (last, shift) in [(1.0, 0.0), (0.0, 0.5)] {
                let found = uniform(lumps, last);
                for (index, frequency) in found.frequencies.iter().enumerate() {
                    let angle = (index as f64 + 1.0 - shift) * std::f64::consts::PI / lumps as f64;
                    let expected = 2.0 * lumps as f64 * (0.5 * angle).sin();
                    assert!((frequency / expected - 1.0).abs() < 1e-13, "{lumps} {index}: {frequency} {expected}");
                    let row = &found.shapes[index * lumps..][..lumps];
                    let exact: Vec<f64> = (0..lumps).map(|lump| (angle * (lump as f64 + 0.5)).sin()).collect();
                    let largest = exact.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
                    let apart = row.iter().zip(&exact).map(|(a, b)| (a - b / largest).abs()).fold(0.0, f64::max);
                    assert!(apart < 1e-9, "{lumps} {index}: {apart}");
                }
            }
        }
    }
}
