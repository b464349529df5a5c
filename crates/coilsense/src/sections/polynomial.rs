//! Polynomials of the place along a section, 0 to 1: gap and compliance.
//!
//! Next door: what they are of (`coil`).

/// Of a place from 0 to 1, lowest power first.
pub(super) type Polynomial = [f64; 5];

pub(super) fn at([first, last]: [f64; 2], place: f64) -> f64 {
    first + place * (last - first)
}

pub(super) fn value(p: &Polynomial, place: f64) -> f64 {
    p.iter().rev().fold(0.0, |sum, coefficient| sum * place + coefficient)
}

pub(super) fn rate(p: &Polynomial) -> Polynomial {
    [p[1], 2.0 * p[2], 3.0 * p[3], 4.0 * p[4], 0.0]
}

pub(super) fn difference(p: &Polynomial, q: &Polynomial) -> Polynomial {
    std::array::from_fn(|power| p[power] - q[power])
}

/// The product, which is of no higher power than the fourth.
pub(super) fn product(p: &Polynomial, q: &Polynomial) -> Polynomial {
    std::array::from_fn(|power| (0..=power).map(|first| p[first] * q[power - first]).sum())
}

pub(super) fn integral(p: &Polynomial, from: f64, to: f64) -> f64 {
    let sum = |place: f64| {
        p.iter().enumerate().rev().fold(0.0, |sum, (power, value)| sum * place + value / (power + 1) as f64) * place
    };
    sum(to) - sum(from)
}

/// Where it crosses zero between 0 and 1, ascending: halved between the places at which it turns.
pub(super) fn roots(p: &Polynomial) -> Vec<f64> {
    if p[1..].iter().all(|coefficient| *coefficient == 0.0) {
        return Vec::new();
    }
    let mut turns = roots(&rate(p));
    turns.insert(0, 0.0);
    turns.push(1.0);
    let crosses = |pair: &&[f64]| (value(p, pair[0]) < 0.0) != (value(p, pair[1]) < 0.0);
    let root = |pair: &[f64]| {
        let (mut low, mut high) = (pair[0], pair[1]);
        let begins_below = value(p, low) < 0.0;
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if (value(p, middle) < 0.0) == begins_below { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    turns.windows(2).filter(crosses).map(root).collect()
}
