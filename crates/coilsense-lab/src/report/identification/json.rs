//! An identification for machines, in SI units, as the names of its keys say.
//!
//! Next door: the same for people (`text`, `html`).

use coilsense::identify::{Estimate, Identification, Line, Meaning, ModeSeries, Trust};
use serde::Serialize;

use crate::identification::{Identified, answer, component_name};
use crate::report::outcome::{Outcome, to_json};

/// What a log says of its spring; null for what was not found.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct IdentificationOutcome<'a> {
    date: Option<&'a str>,
    file: &'a str,
    /// What the log says of its being simulated, where it does.
    simulated: Option<&'a str>,
    /// Whether it is the spring that rings, in a word.
    verdict: &'static str,
    evidence: &'a [String],
    /// What to record next to know more.
    record_next: &'a [String],
    /// The answer, a sentence each.
    answer: Vec<String>,
    samples: usize,
    sample_rate_hz: f64,
    /// When the spring was hit.
    hits_s: Vec<f64>,
    first_frequency_hz: Option<EstimatePart>,
    damping_ratio: Option<EstimatePart>,
    stiffness_n_per_m: Option<EstimatePart>,
    length_at_zero_force_m: Option<EstimatePart>,
    /// Whether that length is between both ends' positions; else it is end 1's alone.
    length_is_of_both_ends: Option<bool>,
    length_range_m: Option<[f64; 2]>,
    no_stiffness_because: Option<&'a str>,
    mass_kg: Option<EstimatePart>,
    /// From one end to the other.
    transit_time_s: Option<EstimatePart>,
    mount: Option<&'static str>,
    /// End mass over the spring's.
    mass_ratio: Option<f64>,
    end_mass_kg: Option<f64>,
    windings_fitted: Option<f64>,
    /// From stiffness and mass.
    predicted_first_frequency_hz: Option<f64>,
    trust: Option<TrustPart>,
    lines: Vec<LineRow<'a>>,
    /// What became of the log's rows, line by line.
    account: &'a [String],
}

impl Outcome for IdentificationOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/identification/2";
}

/// A number and how sure it is.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct EstimatePart {
    value: f64,
    standard_uncertainty: f64,
    /// Lower end of the interval of 95 %.
    low: f64,
    high: f64,
}

/// Up to which frequency one force may be taken for another.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct TrustPart {
    /// The relative error that it then has.
    tolerance: f64,
    output_for_input_hz: f64,
    deflection_for_input_hz: f64,
    deflection_for_output_hz: f64,
}

/// A line of the spectrum.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct LineRow<'a> {
    /// Undamped.
    frequency_hz: EstimatePart,
    /// Of the ring-down; null for a steady line.
    damping_ratio: Option<EstimatePart>,
    damping_ratio_half_power: Option<EstimatePart>,
    no_half_power_because: Option<&'a str>,
    decays: bool,
    /// Right after a hit, or of a steady line.
    amplitude_n: f64,
    /// "antisymmetric" (½(F_o − F_i), odd modes between held ends), "symmetric" (½(F_o + F_i)), a channel, or "mixed".
    component: &'static str,
    /// How many hits its fit took.
    hits: usize,
    /// "mode", "alias", "mains", "follows the ends" or "unknown".
    kind: &'static str,
    /// Of the mode, or multiple of the mains.
    number: Option<usize>,
    /// The true frequency of an alias.
    unfolded_hz: Option<f64>,
    reason: &'a str,
}

impl<'a> IdentificationOutcome<'a> {
    /// Of a log that was read.
    pub fn of(identified: &'a Identified, date: Option<&'a str>) -> Self {
        let found: &Identification = &identified.found;
        let line = found.stiffness.as_ref().ok();
        Self {
            date,
            file: &identified.file,
            simulated: identified.simulated.as_deref(),
            verdict: found.verdict.answer.name(),
            evidence: &found.verdict.evidence,
            record_next: &found.verdict.next,
            answer: answer(identified),
            samples: found.sampling.samples,
            sample_rate_hz: found.sampling.rate,
            hits_s: found.hits.iter().map(|hit| hit.time).collect(),
            first_frequency_hz: EstimatePart::maybe(&found.first_frequency),
            damping_ratio: EstimatePart::maybe(&found.ratio),
            stiffness_n_per_m: line.map(|line| EstimatePart::of(&line.stiffness)),
            length_at_zero_force_m: line.map(|line| EstimatePart::of(&line.length_at_zero)),
            length_is_of_both_ends: line.map(|line| line.both_positions),
            length_range_m: line.map(|line| [line.range.0, line.range.1]),
            no_stiffness_because: found.stiffness.as_ref().err().map(String::as_str),
            mass_kg: EstimatePart::maybe(&found.mass),
            transit_time_s: EstimatePart::maybe(&found.transit_time),
            mount: found.mode_series.map(|series| series.name()),
            mass_ratio: match found.mode_series {
                Some(ModeSeries::EndMass { mass_ratio }) => Some(mass_ratio),
                Some(ModeSeries::HeldHeld | ModeSeries::HeldFree) | None => None,
            },
            end_mass_kg: found.end_mass,
            windings_fitted: found.fitted_windings,
            predicted_first_frequency_hz: found.predicted,
            trust: found.trust.as_ref().map(TrustPart::of),
            lines: found.lines.iter().map(LineRow::of).collect(),
            account: &identified.account,
        }
    }
}

impl EstimatePart {
    fn of(estimate: &Estimate) -> Self {
        let Estimate { value, standard, expanded } = *estimate;
        Self { value, standard_uncertainty: standard, low: value - expanded, high: value + expanded }
    }

    fn maybe(estimate: &Option<Estimate>) -> Option<Self> {
        estimate.as_ref().map(Self::of)
    }
}

impl TrustPart {
    fn of(trust: &Trust) -> Self {
        Self {
            tolerance: trust.tolerance,
            output_for_input_hz: trust.output_for_input,
            deflection_for_input_hz: trust.deflection_for_input,
            deflection_for_output_hz: trust.deflection_for_output,
        }
    }
}

impl<'a> LineRow<'a> {
    fn of(line: &'a Line) -> Self {
        let (kind, number, unfolded_hz) = match line.meaning {
            Meaning::Mode(mode) => ("mode", Some(mode), None),
            Meaning::Alias { mode, frequency } => ("alias", Some(mode), Some(frequency)),
            Meaning::Mains { multiple, .. } => ("mains", Some(multiple), None),
            Meaning::Follows => ("follows the ends", None, None),
            Meaning::Unknown => ("unknown", None, None),
        };
        Self {
            frequency_hz: EstimatePart::of(&line.frequency),
            damping_ratio: line.ratio.as_ref().filter(|_| line.decays).map(EstimatePart::of),
            damping_ratio_half_power: line.half_power.as_ref().ok().map(EstimatePart::of),
            no_half_power_because: line.half_power.as_ref().err().map(String::as_str),
            decays: line.decays,
            amplitude_n: line.amplitude,
            component: component_name(line.part),
            hits: line.hits,
            kind,
            number,
            unfolded_hz,
            reason: &line.reason,
        }
    }
}

/// The whole identification as JSON.
///
/// # Errors
/// [`serde_json::Error`] where it cannot be written.
pub fn identification_json(identified: &Identified, date: Option<&str>) -> Result<String, serde_json::Error> {
    to_json(IdentificationOutcome::of(identified, date))
}
