//! A speed map on a terminal: the answer, and the speeds at which most happens.
//!
//! Next door: the report (`html`).

use crate::quantity::digits;
use crate::speed::{SpeedMap, SpeedPoint, answer};

/// Speeds that are shown.
const SHOWN: usize = 8;

/// The answer and the worst speeds of the worst way.
pub fn speed_text(map: &SpeedMap) -> String {
    let mut text = answer(map).join("\n") + "\n\n";
    let mut worst: Vec<&SpeedPoint> = map.points.iter().collect();
    worst.sort_by(|a, b| b.surge.total_cmp(&a.surge));
    worst.truncate(SHOWN);
    worst.sort_by(|a, b| a.speed.total_cmp(&b.speed).then(a.way.cmp(&b.way)));
    text.push_str(&format!(
        "{:>10}  {:<24}{:>12}{:>12}{:>12}{:>12}{:>10}{:>10}\n",
        "n [rpm]", "the most surge in", "surge [N]", "F_i [N]", "F_o [N]", "meets [1/t]", "v [m/s]", "float [%]"
    ));
    for point in worst {
        let label = &map.spec.mount.cases[point.way].label;
        let float = point.floating.map_or("–".to_owned(), |floating| digits(100.0 * floating.share));
        text.push_str(&format!(
            "{:>10.0}  {:<24}{:>12}{:>12}{:>12}{:>12}{:>10}{:>10}\n",
            60.0 * point.speed,
            label,
            digits(point.surge),
            digits(point.input[0]),
            digits(point.output[0]),
            digits(point.touches),
            digits(point.fastest),
            float,
        ));
    }
    text.push_str("surge: the largest |F − F_x| of both ends; F_i, F_o: the hardest push; meets: touches a turn of the camshaft; v: the fastest of them\n");
    text
}
