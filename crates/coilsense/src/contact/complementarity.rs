//! Which of the pairs that touch push, and how hard: a linear complementarity problem, solved directly.
//!
//! Next door: W and its factors (`bonds`), the speeds and accelerations that ask for it (`meet`, `series`).

use super::bonds::Bonds;
use super::chain::Chain;

/// An opening, or a push, this much \[1\] of the largest is none.
const ROUNDING: f64 = 1e-13;

/// So many rounds without progress may pass until one pair at a time changes sides.
const SPARE: usize = 3;

/// A push this many times \[1\] what stops the whole chain is that of a stack between two ends that close on it.
const MOST_PUSH: f64 = 1e2;

/// Rounds per pair after which no set is looked for any more.
const MOST_ROUNDS: usize = 20;

/// What the pairs that touch do to each other.
pub(super) struct Pushes {
    /// Λ_c ≥ 0 of each pair \[N s, or N\]; zero where `pushing` is not set.
    pub amounts: Vec<f64>,
    /// Which of them push.
    pub pushing: Vec<bool>,
    /// How each pair that may push opens under the pushes of all \[m/s, or m/s²\]; zero for those that push.
    pub opening: Vec<f64>,
    /// What an opening may be below zero per push where several stacks are solid side by side.
    gives: f64,
}

/// Finds Λ ≥ 0 with W Λ + q ≥ 0 and Λ (W Λ + q) = 0 over the pairs that `may` push; q is how pairs open without.
///
/// All that are on the wrong side change it at once. Where no point is in more than two pairs W is an M-matrix, so that the set of those that push only grows:
/// Chandrasekaran's method, which ends after at most as many rounds as there are pairs. Seats on a follower push one another apart, so that some may have to
/// leave the set again: there all change while they become fewer, else one alone (Júdice and Pires, *Computers and Operations Research* 21 (1994) 587-596;
/// Murty's way, which ends for every matrix whose principal minors are positive). `None` where a stack is solid between two ends that do not give way, or no
/// set is found.
pub(super) fn pushes(chain: &Chain, may: &[bool], q: &[f64]) -> Option<Pushes> {
    let of_those = || q.iter().zip(may).filter(|(_, may)| **may).map(|(q, _)| q.abs());
    let rounding = ROUNDING * of_those().fold(0.0, f64::max);
    let spare = if chain.shared().is_some() { SPARE } else { usize::MAX };
    let mut pushing: Vec<bool> = may.iter().zip(q).map(|(may, q)| *may && *q < -rounding).collect();
    let (mut fewest, mut left) = (usize::MAX, spare);
    for _ in 0..MOST_ROUNDS * q.len() {
        let found = Pushes::of(chain, pushing.clone(), q)?;
        let largest = found.amounts.iter().fold(0.0_f64, |most, amount| most.max(amount.abs()));
        let is_wrong = |number: &usize| match found.pushing[*number] {
            true => found.amounts[*number] < -ROUNDING * largest,
            false => may[*number] && found.opening[*number] < -rounding.max(found.gives * largest),
        };
        let wrong: Vec<usize> = (0..q.len()).filter(is_wrong).collect();
        let change: &[usize] = if wrong.len() < fewest {
            (fewest, left) = (wrong.len(), spare);
            &wrong
        } else if left > 0 {
            left -= 1;
            &wrong
        } else {
            &wrong[wrong.len() - 1..]
        };
        if change.is_empty() {
            let is_solid = largest > MOST_PUSH * chain.masses().iter().sum::<f64>() * of_those().sum::<f64>();
            return (!is_solid).then_some(found);
        }
        change.iter().for_each(|&number| pushing[number] = !pushing[number]);
    }
    None
}

impl Pushes {
    /// What a set of pairs takes where all of it holds; `None` where a stack is solid.
    fn of(chain: &Chain, pushing: Vec<bool>, q: &[f64]) -> Option<Self> {
        let (pairs, inverse) = (chain.pairs(), chain.inverse_masses());
        let mut amounts: Vec<f64> =
            q.iter().zip(&pushing).map(|(q, pushing)| if *pushing { -q } else { 0.0 }).collect();
        let bonds = Bonds::new(chain, &pushing)?;
        bonds.solve(&mut amounts);
        let mut gained = vec![0.0; chain.points()];
        for (pair, amount) in pairs.iter().zip(&amounts) {
            gained[pair.first] -= amount * inverse[pair.first];
            gained[pair.second] += amount * inverse[pair.second];
        }
        let opens = pairs.iter().zip(q).map(|(pair, q)| q + gained[pair.second] - gained[pair.first]);
        let opening = opens.zip(&pushing).map(|(opens, pushing)| if *pushing { 0.0 } else { opens }).collect();
        Some(Self { amounts, pushing, opening, gives: 4.0 * bonds.gives() })
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::super::chain::Pair;
    use super::*;
    use crate::mount::FarEnd;

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

    /// A follower under a cam with seats for each of `classes` of points of `lumps` masses, by a generator of its own.
    fn on_follower(classes: usize, lumps: usize, next: &mut impl FnMut() -> f64) -> Chain {
        let masses: Vec<f64> = (0..lumps).map(|_| 0.1 + next()).collect();
        let mut pairs = Vec::new();
        for class in 1..=classes {
            let points: Vec<usize> =
                [0].into_iter().chain((class..=lumps).step_by(classes)).chain([lumps + 1]).collect();
            pairs.extend(points.windows(2).map(|ends| Pair { first: ends[0], second: ends[1], gap: 0.0 }));
        }
        Chain::trusted(masses, vec![1.0; lumps + 1], pairs, FarEnd::Position).on_follower(0.1 + 3.0 * next()).unwrap()
    }

    /// W by what a unit push in one pair does to all others, dense.
    fn dense(chain: &Chain) -> DMatrix<f64> {
        let (pairs, inverse) = (chain.pairs(), chain.inverse_masses());
        DMatrix::from_fn(pairs.len(), pairs.len(), |row, column| {
            let (seen, pushed) = (pairs[row], pairs[column]);
            let moved = |point: usize| {
                let sign = f64::from(u8::from(point == pushed.second)) - f64::from(u8::from(point == pushed.first));
                sign * inverse[point]
            };
            moved(seen.second) - moved(seen.first)
        })
    }

    #[test]
    fn seats_on_a_follower_push_as_by_all_sets_tried() {
        let mut state = 7_u64;
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let (mut tried, mut solid, mut left) = (0, 0, 0);
        for (round, (classes, lumps)) in
            [(2, 2), (2, 3), (3, 3), (2, 4), (3, 5)].repeat(60).into_iter().chain([(4, 7); 6]).enumerate()
        {
            let chain = on_follower(classes, lumps, &mut next);
            let (w, size) = (dense(&chain), chain.pairs().len());
            // All that touch, from speeds of the points; or any pairs, by numbers that no points have.
            let whole = round % 2 == 0;
            let may: Vec<bool> = (0..size).map(|_| whole || next() < 0.7).collect();
            let speeds: Vec<f64> = (0..chain.points()).map(|_| (4.0 * next() - 2.0).round()).collect();
            let opens = |pair: &Pair| speeds[pair.second] - speeds[pair.first];
            let mut q: Vec<f64> = chain.pairs().iter().map(opens).collect();
            if !whole {
                q = may.iter().map(|may| if *may { 2.0 * next() - 1.0 } else { 1.0 }).collect();
            }
            // Every set of the pairs that may push, by a solver of its own; one whose pushes push and whose gaps open is an answer. Where stacks stand side
            // by side more than one may be, with one and the same opening.
            let allowed = (0..1_usize << size).filter(|set| (0..size).all(|n| set >> n & 1 == 0 || may[n]));
            let mut answers = allowed.filter_map(|set| {
                let members: Vec<usize> = (0..size).filter(|n| set >> n & 1 == 1).collect();
                let part = w.select_rows(&members).select_columns(&members);
                let right = DVector::from_iterator(members.len(), members.iter().map(|n| -q[*n]));
                let solved = if members.is_empty() { right } else { part.full_piv_lu().solve(&right)? };
                let mut amounts = DVector::zeros(size);
                members.iter().zip(solved.iter()).for_each(|(member, amount)| amounts[*member] = *amount);
                let opening = &w * &amounts + DVector::from_column_slice(&q);
                let holds = amounts.iter().all(|amount| (-1e-9..1e6).contains(amount))
                    && (0..size).all(|n| !may[n] || opening[n] > -1e-9)
                    && members.iter().all(|n| opening[*n].abs() < 1e-9);
                holds.then_some(opening)
            });
            match (answers.next(), pushes(&chain, &may, &q)) {
                (Some(answer), Some(found)) => {
                    tried += 1;
                    let opening = &w * DVector::from_column_slice(&found.amounts) + DVector::from_column_slice(&q);
                    let most = found.amounts.iter().fold(1.0_f64, |most, amount| most.max(*amount));
                    for n in 0..size {
                        assert!((opening[n] - answer[n]).abs() < 1e-7 * most, "{opening} {answer}");
                        assert!(found.amounts[n] > -1e-12 * most && (found.pushing[n] || found.amounts[n] == 0.0));
                    }
                    left += usize::from((0..size).any(|n| may[n] && q[n] < 0.0 && !found.pushing[n]));
                }
                (None, None) => solid += 1,
                (answer, found) => panic!("{q:?} {may:?} {answer:?} {:?}", found.map(|found| found.amounts)),
            }
        }
        // Both kinds occur, and pairs that come together by themselves are driven apart by what others do.
        assert!(tried > 150 && solid > 20 && left > 5, "{tried} {solid} {left}");
    }

    #[test]
    fn stacks_that_are_solid_behind_a_follower_stop_it_together() {
        let mut halves = || 0.5;
        // Three stacks of two masses on end 2: what comes down at 2 m/s is stopped by all of them alike, each mass by what stands below it.
        let chain = on_follower(3, 6, &mut halves);
        let mass = chain.masses()[0];
        let opening: Vec<f64> = chain.pairs().iter().map(|pair| f64::from(u8::from(pair.first == 1)) * -2.0).collect();
        let may: Vec<bool> = chain.pairs().iter().map(|pair| pair.first > 0).collect();
        let found = pushes(&chain, &may, &opening).unwrap();
        assert_eq!(found.pushing, may);
        for amount in &found.amounts[1..] {
            assert!((amount / (2.0 * mass / 3.0) - 1.0).abs() < 1e-6, "{:?}", found.amounts);
        }
        // A cam that goes on pressing it down on them would have to give way itself.
        let mut all = opening.clone();
        all[0] = -1.0;
        assert!(pushes(&chain, &vec![true; all.len()], &all).is_none());
        // One that goes back as fast as it comes leaves it.
        all[0] = 3.0;
        assert!(!pushes(&chain, &vec![true; all.len()], &all).unwrap().pushing[0]);
    }
}
