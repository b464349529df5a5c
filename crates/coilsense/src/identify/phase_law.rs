//! Where the lines of one cause lie: a coil between seats of any kind, or what looks like one.
//!
//! Next door: laying a law on lines (`explain`), the mounts that users are told (`mode_series`).

use std::f64::consts::{FRAC_PI_2, PI};

/// What holds an end of the coil; κ = k/K: the seat's compliance over the coil's, μ = M/m: the seat's mass over the coil's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Seat {
    /// It does not give.
    Rigid,
    /// It gives like a spring that may carry a mass: κ, μ.
    Gives(f64, f64),
    /// A free mass: μ.
    Mass(f64),
    /// A force that stays.
    Free,
}

impl Seat {
    /// φ of the phase law at a coil's phase, given t = 2N tan(θ/2N) and x = 2N sin(θ/2N).
    ///
    /// tan φ = t k/(K − Mω²), ω² = x² k/m, continued through the seat's own resonance: φ grows from 0 to π.
    fn phase(self, t: f64, x: f64) -> f64 {
        match self {
            Self::Rigid => 0.0,
            Self::Gives(kappa, mu) => (kappa * t).atan2(1.0 - mu * kappa * x * x),
            Self::Mass(mu) => t.atan2(-mu * x * x),
            Self::Free => FRAC_PI_2,
        }
    }

    /// dφ/dθ, given dt/dθ and dx/dθ, too.
    fn slope(self, [t, dt]: [f64; 2], [x, dx]: [f64; 2]) -> f64 {
        // φ = atan(a/b).
        let of = |a: f64, da: f64, b: f64, db: f64| (da * b - a * db) / (a * a + b * b);
        match self {
            Self::Rigid | Self::Free => 0.0,
            Self::Gives(kappa, mu) => of(kappa * t, kappa * dt, 1.0 - mu * kappa * x * x, -2.0 * mu * kappa * x * dx),
            Self::Mass(mu) => of(t, dt, -mu * x * x, -2.0 * mu * x * dx),
        }
    }
}

/// A cause of lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Law {
    /// A coil of N windings (infinite: the continuous one) between two seats.
    Coil {
        /// N.
        windings: f64,
        /// At end 1 and at end 2.
        seats: [Seat; 2],
    },
    /// Multiples of one motion's frequency.
    Harmonics,
    /// Multiples of the mains' frequency \[Hz\].
    Mains(f64),
    /// A string or belt that resists bending: f_n = n f √(1 + B n²)/√(1 + B).
    String(f64),
    /// A beam of one of four kinds of support.
    Beam(Support),
}

/// How a beam's ends are held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Support {
    ClampedFree,
    ClampedClamped,
    Hinged,
    ClampedHinged,
}

/// A mode of a coil: f_j over f1 of the held coil, and what the ends' forces depend on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mode {
    pub(super) multiple: f64,
    /// φ at end 1 and end 2.
    pub(super) phases: [f64; 2],
    /// t = 2N tan(θ/2N).
    pub(super) tangent: f64,
}

impl Law {
    /// f_j over the law's base frequency: f1 of the held coil, the lowest line of others; none where there is no such mode.
    pub(super) fn multiple(&self, mode: usize) -> Option<f64> {
        let j = mode as f64;
        match *self {
            Self::Coil { windings, seats } => mode_of(windings, seats, mode).map(|mode| mode.multiple),
            Self::Harmonics | Self::Mains(_) => Some(j),
            Self::String(bending) => Some(j * ((1.0 + bending * j * j) / (1.0 + bending)).sqrt()),
            Self::Beam(support) => Some((support.root(mode) / support.root(1)).powi(2)),
        }
    }
}

impl Support {
    /// Root β_j L of the frequency equation of a beam of Euler and Bernoulli: cos βL cosh βL = ∓1, or tan βL = tanh βL; to 1e-9.
    fn root(self, mode: usize) -> f64 {
        let j = mode as f64;
        let (table, far): (&[f64], f64) = match self {
            Self::ClampedFree => {
                (&[1.875_104_069, 4.694_091_133, 7.854_757_438, 10.995_540_735, 14.137_168_391], (j - 0.5) * PI)
            }
            Self::ClampedClamped => {
                (&[4.730_040_745, 7.853_204_624, 10.995_607_838, 14.137_165_491, 17.278_759_657], (j + 0.5) * PI)
            }
            Self::Hinged => (&[], j * PI),
            Self::ClampedHinged => {
                (&[3.926_602_312, 7.068_582_746, 10.210_176_123, 13.351_768_778, 16.493_361_432], (j + 0.25) * PI)
            }
        };
        table.get(mode - 1).copied().unwrap_or(far)
    }

    /// In words.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::ClampedFree => "a beam, one end clamped",
            Self::ClampedClamped => "a beam, both ends clamped or free",
            Self::Hinged => "a beam on hinges",
            Self::ClampedHinged => "a beam, one end clamped, the other hinged",
        }
    }
}

/// Mode j of a coil between seats: θ + φ1 + φ2 = jπ, f_j/f1 = sin(θ/2N)/sin(π/2N).
///
/// The left side grows with θ, by Foster's theorem, so there is one root for each j.
pub(super) fn mode_of(windings: f64, seats: [Seat; 2], mode: usize) -> Option<Mode> {
    let wanted = mode as f64 * PI;
    let top = if windings.is_finite() { (windings - 1e-9) * PI } else { f64::INFINITY };
    // [t, dt/dθ] and [x, dx/dθ].
    let reach = |theta: f64| {
        if !windings.is_finite() {
            return ([theta, 1.0], [theta, 1.0]);
        }
        let (sine, cosine) = (0.5 * theta / windings).sin_cos();
        ([2.0 * windings * sine / cosine, 1.0 / (cosine * cosine)], [2.0 * windings * sine, cosine])
    };
    let theta = if seats == [Seat::Rigid; 2] {
        // The highest mode of a chain whose N is a little off has its line all the same.
        if wanted > top + 0.3 * PI {
            return None;
        }
        wanted
    } else {
        let excess = |theta: f64| {
            let (t, x) = reach(theta);
            let phases: f64 = seats.iter().map(|seat| seat.phase(t[0], x[0])).sum();
            let slopes: f64 = seats.iter().map(|seat| seat.slope(t, x)).sum();
            (theta + phases - wanted, 1.0 + slopes)
        };
        let loosest: f64 = seats.iter().map(|seat| if *seat == Seat::Rigid { 0.0 } else { PI }).sum();
        root_of(excess, (wanted - loosest).max(1e-9), wanted.min(top), 1e-13 * wanted)?
    };
    let ([tangent, _], [x, _]) = reach(theta);
    let phases = seats.map(|seat| seat.phase(tangent, x));
    let one = if windings.is_finite() { 2.0 * windings * (FRAC_PI_2 / windings).sin() } else { PI };
    Some(Mode { multiple: x / one, phases, tangent })
}

/// The root of a growing function with its slope, between two bounds; none where the function is negative up to the upper one.
///
/// Newton's steps from above, halves of what is left of the bracket where one would leave it, and every eighth time.
fn root_of(of: impl Fn(f64) -> (f64, f64), mut low: f64, mut high: f64, small: f64) -> Option<f64> {
    let (mut value, mut slope) = of(high);
    if high <= low || value < -1e-9 {
        return None;
    }
    if value < small {
        return Some(high);
    }
    let mut root = high;
    for step in 1..100 {
        let next = root - value / slope;
        let inside = next > low && next < high && step % 8 != 0;
        let next = if inside { next } else { 0.5 * (low + high) };
        let moved = (next - root).abs();
        root = next;
        if moved <= 1e-14 * high || high - low <= 1e-13 * high {
            break;
        }
        (value, slope) = of(root);
        if value.abs() < small {
            break;
        }
        *(if value > 0.0 { &mut high } else { &mut low }) = root;
    }
    Some(root)
}

/// f_j over f1 of a coil between seats that give.
pub(super) fn giving_multiple(compliance: [f64; 2], mass: [f64; 2], mode: usize, windings: f64) -> f64 {
    let seat = |end: usize| if compliance[end] > 0.0 { Seat::Gives(compliance[end], mass[end]) } else { Seat::Rigid };
    mode_of(windings, [seat(0), seat(1)], mode).map_or(f64::NAN, |mode| mode.multiple)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mass_at_the_end_obeys_its_own_equation() {
        for mu in [0.1, 1.0, 20.0] {
            for mode in 1..6 {
                let beta = PI * mode_of(f64::INFINITY, [Seat::Rigid, Seat::Mass(mu)], mode).unwrap().multiple;
                // β tan β = m/M, to what the tangent makes of 1e-13.
                assert!((beta * beta.tan() - 1.0 / mu).abs() < 1e-9 * (1.0 + beta * beta), "μ {mu} mode {mode}");
            }
        }
    }

    #[test]
    fn every_root_obeys_the_law_and_slopes_are_those_of_the_phases() {
        let seats = [Seat::Gives(0.03, 0.0), Seat::Gives(0.1, 2.0), Seat::Mass(0.4), Seat::Free, Seat::Rigid];
        for windings in [f64::INFINITY, 7.3, 40.0] {
            let [t, x] = [f64::tan, f64::sin].map(|of| {
                move |theta: f64| if windings.is_finite() { 2.0 * windings * of(0.5 * theta / windings) } else { theta }
            });
            for pair in seats.into_iter().flat_map(|one| seats.map(|other| [one, other])) {
                for mode in 1..=5 {
                    let Some(found) = mode_of(windings, pair, mode) else { continue };
                    let theta = if windings.is_finite() {
                        2.0 * windings * (found.tangent / (2.0 * windings)).atan()
                    } else {
                        found.tangent
                    };
                    let left = theta + pair.map(|seat| seat.phase(t(theta), x(theta))).iter().sum::<f64>();
                    // Two free masses move together at θ = 0, which is looked for from 1e-9 on.
                    let off = if theta < 2e-9 { 1e-8 } else { 1e-11 };
                    assert!((left - mode as f64 * PI).abs() < off, "{windings} {pair:?} mode {mode}: {left}");
                }
            }
            for (seat, theta) in seats.into_iter().flat_map(|seat| [0.7, 2.9, 9.1].map(|theta| (seat, theta))) {
                let quotient = |of: &dyn Fn(f64) -> f64| (of(theta + 1e-6) - of(theta - 1e-6)) / 2e-6;
                let told = seat.slope([t(theta), quotient(&t)], [x(theta), quotient(&x)]);
                let seen = quotient(&|theta| seat.phase(t(theta), x(theta)));
                assert!(
                    (told - seen).abs() < 1e-6 * (1.0 + seen.abs()),
                    "{windings} {seat:?} at {theta}: {told}, {seen}"
                );
            }
        }
    }

    #[test]
    fn a_seat_with_a_resonance_adds_one_mode() {
        let seats = [Seat::Rigid, Seat::Gives(1e-3, 4.0)];
        let multiples: Vec<f64> = (1..30).map(|mode| mode_of(f64::INFINITY, seats, mode).unwrap().multiple).collect();
        assert!(multiples.windows(2).all(|pair| pair[1] > pair[0]));
        // Above its resonance the seat stands still again: mode 29 lies near 28 f1.
        assert!((multiples[28] - 28.0).abs() < 0.01, "{}", multiples[28]);
        assert!((multiples[1] - 2.0).abs() < 0.01);
    }

    #[test]
    fn a_free_end_has_the_quarter_waves() {
        let free = mode_of(f64::INFINITY, [Seat::Rigid, Seat::Free], 3).unwrap();
        assert!((free.multiple - 2.5).abs() < 1e-12);
        let soft = mode_of(f64::INFINITY, [Seat::Rigid, Seat::Gives(1e9, 0.0)], 3).unwrap();
        assert!((soft.multiple - 2.5).abs() < 1e-8);
    }
}
