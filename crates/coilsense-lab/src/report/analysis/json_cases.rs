//! Each condition at each damping, for machines.
//!
//! Next door: the analysis that holds them (`json`).

use std::collections::BTreeMap;

use coilsense::Deviation;
use coilsense::contact::{Float, Lift, Touch};
use serde::Serialize;

use crate::analysis::{Analysis, Assessment, Case};
use crate::study::{Contacts, Meeting};

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
    /// What windings did when they met; null where the spec has them pass through one another.
    contact: Option<ContactPart>,
}

/// Windings that met, and ends that left their seats.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ContactPart {
    /// Up to when both end forces are within `apart_n` of those under an input larger by a millionth; what comes after that is good in its rms and
    /// its extremes only.
    holds_until_s: Option<f64>,
    apart_n: f64,
    until_s: f64,
    touches: usize,
    energy_lost_j: f64,
    pairs: Vec<MeetingRow>,
    lifts: Vec<LiftRow>,
    floats: Vec<FloatRow>,
    /// The first of all touches, 2000 at most.
    first_touches: Vec<TouchRow>,
}

/// Two neighbouring windings, or a winding and its seat.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct MeetingRow {
    /// `3|4`, `seat 1`.
    between: String,
    touches: usize,
    share_of_time_closed: f64,
    largest_closing_speed_m_per_s: f64,
    impulse_n_s: f64,
    largest_impulse_n_s: f64,
    energy_lost_j: f64,
}

/// A touch.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct TouchRow {
    time_s: f64,
    between: String,
    /// Turns from end 1 to the point nearer to it.
    turn: f64,
    closing_speed_m_per_s: f64,
    /// Null where they had not parted by the end.
    duration_s: Option<f64>,
    /// What they gave each other at once.
    impulse_n_s: f64,
    /// And while they were together.
    pressed_n_s: f64,
    energy_lost_j: f64,
}

/// An end that left its seat.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct LiftRow {
    end: u8,
    time_s: f64,
    /// Null where it was not back by the end.
    duration_s: Option<f64>,
}

/// A follower that left its cam.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct FloatRow {
    time_s: f64,
    /// Null where it was not back by the end.
    duration_s: Option<f64>,
    closing_speed_m_per_s: f64,
    impulse_n_s: f64,
}

/// Most touches that are listed.
const MOST_TOUCHES: usize = 2000;

impl ContactPart {
    fn of(contacts: &Contacts) -> Self {
        let meeting = |meeting: &Meeting| MeetingRow {
            between: meeting.between.words(),
            touches: meeting.count,
            share_of_time_closed: meeting.closed,
            largest_closing_speed_m_per_s: meeting.speed,
            impulse_n_s: meeting.impulse,
            largest_impulse_n_s: meeting.largest_impulse,
            energy_lost_j: meeting.lost,
        };
        let touch = |touch: &Touch| TouchRow {
            time_s: touch.time,
            between: contacts.between(touch).words(),
            turn: contacts.turn(touch),
            closing_speed_m_per_s: touch.closing_speed,
            duration_s: touch.parted.map(|parted| parted - touch.time),
            impulse_n_s: touch.impulse,
            pressed_n_s: touch.pressed,
            energy_lost_j: touch.lost,
        };
        let lift = |lift: &Lift| LiftRow {
            end: if lift.is_end2 { 2 } else { 1 },
            time_s: lift.time,
            duration_s: lift.back.map(|back| back - lift.time),
        };
        let float = |float: &Float| FloatRow {
            time_s: float.time,
            duration_s: float.back.map(|back| back - float.time),
            closing_speed_m_per_s: float.closing_speed,
            impulse_n_s: float.impulse,
        };
        Self {
            holds_until_s: contacts.holds_until,
            apart_n: contacts.apart,
            until_s: contacts.until,
            touches: contacts.touches.len(),
            energy_lost_j: contacts.balance.lost,
            pairs: contacts.meetings.iter().map(meeting).collect(),
            lifts: contacts.lifts.iter().map(lift).collect(),
            floats: contacts.floats.iter().map(float).collect(),
            first_touches: contacts.touches.iter().take(MOST_TOUCHES).map(touch).collect(),
        }
    }
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
            contact: case.contacts.as_ref().map(ContactPart::of),
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
