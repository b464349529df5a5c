//! Whether the budget's interval is that of the Monte Carlo run: the test of whether first order is enough.
//!
//! Next door: the two that it compares (`budget`, `monte_carlo`).

use super::{Budget, MonteCarlo, probability};
use crate::error::{Error, called, check};

/// How far the budget's interval is from the Monte Carlo run's, in the output's unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// d_low = |y − U − y_low|.
    pub low: f64,
    /// d_high = |y + U − y_high|.
    pub high: f64,
    /// δ: half a unit of the last digit that counts.
    pub tolerance: f64,
    /// How far chance alone may have moved an end of the run's interval: two standard deviations.
    pub chance: f64,
}

impl Agreement {
    /// Whether both ends agree: the budget is validated.
    pub fn holds(&self) -> bool {
        self.low <= self.tolerance && self.high <= self.tolerance
    }

    /// Whether the run was long enough to judge: chance alone would not turn the verdict. `[JCGM101]` 8.2 asks for chance below δ/5
    /// whatever the verdict is, which takes far more trials where the two are far apart.
    pub fn decided(&self) -> bool {
        (self.low.max(self.high) - self.tolerance).abs() > self.chance
    }
}

impl MonteCarlo {
    /// Compares the interval of a `budget` of the same model with the run's, at 95 %; see [`Self::agrees_at`].
    ///
    /// ```
    /// use coilsense::uncertainty::{Budget, Distribution, Input, MonteCarlo};
    ///
    /// // At the apex of a square first order sees nothing, and the run says so.
    /// let inputs = [Input::new("x", 0.0, Distribution::Normal { standard: 1.0 })];
    /// let square = |x: &[f64]| x[0] * x[0];
    /// let agreement = MonteCarlo::run(square, &inputs, 100_000, 1)?.agrees_with(&Budget::of(square, &inputs)?, 2)?;
    /// assert!(agreement.decided() && !agreement.holds());
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::agrees_at`].
    pub fn agrees_with(&self, budget: &Budget, significant_digits: u32) -> Result<Agreement, Error> {
        self.agrees_at(0.95, budget, significant_digits)
    }

    /// Compares the interval of a `budget` of the same model with the run's, at a `coverage` p.
    ///
    /// d_low = |y − U_p − y_low|, d_high = |y + U_p − y_high|, δ = ½ 10^l where u_c = c · 10^l with c of so many digits
    ///
    /// - `significant_digits`: of the standard uncertainty, 1 to 15; 2 as a rule
    ///
    /// Source:   `[JCGM101]` 8.1, 7.9.2 (tolerance), 8.2 (length of the run).
    /// Valid:    y is the budget's corrected estimate; where u_c is zero, at an apex, δ is that of the run's standard deviation.
    /// Accuracy: that of chance, stated in [`Agreement::chance`].
    /// Differs:  8.1 leaves open which interval of the run; here it is the symmetric one, whose ends chance moves least.
    ///
    /// # Errors
    /// [`Error::Value`] for a coverage that is not between 0 and 1, or digits out of range.
    pub fn agrees_at(&self, coverage: f64, budget: &Budget, significant_digits: u32) -> Result<Agreement, Error> {
        let digits = f64::from(significant_digits);
        check((1.0..=15.0).contains(&digits), called("digits", "significant digits"), digits, "", "from 1 to 15")?;
        let (low, high) = self.symmetric(coverage)?;
        let expanded = budget.expanded(coverage)?;
        let standard = if budget.combined() > 0.0 { budget.combined() } else { self.standard() };
        Ok(Agreement {
            low: (budget.corrected() - expanded - low).abs(),
            high: (budget.corrected() + expanded - high).abs(),
            tolerance: tolerance(standard, significant_digits),
            chance: self.chance(coverage)?,
        })
    }

    /// Two standard deviations of the ends of the symmetric interval: the number of outputs below an end is binomial.
    fn chance(&self, coverage: f64) -> Result<f64, Error> {
        let trials = self.outputs().len() as f64;
        let tail = 0.5 * (1.0 - probability(coverage)?);
        let spread = 2.0 * (trials * tail * (1.0 - tail)).sqrt();
        let output = |rank: f64| self.outputs()[rank.clamp(0.0, trials - 1.0) as usize];
        let moved = |rank: f64| 0.5 * (output(rank + spread) - output(rank - spread));
        Ok(moved(trials * tail).max(moved(trials * (1.0 - tail))))
    }
}

/// δ = ½ 10^l of a value written as c · 10^l with so many digits; zero for zero.
fn tolerance(value: f64, digits: u32) -> f64 {
    // Written out, so that 9.96 with two digits becomes 10 as it does on paper.
    let written = format!("{value:.*e}", digits as usize - 1);
    let power = written.split_once('e').and_then(|(_, power)| power.parse::<i32>().ok());
    power.map_or(0.0, |power| if value > 0.0 { 0.5 * 10_f64.powi(power + 1 - digits as i32) } else { 0.0 })
}
