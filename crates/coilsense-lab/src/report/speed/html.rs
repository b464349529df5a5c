//! `report.html` of a speed map: one page that needs no other file and no network; the answer first.
//!
//! Next door: its layout (`page.html`), its figures (`figures`).

use minijinja::{Value, context};

use super::figures;
use crate::quantity::digits;
use crate::report::ReportError;
use crate::report::page::{self, drawn};
use crate::report::prose::{file_name, unbroken};
use crate::speed::{SpeedMap, SpeedPoint, answer};

/// The page of a map.
pub(super) fn page(map: &SpeedMap, date: &str) -> Result<String, ReportError> {
    let ways = &map.spec.mount.cases;
    Ok(page::page(
        include_str!("page.html"),
        context! {
            date,
            spring => &map.spec.spring.name,
            file => file_name(&map.spec.file),
            text => &map.spec.text,
            cam => &map.cam.words,
            answer => answer(map).iter().map(|line| unbroken(line)).collect::<Vec<_>>(),
            overview => drawn("overview", &figures::overview(map, 2))?,
            narrow => drawn("overview", &figures::overview(map, 1))?,
            ends => drawn("forces", &figures::ends(map))?,
            waterfall => drawn("waterfall", &figures::waterfall(map))?,
            has_strength => map.spec.strength.is_some(),
            first_way => &ways[0].label,
            has_follower => map.points.iter().any(|point| point.floating.is_some()),
            crossings => map.campbell.crossings.iter().map(|at| context! {
                harmonic => at.harmonic,
                speed => format!("{:.0}", 60.0 * at.speed),
                amplitude => digits(1e6 * at.amplitude),
            }).collect::<Vec<_>>(),
            rows => map.points.iter().map(|point| row(map, point)).collect::<Vec<_>>(),
        },
    )?)
}

fn row(map: &SpeedMap, point: &SpeedPoint) -> Value {
    let range = |[low, high]: [f64; 2]| format!("{} … {}", digits(low), digits(high)).replace('-', "\u{2212}");
    context! {
        speed => format!("{:.0}", 60.0 * point.speed),
        way => &map.spec.mount.cases[point.way].label,
        input => range(point.input),
        output => range(point.output),
        surge => digits(point.surge),
        push => digits(point.least_push().into_iter().fold(f64::INFINITY, f64::min)),
        touches => digits(point.touches),
        closed => digits(100.0 * point.closed),
        fastest => digits(point.fastest),
        blow => point.blow.map_or_else(|| "–".to_owned(), |blow| digits(1e3 * blow)),
        lifts => point.lifts.map_or_else(|| "–".to_owned(), digits),
        float => point.floating.map(|floating| digits(100.0 * floating.share)),
        landing => point.floating.map(|floating| digits(floating.fastest)),
        stress => point.stress.map(|stress| format!("{:.0}", 1e-6 * stress.largest)),
        amplitude => point.stress.map(|stress| format!("{:.0}", 1e-6 * stress.amplitude())),
        goodman => point.stress.and_then(|stress| stress.safety).map(|safety| format!("{safety:.2}")),
        unsettled => format!("{:.1}", 100.0 * point.unsettled),
        is_wild => point.unsettled > crate::speed::SETTLED || point.given_up.is_some(),
    }
}
