//! What makes the force of a sensor uncertain, in the terms of the GUM: the measurement model, its inputs, their distributions.
//!
//! Next door: how a budget and its Monte Carlo come about (`coilsense::uncertainty`), the judgement (`verdict`).

use coilsense::inductance::MaxwellSum;
use coilsense::uncertainty::{Agreement, Budget, Distribution, Input, MonteCarlo};
use coilsense::{Calibration, Error, Spring};

use super::instrument::Instrument;
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

/// What the budget of a sensor in a case is made of.
pub(super) struct Model<'a> {
    pub spec: &'a Spec,
    pub sensor: &'a SensorSpec,
    pub instrument: &'a Instrument,
    /// The reading at the largest force, in the native unit.
    pub reading: f64,
    /// Force of the steady reading less the true one \[N\]: oscillation, as the sensor sees it.
    pub errors: Vec<f64>,
    /// Samples per second of the simulation \[Hz\].
    pub sample_rate: f64,
}

/// An input of the model, by its place in the vector of inputs.
#[derive(Clone, Copy)]
enum Place {
    Oscillation,
    /// Added to the reading, in the native unit.
    Reading,
    /// A share of the reading.
    Gain,
    /// \[K\].
    Temperature,
    /// A share of the stiffness.
    Stiffness,
    /// Added to the rest length \[m\].
    RestLength,
    /// Added to the length that is read from an inductance \[m\].
    Form,
}

impl Model<'_> {
    /// The budget alone.
    pub fn budget(&self) -> Result<Budget, Error> {
        let (places, inputs) = self.inputs()?;
        Budget::of(|values| self.force(&places, values), &inputs)
    }

    /// The budget with its Monte Carlo.
    pub fn with_monte_carlo(&self) -> Result<SensorBudget, Error> {
        let (places, inputs) = self.inputs()?;
        let asked = &self.spec.uncertainty;
        let budget = Budget::of(|values| self.force(&places, values), &inputs)?;
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

    /// F of the inputs: the reading as the sensor errs, the force that the estimate makes of it as the spring errs, and the oscillation.
    fn force(&self, places: &[Place], values: &[f64]) -> f64 {
        let [mut oscillation, mut added, mut gain, mut kelvin, mut stiffness, mut longer] = [0.0; 6];
        for (place, value) in places.iter().zip(values) {
            match place {
                Place::Oscillation => oscillation += value,
                Place::Reading => added += value,
                Place::Gain => gain += value,
                Place::Temperature => kelvin += value,
                Place::Stiffness => stiffness += value,
                Place::RestLength => longer -= value,
                Place::Form => longer += value,
            }
        }
        let reading = (self.reading + added) * (1.0 + gain) * (1.0 + self.sensor.temperature_coefficient * kelvin);
        let estimate = self.instrument.force(reading);
        if matches!(self.sensor.quantity, Quantity::Force(_)) {
            return estimate + oscillation;
        }
        // The true spring is not the nominal one: of the same elongation its force differs, and the estimate knows nothing of it.
        let modulus = self.spec.spring.geometry.material().stiffness_temperature().unwrap_or(0.0);
        let share = (1.0 + stiffness) * (1.0 + modulus * kelvin);
        (estimate + self.spec.spring.spring.stiffness() * longer) * share + oscillation
    }

    fn inputs(&self) -> Result<(Vec<Place>, Vec<Input>), Error> {
        let (spec, sensor) = (self.spec, self.sensor);
        let (readout, range) = (&sensor.readout, sensor.range);
        let normal = |standard| Distribution::Normal { standard };
        let limits = |half_width| Distribution::Rectangular { half_width };
        let mut lines = vec![(Place::Oscillation, "oscillation", Distribution::Empirical(self.errors.clone()))];
        let mut add = |place, name, standard: f64, distribution| {
            if standard > 0.0 {
                lines.push((place, name, distribution));
            }
        };
        let noise = self.noise_in_band();
        add(Place::Reading, "sensor: noise", noise, normal(noise));
        let step = readout.resolution.unwrap_or(0.0);
        add(Place::Reading, "sensor: resolution", step, limits(0.5 * step));
        let full_scale = sensor.accuracy_full_scale * range;
        add(Place::Reading, "sensor: accuracy of full scale", full_scale, limits(full_scale));
        add(Place::Gain, "sensor: accuracy of reading", sensor.accuracy_reading, limits(sensor.accuracy_reading));
        let gain = sensor.calibration_uncertainty;
        add(Place::Gain, "calibration", gain, normal(gain));
        if let Quantity::Inductance { form, .. } = sensor.quantity {
            let (shortest, longest) = spec.spring.spring.operating_range();
            let form = form * (longest - shortest);
            add(Place::Form, "calibration form: measured springs", form, normal(form));
            let misfit = self.misfit();
            add(Place::Form, "calibration form: eq. (13) itself", misfit, normal(misfit));
        }
        let kelvin = spec.uncertainty.temperature_change;
        add(Place::Temperature, "temperature", kelvin, limits(kelvin));
        if !matches!(sensor.quantity, Quantity::Force(_)) {
            let (stiffness, length) = (spec.spring.stiffness_tolerance, spec.spring.rest_length_tolerance);
            add(Place::Stiffness, "tolerance of the stiffness", stiffness, limits(stiffness));
            add(Place::RestLength, "tolerance of the rest length", length, limits(length));
        }
        let places = lines.iter().map(|(place, ..)| *place).collect();
        let input = |(_, name, distribution): (Place, &'static str, Distribution)| Input::new(name, 0.0, distribution);
        Ok((places, lines.into_iter().map(input).collect()))
    }

    /// White noise of the readings, less what lies above the wanted bandwidth; native unit.
    fn noise_in_band(&self) -> f64 {
        let rate = self.sensor.readout.sample_rate.unwrap_or(self.sample_rate);
        let share = self.spec.goal.bandwidth.map_or(1.0, |bandwidth| (2.0 * bandwidth / rate).min(1.0));
        self.sensor.readout.noise * share.sqrt()
    }

    /// How far eq. (13) departs from the inductance's own theory over the operating range, rms \[m\].
    fn misfit(&self) -> f64 {
        let Some(calibration) = self.instrument.calibration() else { return 0.0 };
        let coil = MaxwellSum::new(&self.spec.spring.spring, self.spec.spring.self_distance);
        misfit(&self.spec.spring.spring, &coil, calibration)
    }
}

/// Lengths at which the misfit of eq. (13) is taken.
const MISFIT_LENGTHS: usize = 41;

/// Rms departure \[m\] of eq. (13) from the theory of the coil, uniform over the operating range.
pub(super) fn misfit(spring: &Spring, coil: &MaxwellSum, calibration: &Calibration) -> f64 {
    let (shortest, longest) = spring.operating_range();
    let step = (longest - shortest) / (MISFIT_LENGTHS - 1) as f64;
    let departures = (0..MISFIT_LENGTHS).map(|index| {
        let length = shortest + index as f64 * step;
        calibration.length(coil.at_length(length)) - length
    });
    (departures.map(|d| d * d).sum::<f64>() / MISFIT_LENGTHS as f64).sqrt()
}
