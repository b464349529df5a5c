//! The budget: what each input contributes to the uncertainty of a model's output, to first order.
//!
//! Next door: the factor of a coverage (`student`), the same by Monte Carlo (`monte_carlo`), whether the two agree (`agreement`).

use std::borrow::Cow;

use super::{Input, coverage_factor, evaluate, probability};
use crate::error::{Error, at_least_one, check};

/// What one input contributes.
#[derive(Debug, Clone, PartialEq)]
pub struct Contribution {
    /// The input's name.
    pub name: Cow<'static, str>,
    /// x: the input's estimate, in its own unit.
    pub estimate: f64,
    /// u(x), in the input's unit.
    pub standard_uncertainty: f64,
    /// ν of u(x).
    pub degrees_of_freedom: f64,
    /// c = ∂f/∂x over ±u, output per input; zero where u is, since such an input is not varied.
    pub sensitivity: f64,
    /// |c| u(x), in the output's unit.
    pub contribution: f64,
    /// Its part of the combined variance \[1\].
    pub share: f64,
}

/// An uncertainty budget of independent inputs.
///
/// ```
/// use coilsense::uncertainty::{Budget, Distribution, Input};
///
/// // F = k x: 760 N/m known to 1 %, 0.1 m read in steps of 1 mm.
/// let budget = Budget::of(
///     |x| x[0] * x[1],
///     &[
///         Input::new("stiffness", 760.0, Distribution::Normal { standard: 7.6 }),
///         Input::new("elongation", 0.1, Distribution::Rectangular { half_width: 0.0005 }),
///     ],
/// )?;
/// assert_eq!(budget.estimate(), 76.0);
/// assert!((budget.combined() - 0.76_f64.hypot(0.38 / 3.0_f64.sqrt())).abs() < 1e-12);
/// assert_eq!(budget.contributions()[0].name, "stiffness");
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Budget {
    estimate: f64,
    corrected: f64,
    combined: f64,
    degrees_of_freedom: f64,
    contributions: Vec<Contribution>,
}

impl Budget {
    /// Of `model`, a function of the inputs' values in their order.
    ///
    /// c_i = Z_i/u_i, Z_i = ½ (f(…, x_i + u_i, …) − f(…, x_i − u_i, …)); u_c² = Σ Z_i²; ν_eff = u_c⁴ / Σ (Z_i⁴/ν_i)
    ///
    /// The means of deviations that were seen are recognised effects: sensitivities are taken with them corrected, and what they do
    /// to the output is stated as [`Self::bias`], not hidden in an uncertainty.
    ///
    /// Source:   `[JCGM100]` 5.1.2, 5.1.3 note 2 (differences), G.4.1 (Welch–Satterthwaite), 3.2.4 (recognised effects).
    /// Valid:    independent inputs; a model that is close to straight over ±u. Whether it is, [`super::MonteCarlo::agrees_with`] tells.
    /// Accuracy: exact for straight models and for the sensitivity of quadratic ones, else second order in u; rounding 1e-16 f/Z.
    ///
    /// # Errors
    /// [`Error::Count`] for no inputs or an empirical one without deviations; [`Error::Value`] for an input's number that is not
    /// finite, an uncertainty below zero, degrees of freedom below 1, or a model that is not finite at the points above.
    pub fn of(model: impl Fn(&[f64]) -> f64, inputs: &[Input]) -> Result<Self, Error> {
        at_least_one("inputs", inputs.len())?;
        inputs.iter().try_for_each(|input| input.checked().map(|_| ()))?;
        let estimate = evaluate(&model, &inputs.iter().map(|input| input.estimate).collect::<Vec<_>>())?;
        let mut at: Vec<f64> = inputs.iter().map(Input::corrected).collect();
        let corrected = evaluate(&model, &at)?;
        let mut contributions = Vec::with_capacity(inputs.len());
        for (index, input) in inputs.iter().enumerate() {
            contributions.push(contribution(&model, &mut at, index, input)?);
        }
        let combined = contributions.iter().fold(0.0_f64, |sum, c| sum.hypot(c.contribution));
        check(combined.is_finite(), "combined uncertainty", combined, "", "finite")?;
        for each in &mut contributions {
            each.share = if combined > 0.0 { (each.contribution / combined).powi(2) } else { 0.0 };
        }
        // With shares s_i = Z_i²/u_c² the sum below is that of Z_i⁴/ν_i over u_c⁴.
        let unsure: f64 = contributions.iter().map(|c| c.share * c.share / c.degrees_of_freedom).sum();
        Ok(Self { estimate, corrected, combined, degrees_of_freedom: 1.0 / unsure, contributions })
    }

    /// Output at the inputs' estimates, nothing corrected.
    pub fn estimate(&self) -> f64 {
        self.estimate
    }

    /// y: output at the inputs' estimates with the means of their deviations added, the best estimate.
    pub fn corrected(&self) -> f64 {
        self.corrected
    }

    /// What recognised effects add to the output: corrected − estimate. Who does not correct for it has to state it
    /// (`[JCGM100]` 3.2.4, F.2.4.5).
    pub fn bias(&self) -> f64 {
        self.corrected - self.estimate
    }

    /// u_c: combined standard uncertainty, in the output's unit.
    pub fn combined(&self) -> f64 {
        self.combined
    }

    /// ν_eff: effective degrees of freedom \[1\].
    pub fn degrees_of_freedom(&self) -> f64 {
        self.degrees_of_freedom
    }

    /// What each input contributes, in the inputs' order.
    pub fn contributions(&self) -> &[Contribution] {
        &self.contributions
    }

    /// k_p of a `coverage` p, by Student's t with ν_eff cut to its whole part; see [`coverage_factor`].
    ///
    /// # Errors
    /// [`Error::Value`] for a coverage that is not between 0 and 1.
    pub fn coverage_factor(&self, coverage: f64) -> Result<f64, Error> {
        // Of inputs with ν of 1 or above, ν_eff is 1 or above but for rounding.
        coverage_factor(probability(coverage)?, self.degrees_of_freedom.max(1.0))
    }

    /// U_p = k_p u_c: expanded uncertainty of a `coverage` p, 0.95 say, in the output's unit; the interval is y ± U_p.
    ///
    /// # Errors
    /// As [`Self::coverage_factor`].
    pub fn expanded(&self, coverage: f64) -> Result<f64, Error> {
        Ok(self.coverage_factor(coverage)? * self.combined)
    }
}

/// Of input `index`, with the model's inputs at their best estimates in `at`, which it leaves as it found them.
fn contribution(
    model: &impl Fn(&[f64]) -> f64,
    at: &mut [f64],
    index: usize,
    input: &Input,
) -> Result<Contribution, Error> {
    let middle = at[index];
    let standard = input.distribution.standard_uncertainty();
    check(standard.is_finite(), format!("standard uncertainty of {}", input.name), standard, "", "finite")?;
    at[index] = middle + standard;
    let above = evaluate(model, at)?;
    at[index] = middle - standard;
    let below = evaluate(model, at)?;
    at[index] = middle;
    let change = 0.5 * above - 0.5 * below;
    Ok(Contribution {
        name: input.name.clone(),
        estimate: input.estimate,
        standard_uncertainty: standard,
        degrees_of_freedom: input.degrees_of_freedom,
        sensitivity: if standard > 0.0 { change / standard } else { 0.0 },
        contribution: change.abs(),
        share: 0.0,
    })
}
