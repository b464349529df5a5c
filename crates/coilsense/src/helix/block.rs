//! Symmetric stiffness of a piece of wire between its two ends, and how pieces join.
//!
//! Freedoms 0 to 5 are those of the near end, 6 to 11 those of the far end, each in the section's own axes: so equal pieces of a helix
//! have equal stiffnesses. Next door: the shortest piece (`segment`), the whole wire (`chain`).

use num_complex::{Complex, ComplexFloat};

/// A square matrix on the stack.
pub(super) type Square<T, const N: usize> = [[T; N]; N];

/// Real without damping, complex with it.
pub(super) trait Number: ComplexFloat<Real = f64> {
    /// A real value as such a number.
    fn real(value: f64) -> Self;
}

impl Number for f64 {
    fn real(value: f64) -> Self {
        value
    }
}

impl Number for Complex<f64> {
    fn real(value: f64) -> Self {
        Self::new(value, 0.0)
    }
}

/// A piece of wire at one frequency.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<T> {
    /// The stiffness.
    pub stiffness: Square<T, 12>,
    /// Modes of the piece below this frequency with both ends held (Wittrick and Williams' J_0).
    pub below: usize,
}

impl<T: Number> Block<T> {
    /// This piece and then another one.
    pub fn then(&self, other: &Self) -> Self {
        let mut all = self.assembled(other);
        let below = self.below + other.below + eliminate(&mut all, &MIDDLE);
        let stiffness = std::array::from_fn(|i| std::array::from_fn(|j| all[i][j]));
        Self { stiffness, below }
    }

    /// What the middle of both does per freedom of the outer ends, all else free of force: 6 x 12.
    pub fn follows(&self, other: &Self) -> [[T; 12]; 6] {
        let mut middle: [[T; 18]; 6] = std::array::from_fn(|i| {
            std::array::from_fn(|j| match j {
                0..6 => self.stiffness[6 + i][6 + j] + other.stiffness[i][j],
                6..12 => -self.stiffness[6 + i][j - 6],
                _ => -other.stiffness[i][j - 6],
            })
        });
        reduce(&mut middle);
        std::array::from_fn(|i| std::array::from_fn(|j| middle[i][6 + j]))
    }

    /// Outer ends as in a block, the middle last.
    fn assembled(&self, other: &Self) -> Square<T, 18> {
        let (one, two) = (&self.stiffness, &other.stiffness);
        let mut all = [[T::zero(); 18]; 18];
        for i in 0..6 {
            for j in 0..6 {
                all[i][j] = one[i][j];
                all[6 + i][6 + j] = two[6 + i][6 + j];
                all[12 + i][12 + j] = one[6 + i][6 + j] + two[i][j];
                (all[i][12 + j], all[12 + i][j]) = (one[i][6 + j], one[6 + i][j]);
                (all[6 + i][12 + j], all[12 + i][6 + j]) = (two[6 + i][j], two[i][6 + j]);
            }
        }
        all
    }
}

/// The freedoms between two pieces.
const MIDDLE: [usize; 6] = [12, 13, 14, 15, 16, 17];

/// Eliminates freedoms from a symmetric matrix, leaving their effect on the others, and returns how many of their pivots are below zero.
///
/// Pivots are taken by size from the diagonal: their signs are those of the eigenvalues of the eliminated block (Sylvester).
pub(super) fn eliminate<T: Number, const N: usize>(matrix: &mut Square<T, N>, freedoms: &[usize]) -> usize {
    let mut gone = [false; N];
    let mut negative = 0;
    for _ in freedoms {
        let size = |k: &usize| matrix[*k][*k].abs();
        let left = freedoms.iter().copied().filter(|k| !gone[*k]);
        let Some(pivot) = left.max_by(|one, other| size(one).total_cmp(&size(other))) else { break };
        gone[pivot] = true;
        let row = matrix[pivot];
        // A pivot of exactly zero is a mode at exactly this frequency: it counts as not below it.
        let value = if size(&pivot) == 0.0 { T::real(f64::MIN_POSITIVE.sqrt()) } else { row[pivot] };
        negative += usize::from(value.re() < 0.0);
        let inverse = value.recip();
        for i in 0..N {
            if gone[i] || row[i] == T::zero() {
                continue;
            }
            let factor = row[i] * inverse;
            for j in 0..N {
                matrix[i][j] = matrix[i][j] - factor * row[j];
            }
        }
    }
    negative
}

/// Brings the first columns of a system to the unit matrix, by elimination with pivots from each column; what stands right of them becomes
/// the solution.
pub(super) fn reduce<T: Number, const M: usize, const N: usize>(system: &mut [[T; N]; M]) {
    for column in 0..M {
        let best = (column..M).max_by(|i, j| system[*i][column].abs().total_cmp(&system[*j][column].abs()));
        system.swap(column, best.unwrap_or(column));
        let inverse = system[column][column].recip();
        for value in &mut system[column] {
            *value = *value * inverse;
        }
        let row = system[column];
        for (i, other) in system.iter_mut().enumerate() {
            if i != column {
                let factor = other[column];
                for j in column..N {
                    other[j] = other[j] - factor * row[j];
                }
            }
        }
    }
}
