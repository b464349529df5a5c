//! Where both ends are in a log: as recorded, or by the coil's length that a stored calibration reads off its inductance.
//!
//! Next door: what is made of them (`recorded`), the calibration (`crate::calibration`).

use coilsense::Channel;

use super::request::{CALIBRATION, END2, Request};
use crate::calibration::Applied;
use crate::message::{Hint, Message};
use crate::quantity::digits;
use crate::recording::{Recording, RecordingError};

/// Positions of both ends.
pub(super) struct Ends {
    /// u1 and u2 \[m\], shape `samples`.
    pub positions: [Vec<f64>; 2],
    /// What is known of the length of the coil where both read zero.
    pub zero: Zero,
    /// What was done about it, a sentence each.
    pub notes: Vec<String>,
}

/// Length of the coil where both ends read zero \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Zero {
    /// By the mean of F_i.
    Unknown,
    /// As told.
    Told(f64),
    /// By the coil's inductance.
    ByInductance(f64),
}

/// By which share of their own motion lengths by inductance may leave those of the ends.
const ANOTHER: f64 = 0.5;
/// How many standard uncertainties are no disagreement.
const AGREES: f64 = 3.0;

impl Ends {
    /// - `held`: whether end 2 is, by the spec; `stiffness`: k \[N/m\]
    /// - `by_inductance`: the lengths of the log's inductances, where they are asked for
    ///
    /// # Errors
    /// [`RecordingError`] for a log without an end that is needed, and for lengths that are not those of the ends.
    pub fn of(
        (held, stiffness): (bool, f64),
        asked: &Request,
        log: &Recording,
        by_inductance: Option<&Applied>,
    ) -> Result<Self, RecordingError> {
        let is_held = asked.end2_held.unwrap_or(held);
        let nothing = || vec![0.0; log.signals().time().len()];
        let recorded = |channel: Channel| log.signals().channel(channel).ok().map(<[f64]>::to_vec);
        let (first, second) = (recorded(Channel::U1), recorded(Channel::U2));
        let Some(applied) = by_inductance else {
            let first = log.channel(Channel::U1)?.to_vec();
            let second = match second {
                Some(second) => second,
                None if is_held => nothing(),
                None => return Err(without_second(log)),
            };
            let zero = asked.length_at_zero.map_or(Zero::Unknown, Zero::Told);
            return Ok(Self { positions: [first, second], zero, notes: Vec::new() });
        };
        let lengths = &applied.lengths;
        let beside = |ends: &[f64], sign: f64| -> Vec<f64> {
            ends.iter().zip(lengths).map(|(end, length)| end + sign * length).collect()
        };
        let (positions, told) = match (first, second, is_held) {
            (Some(first), Some(second), _) => return Self::both(stiffness, log, [first, second], applied),
            (Some(first), None, true) => return Self::both(stiffness, log, [first, nothing()], applied),
            (Some(first), None, false) => {
                let second = beside(&first, 1.0);
                ([first, second], "u2 is u1 and the length by L")
            }
            (None, Some(second), _) => {
                let first = beside(&second, -1.0);
                ([first, second], "u1 is u2 less the length by L")
            }
            (None, None, true) => ([beside(&nothing(), -1.0), nothing()], "u1 is the length by L, end 2 is held"),
            (None, None, false) => return Err(without_both(log)),
        };
        let mut notes = vec![format!("{told}: {}.", doubt(stiffness, applied))];
        notes.push(RINGING.to_owned());
        Ok(Self { positions, zero: Zero::ByInductance(0.0), notes })
    }

    /// Both ends as recorded; where they count from, by inductance.
    fn both(
        stiffness: f64,
        log: &Recording,
        positions: [Vec<f64>; 2],
        applied: &Applied,
    ) -> Result<Self, RecordingError> {
        let count = applied.lengths.len() as f64;
        let apart = positions[0].iter().zip(&positions[1]).map(|(first, second)| second - first);
        let missing: Vec<f64> = apart.clone().zip(&applied.lengths).map(|(apart, length)| length - apart).collect();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let spread = |values: &[f64]| {
            let middle = mean(values);
            (values.iter().map(|value| (value - middle).powi(2)).sum::<f64>() / count).sqrt()
        };
        let (zero, left, moved) = (mean(&missing), spread(&missing), spread(&apart.collect::<Vec<f64>>()));
        let doubt_of_one = applied.lengths_u.as_deref().map_or(0.0, mean);
        let [left_mm, moved_mm] = [left, moved].map(|metres| digits(1e3 * metres));
        if left > ANOTHER * moved.max(spread(&applied.lengths)) && left > AGREES * doubt_of_one {
            return Err(RecordingError::of_file(
                &log.account().file,
                format!(
                    "the length by L leaves {left_mm} mm rms of u2 − u1, which move by {moved_mm} mm rms: the calibration of another spring, a turned sign, or channels that do not belong together"
                ),
            ));
        }
        let mut notes = vec![format!(
            "Where u1 and u2 read zero the coil is {:.3} mm long, by L: {}; L and u2 − u1 are {left_mm} mm rms apart beside that.",
            1e3 * zero,
            doubt(stiffness, applied)
        )];
        notes.push(RINGING.to_owned());
        Ok(Self { positions, zero: Zero::ByInductance(zero), notes })
    }
}

/// What lengths by inductance leave out, beside a motion.
const RINGING: &str = "The length by L is that of windings at rest: what ringing adds to it, of second order, is told by coilsense analyze.";

/// How far off lengths by inductance may be.
fn doubt(stiffness: f64, applied: &Applied) -> String {
    match &applied.lengths_u {
        Some(each) => {
            let most = each.iter().copied().fold(0.0, f64::max);
            format!("standard uncertainty at most {} mm, {} N of k·Δl", digits(1e3 * most), digits(stiffness * most))
        }
        None => "its uncertainty unknown, as the calibration does not tell one".to_owned(),
    }
}

fn without_second(log: &Recording) -> RecordingError {
    let missing = log.channel(Channel::U2).err().map(Message::from).unwrap_or_else(|| Message::from(""));
    let or = Message::from("; where that end is held, ") + Hint::Value(END2.name, "held".to_owned()) + " says so";
    RecordingError::of_words(missing + or)
}

fn without_both(log: &Recording) -> RecordingError {
    let missing = log.channel(Channel::U1).err().map(Message::from).unwrap_or_else(|| Message::from(""));
    let or = Message::from("; ")
        + Hint::Option(CALIBRATION.name, "FILE")
        + " tells the length alone, not where both ends are: one of them must be recorded, or end 2 held ("
        + Hint::Value(END2.name, "held".to_owned())
        + ")";
    RecordingError::of_words(missing + or)
}
