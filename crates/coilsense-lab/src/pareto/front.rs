//! The front of points that come one after another: what is held is the front so far and as much again.
//!
//! Next door: how points are compared in bulk (`dominance`).

use super::dominance::{Points, covers, front};

/// Fewest points that are held before they are compared in bulk.
const LEAST_HELD: usize = 1 << 14;
/// Points of the front that meet every new point at once.
const GUARDS: usize = 48;

/// The points that no other dominates, of all that were offered.
///
/// A point dominates another where it is as low in every coordinate and lower in one. Equal points stand together. The front is that of
/// the points, whatever their order.
///
/// Source:   definition of `[Kung1975]`; the bulk comparison is its algorithm.
/// Valid:    2³¹ points on the front.
/// Accuracy: exact.
///
/// ```
/// use coilsense_lab::pareto::Front;
/// let mut front = Front::new(2);
/// for (number, point) in [[1.0, 4.0], [2.0, 2.0], [3.0, 3.0], [4.0, 1.0]].iter().enumerate() {
///     front.offer(number as u64, point);
/// }
/// assert_eq!(front.numbers(), [0, 1, 3]);
/// ```
#[derive(Debug, Clone)]
pub struct Front {
    width: usize,
    /// The front so far, then what has come since.
    values: Vec<f64>,
    numbers: Vec<u64>,
    settled: usize,
    guards: Vec<f64>,
}

impl Front {
    /// A front of no point.
    ///
    /// - `coordinates`: of a point, at least 1
    pub fn new(coordinates: usize) -> Self {
        Self { width: coordinates.max(1), values: Vec::new(), numbers: Vec::new(), settled: 0, guards: Vec::new() }
    }

    /// Takes a point, unless one of its coordinates is not finite or is missing; whether it was taken.
    ///
    /// - `number`: by which it is known, such as its row
    /// - `point`: its coordinates, lower is better
    pub fn offer(&mut self, number: u64, point: &[f64]) -> bool {
        if point.len() != self.width || !point.iter().all(|value| value.is_finite()) {
            return false;
        }
        // Most points of a cloud lie well behind its front: one look at a few good points spares the rest.
        let beaten = |guard: &[f64]| covers(guard, point) && guard != point;
        if self.guards.chunks_exact(self.width).any(beaten) {
            return true;
        }
        // −0 and 0 are one number.
        self.values.extend(point.iter().map(|value| value + 0.0));
        self.numbers.push(number);
        if self.numbers.len() >= LEAST_HELD.max(2 * self.settled) {
            self.settle();
        }
        true
    }

    /// Takes what is on another front of as many coordinates.
    pub fn merge(&mut self, other: &Self) {
        for (number, point) in other.numbers.iter().zip(other.values.chunks_exact(other.width)) {
            self.offer(*number, point);
        }
    }

    /// Numbers of the points on the front, ascending.
    pub fn numbers(&mut self) -> Vec<u64> {
        self.settle();
        let mut numbers = self.numbers.clone();
        numbers.sort_unstable();
        numbers
    }

    /// The points on the front by their numbers, ascending: number and coordinates.
    pub fn points(&mut self) -> Vec<(u64, Vec<f64>)> {
        self.settle();
        let points = self.values.chunks_exact(self.width).map(<[f64]>::to_vec);
        let mut points: Vec<(u64, Vec<f64>)> = self.numbers.iter().copied().zip(points).collect();
        points.sort_unstable_by_key(|(number, _)| *number);
        points
    }

    /// Leaves the front only.
    fn settle(&mut self) {
        if self.settled == self.numbers.len() {
            return;
        }
        let kept = front(Points { values: &self.values, width: self.width });
        self.values =
            kept.iter().flat_map(|point| &self.values[*point as usize * self.width..][..self.width]).copied().collect();
        self.numbers = kept.iter().map(|point| self.numbers[*point as usize]).collect();
        self.settled = self.numbers.len();
        self.post_guards();
    }

    /// The points with the lowest sums of shares, which cover most of the others, and some from all over the front.
    fn post_guards(&mut self) {
        let scaled = super::scaled(&self.values, self.width);
        let sum = |point: usize| scaled[point * self.width..][..self.width].iter().sum::<f64>();
        let mut order: Vec<usize> = (0..self.settled).collect();
        let half = GUARDS / 2;
        if order.len() > GUARDS {
            order.select_nth_unstable_by(half, |a, b| sum(*a).total_cmp(&sum(*b)));
            let step = (order.len() / half).max(1);
            let spread = order[half..].iter().copied().step_by(step).take(half);
            order = order[..half].iter().copied().chain(spread).collect();
        }
        self.guards =
            order.into_iter().flat_map(|point| &self.values[point * self.width..][..self.width]).copied().collect();
    }
}
