//! A bank of observers over a tolerance box: the one that is surprised least is believed most.
//!
//! Next door: the single observer (`kalman`).

use crate::kalman::{Estimate, KalmanState, Measured, ModalKalman};
use crate::real::Real;

/// `MEMBERS` filters of springs over the box; their estimates weighted by how little each has been surprised of late.
///
/// J_i' = J_i + g (e_i² − J_i), w_i = max(0, 1 − s (J_i − min J)/256)^256 ≈ exp(−s (J_i − min J)), F = Σ w_i F_i / Σ w_i
///
/// - `members`: the filters; `forgetting`: g \[1\], above 0 and at most 1; `sharpness`: s \[1/N²\], zero or above
///
/// Source:   `[Simon2006]` section 10.2, multiple-model estimation, with a memory that fades.
/// Valid:    one of the members near the true spring.
/// Accuracy: the weight of a member as far off as s ΔJ = 5 is 5 % below the exponential; weights add up to 1 but for rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bank<T, const MODES: usize, const MEMBERS: usize> {
    /// One for each spring.
    pub members: [ModalKalman<T, MODES>; MEMBERS],
    /// g \[1\].
    pub forgetting: T,
    /// s \[1/N²\].
    pub sharpness: T,
}

/// What a [`Bank`] remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BankState<T, const MODES: usize, const MEMBERS: usize> {
    members: [KalmanState<T, MODES>; MEMBERS],
    scores: [T; MEMBERS],
}

impl<T: Real, const MODES: usize, const MEMBERS: usize> Bank<T, MODES, MEMBERS> {
    /// The same with every number changed, into another precision.
    pub fn map<U>(&self, change: impl Fn(T) -> U + Copy) -> Bank<U, MODES, MEMBERS> {
        Bank {
            members: self.members.map(|member| member.map(change)),
            forgetting: change(self.forgetting),
            sharpness: change(self.sharpness),
        }
    }

    /// The state of a spring at rest on which this is measured.
    pub fn settled(&self, measured: &Measured<T>) -> BankState<T, MODES, MEMBERS> {
        BankState { members: self.members.map(|member| member.settled(measured)), scores: [T::ZERO; MEMBERS] }
    }

    /// Takes F_i, u1 and u2 in and gives both end forces; the surprise is the weighted mean of the members'.
    pub fn step(&self, state: &mut BankState<T, MODES, MEMBERS>, measured: &Measured<T>) -> Estimate<T> {
        let none = Estimate { input: T::ZERO, output: T::ZERO, surprise: T::ZERO };
        let mut estimates = [none; MEMBERS];
        let mut least = None;
        let runs = self.members.iter().zip(&mut state.members).zip(&mut state.scores).zip(&mut estimates);
        for (((member, memory), score), estimate) in runs {
            *estimate = member.step(memory, measured);
            *score = *score + self.forgetting * (estimate.surprise * estimate.surprise - *score);
            least = Some(match least {
                Some(least) if least < *score => least,
                _ => *score,
            });
        }
        let least = least.unwrap_or(T::ZERO);
        let (mut total, mut sum) = (T::ZERO, none);
        for (estimate, score) in estimates.iter().zip(&state.scores) {
            let weight = fading(self.sharpness * (*score - least));
            total = total + weight;
            sum.input = sum.input + weight * estimate.input;
            sum.output = sum.output + weight * estimate.output;
            sum.surprise = sum.surprise + weight * estimate.surprise;
        }
        Estimate { input: sum.input / total, output: sum.output / total, surprise: sum.surprise / total }
    }
}

/// max(0, 1 − x/256)^256, near e^(−x) for x from 0 on.
#[inline]
fn fading<T: Real>(x: T) -> T {
    let base = T::ONE - x * T::TWO_TO_MINUS_8;
    if base > T::ZERO { (0..8).fold(base, |power, _| power * power) } else { T::ZERO }
}
