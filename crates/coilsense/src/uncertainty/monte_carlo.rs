//! The same model with its inputs drawn by chance, many times.
//!
//! Next door: the budget that it checks (`budget`), the check (`agreement`).

use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

use super::{Input, evaluate, probability};
use crate::error::{Error, at_least_one, check};

/// Most trials: their outputs are kept, 8 bytes each.
const MOST_TRIALS: usize = 100_000_000;

/// Outputs of a model, propagated from its inputs' distributions.
///
/// ```
/// use coilsense::uncertainty::{Distribution, Input, MonteCarlo};
///
/// // Two like rectangles add up to a triangle: 95 % lie within 2 - √(4 · 0.05) half widths.
/// let input = |name| Input::new(name, 0.0, Distribution::Rectangular { half_width: 1.0 });
/// let run = MonteCarlo::run(|x| x[0] + x[1], &[input("a"), input("b")], 100_000, 1)?;
/// let (low, high) = run.symmetric(0.95)?;
/// assert!((high - (2.0 - 0.2_f64.sqrt())).abs() < 0.02 && (low + high).abs() < 0.02);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MonteCarlo {
    mean: f64,
    standard: f64,
    /// Outputs of the model, smallest first.
    outputs: Vec<f64>,
}

impl MonteCarlo {
    /// Draws `trials` values of every input and works out the model for each.
    ///
    /// mean = Σ y_r/M, u² = Σ (y_r − mean)²/(M − 1), y_r = f(x_1r, …, x_Nr)
    ///
    /// - `trials`: M, 100 to 1e8; `seed`: the same seed gives the same draws
    ///
    /// Source:   `[JCGM101]` 7.2–7.6; a normal input of finite ν is drawn as x + u t_ν (6.4.9), so below ν = 3 it has no variance.
    /// Valid:    independent inputs; other distributions take no notice of ν.
    /// Accuracy: that of chance: mean to u/√M, u to u/√(2M) for a normal output.
    ///
    /// # Errors
    /// [`Error::Count`] for no inputs or an empirical one without deviations; [`Error::Value`] as [`super::Budget::of`] for inputs and
    /// model, and for trials out of range.
    pub fn run(model: impl Fn(&[f64]) -> f64, inputs: &[Input], trials: usize, seed: u64) -> Result<Self, Error> {
        at_least_one("inputs", inputs.len())?;
        inputs.iter().try_for_each(|input| input.checked().map(|_| ()))?;
        let enough = (100..=MOST_TRIALS).contains(&trials);
        check(enough, "trials", trials as f64, "", format!("from 100 to {MOST_TRIALS}"))?;
        let mut generator = Pcg64::seed_from_u64(seed);
        let samplers: Vec<_> = inputs.iter().map(Input::sampler).collect();
        let mut drawn = vec![0.0; inputs.len()];
        let mut outputs = Vec::with_capacity(trials);
        for _ in 0..trials {
            for (value, sampler) in drawn.iter_mut().zip(&samplers) {
                *value = sampler.sample(&mut generator);
            }
            outputs.push(evaluate(&model, &drawn)?);
        }
        outputs.sort_unstable_by(f64::total_cmp);
        let count = trials as f64;
        let mean: f64 = outputs.iter().map(|output| output / count).sum();
        let scatter: f64 = outputs.iter().map(|output| (output - mean) * (output - mean)).sum();
        let standard = (scatter / (count - 1.0)).sqrt();
        check(standard.is_finite(), "standard deviation of the outputs", standard, "", "finite")?;
        Ok(Self { mean, standard, outputs })
    }

    /// Mean of the outputs: the estimate.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Their standard deviation: the standard uncertainty.
    pub fn standard(&self) -> f64 {
        self.standard
    }

    /// The outputs, smallest first, shape `trials`.
    pub fn outputs(&self) -> &[f64] {
        &self.outputs
    }

    /// The interval that holds `coverage` p of the outputs, with as many below as above.
    ///
    /// y_(r) to y_(r+q) of the sorted outputs, q = ⌊pM + ½⌋, r = (M − q)/2
    ///
    /// Source:   `[JCGM101]` 7.7.2.
    /// Valid:    any model.
    /// Accuracy: that of chance: each end is known to √(α(1 − α)/M) of the density's inverse there, α = (1 − p)/2.
    ///
    /// # Errors
    /// [`Error::Value`] for a coverage that is not between 0 and 1.
    pub fn symmetric(&self, coverage: f64) -> Result<(f64, f64), Error> {
        let held = self.held(coverage)?;
        let first = (self.outputs.len() - held) / 2;
        Ok((self.outputs[first], self.outputs[first + held]))
    }

    /// The shortest interval that holds `coverage` p of the outputs.
    ///
    /// The least of y_(r+q) − y_(r) over r, q = ⌊pM + ½⌋
    ///
    /// Source:   `[JCGM101]` 7.7.4.
    /// Valid:    outputs of one hump.
    /// Accuracy: that of chance; where it lies is known less well than how long it is, since its length is flat at its least.
    ///
    /// # Errors
    /// [`Error::Value`] for a coverage that is not between 0 and 1.
    pub fn shortest(&self, coverage: f64) -> Result<(f64, f64), Error> {
        let held = self.held(coverage)?;
        let pairs = self.outputs.iter().zip(&self.outputs[held..]);
        let least = pairs.min_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)));
        Ok(least.map_or((self.mean, self.mean), |(low, high)| (*low, *high)))
    }

    /// q: how many steps from output to output a coverage takes, at most all there are.
    fn held(&self, coverage: f64) -> Result<usize, Error> {
        let trials = self.outputs.len();
        Ok(((probability(coverage)? * trials as f64 + 0.5).floor() as usize).clamp(1, trials - 1))
    }
}
