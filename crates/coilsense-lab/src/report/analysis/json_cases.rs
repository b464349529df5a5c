//! Each condition at each damping, for machines.
//!
//! Next door: the analysis that holds them (`json`).

use std::collections::BTreeMap;

use coilsense::Deviation;
use serde::Serialize;

use crate::analysis::{Analysis, Assessment, Case};

/// A condition at a damping.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub(super) struct CaseRow<'a> {
    condition: &'a str,
    kind: &'static str,
    damping: &'a str,
    damping_ratio: Option<f64>,
    window_s: [f64; 2],
    sample_rate_hz: f64,
    /// Of each force at the spring's ends, how far it is from the true one.
    forces: BTreeMap<&'static str, DeviationPart>,
    sensors: Vec<ReadingRow<'a>>,
    shortest_length_m: f64,
    longest_length_m: f64,
    /// Null for a single winding, which has no neighbour.
    smallest_pitch_m: Option<f64>,
    smallest_gap_m: Option<f64>,
    /// When windings first touch; null where they do not.
    first_contact_s: Option<f64>,
}

/// How one sensor did in one case.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ReadingRow<'a> {
    sensor: &'a str,
    deviation: DeviationPart,
    #[serde(flatten)]
    assessment: Option<&'a Assessment>,
}

/// How far a force is from the true one; percent are of F_nom.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct DeviationPart {
    rmsd_n: f64,
    rmsd_percent: f64,
    maximum_n: f64,
    maximum_absolute_n: f64,
    maximum_absolute_percent: f64,
    mean_n: f64,
    mean_percent: f64,
    standard_error_n: f64,
}

impl<'a> CaseRow<'a> {
    pub fn of(analysis: &'a Analysis, case: &'a Case) -> Self {
        let spec = &analysis.spec;
        let nominal = spec.spring.spring.nominal_force();
        let number = case.condition * spec.mount.cases.len() + case.damping;
        let sensors = analysis.sensors.iter().enumerate().zip(&case.readings).map(|((index, sensor), reading)| {
            let verdict = analysis.verdicts.iter().find(|verdict| verdict.sensor == index);
            ReadingRow {
                sensor: &sensor.name,
                deviation: DeviationPart::of(&reading.deviation, nominal),
                assessment: verdict.map(|verdict| &verdict.assessments[number]),
            }
        });
        let ideal = case.ideal.iter();
        let pitch = Some(case.clash.smallest_pitch).filter(|pitch| pitch.is_finite());
        let condition = &spec.conditions[case.condition];
        let damping = &spec.mount.cases[case.damping];
        Self {
            condition: &condition.name,
            kind: condition.kind,
            damping: &damping.label,
            damping_ratio: damping.ratio,
            window_s: [condition.window.0, condition.window.1],
            sample_rate_hz: condition.sample_rate,
            forces: ideal.map(|(channel, found)| (channel.name(), DeviationPart::of(found, nominal))).collect(),
            sensors: sensors.collect(),
            shortest_length_m: case.lengths.0,
            longest_length_m: case.lengths.1,
            smallest_pitch_m: pitch.map(|pitch| spec.spring.winding_pitch(pitch)),
            smallest_gap_m: pitch.map(|pitch| spec.spring.gap(pitch)),
            first_contact_s: case.clash.first_contact,
        }
    }
}

impl DeviationPart {
    fn of(deviation: &Deviation, nominal: f64) -> Self {
        let percent = |newton: f64| 100.0 * newton / nominal;
        Self {
            rmsd_n: deviation.rmsd,
            rmsd_percent: percent(deviation.rmsd),
            maximum_n: deviation.maximum,
            maximum_absolute_n: deviation.maximum_absolute,
            maximum_absolute_percent: percent(deviation.maximum_absolute),
            mean_n: deviation.mean,
            mean_percent: percent(deviation.mean),
            standard_error_n: deviation.standard_error,
        }
    }
}
