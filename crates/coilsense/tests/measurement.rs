//! The measurement model of sensors: laws of springs that are not the nominal one, and a kind of sensor that the library does not know.

use std::borrow::Cow;
use std::sync::Arc;

use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::sensors::{
    Cause, FormBy, Instrument, Limits, Measurement, Place, Quantity, Readout, ReadoutParameters, Sensor, Site,
    SpringDoubt,
};
use coilsense::uncertainty::{Budget, MonteCarlo};
use coilsense::{Channel, Error, Signals, Spring, SpringParameters};

const K: f64 = 760.0;
const L0: f64 = 0.104;
const LENGTH: f64 = 0.25;
const MEAN: f64 = 0.23;

fn spring(stiffness: f64, rest_length: f64) -> Spring {
    Spring::new(parameters(stiffness, rest_length)).unwrap()
}

fn parameters(stiffness: f64, rest_length: f64) -> SpringParameters {
    SpringParameters {
        rest_length,
        windings: 52.0,
        coil_radius: 0.008,
        wire_radius: 0.001,
        mass: 0.065,
        stiffness,
        min_length: 0.196,
        max_length: 0.264,
        nominal_force: None,
        inductance_windings: None,
        sections: None,
    }
}

/// Does something with the model of a sensor on the nominal spring.
fn with<T>(sensor: impl Fn(&Site<'_>) -> Arc<dyn Sensor>, reading: f64, look: impl Fn(Measurement<'_>) -> T) -> T {
    let spring = spring(K, L0);
    let coil = MaxwellSum::new(&spring, SelfDistance::default());
    let site = Site { spring: &spring, coil: &coil, mean_length: MEAN };
    let instrument = Instrument::new(Readout::new(ReadoutParameters::default()).unwrap(), sensor(&site));
    let (limits, spring) = (Limits::default(), SpringDoubt::default());
    look(Measurement { instrument: &instrument, site, limits, spring, reading, noise: 0.0, warming: 0.0 })
}

fn budget(model: &Measurement<'_>) -> (Budget, MonteCarlo) {
    let causes = model.causes();
    let places: Vec<Place> = causes.iter().map(|cause| cause.place).collect();
    let inputs: Vec<_> = causes.into_iter().map(Cause::into_input).collect();
    let force = |values: &[f64]| model.force(places.iter().copied().zip(values.iter().copied()));
    (Budget::of(force, &inputs).unwrap(), MonteCarlo::run(force, &inputs, 20_000, 1).unwrap())
}

/// The standard uncertainty that a line of the budget adds \[N\].
fn line(budget: &Budget, name: &str) -> f64 {
    let line = budget.contributions().iter().find(|line| line.name == name);
    line.unwrap_or_else(|| panic!("{name} is not in the budget")).contribution.abs()
}

#[test]
fn a_departing_spring_pulls_with_its_own_stiffness_and_rest_length() {
    let (softer, longer) = (-0.04, 0.7e-3);
    let force = with(
        |site| Quantity::Deflection.on(site).unwrap(),
        LENGTH,
        |model| model.force([(Place::Stiffness, softer), (Place::RestLength, longer)].into_iter()),
    );
    let truth = spring(K * (1.0 + softer), L0 + longer).static_force(LENGTH);
    // Rounding of forces of 100 N.
    assert!((force - truth).abs() < 1e-12, "{force} N, not {truth} N");
}

#[test]
fn behind_a_drive_train_the_model_errs_by_second_order_of_the_stiffness() {
    let compliance = 1.0 / K;
    let encoders = Quantity::TwoEncoder { compliance, compliance_tolerance: 0.0, backlash: 0.0 };
    let off = |share: f64| {
        let elongation = LENGTH - L0;
        let force = with(
            |site| encoders.on(site).unwrap(),
            LENGTH,
            |model| model.force([(Place::Stiffness, share)].into_iter()),
        );
        force - elongation / (1.0 / (K * (1.0 + share)) + compliance)
    };
    let order = (off(0.02) / off(0.01)).log2();
    // Third order adds half a percent here.
    assert!((order - 2.0).abs() < 0.02, "order {order}");
}

#[test]
fn a_warm_spring_between_fixed_ends_is_what_its_inductance_and_its_length_are_corrected_for() {
    let (kelvin, alpha, drift) = (10.0, 17e-6, -3.43e-4);
    let doubt = SpringDoubt { stiffness_drift: drift, expansion: alpha, ..SpringDoubt::default() };
    // All of it grown by α ΔT: rate, rest length, radii.
    let grown = 1.0 + alpha * kelvin;
    let truth = spring(K * (1.0 + drift * kelvin), L0 * grown).static_force(LENGTH);
    let warm = |model: Measurement<'_>| {
        Measurement { spring: doubt, ..model }.force([(Place::Temperature, kelvin)].into_iter())
    };
    let deflection = with(|site| Quantity::Deflection.on(site).unwrap(), LENGTH, warm);
    assert!((deflection - truth).abs() < 1e-9, "{deflection} N, not {truth} N");
    // The meter reads the inductance of the grown coil, where eq. (13) is exact of the cold one.
    let [cold, hot] = [1.0, grown].map(|times| {
        let nominal = parameters(K, L0);
        let (coil_radius, wire_radius) = (times * nominal.coil_radius, times * nominal.wire_radius);
        let coil = Spring::new(SpringParameters { coil_radius, wire_radius, ..nominal }).unwrap();
        MaxwellSum::new(&coil, SelfDistance::default()).at_length(MEAN)
    });
    let truth = spring(K * (1.0 + drift * kelvin), L0 * grown).static_force(MEAN);
    let by_inductance = |site: &Site<'_>| {
        let form_by = FormBy::Measured;
        Quantity::Inductance { uncalibrated: false, form: 0.0, form_by, remounting: 0.0 }.on(site).unwrap()
    };
    let force = with(by_inductance, hot, warm);
    // First order of ΔT, and by eq. (13) in place of the sum; the whole of what L grows by is 60 mN.
    assert!((force - truth).abs() < 1e-3, "{force} N, not {truth} N, L grew by {:e}", hot / cold - 1.0);
}

#[test]
fn a_load_cell_knows_nothing_of_the_spring() {
    let doubt = SpringDoubt {
        stiffness: 0.1,
        rest_length: 1e-3,
        tension: 5.0,
        initial_tension: 0.1,
        stiffness_drift: 1e-3,
        expansion: 1e-5,
    };
    let cell = |site: &Site<'_>| Quantity::Force(coilsense::End::Two).on(site).unwrap();
    let causes = with(cell, 50.0, |model| Measurement { spring: doubt, warming: 10.0, ..model }.causes());
    assert_eq!(causes, []);
}

/// A kind that the library does not know: it reads the square of the length \[m²\], and its mounting is not better known than `mounted`.
#[derive(Debug)]
struct Squared {
    spring: Spring,
    mounted: f64,
}

impl Sensor for Squared {
    fn quantity<'a>(&self, signals: &'a Signals) -> Result<Cow<'a, [f64]>, Error> {
        let (u1, u2) = (signals.channel(Channel::U1)?, signals.channel(Channel::U2)?);
        Ok(u1.iter().zip(u2).map(|(u1, u2)| (u2 - u1).powi(2)).collect())
    }

    fn force_of(&self, reading: f64) -> f64 {
        self.spring.static_force(reading.sqrt())
    }

    fn zero(&self) -> f64 {
        self.spring.rest_length().powi(2)
    }

    fn slope(&self) -> Option<f64> {
        Some(self.spring.stiffness())
    }

    fn own_causes(&self, _: &Site<'_>) -> Vec<Cause> {
        Cause::normal(Place::Length, "mounting", self.mounted).into_iter().collect()
    }
}

#[test]
fn a_kind_that_the_library_does_not_know_goes_through_the_same_budget() {
    let squared =
        |site: &Site<'_>| -> Arc<dyn Sensor> { Arc::new(Squared { spring: site.spring.clone(), mounted: 1e-4 }) };
    let noise = 1e-4;
    let (budget, monte_carlo) = with(squared, LENGTH * LENGTH, |model| {
        budget(&Measurement { noise, spring: SpringDoubt { stiffness: 0.01, ..model.spring }, ..model })
    });
    let force = K * (LENGTH - L0);
    let expected = [
        ("mounting", K * 1e-4),
        ("sensor: noise", K * noise / (2.0 * LENGTH)),
        ("tolerance of the stiffness", 0.01 / 3.0_f64.sqrt() * force),
    ];
    for (name, expected) in expected {
        // The budget's derivatives are differences over a standard uncertainty: the root bends by (σ/l²)²/8 = 3e-7 over one.
        let found = line(&budget, name);
        assert!((found / expected - 1.0).abs() < 1e-6, "{name}: {found} N, not {expected} N");
    }
    // Four standard errors of a standard deviation by 20 000 trials.
    assert!((monte_carlo.standard() / budget.combined() - 1.0).abs() < 4.0 / (2.0 * 20_000.0_f64).sqrt());
}
