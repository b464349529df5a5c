//! Damping of the lumps: forces that their speeds beside the massless line bring about.
//!
//! Next door: what damping means (`crate::damping`), the series that it enters (`series`).

use super::chain::Chain;
use crate::damping::Damping;
use crate::error::{Error, check};
use crate::modes::ModalModel;

/// What damps the lumps.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Damper {
    None,
    /// α \[1/s\].
    Mass(f64),
    /// β \[s\].
    Stiffness(f64),
    /// C \[N s/m\], shape `N × N`, row-major.
    Full(Vec<f64>),
}

impl Damper {
    /// Of a chain whose modes are not known: what is defined without them.
    ///
    /// # Errors
    /// [`Error::Value`] for a damping ratio or a loss factor.
    pub(super) fn without_modes(damping: &Damping) -> Result<Self, Error> {
        let refused = |quantity: &'static str, value: f64| {
            let allowed = "zero for a chain whose modes are not given: take mass- or stiffness-proportional damping";
            check(value == 0.0, quantity, value, "", allowed).map(|_| Self::None)
        };
        match damping.clone().checked()? {
            Damping::None => Ok(Self::None),
            Damping::MassProportional { rate } => Ok(Self::Mass(rate)),
            Damping::StiffnessProportional { time } => Ok(Self::Stiffness(time)),
            Damping::Modal(ratio) => refused("damping_ratio", ratio),
            Damping::ModalEach(ratios) => refused("damping_ratio", ratios.into_iter().fold(0.0, f64::max)),
            Damping::Hysteretic { loss_factor } => refused("loss_factor", loss_factor),
        }
    }

    /// Of a chain with its modes: C = Σ_j M φ_j (2ζ_jω_j/n_j) (M φ_j)ᵀ where each mode has its own ratio, n_j = φ_jᵀ M φ_j.
    ///
    /// # Errors
    /// Those of [`Damping::ratios`].
    pub(super) fn of(damping: &Damping, chain: &Chain, modes: &ModalModel) -> Result<Self, Error> {
        match damping {
            Damping::Modal(_) | Damping::ModalEach(_) | Damping::Hysteretic { .. } => {}
            _ => return Self::without_modes(damping),
        }
        let ratios = damping.ratios(modes.frequencies())?;
        if ratios.iter().all(|ratio| *ratio == 0.0) {
            return Ok(Self::None);
        }
        let lumps = chain.lumps();
        let mut matrix = vec![0.0; lumps * lumps];
        for (mode, (frequency, ratio)) in modes.frequencies().iter().zip(&ratios).enumerate() {
            let shape = |lump: usize| match lump.checked_sub(chain.base()) {
                // A follower is no part of the spring's modes: it goes with the line beside which they are damped.
                None => 0.0,
                Some(lump) if lump < modes.masses() => modes.shape_at(mode + 1, lump + 1),
                Some(_) => modes.end_shapes()[mode],
            };
            let shapes: Vec<f64> = (0..lumps).map(shape).collect();
            let carried: Vec<f64> = shapes.iter().zip(chain.masses()).map(|(shape, mass)| shape * mass).collect();
            let norm: f64 = shapes.iter().zip(&carried).map(|(shape, carried)| shape * carried).sum();
            let factor = 2.0 * ratio * frequency / norm;
            for (row, first) in matrix.chunks_exact_mut(lumps).zip(&carried) {
                row.iter_mut().zip(&carried).for_each(|(entry, second)| *entry += factor * first * second);
            }
        }
        Ok(Self::Full(matrix))
    }

    pub(super) fn is_none(&self) -> bool {
        *self == Self::None
    }

    /// β of the dashpots in the segments \[s\].
    pub(super) fn dashpot_time(&self) -> f64 {
        if let Self::Stiffness(time) = self { *time } else { 0.0 }
    }

    /// Subtracts from forces on the lumps, shape `N`, what it takes at the speeds `relative` to the line, shape `N + 2`, zero at prescribed ends.
    pub(super) fn brake(&self, chain: &Chain, relative: &[f64], forces: &mut [f64]) {
        let inner = &relative[1..=forces.len()];
        match self {
            Self::None => {}
            Self::Mass(rate) => {
                for ((force, mass), speed) in forces.iter_mut().zip(chain.masses()).zip(inner) {
                    *force -= rate * mass * speed;
                }
            }
            Self::Stiffness(time) => {
                for (segment, (stiffness, pair)) in chain.stiffnesses().iter().zip(relative.windows(2)).enumerate() {
                    let tension = time * stiffness * (pair[1] - pair[0]);
                    if segment > 0 {
                        forces[segment - 1] += tension;
                    }
                    if segment < forces.len() {
                        forces[segment] -= tension;
                    }
                }
            }
            Self::Full(matrix) => {
                crate::simd::dispatch(Product { matrix, speeds: inner, forces });
            }
        }
    }

    /// A bound on how fast it stops a lump \[1/s\].
    pub(super) fn fastest(&self, chain: &Chain, angular: f64) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Mass(rate) => *rate,
            Self::Stiffness(time) => time * angular * angular,
            Self::Full(matrix) => {
                let rows = matrix.chunks_exact(chain.lumps()).zip(chain.masses());
                rows.map(|(row, mass)| row.iter().map(|entry| entry.abs()).sum::<f64>() / mass).fold(0.0, f64::max)
            }
        }
    }
}

/// Subtracts C v, column by column, which are rows since C is symmetric: no sum waits for the one before it.
struct Product<'a> {
    matrix: &'a [f64],
    speeds: &'a [f64],
    forces: &'a mut [f64],
}

impl pulp::WithSimd for Product<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        let lumps = self.speeds.len();
        let mut columns = self.matrix.chunks_exact(2 * lumps);
        let mut speeds = self.speeds.chunks_exact(2);
        // Two at a time: each force is loaded half as often.
        for (pair, speeds) in columns.by_ref().zip(speeds.by_ref()) {
            let (first, second) = pair.split_at(lumps);
            for ((force, a), b) in self.forces.iter_mut().zip(first).zip(second) {
                *force -= a * speeds[0] + b * speeds[1];
            }
        }
        for (column, speed) in columns.remainder().chunks_exact(lumps).zip(speeds.remainder()) {
            self.forces.iter_mut().zip(column).for_each(|(force, entry)| *force -= entry * speed);
        }
    }
}
