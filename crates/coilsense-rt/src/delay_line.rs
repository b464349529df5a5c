//! The force at end 2 by waves: what leaves end 1 arrives at end 2 one transit time later.
//!
//! Next door: the same by modes (`kalman`).

use crate::delay::{Delay, Ring};
use crate::kalman::Measured;
use crate::real::Real;

/// Two delay lines of one transit time τ each, fed by both ends' velocities and put right by the measured F_i.
///
/// F_i = L − Z v1, L the wave that arrives at end 1; measured, L is put right by g (F − F_i);
/// what leaves end 1, R = F_i − Z v1, arrives at end 2 after τ: F_o = R(t − τ) + Z v2, and L(t + τ) = F_o + Z v2.
/// On each way a share λ of what departs from the static force k (u2 − u1 − l0) is lost; what the force
/// was off that at rest, at the beginning, counts as static.
///
/// - `stiffness`: k \[N/m\]; `rest_length`: l0 \[m\]; `impedance`: Z = √(k m) \[N s/m\]
/// - `transit`: τ \[samples\], at least 1, at most two less than the rings hold; `rate`: the sampling rate \[1/s\]
/// - `gain`: g \[1\], from 0 (a simulation) to 1 (F_i is taken as it is read); `loss`: λ \[1\], from 0 to 1
///
/// Source:   d'Alembert's solution of the wave equation with F = k ∂u/∂x, Z = k τ; the gain is an observer's.
/// Valid:    a uniform coil whose windings do not touch; λ stands for damping of the first mode, e^(−πζ) = 1 − λ.
/// Accuracy: exact for τ of whole samples and ends that do not move; else [`Delay`]'s, and velocities by backward differences.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DelayLineObserver<T> {
    /// k \[N/m\].
    pub stiffness: T,
    /// l0 \[m\].
    pub rest_length: T,
    /// Z \[N s/m\].
    pub impedance: T,
    /// Sampling rate \[1/s\].
    pub rate: T,
    /// τ \[samples\].
    pub transit: Delay<T>,
    /// g \[1\].
    pub gain: T,
    /// λ \[1\].
    pub loss: T,
}

/// What a [`DelayLineObserver`] remembers: the waves on their way, `N` samples each, where the ends were, and by
/// what the force at rest was off k (u2 − u1 − l0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DelayLineState<T, const N: usize> {
    rightward: Ring<T, N>,
    leftward: Ring<T, N>,
    ends: [T; 2],
    offset: T,
}

impl<T: Real> DelayLineObserver<T> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U) -> DelayLineObserver<U> {
        DelayLineObserver {
            stiffness: change(self.stiffness),
            rest_length: change(self.rest_length),
            impedance: change(self.impedance),
            rate: change(self.rate),
            transit: self.transit.map(&change),
            gain: change(self.gain),
            loss: change(self.loss),
        }
    }

    /// The state of a spring at rest on which this is measured.
    pub fn settled<const N: usize>(&self, measured: &Measured<T>) -> DelayLineState<T, N> {
        let still = Ring::filled(measured.force);
        let offset = measured.force - self.static_force(measured.ends);
        DelayLineState { rightward: still, leftward: still, ends: measured.ends, offset }
    }

    /// Takes F_i, u1 and u2 in and gives F_o \[N\].
    #[inline]
    pub fn step<const N: usize>(&self, state: &mut DelayLineState<T, N>, measured: &Measured<T>) -> T {
        let [first, second] = measured.ends;
        let [before1, before2] = state.ends;
        let (push1, push2) = (self.swing(first - before1), self.swing(second - before2));
        state.ends = measured.ends;
        let resting = self.static_force(measured.ends) + state.offset;
        // The rings' last push was one step ago.
        let back = Delay { whole: self.transit.whole.saturating_sub(1), fraction: self.transit.fraction };
        let predicted = state.leftward.delayed(&back) - push1;
        let force = predicted + self.gain * (measured.force - predicted);
        let output = state.rightward.delayed(&back) + push2;
        state.rightward.push(self.worn(force - push1, resting));
        state.leftward.push(self.worn(output + push2, resting));
        output
    }

    /// Z v for a way in one sample.
    #[inline]
    fn swing(&self, way: T) -> T {
        self.impedance * (self.rate * way)
    }

    /// What is left of a wave at the other end.
    #[inline]
    fn worn(&self, wave: T, resting: T) -> T {
        wave - self.loss * (wave - resting)
    }

    #[inline]
    fn static_force(&self, [first, second]: [T; 2]) -> T {
        self.stiffness * (second - first - self.rest_length)
    }
}
