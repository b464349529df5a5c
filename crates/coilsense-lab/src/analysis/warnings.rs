//! What a reader must know before using the numbers: where the linear model ends, what sampling folds, what the axial model leaves out.
//!
//! Next door: the judgement of sensors (`verdict`).

use coilsense::measures::{Spectrum, alias_of};
use coilsense::modes::ModalModel;
use coilsense::sensors::{Readout, ReadoutParameters};
use coilsense::{Channel, End, Error};

use super::case::Case;
use super::judge::Judge;
use super::rank::has_limits;
use super::{magnetisation, met, overload};
use crate::data_sheet::DataSheet;
use crate::quantity::digits;
use crate::spec::{SensorSpec, Spec, why_no_contact};

/// Something that a reader must know.
#[derive(Debug, Clone, PartialEq)]
pub struct Warning {
    /// What it is about.
    pub subject: Subject,
    /// In a sentence or two.
    pub text: String,
}

/// What a warning is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// A line of the input inside the band that tolerances give a mode.
    Resonance,
    /// Figures that have no limit for many masses.
    NoLimit,
    /// A window that begins after what rings is louder.
    Window,
    /// Windings touch, and pass through one another.
    Clash,
    /// Windings meet, or ends leave their seats, as the spec asks.
    Contact,
    /// A length out of range.
    Length,
    /// An end that can only push, and would have to pull.
    Lift,
    /// Values of the spring that do not fit together.
    Doubt,
    /// A surge line above half a sample rate.
    Alias,
    /// A reading above full scale.
    Range,
    /// An instrument of which nothing is told that could be wrong.
    Instrument,
    /// A drift that is not known.
    Temperature,
    /// Torsional or lateral motion.
    Neighbour,
    /// Magnetic wire whose inductance is told in part only.
    Magnetisation,
}

impl Subject {
    /// Its name in `results.json`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Resonance => "resonance",
            Self::NoLimit => "no_limit",
            Self::Window => "window",
            Self::Clash => "clash",
            Self::Contact => "contact",
            Self::Length => "length",
            Self::Lift => "lift",
            Self::Doubt => "doubt",
            Self::Alias => "alias",
            Self::Range => "range",
            Self::Instrument => "instrument",
            Self::Temperature => "temperature",
            Self::Neighbour => "neighbour",
            Self::Magnetisation => "magnetisation",
        }
    }
}

/// A folded line counts from this share of F_nom on.
const LEAST_LINE: f64 = 1e-4;

/// All warnings, the gravest first.
pub(super) fn of(judge: &Judge<'_>, sensors: &[SensorSpec], sheet: &DataSheet) -> Result<Vec<Warning>, Error> {
    let (spec, cases) = (judge.spec, judge.cases);
    let mut warnings = Vec::new();
    let magnetised = |text| Warning { subject: Subject::Magnetisation, text };
    for condition in 0..spec.conditions.len() {
        let of_condition: Vec<&Case> = cases.iter().filter(|case| case.condition == condition).collect();
        of_motion(spec, &of_condition, &mut warnings)?;
        warnings.extend(magnetisation::uneven(spec, &of_condition).map(magnetised));
    }
    warnings.extend(damping(spec));
    warnings.extend(sheet.doubts.iter().map(|text| Warning { subject: Subject::Doubt, text: text.clone() }));
    for (index, sensor) in sensors.iter().enumerate() {
        warnings.extend(faultless(sensor));
        warnings.extend(alias(judge, sensor)?);
        let range = overload::warning(spec, index, sensor, cases);
        warnings.extend(range.map(|text| Warning { subject: Subject::Range, text }));
        warnings.extend(magnetisation::frequency(&spec.spring, sensor).map(magnetised));
    }
    warnings.extend(magnetisation::untold(spec, sensors).map(magnetised));
    warnings.extend(temperature(spec, sensors));
    warnings.extend(magnetisation::drift(spec, sensors).map(|text| Warning { subject: Subject::Temperature, text }));
    warnings.extend(sheet.beyond_axial.iter().map(|text| Warning { subject: Subject::Neighbour, text: text.clone() }));
    Ok(warnings)
}

/// Where a simulated motion is not what the spring would do: windings that touch, meet, lengths out of range, ends that would have to pull.
///
/// # Errors
/// Those of the science.
pub fn of_simulated(spec: &Spec, cases: &[Case]) -> Result<Vec<Warning>, Error> {
    let mut warnings: Vec<Warning> = damping(spec).into_iter().collect();
    for condition in 0..spec.conditions.len() {
        let of_condition: Vec<&Case> = cases.iter().filter(|case| case.condition == condition).collect();
        of_motion(spec, &of_condition, &mut warnings)?;
    }
    Ok(warnings)
}

/// The same of the cases of one condition.
fn of_motion(spec: &Spec, cases: &[&Case], warnings: &mut Vec<Warning>) -> Result<(), Error> {
    warnings.extend(clash(spec, cases));
    let met = met::of(spec, cases);
    warnings.extend(met.map(|text| Warning { subject: Subject::Contact, text }));
    warnings.extend(length(spec, cases));
    warnings.extend(lift(spec, cases)?);
    Ok(())
}

/// Unusual damping. A page has it with its verdict, after its first load.
fn damping(spec: &Spec) -> Option<Warning> {
    let doubt = if cfg!(feature = "contact") { spec.mount.doubt() } else { None };
    doubt.map(|text| Warning { subject: Subject::Doubt, text })
}

/// Windings that touch, under the damping where they come nearest.
fn clash(spec: &Spec, cases: &[&Case]) -> Option<Warning> {
    if cases.iter().any(|case| case.contacts.is_some()) {
        return None;
    }
    let nearest = cases.iter().min_by(|a, b| a.clash.smallest_pitch.total_cmp(&b.clash.smallest_pitch))?;
    let contact = nearest.clash.first_contact?;
    let clear: Vec<&str> = cases
        .iter()
        .filter(|case| !case.clash.happens())
        .map(|case| spec.mount.cases[case.damping].label.as_str())
        .collect();
    let touching = cases.iter().filter(|case| case.clash.happens() && case.damping != nearest.damping);
    let too: Vec<&str> = touching.map(|case| spec.mount.cases[case.damping].label.as_str()).collect();
    let also = if too.is_empty() { String::new() } else { format!(" They touch at {} too.", too.join(", ")) };
    let until = if clear.is_empty() { String::new() } else { format!(" They stay clear at {}.", clear.join(", ")) };
    let mut text = format!(
        "{}, {}: windings touch from t = {contact:.3} s on; at t = {:.3} s they would overlap by {:.2} mm. The numbers after that \
         lie beyond what this spring can do.{also}{until}",
        spec.conditions[nearest.condition].name,
        spec.mount.cases[nearest.damping].label,
        nearest.clash.time,
        -1e3 * spec.spring.gap(nearest.clash.smallest_pitch),
    );
    // A page has it with the rest of contact, after its first load.
    if cfg!(feature = "contact") && why_no_contact(&spec.spring).is_none() {
        text.push_str(" A table [contact] in the spec lets them meet.");
    }
    Some(Warning { subject: Subject::Clash, text })
}

/// Lengths below the solid length, or out of the range in use.
fn length(spec: &Spec, cases: &[&Case]) -> Option<Warning> {
    let shortest = cases.iter().map(|case| case.lengths.0).fold(f64::INFINITY, f64::min);
    let longest = cases.iter().map(|case| case.lengths.1).fold(f64::NEG_INFINITY, f64::max);
    let name = &spec.conditions[cases.first()?.condition].name;
    let said = spec.spring.out_of_use(shortest, longest)?;
    Some(Warning { subject: Subject::Length, text: format!("{name}: {said}") })
}

/// An end lifts off from this share of F_nom on; below it is rounding of a spring that hangs loose.
const LEAST_LIFT: f64 = 1e-3;

/// How an end that can only push is pulled.
struct Pull {
    end: End,
    damping: usize,
    /// When first \[s\].
    first: f64,
    /// The largest force \[N\], and when \[s\].
    largest: (f64, f64),
    /// Whether the judged part has such a force.
    is_judged: bool,
}

/// Ends of a compression spring that would have to pull, and hooks that would have to push, under the damping where they do so hardest.
fn lift(spec: &Spec, cases: &[&Case]) -> Result<Option<Warning>, Error> {
    // Hooks are the other way round.
    let hooks = spec.spring.geometry.parameters().end_type.is_extension();
    let sign = if hooks { -1.0 } else { 1.0 };
    let mut pulls = Vec::new();
    for case in cases {
        for (end, channel) in [(End::One, Channel::InputForce), (End::Two, Channel::OutputForce)] {
            pulls.extend(pull(spec, case, end, case.signals.channel(channel)?, sign));
        }
    }
    let Some(worst) = pulls.iter().max_by(|a, b| a.largest.0.total_cmp(&b.largest.0)) else { return Ok(None) };
    let of_end = |pull: &Pull| {
        let name = if pull.end == End::One { "end 1" } else { "end 2" };
        format!(
            "{name} from t = {:.4} s on, by up to {} N at t = {:.4} s",
            pull.first,
            digits(pull.largest.0),
            pull.largest.1
        )
    };
    let ends: Vec<String> = pulls.iter().filter(|pull| pull.damping == worst.damping).map(of_end).collect();
    let label = |damping: usize| spec.mount.cases[damping].label.as_str();
    let mut others: Vec<&str> =
        pulls.iter().filter(|pull| pull.damping != worst.damping).map(|pull| label(pull.damping)).collect();
    others.dedup();
    let also = if others.is_empty() { String::new() } else { format!(" So they would at {}.", others.join(", ")) };
    let judged =
        if pulls.iter().any(|pull| pull.is_judged) { "" } else { " The judged part itself has no such force." };
    let (wrong, then) = match hooks {
        true => ("hooks can only pull, and would have to push", "Give the end_type of a spring that is pressed."),
        false => (
            "ends that can only push would have to pull",
            "A real spring lifts off its seat there, which the model does not know; the numbers after that lie beyond what this spring can do.",
        ),
    };
    let text = format!(
        "{}, {}: {wrong}: {}. {then}{also}{judged}",
        spec.conditions[cases[0].condition].name,
        label(worst.damping),
        ends.join("; "),
    );
    Ok(Some(Warning { subject: Subject::Lift, text }))
}

/// A sensor of which nothing is told that could be wrong for long: its uncertainty is that of the oscillation, and of noise and steps.
fn faultless(sensor: &SensorSpec) -> Option<Warning> {
    let steps = sensor.readout.noise + sensor.readout.resolution.unwrap_or_default();
    let (what, counts) = match steps > 0.0 {
        true => ("limit of error (accuracy_full_scale, accuracy_reading)", "oscillation, spring, noise and resolution"),
        false => ("noise, resolution or limit of error", "oscillation and spring"),
    };
    (!has_limits(sensor)).then(|| Warning {
        subject: Subject::Instrument,
        text: format!("{}: no {what} is given, so only {counts} count.", sensor.name),
    })
}

/// The pull, or with a turned sign the push, on an end up to the end of the judged part, where there is one.
fn pull(spec: &Spec, case: &Case, end: End, force: &[f64], sign: f64) -> Option<Pull> {
    let least = LEAST_LIFT * spec.spring.spring.nominal_force();
    let force = &force[..case.judged.end];
    let times = case.signals.time();
    let first = force.iter().position(|force| sign * force > least)?;
    let (place, largest) = force.iter().map(|force| sign * force).enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let is_judged = force[case.judged.start..].iter().any(|force| sign * force > least);
    Some(Pull { end, damping: case.damping, first: times[first], largest: (largest, times[place]), is_judged })
}

/// Surge lines above half of a sensor's sample rate that get through its filter.
fn alias(judge: &Judge<'_>, sensor: &SensorSpec) -> Result<Option<Warning>, Error> {
    let Some(rate) = sensor.readout.sample_rate else { return Ok(None) };
    let spring = &judge.spec.spring.spring;
    let modes = ModalModel::chain(spring, judge.spec.mount.far_end());
    let surge = modes.frequencies().iter().map(|angular| angular / std::f64::consts::TAU);
    let lines: Vec<f64> = surge.filter(|line| *line > 0.5 * rate).collect();
    if lines.is_empty() {
        return Ok(None);
    }
    // What is there at the moment of sampling: the hold comes after it and takes nothing from what it folds.
    let ahead = Readout::new(ReadoutParameters { sample_rate: None, ..sensor.readout.clone() })?;
    let mut amplitudes = vec![0.0_f64; lines.len()];
    for case in judge.cases {
        let instrument = judge.instrument(sensor, case.condition)?;
        let watched = instrument.forces(&instrument.quantity(&case.signals)?[case.judged.clone()]);
        let spectrum = Spectrum::of(case.judged_times(), &watched)?;
        let frequencies = spectrum.frequencies();
        for (line, amplitude) in lines.iter().zip(&mut amplitudes) {
            let passes = ahead.response(*line).norm();
            *amplitude = amplitude.max(passes * line_amplitude(&frequencies, spectrum.amplitudes(), *line));
        }
    }
    let least = LEAST_LINE * spring.nominal_force();
    let folded: Vec<(f64, f64)> =
        lines.into_iter().zip(amplitudes).filter(|(_, amplitude)| *amplitude > least).collect();
    let Some(&(line, amplitude)) = folded.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else { return Ok(None) };
    let (plural, verb) = if folded.len() == 1 { ("", "gets") } else { ("s", "get") };
    let text = format!(
        "{}: {} surge line{plural} above half of the sample rate of {} Hz {verb} through the filter; the largest, {line:.0} Hz with {} N, \
         shows up at {:.1} Hz.",
        sensor.name,
        folded.len(),
        digits(rate),
        digits(amplitude),
        alias_of(line, rate),
    );
    Ok(Some(Warning { subject: Subject::Alias, text }))
}

/// Amplitude of the line nearest to a frequency \[Hz\], which may lie between two; zero above the spectrum's end.
fn line_amplitude(frequencies: &[f64], amplitudes: &[f64], frequency: f64) -> f64 {
    let next = frequencies.partition_point(|&f| f < frequency);
    if next == frequencies.len() {
        return 0.0;
    }
    // The mean is no line, however near it lies where the window is short.
    let around = next.saturating_sub(2).max(1).min(next)..(next + 2).min(frequencies.len());
    amplitudes[around].iter().fold(0.0, |most: f64, amplitude| most.max(*amplitude))
}

/// Sensors that estimate a force by a length, of a spring whose drift with temperature nobody knows.
fn temperature(spec: &Spec, sensors: &[SensorSpec]) -> Option<Warning> {
    let unknown = spec.spring.geometry.material().stiffness_temperature().is_none();
    let estimates: Vec<&str> =
        sensors.iter().filter(|sensor| sensor.quantity.estimates()).map(|sensor| sensor.name.as_str()).collect();
    if !unknown || estimates.is_empty() || spec.uncertainty.temperature_change == 0.0 {
        return None;
    }
    let text = format!(
        "{}: how the stiffness of {} drifts with temperature is not known here, so it is left out of their budgets; steel drifts by 0.35 % in 10 K.",
        estimates.join(", "),
        spec.spring.material
    );
    Some(Warning { subject: Subject::Temperature, text })
}
