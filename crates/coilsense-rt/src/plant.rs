//! The spring itself, step by step: its modes turned exactly, its ends moving straight from sample to sample.
//!
//! Next door: what it is made of (`plant_settings`), how near its windings are (`plant_windings`), what their inductance tells (`plant_coil`), an
//! observer of it (`kalman`).

use crate::plant_settings::FarEnd;
use crate::real::Real;

/// What a step does to one mode: q \[m\], how far it is from the line between the ends, and P = q̇/ω + c·u̇/ω, how fast it is over ω.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turn<T> {
    /// r₀, r₁: whole quarter turns.
    pub quarters: [T; 2],
    /// 1 − r₀.
    pub dragged: T,
    /// a, b, d: what is left of the turn.
    pub rest: [T; 3],
    /// What makes up for rounding every so many steps.
    pub mend: [[T; 2]; 2],
    /// c/ωh: what the ends' way during a step is of P.
    pub line: [T; 2],
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
/// (q, p)' = M (q, P − g), P' = p' + g, g = c·(u − u')/ωh, F = k (stretch + u2 − u1) + Σ w_j (q_j + βω_j p_j); P − g = p = q̇/ω
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
    steps: u32,
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
        PlantState { modes: [[T::ZERO; 2]; MODES], inputs, moved: [T::ZERO; 2], steps: 0 }
    }

    /// Takes u1 \[m\], and u2 \[m\] or the force at end 2 \[N\], and gives the forces at this sample.
    #[inline]
    pub fn step(&self, state: &mut PlantState<T, MODES>, inputs: [T; 2]) -> PlantOutput<T> {
        let moved = [inputs[0] - state.inputs[0], inputs[1] - state.inputs[1]];
        (state.inputs, state.moved) = (inputs, moved);
        let (mut input, mut output) = (T::ZERO, T::ZERO);
        for (mode, place) in self.modes.iter().zip(&mut state.modes) {
            *place = mode.turned(*place, moved);
            input = input + mode.weights[0] * place[0];
            output = output + mode.weights[1] * place[0];
        }
        if self.has_dashpots {
            for (mode, place) in self.modes.iter().zip(&state.modes) {
                let rate = place[1] - mode.dragged_along(moved);
                input = input + mode.rates[0] * rate;
                output = output + mode.rates[1] * rate;
            }
        }
        if T::STEPS_TO_MEND > 0 {
            self.mend(state);
        }
        let [still, deflection, end] = self.ends(state, inputs);
        PlantOutput { input: still + input, output: still + output, deflection, end }
    }

    /// Makes up for the rounding of coefficients, every so many steps.
    #[inline]
    fn mend(&self, state: &mut PlantState<T, MODES>) {
        state.steps += 1;
        if state.steps < T::STEPS_TO_MEND {
            return;
        }
        state.steps = 0;
        for (mode, place) in self.modes.iter().zip(&mut state.modes) {
            let [position, rate] = [place[0], place[1] - mode.dragged_along(state.moved)];
            let [[a, b], [c, d]] = mode.mend;
            *place = [place[0] + (a * position + b * rate), place[1] + (c * position + d * rate)];
        }
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

impl<T: Real, const MODES: usize> Plant<T, MODES> {
    /// How much further apart the ends are than where all inputs are zero \[m\].
    #[inline]
    pub(crate) fn longer(&self, state: &PlantState<T, MODES>) -> T {
        let [_, _, end] = self.ends(state, state.inputs);
        end - state.inputs[0]
    }

    /// The force \[N\] of the spring without mass, so much longer than where all inputs are zero.
    #[inline]
    pub(crate) fn force_at(&self, longer: T) -> T {
        self.preload + self.stiffness * longer
    }

    /// k \[N/m\].
    #[inline]
    pub(crate) fn stiffness(&self) -> T {
        self.stiffness
    }
}

impl<T: Real, const MODES: usize> PlantState<T, MODES> {
    /// Σ_j w_j q_j.
    #[inline]
    pub(crate) fn sum(&self, weights: &[T; MODES]) -> T {
        let mut sum = T::ZERO;
        for (place, weight) in self.modes.iter().zip(weights) {
            sum = sum + *weight * place[0];
        }
        sum
    }
}

impl<T: Real> Turn<T> {
    /// Of a mode that does nothing.
    pub(crate) const STILL: Self = {
        let none = [T::ZERO; 2];
        let (quarters, rest, mend) = ([T::ONE, T::ZERO], [T::ZERO; 3], [none; 2]);
        let (line, weights, rates) = (none, none, none);
        Self { quarters, dragged: T::ZERO, rest, mend, line, weights, rates, end: T::ZERO }
    };

    /// g: what the way of the ends during a step is of P.
    #[inline]
    fn dragged_along(&self, moved: [T; 2]) -> T {
        self.line[0] * moved[0] + self.line[1] * moved[1]
    }

    /// The mode a step later.
    #[inline]
    fn turned(&self, [position, pace]: [T; 2], moved: [T; 2]) -> [T; 2] {
        let line = self.dragged_along(moved);
        let rate = pace - line;
        let ([r0, r1], [a, b, d]) = (self.quarters, self.rest);
        let gained = a * position + b * rate;
        let faded = d * rate - b * position;
        [(r0 * position + r1 * rate) + gained, (r0 * pace - r1 * position) + (faded + self.dragged * line)]
    }
}
