//! Settings of a bank of observers over the tolerance box.
//!
//! Next door: one of them (`kalman`), the box (`tolerance`).

use coilsense_rt::{Bank, ModalKalman};

use super::kalman::{KalmanNoise, modal_kalman};
use super::sampled_spring::SampledSpring;
use super::tolerance::ToleranceBox;
use crate::error::{Error, above_zero, called, check};

/// How a bank is laid out and how it decides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BankDesign {
    /// What each member is to expect.
    pub noise: KalmanNoise,
    /// How many stiffnesses the members stand for, 1 for the nominal one; each has the same first surge frequencies.
    pub stiffnesses: usize,
    /// Over how long surprises are averaged \[s\], at least one sample.
    pub memory: f64,
    /// s σ², how strongly a member that is surprised more than the others is disbelieved \[1\], above zero: chance asks for half the samples of
    /// the memory.
    pub sharpness: f64,
}

/// `MEMBERS` filters of `MODES` modes on springs spread evenly over the box of k and f1; odd numbers of either keep the nominal one.
///
/// Source:   [`Bank`].
/// Valid:    the true spring within half a spacing of a member; what k is off beyond that is bias, which each member has.
/// Accuracy: that of the nearest member, once the memory holds a few surge periods.
///
/// # Errors
/// [`Error::Value`] for members that are no multiple of the stiffnesses or fewer than two frequencies to each, memory or sharpness outside of what
/// is allowed, and as [`modal_kalman`].
pub fn observer_bank<const MODES: usize, const MEMBERS: usize>(
    spring: &SampledSpring,
    tolerances: &ToleranceBox,
    design: &BankDesign,
) -> Result<Bank<f64, MODES, MEMBERS>, Error> {
    let rows = design.stiffnesses;
    let fits = rows >= 1 && MEMBERS.is_multiple_of(rows) && MEMBERS / rows >= 2;
    let allowed = format!("1 or more, so that {MEMBERS} members have two frequencies or more at each");
    check(fits, called("stiffnesses", "stiffnesses of the bank"), rows as f64, "", allowed)?;
    above_zero(called("sharpness", "sharpness of the bank"), design.sharpness, "")?;
    let samples = design.memory * spring.rate();
    check(
        samples >= 1.0,
        called("memory", "memory of the bank"),
        design.memory,
        "s",
        format!("at least {} s", 1.0 / spring.rate()),
    )?;
    let members = (0..MEMBERS)
        .map(|index| {
            let corner = corner(tolerances, index / (MEMBERS / rows), rows, index % (MEMBERS / rows), MEMBERS / rows);
            modal_kalman(&spring.on(&ToleranceBox::changed(spring.spring(), corner)?)?, &design.noise)
        })
        .collect::<Result<Vec<ModalKalman<f64, MODES>>, Error>>()?;
    let mut places = members.into_iter();
    let nominal = modal_kalman(spring, &design.noise)?;
    Ok(Bank {
        members: std::array::from_fn(|_| places.next().unwrap_or(nominal)),
        forgetting: 1.0 / samples,
        sharpness: design.sharpness / (design.noise.force * design.noise.force),
    })
}

/// Δk/k and Δm/m of the member in row `row` of `rows` (stiffness) and column `column` of `columns` (frequency).
fn corner(tolerances: &ToleranceBox, row: usize, rows: usize, column: usize, columns: usize) -> [f64; 2] {
    // From −1 to 1, the middle exactly 0.
    let place = |index: usize, count: usize| (2.0 * index as f64 + 1.0 - count as f64) / (count.max(2) - 1) as f64;
    let [lowest, highest] = tolerances.frequency_factors();
    let aside = place(column, columns);
    let frequency = if aside < 0.0 { 1.0 + aside * (1.0 - lowest) } else { 1.0 + aside * (highest - 1.0) };
    let stiffness = 1.0 + tolerances.stiffness() * place(row, rows);
    [stiffness - 1.0, stiffness / (frequency * frequency) - 1.0]
}
