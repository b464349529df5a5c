//! Where a polynomial first falls below zero: how contacts are found without stepping over one.
//!
//! Next door: the polynomials (`series`), what happens at their roots (`event`).

/// Highest power of time in a step.
pub(super) const ORDER: usize = 26;

/// A polynomial over one step, τ from 0 to 1; lowest power first.
pub(super) type Polynomial = [f64; ORDER + 1];

/// 1/C(ORDER, k).
const SHARES: Polynomial = shares();

const fn shares() -> Polynomial {
    let mut shares = [1.0; ORDER + 1];
    let mut k = 1;
    while k <= ORDER {
        shares[k] = shares[k - 1] * k as f64 / (ORDER + 1 - k) as f64;
        k += 1;
    }
    shares
}

/// p(τ).
pub(super) fn value(p: &Polynomial, tau: f64) -> f64 {
    p.iter().rev().fold(0.0, |sum, coefficient| sum * tau + coefficient)
}

/// Four polynomials, power by power: worked out together, they take the time of one.
pub(super) type Four = [[f64; 4]; ORDER + 1];

/// Several polynomials side by side.
pub(super) fn side_by_side(each: [&Polynomial; 4]) -> Four {
    let mut rows = [[0.0; 4]; ORDER + 1];
    for (power, row) in rows.iter_mut().enumerate() {
        *row = [each[0][power], each[1][power], each[2][power], each[3][power]];
    }
    rows
}

/// All of them at τ: even and odd powers apart, for neither then waits for the other.
pub(super) fn values(each: &Four, tau: f64) -> [f64; 4] {
    let square = tau * tau;
    let (mut even, mut odd) = (each[ORDER], [0.0; 4]);
    for pair in each[..ORDER].as_chunks::<2>().0.iter().rev() {
        for lane in 0..4 {
            even[lane] = even[lane] * square + pair[0][lane];
            odd[lane] = odd[lane] * square + pair[1][lane];
        }
    }
    for (even, odd) in even.iter_mut().zip(&odd) {
        *even += odd * tau;
    }
    even
}

/// An even order has one coefficient more of even powers than of odd ones.
const _: () = assert!(ORDER.is_multiple_of(2));

/// 1/(n + 1).
const PARTS: [f64; 2 * ORDER + 1] = parts();

const fn parts() -> [f64; 2 * ORDER + 1] {
    let mut parts = [1.0; 2 * ORDER + 1];
    let mut n = 1;
    while n < parts.len() {
        parts[n] = 1.0 / (n + 1) as f64;
        n += 1;
    }
    parts
}

/// ∫ p q dτ from zero: Σ p_i q_j τ^(i + j + 1)/(i + j + 1).
pub(super) fn integral_of_product(p: &Polynomial, q: &Polynomial, tau: f64) -> f64 {
    let Some(last) = q.iter().rposition(|coefficient| *coefficient != 0.0) else { return 0.0 };
    let mut scaled = *p;
    let mut power = 1.0;
    for coefficient in &mut scaled {
        *coefficient *= power;
        power *= tau;
    }
    let mut sum = 0.0;
    for order in (0..=last).rev() {
        let with_it: f64 = dot(&scaled, &PARTS[order..]);
        sum = sum * tau + q[order] * with_it;
    }
    sum * tau
}

/// Σ a b over the first, in four sums side by side.
fn dot(a: &Polynomial, b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (a, a_rest) = a.as_chunks::<4>();
    let (b, b_rest) = b[..ORDER + 1].as_chunks::<4>();
    for (a, b) in a.iter().zip(b) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// p(τ) and dp/dτ.
fn with_rate(p: &Polynomial, tau: f64) -> (f64, f64) {
    p.iter().rev().fold((0.0, 0.0), |(sum, slope), coefficient| (sum * tau + coefficient, slope * tau + sum))
}

/// The first τ in \[0, `until`\] at which p falls through −`margin`, moved back to where it fell through zero just before; `None` where it does
/// not.
///
/// Bernstein's coefficients bound a polynomial from below, and their signs count its roots from above: halved until they say which.
pub(super) fn first_fall(p: &Polynomial, margin: f64, until: f64) -> Option<f64> {
    // What is left if all that falls falls at once.
    if p[0] + falling(p) > -margin {
        return None;
    }
    let mut raised = *p;
    raised[0] += margin;
    let mut scaled = raised;
    let mut power = 1.0;
    for coefficient in &mut scaled {
        *coefficient *= power;
        power *= until;
    }
    let bracket = first_bracket(&bernstein(scaled), 0.0, until, 0)?;
    let fall = root(&raised, bracket);
    Some(back_to_zero(p, margin, fall))
}

/// The sum of all that is below zero but for the first.
fn falling(p: &Polynomial) -> f64 {
    let (chunks, rest) = p[1..].as_chunks::<2>();
    debug_assert!(rest.is_empty(), "an even order");
    let [even, odd] =
        chunks.iter().fold([0.0; 2], |sums: [f64; 2], pair| [sums[0] + pair[0].min(0.0), sums[1] + pair[1].min(0.0)]);
    even + odd
}

/// Power form to Bernstein's, on \[0, 1\].
fn bernstein(mut p: Polynomial) -> Polynomial {
    for (coefficient, share) in p.iter_mut().zip(&SHARES) {
        *coefficient *= share;
    }
    for round in 1..=ORDER {
        let before = p;
        for (value, before) in p[round..].iter_mut().zip(&before[round - 1..]) {
            *value += before;
        }
    }
    p
}

/// Most halvings: an interval is then as short as the rounding of its place.
const MOST_HALVINGS: usize = 48;

/// An interval that holds the first root downwards.
fn first_bracket(b: &Polynomial, from: f64, to: f64, halvings: usize) -> Option<[f64; 2]> {
    if b[0] < 0.0 {
        return Some([from, from]);
    }
    if b.iter().all(|coefficient| *coefficient >= 0.0) {
        return None;
    }
    let changes = b.windows(2).filter(|pair| (pair[0] < 0.0) != (pair[1] < 0.0)).count();
    if changes == 1 {
        return Some([from, to]);
    }
    if halvings == MOST_HALVINGS {
        return Some([from, from]);
    }
    let (mut left, mut right) = (*b, *b);
    for (round, value) in left.iter_mut().enumerate().skip(1) {
        for index in 0..=ORDER - round {
            right[index] = 0.5 * (right[index] + right[index + 1]);
        }
        *value = right[0];
    }
    let middle = 0.5 * (from + to);
    first_bracket(&left, from, middle, halvings + 1).or_else(|| first_bracket(&right, middle, to, halvings + 1))
}

/// The only root in a bracket, from above zero to below: Newton's steps as long as they stay inside, else half of it.
fn root(p: &Polynomial, [mut above, mut below]: [f64; 2]) -> f64 {
    let mut tau = 0.5 * (above + below);
    for _ in 0..100 {
        let (here, slope) = with_rate(p, tau);
        if here >= 0.0 {
            above = tau;
        } else {
            below = tau;
        }
        let newton = tau - here / slope;
        let next = if newton > above && newton < below { newton } else { 0.5 * (above + below) };
        if (next - tau).abs() <= 1e-16 || next <= above || next >= below {
            return next;
        }
        tau = next;
    }
    tau
}

/// From where p falls through −`margin` to where it fell through zero, if it did so on a straight way.
fn back_to_zero(p: &Polynomial, margin: f64, fall: f64) -> f64 {
    let (_, slope) = with_rate(p, fall);
    let before = fall + 2.0 * margin / slope;
    if slope < 0.0 && before >= 0.0 && value(p, before) > 0.0 { root(p, [before, fall]) } else { fall }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(coefficients: &[f64]) -> Polynomial {
        let mut p = [0.0; ORDER + 1];
        p[..coefficients.len()].copy_from_slice(coefficients);
        p
    }

    #[test]
    fn the_first_of_several_falls_is_found() {
        // (τ − 0.3)(τ − 0.4)(τ − 0.9), upside down: above zero up to 0.3 and from 0.4 to 0.9.
        let p = of(&[0.108, -0.75, 1.6, -1.0].map(|c| c));
        let exact = of(&[0.3 * 0.4 * 0.9, -(0.12 + 0.27 + 0.36), 1.6, -1.0]);
        assert!((first_fall(&exact, 1e-12, 1.0).unwrap() - 0.3).abs() < 1e-14);
        assert!(first_fall(&p, 1e-12, 0.29).is_none());
    }

    #[test]
    fn together_they_are_what_each_is_alone() {
        let each = [0.3, -1.1, 0.7, 2.0].map(|x: f64| {
            let mut p = [0.0; ORDER + 1];
            p.iter_mut().enumerate().for_each(|(power, value)| *value = (x * (power + 1) as f64).sin());
            p
        });
        let all = side_by_side([&each[0], &each[1], &each[2], &each[3]]);
        for tau in [0.0, 1e-9, 0.4, 1.0] {
            for (together, p) in values(&all, tau).iter().zip(&each) {
                assert!((together - value(p, tau)).abs() < 1e-14, "{tau}: {together}");
            }
        }
    }

    #[test]
    fn work_is_the_integral_of_force_and_rate() {
        let force = of(&[2.0, -1.0, 0.5, 0.0, 3.0]);
        let (all, none) = ([1.0; ORDER + 1], [0.0; ORDER + 1]);
        // (2 − τ + τ²/2 + 3τ⁴)(1 − 4τ) by hand.
        let by_hand =
            |t: f64| 2.0 * t - 4.5 * t.powi(2) + 1.5 * t.powi(3) - 0.5 * t.powi(4) + 0.6 * t.powi(5) - 2.0 * t.powi(6);
        for tau in [0.0, 0.25, 1.0] {
            let work = integral_of_product(&force, &of(&[1.0, -4.0]), tau);
            assert!((work - by_hand(tau)).abs() < 1e-15, "{work} at {tau}");
            assert_eq!(integral_of_product(&force, &none, tau), 0.0);
            // Which way round does not matter, and neither do all powers at once: Σ Σ over τ = 1 is the sum of 1/(i + j + 1).
            let [one, other] = [(&all, &force), (&force, &all)].map(|(p, q)| integral_of_product(p, q, tau));
            assert!((one - other).abs() < 1e-14, "{one}, {other}");
        }
        let by_quadrature = crate::quadrature::panel(0.0, 0.5, |at| value(&all, at) * value(&all, at));
        assert!((integral_of_product(&all, &all, 0.5) - by_quadrature).abs() < 1e-12);
    }

    #[test]
    fn what_touches_zero_within_the_margin_does_not_fall() {
        // (τ − 0.5)², then a thousandth of it deeper than the margin.
        assert_eq!(first_fall(&of(&[0.25, -1.0, 1.0]), 1e-12, 1.0), None);
        assert!(first_fall(&of(&[0.25 - 1e-9, -1.0, 1.0]), 1e-12, 1.0).is_some());
        // A gap right after its release: no place, no speed, no acceleration.
        assert_eq!(first_fall(&of(&[-1e-18, 0.0, 0.0, 1e-3]), 1e-12, 1.0), None);
    }
}
