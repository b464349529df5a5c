//! A kind of sensor that only this test knows: what implements `coilsense::sensors::Sensor` is judged like those that specs name.
//!
//! Next door: the judgement (`judge`).

use std::borrow::Cow;
use std::sync::Arc;

use coilsense::sensors::{Cause, Instrument, Place, Quantity, Readout, ReadoutParameters, Sensor, Site};
use coilsense::{Channel, Error, Signals};

use super::judge::Judge;
use super::simulate;
use super::specimen::{MANY, Springs};
use crate::spec::{SensorSpec, Spec, SpringInductance};

/// It counts the force at end 2 in half newtons, and miscounts.
#[derive(Debug)]
struct HalfNewtons;

impl Sensor for HalfNewtons {
    fn quantity<'a>(&self, signals: &'a Signals) -> Result<Cow<'a, [f64]>, Error> {
        Ok(signals.channel(Channel::OutputForce)?.iter().map(|force| 2.0 * force).collect())
    }

    fn force_of(&self, reading: f64) -> f64 {
        0.5 * reading
    }

    fn zero(&self) -> f64 {
        0.0
    }

    fn slope(&self) -> Option<f64> {
        None
    }

    fn own_causes(&self, _: &Site<'_>) -> Vec<Cause> {
        Cause::normal(Place::Reading, "miscounts", 3.0).into_iter().collect()
    }
}

#[test]
fn a_kind_that_no_spec_names_is_judged_by_what_it_errs_by() {
    let text = format!(
        "{}\n[mount]\ndamping_ratio = 0\n[goal]\nerror = \"2 N\"\n[[condition]]\nkind = \"impact\"\nvelocity = \"0 m/s\"\n\
         duration = \"10 ms\"\nsample_rate = \"1 kHz\"\n",
        include_str!("../../data/springs/S_T.toml")
    );
    let spec = Spec::parse("toy.toml", &text, &|name| Err(format!("{name}: no files here"))).unwrap();
    let cases = simulate(&spec, &|_, _| true).unwrap();
    let coil = SpringInductance::of(&spec.spring).unwrap();
    let springs = Springs::of(&spec, &spec.spring.tolerances, MANY);
    let helices = crate::study::Helices::default();
    let judge = Judge { spec: &spec, coil: &coil, helices: &helices, cases: &cases, springs: &springs };
    let perfect = SensorSpec::perfect("toy", Quantity::Force(coilsense::End::Two), 1.0);
    let scene = cases[0].scene(&perfect, &spec.goal);
    let toy = Instrument::new(Readout::new(ReadoutParameters::default()).unwrap(), Arc::new(HalfNewtons));
    let counted = judge.counted(scene, &toy.forces(&toy.steady_readings(scene.signals).unwrap())).unwrap();
    let assessment = judge.assessment(&perfect, &toy, scene, counted, None).unwrap();
    // Of a spring that hangs still all is the miscount, 3 half newtons; its oscillation is rounding.
    assert!((assessment.combined - 1.5).abs() < 1e-9, "{} N", assessment.combined);
}
