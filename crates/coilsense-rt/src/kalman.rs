//! The force at either end by modes: a steady-state Kalman filter of a few surge modes and of a bias of the force.
//!
//! Next door: several of them over a tolerance box (`bank`), the same by waves (`delay_line`), the gains (`coilsense::mitigation`).

use crate::real::Real;

/// What the controller reads in one sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured<T> {
    /// F_i \[N\].
    pub force: T,
    /// u1, u2 \[m\].
    pub ends: [T; 2],
}

/// What is made of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate<T> {
    /// F_i \[N\], cleaned of noise.
    pub input: T,
    /// F_o \[N\].
    pub output: T,
    /// What was measured less what was predicted \[N\]: white and small where the model fits.
    pub surprise: T,
}

/// One mode (q, q̇/ω) over one sample; q in any unit, such as the force that it adds to F_i.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode<T> {
    /// (q, q̇/ω) after a sample from those before: rows \[1\].
    pub turn: [[T; 2]; 2],
    /// What a jump of velocity of each end adds to q̇/ω \[unit of q per m/s\].
    pub kick: [T; 2],
    /// F_i per q \[N per unit of q\].
    pub input: T,
    /// F_o per q \[N per unit of q\].
    pub output: T,
    /// What a surprise adds to (q, q̇/ω) \[unit of q per N\].
    pub gain: [T; 2],
}

/// Steady-state Kalman filter of `MODES` modes and a force bias.
///
/// q' = Φ (q + B Δv), F_x = k (u2 − u1 − l0), e = F − (F_x + b + Σ h_j q_j), q += K e, b += K_b e, F_o = F_x + b + Σ g_j q_j
///
/// - `stiffness`: k \[N/m\]; `rest_length`: l0 \[m\]; `rate`: the sampling rate \[1/s\]
/// - `modes`: Φ, B, h, g, K of each; `bias_gain`: K_b \[1\]
///
/// Source:   `[Simon2006]` section 7.3; modes as `coilsense::modes::ChainModes`, ends moving straight between samples.
/// Valid:    a linear spring near k, m; the bias takes an offset of F_i, and a wrong k as long as forces move slowly.
/// Accuracy: with all modes and no noise equal to the exact motion at the samples; gains 1e-9 relative, against SciPy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModalKalman<T, const MODES: usize> {
    /// k \[N/m\].
    pub stiffness: T,
    /// l0 \[m\].
    pub rest_length: T,
    /// Sampling rate \[1/s\].
    pub rate: T,
    /// K_b \[1\].
    pub bias_gain: T,
    /// Lowest first.
    pub modes: [Mode<T>; MODES],
}

/// What a [`ModalKalman`] remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KalmanState<T, const MODES: usize> {
    modes: [[T; 2]; MODES],
    bias: T,
    ends: [T; 2],
    velocities: [T; 2],
}

impl<T: Real, const MODES: usize> ModalKalman<T, MODES> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U + Copy) -> ModalKalman<U, MODES> {
        ModalKalman {
            stiffness: change(self.stiffness),
            rest_length: change(self.rest_length),
            rate: change(self.rate),
            bias_gain: change(self.bias_gain),
            modes: self.modes.map(|mode| mode.map(change)),
        }
    }

    /// The state of a spring at rest on which this is measured: what k does not explain of the force is taken for bias.
    pub fn settled(&self, measured: &Measured<T>) -> KalmanState<T, MODES> {
        let bias = measured.force - self.static_force(measured.ends);
        KalmanState { modes: [[T::ZERO; 2]; MODES], bias, ends: measured.ends, velocities: [T::ZERO; 2] }
    }

    #[inline]
    fn static_force(&self, [first, second]: [T; 2]) -> T {
        self.stiffness * (second - first - self.rest_length)
    }

    /// Takes F_i, u1 and u2 in and gives both end forces.
    #[inline]
    pub fn step(&self, state: &mut KalmanState<T, MODES>, measured: &Measured<T>) -> Estimate<T> {
        let jumps = self.jumps(state, measured.ends);
        let still = self.static_force(measured.ends) + state.bias;
        let mut predicted = still;
        for (mode, place) in self.modes.iter().zip(&mut state.modes) {
            *place = mode.turned(*place, jumps);
            predicted = predicted + mode.input * place[0];
        }
        let surprise = measured.force - predicted;
        state.bias = state.bias + self.bias_gain * surprise;
        let still = still + self.bias_gain * surprise;
        let (mut input, mut output) = (still, still);
        for (mode, place) in self.modes.iter().zip(&mut state.modes) {
            *place = [place[0] + mode.gain[0] * surprise, place[1] + mode.gain[1] * surprise];
            input = input + mode.input * place[0];
            output = output + mode.output * place[0];
        }
        Estimate { input, output, surprise }
    }

    /// How much faster the ends go now than a sample ago \[m/s\].
    #[inline]
    fn jumps(&self, state: &mut KalmanState<T, MODES>, ends: [T; 2]) -> [T; 2] {
        let velocities = [self.rate * (ends[0] - state.ends[0]), self.rate * (ends[1] - state.ends[1])];
        let jumps = [velocities[0] - state.velocities[0], velocities[1] - state.velocities[1]];
        (state.ends, state.velocities) = (ends, velocities);
        jumps
    }
}

impl<T: Real> Mode<T> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U + Copy) -> Mode<U> {
        Mode {
            turn: self.turn.map(|row| row.map(change)),
            kick: self.kick.map(change),
            input: change(self.input),
            output: change(self.output),
            gain: self.gain.map(change),
        }
    }

    /// The mode a sample later, kicked at its beginning.
    #[inline]
    fn turned(&self, [position, swing]: [T; 2], jumps: [T; 2]) -> [T; 2] {
        let swing = swing + self.kick[0] * jumps[0] + self.kick[1] * jumps[1];
        let [[a, b], [c, d]] = self.turn;
        [a * position + b * swing, c * position + d * swing]
    }
}
