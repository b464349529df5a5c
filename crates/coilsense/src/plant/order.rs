//! How many modes an error needs, and what stands for those that are left out.
//!
//! Next door: the plant (the parent).

use std::f64::consts::TAU;

use coilsense_rt::PlantMode;
use num_complex::Complex64;

use super::{LOOKS, ModalPlant};
use crate::error::{Error, above_zero, check};
use crate::mount::FarEnd;

/// How many of the spring's modes a plant has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Order {
    /// All of them: exact.
    All,
    /// The first so many.
    Modes(usize),
    /// As few as keep the response of F_i, F_o and F_x to each input within an error up to a bandwidth.
    Within {
        /// Share of k, or of the force at end 2 \[1\], above zero and below one.
        error: f64,
        /// \[Hz\], above zero.
        bandwidth: f64,
    },
}

/// Sums over the modes that are left out, `[F_i, F_o, u2][input]`.
///
/// R = Σ p c/ω², T = Σ p c/ω⁴, D = Σ p c ζ/ω³
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct LeftOut {
    inertia: [[f64; 2]; 3],
    second: [[f64; 2]; 3],
    damping: [[f64; 2]; 3],
    /// Which output each input meets at its own end.
    own: [usize; 2],
}

impl LeftOut {
    fn add(&mut self, mode: &PlantMode) {
        let square = mode.frequency * mode.frequency;
        let of_outputs = [mode.weights[0], mode.weights[1], mode.end];
        for (output, weight) in of_outputs.into_iter().enumerate() {
            for (input, participation) in mode.participations.into_iter().enumerate() {
                let inertia = weight * participation / square;
                self.inertia[output][input] += inertia;
                self.second[output][input] += inertia / square;
                self.damping[output][input] += inertia * mode.damping / mode.frequency;
            }
        }
    }

    /// One mode for each input, which has the inertia of all that are left out, and at the input's own end the next term as well.
    ///
    /// c = 1 for its input, ω² = R/T and ζ = ω D/R where the input meets the spring, p = R ω² for every output
    ///
    /// Source:   a mode far above its drive follows as q = −c (ẅ/ω² − 2ζ w⃛/ω³ − w⁗/ω⁴ …): the mode-acceleration method with two terms more.
    pub(super) fn stand_ins(&self) -> Vec<PlantMode> {
        (0..2).map(|input| self.stand_in(input)).collect()
    }

    fn stand_in(&self, input: usize) -> PlantMode {
        let own = self.own[input];
        let (inertia, second) = (self.inertia[own][input], self.second[own][input]);
        let square = inertia / second;
        let (square, damping) = match square > 0.0 && square.is_finite() {
            true => (square, square.sqrt() * self.damping[own][input] / inertia),
            // Nothing is left out that this input could drive.
            false => (1.0, 0.0),
        };
        let pull = |output: usize| self.inertia[output][input] * square;
        let mut participations = [0.0; 2];
        participations[input] = 1.0;
        PlantMode { frequency: square.sqrt(), damping, participations, weights: [pull(0), pull(1)], end: pull(2) }
    }
}

/// Adds a mode to the response of F_i, F_o and F_x.
///
/// - `pulls`: of the outputs per q; `drive`: Ω \[rad/s\] and β \[s\]
pub(super) fn add(
    response: &mut [[Complex64; 2]; 3],
    pulls: &[f64; 3],
    mode: &PlantMode,
    ratio: f64,
    [drive, dashpot]: [f64; 2],
) {
    let natural = mode.frequency;
    let detuning = Complex64::new((natural - drive) * (natural + drive), 2.0 * ratio * natural * drive);
    let swing = drive * drive / detuning;
    let felt = swing * Complex64::new(1.0, dashpot * drive);
    for (output, (row, pull)) in response.iter_mut().zip(pulls).enumerate() {
        // F_x is of where end 2 is, with no dashpot beside.
        let swing = if output == 2 { swing } else { felt };
        for (value, participation) in row.iter_mut().zip(mode.participations) {
            *value += pull * participation * swing;
        }
    }
}

impl ModalPlant {
    /// How many modes are kept.
    pub(super) fn modes_for(&self, order: Order) -> Result<usize, Error> {
        let all = self.available();
        // Two modes stand for the others: with fewer than three others they would spare nothing.
        let rounded = |kept: usize| if kept + 2 >= all { all } else { kept };
        match order {
            Order::All => Ok(all),
            Order::Modes(modes) => {
                check((1..=all).contains(&modes), "modes", modes as f64, "", format!("from 1 to {all}"))?;
                Ok(rounded(modes))
            }
            Order::Within { error, bandwidth } => {
                check(error > 0.0 && error < 1.0, "error", error, "", "above zero and below one")?;
                above_zero("bandwidth", bandwidth, "Hz")?;
                let enough = self.errors(bandwidth).iter().position(|missed| *missed <= error);
                Ok(rounded(enough.map_or(all, |index| index + 1)))
            }
        }
    }

    /// What is missed with 1, 2 … all modes up to a bandwidth \[Hz\], as [`ModalPlant::error`].
    pub(super) fn errors(&self, bandwidth: f64) -> Vec<f64> {
        let (all, shared) = (self.available(), self.damped.0);
        let modes: Vec<PlantMode> = (0..all).map(|mode| self.own(mode)).collect();
        let mut errors = vec![0.0; all];
        let mut left_out = self.nothing();
        let stand_ins: Vec<Vec<PlantMode>> = (1..all)
            .rev()
            .map(|kept| {
                left_out.add(&modes[kept]);
                left_out.stand_ins()
            })
            .collect();
        let scales = self.of_line()[0].map(|line| if line == 0.0 { self.spring.stiffness() } else { line.abs() });
        for look in 1..=LOOKS {
            let drive = [TAU * bandwidth * look as f64 / LOOKS as f64, self.dashpot_time()];
            let mut missing = [[Complex64::ZERO; 2]; 3];
            for (kept, others) in (1..all).rev().zip(&stand_ins) {
                let mode = &modes[kept];
                add(&mut missing, &self.pulls(mode), mode, mode.damping * shared, drive);
                let mut stood_for = [[Complex64::ZERO; 2]; 3];
                for mode in others {
                    add(&mut stood_for, &self.pulls(mode), mode, mode.damping * shared, drive);
                }
                let pairs = missing.iter().flatten().zip(stood_for.iter().flatten()).zip(scales.iter().cycle());
                let worst = pairs.fold(0.0_f64, |worst, ((all, ours), scale)| worst.max((all - ours).norm() / scale));
                let in_band = mode.frequency <= TAU * bandwidth;
                errors[kept - 1] = if in_band { f64::INFINITY } else { worst.max(errors[kept - 1]) };
            }
        }
        errors
    }

    fn nothing(&self) -> LeftOut {
        let own = if self.mount.far_end() == FarEnd::Position { [0, 1] } else { [0, 2] };
        LeftOut { own, ..LeftOut::default() }
    }

    /// Of all modes from this one on, counted from zero.
    pub(super) fn left_out(&self, kept: usize) -> LeftOut {
        let mut left_out = self.nothing();
        (kept..self.available()).rev().for_each(|mode| left_out.add(&self.own(mode)));
        left_out
    }
}
