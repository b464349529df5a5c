//! All runs of a speed map as a table.
//!
//! Next door: the same for programs (`json`).

use crate::speed::{SpeedMap, SpeedPoint};

/// What a column holds of a run; nothing where it does not apply.
type Column = (&'static str, fn(&SpeedPoint) -> Option<f64>);

const COLUMNS: [Column; 19] = [
    ("F_i least [N]", |point| Some(point.input[0])),
    ("F_i largest [N]", |point| Some(point.input[1])),
    ("F_o least [N]", |point| Some(point.output[0])),
    ("F_o largest [N]", |point| Some(point.output[1])),
    ("rms(F_o - F_i) [N]", |point| Some(point.apart)),
    ("surge [N]", |point| Some(point.surge)),
    ("touches [1/turn]", |point| Some(point.touches)),
    ("closing speed [m/s]", |point| Some(point.fastest)),
    ("blow on a seat [N s]", |point| Some(point.blow)),
    ("lift-offs [1/turn]", |point| Some(point.lifts)),
    ("floats [1/turn]", |point| point.floating.map(|floating| floating.floats)),
    ("floating [1]", |point| point.floating.map(|floating| floating.share)),
    ("landing speed [m/s]", |point| point.floating.map(|floating| floating.fastest)),
    ("least cam force [N]", |point| point.floating.map(|floating| floating.least_cam_force)),
    ("least stress [MPa]", |point| Some(1e-6 * point.stress[0])),
    ("largest stress [MPa]", |point| Some(1e-6 * point.stress[1])),
    ("unsettled [F_nom]", |point| Some(point.unsettled)),
    ("turns [1]", |point| Some(point.turns as f64)),
    ("followed to the end [1]", |point| Some(if point.given_up.is_none() { 1.0 } else { 0.0 })),
];

/// A row for each run; the speed is the engine's.
pub(super) fn csv(map: &SpeedMap) -> String {
    let names: Vec<&str> = COLUMNS.iter().map(|(name, _)| *name).collect();
    let mut text = format!("speed [rpm],case,{}\n", names.join(","));
    for point in &map.points {
        let each = COLUMNS.iter().map(|(_, of)| of(point).map_or_else(String::new, |value| format!("{value:.6e}")));
        let label = &map.spec.mount.cases[point.way].label;
        text.push_str(&format!("{:.3},\"{label}\",{}\n", 60.0 * point.speed, each.collect::<Vec<_>>().join(",")));
    }
    text
}
