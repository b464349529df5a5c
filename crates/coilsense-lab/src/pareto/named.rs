//! The points of a front that one names first: the best in each respect, and the knee between them.
//!
//! Next door: the front (`front`).

/// Coordinates as shares of their range over the points: 0 for the best, 1 for the worst; 0 where all are the same.
///
/// - `values`: shape (points × `width`), lower is better; `width`: coordinates of a point
pub fn scaled(values: &[f64], width: usize) -> Vec<f64> {
    let width = width.max(1);
    let at = |coordinate: usize| values.iter().skip(coordinate).step_by(width).copied();
    let ranges: Vec<[f64; 2]> = (0..width)
        .map(|coordinate| {
            let least = at(coordinate).fold(f64::INFINITY, f64::min);
            [least, at(coordinate).fold(f64::NEG_INFINITY, f64::max)]
        })
        .collect();
    let share = |(value, [least, most]): (&f64, &[f64; 2])| {
        // Halves, since the range of two finite numbers may not be finite.
        let range = 0.5 * most - 0.5 * least;
        if range > 0.0 { (0.5 * value - 0.5 * least) / range } else { 0.0 }
    };
    values.iter().zip(ranges.iter().cycle()).map(share).collect()
}

/// Place of the best point in each coordinate; of several, that with the least sum of shares.
///
/// - `values`, `width`: as for [`scaled`]
pub fn extremes(values: &[f64], width: usize) -> Vec<usize> {
    let sums = sums(values, width);
    let at = |coordinate: usize, point: usize| values[point * width + coordinate];
    let best = |coordinate: usize| {
        let order = |a: &usize, b: &usize| {
            at(coordinate, *a).total_cmp(&at(coordinate, *b)).then(sums[*a].total_cmp(&sums[*b])).then(a.cmp(b))
        };
        (0..sums.len()).min_by(order)
    };
    (0..width).filter_map(best).collect()
}

/// Place of the knee: where giving up a little of one thing no longer gains much of another.
///
/// The point with the least sum of shares of the front's ranges; of two objectives that is the one farthest from the line between the
/// two extremes.
///
/// - `values`, `width`: as for [`scaled`]
///
/// Source:   `[Das1999]`: the point of the front farthest from the hyperplane through its extremes.
/// Valid:    more than two objectives: the hyperplane is that of the shares, Σ = 1, since extremes of a front need not span one.
pub fn knee(values: &[f64], width: usize) -> Option<usize> {
    let sums = sums(values, width);
    (0..sums.len()).min_by(|a, b| sums[*a].total_cmp(&sums[*b]).then(a.cmp(b)))
}

fn sums(values: &[f64], width: usize) -> Vec<f64> {
    scaled(values, width).chunks_exact(width.max(1)).map(|shares| shares.iter().sum()).collect()
}
