//! The budget of a sensor in a case: what its force errs by, with the oscillation that the analysis found.
//!
//! Next door: the measurement model and all that it errs by but oscillation (`coilsense::sensors`), how a budget and its Monte Carlo come
//! about (`coilsense::uncertainty`), the judgement (`verdict`).

use coilsense::Error;
use coilsense::sensors::{Cause, Measurement, Place, SpringDoubt, cause};
use coilsense::uncertainty::{Agreement, Budget, Distribution, Input, MonteCarlo};
use rand::SeedableRng;
use rand_pcg::Pcg64;

use super::moments::Moments;
use super::specimen::Specimens;
use super::spread::Spread;
use crate::spec::{Spec, SpringSpec};

/// The budget of one sensor in one case, and the Monte Carlo of the same model.
#[derive(Debug, Clone)]
pub struct SensorBudget {
    /// The contributions, and combined.
    pub budget: Budget,
    /// k of the expanded uncertainty.
    pub coverage_factor: f64,
    /// Expanded uncertainty U = k u \[N\].
    pub expanded: f64,
    /// Mean of the Monte Carlo \[N\].
    pub mean: f64,
    /// Its standard deviation \[N\].
    pub standard: f64,
    /// Its interval of the same coverage \[N\].
    pub interval: (f64, f64),
    /// Whether the two say the same.
    pub agreement: Agreement,
    /// Force at which it is made up \[N\].
    pub force: f64,
    /// What of the bias is due to a coil whose force is no straight line \[N\].
    pub bend: f64,
}

impl SensorBudget {
    /// Standard uncertainty with the bias that stays uncorrected \[N\].
    pub fn with_bias(&self) -> f64 {
        with_bias(&self.budget)
    }
}

/// √(u² + b²): a mean error that nobody corrects counts as well.
pub(super) fn with_bias(budget: &Budget) -> f64 {
    budget.combined().hypot(budget.bias())
}

/// The line of what the sensor sees of the windings' motion, and its lag.
pub(super) const OSCILLATION: &str = "oscillation";
/// The line that says what it adds that a coil's first frequency is not that of the chain.
pub(super) const CHAIN: &str = "the coil as a chain";

/// The line that says what it adds that a sensor of length takes the spring's force for a straight line.
pub(super) const STRAIGHT: &str = "the force as a straight line";

/// The line that says how far the inductance of magnetic windings that move may be off.
pub(super) const UNEVEN: &str = "magnetisation of uneven windings";

/// What is known of a spec's spring.
pub(super) fn doubt(spring: &SpringSpec) -> SpringDoubt {
    SpringDoubt {
        stiffness: spring.stiffness_tolerance(),
        rest_length: spring.rest_length_tolerance(),
        tension: spring.initial_tension,
        initial_tension: spring.tolerances.initial_tension,
        // Zero, with a warning elsewhere, where the material table does not know it.
        stiffness_drift: spring.geometry.material().stiffness_temperature().unwrap_or(0.0),
        expansion: spring.geometry.material().expansion().unwrap_or(0.0),
    }
}

/// What the budget of a sensor in a case is made of.
pub(super) struct Model<'a> {
    pub spec: &'a Spec,
    /// The sensor on its spring, at the reading of the largest force.
    pub measurement: Measurement<'a>,
    /// Force of the steady reading less the true one at the same instant, as far as it counts \[N\]: oscillation, as the sensor sees it,
    /// and its lag behind a moving force.
    pub errors: Vec<f64>,
    /// The same over the springs that the tolerances allow.
    pub spread: Spread,
    /// What the straight line in place of the coil's static curve makes of it \[N\], as far as it counts; empty where it makes nothing.
    pub straight: Vec<f64>,
    /// Whether errors and spread hold that already: those of a helix that moves do, those of a chain do not.
    pub bends: bool,
    /// What a length by inductance may be off because magnetic windings that move are known to second order, standard deviation \[m\].
    pub uneven: f64,
}

/// The inputs of a model, and where each acts.
struct Inputs {
    places: Vec<Place>,
    inputs: Vec<Input>,
}

impl Model<'_> {
    /// The budget alone.
    pub fn budget(&self) -> Result<Budget, Error> {
        let Inputs { places, inputs } = self.inputs(self.oscillation());
        Budget::of(|values| self.force(&places, values), &inputs)
    }

    /// Variance of what the instrument alone adds to a budget of this model, without what the spring, what it hangs on and its motion do
    /// \[N²\].
    pub fn of_instrument(&self, budget: &Budget) -> f64 {
        let is_of_instrument = |place: &Place| match place {
            Place::Reading | Place::Gain | Place::Length | Place::Temperature => true,
            Place::Force | Place::Stiffness | Place::RestLength | Place::InitialTension | Place::Compliance => false,
        };
        // A budget's lines are in the order of its inputs.
        let places = self.inputs(self.oscillation()).places;
        let lines = places.iter().zip(budget.contributions()).filter(|(place, _)| is_of_instrument(place));
        lines.map(|(_, line)| line.contribution * line.contribution).sum()
    }

    /// What the straight line adds to the errors.
    pub fn beside(&self) -> Moments {
        if self.bends { Moments::default() } else { Moments::of(&self.straight) }
    }

    /// Rms error of the nominal spring's motion \[N\].
    pub fn nominal(&self) -> f64 {
        if self.bends || self.straight.is_empty() {
            return self.spread.nominal.square().sqrt();
        }
        let each: Vec<f64> = self.errors.iter().zip(&self.straight).map(|(error, straight)| error + straight).collect();
        Moments::of(&each).square().sqrt()
    }

    /// Two errors with the mean and the spread of all of them: what a budget needs.
    fn oscillation(&self) -> Distribution {
        let straight = if self.bends { Moments::of(&self.straight) } else { Moments::default() };
        let varies = self.spread.deviation.powi(2) - straight.variance;
        two_of(Moments { mean: self.spread.mean - straight.mean, variance: varies.max(0.0) })
    }

    /// The budget with its Monte Carlo.
    pub fn with_monte_carlo(&self) -> Result<SensorBudget, Error> {
        let asked = &self.spec.uncertainty;
        let budget = self.budget()?;
        let values = Distribution::Empirical(self.spread.values(&self.errors, DRAWN));
        let Inputs { places, mut inputs } = self.inputs(values);
        // These values hold what the chain adds, and of a helix what the straight line does.
        inputs.iter_mut().for_each(|input| match input.name.as_ref() {
            CHAIN => input.distribution = Distribution::Normal { standard: 0.0 },
            STRAIGHT if self.bends => input.distribution = Distribution::Normal { standard: 0.0 },
            STRAIGHT => input.distribution = Distribution::Empirical(self.straight.clone()),
            _ => {}
        });
        let monte_carlo = MonteCarlo::run(|values| self.force(&places, values), &inputs, asked.trials, asked.seed)?;
        Ok(SensorBudget {
            coverage_factor: budget.coverage_factor(asked.coverage)?,
            expanded: budget.expanded(asked.coverage)?,
            interval: monte_carlo.symmetric(asked.coverage)?,
            agreement: monte_carlo.agrees_at(asked.coverage, &budget, 2)?,
            mean: monte_carlo.mean(),
            standard: monte_carlo.standard(),
            force: self.measurement.instrument.force(self.measurement.reading),
            bend: Moments::of(&self.straight).mean,
            budget,
        })
    }

    /// Rms error of each specimen over time \[N\]: one spring, one instrument, one temperature, and the noise of its readings.
    pub fn of_specimens(&self, specimens: &Specimens) -> Vec<f64> {
        let Inputs { places, inputs } = self.inputs(self.oscillation());
        let still: Vec<f64> = vec![0.0; inputs.len()];
        let unmoved = self.force(&places, &still);
        let scattered = |name: &str| name == cause::NOISE || name == cause::RESOLUTION;
        let mut scatter = 0.0;
        for (index, input) in inputs.iter().enumerate().filter(|(_, input)| scattered(&input.name)) {
            let mut values = still.clone();
            values[index] = input.distribution.standard_uncertainty();
            scatter += (self.force(&places, &values) - unmoved).powi(2);
        }
        let mut chance = Pcg64::seed_from_u64(self.spec.uncertainty.seed);
        let mut values = still;
        let beside = self.beside();
        let each = specimens.each.iter().zip(&self.spread.each).map(|(specimen, moments)| {
            for ((value, place), input) in values.iter_mut().zip(&places).zip(&inputs) {
                *value = match place {
                    Place::Force => 0.0,
                    Place::Stiffness => specimen.departure.stiffness - 1.0,
                    // The estimate takes a longer spring for a stretched one.
                    Place::RestLength => specimen.departure.rest_length,
                    Place::InitialTension => specimen.departure.initial_tension - 1.0,
                    Place::Reading if scattered(&input.name) => 0.0,
                    Place::Reading | Place::Gain | Place::Length | Place::Temperature | Place::Compliance => {
                        input.distribution.sample(&mut chance)
                    }
                };
            }
            let steady = self.force(&places, &values) - unmoved;
            let (mean, variance) = (moments.mean + beside.mean, moments.variance + beside.variance);
            (variance + (mean + steady).powi(2) + scatter).sqrt()
        });
        each.collect()
    }

    fn force(&self, places: &[Place], values: &[f64]) -> f64 {
        self.measurement.force(places.iter().copied().zip(values.iter().copied()))
    }

    /// Oscillation, and all else that the force errs by.
    fn inputs(&self, oscillation: Distribution) -> Inputs {
        let oscillation = Cause { place: Place::Force, name: OSCILLATION, distribution: oscillation };
        let chain = Cause::normal(Place::Force, CHAIN, self.spread.chain);
        let straight = (!self.straight.is_empty()).then(|| Cause {
            place: Place::Force,
            name: STRAIGHT,
            distribution: two_of(Moments::of(&self.straight)),
        });
        let uneven = Cause::normal(Place::Length, UNEVEN, self.uneven);
        let others = self.measurement.causes();
        let causes: Vec<Cause> =
            [oscillation].into_iter().chain(chain).chain(straight).chain(uneven).chain(others).collect();
        Inputs {
            places: causes.iter().map(|cause| cause.place).collect(),
            inputs: causes.into_iter().map(Cause::into_input).collect(),
        }
    }
}

/// Two values with a mean and a variance: what a budget needs.
fn two_of(moments: Moments) -> Distribution {
    let apart = (0.5 * moments.variance).sqrt();
    Distribution::Empirical(vec![moments.mean - apart, moments.mean + apart])
}

/// Errors over specimens and time that stand for all of them in a Monte Carlo.
const DRAWN: usize = 16384;
