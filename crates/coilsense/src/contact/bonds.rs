//! W over the pairs that push, factorized: what each takes when all of them hold.
//!
//! Next door: which of the pairs push (`complementarity`), the motion that asks for it order by order (`series`).

use super::chain::{Chain, Pair};

/// Of W, rounding leaves this much \[1\] of a pivot of a stack that cannot give way.
const SOLID: f64 = 1e-12;

/// Where several stacks are solid behind one point, or a stack and its cam, each gives way by this much \[1\] of what the point itself does: none
/// knows how they share what they carry, so they share it evenly.
const GIVES: f64 = 1e-9;

/// Whether a pair shares a point with the next one.
pub(super) fn meet(pairs: &[Pair], pair: usize) -> bool {
    pairs.get(pair + 1).is_some_and(|next| next.first == pairs[pair].second)
}

/// W over the pairs that push, factorized.
///
/// A push in a pair opens it by Λ (1/m_1 + 1/m_2) and closes those that share a point with it. A point is in no more than two pairs, so that W is
/// tridiagonal; but for one that several classes of points meet, a follower of mass M: then W = T + a aᵀ/M, T with the follower immovable, a −1 for its
/// seats and 1 for its cam. Every run of T is eliminated towards the follower, which leaves one equation for its own acceleration.
#[derive(Debug, Clone, Default)]
pub(super) struct Bonds {
    /// Of the pairs that push, in the order of elimination: number, pivot, and the entry that couples it to the one before (zero where none pushes
    /// there).
    rows: Vec<(usize, f64, f64)>,
    shared: Option<Shared>,
}

/// What the runs share that end on one point.
#[derive(Debug, Clone, Default)]
struct Shared {
    /// 1/M of that point \[1/kg\].
    inverse: f64,
    /// The last row of each run, and its sign in a.
    ends: Vec<(usize, f64)>,
    /// Of `ends`, those that take the point along: its cam, or a stack that is solid behind it. One does so exactly, of several each gives.
    rigid: Vec<usize>,
}

impl Bonds {
    /// Of a set of pairs; `None` where a stack is solid between two ends that do not give way, which no run to a shared point is.
    ///
    /// Runs are eliminated from end 2 on, so that each ends at the point that they share.
    pub fn new(chain: &Chain, pushing: &[bool]) -> Option<Self> {
        let (pairs, inverse) = (chain.pairs(), chain.inverse_masses());
        let is_shared = |at: usize| chain.shared() == Some(at);
        let but_shared = |at: usize| if is_shared(at) { 0.0 } else { inverse[at] };
        let mut rows: Vec<(usize, f64, f64)> = Vec::new();
        let mut shared = chain.shared().map(|point| Shared { inverse: inverse[point], ..Shared::default() });
        for (number, pair) in pairs.iter().enumerate().rev().filter(|(number, _)| pushing[*number]) {
            let whole = but_shared(pair.first) + but_shared(pair.second);
            let after = rows.last().filter(|(after, ..)| number + 1 == *after && meet(pairs, number));
            // None with what lies on the other side of the shared point, or of an end.
            let coupled =
                after.map(|(_, pivot, _)| (-but_shared(pair.second), *pivot)).filter(|(coupling, _)| *coupling != 0.0);
            let (coupling, pivot) =
                coupled.map_or((0.0, whole), |(coupling, pivot)| (coupling, whole - coupling * coupling / pivot));
            let is_rigid = pivot <= SOLID * whole;
            match &mut shared {
                Some(shared) if is_shared(pair.first) || is_shared(pair.second) => {
                    shared.rigid.extend(is_rigid.then_some(shared.ends.len()));
                    shared.ends.push((rows.len(), if is_shared(pair.first) { -1.0 } else { 1.0 }));
                }
                _ if is_rigid => return None,
                _ => {}
            }
            rows.push((number, pivot, coupling));
        }
        if let Some(shared) = shared.as_ref().filter(|shared| shared.rigid.len() > 1) {
            shared.rigid.iter().for_each(|end| rows[shared.ends[*end].0].1 = GIVES * shared.inverse);
        }
        Some(Self { rows, shared })
    }

    /// By how much what holds opens all the same, per push \[1/kg\]: above zero where several are solid side by side.
    pub fn gives(&self) -> f64 {
        self.shared.as_ref().filter(|shared| shared.rigid.len() > 1).map_or(0.0, |shared| GIVES * shared.inverse)
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
        let mut ends = self.shared.iter().flat_map(|shared| shared.ends.iter().rev().map(|(end, _)| *end)).peekable();
        if let Some(shared) = &self.shared {
            shared.solve(&self.rows, amounts);
        }
        for index in (0..self.rows.len()).rev() {
            if ends.next_if_eq(&index).is_some() {
                continue;
            }
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

impl Shared {
    /// Λ of the last row of each run, from what elimination has left of −q.
    ///
    /// p_c Λ_c + a_c ÿ = r_c over the runs, with the acceleration of the shared point M ÿ = Σ a_c Λ_c.
    fn solve(&self, rows: &[(usize, f64, f64)], amounts: &mut [f64]) {
        let of = |end: usize| (rows[self.ends[end].0].0, rows[self.ends[end].0].1, self.ends[end].1);
        let exact = if let [one] = self.rigid[..] { Some(one) } else { None };
        let others = || (0..self.ends.len()).filter(|end| Some(*end) != exact).map(of);
        let goes_along = match exact.map(of) {
            Some((number, _, sign)) => sign * amounts[number],
            None => {
                let (mut pushed, mut held) = (0.0, 1.0);
                for (number, pivot, sign) in others() {
                    pushed += self.inverse * sign * amounts[number] / pivot;
                    held += self.inverse / pivot;
                }
                pushed / held
            }
        };
        let mut left = goes_along / self.inverse;
        for (number, pivot, sign) in others() {
            amounts[number] = (amounts[number] - sign * goes_along) / pivot;
            left -= sign * amounts[number];
        }
        // Of one that is rigid all that is left; of several, which have theirs, what rounding has left of it.
        for (number, _, sign) in self.rigid.iter().map(|end| of(*end)) {
            let has = if exact.is_some() { 0.0 } else { amounts[number] };
            amounts[number] = has + sign * left / self.rigid.len() as f64;
        }
    }
}
