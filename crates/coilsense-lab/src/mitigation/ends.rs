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

/// How far from 1 the slope of lengths by inductance over u2 − u1 may be: a turned sign has −1, channels that do not belong together 0.
const ANOTHER: f64 = 0.5;
/// How many standard errors of that slope are no disagreement: a log at rest tells none.
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
        let (first, second) = (log.channel(Channel::U1), log.channel(Channel::U2));
        let Some(applied) = by_inductance else {
            let second = match second {
                Ok(second) => second.to_vec(),
                Err(_) if is_held => nothing(),
                Err(missing) => return Err(without_second(missing)),
            };
            let zero = asked.length_at_zero.map_or(Zero::Unknown, Zero::Told);
            return Ok(Self { positions: [first?.to_vec(), second], zero, notes: Vec::new() });
        };
        let beside = |ends: &[f64], sign: f64| -> Vec<f64> {
            ends.iter().zip(&applied.lengths).map(|(end, length)| end + sign * length).collect()
        };
        let (positions, told) = match (first, second) {
            (Ok(first), Ok(second)) => return Self::both(stiffness, log, [first.to_vec(), second.to_vec()], applied),
            (Ok(first), Err(_)) if is_held => return Self::both(stiffness, log, [first.to_vec(), nothing()], applied),
            (Ok(first), Err(_)) => ([first.to_vec(), beside(first, 1.0)], "u2 is u1 and the length by L"),
            (Err(_), Ok(second)) => ([beside(second, -1.0), second.to_vec()], "u1 is u2 less the length by L"),
            (Err(_), Err(_)) if is_held => {
                ([beside(&nothing(), -1.0), nothing()], "u1 is the length by L, end 2 is held")
            }
            (Err(missing), Err(_)) => return Err(without_both(missing)),
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
        let apart: Vec<f64> = positions[0].iter().zip(&positions[1]).map(|(first, second)| second - first).collect();
        let missing: Vec<f64> = apart.iter().zip(&applied.lengths).map(|(apart, length)| length - apart).collect();
        let count = apart.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let (zero, middle) = (mean(&missing), mean(&apart));
        // By how much what is missing changes with u2 − u1, less what noise makes of that.
        let moved = apart.iter().map(|apart| (apart - middle).powi(2)).sum::<f64>();
        let slope =
            apart.iter().zip(&missing).map(|(apart, missing)| (apart - middle) * (missing - zero)).sum::<f64>() / moved;
        let rest =
            apart.iter().zip(&missing).map(|(apart, missing)| (missing - zero - slope * (apart - middle)).powi(2));
        let error = (rest.sum::<f64>() / (count * moved)).sqrt();
        let left = (missing.iter().map(|missing| (missing - zero).powi(2)).sum::<f64>() / count).sqrt();
        let [left_mm, moved_mm] = [left, (moved / count).sqrt()].map(|metres| digits(1e3 * metres));
        if slope.abs() > ANOTHER.max(AGREES * error) {
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

fn without_second(missing: RecordingError) -> RecordingError {
    let or = Message::from("; where that end is held, ") + Hint::Value(END2.name, "held".to_owned()) + " says so";
    RecordingError::of_words(Message::from(missing) + or)
}

fn without_both(missing: RecordingError) -> RecordingError {
    let or = Message::from("; ")
        + Hint::Option(CALIBRATION.name, "FILE")
        + " tells the length alone, not where both ends are: one of them must be recorded, or end 2 held ("
        + Hint::Value(END2.name, "held".to_owned())
        + ")";
    RecordingError::of_words(Message::from(missing) + or)
}
