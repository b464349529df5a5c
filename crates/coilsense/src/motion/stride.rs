//! All modes over one step, and their sums at the ends: the vector kernel of a march.
//!
//! Next door: when to step, and how far (`march`).

use std::sync::Arc;

use aligned_vec::AVec;
use pulp::{Simd, WithSimd};

use super::closed::ModalState;
use crate::modes::ModalModel;

/// Modes are padded with modes that do nothing to a multiple of this, the widest vector.
const LANES: usize = 8;

/// Modal state and what a step does to it, one series per quantity, padded.
#[derive(Debug, Clone)]
pub(super) struct Stride {
    count: usize,
    coordinates: AVec<f64>,
    rates: AVec<f64>,
    /// What a step adds: r11 − 1, r12, r21, r22 − 1. Shared by copies, until one of them takes another step.
    transition: Arc<[AVec<f64>; 4]>,
    /// Shared by copies.
    tables: Arc<Tables>,
    /// Σ_j a_j c1_j, Σ_j a_j c2_j; Σ_j b_j c1_j, Σ_j b_j c2_j: what a jump of an input's rate does to the sums.
    pulls: [[f64; 2]; 2],
    /// Velocity kicks of both inputs that the next step begins with.
    pending: [f64; 2],
    sums: Sums,
    sums_are_current: bool,
}

/// What does not move.
#[derive(Debug)]
struct Tables {
    participations: [AVec<f64>; 2],
    /// a_j and b_j.
    weights: [AVec<f64>; 2],
}

/// Sums over the modes at both ends.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Sums {
    /// Σ a_j q_j, Σ b_j q_j \[m\].
    pub coordinates: [f64; 2],
    /// Σ a_j q̇_j, Σ b_j q̇_j \[m/s\].
    pub rates: [f64; 2],
}

impl Stride {
    pub(super) fn new(modes: &ModalModel, start: ModalState) -> Self {
        let weights = modes.weights();
        Self {
            count: modes.count(),
            coordinates: padded(&start.coordinates),
            rates: padded(&start.rates),
            transition: still(modes.count()),
            tables: Arc::new(Tables {
                participations: modes.participations().map(padded),
                weights: weights.map(padded),
            }),
            pulls: weights.map(|weights| modes.participations().map(|participations| dot(weights, participations))),
            pending: [0.0; 2],
            sums: Sums::default(),
            sums_are_current: false,
        }
    }

    /// What a step does to each mode, row by row.
    pub(super) fn set(&mut self, transitions: impl Iterator<Item = [f64; 4]>) {
        if Arc::get_mut(&mut self.transition).is_none() {
            self.transition = still(self.count);
        }
        let Some(tables) = Arc::get_mut(&mut self.transition) else { return };
        for (mode, rows) in transitions.enumerate() {
            for (table, value) in tables.iter_mut().zip(rows) {
                table[mode] = value;
            }
        }
    }

    /// A jump of an input's rate: the windings go on as they did, the straight line changes its pace under them.
    pub(super) fn kick(&mut self, end: usize, velocity: f64) {
        for (rate, pulls) in self.sums.rates.iter_mut().zip(self.pulls) {
            *rate -= pulls[end] * velocity;
        }
        self.pending[end] += velocity;
    }

    /// Velocities with the kicks that no step has taken up yet.
    fn kicked_rates(&self) -> impl Iterator<Item = f64> {
        let [first, second] = &self.tables.participations;
        let each = self.rates.iter().zip(first.iter()).zip(second.iter());
        each.map(|((rate, first), second)| rate - first * self.pending[0] - second * self.pending[1])
    }

    /// What an input's acceleration, or a jump of it, leaves: `kick` times what one takes off, per mode.
    pub(super) fn push(&mut self, end: usize, kick: f64, coordinates: &[f64], rates: &[f64]) {
        let each = self.tables.participations[end].iter().zip(coordinates.iter().zip(rates));
        for (mode, (participation, (coordinate, rate))) in each.enumerate() {
            self.coordinates[mode] -= participation * kick * coordinate;
            self.rates[mode] -= participation * kick * rate;
        }
        self.sums_are_current = false;
    }

    /// The sums now.
    pub(super) fn sums(&mut self) -> Sums {
        if !self.sums_are_current {
            let mut sums = Sums::default();
            let weights = self.tables.weights[0].iter().zip(self.tables.weights[1].iter());
            for ((coordinate, rate), (input, output)) in self.coordinates.iter().zip(self.kicked_rates()).zip(weights) {
                sums.coordinates[0] += input * coordinate;
                sums.coordinates[1] += output * coordinate;
                sums.rates[0] += input * rate;
                sums.rates[1] += output * rate;
            }
            self.sums = sums;
            self.sums_are_current = true;
        }
        self.sums
    }

    /// q_j and q̇_j.
    pub(super) fn state(&self) -> ModalState {
        let rates = self.kicked_rates().take(self.count).collect();
        ModalState { coordinates: self.coordinates().to_vec(), rates }
    }

    /// q_j and q̇_j without kicks that no step has taken up yet, shape `count` each.
    pub(super) fn at_sample(&self) -> [&[f64]; 2] {
        [&self.coordinates[..self.count], &self.rates[..self.count]]
    }

    /// Goes on from q_j and q̇_j, shape `count` each, without kicks.
    pub(super) fn begin_at(&mut self, coordinates: &[f64], rates: &[f64]) {
        self.coordinates[..self.count].copy_from_slice(coordinates);
        self.rates[..self.count].copy_from_slice(rates);
        self.pending = [0.0; 2];
        self.sums_are_current = false;
    }

    /// q_j, shape `count`.
    pub(super) fn coordinates(&self) -> &[f64] {
        &self.coordinates[..self.count]
    }
}

fn dot(values: &[f64], weights: &[f64]) -> f64 {
    values.iter().zip(weights).map(|(value, weight)| value * weight).sum()
}

/// Aligned to cache lines: a vector that straddles two costs as much as two.
fn padded(values: &[f64]) -> AVec<f64> {
    let mut padded = AVec::from_slice(aligned_vec::CACHELINE_ALIGN, values);
    padded.resize(values.len().next_multiple_of(LANES), 0.0);
    padded
}

/// A transition that adds nothing.
fn still(count: usize) -> Arc<[AVec<f64>; 4]> {
    let none = padded(&vec![0.0; count]);
    Arc::new([none.clone(), none.clone(), none.clone(), none])
}

impl WithSimd for &mut Stride {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let (coordinates, _) = S::as_mut_simd_f64s(&mut self.coordinates);
        let (rates, _) = S::as_mut_simd_f64s(&mut self.rates);
        // Spelled out: what a closure is handed to (an array's `map`, say) is not compiled for the wider instructions.
        let (Tables { participations, weights }, [t0, t1, t2, t3]) = (&*self.tables, &*self.transition);
        let (r11, r12) = (S::as_simd_f64s(t0).0, S::as_simd_f64s(t1).0);
        let (r21, r22) = (S::as_simd_f64s(t2).0, S::as_simd_f64s(t3).0);
        let (c1, c2) = (S::as_simd_f64s(&participations[0]).0, S::as_simd_f64s(&participations[1]).0);
        let (input, output) = (S::as_simd_f64s(&weights[0]).0, S::as_simd_f64s(&weights[1]).0);
        let kicks = [simd.splat_f64s(-self.pending[0]), simd.splat_f64s(-self.pending[1])];
        let mut sums = [simd.splat_f64s(0.0); 4];
        let state = coordinates.iter_mut().zip(rates).zip(c1.iter().zip(c2));
        let rows = r11.iter().zip(r12).zip(r21.iter().zip(r22)).zip(input.iter().zip(output));
        for (((q, v), (c1, c2)), (((r11, r12), (r21, r22)), (a, b))) in state.zip(rows) {
            let kicked = simd.mul_add_e_f64s(*c2, kicks[1], simd.mul_add_e_f64s(*c1, kicks[0], *v));
            let coordinate = simd.add_f64s(*q, simd.mul_add_e_f64s(*r12, kicked, simd.mul_f64s(*r11, *q)));
            let rate = simd.add_f64s(kicked, simd.mul_add_e_f64s(*r22, kicked, simd.mul_f64s(*r21, *q)));
            (*q, *v) = (coordinate, rate);
            sums[0] = simd.mul_add_e_f64s(*a, coordinate, sums[0]);
            sums[1] = simd.mul_add_e_f64s(*b, coordinate, sums[1]);
            sums[2] = simd.mul_add_e_f64s(*a, rate, sums[2]);
            sums[3] = simd.mul_add_e_f64s(*b, rate, sums[3]);
        }
        self.sums = Sums {
            coordinates: [simd.reduce_sum_f64s(sums[0]), simd.reduce_sum_f64s(sums[1])],
            rates: [simd.reduce_sum_f64s(sums[2]), simd.reduce_sum_f64s(sums[3])],
        };
        self.sums_are_current = true;
        self.pending = [0.0; 2];
    }
}
