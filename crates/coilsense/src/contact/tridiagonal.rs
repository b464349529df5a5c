//! Which of the pairs that touch push, and how hard: a linear complementarity problem, solved directly.
//!
//! Next door: the speeds and accelerations that ask for it (`meet`, `series`).

use super::chain::{Chain, Pair};

/// Of W, rounding leaves this much \[1\] of a pivot of a stack that cannot give way.
const SOLID: f64 = 1e-12;

/// An opening this much \[1\] of the largest is none.
const ROUNDING: f64 = 1e-13;

/// What the pairs that touch do to each other.
pub(super) struct Pushes {
    /// Λ_c ≥ 0 of each pair \[N s, or N\]; zero where `pushing` is not set.
    pub amounts: Vec<f64>,
    /// Which of them push.
    pub pushing: Vec<bool>,
    /// How each pair that may push opens under the pushes of all \[m/s, or m/s²\]; zero for those that push.
    pub opening: Vec<f64>,
}

/// Finds Λ ≥ 0 with W Λ + q ≥ 0 and Λ (W Λ + q) = 0 over the pairs that `may` push; q is how pairs open without.
///
/// W is tridiagonal, since a point is in no more than two pairs: a push in a pair opens it by Λ (1/m_1 + 1/m_2) and closes those that share a
/// point with it. It is an M-matrix, so the set of those that push only grows: Chandrasekaran's method ends after at most as many rounds as
/// there are pairs. `None` where a stack is solid between two ends that do not give way.
pub(super) fn pushes(chain: &Chain, may: &[bool], q: &[f64]) -> Option<Pushes> {
    let largest = q.iter().zip(may).filter(|(_, may)| **may).fold(0.0_f64, |most, (q, _)| most.max(q.abs()));
    let rounding = ROUNDING * largest;
    let (pairs, inverse) = (chain.pairs(), chain.inverse_masses());
    let mut found = Pushes { amounts: vec![0.0; q.len()], pushing: vec![false; q.len()], opening: q.to_vec() };
    loop {
        let mut grown = false;
        for ((may, pushing), opening) in may.iter().zip(&mut found.pushing).zip(&found.opening) {
            if *may && !*pushing && *opening < -rounding {
                (*pushing, grown) = (true, true);
            }
        }
        if !grown {
            return Some(found);
        }
        let runs = Runs::new(chain, &found.pushing)?;
        found
            .amounts
            .iter_mut()
            .zip(q)
            .zip(&found.pushing)
            .for_each(|((amount, q), pushing)| *amount = if *pushing { -q } else { 0.0 });
        runs.solve(&mut found.amounts);
        for pair in 0..q.len() {
            let beside = |at: Option<usize>, shared: usize| match at.and_then(|at| found.amounts.get(at)) {
                Some(amount) => amount * inverse[shared],
                None => 0.0,
            };
            let before = pair.checked_sub(1).filter(|before| meet(pairs, *before));
            let after = Some(pair + 1).filter(|_| meet(pairs, pair));
            found.opening[pair] = if found.pushing[pair] {
                0.0
            } else {
                q[pair] - beside(before, pairs[pair].first) - beside(after, pairs[pair].second)
            };
        }
    }
}

/// Whether a pair shares a point with the next one.
pub(super) fn meet(pairs: &[Pair], pair: usize) -> bool {
    pairs.get(pair + 1).is_some_and(|next| next.first == pairs[pair].second)
}

/// W over the pairs that push, factorized.
#[derive(Debug, Clone, Default)]
pub(super) struct Runs {
    /// Of the pairs that push, in order: number, pivot, and the entry that couples it to the one before (zero where none pushes there).
    rows: Vec<(usize, f64, f64)>,
}

impl Runs {
    /// Of a set of pairs; `None` where a stack is solid.
    pub fn new(chain: &Chain, pushing: &[bool]) -> Option<Self> {
        let (pairs, inverse) = (chain.pairs(), chain.inverse_masses());
        let mut rows: Vec<(usize, f64, f64)> = Vec::new();
        for (number, pair) in pairs.iter().enumerate().filter(|(number, _)| pushing[*number]) {
            let whole = inverse[pair.first] + inverse[pair.second];
            let before = rows.last().filter(|(before, ..)| before + 1 == number && meet(pairs, *before));
            let (pivot, coupling) = match before {
                Some((_, pivot, _)) => {
                    (whole - inverse[pair.first] * inverse[pair.first] / pivot, -inverse[pair.first])
                }
                None => (whole, 0.0),
            };
            if pivot <= SOLID * whole {
                return None;
            }
            rows.push((number, pivot, coupling));
        }
        Some(Self { rows })
    }

    /// Whether none pushes.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Λ from −q, in place, shape `pairs`.
    pub fn solve(&self, amounts: &mut [f64]) {
        for index in 1..self.rows.len() {
            let ((before, pivot, _), (number, _, coupling)) = (self.rows[index - 1], self.rows[index]);
            if coupling != 0.0 {
                amounts[number] -= coupling / pivot * amounts[before];
            }
        }
        for index in (0..self.rows.len()).rev() {
            let (number, pivot, _) = self.rows[index];
            let after = match self.rows.get(index + 1) {
                Some((after, _, coupling)) => coupling * amounts[*after],
                None => 0.0,
            };
            amounts[number] = (amounts[number] - after) / pivot;
        }
    }

    /// Numbers of the pairs.
    pub fn numbers(&self) -> impl Iterator<Item = usize> {
        self.rows.iter().map(|row| row.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_that_meets_a_resting_pair_pushes_through_both_contacts() {
        let chain = Chain::new(vec![1.0; 3], vec![1.0; 4], vec![f64::INFINITY, 0.0, 0.0, f64::INFINITY]).unwrap();
        // Mass 1 at 3 m/s meets mass 2, which touches mass 3: all go on at 1 m/s.
        let found = pushes(&chain, &[true, true], &[-3.0, 0.0]).unwrap();
        assert_eq!(found.pushing, [true, true]);
        assert!((found.amounts[0] - 2.0).abs() < 1e-15 && (found.amounts[1] - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_stack_between_two_ends_that_do_not_give_way_is_solid() {
        let chain = Chain::new(vec![1.0; 2], vec![1.0; 3], vec![0.0; 3]).unwrap();
        assert!(pushes(&chain, &[true; 3], &[-1.0, -1.0, -1.0]).is_none());
        assert!(pushes(&chain, &[true, true, false], &[-1.0, -1.0, 0.0]).is_some());
    }
}
