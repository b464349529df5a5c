//! Settings of a bank of observers over the tolerance box.
//!
//! Next door: one of them (`kalman`), the box (`tolerance`).

use coilsense_rt::{Bank, ModalKalman};

use super::kalman::{KalmanNoise, modal_kalman};
use super::sampled_spring::SampledSpring;
use super::tolerance::ToleranceBox;
use crate::error::{Error, above_zero, check};

/// How a bank is laid out and how it decides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BankDesign {
    /// What each member is to expect.
    pub noise: KalmanNoise,
    /// Over how long surprises are averaged \[s\], at least one sample.
    pub memory: f64,
    /// s σ², how strongly a member that is surprised more than the others is disbelieved \[1\], above zero: half the samples of the
    /// memory is what chance asks for.
    pub sharpness: f64,
}

/// `MEMBERS` filters of `MODES` modes, on springs that share k and differ in f1, spread evenly over the box; an odd number keeps the nominal
/// one.
///
/// Stiffness off is bias, which each member has; frequency off is what no single member can follow.
///
/// Source:   [`Bank`].
/// Valid:    the true f1 within half a spacing of a member: (f_max − f_min)/(`MEMBERS` − 1).
/// Accuracy: that of the nearest member, once the memory holds a few surge periods.
///
/// # Errors
/// [`Error::Value`] for fewer than two members, memory or sharpness outside of what is allowed, and as [`modal_kalman`].
pub fn observer_bank<const MODES: usize, const MEMBERS: usize>(
    spring: &SampledSpring,
    tolerances: &ToleranceBox,
    design: &BankDesign,
) -> Result<Bank<f64, MODES, MEMBERS>, Error> {
    check(MEMBERS >= 2, "members of the bank", MEMBERS as f64, "", "at least 2")?;
    above_zero("sharpness of the bank", design.sharpness, "")?;
    let samples = design.memory * spring.rate();
    check(samples >= 1.0, "memory of the bank", design.memory, "s", format!("at least {} s", 1.0 / spring.rate()))?;
    let [lowest, highest] = tolerances.frequency_factors();
    let place = |index: usize| index as f64 / (MEMBERS - 1) as f64;
    // Around the nominal in the middle, evenly to either side.
    let factor = |index: usize| {
        let place = 2.0 * place(index) - 1.0;
        if place < 0.0 { 1.0 + place * (1.0 - lowest) } else { 1.0 + place * (highest - 1.0) }
    };
    let members = (0..MEMBERS)
        .map(|index| {
            let mass = factor(index).powi(-2) - 1.0;
            let member = spring.on(&ToleranceBox::changed(spring.spring(), [0.0, mass])?)?;
            modal_kalman(&member, &design.noise)
        })
        .collect::<Result<Vec<ModalKalman<f64, MODES>>, Error>>()?;
    let mut places = members.into_iter();
    let first = modal_kalman(spring, &design.noise)?;
    Ok(Bank {
        members: std::array::from_fn(|_| places.next().unwrap_or(first)),
        forgetting: 1.0 / samples,
        sharpness: design.sharpness / (design.noise.force * design.noise.force),
    })
}
