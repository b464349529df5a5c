//! The measurement model of a sensor, in the terms of the GUM: which inputs its force has, how each may be off, and what that does.
//!
//! Next door: what a kind of sensor adds (one file a kind), what the inputs are called (`cause`), budgets and Monte Carlo of such a model
//! (`crate::uncertainty`).

use super::cause::{self, Cause, Place};
use super::instrument::Instrument;
use super::sensor::Site;

/// How far an instrument may be off, as a data sheet says it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// Limits of error that are the same for every reading, in the native unit.
    pub full_scale: f64,
    /// Limits of error as a share of the reading \[1\].
    pub of_reading: f64,
    /// Standard uncertainty of the gain by calibration, as a share of the reading \[1\].
    pub calibration: f64,
    /// Of the gain \[1/K\].
    pub temperature_coefficient: f64,
}

/// How far the spring may be off the nominal one that estimates take it to be.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpringDoubt {
    /// Limits of the stiffness, either way, as a share \[1\].
    pub stiffness: f64,
    /// Limits of the rest length, either way \[m\].
    pub rest_length: f64,
    /// F_0: the force that was wound in \[N\].
    pub tension: f64,
    /// Its limits, either way, as a share \[1\].
    pub initial_tension: f64,
    /// (dk/dT)/k \[1/K\].
    pub stiffness_drift: f64,
    /// α: how its metal expands \[1/K\]; by it the rest length grows, and an inductance ([`super::Sensor::expands`]).
    pub expansion: f64,
}

/// A sensor's force as a function of all by which it errs.
///
/// ```
/// use coilsense::inductance::{MaxwellSum, SelfDistance};
/// use coilsense::sensors::{Instrument, Limits, Measurement, Quantity, Readout, ReadoutParameters, Site, SpringDoubt};
/// use coilsense::uncertainty::Budget;
/// # let spring = coilsense::Spring::new(coilsense::SpringParameters { rest_length: 0.104, windings: 52.0,
/// #     coil_radius: 0.008, wire_radius: 0.001, mass: 0.065, stiffness: 760.0, min_length: 0.196,
/// #     max_length: 0.264, nominal_force: None, inductance_windings: None, sections: None })?;
///
/// let coil = MaxwellSum::new(&spring, SelfDistance::default());
/// let site = Site { spring: &spring, coil: &coil, mean_length: 0.204 };
/// let laser = Instrument::new(Readout::new(ReadoutParameters::default())?, Quantity::Deflection.on(&site)?);
/// let spring = SpringDoubt { stiffness: 0.05, ..Default::default() };
/// let model = Measurement { instrument: &laser, site, limits: Limits::default(), spring, reading: 0.204, noise: 0.0, warming: 0.0 };
/// let causes = model.causes();
/// let places: Vec<_> = causes.iter().map(|cause| cause.place).collect();
/// let inputs: Vec<_> = causes.into_iter().map(|cause| cause.into_input()).collect();
/// let budget = Budget::of(|values| model.force(places.iter().copied().zip(values.iter().copied())), &inputs)?;
/// // 76 N by a stiffness known within ±5 %.
/// assert!((budget.combined() - 0.05 / 3.0_f64.sqrt() * 76.0).abs() < 1e-6);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Measurement<'a> {
    /// The sensor.
    pub instrument: &'a Instrument,
    /// Where it sits.
    pub site: Site<'a>,
    /// What its data sheet says.
    pub limits: Limits,
    /// What is known of the spring.
    pub spring: SpringDoubt,
    /// The reading of which the force is asked, in the native unit.
    pub reading: f64,
    /// σ: noise of the readings, as far as it counts, in the native unit ([`super::Readout::noise_within`]).
    pub noise: f64,
    /// Limits of the temperature since the calibration, either way \[K\].
    pub warming: f64,
}

impl Measurement<'_> {
    /// All by which the force errs, but for oscillation, in the order of their places.
    ///
    /// Limits of error, resolution (±q/2) and tolerances are rectangular, noise and calibration normal. The spring's own lines are those of
    /// an estimate; a load cell sees the force itself.
    ///
    /// Source:   `[JCGM100]` 4.3.7 and F.2.2.1 for limits and resolution.
    /// Valid:    causes that are independent of each other.
    /// Accuracy: no sum is formed here; each line alone gives its closed form in a budget.
    pub fn causes(&self) -> Vec<Cause> {
        let (limits, spring) = (&self.limits, &self.spring);
        let step = self.instrument.readout().parameters().resolution.unwrap_or(0.0);
        let estimates = self.instrument.slope().is_some();
        let of_metal = spring.stiffness_drift != 0.0 || spring.expansion != 0.0;
        let drifts = limits.temperature_coefficient != 0.0 || (estimates && of_metal);
        let kelvin = if drifts { self.warming } else { 0.0 };
        let of_instrument = [
            Cause::normal(Place::Reading, cause::NOISE, self.noise),
            Cause::within(Place::Reading, cause::RESOLUTION, 0.5 * step),
            Cause::within(Place::Reading, cause::FULL_SCALE, limits.full_scale),
            Cause::within(Place::Gain, cause::OF_READING, limits.of_reading),
            Cause::normal(Place::Gain, cause::CALIBRATION, limits.calibration),
            Cause::within(Place::Temperature, cause::TEMPERATURE, kelvin),
        ];
        let tension = if spring.tension > 0.0 { spring.initial_tension } else { 0.0 };
        let of_spring = [
            Cause::within(Place::Stiffness, cause::STIFFNESS, spring.stiffness),
            Cause::within(Place::RestLength, cause::REST_LENGTH, spring.rest_length),
            Cause::within(Place::InitialTension, cause::INITIAL_TENSION, tension),
        ];
        let of_spring = of_spring.into_iter().filter(|_| estimates);
        let mut causes: Vec<Cause> = of_instrument.into_iter().chain(of_spring).flatten().collect();
        causes.extend(self.instrument.own_causes(&self.site));
        causes.sort_by_key(|cause| cause.place);
        causes
    }

    /// F of the inputs \[N\]: the reading as the sensor errs, the force that the estimate makes of it as the spring errs, and what is added.
    ///
    /// F̂ = f(z + (x − z + Δx)(1 + g)(1 + c_T ΔT)), of an estimate with (x − z)(1 − e α ΔT) in place of x − z
    /// F = (F̂ − F_0 + s (Δl − α l0 ΔT))(1 + p((1 + κ)(1 + c_k ΔT) − 1)) + F_0(1 + p c_k ΔT)(1 + τ) + s Δc (F̂ − k (l̄ − l0)) + ΔF
    ///
    /// - `deviations`: of each input its place, and how far it is off in the unit of its place: ΔF \[N\], Δx (native), g \[1\], Δl \[m\] (a
    ///   longer rest length counts against it), ΔT \[K\], κ \[1\], τ \[1\], Δc \[m/N\]
    /// - f, z, s and e: force of a reading, reading of no force, dF/dl of the instrument and by how much the spring's expansion shows in its reading; p = s/k;
    ///   x: the reading; c_T and c_k: drift of its gain and of the stiffness; α: expansion, of which a warmer spring that is held as long reads e α more and has
    ///   the longer rest length
    ///
    /// Source:   Hooke's law for a spring that is not the nominal one at the same elongation. In series with a drive train a spring's
    ///           change shows in part only: dk_s/k_s = (k_s/k) dk/k. The rate's tolerance does not act on the tension that was wound in;
    ///           the modulus does.
    /// Valid:    departures of some percent; F_0 = 0 in series with a drive train.
    /// Accuracy: rounding of a spring of other stiffness and rest length at the ends' own positions; in series with a drive train first
    ///           order of κ, c_k ΔT and Δc.
    pub fn force(&self, deviations: impl Iterator<Item = (Place, f64)>) -> f64 {
        let [mut added, mut reading, mut gain, mut kelvin, mut stiffness, mut tension, mut longer, mut softer] =
            [0.0; 8];
        for (place, value) in deviations {
            match place {
                Place::Force => added += value,
                Place::Reading => reading += value,
                Place::Gain => gain += value,
                Place::Length => longer += value,
                Place::Temperature => kelvin += value,
                Place::Stiffness => stiffness += value,
                Place::RestLength => longer -= value,
                Place::InitialTension => tension += value,
                Place::Compliance => softer += value,
            }
        }
        let zero = self.instrument.zero();
        let gain = (1.0 + gain) * (1.0 + self.limits.temperature_coefficient * kelvin);
        let grown = self.spring.expansion * kelvin;
        let cold = (self.reading - zero) * (1.0 - self.instrument.expands(self.reading) * grown);
        let estimate = self.instrument.force(zero + (cold + reading) * gain);
        let Some(slope) = self.instrument.slope() else { return estimate + added };
        // The true spring is not the nominal one: of the same elongation its force differs, and the estimate knows nothing of it.
        let spring = self.site.spring;
        longer -= grown * spring.rest_length();
        let part = slope / spring.stiffness();
        let warm = 1.0 + self.spring.stiffness_drift * kelvin;
        let share = 1.0 + part * ((1.0 + stiffness) * warm - 1.0);
        let wound = self.spring.tension;
        let tensed = wound * (1.0 + part * (warm - 1.0)) * (1.0 + tension);
        let bent = slope * softer * (estimate - spring.static_force(self.site.mean_length));
        (estimate - wound + slope * longer) * share + tensed + bent + added
    }
}
