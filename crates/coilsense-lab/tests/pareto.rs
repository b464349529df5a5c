//! The front against its definition, whatever the order, the ties and the size; and its time on a million points.

use coilsense_lab::pareto::{Front, extremes, knee};
use proptest::prelude::*;
use rand::RngExt;
use rand::seq::SliceRandom;
use rand_pcg::Pcg64;

/// By definition: no other point is as low everywhere and lower somewhere.
fn by_definition(points: &[Vec<f64>]) -> Vec<u64> {
    let dominates = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| a <= b) && a.iter().zip(b).any(|(a, b)| a < b);
    let stands = |point: &Vec<f64>| !points.iter().any(|other| dominates(other, point));
    points.iter().enumerate().filter(|(_, point)| stands(point)).map(|(number, _)| number as u64).collect()
}

fn front(points: &[Vec<f64>]) -> Vec<u64> {
    let mut front = Front::new(points.first().map_or(1, Vec::len));
    for (number, point) in points.iter().enumerate() {
        assert!(front.offer(number as u64, point));
    }
    front.numbers()
}

/// Points on a coarse grid, where many share a coordinate and some are equal, or anywhere.
fn clouds() -> impl Strategy<Value = Vec<Vec<f64>>> {
    (1usize..=5, any::<bool>()).prop_flat_map(|(width, grid)| {
        let coordinate = if grid { (-3i8..4).prop_map(f64::from).boxed() } else { (-1e3..1e3).boxed() };
        prop::collection::vec(prop::collection::vec(coordinate, width), 0..400)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn a_front_is_that_of_the_definition(points in clouds()) {
        prop_assert_eq!(front(&points), by_definition(&points));
    }

    #[test]
    fn the_order_of_points_does_not_matter(points in clouds(), seed: u64) {
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.shuffle(&mut Pcg64::new(u128::from(seed), 0));
        let mut shuffled = Front::new(points.first().map_or(1, Vec::len));
        for number in order {
            shuffled.offer(number as u64, &points[number]);
        }
        prop_assert_eq!(shuffled.numbers(), front(&points));
    }

    #[test]
    fn the_front_of_fronts_is_the_front(points in clouds(), pieces in 1usize..9) {
        let width = points.first().map_or(1, Vec::len);
        let mut whole = Front::new(width);
        for (piece, part) in points.chunks(points.len().div_ceil(pieces).max(1)).enumerate() {
            let mut one = Front::new(width);
            for (place, point) in part.iter().enumerate() {
                one.offer((piece * points.len().div_ceil(pieces) + place) as u64, point);
            }
            whole.merge(&one);
        }
        prop_assert_eq!(whole.numbers(), front(&points));
    }
}

/// Points on the part of a sphere that faces the origin: all of them are on the front. Behind them, a cloud twice as far out.
fn sphere(width: usize, count: usize, behind: usize) -> Vec<Vec<f64>> {
    let mut draws = Pcg64::new(width as u128, 5);
    let mut direction = || {
        let point: Vec<f64> = (0..width).map(|_| draws.random_range(0.05..1.0)).collect();
        let length = point.iter().map(|x: &f64| x * x).sum::<f64>().sqrt();
        point.into_iter().map(|x| x / length).collect::<Vec<f64>>()
    };
    let on: Vec<Vec<f64>> = (0..count).map(|_| direction().into_iter().map(|x| 2.0 - x).collect()).collect();
    let off = (0..behind).map(|number| on[number % count].iter().map(|x| x + 1e-6 * (1.0 + number as f64)).collect());
    let off: Vec<Vec<f64>> = off.collect();
    on.into_iter().chain(off).collect()
}

#[test]
fn a_sphere_is_its_own_front_and_hides_what_is_behind() {
    for width in 2..=5 {
        let points = sphere(width, 3000, 30_000);
        assert_eq!(front(&points), (0..3000).collect::<Vec<u64>>(), "{width}");
    }
}

#[test]
fn what_is_not_a_number_is_not_taken_and_infinity_neither() {
    let mut front = Front::new(2);
    assert!(!front.offer(0, &[f64::NAN, 0.0]) && !front.offer(1, &[f64::NEG_INFINITY, 0.0]) && !front.offer(2, &[0.0]));
    assert!(front.numbers().is_empty());
    assert!(front.offer(3, &[-0.0, 1.0]) && front.offer(4, &[0.0, 1.0]));
    assert_eq!(front.numbers(), [3, 4]);
}

#[test]
fn the_knee_of_a_bent_front_is_its_bend_and_its_ends_are_the_extremes() {
    // Two straight arms of slopes −9 and −1/9 that meet at (1, 1), in units a thousand apart.
    let arm = |t: f64| if t < 1.0 { [t, 10.0 - 9.0 * t] } else { [t, 1.0 - (t - 1.0) / 9.0] };
    let points: Vec<f64> = (0..=100)
        .flat_map(|step| arm(0.1 * f64::from(step)))
        .enumerate()
        .map(|(place, value)| if place % 2 == 0 { value } else { 1e3 * value })
        .collect();
    assert_eq!(knee(&points, 2), Some(10));
    assert_eq!(extremes(&points, 2), [0, 100]);
    assert_eq!(knee(&[], 2), None);
    assert!(extremes(&[], 2).is_empty());
}

#[test]
#[ignore = "a benchmark; run with cargo test --release -p coilsense-lab --test pareto -- --ignored --nocapture"]
fn a_million_points() {
    for width in 2..=5 {
        let mut draws = Pcg64::new(1, 1);
        let cloud: Vec<Vec<f64>> = (0..1_000_000).map(|_| (0..width).map(|_| draws.random()).collect()).collect();
        let started = std::time::Instant::now();
        let found = front(&cloud).len();
        println!("{width} objectives, a cube: {:.2} s, {found} on the front", started.elapsed().as_secs_f64());
        let cloud = sphere(width, 1_000_000, 0);
        let started = std::time::Instant::now();
        let found = front(&cloud).len();
        println!("{width} objectives, a sphere: {:.2} s, {found} on the front", started.elapsed().as_secs_f64());
    }
}
