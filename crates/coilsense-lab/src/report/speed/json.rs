//! A speed map for machines: SI, one key per number.
//!
//! Next door: the same for people (`text`, `html`).

use serde::Serialize;

use crate::report::outcome::{Outcome, to_json};
use crate::speed::{SpeedMap, SpeedPoint, answer};

/// What a spring under a cam does at each speed of the engine.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct SpeedOutcome<'a> {
    /// The answer, a sentence each.
    answer: Vec<String>,
    cam: &'a str,
    /// Turns of the camshaft for one of the engine.
    cam_ratio: f64,
    masses_per_winding: usize,
    /// What more masses say of the runs that the answer begins with.
    finer: FinerPart<'a>,
    nominal_force_n: f64,
    /// Lines that do not move with the speed.
    lines: Vec<LineRow<'a>>,
    /// Speeds at which a harmonic of the cam has the first of them.
    crossings: Vec<CrossingRow>,
    /// Speeds that were added about them, by case.
    added_speeds: Vec<usize>,
    runs: Vec<RunRow<'a>>,
}

impl Outcome for SpeedOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/speed/1";
}

/// Runs with twice the masses: of the most surge, and the slowest in which the follower floats and windings meet. Where the map has a resonance, the
/// speed is that of this chain's.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct FinerPart<'a> {
    masses_per_winding: usize,
    runs: Vec<RunRow<'a>>,
    /// Why one was not run; null where all were.
    untried: Option<&'a str>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct LineRow<'a> {
    name: &'a str,
    frequency_hz: f64,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct CrossingRow {
    harmonic: usize,
    speed_hz: f64,
    amplitude_m: f64,
}

/// One speed under one damping and rebound.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct RunRow<'a> {
    /// Of the engine.
    speed_hz: f64,
    case: &'a str,
    /// Least and largest, tension positive.
    input_force_n: [f64; 2],
    output_force_n: [f64; 2],
    /// Least push on seat 1 and on seat 2: at zero an end is about to leave it.
    least_push_n: [f64; 2],
    rms_between_ends_n: f64,
    surge_n: f64,
    /// Amplitudes of F_o at the camshaft's frequency and its multiples.
    output_force_harmonics_n: &'a [f64],
    touches_per_turn: f64,
    /// Of the two points that touch longest.
    share_of_time_closed: f64,
    closing_speed_m_per_s: f64,
    /// Null where end turns have no seats to meet.
    blow_on_seat_n_s: Option<f64>,
    /// Null where ends stay on their seats, whatever the force.
    lift_offs_per_turn: Option<f64>,
    /// Null without a follower.
    floats_per_turn: Option<f64>,
    floating_share: Option<f64>,
    landing_speed_m_per_s: Option<f64>,
    least_cam_force_n: Option<f64>,
    /// Where the wire is worst off, with Wahl's correction; null where nothing could be followed.
    stress: Option<StressPart>,
    /// By how much the extremes differ from two turns to the next two, as a share of F_nom.
    unsettled: f64,
    turns: usize,
    followed_to_the_end: bool,
}

impl<'a> RunRow<'a> {
    fn of(map: &'a SpeedMap, point: &'a SpeedPoint) -> Self {
        Self {
            speed_hz: point.speed,
            case: &map.spec.mount.cases[point.way].label,
            input_force_n: point.input,
            output_force_n: point.output,
            least_push_n: point.least_push(),
            rms_between_ends_n: point.apart,
            surge_n: point.surge,
            output_force_harmonics_n: &point.harmonics,
            touches_per_turn: point.touches,
            share_of_time_closed: point.closed,
            closing_speed_m_per_s: point.fastest,
            blow_on_seat_n_s: point.blow,
            lift_offs_per_turn: point.lifts,
            floats_per_turn: point.floating.map(|floating| floating.floats),
            floating_share: point.floating.map(|floating| floating.share),
            landing_speed_m_per_s: point.floating.map(|floating| floating.fastest),
            least_cam_force_n: point.floating.map(|floating| floating.least_cam_force),
            stress: point.stress.map(|stress| StressPart {
                largest_pa: stress.largest,
                mean_pa: stress.mean(),
                amplitude_pa: stress.amplitude(),
                goodman_factor: stress.safety,
            }),
            unsettled: point.unsettled,
            turns: point.turns,
            followed_to_the_end: point.given_up.is_none(),
        }
    }
}

/// Shear stress of the wire.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct StressPart {
    largest_pa: f64,
    mean_pa: f64,
    amplitude_pa: f64,
    /// Safety factor against Goodman's line; null where the spec gives no strengths.
    goodman_factor: Option<f64>,
}

/// The map as JSON.
///
/// # Errors
/// What `serde_json` says.
pub fn speed_json(map: &SpeedMap) -> Result<String, serde_json::Error> {
    to_json(SpeedOutcome {
        answer: answer(map),
        cam: &map.cam.words,
        cam_ratio: map.range.ratio,
        masses_per_winding: map.masses_per_winding,
        finer: FinerPart {
            masses_per_winding: map.finer.per_winding,
            runs: map.finer.runs.iter().map(|(_, point)| RunRow::of(map, point)).collect(),
            untried: map.finer.untried.as_deref(),
        },
        nominal_force_n: map.spec.spring.spring.nominal_force(),
        lines: map
            .campbell
            .lines
            .iter()
            .map(|line| LineRow { name: &line.name, frequency_hz: line.frequency })
            .collect(),
        crossings: (map.campbell.crossings.iter())
            .map(|at| CrossingRow { harmonic: at.harmonic, speed_hz: at.speed, amplitude_m: at.amplitude })
            .collect(),
        added_speeds: map.added.clone(),
        runs: map.points.iter().map(|point| RunRow::of(map, point)).collect(),
    })
}
