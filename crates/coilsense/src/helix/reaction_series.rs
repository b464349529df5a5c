//! What a moving helix does to what holds its ends, over time.
//!
//! Next door: the axial force alone (`crate::motion`), the same by mode and by frequency (`reaction`).

use super::surge::{Six, Slow, Surge, of_mode};
use crate::error::{Error, check};
use crate::excitation::{End, EndInput};
use crate::modes::{ModalModel, Tied};
use crate::motion::Motion;

/// Force and couples on what holds an end, at the spring's axis, over time.
///
/// Axes are those of [`super::Reaction`]: x through the point where the wire begins at end 1, z the spring's own. The force of a spring under
/// tension points along z at end 1 and against it at end 2.
#[derive(Debug, Clone, PartialEq)]
pub struct ReactionSeries {
    /// Along x, y, z \[N\], shape `samples` each.
    pub force: [Vec<f64>; 3],
    /// About x, y, z \[N m\], shape `samples` each.
    pub couple: [Vec<f64>; 3],
}

impl Surge {
    /// What the ends of a motion of this helix do to what holds them: end 1, then end 2.
    ///
    /// P = P_0 + G u + Σ_j r_j (q_j + β q̇_j) − R ü + T u⁗
    ///
    /// with P_0 the load at the helix's length (F and C along the axis), G and r_j what the holding feels of the ends' slow motion and of each
    /// mode, R and T what modes that are left out follow with, β the time of stiffness-proportional damping.
    ///
    /// - `times`: t \[s\], shape `samples`, in any order, none below zero
    ///
    /// Source:   as [`Surge`], for each direction of force and couple.
    /// Valid:    as [`Surge`]; holdings that do not move but along the axis.
    /// Accuracy: that of [`super::Response::reaction`] to 1e-7 of the dynamic axial force (couples: at the coil's radius) under sines below 0.75 f1 (`tests/helix`).
    ///
    /// # Errors
    /// [`Error::Value`] for a motion of other modes than this helix's, and as [`Motion::end_forces`].
    pub fn reactions(&self, motion: &Motion, times: &[f64]) -> Result<[ReactionSeries; 2], Error> {
        self.felt().reactions(&self.model, motion, times)
    }

    /// What its ends feel.
    pub(super) fn felt(&self) -> Felt {
        let of = |end: End| self.modes().iter().map(|mode| of_mode(mode, end)).collect();
        Felt { modes: [of(End::One), of(End::Two)], slow: self.slow, couple: self.helix.couple() }
    }
}

/// What the ends of a helix feel: of each mode for a modal mass of 1 kg, of the slow motion of each end, and at rest.
#[derive(Debug, Clone)]
pub(super) struct Felt {
    modes: [Vec<Six>; 2],
    /// `[at][moved]`.
    slow: [[Slow; 2]; 2],
    /// C \[N m\].
    couple: f64,
}

impl Felt {
    /// The same of a wire with moduli and density multiplied, its shape kept: forces times `stiffness`, frequencies times `frequency`.
    pub(super) fn changed(&self, stiffness: f64, frequency: f64) -> Self {
        let mass = stiffness / (frequency * frequency);
        let all = |six: &Six, by: f64| six.map(|value| by * value);
        let slow = |slow: &Slow| Slow {
            rest: all(&slow.rest, stiffness),
            mass: all(&slow.mass, mass),
            second: all(&slow.second, mass / (frequency * frequency)),
        };
        let of_modes = |modes: &Vec<Six>| modes.iter().map(|six| all(six, stiffness / mass.sqrt())).collect();
        Self {
            modes: self.modes.each_ref().map(of_modes),
            slow: self.slow.each_ref().map(|at| at.each_ref().map(slow)),
            couple: stiffness * self.couple,
        }
    }

    /// [`Surge::reactions`], of modes that belong to these.
    pub(super) fn reactions(
        &self,
        model: &ModalModel,
        motion: &Motion,
        times: &[f64],
    ) -> Result<[ReactionSeries; 2], Error> {
        if let Some(tied) = motion.modes().tie() {
            return self.reactions_of_tied(model, tied, motion, times);
        }
        let count = motion.modes().count();
        let own = model.frequencies().get(..count) == Some(motion.modes().frequencies());
        check(own, "modes of the motion", count as f64, "", "those of this helix")?;
        let forces = motion.end_forces(times)?;
        let [first, second] = [End::One, End::Two].map(|end| motion.excitation().input(end));
        let inputs = [first.displacements(times), second.displacements(times)];
        let accelerations = [first, second].map(|input| of_each(times, input, EndInput::acceleration));
        let snaps = [first, second].map(|input| of_each(times, input, EndInput::snap));
        let series = |end: End, axial: Vec<f64>| -> Result<ReactionSeries, Error> {
            let (at, sign) = if end == End::One { (0, 1.0) } else { (1, -1.0) };
            let of_modes = &self.modes[at][..count];
            let beside = [0, 1, 3, 4, 5];
            let weights: Vec<Vec<f64>> =
                beside.iter().map(|i| of_modes.iter().map(|mode| mode[*i]).collect()).collect();
            let mut sums = motion.modal_sums(times, &weights)?;
            for (i, (sums, weights)) in beside.into_iter().zip(sums.iter_mut().zip(&weights)) {
                let mean = if i == 5 { sign * self.couple } else { 0.0 };
                for moved in 0..2 {
                    let Slow { rest, mass, second } = &self.slow[at][moved];
                    let left = mass[i] - carried(model, weights, moved, 1);
                    let next = second[i] - carried(model, weights, moved, 2);
                    let slow = inputs[moved].iter().zip(&accelerations[moved]).zip(&snaps[moved]);
                    for (((input, acceleration), snap), sum) in slow.zip(&mut *sums) {
                        *sum += rest[i] * input - left * acceleration + next * snap;
                    }
                }
                sums.iter_mut().for_each(|sum| *sum += mean);
            }
            let axial = axial.into_iter().map(|force| sign * force).collect();
            let [x, y, about_x, about_y, about_z]: [Vec<f64>; 5] = sums.try_into().unwrap_or_default();
            Ok(ReactionSeries { force: [x, y, axial], couple: [about_x, about_y, about_z] })
        };
        Ok([series(End::One, forces.input)?, series(End::Two, forces.output)?])
    }
}

impl Felt {
    /// The same where end 2 has no prescribed position: it is off the place of a wire without mass by its part of each mode.
    ///
    /// Modes beyond the reach follow the acceleration of both ends, that of end 2 being `dragged ü1 − Σ_j ω_j² v_j η_j`.
    fn reactions_of_tied(
        &self,
        model: &ModalModel,
        tied: &Tied,
        motion: &Motion,
        times: &[f64],
    ) -> Result<[ReactionSeries; 2], Error> {
        let kept = model.count();
        let (modes, size) = (motion.modes().count(), kept + 1);
        check(tied.parts.len() >= modes * size, "modes of the motion", modes as f64, "", "those of this helix")?;
        let forces = motion.end_forces(times)?;
        let [first, second] = [End::One, End::Two].map(|end| motion.excitation().input(end));
        let [u, force] = [first, second].map(|input| input.displacements(times));
        let acceleration = of_each(times, first, EndInput::acceleration);
        let compliance = 1.0 / motion.spring().stiffness();
        let series = |end: End, axial: Vec<f64>| -> Result<ReactionSeries, Error> {
            let (at, sign) = if end == End::One { (0, 1.0) } else { (1, -1.0) };
            let slow = &self.slow[at];
            let component = |i: usize| -> Result<Vec<f64>, Error> {
                let own: Vec<f64> = self.modes[at].iter().map(|mode| mode[i]).collect();
                let left = [0, 1].map(|moved| slow[moved].mass[i] - carried(model, &own, moved, 1));
                let of_mode = |(parts, frequency): (&[f64], &f64)| {
                    let swings = parts[..kept].iter().zip(&own).map(|(part, own)| part * own).sum::<f64>();
                    swings + parts[kept] * (slow[1].rest[i] + left[1] * frequency * frequency)
                };
                let frequencies = motion.modes().frequencies();
                let weights: Vec<f64> = tied.parts.chunks_exact(size).zip(frequencies).map(of_mode).collect();
                let mut sums = motion.modal_sums(times, &[weights])?.pop().unwrap_or_default();
                let rigid = slow[0].rest[i] + slow[1].rest[i];
                let mean = if i == 5 { sign * self.couple } else { 0.0 };
                for (sample, sum) in sums.iter_mut().enumerate() {
                    *sum += mean + rigid * u[sample] + compliance * slow[1].rest[i] * force[sample]
                        - (left[0] + tied.dragged * left[1]) * acceleration[sample];
                }
                Ok(sums)
            };
            let axial = axial.into_iter().map(|force| sign * force).collect();
            let couple = [component(3)?, component(4)?, component(5)?];
            Ok(ReactionSeries { force: [component(0)?, component(1)?, axial], couple })
        };
        Ok([series(End::One, forces.input)?, series(End::Two, forces.output)?])
    }
}

/// Σ_j r_j c_j/ω_j² of an end that moves, or with ω_j⁴ in the second term: what the modes that are there carry along of the inertia.
fn carried(model: &ModalModel, weights: &[f64], moved: usize, term: i32) -> f64 {
    let [first, second] = model.participations();
    let each = model.frequencies().iter().zip(if moved == 0 { first } else { second }).zip(weights);
    each.map(|((frequency, part), weight)| weight * part / frequency.powi(2 * term)).sum()
}

fn of_each(times: &[f64], input: &EndInput, derivative: fn(&EndInput, f64) -> f64) -> Vec<f64> {
    times.iter().map(|&time| derivative(input, time)).collect()
}
