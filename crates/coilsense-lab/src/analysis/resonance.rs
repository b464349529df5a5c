//! Resonances that the tolerances move onto the input.
//!
//! Next door: other things that a reader must know (`warnings`), how errors change from spring to spring (`response`).

use std::f64::consts::TAU;

use coilsense::excitation::Content;
use coilsense::modes::ModalModel;
use coilsense::{End, Error};

use super::judge::Judge;
use super::response::Responses;
use super::verdict::{self, Verdict};
use super::warnings::{Subject, Warning};
use crate::quantity::digits;
use crate::spec::{Model, SensorSpec, Spec};
use crate::study::Masses;

/// An error that grows by less than this from the nominal spring to the loudest is no resonance.
const GROWS: f64 = 1.5;

/// Frequencies that are no farther apart are one line.
const SAME_LINE: f64 = 1e-6;

/// A warning for each condition in which a mode of a spring that the tolerances allow meets a line of the input.
pub(super) fn of(
    judge: &Judge<'_>,
    sensors: &[SensorSpec],
    verdicts: &[Verdict],
    responses: &[Responses],
) -> Result<Vec<Warning>, Error> {
    let each = (0..judge.spec.conditions.len()).map(|condition| {
        let lines = lines(judge.spec, condition);
        let text = match lines.is_empty() {
            true => by_response(judge, sensors, verdicts, responses, condition),
            false => by_lines(judge, condition, &lines)?,
        };
        Ok(text.map(|text| Warning { subject: Subject::Resonance, text }))
    });
    each.filter_map(Result::transpose).collect()
}

/// A warning for each condition whose rms has no limit.
pub(super) fn without_limit(masses: &Masses, model: Model) -> Option<Warning> {
    let names = masses.without_limit.join(", ");
    let what = match model {
        Model::Helix => "modes (those up to 20 f1 here)".to_owned(),
        Model::Coil | Model::Chain => format!("masses ({} per winding here)", masses.per_winding),
    };
    let text = format!(
        "{names}: a position that jumps hits every mode alike, so that the rms and the largest value of the end forces grow with the number of \
         {what}; what a low-pass leaves of them, or a ramp in place of the jump, has a limit."
    );
    (!masses.without_limit.is_empty()).then_some(Warning { subject: Subject::NoLimit, text })
}

/// Frequencies of the sines that drive the ends \[Hz\].
pub(super) fn lines(spec: &Spec, condition: usize) -> Vec<f64> {
    let excitation = &spec.conditions[condition].excitation;
    let of = |end| match excitation.input(end).content() {
        Content::Lines(sines) => sines.iter().filter(|sine| sine.amplitude != 0.0).map(|s| s.frequency).collect(),
        Content::Nothing | Content::Broad => Vec::new(),
    };
    [End::One, End::Two].into_iter().flat_map(of).collect()
}

/// The same of all conditions with the number of the condition, each frequency once, of the first that has it.
pub fn driven(spec: &Spec) -> Vec<(usize, f64)> {
    let mut found: Vec<(usize, f64)> = Vec::new();
    for condition in 0..spec.conditions.len() {
        for hertz in lines(spec, condition) {
            let is_new = found.iter().all(|(_, other)| (other / hertz - 1.0).abs() > SAME_LINE);
            if hertz > 0.0 && is_new {
                found.push((condition, hertz));
            }
        }
    }
    found
}

/// Whether a condition drives every frequency: by an input that is no sine, or by how it begins.
pub fn is_broad(spec: &Spec, condition: usize) -> bool {
    let excitation = &spec.conditions[condition].excitation;
    let has_broad =
        [End::One, End::Two].into_iter().any(|end| matches!(excitation.input(end).content(), Content::Broad));
    has_broad || lines(spec, condition).is_empty()
}

/// The lowest mode whose band holds a line.
fn by_lines(judge: &Judge<'_>, condition: usize, lines: &[f64]) -> Result<Option<String>, Error> {
    let spec = judge.spec;
    let factors = judge.springs.specimens.each.iter().map(|specimen| specimen.frequency());
    let (low, high) = factors.fold((1.0_f64, 1.0_f64), |(low, high), factor| (low.min(factor), high.max(factor)));
    let modes = ModalModel::chain(&spec.spring.spring, spec.mount.far_end());
    for (mode, angular) in modes.frequencies().iter().enumerate() {
        let frequency = angular / TAU;
        let (from, to) = (low * frequency, high * frequency);
        if let Some(line) = lines.iter().find(|line| (from..=to).contains(*line)) {
            return Ok(Some(format!(
                "{}: the input's {} Hz lie inside the band in which mode {} of such springs may be, {} to {} Hz ({} Hz here): how much it \
                 rings differs from specimen to specimen. Measure that frequency (hit the spring, `coilsense identify`).",
                spec.conditions[condition].name,
                digits(*line),
                mode + 1,
                digits(from),
                digits(to),
                digits(frequency),
            )));
        }
    }
    Ok(None)
}

/// An input without lines of its own, a recording, whose error grows by much for some specimens.
fn by_response(
    judge: &Judge<'_>,
    sensors: &[SensorSpec],
    verdicts: &[Verdict],
    responses: &[Responses],
    condition: usize,
) -> Option<String> {
    let of_condition = |number: &usize| judge.cases[*number].condition == condition;
    let mut loudest: Option<(f64, usize, usize)> = None;
    for number in (0..judge.cases.len()).filter(of_condition) {
        for verdict in verdicts {
            let assessment = &verdict.assessments[number];
            let grows = assessment.loudest / assessment.oscillation.max(f64::MIN_POSITIVE);
            let counts = assessment.over_specimens > 0.5 * assessment.combined;
            let counts = counts && verdict::matters(judge.spec, assessment.loudest);
            if counts && grows > GROWS && loudest.is_none_or(|(most, ..)| grows > most) {
                loudest = Some((grows, number, verdict.sensor));
            }
        }
    }
    let (_, number, sensor) = loudest?;
    let (spec, factor) = (judge.spec, responses[number].loudest(sensor));
    let assessment = verdicts.iter().find(|verdict| verdict.sensor == sensor)?.assessments[number];
    let modes = ModalModel::chain(&spec.spring.spring, spec.mount.far_end());
    let first = modes.frequencies().first()? / TAU;
    Some(format!(
        "{}, {}: how much the spring rings differs from specimen to specimen: the oscillation alone puts {} off by {} N on the nominal spring \
         (first mode {} Hz) and by up to {} N on others, most near {} Hz. Measure that frequency (hit the spring, `coilsense identify`).",
        spec.conditions[condition].name,
        spec.mount.cases[judge.cases[number].damping].label,
        sensors[sensor].name,
        digits(assessment.oscillation),
        digits(first),
        digits(assessment.loudest),
        digits(factor * first),
    ))
}
