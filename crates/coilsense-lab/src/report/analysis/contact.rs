//! Windings that meet, as a reader sees them: when and where, how hard, how long.
//!
//! Next door: the figures' words (`html`), what is counted (`crate::study::Contacts`).

use coilsense::contact::Touch;
use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, Panel, Stroke};
use minijinja::{Value, context};

use crate::analysis::{Analysis, Case};
use crate::quantity::digits;
use crate::study::Contacts;

/// Touches that a table shows.
const SHOWN: usize = 12;
/// The shortest that a figure draws a touch, as a share of its time.
const SHORTEST: f64 = 0.002;
/// Most touches that a figure draws one by one.
const MOST_DRAWN: usize = 4000;

/// The case in which most meets, with its figure; `None` where nothing does.
pub(super) fn busiest(analysis: &Analysis) -> Option<(&Case, &Contacts)> {
    let met = |case: &'_ &Case| case.contacts.as_ref().is_some_and(|contacts| contacts.first.is_some());
    let each = analysis.cases.iter().filter(met).filter_map(|case| Some((case, case.contacts.as_ref()?)));
    each.max_by_key(|(_, contacts)| contacts.touches.len() + contacts.lifts.len() + contacts.floats.len())
}

/// When and where windings lie on each other, and when ends are off their seats.
pub(super) fn figure(case: &Case, contacts: &Contacts) -> Figure {
    let times = case.signals.time();
    let (from, to) = (times[case.judged.start], times[case.judged.end - 1]);
    let turns = contacts.masses as f64 / contacts.masses_per_winding as f64;
    let seen = |touch: &&Touch| touch.time < to && touch.parted.unwrap_or(contacts.until) > from;
    let (mut x, mut y) = (Vec::new(), Vec::new());
    let dash = SHORTEST * (to - from);
    for touch in contacts.touches.iter().filter(seen).take(MOST_DRAWN) {
        let (turn, parted) = (contacts.turn(touch), touch.parted.unwrap_or(contacts.until));
        x.extend([touch.time, parted.max(touch.time + dash), f64::NAN]);
        y.extend([turn, turn, f64::NAN]);
    }
    let together = Curve {
        label: "windings meet".into(),
        x,
        y,
        stroke: Stroke { colour: Colour::Red, dash: Dash::Solid, width: 3.0 },
    };
    let off = |is_end2: bool| {
        let lifts = contacts.lifts.iter().filter(|lift| lift.is_end2 == is_end2);
        let place = if is_end2 { turns } else { 0.0 };
        let (mut x, mut y) = (Vec::new(), Vec::new());
        for lift in lifts {
            x.extend([lift.time, lift.back.unwrap_or(contacts.until), f64::NAN]);
            y.extend([place, place, f64::NAN]);
        }
        (x, y)
    };
    let (first, second) = (off(false), off(true));
    let lifted = Curve {
        label: "end off its seat".into(),
        x: [first.0, second.0].concat(),
        y: [first.1, second.1].concat(),
        stroke: Stroke { colour: Colour::Blue, dash: Dash::Solid, width: 4.0 },
    };
    let (mut x, mut y) = (Vec::new(), Vec::new());
    for float in &contacts.floats {
        x.extend([float.time, float.back.unwrap_or(contacts.until), f64::NAN]);
        y.extend([-0.35, -0.35, f64::NAN]);
    }
    let floats = Curve {
        label: "follower off its cam".into(),
        x,
        y,
        stroke: Stroke { colour: Colour::Green, dash: Dash::Solid, width: 4.0 },
    };
    let curves = [together, lifted, floats].into_iter().filter(|curve| !curve.x.is_empty()).collect();
    let panel = Panel {
        x: Axis { label: "Time [s]".into(), range: Some((from, to)), ..Axis::default() },
        y: Axis { label: "Turns from end 1 [1]".into(), range: Some((-0.6, turns + 0.3)), ..Axis::default() },
        curves,
        ..Panel::default()
    };
    Figure { panels: vec![panel], columns: 1, panel_width: 760.0, panel_height: 260.0 }
}

/// A row for each case in which something meets.
pub(super) fn rows(analysis: &Analysis) -> Vec<Value> {
    let spec = &analysis.spec;
    let row = |case: &Case| {
        let contacts = case.contacts.as_ref()?;
        let first = contacts.first?;
        let fastest = contacts.touches.iter().map(|touch| touch.closing_speed).fold(0.0, f64::max);
        let longest = contacts.meetings.iter().max_by(|a, b| a.closed.total_cmp(&b.closed));
        let aloft: f64 = contacts.lifts.iter().map(|lift| lift.back.unwrap_or(contacts.until) - lift.time).sum();
        let holds = contacts.holds_until.unwrap_or(contacts.until);
        Some(context! {
            condition => &spec.conditions[case.condition].name,
            way => &spec.mount.cases[case.damping].label,
            first => format!("{first:.5}"),
            touches => contacts.touches.len(),
            fastest => digits(fastest),
            closed => longest.map(|longest| format!("{} % ({})", short(100.0 * longest.closed), longest.between.words())),
            lost => digits(1e3 * contacts.balance.lost),
            lifts => contacts.lifts.len(),
            aloft => digits(1e3 * aloft),
            floats => contacts.floats.len(),
            floated => digits(1e3 * contacts.floated()),
            holds => if holds < contacts.until { format!("{holds:.4} s") } else { "to the end".to_owned() },
        })
    };
    analysis.cases.iter().filter_map(row).collect()
}

/// The first touches of a case, and what each pair of neighbours did.
pub(super) fn tables(contacts: &Contacts) -> Value {
    let touch = |touch: &Touch| {
        context! {
            time => format!("{:.6}", touch.time),
            between => contacts.between(touch).words(),
            turn => format!("{:.2}", contacts.turn(touch)),
            speed => digits(touch.closing_speed),
            duration => touch.parted.map_or_else(|| "to the end".to_owned(), |parted| short(1e6 * (parted - touch.time))),
            impulse => digits(1e3 * touch.impulse),
            pressed => digits(1e3 * touch.pressed),
            lost => digits(1e3 * touch.lost),
        }
    };
    let meetings = contacts.meetings.iter().map(|meeting| {
        context! {
            between => meeting.between.words(),
            count => meeting.count,
            closed => short(100.0 * meeting.closed),
            speed => digits(meeting.speed),
            impulse => digits(1e3 * meeting.largest_impulse),
            lost => digits(1e3 * meeting.lost),
        }
    });
    context! {
        touches => contacts.touches.iter().take(SHOWN).map(touch).collect::<Vec<_>>(),
        more => contacts.touches.len().saturating_sub(SHOWN),
        meetings => meetings.collect::<Vec<_>>(),
    }
}

/// A figure of which less than a hundredth is as good as none.
fn short(value: f64) -> String {
    if value < 0.01 { "< 0.01".to_owned() } else { digits(value) }
}
