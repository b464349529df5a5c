//! All runs of a speed map as a table: CSV, Parquet, or columns in SI.
//!
//! Next door: the same for programs (`json`).

use crate::speed::{SpeedMap, SpeedPoint};
#[cfg(feature = "parquet")]
use crate::sweep::{Chunk, Data, SweepError};

/// A column: its title and its key, how many of the title's units an SI unit is, and what it holds of a run in SI; nothing where it does not apply.
type Column = (&'static str, &'static str, f64, fn(&SpeedPoint) -> Option<f64>);

const SPEED: Column = ("speed [rpm]", "speed_hz", 60.0, |point| Some(point.speed));
const CASE: &str = "case";
const COLUMNS: [Column; 24] = [
    ("F_i least [N]", "input_force_least_n", 1.0, |point| Some(point.input[0])),
    ("F_i largest [N]", "input_force_largest_n", 1.0, |point| Some(point.input[1])),
    ("F_o least [N]", "output_force_least_n", 1.0, |point| Some(point.output[0])),
    ("F_o largest [N]", "output_force_largest_n", 1.0, |point| Some(point.output[1])),
    ("least push on seat 1 [N]", "least_push_seat_1_n", 1.0, |point| Some(point.least_push()[0])),
    ("least push on seat 2 [N]", "least_push_seat_2_n", 1.0, |point| Some(point.least_push()[1])),
    ("rms(F_o - F_i) [N]", "rms_between_ends_n", 1.0, |point| Some(point.apart)),
    ("surge [N]", "surge_n", 1.0, |point| Some(point.surge)),
    ("touches [1/turn]", "touches_per_turn", 1.0, |point| Some(point.touches)),
    ("closed at most [1]", "share_of_time_closed", 1.0, |point| Some(point.closed)),
    ("closing speed [m/s]", "closing_speed_m_per_s", 1.0, |point| Some(point.fastest)),
    ("blow on a seat [N s]", "blow_on_seat_n_s", 1.0, |point| point.blow),
    ("lift-offs [1/turn]", "lift_offs_per_turn", 1.0, |point| point.lifts),
    ("floats [1/turn]", "floats_per_turn", 1.0, |point| point.floating.map(|floating| floating.floats)),
    ("floating [1]", "floating_share", 1.0, |point| point.floating.map(|floating| floating.share)),
    ("landing speed [m/s]", "landing_speed_m_per_s", 1.0, |point| point.floating.map(|floating| floating.fastest)),
    ("least cam force [N]", "least_cam_force_n", 1.0, |point| point.floating.map(|floating| floating.least_cam_force)),
    ("largest stress [MPa]", "largest_stress_pa", 1e-6, |point| Some(point.stress?.largest)),
    ("mean stress [MPa]", "mean_stress_pa", 1e-6, |point| Some(point.stress?.mean())),
    ("stress amplitude [MPa]", "stress_amplitude_pa", 1e-6, |point| Some(point.stress?.amplitude())),
    ("Goodman factor [1]", "goodman_factor", 1.0, |point| point.stress?.safety),
    ("unsettled [F_nom]", "unsettled", 1.0, |point| Some(point.unsettled)),
    ("turns [1]", "turns", 1.0, |point| Some(point.turns as f64)),
    ("followed to the end [1]", "followed_to_the_end", 1.0, |point| {
        Some(if point.given_up.is_none() { 1.0 } else { 0.0 })
    }),
];

/// What a run holds in the title's unit; NaN where it does not apply.
fn shown((_, _, scale, of): &Column, point: &SpeedPoint) -> f64 {
    of(point).map_or(f64::NAN, |value| scale * value)
}

/// A row for each run; the speed is the engine's.
pub(super) fn csv(map: &SpeedMap) -> String {
    let names: Vec<&str> = COLUMNS.iter().map(|column| column.0).collect();
    let mut text = format!("{},{CASE},{}\n", SPEED.0, names.join(","));
    for point in &map.points {
        let value = |value: f64| if value.is_nan() { String::new() } else { format!("{value:.6e}") };
        let each: Vec<String> = COLUMNS.iter().map(|column| value(shown(column, point))).collect();
        let label = &map.spec.mount.cases[point.way].label;
        text.push_str(&format!("{:.3},\"{label}\",{}\n", shown(&SPEED, point), each.join(",")));
    }
    text
}

/// The same under the same titles; what does not apply is null.
///
/// # Errors
/// What the writer says.
#[cfg(feature = "parquet")]
pub(super) fn parquet(map: &SpeedMap) -> Result<Vec<u8>, SweepError> {
    let numbers = |column: &Column| {
        let values = map.points.iter().map(|point| shown(column, point)).collect();
        (column.0.to_owned(), Data::Numbers(values))
    };
    let labels = map.points.iter().map(|point| map.spec.mount.cases[point.way].label.clone()).collect();
    let mut columns = vec![numbers(&SPEED), (CASE.to_owned(), Data::Texts(labels))];
    columns.extend(COLUMNS.iter().map(numbers));
    Chunk { columns }.to_parquet()
}

/// The runs of one damping and rebound by rising speed: keys, and what they hold in SI, NaN where they do not apply.
pub fn speed_columns(map: &SpeedMap, way: usize) -> Vec<(&'static str, Vec<f64>)> {
    let of_way =
        |(_, key, _, of): &Column| (*key, map.of_way(way).map(|point| of(point).unwrap_or(f64::NAN)).collect());
    std::iter::once(&SPEED).chain(&COLUMNS).map(of_way).collect()
}
