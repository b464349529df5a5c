//! What makes the force of a sensor uncertain, in the terms of the GUM: the measurement model, its inputs, their distributions.
//!
//! Next door: how a budget and its Monte Carlo come about (`coilsense::uncertainty`), the judgement (`verdict`).

use coilsense::inductance::MaxwellSum;
use coilsense::uncertainty::{Agreement, Budget, Distribution, Input, MonteCarlo};
use coilsense::{Calibration, Error, Spring};
use rand::SeedableRng;
use rand_pcg::Pcg64;

use super::instrument::Instrument;
use super::specimen::Specimens;
use super::spread::Spread;
use crate::spec::{Quantity, SensorSpec, Spec};

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

/// The line that says what it adds that a coil's first frequency is not that of the chain.
pub(super) const CHAIN: &str = "the coil as a chain";

/// What the budget of a sensor in a case is made of.
pub(super) struct Model<'a> {
    pub spec: &'a Spec,
    pub coil: &'a MaxwellSum,
    pub sensor: &'a SensorSpec,
    pub instrument: &'a Instrument,
    /// The reading at the largest force, in the native unit.
    pub reading: f64,
    /// Force of the steady reading less the true one at the same instant, as far as it counts \[N\]: oscillation, as the sensor sees it,
    /// and its lag behind a moving force.
    pub errors: Vec<f64>,
    /// The same over the springs that the tolerances allow.
    pub spread: Spread,
    /// Samples per second of the simulation \[Hz\].
    pub sample_rate: f64,
    /// Force at the mean length, where instruments are set to zero \[N\].
    pub mean_force: f64,
}

/// An input of the model, by its place in the vector of inputs.
#[derive(Clone, Copy)]
enum Place {
    Oscillation,
    /// Added to the reading, in the native unit.
    Reading,
    /// A share of the reading, counted from the instrument's zero.
    Gain,
    /// \[K\].
    Temperature,
    /// A share of the stiffness.
    Stiffness,
    /// A share of the initial tension.
    InitialTension,
    /// Added to the rest length \[m\].
    RestLength,
    /// Added to the length that is read from an inductance \[m\].
    Form,
    /// Added to the drive train's compliance \[m/N\].
    Compliance,
}

impl Model<'_> {
    /// The budget alone.
    pub fn budget(&self) -> Result<Budget, Error> {
        let (places, inputs) = self.inputs(self.oscillation())?;
        Budget::of(|values| self.force(&places, values), &inputs)
    }

    /// Two errors with the mean and the spread of all of them: what a budget needs.
    fn oscillation(&self) -> Distribution {
        let apart = self.spread.deviation / 2.0_f64.sqrt();
        Distribution::Empirical(vec![self.spread.mean - apart, self.spread.mean + apart])
    }

    /// The budget with its Monte Carlo.
    pub fn with_monte_carlo(&self) -> Result<SensorBudget, Error> {
        let asked = &self.spec.uncertainty;
        let budget = self.budget()?;
        let values = Distribution::Empirical(self.spread.values(&self.errors, DRAWN));
        let (places, mut inputs) = self.inputs(values)?;
        // These values hold what the chain adds.
        inputs.iter_mut().filter(|input| input.name == CHAIN).for_each(|input| {
            input.distribution = Distribution::Normal { standard: 0.0 };
        });
        let monte_carlo = MonteCarlo::run(|values| self.force(&places, values), &inputs, asked.trials, asked.seed)?;
        Ok(SensorBudget {
            coverage_factor: budget.coverage_factor(asked.coverage)?,
            expanded: budget.expanded(asked.coverage)?,
            interval: monte_carlo.symmetric(asked.coverage)?,
            agreement: monte_carlo.agrees_at(asked.coverage, &budget, 2)?,
            mean: monte_carlo.mean(),
            standard: monte_carlo.standard(),
            force: self.instrument.force(self.reading),
            budget,
        })
    }

    /// Rms error of each specimen over time \[N\]: one spring, one instrument, one temperature, and the noise of its readings.
    pub fn of_specimens(&self, specimens: &Specimens) -> Result<Vec<f64>, Error> {
        let (places, inputs) = self.inputs(self.oscillation())?;
        let still: Vec<f64> = vec![0.0; inputs.len()];
        let unmoved = self.force(&places, &still);
        let scattered = |name: &str| name == "sensor: noise" || name == "sensor: resolution";
        let mut scatter = 0.0;
        for (index, input) in inputs.iter().enumerate().filter(|(_, input)| scattered(&input.name)) {
            let mut values = still.clone();
            values[index] = input.distribution.standard_uncertainty();
            scatter += (self.force(&places, &values) - unmoved).powi(2);
        }
        let mut chance = Pcg64::seed_from_u64(self.spec.uncertainty.seed);
        let mut values = still;
        let each = specimens.each.iter().zip(&self.spread.each).map(|(specimen, moments)| {
            for ((value, place), input) in values.iter_mut().zip(&places).zip(&inputs) {
                *value = match place {
                    Place::Oscillation => 0.0,
                    Place::Stiffness => specimen.departure.stiffness - 1.0,
                    // The estimate takes a longer spring for a stretched one.
                    Place::RestLength => specimen.departure.rest_length,
                    Place::InitialTension => specimen.departure.initial_tension - 1.0,
                    Place::Reading if scattered(&input.name) => 0.0,
                    _ => input.distribution.sample(&mut chance),
                };
            }
            let steady = self.force(&places, &values) - unmoved;
            (moments.variance + (moments.mean + steady).powi(2) + scatter).sqrt()
        });
        Ok(each.collect())
    }

    /// F of the inputs: the reading as the sensor errs, the force that the estimate makes of it as the spring errs, and the oscillation.
    fn force(&self, places: &[Place], values: &[f64]) -> f64 {
        let [mut oscillation, mut added, mut gain, mut kelvin, mut stiffness, mut tension, mut longer, mut softer] =
            [0.0; 8];
        for (place, value) in places.iter().zip(values) {
            match place {
                Place::Oscillation => oscillation += value,
                Place::Reading => added += value,
                Place::Gain => gain += value,
                Place::Temperature => kelvin += value,
                Place::Stiffness => stiffness += value,
                Place::InitialTension => tension += value,
                Place::RestLength => longer -= value,
                Place::Form => longer += value,
                Place::Compliance => softer += value,
            }
        }
        let zero = self.instrument.zero();
        let gain = (1.0 + gain) * (1.0 + self.sensor.temperature_coefficient * kelvin);
        let estimate = self.instrument.force(zero + (self.reading - zero + added) * gain);
        if !self.estimates() {
            return estimate + oscillation;
        }
        // The true spring is not the nominal one: of the same elongation its force differs, and the estimate knows nothing of it.
        let (spring, slope) = (&self.spec.spring.spring, self.instrument.stiffness(&self.spec.spring.spring));
        // In series with a drive train a spring's change shows in part only: dk_s/k_s = (k_s/k) dk/k.
        let part = slope / spring.stiffness();
        let warm = 1.0 + self.modulus_drift() * kelvin;
        let share = 1.0 + part * ((1.0 + stiffness) * warm - 1.0);
        // The rate's tolerance does not act on the tension that was wound in; the modulus does.
        let wound = self.spec.spring.initial_tension;
        let tensed = wound * (1.0 + part * (warm - 1.0)) * (1.0 + tension);
        // Set to zero at the mean length, a drive train that is softer than thought shows in what the force is off its mean.
        let bent = slope * softer * (estimate - self.mean_force);
        (estimate - wound + slope * longer) * share + tensed + bent + oscillation
    }

    /// (dk/dT)/k \[1/K\]; zero, with a warning elsewhere, where the material table does not know it.
    fn modulus_drift(&self) -> f64 {
        self.spec.spring.geometry.material().stiffness_temperature().unwrap_or(0.0)
    }

    fn inputs(&self, oscillation: Distribution) -> Result<(Vec<Place>, Vec<Input>), Error> {
        let (spec, sensor) = (self.spec, self.sensor);
        let (readout, range) = (&sensor.readout, sensor.range);
        let normal = |standard| Distribution::Normal { standard };
        let limits = |half_width| Distribution::Rectangular { half_width };
        let mut lines = vec![(Place::Oscillation, "oscillation", oscillation)];
        let mut add = |place, name, standard: f64, distribution| {
            if standard > 0.0 {
                lines.push((place, name, distribution));
            }
        };
        let chain = self.spread.chain;
        add(Place::Oscillation, CHAIN, chain, normal(chain));
        let noise = self.noise_in_band();
        add(Place::Reading, "sensor: noise", noise, normal(noise));
        let step = readout.resolution.unwrap_or(0.0);
        add(Place::Reading, "sensor: resolution", step, limits(0.5 * step));
        let full_scale = sensor.accuracy_full_scale * range;
        add(Place::Reading, "sensor: accuracy of full scale", full_scale, limits(full_scale));
        add(Place::Gain, "sensor: accuracy of reading", sensor.accuracy_reading, limits(sensor.accuracy_reading));
        let gain = sensor.calibration_uncertainty;
        add(Place::Gain, "calibration", gain, normal(gain));
        if let Some((name, form)) = self.calibration_form() {
            add(Place::Form, name, form, normal(form));
        }
        let drifts = sensor.temperature_coefficient != 0.0 || (self.estimates() && self.modulus_drift() != 0.0);
        let kelvin = if drifts { spec.uncertainty.temperature_change } else { 0.0 };
        add(Place::Temperature, "temperature", kelvin, limits(kelvin));
        if self.estimates() {
            let (stiffness, length) = (spec.spring.stiffness_tolerance(), spec.spring.rest_length_tolerance());
            add(Place::Stiffness, "tolerance of the stiffness", stiffness, limits(stiffness));
            add(Place::RestLength, "tolerance of the rest length", length, limits(length));
            let tension = if spec.spring.initial_tension > 0.0 { spec.spring.tolerances.initial_tension } else { 0.0 };
            add(Place::InitialTension, "tolerance of the initial tension", tension, limits(tension));
            if let Quantity::TwoEncoder { compliance, .. } = sensor.quantity {
                let softer = sensor.compliance_tolerance * compliance;
                add(Place::Compliance, "tolerance of the drive train's compliance", softer, limits(softer));
            }
        }
        let places = lines.iter().map(|(place, ..)| *place).collect();
        let input = |(_, name, distribution): (Place, &'static str, Distribution)| Input::new(name, 0.0, distribution);
        Ok((places, lines.into_iter().map(input).collect()))
    }

    /// Whether the force is an estimate by a length, which takes the spring to be the nominal one; a load cell sees the force itself.
    fn estimates(&self) -> bool {
        !matches!(self.sensor.quantity, Quantity::Force(_))
    }

    /// White noise of the readings, less what lies above the wanted bandwidth; native unit.
    fn noise_in_band(&self) -> f64 {
        let rate = self.sensor.readout.sample_rate.unwrap_or(self.sample_rate);
        let share = self.spec.goal.bandwidth.map_or(1.0, |bandwidth| (2.0 * bandwidth / rate).min(1.0));
        self.sensor.readout.noise * share.sqrt()
    }

    /// How far eq. (13) is off in length \[m\], and which line of the budget says so; `None` for other sensors.
    ///
    /// The larger of the departure of measured springs and that of the coil's own theory, uniform over the operating range: what was
    /// measured holds the theory's part, so adding both would count it twice. It stands for all lengths in use, though a condition of
    /// use visits those near its mean length only, where eq. (13) is forced to be right.
    fn calibration_form(&self) -> Option<(&'static str, f64)> {
        let (Quantity::Inductance { form, .. }, Some(calibration)) =
            (self.sensor.quantity, self.instrument.calibration())
        else {
            return None;
        };
        let spring = &self.spec.spring.spring;
        let (shortest, longest) = spring.operating_range();
        let measured = form * (longest - shortest);
        let theory = misfit(spring, self.coil, calibration);
        Some(if measured >= theory {
            ("calibration form: measured springs", measured)
        } else {
            ("calibration form: eq. (13) itself", theory)
        })
    }
}

/// Errors over specimens and time that stand for all of them in a Monte Carlo.
const DRAWN: usize = 16384;

/// Lengths at which the misfit of eq. (13) is taken.
const MISFIT_LENGTHS: usize = 41;

/// Rms departure \[m\] of eq. (13) from the theory of the coil, over lengths from end to end of the operating range.
fn misfit(spring: &Spring, coil: &MaxwellSum, calibration: &Calibration) -> f64 {
    let (shortest, longest) = spring.operating_range();
    let step = (longest - shortest) / (MISFIT_LENGTHS - 1) as f64;
    let departures = (0..MISFIT_LENGTHS).map(|index| {
        let length = shortest + index as f64 * step;
        calibration.length(coil.at_length(length)) - length
    });
    (departures.map(|d| d * d).sum::<f64>() / MISFIT_LENGTHS as f64).sqrt()
}
