//! The spring itself, step by step: its modes turned exactly, its ends moving straight from sample to sample.
//!
//! Next door: what it is made of (`plant_settings`), an observer of it (`kalman`).

use crate::plant_settings::FarEnd;
use crate::real::Real;

/// What a step does to one mode (q, q̇/ω).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turn<T> {
    /// What q gains of q, of q̇/ω (and q̇/ω loses of q), and what q̇/ω gains of itself \[1\]; each with what its rounding leaves.
    pub keep: [T; 2],
    pub cross: [T; 2],
    pub fade: [T; 2],
    /// What a bend of each input, u(t) − 2u(t−h) + u(t−2h), adds to q̇/ω at the beginning of a step.
    pub kick: [T; 2],
    /// F_i and F_o per q \[N/m\].
    pub weights: [T; 2],
    /// F_i and F_o per q̇/ω \[N/m\].
    pub rates: [T; 2],
    /// u2 per q \[1\].
    pub end: T,
}

/// A spring on its mount in `MODES` modes, ready to be stepped; [`crate::PlantSettings::plant`] makes it.
///
/// Inputs, counted from their means, run straight from the last sample to this one: with an input that is read now, a step is exact at the
/// sample; what an input that is held between samples does to the spring is another motion, in which every sample hits all modes.
///
/// p += K (u − 2u' + u''), (q, p) += E (q, p), F = k (stretch + u2 − u1) + Σ w_j (q_j + βω_j p_j), p = q̇/ω
///
/// Where damping is that of dashpots, forces jump with an end's velocity: those told are from just before a sample.
///
/// Source:   `coilsense::Motion`, of which it is a step.
/// Valid:    linear; windings that do not touch, ends that are not lifted. An input of this very sample is needed for its forces.
/// Accuracy: 1e-10 of the peak in `f64`, 1e-4 in `f32`, over 10⁵ steps (`coilsense`, `tests/plant.rs`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plant<T, const MODES: usize> {
    pub(crate) stiffness: T,
    pub(crate) compliance: T,
    pub(crate) preload: T,
    pub(crate) far_end: FarEnd,
    pub(crate) has_dashpots: bool,
    pub(crate) modes: [Turn<T>; MODES],
}

/// What a [`Plant`] remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlantState<T, const MODES: usize> {
    modes: [[T; 2]; MODES],
    inputs: [T; 2],
    moved: [T; 2],
}

/// What a [`Plant`] gives; forces are tension-positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlantOutput<T> {
    /// F_i \[N\], at end 1.
    pub input: T,
    /// F_o \[N\], at end 2.
    pub output: T,
    /// F_x \[N\]: what a sensor of the ends' distance makes of it.
    pub deflection: T,
    /// u2 \[m\], from its mean.
    pub end: T,
}

impl<T: Real, const MODES: usize> Plant<T, MODES> {
    /// The state of a spring at rest under inputs that have been there for ever; zeros are the mean length.
    pub fn settled(&self, inputs: [T; 2]) -> PlantState<T, MODES> {
        PlantState { modes: [[T::ZERO; 2]; MODES], inputs, moved: [T::ZERO; 2] }
    }

    /// Takes u1 \[m\], and u2 \[m\] or the force at end 2 \[N\], and gives the forces at this sample.
    #[inline]
    pub fn step(&self, state: &mut PlantState<T, MODES>, inputs: [T; 2]) -> PlantOutput<T> {
        let moved = [inputs[0] - state.inputs[0], inputs[1] - state.inputs[1]];
        let bends = [moved[0] - state.moved[0], moved[1] - state.moved[1]];
        (state.inputs, state.moved) = (inputs, moved);
        let (mut input, mut output) = (T::ZERO, T::ZERO);
        for (mode, place) in self.modes.iter().zip(&mut state.modes) {
            *place = mode.turned(*place, bends);
            input = input + mode.weights[0] * place[0];
            output = output + mode.weights[1] * place[0];
        }
        if self.has_dashpots {
            for (mode, place) in self.modes.iter().zip(&state.modes) {
                input = input + mode.rates[0] * place[1];
                output = output + mode.rates[1] * place[1];
            }
        }
        let [still, deflection, end] = self.ends(state, inputs);
        PlantOutput { input: still + input, output: still + output, deflection, end }
    }

    /// Force of a spring without mass, F_x, and u2.
    #[inline]
    fn ends(&self, state: &PlantState<T, MODES>, [first, second]: [T; 2]) -> [T; 3] {
        if self.far_end == FarEnd::Position {
            let still = self.preload + self.stiffness * (second - first);
            return [still, still, second];
        }
        let mut swing = T::ZERO;
        for (mode, place) in self.modes.iter().zip(&state.modes) {
            swing = swing + mode.end * place[0];
        }
        let still = self.preload + second;
        [still, still + self.stiffness * swing, first + self.compliance * second + swing]
    }
}

impl<T: Real> Turn<T> {
    /// Of a mode that does nothing.
    pub(crate) const STILL: Self = {
        let none = [T::ZERO; 2];
        Self { keep: none, cross: none, fade: none, kick: none, weights: none, rates: none, end: T::ZERO }
    };

    /// The mode a step later, kicked at its beginning.
    #[inline]
    fn turned(&self, [position, swing]: [T; 2], bends: [T; 2]) -> [T; 2] {
        let swing = swing + self.kick[0] * bends[0] + self.kick[1] * bends[1];
        let mut gained = self.keep[0] * position + self.cross[0] * swing;
        let mut faded = self.fade[0] * swing - self.cross[0] * position;
        if T::IS_SINGLE {
            gained = gained + (self.keep[1] * position + self.cross[1] * swing);
            faded = faded + (self.fade[1] * swing - self.cross[1] * position);
        }
        [position + gained, swing + faded]
    }
}
