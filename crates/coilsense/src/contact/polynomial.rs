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

/// dp/dτ.
pub(super) fn rate(p: &Polynomial, tau: f64) -> f64 {
    let terms = p.iter().enumerate().skip(1).rev();
    terms.fold(0.0, |sum, (power, coefficient)| sum * tau + power as f64 * coefficient)
}

/// The first τ in \[0, `until`\] at which p falls through −`margin`, moved back to where it fell through zero just before; `None` where it does
/// not.
///
/// Bernstein's coefficients bound a polynomial from below, and their signs count its roots from above: halved until they say which.
pub(super) fn first_fall(p: &Polynomial, margin: f64, until: f64) -> Option<f64> {
    // What is left if all that falls falls at once.
    if p[1..].iter().fold(p[0], |least, coefficient| least + coefficient.min(0.0)) > -margin {
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

/// Power form to Bernstein's, on \[0, 1\].
fn bernstein(mut p: Polynomial) -> Polynomial {
    for (coefficient, share) in p.iter_mut().zip(&SHARES) {
        *coefficient *= share;
    }
    for round in 1..=ORDER {
        for index in (round..=ORDER).rev() {
            p[index] += p[index - 1];
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
        let here = value(p, tau);
        if here >= 0.0 {
            above = tau;
        } else {
            below = tau;
        }
        let newton = tau - here / rate(p, tau);
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
    let slope = rate(p, fall);
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
    fn what_touches_zero_within_the_margin_does_not_fall() {
        // (τ − 0.5)², then a thousandth of it deeper than the margin.
        assert_eq!(first_fall(&of(&[0.25, -1.0, 1.0]), 1e-12, 1.0), None);
        assert!(first_fall(&of(&[0.25 - 1e-9, -1.0, 1.0]), 1e-12, 1.0).is_some());
        // A gap right after its release: no place, no speed, no acceleration.
        assert_eq!(first_fall(&of(&[-1e-18, 0.0, 0.0, 1e-3]), 1e-12, 1.0), None);
    }
}
