//! A law with numbers: which of them lines decide, where a mode lies by them, and how that moves with each.
//!
//! Next door: the laws (`phase_law`), how numbers are fitted to lines (`fit`).

use nalgebra::DMatrix;

use crate::identify::phase_law::{Law, Seat};

/// Parameters of a law, at most.
const MOST_KNOBS: usize = 6;

/// A parameter that lines decide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Knob {
    /// ln of the base frequency.
    Base,
    /// 1/N².
    Chain,
    /// ln κ of a seat.
    Kappa(usize),
    /// ln μ of a seat.
    Mu(usize),
    /// ln B.
    Bending,
}

impl Knob {
    /// Bounds.
    pub(super) fn bounds(self) -> (f64, f64) {
        match self {
            Self::Base => (-3.0, 12.0),
            Self::Chain => (0.0, 0.0625),
            Self::Kappa(_) => (2e-5_f64.ln(), 0.15_f64.ln()),
            Self::Mu(_) => (1e-4_f64.ln(), 1e3_f64.ln()),
            // Below, a belt is a string, whose lines are those of a coil.
            Self::Bending => (1e-4_f64.ln(), 0.3_f64.ln()),
        }
    }

    /// ln of the prior's density at a value: N, κ, μ, B are as likely in every octave of what rigs have.
    pub(super) fn prior(self, value: f64) -> f64 {
        match self {
            Self::Base => -(5.0_f64.ln()),
            // N from 4 to 300.
            Self::Chain => -(2.0 * value.max(1e-5) * 75.0_f64.ln()).ln(),
            Self::Kappa(_) => -((0.15_f64 / 1e-4).ln().ln()),
            Self::Mu(_) => -((200.0_f64 / 3e-3).ln().ln()),
            Self::Bending => -((0.1_f64 / 1e-4).ln().ln()),
        }
    }

    /// Its value in a law.
    fn of(self, law: Law, base: f64) -> f64 {
        match (self, law) {
            (Self::Base, _) => base.ln(),
            (Self::Chain, Law::Coil { windings, .. }) => {
                if windings.is_finite() {
                    windings.powi(-2)
                } else {
                    0.0
                }
            }
            (Self::Kappa(end), Law::Coil { seats, .. }) => match seats[end] {
                Seat::Gives(kappa, _) => kappa.ln(),
                _ => f64::NAN,
            },
            (Self::Mu(end), Law::Coil { seats, .. }) => match seats[end] {
                Seat::Gives(_, mu) | Seat::Mass(mu) => mu.ln(),
                _ => f64::NAN,
            },
            (Self::Bending, Law::String(bending)) => bending.ln(),
            _ => f64::NAN,
        }
    }

    /// The law with another value, within bounds.
    fn put(self, mut law: Law, mut base: f64, value: f64) -> (Law, f64) {
        let (low, high) = self.bounds();
        let value = value.clamp(low, high);
        match (self, &mut law) {
            (Self::Base, _) => base = value.exp(),
            (Self::Chain, Law::Coil { windings, .. }) => {
                *windings = if value < 1e-8 { f64::INFINITY } else { value.powf(-0.5) };
            }
            (Self::Kappa(end), Law::Coil { seats, .. }) => {
                if let Seat::Gives(kappa, _) = &mut seats[end] {
                    *kappa = value.exp();
                }
            }
            (Self::Mu(end), Law::Coil { seats, .. }) => {
                if let Seat::Gives(_, mu) | Seat::Mass(mu) = &mut seats[end] {
                    *mu = value.exp();
                }
            }
            (Self::Bending, Law::String(bending)) => *bending = value.exp(),
            _ => {}
        }
        (law, base)
    }

    /// Step of a derivative.
    fn step(self, value: f64) -> f64 {
        match self {
            Self::Chain => (1e-4 * value).max(2e-7),
            _ => 1e-5,
        }
    }
}

/// A law with numbers, and which of them are free.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Trial {
    pub(super) law: Law,
    /// Base frequency \[Hz\].
    pub(super) base: f64,
    pub(super) knobs: Vec<Knob>,
}

impl Trial {
    pub(super) fn get(&self, knob: Knob) -> f64 {
        knob.of(self.law, self.base)
    }

    pub(super) fn set(&mut self, knob: Knob, value: f64) {
        (self.law, self.base) = knob.put(self.law, self.base, value);
    }

    /// ln f_j; none where the law has no such mode.
    pub(super) fn line(&self, mode: usize) -> Option<f64> {
        Some(self.base.ln() + self.law.multiple(mode)?.ln())
    }

    /// ln f_j and its derivatives by the knobs.
    pub(super) fn slopes(&self, mode: usize) -> Option<(f64, [f64; MOST_KNOBS])> {
        let own = self.law.multiple(mode)?.ln();
        let mut slopes = [0.0; MOST_KNOBS];
        for (slope, knob) in slopes.iter_mut().zip(&self.knobs) {
            if *knob == Knob::Base {
                *slope = 1.0;
                continue;
            }
            let value = self.get(*knob);
            let (law, base) = knob.put(self.law, self.base, value + knob.step(value));
            let moved = knob.of(law, base) - value;
            if moved != 0.0 {
                *slope = (law.multiple(mode)?.ln() - own) / moved;
            }
        }
        Some((self.base.ln() + own, slopes))
    }

    /// Variance of ln f_j by that of the knobs.
    pub(super) fn variance(&self, slopes: &[f64; MOST_KNOBS], covariance: &DMatrix<f64>) -> f64 {
        let count = self.knobs.len();
        let each = (0..count * count).map(|n| (n / count, n % count));
        each.map(|(row, column)| slopes[row] * covariance[(row, column)] * slopes[column]).sum::<f64>().max(0.0)
    }
}
