//! An input quantity of a model: what it is called, what it is taken to be, and how well that is known.
//!
//! Next door: shapes of what is not known (`distribution`), what it does to the output (`budget`).

use std::borrow::Cow;

use rand_distr::{Distribution as _, StudentT};
use rand_pcg::rand_core::Rng;

use super::distribution::Distribution;
use crate::error::{Error, check};

/// An input quantity X = x + deviation.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// What it is called in the budget.
    pub name: Cow<'static, str>,
    /// x: what it is taken to be, in its own unit.
    pub estimate: f64,
    /// How X may deviate from x.
    pub distribution: Distribution,
    /// ν: how well the standard uncertainty itself is known, 1 or above; infinite where it is taken for granted.
    pub degrees_of_freedom: f64,
}

impl Input {
    /// An input whose standard uncertainty is taken for granted: infinite degrees of freedom.
    pub fn new(name: impl Into<Cow<'static, str>>, estimate: f64, distribution: Distribution) -> Self {
        Self { name: name.into(), estimate, distribution, degrees_of_freedom: f64::INFINITY }
    }

    /// The same with `degrees_of_freedom` ν: n − 1 of n readings, ½ (Δu/u)⁻² of a judged Δu (`[JCGM100]` G.4.2).
    #[must_use]
    pub fn with_degrees_of_freedom(self, degrees_of_freedom: f64) -> Self {
        Self { degrees_of_freedom, ..self }
    }

    /// x + mean deviation: the best estimate.
    pub(super) fn corrected(&self) -> f64 {
        self.estimate + self.distribution.mean()
    }

    /// How values of X are drawn: x + u t_ν for a normal one of few degrees of freedom (`[JCGM101]` 6.4.9), else x + deviation.
    pub(super) fn sampler(&self) -> Sampler<'_> {
        let few = match self.distribution {
            Distribution::Normal { standard } if self.degrees_of_freedom.is_finite() => {
                StudentT::new(self.degrees_of_freedom).ok().map(|student| (standard, student))
            }
            _ => None,
        };
        Sampler { input: self, few }
    }

    /// Lets it through where its numbers are.
    pub(super) fn checked(&self) -> Result<&Self, Error> {
        let named = |error| match error {
            Error::Value { field, quantity, value, unit, allowed } => {
                Error::Value { field, quantity: format!("{quantity} of {}", self.name).into(), value, unit, allowed }
            }
            Error::Count { field, quantity, found, allowed } => {
                Error::Count { field, quantity: format!("{quantity} of {}", self.name).into(), found, allowed }
            }
            other => other,
        };
        check(self.estimate.is_finite(), "estimate", self.estimate, "", "finite").map_err(named)?;
        self.distribution.checked().map_err(named)?;
        let enough = self.degrees_of_freedom >= 1.0;
        check(enough, "degrees_of_freedom", self.degrees_of_freedom, "", "1 or above").map_err(named)?;
        Ok(self)
    }
}

/// Draws values of one input.
pub(super) struct Sampler<'a> {
    input: &'a Input,
    few: Option<(f64, StudentT<f64>)>,
}

impl Sampler<'_> {
    /// One value of X.
    pub(super) fn sample(&self, generator: &mut impl Rng) -> f64 {
        let deviation = match &self.few {
            Some((standard, student)) => standard * student.sample(generator),
            None => self.input.distribution.sample(generator),
        };
        self.input.estimate + deviation
    }
}
