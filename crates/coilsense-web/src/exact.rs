//! A case at rest: what `coilsense analyze` computes of it, to the last digit that two processors share.
//!
//! Next door: the quick one (`preview`), the case itself (`coilsense_lab::analysis::Single`).

use coilsense_lab::analysis::Single;
use coilsense_lab::spec::Spec;
use serde_json::{Map, Value, json};

use crate::answer::Answer;
use crate::{contact, facts};

/// A case processed.
#[derive(Debug, Clone)]
pub struct Exact {
    /// The case, its sensors and warnings.
    pub single: Single,
    facts: Value,
}

impl Exact {
    /// Processes the condition and the damping of these numbers.
    ///
    /// # Errors
    /// One line: what the science says of the case.
    pub fn run(spec: &Spec, condition: usize, damping: usize) -> Result<Self, String> {
        let single = Single::run(spec, condition, damping).map_err(|error| error.to_string())?;
        let facts = facts::of_spec(&single.spec, condition, damping);
        Ok(Self { single, facts })
    }

    /// Series: `time` and every channel from t = 0 on, `reading 0` … the force each sensor means, `frequency` and `spectrum F_i` … of the judged
    /// window.
    pub fn answer(self) -> Answer {
        let Single { case, sensors, warnings, spec, .. } = self.single;
        let mut meta = self.facts;
        meta["exact"] = json!(true);
        meta["clash"] = facts::of_clash(&case.clash);
        meta["lengths"] = json!([case.lengths.0, case.lengths.1]);
        let forces: Map<String, Value> =
            case.ideal.iter().map(|(force, off)| (force.name().to_owned(), facts::of_deviation(off))).collect();
        meta["forces"] = Value::Object(forces);
        let of_sensor = sensors.iter().zip(&case.readings).map(|(sensor, reading)| {
            json!({
                "name": sensor.name,
                "kind": sensor.quantity.kind(),
                "sampleRate": sensor.readout.sample_rate,
                "deviation": facts::of_deviation(&reading.deviation),
            })
        });
        meta["sensors"] = of_sensor.collect();
        meta["contact"] = contact::of_case(&spec.mount.cases[case.damping], case.contacts.as_ref());
        meta["warnings"] = warnings.iter().map(|w| json!({ "subject": w.subject.name(), "text": w.text })).collect();

        let mut series = vec![("time".to_owned(), case.signals.time().to_vec())];
        series.extend(case.signals.channels().map(|(channel, values)| (channel.name().to_owned(), values.to_vec())));
        let readings = case.readings.into_iter().enumerate();
        series.extend(readings.map(|(number, reading)| (format!("reading {number}"), reading.force)));
        for (force, spectrum) in &case.spectra {
            if series.iter().all(|(name, _)| name != "frequency") {
                series.push(("frequency".to_owned(), spectrum.frequencies()));
            }
            series.push((format!("spectrum {}", force.name()), spectrum.amplitudes().to_vec()));
        }
        series.extend(case.contacts.iter().flat_map(contact::series));
        Answer::new(&meta, series)
    }
}
