//! The points of a set that no other dominates, in less than the square of their number.
//!
//! Points are compared by where they stand, lower is better. Next door: points that come in pieces (`front`).

use std::cmp::Ordering;

/// Below this many comparisons, each is made.
const FEW: usize = 1024;

/// Points of equally many finite coordinates.
#[derive(Clone, Copy)]
pub(super) struct Points<'a> {
    /// Coordinates of all points, point by point.
    pub values: &'a [f64],
    /// Coordinates of a point, at least 1.
    pub width: usize,
}

impl<'a> Points<'a> {
    fn of(self, point: u32) -> &'a [f64] {
        &self.values[point as usize * self.width..][..self.width]
    }

    fn compare(self, a: u32, b: u32) -> Ordering {
        let pairs = self.of(a).iter().zip(self.of(b));
        pairs.map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    }
}

/// Whether `a` is as good as `b` in every coordinate.
pub(super) fn covers(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a <= b)
}

/// Numbers of the points that no other dominates, in the order of their coordinates; equal points stand or fall together.
///
/// Points in the order of their coordinates are halved: the first half's front stands, and what is left of the second half's is what no
/// point of the first covers in the coordinates after the first.
///
/// Source:   `[Kung1975]`, section 5; O(n (log n)^(d−2)) for d of four or more coordinates, O(n log n) for two and three.
/// Valid:    finite coordinates, fewer than 2³² points.
/// Differs:  equal points are looked at once; points that share a coordinate's median are set apart, so that grids end too.
pub(super) fn front(points: Points<'_>) -> Vec<u32> {
    let mut order: Vec<u32> = (0..(points.values.len() / points.width) as u32).collect();
    order.sort_unstable_by(|a, b| points.compare(*a, *b).then(a.cmp(b)));
    let mut distinct = order.clone();
    distinct.dedup_by(|b, a| points.compare(*a, *b).is_eq());
    let kept = of_sorted(points, &distinct);
    let mut kept = kept.into_iter().peekable();
    let mut all = Vec::new();
    for point in order {
        while kept.peek().is_some_and(|kept| points.compare(*kept, point).is_lt()) {
            kept.next();
        }
        if kept.peek().is_some_and(|kept| points.compare(*kept, point).is_eq()) {
            all.push(point);
        }
    }
    all
}

/// The front of distinct points in the order of their coordinates, none of which is dominated by a later one.
fn of_sorted(points: Points<'_>, sorted: &[u32]) -> Vec<u32> {
    if sorted.len() * sorted.len() <= FEW || points.width <= 2 {
        return match points.width {
            1 => sorted.iter().take(1).copied().collect(),
            2 => stairs(points, sorted),
            _ => one_by_one(points, sorted),
        };
    }
    let (first, second) = sorted.split_at(sorted.len() / 2);
    let mut front = of_sorted(points, first);
    let mut rest = of_sorted(points, second);
    remove_covered(points, 1, front.clone(), &mut rest);
    front.extend(rest);
    front
}

/// Two coordinates: as the first one grows, the second must fall.
fn stairs(points: Points<'_>, sorted: &[u32]) -> Vec<u32> {
    let mut least = f64::INFINITY;
    let lower = |point: &u32| {
        let second = points.of(*point)[1];
        let lower = second < least;
        least = least.min(second);
        lower
    };
    sorted.iter().copied().filter(lower).collect()
}

fn one_by_one(points: Points<'_>, sorted: &[u32]) -> Vec<u32> {
    let mut front: Vec<u32> = Vec::new();
    for point in sorted {
        if !front.iter().any(|better| covers(points.of(*better), points.of(*point))) {
            front.push(*point);
        }
    }
    front
}

/// Removes from `judged` what a point of `by` covers in the coordinates from `from` on; keeps the order of the others.
fn remove_covered(points: Points<'_>, from: usize, by: Vec<u32>, judged: &mut Vec<u32>) {
    if by.is_empty() || judged.is_empty() {
        return;
    }
    let rest = |point: u32| &points.of(point)[from..];
    if points.width - from == 1 {
        let least = by.iter().map(|point| rest(*point)[0]).fold(f64::INFINITY, f64::min);
        judged.retain(|point| rest(*point)[0] < least);
    } else if points.width - from == 2 {
        remove_above_stairs(points, from, by, judged);
    } else if by.len() * judged.len() <= FEW {
        judged.retain(|point| !by.iter().any(|better| covers(rest(*better), rest(*point))));
    } else {
        halve(points, from, by, judged);
    }
}

/// About the median m of a coordinate: what lies below it can only be covered from below, what lies at or above it also, in the other
/// coordinates, by all that lies at or below.
fn halve(points: Points<'_>, from: usize, by: Vec<u32>, judged: &mut Vec<u32>) {
    let at = |point: &u32| points.of(*point)[from];
    let mut values: Vec<f64> = by.iter().chain(judged.iter()).map(at).collect();
    let middle = values.len() / 2;
    let median = *values.select_nth_unstable_by(middle, f64::total_cmp).1;
    drop(values);
    let side = |side: fn(&f64, &f64) -> bool| by.iter().copied().filter(move |point| side(&at(point), &median));
    let (below, above): (Vec<u32>, Vec<u32>) = (side(f64::lt).collect(), side(f64::gt).collect());
    let up_to: Vec<u32> = side(f64::le).collect();
    drop(by);
    let mut judged_below: Vec<u32> = judged.iter().copied().filter(|point| at(point) < median).collect();
    let mut judged_at: Vec<u32> = judged.iter().copied().filter(|point| at(point) >= median).collect();
    remove_covered(points, from, below, &mut judged_below);
    remove_covered(points, from + 1, up_to, &mut judged_at);
    let mut judged_above: Vec<u32> = judged_at.iter().copied().filter(|point| at(point) > median).collect();
    remove_covered(points, from, above, &mut judged_above);
    // All three are parts of `judged` in its order: what is in none of them has been covered.
    let mut left = [judged_below, judged_above].map(|part| part.into_iter().peekable());
    let mut left_at = judged_at.into_iter().filter(|point| at(point) == median).peekable();
    judged.retain(|point| {
        left.iter_mut().any(|part| part.next_if_eq(point).is_some()) || left_at.next_if_eq(point).is_some()
    });
}

/// Two coordinates left: `by` as stairs, over which `judged` are held in the order of the first of the two.
fn remove_above_stairs(points: Points<'_>, from: usize, mut by: Vec<u32>, judged: &mut Vec<u32>) {
    let pair = |point: u32| [points.of(point)[from], points.of(point)[from + 1]];
    by.sort_unstable_by(|a, b| pair(*a)[0].total_cmp(&pair(*b)[0]));
    let mut least = f64::INFINITY;
    let stairs: Vec<[f64; 2]> = by
        .into_iter()
        .map(|point| {
            let [across, up] = pair(point);
            least = least.min(up);
            [across, least]
        })
        .collect();
    judged.retain(|point| {
        let [across, up] = pair(*point);
        let before = stairs.partition_point(|step| step[0] <= across);
        before == 0 || stairs[before - 1][1] > up
    });
}
