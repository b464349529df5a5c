//! An identification for machines, in SI units, as the names of its keys say.
//!
//! Next door: the same for people (`text`, `html`).

use coilsense::identify::{ChannelCheck, Estimate, Identification, Line, Meaning, ModeSeries, Trust, Weight};
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
    /// Where f1 lies with 95 %: noise, and what a mount that gives may do to it.
    first_frequency_range_hz: Option<[f64; 2]>,
    damping_ratio: Option<EstimatePart>,
    /// The mode that it belongs to.
    damping_ratio_mode: Option<usize>,
    stiffness_n_per_m: Option<EstimatePart>,
    length_at_zero_force_m: Option<EstimatePart>,
    /// Whether that length is between both ends' positions; else it is end 1's alone.
    length_is_of_both_ends: Option<bool>,
    length_range_m: Option<[f64; 2]>,
    no_stiffness_because: Option<&'a str>,
    mass_kg: Option<EstimatePart>,
    /// Where it lies with 95 %: noise, and what a mount that gives may do to f1.
    mass_range_kg: Option<[f64; 2]>,
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
    /// The channel whose sign is turned, where one is.
    sign_turned: Option<&'static str>,
    /// What may be the cause of the lines, the likeliest first.
    explanations: Vec<ExplanationRow<'a>>,
    /// What instruments did to the forces.
    channels: Vec<ChannelRow>,
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

/// A cause of lines.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ExplanationRow<'a> {
    cause: &'a str,
    /// Natural logarithm of its evidence over that of lines that have nothing in common.
    evidence_nats: f64,
    /// Share of the ringing's energy that it explains.
    share: f64,
    /// f1 of the coil between held ends; null for what is no coil.
    first_frequency_hz: Option<f64>,
}

/// A force's channel; null for what it does not show.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ChannelRow {
    channel: &'static str,
    /// How often it has a new value, where that is less often than the log's rate.
    update_rate_hz: Option<f64>,
    last_digit_n: Option<f64>,
    /// Share of the samples at a limit, where it is clipped.
    clipped_share: Option<f64>,
    /// Corner of a low-pass, roughly.
    low_pass_hz: Option<f64>,
    /// Frequency of slow motion that the force misses: a high-pass lies above.
    high_pass_above_hz: Option<f64>,
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
    /// "mode", "alias", "mains", "follows the ends", "torsional", "lateral" or "unknown".
    kind: &'static str,
    /// Of the mode, of the axial mode beside a torsional line, or multiple of the mains.
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
            first_frequency_range_hz: found.first_range.map(|(low, high)| [low, high]),
            damping_ratio: EstimatePart::maybe(&found.ratio),
            damping_ratio_mode: found.ratio_mode,
            stiffness_n_per_m: line.map(|line| EstimatePart::of(&line.stiffness)),
            length_at_zero_force_m: line.map(|line| EstimatePart::of(&line.length_at_zero)),
            length_is_of_both_ends: line.map(|line| line.both_positions),
            length_range_m: line.map(|line| [line.range.0, line.range.1]),
            no_stiffness_because: found.stiffness.as_ref().err().map(String::as_str),
            mass_kg: EstimatePart::maybe(&found.mass),
            mass_range_kg: found.mass_range.map(|(low, high)| [low, high]),
            transit_time_s: EstimatePart::maybe(&found.transit_time),
            mount: found.mode_series.map(|series| series.name()),
            mass_ratio: match found.mode_series {
                Some(ModeSeries::EndMass { mass_ratio }) => Some(mass_ratio),
                Some(ModeSeries::HeldHeld | ModeSeries::HeldFree | ModeSeries::Gives { .. }) | None => None,
            },
            end_mass_kg: found.end_mass,
            windings_fitted: found.fitted_windings,
            predicted_first_frequency_hz: found.predicted,
            trust: found.trust.as_ref().map(TrustPart::of),
            sign_turned: found.turned.map(|channel| channel.name()),
            explanations: found.explanations.iter().map(ExplanationRow::of).collect(),
            channels: found.channels.iter().map(ChannelRow::of).collect(),
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

impl<'a> ExplanationRow<'a> {
    fn of(weight: &'a Weight) -> Self {
        let Weight { name, evidence, share, first_frequency } = weight;
        Self { cause: name, evidence_nats: *evidence, share: *share, first_frequency_hz: *first_frequency }
    }
}

impl ChannelRow {
    fn of(check: &ChannelCheck) -> Self {
        Self {
            channel: check.channel.name(),
            update_rate_hz: check.update_rate,
            last_digit_n: check.last_digit,
            clipped_share: check.clipping.map(|clipping| clipping.share),
            low_pass_hz: check.low_pass,
            high_pass_above_hz: check.high_pass,
        }
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
            Meaning::Torsional { mode } => ("torsional", mode, None),
            Meaning::Lateral => ("lateral", None, None),
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
