//! A log as candidates take it: its positions as lengths of the coil, its stiffness in place of one that does not fit.
//!
//! Next door: what is asked (`request`), how logs are read (`crate::recording`).

use coilsense::identify::{Estimate, Stiffness};
use coilsense::mitigation::ToleranceBox;
use coilsense::{Channel, Signals, Spring};
use coilsense_rt::Measured;

use super::ends::{Ends, Zero};
use super::request::Request;
use crate::calibration::Applied;
use crate::quantity::digits;
use crate::recording::{Recording, RecordingError};

/// A log as candidates take it.
#[derive(Debug, Clone)]
pub struct Recorded {
    /// The file's name.
    pub name: String,
    /// F_i, u1, u2, the latter such that u2 − u1 is the coil's length; at least one sample.
    pub measured: Vec<Measured<f64>>,
    /// F_o \[N\], where it was recorded; without it there is nothing to hold estimators against.
    pub output: Option<Vec<f64>>,
    /// k of the log \[N/m\], where its slow motion tells one.
    pub stiffness: Option<Estimate>,
    /// Length of the coil where u1 and u2 read zero \[m\].
    pub length_at_zero: f64,
    /// What was found of that, and what cannot be judged, a sentence each.
    pub notes: Vec<String>,
}

/// What the spec says of the spring in the log.
pub(super) struct Known<'a> {
    /// As the spec has it.
    pub spring: &'a Spring,
    /// Whether its mount holds end 2.
    pub is_held: bool,
    /// By how much k may be off, as a share.
    pub tolerance: f64,
}

/// Beyond this factor either way a stiffness is another spring's, or its unit or gain is wrong.
const ANOTHER: f64 = 1.5;
/// The most that a straight line may leave of slow forces, in their own rms.
const LEFT: f64 = 0.3;
/// Over which forces are averaged where no line is fitted \[s\], and what of F_nom does not matter then.
const MEAN: f64 = 0.2;
const SMALL: f64 = 0.005;
/// What the mean of F_i does not tell from nothing, ringing and all, in F_nom.
const UNTOLD: f64 = 1e-3;
/// Mean error of F_i that is told as one, in F_nom.
const LARGE: f64 = 0.03;

impl Recorded {
    /// Of a log, with the spring that it is judged by.
    ///
    /// # Errors
    /// [`RecordingError`] for a log without one of the channels, of another spring, or with a turned sign.
    pub(super) fn of(
        known: &Known<'_>,
        asked: &Request,
        log: &Recording,
        by_inductance: Option<&Applied>,
    ) -> Result<(Self, Spring), RecordingError> {
        let force = input_force(log)?;
        let Ends { positions: [first, second], zero, mut notes } =
            Ends::of((known.is_held, known.spring.stiffness()), asked, log, by_inductance)?;
        let lengths: Vec<f64> = first.iter().zip(&second).map(|(first, second)| second - first).collect();
        let output = log.signals().channel(Channel::OutputForce).ok();
        let line = line(known, log, &lengths, Channel::InputForce, force, &mut notes)?;
        if let Some(output) = output {
            let _ = self::line(known, log, &lengths, Channel::OutputForce, output, &mut Vec::new())?;
        } else {
            notes.push("F_o was not recorded: filters of F_i are judged, estimators of F_o cannot be.".to_owned());
        }
        let spring = spring(known, log, line.as_ref(), &mut notes)?;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        // By the blocks of the fit, where there is one: the line goes through their middle.
        let (x, f) = match &line {
            Some(line) => (mean(&line.lengths), mean(&line.forces)),
            None => (mean(&lengths), mean(force)),
        };
        let found = spring.rest_length() + f / spring.stiffness() - x;
        // What the mean of F_i does not tell from zero is none.
        let is_length = (spring.stiffness() * found).abs() <= UNTOLD * spring.nominal_force();
        let length_at_zero = match zero {
            Zero::Told(length) | Zero::ByInductance(length) => length,
            Zero::Unknown if is_length => 0.0,
            Zero::Unknown => found,
        };
        notes.extend(where_zero(&spring, zero, found, is_length));
        let each = force.iter().zip(&first).zip(&second);
        let measured =
            each.map(|((force, first), second)| Measured { force: *force, ends: [*first, *second + length_at_zero] });
        let recorded = Self {
            name: log.account().file.display().to_string(),
            measured: measured.collect(),
            output: output.map(<[f64]>::to_vec),
            stiffness: line.map(|line| line.stiffness),
            length_at_zero,
            notes,
        };
        Ok((recorded, spring))
    }
}

/// F_i, from which filters and estimators start: a force at the other end is not it.
fn input_force(log: &Recording) -> Result<&[f64], RecordingError> {
    let refused = |why: &str| Err(RecordingError::of_file(&log.account().file, why.to_owned()));
    let of = |channel| log.signals().channel(channel).ok();
    match (of(Channel::InputForce), of(Channel::OutputForce)) {
        (None, Some(_)) => refused(
            "has F_o, the force at end 2, and no F_i: filters and estimators start from a load cell at end 1. Where this one sits at end 1, name its column F_i \
             and count positions from there; else record one at end 1",
        ),
        (Some(input), Some(output)) if input == output => refused(
            "has one and the same series as F_i and as F_o: two load cells never agree so; name each column once",
        ),
        _ => log.channel(Channel::InputForce),
    }
}

/// Force over length where both move slowly; none where they tell none, which is noted.
fn line(
    known: &Known<'_>,
    log: &Recording,
    lengths: &[f64],
    channel: Channel,
    force: &[f64],
    notes: &mut Vec<String>,
) -> Result<Option<Stiffness>, RecordingError> {
    let (name, k) = (channel.name(), known.spring.stiffness());
    let refused = |message: String| Err(RecordingError::of_file(&log.account().file, message));
    let line = match slow(known, log, lengths, force) {
        Ok(line) => line,
        Err(why) => {
            let turned: Vec<f64> = force.iter().map(|force| -force).collect();
            if let Ok(line) = slow(known, log, lengths, &turned) {
                let fall = digits(line.value());
                return refused(format!(
                    "{name} falls by {fall} N for each metre that u2 − u1 grows: the sign of {name}, u1 or u2 is turned; \
                     tension and the way from end 1 to end 2 count positive"
                ));
            }
            if let Some(left) = unexplained(known, lengths, force, log.account().interval.unwrap_or(1.0)) {
                return refused(format!(
                    "{name} does not follow k·Δl of the spec's {k:.1} N/m: {} N rms of its slow part are left; another spring, or channels that do not belong together",
                    digits(left)
                ));
            }
            notes.push(format!("No stiffness from the log, the spec's {k:.1} N/m is used: {why}."));
            return Ok(None);
        }
    };
    let ratio = line.value() / k;
    if !(1.0 / ANOTHER..=ANOTHER).contains(&ratio) {
        let found = line.value();
        return refused(format!(
            "{name} rises by {found:.1} N/m, {ratio:.2} times the spec's {k:.1} N/m: another spring, or a unit or gain that is off"
        ));
    }
    let mean = line.forces.iter().sum::<f64>() / line.forces.len() as f64;
    let rms = (line.forces.iter().map(|force| (force - mean).powi(2)).sum::<f64>() / line.forces.len() as f64).sqrt();
    if line.scatter > LEFT * rms {
        let (scatter, rms) = (digits(line.scatter), digits(rms));
        return refused(format!(
            "{name} is no straight line over u2 − u1: {scatter} N rms are left of {rms} N of slow force; another spring, or channels that do not belong together"
        ));
    }
    Ok(Some(line))
}

fn slow(known: &Known<'_>, log: &Recording, lengths: &[f64], force: &[f64]) -> Result<Stiffness, String> {
    let told = |error: coilsense::Error| error.to_string();
    let mut signals = Signals::new(log.signals().time().to_vec()).map_err(told)?;
    signals.insert(Channel::U2, lengths.to_vec()).map_err(told)?;
    signals.insert(Channel::InputForce, force.to_vec()).map_err(told)?;
    Stiffness::of_record(&signals, known.spring.surge_frequency())
}

/// What the spec's spring leaves of the slow force \[N rms\], where that is most of it and matters.
fn unexplained(known: &Known<'_>, lengths: &[f64], force: &[f64], interval: f64) -> Option<f64> {
    let block = ((MEAN / interval) as usize).clamp(1, force.len());
    let means = |of: &dyn Fn(usize) -> f64| -> Vec<f64> {
        let starts = (0..force.len() / block).map(|number| number * block);
        starts.map(|start| (start..start + block).map(of).sum::<f64>() / block as f64).collect()
    };
    let rms = |values: Vec<f64>| {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
    };
    let k = known.spring.stiffness();
    let of_force = rms(means(&|index| force[index]));
    let of_length = rms(means(&|index| k * lengths[index]));
    let left = rms(means(&|index| force[index] - k * lengths[index]));
    (left > 0.5 * of_force.max(of_length) && left > SMALL * known.spring.nominal_force()).then_some(left)
}

/// The spec's spring, or one with the log's stiffness where that is another.
fn spring(
    known: &Known<'_>,
    log: &Recording,
    line: Option<&Stiffness>,
    notes: &mut Vec<String>,
) -> Result<Spring, RecordingError> {
    let Some(line) = line else { return Ok(known.spring.clone()) };
    let (found, told) = (line.stiffness, known.spring.stiffness());
    let from_log =
        format!("k from the log {:.1} ± {:.1} N/m, the spec says {told:.1} N/m", found.value, found.expanded);
    if found.holds(told) {
        notes.push(format!("{from_log}: they agree, and the spec's is used."));
        return Ok(known.spring.clone());
    }
    let off = found.value / told - 1.0;
    notes.push(format!("{from_log}: ranking and settings take the log's."));
    if off.abs() > known.tolerance + found.expanded / told {
        notes.push(format!(
            "Warning: that is {:+.1} %, more than the tolerance of ±{} %: is it this spring, and are the gains right?",
            100.0 * off,
            100.0 * known.tolerance
        ));
    }
    ToleranceBox::changed(known.spring, [off, 0.0]).map_err(|error| RecordingError::of_file(&log.account().file, error))
}

/// What is said of the length of the coil where positions read zero.
fn where_zero(spring: &Spring, zero: Zero, found: f64, is_length: bool) -> Option<String> {
    let is_off = |given: f64| {
        let error = spring.stiffness() * (found - given);
        (error.abs() > LARGE * spring.nominal_force()).then(|| {
            format!(
                "F_i is {} N off k·Δl on average then, which no filter takes away. By the mean of F_i",
                digits(error)
            )
        })
    };
    Some(match zero {
        Zero::Unknown if is_length => {
            "u2 − u1 is taken for the coil's length: the mean of F_i agrees with it to 0.1 % of F_nom.".to_owned()
        }
        Zero::Unknown => format!(
            "The coil is {:.3} mm long where u1 and u2 read zero, by the mean of F_i; a constant error of F_i is not seen so.",
            1e3 * found
        ),
        Zero::Told(given) => {
            let told = format!("The coil is {:.3} mm long where u1 and u2 read zero, as told", 1e3 * given);
            match is_off(given) {
                None => told + ".",
                Some(off) => format!("Warning: {told}; {off} it is {:.3} mm.", 1e3 * found),
            }
        }
        Zero::ByInductance(given) => {
            let off = is_off(given)?;
            let longer = 1e3 * (found - given);
            let word = if longer < 0.0 { "shorter" } else { "longer" };
            format!("Warning: the length is by L; {off} the coil is {:.3} mm {word}.", longer.abs())
        }
    })
}
